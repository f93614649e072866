use core::marker::PhantomData;

use crate::color::{Color, Rgb565};
use crate::texture::{PaletteEntry, TexelFormat, Weights};

/// Eight bits a texel: the number of one of 256 palette entries in format `E`.
///
/// ```
/// use microraster::texture::{Indexed8, Sampler, Texture, TextureError};
/// use microraster::{Color, Rgb565};
///
/// # fn main() -> Result<(), TextureError> {
/// let mut palette = [0; 256];
/// palette[7] = 0xF800;
/// let texture = Texture::<Indexed8<Rgb565>>::with_palette(&[7], &palette, 1, 1)?;
/// assert_eq!(Sampler::nearest(texture)?.sample(0, 0), Color::new(255, 0, 0));
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Indexed8<E = Rgb565>(PhantomData<E>);

impl<E: PaletteEntry> TexelFormat for Indexed8<E> {
    type Word = u8;
    type Palette = [E::Word; 256];
    type Texel = E::Word;

    const PLACES: u32 = E::PLACES;
    const CONSTANTS: [u32; 2] = E::CONSTANTS;

    #[inline(always)]
    fn fetch(words: &[u8], palette: &[E::Word; 256], index: usize) -> Option<E::Word> {
        // Every byte has its entry.
        words.get(index).and_then(|&number| palette.get(usize::from(number)).copied())
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
