use super::Sample;
use crate::color::Color;
use crate::shade::Uv;

/// How a texel and the surface's colour become one: the texture environment of OpenGL 1.x.
pub trait Environment {
    /// Whether several pixels may be combined at a time, and the texel is multiplied then.
    #[doc(hidden)]
    const IN_LANES: Option<bool> = None;

    /// The colour of a fragment.
    fn combine(&self, texel: Color, surface: Color) -> Color;

    /// The same of the texel at coordinates that have [begun](Sample::begin).
    #[doc(hidden)]
    #[inline(always)]
    fn combine_begun(&self, sampler: &impl Sample, uv: Uv, surface: Color) -> Option<Color> {
        Some(self.combine(sampler.fetch_begun(uv)?, surface))
    }
}

/// Texel x surface, alpha too: light falls on the picture.
///
/// # Rounding
/// Within one 8-bit step of the exact product; full x a channel is that channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Modulate;

impl Environment for Modulate {
    const IN_LANES: Option<bool> = Some(true);

    #[inline(always)]
    fn combine(&self, texel: Color, surface: Color) -> Color {
        // (t + 1/2)(c + 1/2) / 256 is t c / 255 + 1/2, less half a step at most.
        let red = product(texel.blue_red, surface.blue_red) >> 16;
        let blue = product(texel.blue_red >> 16, surface.blue_red >> 16) & HIGH;
        let green = product(texel.green >> 16, surface.green >> 16) & HIGH;
        Color { blue_red: blue | red, green: green | alpha(texel, surface) }
    }

    #[inline(always)]
    fn combine_begun(&self, sampler: &impl Sample, uv: Uv, surface: Color) -> Option<Color> {
        sampler.modulate_begun(uv, surface)
    }
}

/// The texel alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Replace;

impl Environment for Replace {
    const IN_LANES: Option<bool> = Some(false);

    #[inline(always)]
    fn combine(&self, texel: Color, _surface: Color) -> Color {
        texel
    }
}

/// The texel over the surface, as its alpha says; the surface's alpha stays.
///
/// # Rounding
/// Within one and a half 8-bit steps; texels of alpha 255 and 0 give the texel and the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Decal;

impl Environment for Decal {
    #[inline(always)]
    fn combine(&self, texel: Color, surface: Color) -> Color {
        // 0 to 256.
        let over = (texel.green >> 8) & 255;
        let over = over.wrapping_add(over >> 7);
        let under = 256u32.wrapping_sub(over);
        let mix = |texel: u32, surface: u32| {
            texel.wrapping_mul(over).wrapping_add(surface.wrapping_mul(under))
        };
        let bytes = |color: Color| (color.blue_red >> 8) & 0x00FF_00FF;
        let blue_red = mix(bytes(texel), bytes(surface)).wrapping_add(0x0080_0080);
        let green = mix(texel.green >> 16, surface.green >> 16) << 8;
        Color { blue_red, green: green & HIGH | surface.green & LOW }
    }
}

/// Texel + surface, at most full, and the product of their alphas: what shines.
///
/// # Rounding
/// Exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Add;

impl Environment for Add {
    #[inline(always)]
    fn combine(&self, texel: Color, surface: Color) -> Color {
        let sum = |texel: u32, surface: u32| {
            // Both have the half step; the sum needs it once.
            let sum = texel.wrapping_add(surface).saturating_sub(0x80);
            sum.min(LOW)
        };
        let red = sum(texel.blue_red & LOW, surface.blue_red & LOW);
        let blue = sum(texel.blue_red >> 16, surface.blue_red >> 16);
        let green = sum(texel.green >> 16, surface.green >> 16);
        Color { blue_red: blue << 16 | red, green: green << 16 | alpha(texel, surface) }
    }
}

/// Any environment, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyEnvironment {
    /// As [`Modulate`](struct@Modulate).
    Modulate,
    /// As [`Replace`](struct@Replace).
    Replace,
    /// As [`Decal`](struct@Decal).
    Decal,
    /// As [`Add`](struct@Add).
    Add,
}

impl Environment for AnyEnvironment {
    #[inline(always)]
    fn combine(&self, texel: Color, surface: Color) -> Color {
        match self {
            Self::Modulate => Modulate.combine(texel, surface),
            Self::Replace => Replace.combine(texel, surface),
            Self::Decal => Decal.combine(texel, surface),
            Self::Add => Add.combine(texel, surface),
        }
    }
}

/// The upper of two 8.8 channels.
const HIGH: u32 = 0xFFFF_0000;
/// The lower of two 8.8 channels.
const LOW: u32 = 0xFFFF;

/// The product of the low halves; 8.8 in the upper half.
#[inline(always)]
const fn product(a: u32, b: u32) -> u32 {
    (a & LOW).wrapping_mul(b & LOW)
}

/// The product of two alphas: full x full is full.
#[inline(always)]
const fn alpha(texel: Color, surface: Color) -> u32 {
    product(texel.green, surface.green).wrapping_add(LOW) >> 16
}
