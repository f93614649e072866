use super::leading_zeros::leading_zeros;
use super::wide::{less_high, low_of_high, mul_high_31, mul_short, HALVES_MULTIPLY};

/// One over an integer: 1 / n is about `mantissa` / 2^`shift`.
///
/// Made by [`reciprocal`]. Two numbers instead of a float, so that a product and a shift divide
/// on cores without a divider or a floating-point unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Reciprocal {
    /// In [2^30, 2^31 - 1]: all bits significant, and positive as an `i32` too.
    pub mantissa: u32,
    /// In [31, 62]; it is 62 - `n.leading_zeros()`.
    pub shift: u32,
}

/// 2^15 / f in the middle of each interval of f = n / 2^32 in [1/2, 1) that seven bits tell apart.
static SEEDS: [u16; 128] = {
    let mut seeds = [0; 128];
    let mut i = 0u32;
    while i < 128 {
        // f = (128 + i + 1/2) / 256. The first and largest seed is 65280.
        let seed = (1u32 << 24) / (2 * (128 + i) + 1);
        seeds[i as usize] = (seed & 0xFFFF) as u16;
        i += 1;
    }
    seeds
};

/// The reciprocal of `n`, without a division.
///
/// A seed from a table of 128 entries, and two steps of Newton's iteration x' = x + x (1 - f x),
/// each of which squares the error (Warren, *Hacker's Delight*, section 10-19).
///
/// # Range
///
/// Every `n`. Zero saturates: it gives the reciprocal of 1, the largest there is.
///
/// # Rounding
///
/// Relative error at most 2^-29.4 (tests go through every interval of the table).
///
/// # Cost
///
/// Four multiplications, two of them longer than 32 bits; 256 bytes of table.
///
/// ```
/// use microraster::math::reciprocal;
///
/// let third = reciprocal(3);
/// assert_eq!((3000 * u64::from(third.mantissa) + (1 << (third.shift - 1))) >> third.shift, 1000);
/// ```
#[inline]
#[must_use]
pub fn reciprocal(n: u32) -> Reciprocal {
    reciprocal_of_some(if n == 0 { 1 } else { n })
}

/// The same for what is known not to be zero (of which it makes nonsense).
#[inline(never)]
pub(crate) fn reciprocal_of_some(n: u32) -> Reciprocal {
    inlined_reciprocal_of_some(n)
}

/// The same in place: for what is done once a triangle, and not much longer than the call.
#[inline(always)]
pub(crate) fn inlined_reciprocal_of_some(n: u32) -> Reciprocal {
    let leading_zeros = leading_zeros(n);
    let mantissa = mantissa_of(n.wrapping_shl(leading_zeros));
    Reciprocal { mantissa, shift: 62u32.wrapping_sub(leading_zeros) }
}

/// The mantissa of the reciprocal of a number whose uppermost bit is set.
#[inline(always)]
pub(crate) fn mantissa_of(normal: u32) -> u32 {
    // f = normal / 2^32, in [1/2, 1).
    // The seed, 2^15 / f with nine good bits.
    let seed = u32::from(SEEDS[((normal >> 24) & 127) as usize]);

    // First step, to 2^30 / f with 15 good bits: the upper half of f is enough for that.
    let error = (1u32 << 31).wrapping_sub((normal >> 16).wrapping_mul(seed)).cast_signed();
    let correction = seed.cast_signed().wrapping_mul(error >> 9) >> 7;
    let estimate = (seed << 15).wrapping_add(correction.cast_unsigned());

    // In range for all 2^31 normal numbers, as going through them shows.
    if HALVES_MULTIPLY {
        last_step_at_once(normal, estimate)
    } else {
        last_step(normal, estimate)
    }
}

/// The second step. The error 2^30 (1 - f x) has 16 bits, as going through all normal numbers shows.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "an error of 16 bits")]
fn last_step(normal: u32, estimate: u32) -> u32 {
    let error = 0_u32.wrapping_sub(low_of_high(normal, estimate));
    let correction = mul_short(estimate >> 1, error as i16) >> 13;
    estimate.wrapping_add(correction.cast_unsigned())
}

/// The same by one long product, which is taken away: two bits higher the error has lost its 2^30.
#[inline(always)]
fn last_step_at_once(normal: u32, estimate: u32) -> u32 {
    let excess = mul_high_31(normal, estimate) << 2;
    let estimate = estimate.cast_signed();
    less_high(estimate, estimate & !1, excess.cast_signed()).cast_unsigned()
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{last_step, last_step_at_once, reciprocal, Reciprocal};
    use crate::math::hard_numbers::{Random, WORDS};

    /// The promise of the documentation: 2^-29.4.
    const BOUND: f64 = 1.41e-9;

    /// |m n / 2^shift - 1|.
    fn error(n: u32) -> f64 {
        let Reciprocal { mantissa, shift } = reciprocal(n);
        assert!((1 << 30..1 << 31).contains(&mantissa), "mantissa of 1/{n}");
        assert_eq!(shift, 62 - n.leading_zeros());
        let product = i128::from(mantissa) * i128::from(n);
        (product - (1i128 << shift)).unsigned_abs() as f64 / (1i128 << shift) as f64
    }

    #[test]
    fn error_is_bounded_in_every_interval_of_the_table() {
        let mut random = Random::new(4);
        let mut worst = 0.0;
        for interval in 128..256u32 {
            let first = interval << 24;
            for n in [first, first + 1, first | 0x00FF_FFFE, first | 0x00FF_FFFF] {
                worst = f64::max(worst, error(n));
            }
            // Evenly spread, with random low bits: the truncations depend on all of them.
            for step in 0..8192 {
                let low = (step << 11) | (random.word() & 0x7FF);
                worst = f64::max(worst, error(first | low));
            }
        }
        std::println!("reciprocal: worst 2^{:.2} = {worst:e}", worst.log2());
        assert!(worst <= BOUND, "{worst:e}");
    }

    #[test]
    fn the_last_step_at_once_has_the_bits_of_the_last_step() {
        let mut random = Random::new(6);
        for round in 0..2_000_000_u32 {
            let normal = random.word() | 1 << 31;
            // As good as the first step leaves it, and as bad as the error's 16 bits allow.
            let exact = (1_u64 << 62) / u64::from(normal);
            let spread = random.word() >> 17 >> (round % 16);
            let estimate = u32::try_from(exact).unwrap_or(0).wrapping_sub(spread);
            let (one, other) = (last_step_at_once(normal, estimate), last_step(normal, estimate));
            assert_eq!(one, other, "{normal:#x} from {estimate:#x}");
        }
    }

    #[test]
    fn error_is_bounded_for_small_hard_and_random_numbers() {
        let mut random = Random::new(5);
        let randoms = (0..500_000).map(|_| {
            let word = random.word();
            (word >> (word & 31)).max(1)
        });
        let hard = WORDS.into_iter().filter(|&n| n != 0);
        for n in (1..200_000).chain(hard).chain(randoms) {
            assert!(error(n) <= BOUND, "1/{n}");
        }
    }

    #[test]
    fn zero_saturates() {
        assert_eq!(reciprocal(0), reciprocal(1));
    }
}
