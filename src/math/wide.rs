//! Products of two 32-bit numbers at full width, the same bits on every target.
//!
//! A Cortex-M0+ (`ARMv6-M`) multiplies 32x32 to 32 bits only; the compiler would call a library
//! routine for each 64-bit product. There the product is put together from four 16-bit halves
//! (Knuth, *The Art of Computer Programming* 2, section 4.3.1, algorithm M with base 2^16).

/// The whole product as (high word, low word), by the processor's own 32x32 to 64 multiply.
#[cfg(any(test, not(all(target_arch = "arm", not(target_has_atomic = "32")))))]
#[inline(always)]
const fn wide_mul_native(a: u32, b: u32) -> (u32, u32) {
    let product = a as u64 * b as u64;
    ((product >> 32) as u32, (product & 0xFFFF_FFFF) as u32)
}

/// The whole product as (high word, low word), from 16-bit halves.
#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[inline(always)]
const fn wide_mul_halves(a: u32, b: u32) -> (u32, u32) {
    let (a_low, a_high) = (a & 0xFFFF, a >> 16);
    let (b_low, b_high) = (b & 0xFFFF, b >> 16);

    // Each partial product fits: 65535^2 < 2^32.
    let low = a_low.wrapping_mul(b_low);
    let cross = a_low.wrapping_mul(b_high);
    let (middle, middle_carry) = cross.overflowing_add(a_high.wrapping_mul(b_low));

    // The middle sum has weight 2^16, its carry weight 2^48.
    let (low, low_carry) = low.overflowing_add(middle << 16);
    let high = a_high
        .wrapping_mul(b_high)
        .wrapping_add(middle >> 16)
        .wrapping_add((middle_carry as u32) << 16)
        .wrapping_add(low_carry as u32);
    (high, low)
}

/// The whole product of two unsigned words as (high word, low word). Exact.
#[inline(always)]
pub(crate) const fn wide_mul(a: u32, b: u32) -> (u32, u32) {
    #[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
    return wide_mul_native(a, b);
    #[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
    return wide_mul_halves(a, b);
}

/// floor(a * b / 2^32). Exact.
#[inline(always)]
pub(crate) const fn mul_high(a: u32, b: u32) -> u32 {
    wide_mul(a, b).0
}

/// floor(a * b / 2^32) of signed words: rounds towards minus infinity. Exact.
#[inline(always)]
pub(crate) const fn mul_high_signed(a: i32, b: i32) -> i32 {
    // A negative word read as unsigned is 2^32 too large, which adds the other factor above.
    let unsigned = mul_high(a.cast_unsigned(), b.cast_unsigned()).cast_signed();
    unsigned
        .wrapping_sub(b & (a >> 31))
        .wrapping_sub(a & (b >> 31))
}

/// The whole product of two signed words. Exact.
#[allow(
    dead_code,
    reason = "part of the set: transform and attribute set-up take their products from here"
)]
#[inline(always)]
pub(crate) const fn wide_mul_signed(a: i32, b: i32) -> i64 {
    let low = a.wrapping_mul(b).cast_unsigned();
    ((mul_high_signed(a, b) as i64) << 32) | low as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::{Random, WORDS};

    fn check(a: u32, b: u32) {
        let product = u64::from(a) * u64::from(b);
        assert_eq!(wide_mul_native(a, b), wide_mul_halves(a, b));
        let (high, low) = wide_mul(a, b);
        assert_eq!((u64::from(high) << 32) | u64::from(low), product);
        assert_eq!(u64::from(mul_high(a, b)), product >> 32);

        let (a, b) = (a.cast_signed(), b.cast_signed());
        let product = i64::from(a) * i64::from(b);
        assert_eq!(i64::from(mul_high_signed(a, b)), product >> 32);
        assert_eq!(wide_mul_signed(a, b), product);
    }

    #[test]
    fn hard_words_multiply_exactly() {
        for a in WORDS {
            for b in WORDS {
                check(a, b);
            }
        }
    }

    #[test]
    fn random_words_multiply_exactly_in_halves_and_natively() {
        let mut random = Random::new(1);
        for _ in 0..1_000_000 {
            check(random.word(), random.word());
        }
    }
}
