use super::varying::mix_word;
use super::Varying;
use crate::color::{Color, Rgb16};
use crate::raster::Gradients;

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

impl Varying for FlatColor {
    type Corner = Rgb16;
    type Planes = Color;
    type Step = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;

    #[inline(always)]
    fn planes(_: &Gradients, _: [&Rgb16; 3], provoking: &Rgb16) -> Color {
        Color::from_rgb16(*provoking)
    }

    #[inline(always)]
    fn start(color: &Color, _x: i32, _y: i32) -> (Self, ()) {
        (Self(*color), ())
    }

    #[inline(always)]
    fn step(&mut self, (): &()) {}

    #[inline(always)]
    fn advance(&mut self, (): &(), _pixels: i32) {}

    #[inline(always)]
    fn mix(corners: [&Rgb16; 3], u: i32, v: i32) -> Rgb16 {
        mix_color(corners, u, v)
    }
}

/// Three channels mixed: one copy for all, as clipping is rare.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "clamped to 16 bits")]
pub(super) fn mix_color([a, b, c]: [&Rgb16; 3], u: i32, v: i32) -> Rgb16 {
    let full = i32::from(Rgb16::FULL);
    let channel = |of: fn(&Rgb16) -> u16| {
        mix_word(of(a).into(), of(b).into(), of(c).into(), u, v).clamp(0, full) as u16
    };
    Rgb16::new(channel(|c| c.r), channel(|c| c.g), channel(|c| c.b))
}
