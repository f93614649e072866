use crate::color::Color;
use crate::texture::{TexelFormat, Weights};

/// Eight bits of grey.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Luminance8;

impl TexelFormat for Luminance8 {
    type Word = u8;
    type Palette = ();
    type Texel = u8;

    #[inline(always)]
    fn fetch(words: &[u8], (): &(), index: usize) -> Option<u8> {
        words.get(index).copied()
    }

    #[inline(always)]
    fn decode(texel: u8) -> Color {
        let grey = texel.into();
        super::with_alpha(grey, grey, grey, 255)
    }

    /// # Rounding
    /// Half an 8-bit step, and what the place is off.
    #[inline(always)]
    fn mix(texels: [u8; 4], weights: Weights) -> Color {
        let grey = mix_byte(texels, weights);
        super::with_alpha(grey, grey, grey, 255)
    }
}

/// One channel mixed, rounded to nearest.
#[inline(always)]
pub(super) fn mix_byte(texels: [u8; 4], weights: Weights) -> u32 {
    let weighted = texels.iter().zip(weights.exact());
    weighted.fold(0x8000u32, |sum, (texel, weight)| {
        sum.wrapping_add(u32::from(*texel).wrapping_mul(weight))
    }) >> 16
}
