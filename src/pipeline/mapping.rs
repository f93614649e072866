use super::projected::{flag, Projected};
use super::transform::Depth;
use super::Clip;
use crate::frame::Rect;
use crate::math::{mul_high_31, mul_high_signed, reciprocal, Reciprocal};
use crate::raster::{ScreenVertex, GUARD, SUBPIXELS};

/// Half a side of the viewport in subpixels, normalised: side = mantissa 2^-shift.
#[derive(Clone, Copy, Debug)]
struct HalfSide {
    mantissa: u32,
    shift: u32,
}

impl HalfSide {
    fn new(pixels: u32) -> Self {
        let subpixels = pixels.wrapping_mul(8).max(1);
        let shift = subpixels.leading_zeros().saturating_sub(1);
        Self { mantissa: subpixels << shift, shift }
    }
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
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) depth: Depth,
}

/// How far from the viewport's centre a corner may lie, in subpixels.
const GUARD_BITS: i32 = GUARD * SUBPIXELS;

/// Depth codes from the far end to the near plane.
const DEPTHS: u32 = 65_531;

const _: () = assert!((Clip::LIMIT as u32 - 1).leading_zeros() >= 2, "a shift by w's room");
const _: () = assert!((DEPTHS as u64) << 14 < 1 << 31, "a factor of a high product");
const _: () = assert!(2 + DEPTHS <= u16::MAX as u32, "depth codes");

impl Mapping {
    #[allow(
        clippy::cast_possible_wrap,
        reason = "in range by shifts and clamps, or compared with the original"
    )]
    pub(crate) fn new(viewport: Rect, depth: Depth) -> Self {
        let (width, height) = (viewport.width(), viewport.height());
        // Sides are at most 8192 pixels, so that nothing here can overflow.
        let center = |from: i32, side: u32| from.wrapping_mul(16).wrapping_add(side as i32 * 8);
        Self {
            half_width: HalfSide::new(width),
            half_height: HalfSide::new(height),
            center_x: center(viewport.left, width),
            center_y: center(viewport.top, height),
            width,
            height,
            depth,
        }
    }

    /// Projects a vertex and says on which sides of the view it lies.
    ///
    /// # Cost
    /// One reciprocal and five high products: about 75 instructions on Cortex-M4.
    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        reason = "in range by shifts and clamps, or compared with the original"
    )]
    pub(crate) fn project(&self, clip: &Clip) -> Projected {
        let Clip { x, y, z, w } = *clip;
        let mut flags = 0;
        if x < w.wrapping_neg() {
            flags |= flag::LEFT;
        }
        if x > w {
            flags |= flag::RIGHT;
        }
        if y > w {
            flags |= flag::ABOVE;
        }
        if y < w.wrapping_neg() {
            flags |= flag::BELOW;
        }
        if !self.is_behind_near(z, w) {
            if matches!(self.depth, Depth::Row { far: true }) && z < 0 {
                flags |= flag::FAR;
            }
            let (x, y, z) = self.screen(clip);
            let (short_x, short_y) = (x as i16, y as i16);
            if i32::from(short_x) != x || i32::from(short_y) != y {
                flags |= flag::RANGE;
            }
            return Projected { x: short_x, y: short_y, z, flags };
        }
        Projected { x: 0, y: 0, z: 0, flags: flags | flag::NEAR }
    }

    /// Whether a vertex lies before the near plane (or has no positive w at all).
    #[inline(always)]
    fn is_behind_near(&self, z: i32, w: i32) -> bool {
        match self.depth {
            Depth::Near { w_min, .. } => w < w_min,
            Depth::Row { .. } => w < 1 || z.wrapping_sub(w) > near_slack(w),
        }
    }

    /// The screen position of a vertex in view of the near plane, as a corner for the rasterizer:
    /// the same bits as [`project`](Self::project) gives, also beyond what 12.4 holds.
    pub(crate) fn corner(&self, clip: &Clip) -> ScreenVertex {
        let (x, y, z) = self.screen(clip);
        let limit = |v: i32| v.clamp(-GUARD_BITS, GUARD_BITS);
        ScreenVertex::from_bits(
            self.center_x.wrapping_add(limit(x)),
            self.center_y.wrapping_add(limit(y)),
            z,
        )
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

    /// x and y in subpixels from the viewport's centre, and the depth code.
    #[inline(never)]
    fn screen(&self, clip: &Clip) -> (i32, i32, u16) {
        let w = clip.w.max(1) as u32;
        let Reciprocal { mantissa, .. } = reciprocal(w);
        // 1 / w = mantissa 2^-(60 - room); w < 2^30, so that there is room above it.
        let room = w.leading_zeros().wrapping_sub(2);
        let x = scaled(clip.x, mantissa, self.half_width, room);
        let y = scaled(clip.y, mantissa, self.half_height, room);
        (x, y.wrapping_neg(), self.code(clip, mantissa, room))
    }

    /// The depth code 2 + 65531 z / w, rounded to nearest.
    #[inline(always)]
    #[allow(
        clippy::cast_possible_wrap,
        reason = "in range by shifts and clamps, or compared with the original"
    )]
    fn code(&self, clip: &Clip, mantissa: u32, room: u32) -> u16 {
        let above_two = match self.depth {
            Depth::Near { numerator, shift, .. } => {
                let down = 28_i32.wrapping_add(shift).wrapping_sub(room as i32).clamp(1, 31);
                let quotient = mul_high_31(numerator, mantissa);
                quotient.wrapping_add(1 << (down - 1)) >> down
            }
            Depth::Row { .. } => {
                // z / w as 2.28, times 65531 as 13 more bits.
                let z = clip.z.clamp(0, clip.w.max(1)) as u32;
                let ratio = mul_high_31(z << room, mantissa);
                mul_high_31(ratio << 3, DEPTHS << 14).wrapping_add(1 << 12) >> 13
            }
        };
        above_two.wrapping_add(2).min(65535) as u16
    }
}

/// How far z may exceed w by the rounding of the matrix before a vertex counts as before the near
/// plane: two rows' worth of half a unit at positions of 32768, but never more than 1/64 of w.
#[inline(always)]
pub(super) fn near_slack(w: i32) -> i32 {
    (w >> 6).min(6 * 16384)
}

/// v x half / w in subpixels, rounded to nearest; saturates far beyond the guard box.
#[inline(always)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "in range by shifts and clamps, or compared with the original"
)]
fn scaled(v: i32, mantissa: u32, half: HalfSide, room: u32) -> i32 {
    let factor = mul_high_31(mantissa, half.mantissa);
    let down = 28_u32.wrapping_add(half.shift).wrapping_sub(room);
    if down > 32 {
        let high = mul_high_signed(v, factor);
        let down = (down - 32) & 31;
        return high.wrapping_add(1 << ((down - 1) & 31)) >> down;
    }
    let product = i64::from(v).wrapping_mul(factor.into());
    let rounded = product.wrapping_add(1 << (down.wrapping_sub(1) & 63)) >> (down & 63);
    rounded.clamp(-(1 << 24), 1 << 24) as i32
}
