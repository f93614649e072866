//! Lines as rectangles.

use super::super::fill::{Access, Fill, Walk};
use crate::color::Format;
use crate::frame::{Frame, Rect, Supplies};
use crate::math::{inverse_sqrt, InverseSqrt};
use crate::raster::{ScreenVertex, SpanBatch, Traversal, Triangle, GUARD, SUBPIXELS};
use crate::shade::{Corner, DepthTest, Fragments, State};

// Rectangles reach as far beyond the square of corners as half the widest line, and edge values
// still leave the sign bit of an i32 alone.
const _: () = assert!(
    SUBPIXELS as i64 * (2 * (GUARD as i64 + 18)).pow(2) < 1 << 31,
    "edge values of rectangles about lines"
);

/// The rectangle about a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quad {
    /// One side of the first corner, one of the last, and the other sides of both.
    pub(super) v: [ScreenVertex; 4],
    /// From the line to the side of the first two, in subpixels.
    across: (i32, i32),
    /// Across the line, of length 2^16.
    unit: (i32, i32),
}

impl Quad {
    /// The rectangle that reaches so many subpixels to both sides; `None` of a line without length.
    ///
    /// # Rounding
    /// The way across is off by 2^-12.8 of its length, and rounded to subpixels: the same for both
    /// ends and both sides.
    #[inline(never)]
    pub(super) fn about([a, b]: &[ScreenVertex; 2], half: i32) -> Option<Self> {
        let (dx, dy) = (b.x_bits().wrapping_sub(a.x_bits()), b.y_bits().wrapping_sub(a.y_bits()));
        let longest = dx.unsigned_abs() | dy.unsigned_abs();
        if longest == 0 {
            return None;
        }
        // The longer side in 2^14..2^15: squares add up to less than 2^31.
        let room = longest.leading_zeros().cast_signed().wrapping_sub(17);
        let normal = |side: i32| {
            if room < 0 {
                side >> room.unsigned_abs()
            } else {
                side.wrapping_shl(room.unsigned_abs())
            }
        };
        let (x, y) = (normal(dx), normal(dy));
        let square = x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y));
        let InverseSqrt { mantissa, shift } = inverse_sqrt(square.unsigned_abs());
        let unit =
            |side: i32| side.wrapping_mul(mantissa.cast_signed()) >> (shift.wrapping_sub(16) & 31);
        let unit = (unit(y), unit(x).wrapping_neg());
        let scaled = |unit: i32| unit.wrapping_mul(half).wrapping_add(1 << 15) >> 16;
        let across = (scaled(unit.0), scaled(unit.1));
        let moved = |v: &ScreenVertex, sign: i32| {
            ScreenVertex::from_bits(
                v.x_bits().wrapping_add(across.0.wrapping_mul(sign)),
                v.y_bits().wrapping_add(across.1.wrapping_mul(sign)),
                v.z,
            )
        };
        Some(Self { v: [moved(a, 1), moved(b, 1), moved(b, -1), moved(a, -1)], across, unit })
    }

    /// How far its sides are from the line, in 2^-10 of a pixel: exact but for the
    /// [error of the way across](Self::about).
    pub(super) fn distance(&self) -> i32 {
        let ((x, y), (u, v)) = (self.across, self.unit);
        let subpixels = x.wrapping_mul(u).wrapping_add(y.wrapping_mul(v));
        subpixels.wrapping_add(1 << 9) >> 10
    }

    /// Draws it; whether it has pixels.
    pub(super) fn draw<H, S, F, D>(
        &self,
        corners: &[Corner<H::Varying>; 4],
        provoking: &Corner<H::Varying>,
        area: &Rect,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
    ) -> bool
    where
        H: Fragments,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let target = &mut frame.target::<Access<S>>();
        let mut is_drawn = false;
        for [i, j, k] in [[0_usize, 1, 2], [0, 2, 3]] {
            let at = |i: usize| self.v[i & 3];
            let corner = |i: usize| corners[i & 3];
            let Some(triangle) = &Triangle::oriented([at(i), at(j), at(k)]) else { continue };
            let mut walk = Walk::<S>::default();
            let mut batch = SpanBatch::made_by_stores();
            state.traversal().start(&mut walk, triangle, area, &mut batch);
            if batch.is_empty() {
                continue;
            }
            is_drawn = true;
            let (second, third) = if triangle.flipped { (k, j) } else { (j, k) };
            let corners = &[corner(i), corner(second), corner(third)];
            let fill = Fill { triangle, corners, provoking };
            if S::Depth::OFFSETS {
                fill.draw_unmoved(target, state, shader, &mut walk, &mut batch);
            } else {
                fill.draw(target, state, shader, &mut walk, &mut batch);
            }
        }
        is_drawn
    }
}
