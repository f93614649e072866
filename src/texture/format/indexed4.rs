use core::marker::PhantomData;

use crate::color::{Color, Rgb565};
use crate::texture::{PaletteEntry, TexelFormat, Weights};

/// Four bits a texel: the number of one of 16 palette entries in format `E`.
///
/// The left one of two texels has the upper half of their byte; rows follow each other without a
/// gap, so that one of an odd width may end in the middle of a byte.
#[derive(Clone, Copy, Debug)]
pub struct Indexed4<E = Rgb565>(PhantomData<E>);

impl<E: PaletteEntry> TexelFormat for Indexed4<E> {
    type Word = u8;
    type Palette = [E::Word; 16];
    type Texel = E::Word;

    const PLACES: u32 = E::PLACES;
    const CONSTANTS: [u32; 2] = E::CONSTANTS;
    const TEXELS_PER_WORD: usize = 2;

    #[inline(always)]
    fn fetch(words: &[u8], palette: &[E::Word; 16], index: usize) -> Option<E::Word> {
        // Every half of a byte has its entry.
        words.get(index / 2).and_then(|&pair| {
            let shift = if index.is_multiple_of(2) { 4 } else { 0 };
            palette.get(usize::from((pair >> shift) & 15)).copied()
        })
    }

    #[inline(always)]
    fn decode(texel: E::Word) -> Color {
        E::decode(texel)
    }

    #[inline(always)]
    fn mix(texels: [E::Word; 4], weights: Weights) -> Color {
        E::mix(texels, weights)
    }

    #[inline(always)]
    fn blend(texels: [E::Word; 4], weights: Weights, constants: [u32; 2]) -> Color {
        E::blend(texels, weights, constants)
    }
}
