use super::{Axis, Environment, Modulate, Weights};
use crate::color::{Color, Format};

/// How the texels of a [`Texture`](super::Texture) are stored.
///
/// A format of your own needs [`fetch`](Self::fetch) and [`decode`](Self::decode).
pub trait TexelFormat {
    /// What the texture's data consist of.
    type Word: Copy + 'static;
    /// What indices mean: an array, or `()` where texels stand for themselves.
    type Palette: ?Sized + 'static;
    /// One texel, still packed.
    type Texel: Copy;

    /// How many bits of a place between texels, 1 to 8, [`blend`](Self::blend) takes.
    const PLACES: u32 = 8;

    /// Two words that [`blend`](Self::blend) is handed again: kept for a run of pixels, they are not
    /// made anew for each.
    const CONSTANTS: [u32; 2] = [0; 2];

    /// Texels in one word of the data; rows follow each other without a gap.
    const TEXELS_PER_WORD: usize = 1;

    /// Texel `index` of the data; `None` beyond its end, where no sampler reads.
    fn fetch(words: &[Self::Word], palette: &Self::Palette, index: usize) -> Option<Self::Texel>;

    /// The colour of a texel.
    fn decode(texel: Self::Texel) -> Color;

    /// The colour of a texel [multiplied](Modulate) with that of a surface.
    #[inline(always)]
    fn modulate(texel: Self::Texel, surface: Color) -> Color {
        Modulate.combine(Self::decode(texel), surface)
    }

    /// The colour between the four texels of a square: upper left, upper right, lower left, lower
    /// right.
    ///
    /// # Rounding
    /// As provided here, the 8-bit channels of the decoded colours are mixed by 8-bit weights.
    #[inline(always)]
    fn mix(texels: [Self::Texel; 4], weights: Weights) -> Color {
        mix_colors(texels.map(Self::decode), weights)
    }

    /// The same as finely as is cheap: for [`Bilinear`](super::Bilinear).
    #[inline(always)]
    fn blend(texels: [Self::Texel; 4], weights: Weights, _constants: [u32; 2]) -> Color {
        Self::mix(texels, weights)
    }

    /// The same of texel `index`, the next one, and both a row behind, that is, so many texels; of
    /// `corners` where there is no such place, or it is beyond the end of the data. A format may
    /// look up a square with one check, and [multiply](Modulate) with the colour of a `surface` what is
    /// still packed.
    #[inline(always)]
    fn blend_square(
        _words: &[Self::Word],
        _index: Option<usize>,
        _row: usize,
        corners: impl FnOnce() -> Option<[Self::Texel; 4]>,
        weights: Weights,
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        Some(multiplied(Self::blend(corners()?, weights, constants), surface))
    }

    /// Whether several pixels are worth blending at a time, as [`Squares`] of RGB565 texels.
    #[doc(hidden)]
    const IN_LANES: bool = false;

    /// Two texels in a word, the first one below.
    #[doc(hidden)]
    #[inline(always)]
    fn pair(_first: Self::Texel, _second: Self::Texel) -> u32 {
        0
    }

    /// Texel `index` and the next one, and both a row behind; `None` beyond the data.
    #[doc(hidden)]
    #[inline(always)]
    fn pairs(_words: &[Self::Word], _index: usize, _row: usize) -> Option<[u32; 2]> {
        None
    }

    /// Whether rows are worth mixing before they are drawn.
    #[doc(hidden)]
    const IN_ROWS: bool = false;

    /// Mixes pixels side by side from two rows of texels, `y` in units of 2^-5 below the upper one; of turned
    /// coordinates, u and its way, which is less than a texel to the right.
    #[doc(hidden)]
    #[inline(always)]
    fn mix_row(
        _rows: [&[Self::Word]; 2],
        _y: u32,
        _axis: &Axis,
        _u_and_way: [i32; 2],
        _mixed: &mut [u32],
    ) -> Option<()> {
        None
    }

    /// What was mixed, [multiplied](super::Modulate) with the colour of a `surface`, as it is stored.
    #[doc(hidden)]
    #[inline(always)]
    fn show_mixed<F: Format>(_mixed: u32, surface: Option<Color>) -> F::Raw {
        F::pack(surface.unwrap_or_default())
    }
}

/// A texel multiplied with the colour of a surface, if there is one.
#[inline(always)]
pub(super) fn multiplied(texel: Color, surface: Option<Color>) -> Color {
    match surface {
        Some(surface) => Modulate.combine(texel, surface),
        None => texel,
    }
}

/// A format whose words may be the entries of a palette.
pub trait PaletteEntry: TexelFormat<Palette = (), Texel = <Self as TexelFormat>::Word> {}

/// Texels that are colours already; mostly for palettes.
impl TexelFormat for Color {
    type Word = Self;
    type Palette = ();
    type Texel = Self;

    #[inline(always)]
    fn fetch(words: &[Self], (): &(), index: usize) -> Option<Self> {
        words.get(index).copied()
    }

    #[inline(always)]
    fn decode(texel: Self) -> Self {
        texel
    }
}

impl PaletteEntry for Color {}

/// Two bytes of each word, 16 bits apart.
const BYTES: u32 = 0x00FF_00FF;

/// Mixes two 8-bit channels a word into 8.8 ones, with the half that makes cutting off a rounding.
#[inline(always)]
pub(super) fn mix_bytes(words: [u32; 4], weights: Weights) -> u32 {
    // At most 255 x 256 + 128 a channel: none runs into its neighbour.
    let weighted = words.iter().zip(weights.bytes());
    weighted.fold(0x0080_0080, |sum, (word, weight)| {
        sum.wrapping_add((word & BYTES).wrapping_mul(weight))
    })
}

/// Mixes decoded colours with their alphas.
#[inline(always)]
fn mix_colors(colors: [Color; 4], weights: Weights) -> Color {
    let blue_red = mix_bytes(colors.map(|color| color.blue_red >> 8), weights);
    let green_alpha = mix_bytes(colors.map(|color| color.green >> 8), weights);
    // Full alpha is all ones.
    Color { blue_red, green: green_alpha | 0x7F }
}
