//! Sine and cosine in integers.

use super::wide::mul_high;

/// (pi/4)^(2k+1) / (2k+1)! with 32 fraction bits: the series of sin(pi/4 z) / z.
static SINE: [u32; 5] = [0xC90F_DAA2, 0x14AB_BCE6, 0x00A3_35E3, 0x0002_65A6, 0x0000_0542];

/// (pi/4)^(2k) / (2k)! with 31 fraction bits: the series of cos(pi/4 z) after its 1.
static COSINE: [u32; 5] = [0x277A_7993, 0x0207_83E1, 0x000A_AE9E, 0x0000_1E1F, 0x0000_0035];

/// The sum c0 - w (c1 - w (c2 - w (c3 - w c4))), `w` with 32 fraction bits.
///
/// No difference is negative: each coefficient is less than a seventh of the one before.
#[inline(never)]
const fn alternating_series([c0, c1, c2, c3, c4]: &[u32; 5], w: u32) -> u32 {
    let sum = c3.wrapping_sub(mul_high(w, *c4));
    let sum = c2.wrapping_sub(mul_high(w, sum));
    let sum = c1.wrapping_sub(mul_high(w, sum));
    c0.wrapping_sub(mul_high(w, sum))
}

/// Sine and cosine of an angle in units of 2^-32 turn.
///
/// The Taylor series on an eighth of a turn to either side, in fixed point, and one conversion to
/// float: the error (3.2e-8 for either, measured over the circle) is hardly more than what
/// rounding to an `f32` costs.
#[inline(never)]
pub(super) const fn sin_cos(angle: u32) -> (f32, f32) {
    const UNIT: f32 = 1.0 / 2_147_483_648.0;

    // Quadrants centred on the axes; the distance from the axis is z eighths of a turn.
    let shifted = angle.wrapping_add(1 << 29);
    let offset = (shifted & 0x3FFF_FFFF).cast_signed() - (1 << 29);
    let z = offset.unsigned_abs() << 2;

    // z^2 with 32 fraction bits; 1 itself does not fit, and 2^-30 less makes no difference.
    let square = mul_high(z, z);
    let square = (if square >> 30 == 0 { square } else { (1 << 30) - 1 }) << 2;

    let sine = mul_high(z, alternating_series(&SINE, square)) as f32 * UNIT;
    let cosine = mul_high(square, alternating_series(&COSINE, square));
    let cosine = (1u32 << 31).wrapping_sub(cosine) as f32 * UNIT;

    // Subtracting from zero, unlike negating, makes no negative zero.
    let sine = if offset < 0 { 0.0 - sine } else { sine };
    match shifted >> 30 {
        0 => (sine, cosine),
        1 => (cosine, 0.0 - sine),
        2 => (0.0 - sine, 0.0 - cosine),
        _ => (0.0 - cosine, sine),
    }
}

/// x C in units of 2^-32, modulo 2^32, for any float `x` and a constant C in (0, 1) given by its
/// first 192 fraction bits (and 64 zeros, which stand in front of it too). Not a number and
/// infinities give 0.
///
/// This is the argument reduction of Payne and Hanek (*SIGNUM Newsletter* 18, 1983): of C only the
/// 64 bits matter that can reach the result, the more significant ones give whole units, which
/// drop out. The error is 2^-8 of a unit before the final rounding, however large `x` is.
pub(super) const fn times_fraction(x: f32, c: &[u32; 8]) -> u32 {
    // x = significand * 2^exponent, both integers.
    let bits = x.to_bits();
    let biased = (bits >> 23) & 0xFF;
    let (significand, exponent) = match biased {
        0xFF => return 0,
        0 => (bits & 0x007F_FFFF, 1 - 150),
        _ => (bits & 0x007F_FFFF | 0x0080_0000, biased.cast_signed() - 150),
    };
    if exponent <= -64 {
        return 0;
    }

    // The 64 bits of C from the one whose product has weight 1/2.
    let word = exponent >> 5;
    let shift = exponent & 31;
    let first = c[(word & 7).cast_unsigned() as usize] as u64;
    let second = c[((word + 1) & 7).cast_unsigned() as usize] as u64;
    let third = c[((word + 2) & 7).cast_unsigned() as usize] as u64;
    let window = (((first << 32) | second) << shift) | ((third << shift) >> 32);

    let product = (significand as u64).wrapping_mul(window);
    let rounded = (product.wrapping_add(1 << 31) >> 32) as u32;
    if bits >> 31 == 0 {
        rounded
    } else {
        rounded.wrapping_neg()
    }
}
