use crate::color::Color;
use crate::texture::{TexelFormat, Weights};

/// Eight bits of alpha: white, more or less of it. Glyphs, smoke, soft shadows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Alpha8;

impl TexelFormat for Alpha8 {
    type Word = u8;
    type Palette = ();
    type Texel = u8;

    #[inline(always)]
    fn fetch(words: &[u8], (): &(), index: usize) -> Option<u8> {
        words.get(index).copied()
    }

    #[inline(always)]
    fn decode(texel: u8) -> Color {
        super::with_alpha(255, 255, 255, texel.into())
    }

    /// # Rounding
    /// Half an 8-bit step, and what the place is off.
    #[inline(always)]
    fn mix(texels: [u8; 4], weights: Weights) -> Color {
        super::with_alpha(255, 255, 255, super::luminance8::mix_byte(texels, weights))
    }
}
