use super::projected::{flag, Projected, RAISED};
use super::transform::Depth;
use super::Clip;
use crate::frame::Size;
use crate::math::{
    half_factor, inlined_reciprocal_of_some, mul_high_30, mul_high_both_31, mul_high_positive,
    mul_high_signed, rare, reciprocal_of_some, Reciprocal, HALVES_MULTIPLY,
};
use crate::raster::{ScreenVertex, GUARD, SUBPIXELS};

/// Half a side of the viewport in subpixels, normalised for products with reciprocals.
#[derive(Clone, Copy, Debug)]
struct HalfSide {
    /// In 2^30..2^31, as [`half_factor`] has it.
    mantissa: i32,
    /// v / w x half is twice the upper word of v x (the upper word of both mantissas), shifted right
    /// by this less the leading zeros of w.
    down: u32,
}

impl HalfSide {
    #[allow(clippy::cast_possible_wrap, reason = "a bit is left above")]
    const fn new(pixels: u16) -> Self {
        // Half of 16 to the pixel.
        let subpixels = pixels as u32 * 8;
        let room = subpixels.leading_zeros();
        let mantissa = subpixels.wrapping_shl(room) >> 1;
        Self { mantissa: half_factor(mantissa as i32), down: room.wrapping_sub(4) }
    }

    /// Twice v / w x half a side in subpixels, rounded down; saturates far beyond the guard box.
    #[inline(never)]
    #[allow(clippy::cast_possible_wrap, reason = "mantissas are below 2^31")]
    fn twice(self, v: i32, over_w: Reciprocal) -> i32 {
        let down = self.down.wrapping_sub(zeros(over_w));
        if down < 32 {
            return self.twice_easy(v, over_w);
        }
        let factor = mul_high_positive(over_w.mantissa as i32, self.mantissa);
        mul_high_signed(raised(v, down.wrapping_neg()), factor as u32)
    }

    /// The same for a w of at least [`least_w`](Self::least_w).
    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, reason = "mantissas are below 2^31")]
    fn twice_easy(self, v: i32, over_w: Reciprocal) -> i32 {
        let factor = mul_high_positive(over_w.mantissa as i32, self.mantissa);
        mul_high_30(v, factor as u32) >> (self.down.wrapping_sub(zeros(over_w)) & 31)
    }

    /// The smallest w that has no more leading zeros than [`down`](Self::down).
    const fn least_w(self) -> i32 {
        1 << (31_u32.wrapping_sub(self.down) & 31)
    }
}

/// The leading zeros of a w.
#[inline(always)]
const fn zeros(over_w: Reciprocal) -> u32 {
    62_u32.wrapping_sub(over_w.shift)
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
    /// The same less [`RAISED`].
    raised_x: i32,
    raised_y: i32,
    /// The viewport's size in pixels.
    size: Size,
    pub(super) depth: Depth,
    /// From this w on a vertex between the sides of the view is projected without a question; no
    /// such w where depth comes from z.
    easy_w: i32,
    /// The same where depth comes from z, if that is in the view too.
    easy_w_by_z: i32,
    /// What every vertex has: [`LARGE`](flag::LARGE) or nothing.
    flags: u32,
}

/// How far from the viewport's centre a corner may lie, in subpixels.
const GUARD_BITS: i32 = GUARD * SUBPIXELS;

/// Depth codes from the far end to the near plane.
const DEPTHS: u32 = 65_531;

const _: () = assert!((Clip::LIMIT as u32 - 1).leading_zeros() >= 2, "a shift by w's room");
const _: () = assert!((DEPTHS as u64) << 14 < 1 << 31, "a factor of a high product");
const _: () = assert!(2 + DEPTHS <= u16::MAX as u32, "depth codes");

/// The pixels of the largest viewport in which twice the area of any triangle has 31 bits, and the
/// longest side whose half 12.4 holds; both with room for rounding.
const SMALL_AREA: u32 = 1 << 22;
const SMALL_SIDE: u16 = 4094;

const _: () = assert!(SMALL_AREA as i64 * 256 + 4096 * 64 < i32::MAX as i64, "areas");
const _: () = assert!(SMALL_SIDE as i32 * 8 < i16::MAX as i32, "coordinates");

impl Mapping {
    /// The mapping to a viewport of this size whose upper left corner is the pixel (`left`, `top`).
    pub(super) fn new(left: i32, top: i32, size: Size, depth: Depth) -> Self {
        // Sides are at most 8192 pixels, so that nothing here can overflow.
        let center = |from: i32, side: u16| from.wrapping_mul(16).wrapping_add(i32::from(side) * 8);
        let Size { width, height } = size;
        let half_width = HalfSide::new(width);
        let half_height = HalfSide::new(height);
        let is_large = u32::from(width).wrapping_mul(height.into()) > SMALL_AREA
            || width.max(height) > SMALL_SIDE;
        let easy_w = half_width.least_w().max(half_height.least_w()).max(depth.easy_w);
        let only_if = |is_easy: bool| if is_easy && !is_large { easy_w } else { i32::MAX };
        Self {
            half_width,
            half_height,
            center_x: center(left, width),
            center_y: center(top, height),
            raised_x: center(left, width).wrapping_sub(RAISED),
            raised_y: center(top, height).wrapping_sub(RAISED),
            size,
            depth,
            easy_w: only_if(!depth.is_row()),
            easy_w_by_z: only_if(depth.is_row()),
            flags: if is_large { flag::LARGE } else { 0 },
        }
    }

    /// The viewport's size in pixels.
    pub(super) const fn size(&self) -> Size {
        self.size
    }

    /// The least w from which on vertices are projected without a question, as far as w goes.
    pub(super) fn least_easy_w(&self) -> i32 {
        self.easy_w.min(self.easy_w_by_z)
    }

    /// Projects a vertex and says on which sides of the view it lies.
    ///
    /// What lies in the view is projected in place; all else by [`project_any`](Self::project_any),
    /// which gives the same. z is asked for where depth comes from it, and nowhere else.
    ///
    /// # Cost
    /// One reciprocal and five high products: about 60 instructions on Cortex-M4 in the view.
    #[inline(always)]
    pub(super) fn project(&self, [x, y, w]: [i32; 3], z: impl Fn() -> i32) -> Projected {
        if is_hard(x, y, w, self.easy_w) {
            return if self.depth.is_row() {
                self.project_by_z(&Clip { x, y, z: z(), w })
            } else {
                self.project_any(&Clip { x, y, z: 0, w })
            };
        }
        let over_w = inlined_reciprocal_of_some(w as u32);
        self.in_view(x, y, over_w, self.code_of_w(over_w))
    }

    /// The same of any vertex whose depth comes from z.
    #[inline(never)]
    fn project_by_z(&self, clip: &Clip) -> Projected {
        let Clip { x, y, z, w } = *clip;
        if is_hard(x, y, w, self.easy_w_by_z) || z > w || z < self.depth.z_min {
            return self.project_any(clip);
        }
        let over_w = reciprocal_of_some(w as u32);
        self.in_view(x, y, over_w, rounded_code(twice_ratio(z, over_w)))
    }

    /// A vertex in the view.
    #[inline(always)]
    fn in_view(&self, x: i32, y: i32, over_w: Reciprocal, code: u32) -> Projected {
        let (x, y) = self.easy_place(x, y, over_w);
        Projected::in_view(x, y, code)
    }

    /// The place on the screen of a vertex whose w is at least [`easy_w`](Self::easy_w).
    #[inline(always)]
    fn easy_place(&self, x: i32, y: i32, over_w: Reciprocal) -> (i32, i32) {
        let x = self.half_width.twice_easy(x, over_w).wrapping_add(1) >> 1;
        let y = self.half_height.twice_easy(y, over_w).wrapping_neg() >> 1;
        (x, y)
    }

    /// Projects any vertex as [`project`](Self::project) does.
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation, reason = "compared with the original")]
    pub(super) fn project_any(&self, clip: &Clip) -> Projected {
        let Clip { x, y, z, w } = *clip;
        // Coordinates are below 2^30: a sum's sign bit is right.
        let outside = |margin: i32, flag: u32| if margin < 0 { flag } else { 0 };
        let mut flags = self.flags
            | outside(w.wrapping_add(x), flag::LEFT)
            | outside(w.wrapping_sub(x), flag::RIGHT)
            | outside(w.wrapping_sub(y), flag::ABOVE)
            | outside(w.wrapping_add(y), flag::BELOW);
        if self.is_behind_near(z, w) {
            return Projected::new(0, 0, 0, flags | flag::NEAR);
        }
        if z < self.depth.z_min {
            flags |= flag::FAR;
        }
        let (x, y, z) = self.screen(clip);
        if i32::from(x as i16) != x || i32::from(y as i16) != y {
            flags |= flag::RANGE;
        }
        Projected::new(x, y, z, flags)
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

    /// Where a point lies, however far beside the viewport; `None` if it is not between the near and
    /// the far plane.
    #[cold]
    #[inline(never)]
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

    /// From this w on [`inlined_point`](Self::inlined_point) asks no question; above zero, as the
    /// compiler sees where this is not a loop's: then a shift by leading zeros needs no mask.
    #[inline(always)]
    pub(super) fn easy_w(&self) -> i32 {
        self.easy_w.max(1)
    }

    /// The same as [`point`](Self::point), in place where no question is left.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "a code has 16 bits")]
    pub(super) fn inlined_point(
        &self,
        [x, y, w]: [i32; 3],
        z: impl Fn() -> i32,
        easy_w: i32,
    ) -> Option<ScreenVertex> {
        if w < easy_w {
            let z = if self.depth.is_row() { z() } else { 0 };
            return self.point(&Clip { x, y, z, w });
        }
        // Below 2^27, far beyond any point's extent too.
        let over_w = inlined_reciprocal_of_some(w as u32);
        let (x, y) = self.easy_place(x, y, over_w);
        let (x, y) = (self.center_x.wrapping_add(x), self.center_y.wrapping_add(y));
        Some(ScreenVertex::from_bits(x, y, self.code_of_w(over_w) as u16))
    }

    /// A projected vertex as a corner for the rasterizer.
    #[inline(always)]
    pub(crate) fn place(&self, vertex: &Projected) -> ScreenVertex {
        // Words of both would be made before, for products that do not ask for them.
        let (x, y) = if HALVES_MULTIPLY {
            let (x, y) = vertex.raised();
            (self.raised_x.wrapping_add(x), self.raised_y.wrapping_add(y))
        } else {
            (self.center_x.wrapping_add(vertex.x()), self.center_y.wrapping_add(vertex.y()))
        };
        ScreenVertex::from_bits(x, y, vertex.z())
    }

    /// x and y in subpixels from the viewport's centre, and the depth code. w must be above zero.
    #[inline(never)]
    fn screen(&self, clip: &Clip) -> (i32, i32, u16) {
        let over_w = reciprocal_of_some(clip.w as u32);
        let x = self.half_width.twice(clip.x, over_w).wrapping_add(1) >> 1;
        // Minus the nearest.
        let y = self.half_height.twice(clip.y, over_w).wrapping_neg() >> 1;
        (x, y, self.code(clip, over_w))
    }

    /// The depth code 2 + 65531 z / w, rounded to nearest.
    #[inline(always)]
    fn code(&self, clip: &Clip, over_w: Reciprocal) -> u16 {
        let Depth { numerator, shift, .. } = self.depth;
        let twice = if numerator != 0 {
            // Below 2^30: 31 is far enough.
            let down = shift.wrapping_sub(zeros(over_w)).min(31);
            mul_high_both_31(numerator, over_w.mantissa) >> down
        } else {
            twice_ratio(clip.z.min(clip.w), over_w)
        };
        rounded_code(twice).min(65535) as u16
    }

    /// The same of a w of at least [`easy_w`](Self::easy_w).
    #[inline(always)]
    fn code_of_w(&self, over_w: Reciprocal) -> u32 {
        let Depth { numerator, shift, .. } = self.depth;
        let down = shift.wrapping_sub(zeros(over_w));
        rounded_code(mul_high_both_31(numerator, over_w.mantissa) >> (down & 31))
    }
}

/// Whether a vertex does not lie between the sides of the view, or at a w below `easy_w`.
#[inline(always)]
fn is_hard(x: i32, y: i32, w: i32, easy_w: i32) -> bool {
    // Coordinates are below 2^30: a sum that is below zero is above all others without its sign.
    let is_beside = |v: i32| w.wrapping_add(v).cast_unsigned() > w.cast_unsigned() << 1;
    if w < easy_w || is_beside(x) || is_beside(y) {
        rare();
        return true;
    }
    false
}

/// The depth code of twice 65531 z / w, rounded to nearest.
#[inline(always)]
const fn rounded_code(twice: u32) -> u32 {
    // Half of one more, and 2.
    twice.wrapping_add(5) >> 1
}

/// Twice 65531 z / w for a z that is at most w; 0 where it is negative.
#[inline(always)]
fn twice_ratio(z: i32, over_w: Reciprocal) -> u32 {
    // z / w as 2.28, times 65531 as 13 more bits. w has room for 60 - shift.
    let up = 60_u32.wrapping_sub(over_w.shift);
    let ratio = mul_high_both_31((z.max(0) as u32).wrapping_shl(up), over_w.mantissa);
    // At most 2^31, with a factor of 30 bits.
    mul_high_both_31(ratio << 3, DEPTHS << 14) >> 12
}

/// How far z may exceed w by the rounding of the matrix before a vertex counts as before the near
/// plane: two rows' worth of half a unit at positions of 32768, but never more than 1/64 of w.
#[inline(always)]
pub(super) fn near_slack(w: i32) -> i32 {
    (w >> 6).min(6 * 16384)
}

#[cfg(test)]
#[path = "mapping_tests.rs"]
mod tests;
