use super::flat_color::mix_color;
use super::Varying;
use crate::color::Color;
use crate::raster::{Gradients, Plane};

/// A colour interpolated over the triangle, linear on the screen (Gouraud).
///
/// # Rounding
/// Three planes of 8.24 are exact to 2^-12 of an 8-bit step. Within a piece of at most 128 pixels
/// blue and red are stepped together in one word, as 8.8: each slope is off by at most half of
/// 1/256, so that the packed channels stray by at most a quarter of an 8-bit step and, starting
/// half a step inside of their range, never leave it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SmoothColor(Color);

/// The planes of a [`SmoothColor`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SmoothColorPlanes {
    red: Plane,
    green: Plane,
    blue: Plane,
    /// Slopes of blue and red in 8.8, packed like [`Color::blue_red`].
    step: u32,
}

impl SmoothColor {
    /// Pixels over which blue and red are stepped in one word.
    const PIXELS: i32 = 128;

    /// The colour at this pixel.
    #[inline(always)]
    pub const fn color(self) -> Color {
        self.0
    }
}

// Half a unit of slope over the steps of a piece, one unit where the start is cut off and one for
// the planes' own error must stay below the half step (128 units) that the corners are raised by.
const _: () = assert!((SmoothColor::PIXELS - 1) / 2 + 2 < 128, "packed channels stay in range");

/// A slope of 8.24 rounded to 8.8.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "slopes are modulo 2^32")]
const fn packed_slope(slope: u32) -> u32 {
    // Arithmetic: the borrow of a negative red goes into blue and comes back when it is added.
    ((slope as i32).wrapping_add(0x8000) >> 16) as u32
}

impl Varying for SmoothColor {
    type Corner = Color;
    type Planes = SmoothColorPlanes;
    type Step = (u32, u32);

    const INTERPOLATED: bool = true;
    const PIECE: i32 = Self::PIXELS;

    #[inline(always)]
    fn planes(gradients: &Gradients, [a, b, c]: [&Color; 3], _: &Color) -> SmoothColorPlanes {
        smooth_planes(gradients, a, b, c)
    }

    #[inline(always)]
    fn start(planes: &SmoothColorPlanes, x: i32, y: i32) -> (Self, (u32, u32)) {
        let (red, blue) = (planes.red.at(x, y), planes.blue.at(x, y));
        let blue_red = (blue & 0xFFFF_0000) | red >> 16;
        (Self(Color { blue_red, green: planes.green.at(x, y) }), (planes.step, planes.green.dx))
    }

    #[inline(always)]
    fn step(&mut self, (blue_red, green): &(u32, u32)) {
        self.0.blue_red = self.0.blue_red.wrapping_add(*blue_red);
        self.0.green = self.0.green.wrapping_add(*green);
    }

    #[inline(always)]
    fn advance(&mut self, (blue_red, green): &(u32, u32), pixels: i32) {
        let pixels = pixels as u32;
        self.0.blue_red = self.0.blue_red.wrapping_add(blue_red.wrapping_mul(pixels));
        self.0.green = self.0.green.wrapping_add(green.wrapping_mul(pixels));
    }

    #[inline(always)]
    fn mix(corners: [&Color; 3], u: i32, v: i32) -> Color {
        mix_color(corners, u, v)
    }
}

/// One copy for every shader that interpolates a colour.
#[inline(never)]
fn smooth_planes(gradients: &Gradients, a: &Color, b: &Color, c: &Color) -> SmoothColorPlanes {
    // The difference of a channel in 16 bits.
    let low = |to: u32, from: u32| (to & 0xFFFF).wrapping_sub(from & 0xFFFF) as i32;
    let high = |to: u32, from: u32| (to >> 16).wrapping_sub(from >> 16) as i32;
    let (first, second, third) = (a.blue_red, b.blue_red, c.blue_red);
    let red = gradients.plane_from(first << 16, low(second, first), low(third, first));
    let blue = gradients.plane_from(first & 0xFFFF_0000, high(second, first), high(third, first));
    let green = gradients.plane_from(a.green, high(b.green, a.green), high(c.green, a.green));
    let step = (packed_slope(blue.dx) << 16).wrapping_add(packed_slope(red.dx));
    SmoothColorPlanes { red, green, blue, step }
}
