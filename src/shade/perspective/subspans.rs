use core::marker::PhantomData;
use core::ops::Deref;

use super::planes::mix;
use super::{PerspectiveCorner, PerspectiveMode, PerspectivePlanes, PerspectiveVarying};
use crate::math::mul_high_signed;
use crate::raster::{Gradients, Plane, Span};
use crate::shade::{Corner, Interpolated, Varying, Words};

/// Knots at every `N`th column of the picture (a power of two from 4 to 32), linear between.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Every<const N: i32>;

/// Knots as near as they have to be: `2^k` columns apart, at most 16, such that the error stays
/// below a quarter of what a pixel covers.
///
/// In each 16 columns of the picture `N` is the largest power of two with `N^2 |dq| <= q`, where q
/// is 1 / w, the smaller of its two at the ends, and dq what it changes by from pixel to pixel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adaptive;

/// How far knots are apart.
pub trait Interval: Copy {
    /// The power of two in the 16 columns that hold column `x` of a span.
    fn exponent(q: &Plane, span: &Span, x: i32) -> u32;
    /// Whether that is the same everywhere.
    const FIXED: bool;
}

impl<const N: i32> Every<N> {
    const EXPONENT: u32 = {
        assert!(4 <= N && N <= 32 && N.count_ones() == 1, "a power of two from 4 to 32");
        N.trailing_zeros()
    };
}

impl<const N: i32> Interval for Every<N> {
    const FIXED: bool = true;

    #[inline(always)]
    fn exponent(_: &Plane, _: &Span, _x: i32) -> u32 {
        Self::EXPONENT
    }
}

impl Interval for Adaptive {
    const FIXED: bool = false;

    #[inline(always)]
    fn exponent(q: &Plane, span: &Span, x: i32) -> u32 {
        let cell = x & !15;
        let last = span.behind.wrapping_sub(1);
        let (from, to) = (cell.max(span.first), cell.wrapping_add(16).min(last));
        let least = q.at(from, span.y).min(q.at(to, span.y));
        let change = q.dx.cast_signed().unsigned_abs();
        let mut exponent = 4;
        while exponent > 0 && change > least >> (2 * exponent) {
            exponent -= 1;
        }
        exponent
    }
}

impl<const N: i32> PerspectiveMode for Every<N> {
    type Of<V: Interpolated> = SubspanValue<V, Self>;
}

impl PerspectiveMode for Adaptive {
    type Of<V: Interpolated> = SubspanValue<V, Self>;
}

/// A varying that is linear between knots, at which it is divided.
///
/// Knots are a row's first covered pixel before any scissor, columns of the picture, and the last
/// covered pixel: nothing is evaluated outside of the triangle, and no scissor or band changes a
/// bit.
#[derive(Clone, Copy, Debug)]
pub struct SubspanValue<V, I> {
    value: V,
    interval: PhantomData<I>,
}

/// The planes of a [`SubspanValue`], and the latest knot.
#[derive(Clone, Copy, Debug)]
pub struct SubspanPlanes<V: Interpolated> {
    planes: PerspectivePlanes<V>,
    /// Of the latest knot.
    x: i32,
    y: i32,
    words: Option<V::Words>,
    /// The first of the 16 columns of which the exponent is known, in row `y`.
    cell: i32,
    exponent: u32,
}

/// 2^31 / n for runs that end at a row's last pixel.
#[allow(clippy::cast_possible_truncation, reason = "below 2^31")]
static INVERSES: [u32; 32] = {
    let mut inverses = [0; 32];
    let mut n = 2;
    while n < 32 {
        inverses[n] = ((1_u64 << 31) / n as u64) as u32;
        n += 1;
    }
    inverses
};

impl<V: Interpolated> SubspanPlanes<V> {
    /// The words at a knot: known, if it is where the last run ended.
    #[inline(always)]
    fn knot(&self, x: i32, y: i32) -> V::Words {
        match self.words {
            Some(words) if self.x == x && self.y == y => words,
            _ => self.planes.at(x, y),
        }
    }
}

impl<V, I> Deref for SubspanValue<V, I> {
    type Target = V;

    #[inline(always)]
    fn deref(&self) -> &V {
        &self.value
    }
}

impl<V: Interpolated, I: Interval> PerspectiveVarying for SubspanValue<V, I> {
    type Inner = V;

    #[inline(always)]
    fn inner_step(step: &V::Step) -> &V::Step {
        step
    }
}

impl<V: Interpolated, I: Interval> Varying for SubspanValue<V, I> {
    type Corner = PerspectiveCorner<Corner<V>>;
    type Planes = SubspanPlanes<V>;
    type Step = V::Step;

    const INTERPOLATED: bool = true;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = true;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        _: &Self::Corner,
        _in_pieces: bool,
    ) -> SubspanPlanes<V> {
        let planes = PerspectivePlanes::new(gradients, corners);
        SubspanPlanes { planes, x: 0, y: 0, words: None, cell: i32::MIN, exponent: 0 }
    }

    #[inline(always)]
    fn run(state: &mut SubspanPlanes<V>, span: &Span, x: i32) -> (Self, V::Step, i32) {
        let (y, last) = (span.y, span.behind.wrapping_sub(1));
        let exponent = if I::FIXED {
            I::exponent(&state.planes.q, span, x)
        } else {
            if state.cell != x & !15 || state.y != y {
                state.exponent = I::exponent(&state.planes.q, span, x);
                state.cell = x & !15;
            }
            state.exponent
        };
        let column = x >> exponent << exponent;
        let (start, next) = (column.max(span.first), column.wrapping_add(1 << exponent));
        let (knot, end) = if last < next { (last, last.wrapping_add(1)) } else { (next, next) };
        let from = state.knot(start, y);
        let length = knot.wrapping_sub(start);
        let to = if length == 0 { from } else { state.planes.at(knot, y) };
        let change = to.zip(from, u32::wrapping_sub);
        let right = if length == 1 << exponent {
            change.map(|change| (change.cast_signed() >> exponent).cast_unsigned())
        } else if length < 2 {
            change
        } else {
            let inverse = INVERSES.get(length as usize).copied().unwrap_or(0);
            change.map(|change| {
                mul_high_signed(change.cast_signed(), inverse).wrapping_shl(1).cast_unsigned()
            })
        };
        (state.x, state.y, state.words) = (knot, y, Some(to));
        let base = &state.planes.base;
        let step = V::step_of(base, right, state.planes.down(from, start, y));
        let mut value = V::value(base, from);
        value.jump(&step, x.wrapping_sub(start));
        (Self { value, interval: PhantomData }, step, end)
    }

    #[inline(always)]
    fn step(&mut self, step: &V::Step) {
        self.value.step(step);
    }

    #[inline(always)]
    fn settle(_: &mut SubspanPlanes<V>, _x: i32, _y: i32) {}

    #[inline(always)]
    fn place(corner: &mut Self::Corner, w: impl Fn() -> i32) {
        corner.w = w();
    }

    #[inline(always)]
    fn mix(corners: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner {
        mix::<V>(corners, u, v)
    }
}
