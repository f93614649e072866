/// The square root of `x`, correctly rounded (to nearest, ties to even), with integers only.
///
/// `core` has no square root, and a library's may differ in the last bit from target to target;
/// this one is the bits that IEEE 754 prescribes everywhere. The method is the digit recurrence
/// that schools teach, one binary digit a step (Ercegovac and Lang, *Digital Arithmetic*, chapter 6).
///
/// # Range
///
/// Every float. Zeros keep their sign, infinity stays infinity, and NaN and all negative numbers
/// give NaN.
///
/// # Cost
///
/// 25 steps of about seven integer instructions, no multiplication, on every core.
///
/// ```
/// use microraster::math::sqrt;
///
/// assert_eq!(sqrt(2.0), core::f32::consts::SQRT_2);
/// assert!(sqrt(-1.0).is_nan());
/// ```
#[must_use]
pub const fn sqrt(x: f32) -> f32 {
    const INFINITY: u32 = 0x7F80_0000;
    let bits = x.to_bits();
    if bits << 1 == 0 || bits == INFINITY {
        return x;
    }
    if bits > INFINITY {
        return f32::NAN;
    }

    // Take x apart as significand * 2^exponent with 2^23 <= significand < 2^24.
    let mut significand = bits & 0x007F_FFFF;
    let mut exponent = (bits >> 23).cast_signed();
    if exponent == 0 {
        let shift = significand.leading_zeros() - 8;
        significand <<= shift;
        exponent = 1 - shift.cast_signed();
    } else {
        significand |= 0x0080_0000;
    }
    exponent -= 127;

    // An even exponent halves exactly; an odd one lends a factor of two.
    let mut remainder = significand << (1 + (exponent & 1));
    exponent >>= 1;

    // Find 24 digits of the root and one more for rounding.
    let mut root = 0;
    let mut twice_root = 0;
    let mut digit = 1 << 24;
    while digit != 0 {
        let trial = twice_root + digit;
        if trial <= remainder {
            remainder -= trial;
            twice_root = trial + digit;
            root += digit;
        }
        remainder <<= 1;
        digit >>= 1;
    }

    // A root of 25 digits would need a square of 49 or more: there are no ties, nor exact
    // results with the last digit set, so the last digit alone decides.
    root = (root + 1) >> 1;
    // The leading digit of the root adds the one that is missing in the exponent.
    f32::from_bits(root.wrapping_add(((exponent + 126) << 23).cast_unsigned()))
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::sqrt;
    use crate::math::hard_numbers::{Random, FLOATS};

    fn check(x: f32) {
        let (ours, theirs) = (sqrt(x), x.sqrt());
        assert!(
            ours.to_bits() == theirs.to_bits() || (ours.is_nan() && theirs.is_nan()),
            "sqrt({x:e}) = {ours:e}, not {theirs:e}"
        );
    }

    #[test]
    fn hard_numbers_agree_with_the_host() {
        for x in FLOATS {
            check(x);
        }
        assert!(sqrt(-f32::MIN_POSITIVE).is_nan());
        assert_eq!(sqrt(-0.0).to_bits(), (-0.0f32).to_bits());
    }

    #[test]
    fn random_bit_patterns_agree_with_the_host() {
        let mut random = Random::new(2);
        for _ in 0..4_000_000 {
            check(f32::from_bits(random.word()));
        }
    }

    #[test]
    fn random_subnormals_agree_with_the_host() {
        let mut random = Random::new(3);
        for _ in 0..500_000 {
            let word = random.word();
            check(f32::from_bits((word & 0x007F_FFFF) >> (word >> 27)));
        }
    }

    #[test]
    fn every_significand_of_two_octaves_agrees_with_the_host() {
        // All other results are these, times a power of two. A stride keeps debug builds quick.
        for bits in (1.0f32.to_bits()..4.0f32.to_bits()).step_by(7) {
            check(f32::from_bits(bits));
        }
    }
}
