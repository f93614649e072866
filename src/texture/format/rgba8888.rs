use crate::color::{Color, Rgba8888};
use crate::texture::texel_format::mix_bytes;
use crate::texture::{PaletteEntry, TexelFormat, Weights};

/// The bytes red, green, blue, alpha in memory, alpha not multiplied in.
impl TexelFormat for Rgba8888 {
    type Word = u32;
    type Palette = ();
    type Texel = u32;

    #[inline(always)]
    fn fetch(words: &[u32], (): &(), index: usize) -> Option<u32> {
        words.get(index).copied()
    }

    #[inline(always)]
    fn decode(texel: u32) -> Color {
        let texel = u32::from_le(texel);
        super::with_alpha(texel & 255, (texel >> 8) & 255, (texel >> 16) & 255, texel >> 24)
    }

    /// # Rounding
    /// Two channels to a product under weights of 8 bits: one and a half 8-bit steps, and what the
    /// place is off.
    #[inline(always)]
    fn mix(texels: [u32; 4], weights: Weights) -> Color {
        let texels = texels.map(u32::from_le);
        let blue_red = mix_bytes(texels, weights);
        let green_alpha = mix_bytes(texels.map(|texel| texel >> 8), weights).rotate_right(16);
        // Full alpha is all ones.
        Color { blue_red, green: green_alpha | 0x7F }
    }
}

impl PaletteEntry for Rgba8888 {}
