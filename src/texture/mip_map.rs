use super::{Alpha8, Luminance8, Rgba4444, Rgba5551, TexelFormat, Texture, TextureError};
use crate::color::{Rgb565, Rgba8888};

/// A picture and its smaller copies, in one slice: each half as wide and half as high as the one
/// before it, down to a single texel.
///
/// Copies are made when the program is built by `reduce` (of the formats that are not indexed), or
/// on the host by `host::mip_map`.
///
/// ```
/// use microraster::texture::{MipMap, TextureError};
/// use microraster::Rgb565;
///
/// static WORDS: [u16; MipMap::<Rgb565>::words_needed(2, 2)] = {
///     let mut words = [0xF800, 0xF800, 0, 0, 0];
///     match MipMap::<Rgb565>::reduce(&mut words, 2, 2) {
///         Ok(()) => words,
///         Err(_) => panic!("two is a power of two"),
///     }
/// };
/// # fn main() -> Result<(), TextureError> {
/// assert_eq!(WORDS[4], 0x8000); // half red
/// assert_eq!(MipMap::<Rgb565>::new(&WORDS, 2, 2)?.levels(), 2);
/// # Ok(())
/// # }
/// ```
pub struct MipMap<'a, T: TexelFormat = Rgb565> {
    /// The largest picture.
    base: Texture<'a, T>,
    /// Its words and those of all others.
    words: &'a [T::Word],
}

impl<T: TexelFormat> Clone for MipMap<'_, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: TexelFormat> Copy for MipMap<'_, T> {}

impl<T: TexelFormat> core::fmt::Debug for MipMap<'_, T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("MipMap").field("base", &self.base).finish()
    }
}

impl<'a, T: TexelFormat<Palette = ()>> MipMap<'a, T> {
    /// `words` hold a picture of `width` x `height` texels and all smaller ones after it.
    ///
    /// # Errors
    /// As [`with_palette`](Self::with_palette).
    pub const fn new(words: &'a [T::Word], width: u16, height: u16) -> Result<Self, TextureError> {
        Self::with_palette(words, &(), width, height)
    }
}

impl<'a, T: TexelFormat> MipMap<'a, T> {
    /// The same for texels that are indices into `palette`. Each picture begins with a new word.
    ///
    /// # Errors
    /// Those of [`Texture::with_palette`], [`TextureError::NotPowerOfTwo`], and
    /// [`TextureError::Length`] for less than [`words_needed`](Self::words_needed).
    pub const fn with_palette(
        words: &'a [T::Word],
        palette: &'a T::Palette,
        width: u16,
        height: u16,
    ) -> Result<Self, TextureError> {
        match Texture::with_palette(words, palette, width, height) {
            Err(error) => Err(error),
            Ok(base) if !base.has_power_of_two_sides() => {
                Err(TextureError::NotPowerOfTwo { width, height })
            }
            Ok(base) => {
                let needed = Self::words_needed(width, height);
                if words.len() < needed {
                    return Err(TextureError::Length { needed, got: words.len() });
                }
                Ok(Self { base, words })
            }
        }
    }

    /// Words of a picture of this size and all smaller ones.
    pub const fn words_needed(width: u16, height: u16) -> usize {
        Self::start(width, height, Self::last(width, height) + 1)
    }

    /// The largest picture: level 0.
    pub const fn base(&self) -> Texture<'a, T> {
        self.base
    }

    /// Pictures in all.
    pub const fn levels(&self) -> u32 {
        Self::last(self.base.width(), self.base.height()) + 1
    }

    /// Picture `number`, or the last one: half the sides (at least 1) of the one before.
    pub fn level(&self, number: u32) -> Texture<'a, T> {
        let (width, height) = (self.base.width(), self.base.height());
        let number = number.min(Self::last(width, height));
        // Checked before: there are so many words.
        let from = Self::start(width, height, number);
        let to = Self::start(width, height, number.wrapping_add(1));
        let words = self.words.get(from..to).unwrap_or_default();
        Texture::checked(words, self.base.palette(), side(width, number), side(height, number))
    }

    /// Number of the picture of one texel.
    pub(super) const fn last(width: u16, height: u16) -> u32 {
        15u32.saturating_sub((width | height).leading_zeros())
    }

    /// The word at which picture `level` begins.
    const fn start(width: u16, height: u16, level: u32) -> usize {
        let (mut words, mut before) = (0, 0);
        while before < level {
            let texels = side(width, before) as usize * side(height, before) as usize;
            words += texels.div_ceil(T::TEXELS_PER_WORD);
            before += 1;
        }
        words
    }
}

/// A side at a level.
const fn side(base: u16, level: u32) -> u16 {
    let side = base >> (level & 15);
    if side == 0 {
        1
    } else {
        side
    }
}

/// A format whose smaller pictures can be made: see `reduce` of its [`MipMap`].
pub trait Reduce: TexelFormat<Palette = ()> {
    /// Makes the smaller pictures, as `MipMap::reduce` does.
    ///
    /// # Errors
    /// As that.
    fn reduce(words: &mut [Self::Word], width: u16, height: u16) -> Result<(), TextureError>;
}

/// A word of a slice, in a constant too; 0 beyond the end.
macro_rules! word {
    ($words:expr, $at:expr) => {
        match $words.split_at_checked($at) {
            Some((_, [word, ..])) => *word,
            _ => 0,
        }
    };
}

macro_rules! reduce {
    ($($format:ty: $word:ty, [$($mask:literal),+];)*) => {
        $(
            impl MipMap<'_, $format> {
                /// Makes the smaller pictures of one of `width` x `height` texels, which is at the
                /// start of `words`: each texel the mean of four (or two), channel by channel.
                ///
                /// # Rounding
                /// To nearest, up from the middle.
                ///
                /// # Errors
                /// As [`new`](Self::new).
                #[allow(clippy::cast_possible_truncation, reason = "masks are no wider")]
                pub const fn reduce(
                    words: &mut [$word],
                    width: u16,
                    height: u16,
                ) -> Result<(), TextureError> {
                    match MipMap::<$format>::new(words, width, height) {
                        Err(error) => return Err(error),
                        Ok(_) => {}
                    }
                    let mut level = 1;
                    while level <= Self::last(width, height) {
                        let from = Self::start(width, height, level - 1);
                        let to = Self::start(width, height, level);
                        let (w, h) = (side(width, level - 1) as usize, side(height, level - 1) as usize);
                        // Where a side has one texel only, it stands for both.
                        let (across, below) = (if w > 1 { 1 } else { 0 }, if h > 1 { w } else { 0 });
                        let (half_w, half_h) = (side(width, level) as usize, side(height, level) as usize);
                        let mut i = 0;
                        while i < half_w * half_h {
                            let corner = from + i / half_w * 2 * below + i % half_w * 2 * across;
                            let texels = [
                                word!(words, corner),
                                word!(words, corner + across),
                                word!(words, corner + below),
                                word!(words, corner + across + below),
                            ];
                            let mut mean = 0;
                            $({
                                const MASK: $word = $mask;
                                let [a, b, c, d] = texels;
                                let sum = channel(a as u32, MASK as u32)
                                    + channel(b as u32, MASK as u32)
                                    + channel(c as u32, MASK as u32)
                                    + channel(d as u32, MASK as u32);
                                mean |= ((sum + 2) / 4) << MASK.trailing_zeros();
                            })+
                            if let Some((_, [word, ..])) = words.split_at_mut_checked(to + i) {
                                *word = mean as $word;
                            }
                            i += 1;
                        }
                        level += 1;
                    }
                    Ok(())
                }
            }

            impl Reduce for $format {
                fn reduce(words: &mut [$word], width: u16, height: u16) -> Result<(), TextureError> {
                    MipMap::<$format>::reduce(words, width, height)
                }
            }
        )*
    };
}

/// A channel of a texel.
const fn channel(texel: u32, mask: u32) -> u32 {
    (texel & mask) >> (mask.trailing_zeros() & 31)
}

reduce! {
    Rgb565: u16, [0xF800, 0x07E0, 0x001F];
    Rgba5551: u16, [0xF800, 0x07C0, 0x003E, 0x0001];
    Rgba4444: u16, [0xF000, 0x0F00, 0x00F0, 0x000F];
    Rgba8888: u32, [0xFF00_0000, 0x00FF_0000, 0x0000_FF00, 0x0000_00FF];
    Luminance8: u8, [0xFF];
    Alpha8: u8, [0xFF];
}
