use crate::color::Color;
use crate::texture::{PaletteEntry, TexelFormat};

/// Sixteen bits a texel, `rrrrgggg bbbbaaaa`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgba4444;

impl TexelFormat for Rgba4444 {
    type Word = u16;
    type Palette = ();
    type Texel = u16;

    #[inline(always)]
    fn fetch(words: &[u16], (): &(), index: usize) -> Option<u16> {
        words.get(index).copied()
    }

    /// Bits are repeated, which is exact: 15 x 17 is 255.
    #[inline(always)]
    fn decode(texel: u16) -> Color {
        let texel = u32::from(texel);
        let channel = |shift: u32| ((texel >> shift) & 15).wrapping_mul(17);
        super::with_alpha(channel(12), channel(8), channel(4), channel(0))
    }
}

impl PaletteEntry for Rgba4444 {}
