/// One over the square root of an integer: 1 / sqrt(n) is about `mantissa` / 2^`shift`.
///
/// Made by [`inverse_sqrt`]. The mantissa is short on purpose: its product with a number of
/// 15 bits stays in 32.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct InverseSqrt {
    /// In [2^15, 2^16].
    pub mantissa: u32,
    /// In [16, 31]; 0 for the square root of zero only.
    pub shift: u32,
}

/// 256 / sqrt(f) - 256 in the middle of each interval of f = n / 2^32 in [1/4, 1) that seven bits
/// tell apart. The first 32 entries are never read: they let a mask stand for a bounds check.
static SEEDS: [u8; 128] = {
    let mut seeds = [0; 128];
    let mut i = 32u32;
    while i < 128 {
        // f = (2 i + 1) / 256, so 256 / sqrt(f) = sqrt(2^24 / (2 i + 1)); one more bit rounds it.
        let twice = ((1u32 << 26) / (2 * i + 1)).isqrt();
        seeds[i as usize] = ((twice.div_ceil(2) - 256) & 0xFF) as u8;
        i += 1;
    }
    seeds
};

/// The inverse square root of `n`, for normals and other lengths in integers.
///
/// A seed from a table and one step of Newton's iteration y' = y (3 - f y^2) / 2 (Warren,
/// *Hacker's Delight*, section 11-1 has the iteration for the root itself).
///
/// # Range
///
/// Every `n`. Zero gives the saturated value 2^16, where all others are at most 1.
///
/// # Rounding
///
/// Relative error at most 0.014 %, or 2^-12.8.
///
/// # Cost
///
/// Three 32-bit multiplications and a table of 128 bytes; no division, no 64-bit product.
///
/// ```
/// use microraster::math::inverse_sqrt;
///
/// // Make the vector (300, 400) 127 long, as a normal is kept.
/// let inverse = inverse_sqrt(300 * 300 + 400 * 400);
/// let unit = |x: u32| (127 * x * inverse.mantissa + (1 << (inverse.shift - 1))) >> inverse.shift;
/// assert_eq!((unit(300), unit(400)), (76, 102));
/// ```
#[must_use]
pub fn inverse_sqrt(n: u32) -> InverseSqrt {
    if n == 0 {
        return InverseSqrt { mantissa: 1 << 16, shift: 0 };
    }
    // f = normal / 2^32, in [1/4, 1): the shift must be even to come out of the root.
    let even_zeros = n.leading_zeros() & !1;
    let normal = n << even_zeros;

    let seed = u32::from(SEEDS[((normal >> 25) & 127) as usize]) + 256;

    // f y^2 with 30 fraction bits is close to 1, hence 3 - f y^2 close to 2 and in 32 bits.
    let product = (normal >> 16).wrapping_mul((seed * seed) >> 2);
    let rest = (3u32 << 30).wrapping_sub(product);
    // 8 + 14 fraction bits, 15 wanted, and half of it.
    let mantissa = (seed.wrapping_mul(rest >> 16)).wrapping_add(1 << 7) >> 8;

    InverseSqrt { mantissa: mantissa.clamp(1 << 15, 1 << 16), shift: 31 - even_zeros / 2 }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::{inverse_sqrt, InverseSqrt};
    use crate::math::hard_numbers::{Random, WORDS};

    /// The promise of the documentation.
    const BOUND: f64 = 1.4e-4;

    fn error(n: u32) -> f64 {
        let InverseSqrt { mantissa, shift } = inverse_sqrt(n);
        assert!((1 << 15..=1 << 16).contains(&mantissa), "mantissa of {n}");
        assert!((16..=31).contains(&shift), "shift of {n}");
        (f64::from(mantissa) / f64::from(shift).exp2() * f64::from(n).sqrt() - 1.0).abs()
    }

    #[test]
    fn error_is_bounded_for_every_pattern_of_the_high_bits() {
        let mut worst = 0.0;
        // All values of the upper half, in which the arithmetic works, with the lower half at both ends.
        for high in 1u32 << 14..1 << 16 {
            for low in [0, 1, 0x8000, 0xFFFF] {
                worst = f64::max(worst, error((high << 16) | low));
            }
        }
        std::println!("inverse_sqrt: worst {worst:e}");
        assert!(worst <= BOUND, "{worst:e}");
    }

    #[test]
    fn error_is_bounded_for_small_hard_and_random_numbers() {
        let mut random = Random::new(6);
        let randoms = (0..500_000).map(|_| {
            let word = random.word();
            (word >> (word & 31)).max(1)
        });
        let hard = WORDS.into_iter().filter(|&n| n != 0);
        for n in (1..200_000).chain(hard).chain(randoms) {
            assert!(error(n) <= BOUND, "{n}");
        }
    }

    #[test]
    fn zero_saturates() {
        assert_eq!(inverse_sqrt(0), InverseSqrt { mantissa: 1 << 16, shift: 0 });
    }
}
