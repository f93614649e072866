use super::{Plane, Triangle};
use crate::math::{reciprocal, wide_product};

/// What the attribute planes of one triangle share: its sides and the reciprocal of its area.
///
/// # Rounding
/// Slopes are rounded to 2^-16 of a step of the attribute and come from the exact determinant, in
/// 64 bits that are cut off, never clamped: see [`Plane`]. The reciprocal's error (2^-27.9) is
/// common to both slopes, so that it only scales the difference to the first corner.
///
/// # Cost
/// About 110 instructions to make and 70 a plane on Cortex-M4.
#[derive(Clone, Copy, Debug, Default)]
pub struct Gradients {
    x1: i32,
    y1: i32,
    x2: i32,
    y2: i32,
    /// 1 / (2 area) = mantissa 2^-(shift + 20), the 20 for 16 fraction bits and 16 subpixels.
    mantissa: u32,
    shift: u32,
    /// Half a unit of the shifted product.
    half: i64,
    /// Sides so long that numerators need 64 bits.
    long: bool,
    /// From the first corner to the centre of its pixel, in subpixels.
    to_center_x: i32,
    to_center_y: i32,
    /// The first corner's pixel.
    pixel_x: i32,
    pixel_y: i32,
}

/// Sides up to here (1024 pixels, in subpixels) keep numerators of 16-bit attributes in an i32.
const SHORT_SIDE: u32 = 1 << 14;
// Two products of a 16-bit difference and a side, subtracted.
const _: () = assert!(2 * 65535 * (SHORT_SIDE as i64) < 1 << 31, "numerators");

impl Gradients {
    /// Prepares the planes of a triangle.
    #[inline(never)]
    #[allow(
        clippy::cast_possible_truncation,
        reason = "planes are modulo 2^32: the upper bits are cut off on purpose"
    )]
    pub fn new(triangle: &Triangle) -> Self {
        let [a, b, c] = &triangle.v;
        let (x1, y1) = (b.x_bits().wrapping_sub(a.x_bits()), b.y_bits().wrapping_sub(a.y_bits()));
        let (x2, y2) = (c.x_bits().wrapping_sub(a.x_bits()), c.y_bits().wrapping_sub(a.y_bits()));
        // Areas above 32 bits lose low bits that are far below the reciprocal's own error.
        let excess = 32_u32.saturating_sub(triangle.area.leading_zeros());
        let reciprocal = reciprocal((triangle.area >> excess) as u32);
        let shift = reciprocal.shift.wrapping_add(excess).wrapping_sub(20);
        let longest = x1.unsigned_abs() | y1.unsigned_abs() | x2.unsigned_abs() | y2.unsigned_abs();
        Self {
            x1,
            y1,
            x2,
            y2,
            mantissa: reciprocal.mantissa,
            shift,
            half: 1 << (shift.wrapping_sub(1) & 63),
            long: longest >= SHORT_SIDE,
            to_center_x: 8_i32.wrapping_sub(a.x_bits() & 15),
            to_center_y: 8_i32.wrapping_sub(a.y_bits() & 15),
            pixel_x: a.x_bits() >> 4,
            pixel_y: a.y_bits() >> 4,
        }
    }

    /// The plane through an attribute's values at the triangle's corners, as 16.16.
    ///
    /// # Range
    /// Any three 16-bit values, whatever they count: depth codes, 8.8 channels.
    #[inline(always)]
    pub fn plane(&self, a: u16, b: u16, c: u16) -> Plane {
        let d1 = i32::from(b).wrapping_sub(i32::from(a));
        let d2 = i32::from(c).wrapping_sub(i32::from(a));
        if d1 == 0 && d2 == 0 {
            return Plane { origin: u32::from(a) << 16, dx: 0, dy: 0 };
        }
        let (dx, sub_x) = self.slope(d1, self.y2, d2, self.y1);
        let (dy, sub_y) = self.slope(d2, self.x1, d1, self.x2);
        let origin = (i32::from(a) << 16)
            .wrapping_add(sub_x.wrapping_mul(self.to_center_x))
            .wrapping_add(sub_y.wrapping_mul(self.to_center_y))
            .wrapping_sub(dx.wrapping_mul(self.pixel_x))
            .wrapping_sub(dy.wrapping_mul(self.pixel_y));
        Plane { origin: origin as u32, dx: dx as u32, dy: dy as u32 }
    }

    /// (p q - r s) / (2 area): a pixel's and a subpixel's step, cut to 32 bits.
    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "planes are modulo 2^32: the upper bits are cut off on purpose"
    )]
    fn slope(&self, p: i32, q: i32, r: i32, s: i32) -> (i32, i32) {
        if self.long {
            return self.slope_of_long_sides(p, q, r, s);
        }
        let numerator = p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s));
        let product = wide_product(numerator, self.mantissa).wrapping_add(self.half);
        // product >> shift by words: cheaper than a shift of 64 bits by a variable.
        let (high, low) = ((product >> 32) as i32, product as u32);
        let (high, low) = if self.shift < 32 {
            let over = (high as u32).wrapping_shl(32_u32.wrapping_sub(self.shift));
            (high.wrapping_shr(self.shift), over | low.wrapping_shr(self.shift))
        } else {
            (high >> 31, high.wrapping_shr(self.shift.wrapping_sub(32)) as u32)
        };
        (low as i32, ((high as u32) << 28 | low >> 4) as i32)
    }

    /// The same where numerators need more than 32 bits: apart, because it is rare and long.
    #[cold]
    #[inline(never)]
    fn slope_of_long_sides(&self, p: i32, q: i32, r: i32, s: i32) -> (i32, i32) {
        let exact =
            i64::from(p).wrapping_mul(q.into()).wrapping_sub(i64::from(r).wrapping_mul(s.into()));
        let scaled = |shift| scaled_wide(exact, self.mantissa, shift);
        (scaled(self.shift), scaled(self.shift.wrapping_add(4)))
    }
}

/// The low 32 bits of numerator x mantissa / 2^shift, rounded, for numerators of up to 36 bits.
///
/// The whole product has up to 67 bits: its low 64 are enough while the shift is at most 32, its
/// high part from there on.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "planes are modulo 2^32: the upper bits are cut off on purpose"
)]
fn scaled_wide(numerator: i64, mantissa: u32, shift: u32) -> i32 {
    if shift <= 32 {
        let product = numerator.wrapping_mul(mantissa.into());
        (product.wrapping_add(1 << (shift.wrapping_sub(1) & 63)) >> (shift & 63)) as i32
    } else {
        let low = (numerator & 0xFFFF_FFFF).wrapping_mul(mantissa.into());
        // Logical: the low product is unsigned.
        let carry = ((low as u64) >> 32) as i64;
        let high = (numerator >> 32).wrapping_mul(mantissa.into()).wrapping_add(carry);
        let shift = shift.wrapping_sub(32);
        (high.wrapping_add(1 << (shift.wrapping_sub(1) & 63)) >> (shift & 63)) as i32
    }
}
