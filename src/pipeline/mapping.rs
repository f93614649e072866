use super::projected::{flag, Projected};
use super::transform::Depth;
use super::Clip;
use crate::frame::Size;
use crate::math::{
    mul_high_31, mul_high_positive, mul_high_signed, reciprocal_of_some, Reciprocal,
};
use crate::raster::{ScreenVertex, GUARD, SUBPIXELS};

/// Half a side of the viewport in subpixels, normalised for products with reciprocals.
#[derive(Clone, Copy, Debug)]
struct HalfSide {
    /// In 2^30..2^31.
    mantissa: i32,
    /// v / w x half is twice the upper word of v x (the upper word of both mantissas), shifted right
    /// by this and the reciprocal's shift.
    down: u32,
}

impl HalfSide {
    #[allow(clippy::cast_possible_wrap, reason = "a bit is left above")]
    const fn new(pixels: u16) -> Self {
        // Half of 16 to the pixel.
        let subpixels = pixels as u32 * 8;
        let room = subpixels.leading_zeros();
        let mantissa = subpixels.wrapping_shl(room) >> 1;
        Self { mantissa: mantissa as i32, down: room.wrapping_sub(66) }
    }

    /// v / w x half a side in subpixels, rounded to nearest; saturates far beyond the guard box.
    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, reason = "mantissas are below 2^31")]
    fn times(self, v: i32, over_w: Reciprocal) -> i32 {
        let factor = mul_high_positive(over_w.mantissa as i32, self.mantissa);
        let down = self.down.wrapping_add(over_w.shift);
        let (v, down) = if down < 32 { (v, down) } else { (raised(v, down.wrapping_neg()), 0) };
        (mul_high_signed(v, factor as u32) >> down).wrapping_add(1) >> 1
    }
}

/// v x 2^up for a vertex near the eye; saturates.
#[cold]
#[inline(never)]
fn raised(v: i32, up: u32) -> i32 {
    let most = i32::MAX.wrapping_shr(up);
    v.max(most.wrapping_neg()).min(most).wrapping_shl(up)
}

/// From clip space to the screen: the viewport's numbers, ready for 32-bit products.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mapping {
    half_width: HalfSide,
    half_height: HalfSide,
    /// The viewport's centre in subpixels of the picture.
    pub(crate) center_x: i32,
    pub(crate) center_y: i32,
    /// The viewport's size in pixels.
    size: Size,
    pub(super) depth: Depth,
}

/// How far from the viewport's centre a corner may lie, in subpixels.
const GUARD_BITS: i32 = GUARD * SUBPIXELS;

/// Depth codes from the far end to the near plane.
const DEPTHS: u32 = 65_531;

const _: () = assert!((Clip::LIMIT as u32 - 1).leading_zeros() >= 2, "a shift by w's room");
const _: () = assert!((DEPTHS as u64) << 14 < 1 << 31, "a factor of a high product");
const _: () = assert!(2 + DEPTHS <= u16::MAX as u32, "depth codes");

impl Mapping {
    /// The mapping to a viewport of this size whose upper left corner is the pixel (`left`, `top`).
    pub(super) fn new(left: i32, top: i32, size: Size, depth: Depth) -> Self {
        // Sides are at most 8192 pixels, so that nothing here can overflow.
        let center = |from: i32, side: u16| from.wrapping_mul(16).wrapping_add(i32::from(side) * 8);
        Self {
            half_width: HalfSide::new(size.width),
            half_height: HalfSide::new(size.height),
            center_x: center(left, size.width),
            center_y: center(top, size.height),
            size,
            depth,
        }
    }

    /// The viewport's size in pixels.
    pub(super) const fn size(&self) -> Size {
        self.size
    }

    /// Projects a vertex and says on which sides of the view it lies.
    ///
    /// # Cost
    /// One reciprocal and five high products: about 125 instructions on Cortex-M4, with the flags.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "compared with the original")]
    pub(crate) fn project(&self, clip: &Clip) -> Projected {
        let Clip { x, y, z, w } = *clip;
        // Coordinates are below 2^30: a sum's sign bit is right.
        let (left, right) = (w.wrapping_add(x), w.wrapping_sub(x));
        let (above, below) = (w.wrapping_sub(y), w.wrapping_add(y));
        let mut flags = 0;
        if left | right | above | below < 0 {
            let outside = |margin: i32, flag: u16| (margin as u32 >> 31) as u16 * flag;
            flags = outside(left, flag::LEFT)
                | outside(right, flag::RIGHT)
                | outside(above, flag::ABOVE)
                | outside(below, flag::BELOW);
        }
        if self.is_behind_near(z, w) {
            return Projected { x: 0, y: 0, z: 0, flags: flags | flag::NEAR };
        }
        if z < self.depth.z_min {
            flags |= flag::FAR;
        }
        let (x, y, z) = self.screen(clip);
        let (short_x, short_y) = (x as i16, y as i16);
        if i32::from(short_x) != x || i32::from(short_y) != y {
            flags |= flag::RANGE;
        }
        Projected { x: short_x, y: short_y, z, flags }
    }

    /// Whether a vertex lies before the near plane (or has no positive w at all).
    #[inline(always)]
    fn is_behind_near(&self, z: i32, w: i32) -> bool {
        // z is 0 where depth comes from w.
        w < self.depth.w_min || z > w && z.wrapping_sub(w) > near_slack(w)
    }

    /// The screen position of a vertex in view of the near plane, as a corner for the rasterizer:
    /// the same bits as [`project`](Self::project) gives, also beyond what 12.4 holds.
    pub(crate) fn corner(&self, clip: &Clip) -> ScreenVertex {
        // Rounding may leave a corner that was cut at w = 1 at 0.
        let (x, y, z) = self.screen(&Clip { w: clip.w.max(1), ..*clip });
        let limit = |v: i32| v.clamp(-GUARD_BITS, GUARD_BITS);
        ScreenVertex::from_bits(
            self.center_x.wrapping_add(limit(x)),
            self.center_y.wrapping_add(limit(y)),
            z,
        )
    }

    /// Where a point lies, however far beside the viewport; `None` if it is not between the near
    /// and the far plane.
    pub(super) fn point(&self, clip: &Clip) -> Option<ScreenVertex> {
        /// Far beyond any point's extent, and nothing overflows.
        const FARTHEST: i32 = 1 << 20;
        if self.is_behind_near(clip.z, clip.w) || clip.z < self.depth.z_min {
            return None;
        }
        let (x, y, z) = self.screen(clip);
        let limit = |v: i32| v.clamp(-FARTHEST, FARTHEST);
        Some(ScreenVertex::from_bits(
            self.center_x.wrapping_add(limit(x)),
            self.center_y.wrapping_add(limit(y)),
            z,
        ))
    }

    /// A projected vertex as a corner for the rasterizer.
    #[inline(always)]
    pub(crate) fn place(&self, vertex: &Projected) -> ScreenVertex {
        ScreenVertex::from_bits(
            self.center_x.wrapping_add(vertex.x.into()),
            self.center_y.wrapping_add(vertex.y.into()),
            vertex.z,
        )
    }

    /// x and y in subpixels from the viewport's centre, and the depth code. w must be above zero.
    #[inline(never)]
    fn screen(&self, clip: &Clip) -> (i32, i32, u16) {
        let over_w = reciprocal_of_some(clip.w as u32);
        let x = self.half_width.times(clip.x, over_w);
        let y = self.half_height.times(clip.y, over_w);
        (x, y.wrapping_neg(), self.code(clip, over_w))
    }

    /// The depth code 2 + 65531 z / w, rounded to nearest.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited just before")]
    fn code(&self, clip: &Clip, over_w: Reciprocal) -> u16 {
        let Depth { numerator, shift, .. } = self.depth;
        let twice = if numerator != 0 {
            // Below 2^30: 31 is far enough.
            let down = shift.wrapping_add(over_w.shift).wrapping_sub(33).min(31);
            mul_high_31(numerator, over_w.mantissa) >> down
        } else {
            // z / w as 2.28, times 65531 as 13 more bits. w has room for 60 - shift.
            let z = clip.z.min(clip.w).max(0) as u32;
            let ratio =
                mul_high_31(z.wrapping_shl(60_u32.wrapping_sub(over_w.shift)), over_w.mantissa);
            mul_high_31(ratio << 3, DEPTHS << 14) >> 12
        };
        (twice.wrapping_add(1) >> 1).wrapping_add(2).min(65535) as u16
    }
}

/// How far z may exceed w by the rounding of the matrix before a vertex counts as before the near
/// plane: two rows' worth of half a unit at positions of 32768, but never more than 1/64 of w.
#[inline(always)]
pub(super) fn near_slack(w: i32) -> i32 {
    (w >> 6).min(6 * 16384)
}
