use crate::color::Color;
use crate::texture::{PaletteEntry, TexelFormat};

/// Sixteen bits a texel, `rrrrrggg ggbbbbba`: five bits of colour, one of alpha.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgba5551;

impl TexelFormat for Rgba5551 {
    type Word = u16;
    type Palette = ();
    type Texel = u16;

    #[inline(always)]
    fn fetch(words: &[u16], (): &(), index: usize) -> Option<u16> {
        words.get(index).copied()
    }

    /// Bits are repeated: full stays full.
    #[inline(always)]
    fn decode(texel: u16) -> Color {
        let texel = u32::from(texel);
        let channel = |shift: u32| {
            let bits = (texel >> shift) & 31;
            bits << 3 | bits >> 2
        };
        super::with_alpha(channel(11), channel(6), channel(1), (texel & 1).wrapping_mul(255))
    }
}

impl PaletteEntry for Rgba5551 {}
