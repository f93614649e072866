use core::ops::Deref;

use super::planes::mix;
use super::{PerspectiveCorner, PerspectiveMode, PerspectiveVarying};
use crate::raster::{Gradients, Span};
use crate::shade::{Corner, Interpolated, Stepped, Varying};

/// No perspective: linear on the screen. The cheapest, and wrong wherever w differs much over a
/// triangle.
///
/// # Measured
/// <!-- tradeoff: plane-10/perspective=affine -->
/// `affine` in the scene `plane-10`: 27.1 (M4F), 42.0 (M0+), 21.3 (RV32) instructions a pixel; 294 texels off, 465 at most; PSNR 6.9 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Affine;

/// A varying that is linear on the screen, with the corners of one in perspective.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AffineValue<V>(V);

impl PerspectiveMode for Affine {
    type Of<V: Interpolated> = AffineValue<V>;
}

impl<V> Deref for AffineValue<V> {
    type Target = V;

    #[inline(always)]
    fn deref(&self) -> &V {
        &self.0
    }
}

impl<V: Interpolated> PerspectiveVarying for AffineValue<V> {
    type Inner = V;

    const LINEAR: bool = true;

    #[inline(always)]
    fn inner_step(step: &V::Step) -> &V::Step {
        step
    }
}

impl<V: Stepped> Stepped for AffineValue<V> {
    type Step = V::Step;

    const JUMPS: bool = V::JUMPS;

    #[inline(always)]
    fn step(&mut self, step: &V::Step) {
        self.0.step(step);
    }

    #[inline(always)]
    fn jump(&mut self, step: &V::Step, pixels: i32) {
        self.0.jump(step, pixels);
    }
}

impl<V: Interpolated> Varying for AffineValue<V> {
    type Corner = PerspectiveCorner<Corner<V>>;
    type Planes = V::Planes;
    type Runs = V::Runs;

    const INTERPOLATED: bool = V::INTERPOLATED;
    const PIECE: i32 = V::PIECE;
    const IN_RUNS: bool = V::IN_RUNS;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        provoking: &Self::Corner,
        in_pieces: bool,
    ) -> V::Planes {
        let values = corners.map(|corner| corner.value);
        V::planes(gradients, &values, &provoking.value, in_pieces)
    }

    #[inline(always)]
    fn runs(planes: &V::Planes, span: &Span) -> V::Runs {
        V::runs(planes, span)
    }

    #[inline(always)]
    fn run(planes: &V::Planes, runs: &mut V::Runs, span: &Span, x: i32) -> (Self, V::Step, i32) {
        let (value, step, end) = V::run(planes, runs, span, x);
        (Self(value), step, end)
    }

    #[inline(always)]
    fn settle(planes: &mut V::Planes, x: i32, y: i32) {
        V::settle(planes, x, y);
    }

    #[inline(always)]
    fn mix(corners: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner {
        mix::<V>(corners, u, v)
    }
}
