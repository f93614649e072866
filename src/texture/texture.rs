use super::{TexelFormat, TextureError, Weights};
use crate::color::{Color, Rgb565};

/// A picture in memory of the caller's: borrowed, never copied.
///
/// ```
/// use microraster::texture::{Texture, TextureError};
/// use microraster::Rgb565;
///
/// // In flash: the size is checked when the program is built.
/// static CHECKS: [u16; 4] = [0xFFFF, 0xF800, 0xF800, 0xFFFF];
/// static TEXTURE: Texture<'_, Rgb565> = match Texture::new(&CHECKS, 2, 2) {
///     Ok(texture) => texture,
///     Err(_) => panic!("the size fits the data"),
/// };
/// assert_eq!((TEXTURE.width(), TEXTURE.height()), (2, 2));
/// let short = Texture::<Rgb565>::new(&CHECKS, 4, 2);
/// assert_eq!(short.err(), Some(TextureError::Length { needed: 8, got: 4 }));
/// ```
pub struct Texture<'a, T: TexelFormat = Rgb565> {
    words: &'a [T::Word],
    palette: &'a T::Palette,
    width: u16,
    height: u16,
}

impl<T: TexelFormat> Clone for Texture<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: TexelFormat> Copy for Texture<'_, T> {}

impl<T: TexelFormat> core::fmt::Debug for Texture<'_, T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Texture")
            .field("width", &self.width)
            .field("height", &self.height)
            .finish_non_exhaustive()
    }
}

impl<'a, T: TexelFormat<Palette = ()>> Texture<'a, T> {
    /// A picture of `width` x `height` texels, the upper left one first, row by row.
    ///
    /// # Errors
    /// As [`with_palette`](Self::with_palette).
    pub const fn new(words: &'a [T::Word], width: u16, height: u16) -> Result<Self, TextureError> {
        Self::with_palette(words, &(), width, height)
    }
}

impl<'a, T: TexelFormat> Texture<'a, T> {
    /// The longest side, in texels.
    pub const MAX_SIDE: u16 = 4096;

    /// A picture whose texels are indices into `palette`.
    ///
    /// # Errors
    /// [`TextureError::Empty`] and [`TextureError::TooLarge`] for sides outside of
    /// 1 to [`MAX_SIDE`](Self::MAX_SIDE), [`TextureError::Length`] where `words` are too few. Words
    /// beyond the picture are allowed and never read.
    pub const fn with_palette(
        words: &'a [T::Word],
        palette: &'a T::Palette,
        width: u16,
        height: u16,
    ) -> Result<Self, TextureError> {
        if width == 0 || height == 0 {
            return Err(TextureError::Empty);
        }
        if width > Self::MAX_SIDE {
            return Err(TextureError::TooLarge { got: width });
        }
        if height > Self::MAX_SIDE {
            return Err(TextureError::TooLarge { got: height });
        }
        let needed = (width as usize * height as usize).div_ceil(T::TEXELS_PER_WORD);
        if words.len() < needed {
            return Err(TextureError::Length { needed, got: words.len() });
        }
        // The data end with the picture, so that what lies beyond its last row is not found.
        Ok(Self { words: words.split_at(needed).0, palette, width, height })
    }

    /// The same where all of that is known; `words` are no more than needed.
    pub(super) const fn checked(
        words: &'a [T::Word],
        palette: &'a T::Palette,
        width: u16,
        height: u16,
    ) -> Self {
        Self { words, palette, width, height }
    }

    /// Texels in a row.
    pub const fn width(&self) -> u16 {
        self.width
    }

    /// Rows.
    pub const fn height(&self) -> u16 {
        self.height
    }

    /// What indices mean.
    pub(super) const fn palette(&self) -> &'a T::Palette {
        self.palette
    }

    /// Whether both sides are powers of two.
    pub(super) const fn has_power_of_two_sides(&self) -> bool {
        self.width.is_power_of_two() && self.height.is_power_of_two()
    }

    /// The place of a texel in the data.
    #[inline(always)]
    fn index(&self, x: u32, y: u32) -> usize {
        y.wrapping_mul(self.width.into()).wrapping_add(x) as usize
    }

    /// Texel `x` of row `y`, still packed; `None` beyond the data.
    #[inline(always)]
    pub(super) fn texel(&self, x: u32, y: u32) -> Option<T::Texel> {
        T::fetch(self.words, self.palette, self.index(x, y))
    }

    /// What texel `place`, the one behind it, and both below show between them, or `corners` where
    /// there is no such place, multiplied with the colour of a `surface`. A row has so many texels.
    #[inline(always)]
    pub(super) fn blend_square(
        &self,
        place: Option<usize>,
        row: usize,
        corners: impl FnOnce() -> Option<[T::Texel; 4]>,
        weights: Weights,
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        T::blend_square(self.words, place, row, corners, weights, constants, surface)
    }

    /// So many words from one on; `None` beyond the data.
    #[inline(always)]
    pub(super) fn words_at(&self, first: usize, length: usize) -> Option<&[T::Word]> {
        self.words.get(first..)?.get(..length)
    }

    /// Texel `place` and the one behind it, and both below; `None` beyond the data.
    #[inline(always)]
    pub(super) fn pairs(&self, place: usize, row: usize) -> Option<[u32; 2]> {
        T::pairs(self.words, place, row)
    }
}
