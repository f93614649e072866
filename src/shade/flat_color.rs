use super::varying::mix_word;
use super::{Stepped, Varying};
use crate::color::{rounded, Color, Rgb16};
use crate::raster::{Gradients, Span};

/// One colour for the whole triangle: the provoking corner's (the first one).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlatColor(Color);

impl FlatColor {
    /// The triangle's colour.
    #[inline(always)]
    pub const fn color(self) -> Color {
        self.0
    }
}

impl Stepped for FlatColor {
    type Step = ();

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, (): &()) {}

    #[inline(always)]
    fn jump(&mut self, (): &(), _pixels: i32) {}
}

impl Varying for FlatColor {
    type Corner = Color;
    type Planes = Color;
    type Runs = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(_: &Gradients, _: &[Color; 3], provoking: &Color, _: bool) -> Color {
        *provoking
    }

    #[inline(always)]
    fn runs(_: &Color, _: &Span) {}

    #[inline(always)]
    fn run(color: &Color, (): &mut (), _: &Span, _x: i32) -> (Self, (), i32) {
        (Self(*color), (), i32::MAX)
    }

    #[inline(always)]
    fn settle(_: &mut Color, _x: i32, _y: i32) {}

    #[inline(always)]
    fn mix(corners: [&Color; 3], u: i32, v: i32) -> Color {
        mix_color(corners, u, v)
    }
}

/// Three channels mixed: one copy for all, as clipping is rare.
#[inline(never)]
pub(super) fn mix_color([a, b, c]: [&Color; 3], u: i32, v: i32) -> Color {
    // The corners' channels lie half a step inside of their range, and so does what is between.
    let channel = |of: fn(&Color) -> u32| {
        let [a, b, c] = [a, b, c].map(|corner| of(corner).cast_signed());
        let mixed = mix_word(a, b, c, u, v);
        mixed.clamp(rounded(0).into(), rounded(Rgb16::FULL).into()) as u32
    };
    let (red, blue) = (channel(|c| c.blue_red & 0xFFFF), channel(|c| c.blue_red >> 16));
    Color { blue_red: blue << 16 | red, green: channel(|c| c.green >> 16) << 16 | Color::OPAQUE }
}
