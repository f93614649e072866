use super::{Plane, Triangle};
use crate::math::{mul_high_signed, reciprocal, weighted_sum};

/// What the attribute planes of one triangle share: its sides and the reciprocal of its area.
///
/// # Rounding
/// On triangles that are neither large nor thin (sides below 1024 pixels, and twice the area at
/// least 1/32 of the longest side's square) a slope is the sum of two differences, each times its
/// weight of 27 bits: over the whole triangle an attribute is off by less than 1/8 of a step. On
/// all others slopes come from the exact determinant, rounded to 2^-16 of a step, in 64 bits that
/// are cut off, never clamped: see [`Plane`]. The reciprocal's error (2^-27.9) is common to both
/// slopes, so that it only scales the difference to the first corner.
///
/// # Cost
/// About 110 instructions to make and 40 a plane on Cortex-M4, 300 a plane of large or thin
/// triangles.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    steps: Steps,
    /// From the first corner to the centre of its pixel, in subpixels.
    to_center_x: i32,
    to_center_y: i32,
    /// The first corner's pixel.
    pixel_x: i32,
    pixel_y: i32,
}

/// What slopes are made of.
#[derive(Clone, Copy, Debug)]
enum Steps {
    /// What a difference of 2^16 to the second and to the third corner makes in a column and in a
    /// row, up to the shifts.
    Weighted { by_column: [i32; 2], by_row: [i32; 2], pixel: Shifts, subpixel: Shifts },
    /// The sides, and 1 / (2 area) = mantissa 2^-(shift + 20), the 20 for 16 fraction bits and 16
    /// subpixels.
    Exact { x1: i32, y1: i32, x2: i32, y2: i32, mantissa: u32, shift: u32 },
}

/// A shift by a number of either sign: one of the two is zero.
#[derive(Clone, Copy, Debug, Default)]
struct Shifts {
    up: u32,
    down: u32,
}

impl Shifts {
    fn by(up: i32) -> Self {
        Self { up: up.max(0) as u32, down: up.wrapping_neg().max(0) as u32 }
    }

    #[inline(always)]
    const fn apply(self, v: i32) -> i32 {
        v.wrapping_shl(self.up).wrapping_shr(self.down)
    }
}

/// The slopes of an attribute, 16.16: a column's and a row's step, and a subpixel's.
#[derive(Clone, Copy, Debug)]
struct Slopes {
    dx: i32,
    dy: i32,
    sub_x: i32,
    sub_y: i32,
}

/// Sides up to here (1024 pixels, in subpixels) may have weights.
const SHORT_SIDE: u32 = 1 << 14;
/// The least twice area that weights are made for, as a power of two of the longest side's square.
const THICK: u32 = 5;

impl Gradients {
    /// Of no triangle: where nothing is interpolated.
    pub(crate) const NONE: Self = Self {
        steps: Steps::Exact { x1: 0, y1: 0, x2: 0, y2: 0, mantissa: 0, shift: 0 },
        to_center_x: 0,
        to_center_y: 0,
        pixel_x: 0,
        pixel_y: 0,
    };

    /// Prepares the planes of a triangle.
    #[inline(never)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "areas of short sides fit, large ones are shifted so that they do; shifts are small"
    )]
    pub fn new(triangle: &Triangle) -> Self {
        let [a, b, c] = &triangle.v;
        let (x1, y1) = (b.x_bits().wrapping_sub(a.x_bits()), b.y_bits().wrapping_sub(a.y_bits()));
        let (x2, y2) = (c.x_bits().wrapping_sub(a.x_bits()), c.y_bits().wrapping_sub(a.y_bits()));
        // At least the longest side, and less than twice as much.
        let longest = x1.unsigned_abs() | y1.unsigned_abs() | x2.unsigned_abs() | y2.unsigned_abs();
        let area = triangle.area as u32;
        let steps = if longest < SHORT_SIDE && area >= longest.wrapping_mul(longest) >> THICK {
            let reciprocal = reciprocal(area);
            // Sides below 2^28, so that the weights are below 2^27.
            let room = longest.leading_zeros().wrapping_sub(4);
            let weight = |side: i32| mul_high_signed(side.wrapping_shl(room), reciprocal.mantissa);
            // side / area = weight 2^(32 - room - shift); sums lose 16 bits, slopes have 16 more
            // and count pixels of 16 subpixels.
            let up = 68_i32.wrapping_sub(room.wrapping_add(reciprocal.shift) as i32);
            Steps::Weighted {
                by_column: [weight(y2), weight(y1.wrapping_neg())],
                by_row: [weight(x2.wrapping_neg()), weight(x1)],
                pixel: Shifts::by(up),
                subpixel: Shifts::by(up.wrapping_sub(4)),
            }
        } else {
            // Areas above 32 bits lose low bits that are far below the reciprocal's own error.
            let excess = 32_u32.saturating_sub(triangle.area.leading_zeros());
            let reciprocal = reciprocal((triangle.area >> excess) as u32);
            let shift = reciprocal.shift.wrapping_add(excess).wrapping_sub(20);
            Steps::Exact { x1, y1, x2, y2, mantissa: reciprocal.mantissa, shift }
        };
        Self {
            steps,
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
        let Slopes { dx, dy, sub_x, sub_y } = match &self.steps {
            Steps::Weighted { by_column, by_row, pixel, subpixel } => {
                let sum = |[p, q]: &[i32; 2]| weighted_sum(d1, *p, d2, *q);
                let (x, y) = (sum(by_column), sum(by_row));
                Slopes {
                    dx: pixel.apply(x),
                    dy: pixel.apply(y),
                    sub_x: subpixel.apply(x),
                    sub_y: subpixel.apply(y),
                }
            }
            Steps::Exact { x1, y1, x2, y2, mantissa, shift } => {
                exact_slopes([*x1, *y1, *x2, *y2], d1, d2, *mantissa, *shift)
            }
        };
        let origin = (i32::from(a) << 16)
            .wrapping_add(sub_x.wrapping_mul(self.to_center_x))
            .wrapping_add(sub_y.wrapping_mul(self.to_center_y))
            .wrapping_sub(dx.wrapping_mul(self.pixel_x))
            .wrapping_sub(dy.wrapping_mul(self.pixel_y));
        Plane { origin: origin as u32, dx: dx as u32, dy: dy as u32 }
    }
}

/// From the exact determinant: apart, because it is rare and long.
#[cold]
#[inline(never)]
fn exact_slopes([x1, y1, x2, y2]: [i32; 4], d1: i32, d2: i32, mantissa: u32, shift: u32) -> Slopes {
    let slopes = |p: i32, q: i32, r: i32, s: i32| {
        let (p, q, r, s) = (i64::from(p), i64::from(q), i64::from(r), i64::from(s));
        let numerator = p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s));
        let scaled = |shift| scaled_wide(numerator, mantissa, shift);
        (scaled(shift), scaled(shift.wrapping_add(4)))
    };
    let (dx, sub_x) = slopes(d1, y2, d2, y1);
    let (dy, sub_y) = slopes(d2, x1, d1, x2);
    Slopes { dx, dy, sub_x, sub_y }
}

/// The low 32 bits of numerator x mantissa / 2^shift, rounded, for numerators of up to 36 bits.
///
/// The whole product has up to 67 bits: its low 64 are enough while the shift is at most 32, its
/// high part from there on.
#[inline(never)]
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
