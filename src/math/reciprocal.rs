use super::wide::{mul_high, mul_high_signed};

/// A number's reciprocal: `mantissa` x 2^-`shift`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Reciprocal {
    /// 2^30 to 2^31 - 1.
    pub mantissa: u32,
    /// 62 less the leading zeros of the number.
    pub shift: u32,
}

/// Seeds: 2^24 / (2 x (128 + i) + 1), the reciprocal in the middle of each of 128 intervals.
static SEEDS: [u16; 128] = {
    let mut seeds = [0; 128];
    let mut i = 0;
    while i < 128 {
        seeds[i] = ((1 << 24) / (2 * (128 + i as u32) + 1)) as u16;
        i += 1;
    }
    seeds
};

/// The reciprocal of a number, without a division: a table of 128 entries and two Newton steps.
///
/// # Rounding
/// Relative error at most 2^-27.9. The reciprocal of 0 is taken as that of 1.
///
/// # Cost
/// About 25 instructions on Cortex-M4, 75 on M0+; 256 bytes of table.
#[inline(never)]
pub fn reciprocal(n: u32) -> Reciprocal {
    let n = if n == 0 { 1 } else { n };
    let zeros = n.leading_zeros();
    let n = n << zeros;
    let seed = match SEEDS.get((n >> 24 & 127) as usize) {
        Some(seed) => u32::from(*seed),
        None => 0,
    };
    // First step in 32 bits: 2^31 - n x / 2^16 is the error, of 24 bits.
    let error = 0x8000_0000_u32.wrapping_sub((n >> 16).wrapping_mul(seed)) as i32;
    let correction = (seed as i32).wrapping_mul(error >> 9) >> 7;
    let x = ((seed << 15) as i32).wrapping_add(correction) as u32;
    // Second step: 2^30 - n x / 2^32 is the error.
    let error = 0x4000_0000_u32.wrapping_sub(mul_high(n, x)) as i32;
    let x = x.wrapping_add((mul_high_signed(error, x) << 2) as u32);
    Reciprocal { mantissa: x.clamp(1 << 30, (1 << 31) - 1), shift: 62 - zeros }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Error relative to 1 / n in units of 2^-32.
    fn error(n: u32) -> i64 {
        let Reciprocal { mantissa, shift } = reciprocal(n);
        assert!((1 << 30..1u32 << 31).contains(&mantissa), "{n}: {mantissa:x}");
        assert_eq!(shift, 62 - n.leading_zeros(), "{n}");
        let one = 1_i128 << shift;
        let product = i128::from(mantissa) * i128::from(n);
        ((product - one).abs() * (1 << 32) / one) as i64
    }

    #[test]
    fn error_is_at_most_2_to_the_minus_27_9_over_all_intervals() {
        let bound = 17; // 2^32 / 2^27.9
        let mut worst = 0;
        for interval in 128..256_u32 {
            for step in 0..4096_u32 {
                worst = worst.max(error(interval << 24 | step << 12 | step * 0x95F & 0xFFF));
            }
        }
        for n in (1..70_000).chain(u32::MAX - 1000..=u32::MAX) {
            worst = worst.max(error(n));
        }
        for bit in 0..32 {
            worst = worst.max(error(1 << bit));
        }
        assert!(worst <= bound, "worst error {worst} x 2^-32");
    }

    #[test]
    fn zero_is_taken_as_one() {
        assert_eq!(reciprocal(0), reciprocal(1), "no division by zero");
    }
}
