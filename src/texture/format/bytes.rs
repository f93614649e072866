//! Texels that are bytes: image files and raw images as they lie in flash, at any address.

use core::marker::PhantomData;

use super::with_alpha;
use crate::color::{Color, Rgb565};
use crate::texture::{PaletteEntry, TexelFormat, Weights};

/// A texel's word from its bytes, and the rest as the format of the word says.
macro_rules! in_bytes {
    ($name:ident, $from:ident, $(#[$doc:meta])*) => {
        $(#[$doc])*
        ///
        /// Rows follow each other without a gap.
        ///
        /// # Cost
        /// A texel is two loads and a shift instead of one load; where bytes lie at an even address,
        /// a program may see them as the words that they are.
        #[derive(Clone, Copy, Debug)]
        pub struct $name<F = Rgb565>(PhantomData<F>);

        impl<F: PaletteEntry<Word = u16>> TexelFormat for $name<F> {
            type Word = [u8; 2];
            type Palette = ();
            type Texel = u16;

            const PLACES: u32 = F::PLACES;
            const CONSTANTS: [u32; 2] = F::CONSTANTS;

            #[inline(always)]
            fn fetch(words: &[[u8; 2]], (): &(), index: usize) -> Option<u16> {
                words.get(index).map(|bytes| u16::$from(*bytes))
            }

            #[inline(always)]
            fn decode(texel: u16) -> Color {
                F::decode(texel)
            }

            #[inline(always)]
            fn modulate(texel: u16, surface: Color) -> Color {
                F::modulate(texel, surface)
            }

            #[inline(always)]
            fn mix(texels: [u16; 4], weights: Weights) -> Color {
                F::mix(texels, weights)
            }

            #[inline(always)]
            fn blend(texels: [u16; 4], weights: Weights, constants: [u32; 2]) -> Color {
                F::blend(texels, weights, constants)
            }
        }
    };
}

in_bytes! {
    LittleEndian, from_le_bytes,
    /// Texels of a format of 16 bits in bytes, the low one first: as in BMP files whose masks are
    /// those of RGB565, and in an `ImageRaw` of `embedded-graphics` that is little-endian. TGA files of
    /// 16 bits, and BMP files without masks, have five bits a channel from bit 0 up, which is none
    /// of these formats.
    ///
    /// ```
    /// use microraster::texture::{LittleEndian, Sampler, Texture};
    /// use microraster::Color;
    ///
    /// // A red and a blue texel, which `include_bytes!` may put at any address.
    /// static BYTES: &[u8] = &[0x00, 0xF8, 0x1F, 0x00];
    /// let texture = Texture::<LittleEndian>::new(BYTES.as_chunks().0, 2, 1)?;
    /// let sampler = Sampler::nearest(texture)?;
    /// assert_eq!(sampler.sample(0, 0), Color::new(255, 0, 0));
    /// # Ok::<(), microraster::texture::TextureError>(())
    /// ```
}

in_bytes! {
    BigEndian, from_be_bytes,
    /// Texels of a format of 16 bits in bytes, the high one first: what most displays take, and what
    /// an `ImageRaw` of `embedded-graphics` has unless it says otherwise.
}

/// Three bytes a texel, red first: an `ImageRaw` of `embedded-graphics` with `Rgb888`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgb888;

/// Three bytes a texel, blue first: BMP and TGA files of 24 bits that are not compressed.
///
/// The rows of such files mostly begin with the lowest one, so that `v` runs upwards; those of BMP
/// files are without a gap where the width is a multiple of four.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bgr888;

/// Four bytes a texel: blue, green, red, and alpha that is not multiplied in. TGA files of 32 bits that
/// are not compressed. Most BMP files of 32 bits have the bytes, but 0 for alpha: nothing is seen of
/// them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bgra8888;

/// Texels that are so many bytes, and the colour of each.
macro_rules! channels_in_bytes {
    ($($name:ident, $bytes:literal, |$texel:pat_param| $color:expr;)*) => {
        $(impl TexelFormat for $name {
            type Word = [u8; $bytes];
            type Palette = ();
            type Texel = [u8; $bytes];

            #[inline(always)]
            fn fetch(words: &[[u8; $bytes]], (): &(), index: usize) -> Option<[u8; $bytes]> {
                words.get(index).copied()
            }

            #[inline(always)]
            fn decode($texel: [u8; $bytes]) -> Color {
                $color
            }
        }

        impl PaletteEntry for $name {})*
    };
}

channels_in_bytes! {
    Rgb888, 3, |[red, green, blue]| Color::new(red, green, blue);
    Bgr888, 3, |[blue, green, red]| Color::new(red, green, blue);
    Bgra8888, 4, |[blue, green, red, alpha]| {
        with_alpha(red.into(), green.into(), blue.into(), alpha.into())
    };
}
