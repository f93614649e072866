use super::varying::mix_word;
use super::{Interpolated, Stepped, Varying};
use crate::raster::{Gradients, Plane, PointSquare, Span};

/// A 16-bit number over the triangle, 16.16 while it is interpolated: heights, weights, distances.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scalar(pub(crate) u32);

impl Scalar {
    /// The number at this pixel, rounded to nearest.
    #[inline(always)]
    pub const fn get(self) -> u16 {
        (self.0 >> 16) as u16
    }
}

impl Stepped for Scalar {
    type Step = u32;

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, step: &u32) {
        self.0 = self.0.wrapping_add(*step);
    }

    #[inline(always)]
    fn jump(&mut self, step: &u32, pixels: i32) {
        self.0 = self.0.wrapping_add(step.wrapping_mul(pixels.cast_unsigned()));
    }
}

impl Varying for Scalar {
    type Corner = u16;
    type Planes = Plane;
    type Runs = ();

    const INTERPOLATED: bool = true;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(gradients: &Gradients, [a, b, c]: &[u16; 3], _: &u16, _: bool) -> Plane {
        let mut plane = gradients.plane(*a, *b, *c);
        plane.origin = plane.origin.wrapping_add(0x8000);
        plane
    }

    #[inline(always)]
    fn runs(_: &Plane, _: &Span) {}

    #[inline(always)]
    fn run(plane: &Plane, (): &mut (), span: &Span, x: i32) -> (Self, u32, i32) {
        (Self(plane.at(x, span.y)), plane.dx, i32::MAX)
    }

    #[inline(always)]
    fn on_point(corner: &u16, _: &PointSquare, _x: i32, _y: i32) -> (Self, u32) {
        (Self(u32::from(*corner) << 16 | 0x8000), 0)
    }

    #[inline(always)]
    fn settle(_: &mut Plane, _x: i32, _y: i32) {}

    #[inline(always)]
    fn mix([a, b, c]: [&u16; 3], u: i32, v: i32) -> u16 {
        mix_word((*a).into(), (*b).into(), (*c).into(), u, v).clamp(0, 65535) as u16
    }
}

impl Interpolated for Scalar {
    type Words = [u32; 1];
    type Base = ();

    #[inline(always)]
    fn words(corners: &[u16; 3]) -> ([[u32; 1]; 3], ()) {
        (corners.map(|corner| [corner.into()]), ())
    }

    #[inline(always)]
    fn value((): &(), [word]: [u32; 1]) -> Self {
        Self((word << 1).wrapping_add(0x8000))
    }

    #[inline(always)]
    fn step_of((): &(), [right]: [u32; 1], _down: [u32; 1]) -> u32 {
        right << 1
    }
}
