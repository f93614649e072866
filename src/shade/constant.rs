use super::{Stepped, Varying};
use crate::raster::{Gradients, Span};

/// A value of any kind that is the same for the whole triangle: the provoking corner's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Constant<T>(pub T);

impl<T: Copy + Default> Stepped for Constant<T> {
    type Step = ();

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, (): &()) {}

    #[inline(always)]
    fn jump(&mut self, (): &(), _pixels: i32) {}
}

impl<T: Copy + Default> Varying for Constant<T> {
    type Corner = T;
    type Planes = T;
    type Runs = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(_: &Gradients, _: &[T; 3], provoking: &T, _in_pieces: bool) -> T {
        *provoking
    }

    #[inline(always)]
    fn runs(_: &T, _: &Span) {}

    #[inline(always)]
    fn run(value: &T, (): &mut (), _: &Span, _x: i32) -> (Self, (), i32) {
        (Self(*value), (), i32::MAX)
    }

    #[inline(always)]
    fn settle(_: &mut T, _x: i32, _y: i32) {}

    #[inline(always)]
    fn mix([a, ..]: [&T; 3], _u: i32, _v: i32) -> T {
        *a
    }
}
