use super::{Stepped, Uv, Varying};
use crate::raster::{Gradients, PointSquare, Span};

/// Where a pixel lies in the square of its point: `s` runs to the right, `t` downwards, both from
/// 0 to 1, at the pixel's centre. For round points and sprites; zero on lines and triangles.
///
/// `s = 1/2 + (xf + 1/2 - xp) / size`, as OpenGL 4.6 has it in section 14.4.
///
/// # Range
/// Below 1, with 28 fraction bits: the units of a texture coordinate of which 2^12 make the texture,
/// with 16 fraction bits.
///
/// # Rounding
/// Less than 2^-19 too small.
///
/// # Cost
/// One division for each row of the point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PointCoordinates {
    s: u32,
    t: u32,
}

impl PointCoordinates {
    /// 1 in the units of the coordinates.
    pub const ONE: i32 = 1 << 28;

    /// From the left side of the square.
    #[inline(always)]
    pub const fn s(self) -> i32 {
        self.s.cast_signed()
    }

    /// From the upper side of the square.
    #[inline(always)]
    pub const fn t(self) -> i32 {
        self.t.cast_signed()
    }

    /// From the lower side of the square: OpenGL's other origin.
    #[inline(always)]
    pub const fn t_from_below(self) -> i32 {
        Self::ONE.wrapping_sub(self.t())
    }

    /// As texture coordinates, 2^12 of which make the texture: for sprites.
    #[inline(always)]
    pub const fn uv(self) -> Uv {
        Uv { u: self.s(), v: self.t() }
    }

    /// The square of the distance to the middle, where half a side is 2^13: below 2^26 in the
    /// circle that fills the square.
    #[inline(always)]
    pub const fn radius_squared(self) -> u32 {
        const fn from_middle(v: u32) -> i32 {
            v.wrapping_sub(1 << 27).cast_signed() >> 14
        }
        let (x, y) = (from_middle(self.s), from_middle(self.t));
        x.wrapping_mul(x).wrapping_add(y.wrapping_mul(y)).cast_unsigned()
    }
}

impl Stepped for PointCoordinates {
    type Step = u32;

    #[inline(always)]
    fn step(&mut self, step: &u32) {
        self.s = self.s.wrapping_add(*step);
    }
}

impl Varying for PointCoordinates {
    type Corner = ();
    type Planes = ();
    type Runs = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(_: &Gradients, _: &[(); 3], (): &(), _in_pieces: bool) {}

    #[inline(always)]
    fn runs((): &(), _: &Span) {}

    #[inline(always)]
    fn run((): &(), (): &mut (), _: &Span, _x: i32) -> (Self, u32, i32) {
        (Self::default(), 0, i32::MAX)
    }

    #[inline(always)]
    fn on_point((): &(), square: &PointSquare, x: i32, y: i32) -> (Self, u32) {
        // Of sizes in sixteenths: the step of a pixel, and of one of 32 parts of it.
        let step = u32::MAX.wrapping_div(square.size_bits().max(16));
        let part = step >> 5;
        let at = |offset: i32| {
            let (pixels, parts) = (offset.cast_unsigned() >> 5, offset.cast_unsigned() & 31);
            pixels.wrapping_mul(step).wrapping_add(parts.wrapping_mul(part))
        };
        let (s, t) = square.offset(x, y);
        (Self { s: at(s), t: at(t) }, step)
    }

    #[inline(always)]
    fn settle((): &mut (), _x: i32, _y: i32) {}

    #[inline(always)]
    fn mix(_: [&(); 3], _u: i32, _v: i32) {}
}
