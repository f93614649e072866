use core::marker::PhantomData;
use core::ops::Deref;

use super::planes::mix;
use super::{PerspectiveCorner, PerspectiveMode, PerspectivePlanes, PerspectiveVarying};
use crate::math::{mul_high_signed, reciprocal_of_some, Reciprocal};
use crate::raster::{Gradients, Plane, Span};
use crate::shade::{Corner, Interpolated, Stepped, Varying, Words};

/// Knots at every `N`th column of the picture (a power of two from 4 to 32), linear between.
///
/// # Measured
/// <!-- tradeoff: plane-10/perspective=every-16 -->
/// `every-16` in the scene `plane-10`: 39.1 (M4F), 70.4 (M0+), 36.2 (RV32) instructions a pixel; 1.33 texels off, 41.1 at most; PSNR 15.3 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Every<const N: i32>;

/// Knots as near as they have to be: `2^k` columns apart, such that the error stays below a quarter
/// of what a pixel covers.
///
/// `N` is the largest power of two up to 128 (512 for texture coordinates alone) with `N^2 |dq| <= q` in the whole row, where q is 1 / w
/// and dq what it changes by from pixel to pixel: floors and walls that run across the view need few
/// knots. Where that is less than 16, it is chosen anew for each 16 columns of the picture.
///
/// # Measured
/// <!-- tradeoff: plane-10/perspective=adaptive -->
/// `adaptive` in the scene `plane-10`: 55.1 (M4F), 102 (M0+), 53.1 (RV32) instructions a pixel; 0.16 texels off, 4.13 at most; PSNR 22.1 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Adaptive;

/// How far knots are apart.
pub trait Interval: Copy {
    /// The power of two, at most `longest`, in the columns from `from` to `to` of row `y`.
    fn exponent(q: &Plane, y: i32, from: i32, to: i32, longest: u32) -> u32;
    /// The least that a whole row may have; below it is chosen for each cell of so many columns.
    const CELL: u32;
}

impl<const N: i32> Interval for Every<N> {
    const CELL: u32 = {
        assert!(4 <= N && N <= 32 && N.count_ones() == 1, "a power of two from 4 to 32");
        N.trailing_zeros()
    };

    #[inline(always)]
    fn exponent(_: &Plane, _y: i32, _from: i32, _to: i32, _longest: u32) -> u32 {
        Self::CELL
    }
}

impl Interval for Adaptive {
    const CELL: u32 = 4;

    #[inline(always)]
    fn exponent(q: &Plane, y: i32, from: i32, to: i32, longest: u32) -> u32 {
        let least = q.at(from, y).min(q.at(to, y));
        let change = q.dx.cast_signed().unsigned_abs();
        let mut exponent = longest;
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

/// A run of a row, from one knot to the next.
#[derive(Clone, Copy, Debug)]
pub struct Subspan<W> {
    /// The knots' columns and words.
    start: i32,
    knot: i32,
    from: W,
    to: W,
    /// The first pixel behind the run.
    end: i32,
    /// Whether knots lie as far apart in the whole row.
    is_even: bool,
    exponent: u32,
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

    const LINEAR: bool = true;

    #[inline(always)]
    fn inner_step(step: &V::Step) -> &V::Step {
        step
    }
}

impl<V: Stepped, I: Interval> Stepped for SubspanValue<V, I> {
    type Step = V::Step;

    const JUMPS: bool = V::JUMPS;

    #[inline(always)]
    fn step(&mut self, step: &V::Step) {
        self.value.step(step);
    }

    #[inline(always)]
    fn jump(&mut self, step: &V::Step, pixels: i32) {
        self.value.jump(step, pixels);
    }
}

/// The knot behind column `x`, and the first pixel behind the run to it.
#[inline(always)]
fn knot_behind(column: i32, exponent: u32, span: &Span) -> (i32, i32) {
    let next = column.wrapping_add(1 << exponent);
    if span.behind <= next {
        (span.behind.wrapping_sub(1), span.behind)
    } else {
        (next, next)
    }
}

impl<V: Interpolated, I: Interval> Varying for SubspanValue<V, I> {
    type Corner = PerspectiveCorner<Corner<V>>;
    type Planes = PerspectivePlanes<V>;
    type Runs = Subspan<V::Words>;

    const INTERPOLATED: bool = true;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = true;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        _: &Self::Corner,
        _in_pieces: bool,
    ) -> PerspectivePlanes<V> {
        PerspectivePlanes::new(gradients, corners)
    }

    #[inline(always)]
    fn runs(planes: &PerspectivePlanes<V>, span: &Span) -> Subspan<V::Words> {
        let Span { y, first, left, behind, .. } = *span;
        let row = I::exponent(&planes.q, y, first, behind.wrapping_sub(1), V::LONGEST);
        let is_even = row >= I::CELL;
        // The knot at or before the first pixel that is drawn.
        let exponent = if is_even { row } else { cell_exponent::<I>(&planes.q, span, left) };
        let start = (left >> exponent << exponent).max(first);
        let words = planes.at(start, y);
        Subspan { start, knot: start, from: words, to: words, end: left, is_even, exponent }
    }

    #[inline(always)]
    fn run(
        planes: &PerspectivePlanes<V>,
        runs: &mut Subspan<V::Words>,
        span: &Span,
        x: i32,
    ) -> (Self, V::Step, i32) {
        // Otherwise pictures would be wrong without a word.
        const { assert!(V::JUMPS, "what is interpolated in perspective jumps") };
        let y = span.y;
        if x >= runs.end {
            if !runs.is_even && x & ((1 << I::CELL) - 1) == 0 {
                runs.exponent = cell_exponent::<I>(&planes.q, span, x);
            }
            let exponent = runs.exponent;
            (runs.start, runs.from) = (runs.knot, runs.to);
            (runs.knot, runs.end) = knot_behind(x >> exponent << exponent, exponent, span);
            runs.to = planes.at(runs.knot, y);
        }
        let Subspan { start, knot, from, to, end, exponent, .. } = *runs;
        let length = knot.wrapping_sub(start);
        let change = to.zip(from, u32::wrapping_sub);
        let right = if length == 1 << exponent {
            change.map(|change| change.cast_signed().wrapping_shr(exponent).cast_unsigned())
        } else {
            short_steps(change, length)
        };
        let base = &planes.base;
        let step = V::step_of(base, right, planes.down(from, start, y));
        let mut value = V::value(base, from);
        value.jump(&step, x.wrapping_sub(start));
        (Self { value, interval: PhantomData }, step, end)
    }

    #[inline(always)]
    fn settle(_: &mut PerspectivePlanes<V>, _x: i32, _y: i32) {}

    #[inline(always)]
    fn place(corner: &mut Self::Corner, w: impl Fn() -> i32) {
        corner.w = w();
    }

    #[inline(always)]
    fn mix(corners: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner {
        mix::<V>(corners, u, v)
    }
}

/// The power of two in the cell that holds column `x`.
#[inline(never)]
fn cell_exponent<I: Interval>(q: &Plane, span: &Span, x: i32) -> u32 {
    let cell = x >> I::CELL << I::CELL;
    let (next, last) = (cell.wrapping_add(1 << I::CELL), span.behind.wrapping_sub(1));
    I::exponent(q, span.y, cell.max(span.first), next.min(last), I::CELL)
}

/// Steps of a run that is shorter than knots are apart.
#[inline(always)]
fn short_steps<W: Words>(change: W, length: i32) -> W {
    if length < 2 {
        return change;
    }
    let Reciprocal { mantissa, shift } = reciprocal_of_some(length.cast_unsigned());
    change.map(|change| {
        let step = mul_high_signed(change.cast_signed(), mantissa);
        // The length is below 2^10, so that 32 of the shift's at most 62 are not too many.
        step.wrapping_shr(shift.wrapping_sub(32)).cast_unsigned()
    })
}
