use super::BY_HALVES;

/// The integer part of a float; saturates. Not for what is no number.
///
/// ARMv6-M converts by a routine, and by four more the compiler asks whether the result fits. By the
/// bits it is short; the result is the same.
#[inline(never)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "a float cast saturates; a bit is left above"
)]
pub(crate) const fn whole(v: f32) -> i32 {
    if BY_HALVES {
        by_bits(v)
    } else {
        v as i32
    }
}

/// The same by the bits.
#[allow(clippy::cast_possible_wrap, reason = "a bit is left above")]
const fn by_bits(v: f32) -> i32 {
    let bits = v.to_bits();
    let exponent = bits >> 23 & 0xFF;
    if exponent > 157 {
        return if v.is_sign_negative() { i32::MIN } else { i32::MAX };
    }
    // |v| = significand 2^-down.
    let (significand, down) = (bits << 8 | 1 << 31, 158 - exponent);
    let size = if down < 32 { significand >> down } else { 0 } as i32;
    if v.is_sign_negative() {
        size.wrapping_neg()
    } else {
        size
    }
}

#[cfg(test)]
mod tests {
    use super::by_bits;
    use crate::math::hard_numbers::{Random, FLOATS};

    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
    fn bits_give_what_a_cast_gives() {
        let mut random = Random::new(11);
        let randoms = (0..200_000).map(|_| f32::from_bits(random.word()));
        for v in FLOATS.into_iter().chain(randoms).filter(|v| !v.is_nan()) {
            assert_eq!(by_bits(v), v as i32, "{v}");
        }
    }
}
