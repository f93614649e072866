use crate::color::{add_to_pairs, multiply_pairs, subtract_from_pairs, Color, Format, EIGHTS};

/// How a fragment's colour meets the one that is stored.
///
/// # Rounding
/// Every mode is within one step of the format of the exact result for the 8-bit channels that
/// the source and the stored pixel stand for, and for the format's [weight](Format::weight) of
/// alpha, which RGB565 resolves to 32nds. What leaves the stored pixel as it is (alpha 0,
/// nothing added) does so to the bit, and what replaces it (alpha 255) stores what [`Replace`]
/// does.
pub trait Blend {
    /// Whether what is stored may be read. Otherwise the source is stored as it is.
    const READS: bool;
    /// Whether it is.
    #[inline(always)]
    fn reads(&self) -> bool {
        Self::READS
    }
    /// What is made of a source colour, once for as many pixels as it meets.
    type Source: Copy;

    /// Prepares a source colour for pixels of a format.
    fn source<F: Format>(&self, color: Color) -> Self::Source;

    /// The colour of a source and the pixel that it meets.
    fn blend<F: Format>(&self, source: &Self::Source, stored: F::Raw) -> Color;

    /// Blends one source into a run of pixels.
    #[inline(always)]
    fn fill<F: Format>(&self, source: &Self::Source, pixels: &mut [F::Raw]) {
        one_by_one::<F, _>(self, source, pixels);
    }
}

/// Blends one source into a run of pixels, each as if it were the only one.
#[inline(always)]
fn one_by_one<F: Format, B: Blend + ?Sized>(mode: &B, source: &B::Source, pixels: &mut [F::Raw]) {
    for pixel in pixels {
        *pixel = F::pack(mode.blend::<F>(source, *pixel));
    }
}

/// The source alone: the default, for which nothing is read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Replace;

impl Blend for Replace {
    const READS: bool = false;
    type Source = Color;

    #[inline(always)]
    fn source<F: Format>(&self, color: Color) -> Color {
        color
    }

    #[inline(always)]
    fn blend<F: Format>(&self, source: &Color, _stored: F::Raw) -> Color {
        *source
    }

    #[inline(always)]
    fn fill<F: Format>(&self, source: &Color, pixels: &mut [F::Raw]) {
        F::fill(pixels, F::pack(*source));
    }
}

/// A source that is weighted already: `keep / 256` of what is stored stay, `add` comes.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Weighted {
    keep: u32,
    add: Color,
}

/// Half an 8-bit step in each channel.
const HALVES: Color = Color { blue_red: 0x0080_0080, green: 0x0080_0000 };

impl Weighted {
    /// So much of the source, 256 for all.
    #[inline(always)]
    const fn new(color: Color, weight: u32) -> Self {
        Self { keep: 256_u32.wrapping_sub(weight), add: color.weighted(weight, HALVES) }
    }

    #[inline(always)]
    fn over<F: Format>(&self, stored: F::Raw) -> Color {
        F::middle(stored).weighted(self.keep, self.add)
    }
}

/// An alpha in 256ths, so that both ends are whole: off by at most half of one.
#[inline(always)]
const fn weight(alpha: u8) -> u32 {
    (alpha as u32).wrapping_add((alpha >> 7) as u32)
}

/// Modes whose sources are weighted.
macro_rules! weighted {
    ($($name:ident: $this:ident, $color:ident => $weight:expr;)*) => {
        $(
            impl Blend for $name {
                const READS: bool = true;
                type Source = Weighted;

                #[inline(always)]
                fn source<F: Format>(&self, $color: Color) -> Weighted {
                    let $this = self;
                    Weighted::new($color, F::weight($weight))
                }

                #[inline(always)]
                fn blend<F: Format>(&self, source: &Weighted, stored: F::Raw) -> Color {
                    source.over::<F>(stored)
                }

                #[inline(always)]
                fn fill<F: Format>(&self, source: &Weighted, pixels: &mut [F::Raw]) {
                    F::fade(pixels, source.keep, source.add);
                }
            }
        )*
    };
}

/// By the source's alpha: `source a + stored (1 - a)`.
///
/// # Measured
/// <!-- tradeoff: heads-up/blend=alpha -->
/// `alpha` in the scene `heads-up`: 5.66 (M4F), 10.7 (M0+), 7.80 (RV32) instructions a pixel; PSNR 39.9 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Alpha;

/// By an alpha for all fragments, whatever their own: 0 is invisible, 255 opaque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ConstantAlpha(pub u8);

/// Half the source and half of what is stored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Average;

weighted! {
    Alpha: _this, color => weight(color.alpha());
    ConstantAlpha: this, color => weight(this.0);
    Average: _this, color => 128;
}

/// Both channels of a word, brought down to 255; at most 511 each.
#[inline(always)]
const fn saturated(channels: u32) -> u32 {
    let over = channels >> 8 & 0x0001_0001;
    (channels | over.wrapping_mul(255)) & EIGHTS
}

/// Both channels of the difference of words, brought up to 0.
#[inline(always)]
const fn difference(from: u32, take: u32) -> u32 {
    let guarded = (from | 0x0100_0100).wrapping_sub(take);
    let positive = guarded >> 8 & 0x0001_0001;
    guarded & positive.wrapping_mul(255)
}

/// Eight bits of blue and red in one word, and green.
#[derive(Clone, Copy)]
struct Eights(u32, u32);

impl Eights {
    #[inline(always)]
    const fn of(color: Color) -> Self {
        Self(color.blue_red >> 8 & EIGHTS, color.green >> 24)
    }

    /// The opaque colour; fractions are zero.
    #[inline(always)]
    const fn color(self) -> Color {
        Color { blue_red: self.0 << 8, green: self.1 << 24 | Color::OPAQUE }
    }
}

/// By the source's alpha, which its channels have been multiplied by: `source + stored (1 - a)`,
/// at most full. Channels may exceed alpha: what has alpha 0 glows.
///
/// # Rounding
/// Where channels exceed alpha, within 17/16 of a step: the stored pixel's eight bits are rounded
/// before they are added.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Premultiplied;

/// A source of [`Premultiplied`]: eight bits a channel, to be added.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PremultipliedSource {
    keep: u32,
    add: Color,
    /// Whether the sum may exceed full.
    glows: bool,
}

impl Blend for Premultiplied {
    const READS: bool = true;
    type Source = PremultipliedSource;

    #[inline(always)]
    fn source<F: Format>(&self, color: Color) -> PremultipliedSource {
        let keep = 256_u32.wrapping_sub(F::weight(weight(color.alpha())));
        let Eights(blue_red, green) = Eights::of(color);
        // What is kept is at most 255 keep / 256, rounded.
        let room = 255_u32.wrapping_sub(keep.wrapping_mul(255).wrapping_add(128) >> 8);
        let glows = (blue_red >> 16).max(blue_red & 0xFF).max(green) > room;
        PremultipliedSource { keep, add: color, glows }
    }

    #[inline(always)]
    fn blend<F: Format>(&self, source: &PremultipliedSource, stored: F::Raw) -> Color {
        let stored = if source.glows { F::unpack(stored) } else { F::middle(stored) };
        let kept = Eights::of(stored.weighted(source.keep, HALVES));
        let added = Eights::of(source.add);
        let (blue_red, green) = (kept.0.wrapping_add(added.0), kept.1.wrapping_add(added.1));
        Eights(saturated(blue_red), saturated(green)).color()
    }

    #[inline(always)]
    fn fill<F: Format>(&self, source: &PremultipliedSource, pixels: &mut [F::Raw]) {
        if source.glows {
            one_by_one::<F, _>(self, source, pixels);
        } else {
            let Eights(blue_red, green) = Eights::of(source.add);
            let (blue_red, green) = (blue_red << 8 | 0x0080_0080, green << 24 | 0x0080_0000);
            F::fade(pixels, source.keep, Color { blue_red, green });
        }
    }
}

/// Modes of the eight bits of both colours.
macro_rules! eights {
    ($($(#[$doc:meta])* $name:ident by $pairs:ident: $source:ident, $stored:ident => $blended:expr;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct $name;

            impl Blend for $name {
                const READS: bool = true;
                type Source = Color;

                #[inline(always)]
                fn source<F: Format>(&self, color: Color) -> Color {
                    color
                }

                #[inline(always)]
                fn blend<F: Format>(&self, source: &Color, stored: F::Raw) -> Color {
                    let ($source, $stored) = (Eights::of(*source), Eights::of(F::unpack(stored)));
                    $blended.color()
                }

                #[inline(always)]
                fn fill<F: Format>(&self, source: &Color, pixels: &mut [F::Raw]) {
                    match F::as_rgb565(pixels) {
                        Some((pixels, false)) => $pairs::<false>(pixels, *source),
                        Some((pixels, true)) => $pairs::<true>(pixels, *source),
                        None => one_by_one::<F, _>(self, source, pixels),
                    }
                }
            }
        )*
    };
}

eights! {
    /// The sum, at most full.
    Add by add_to_pairs: source, stored => Eights(
        saturated(source.0.wrapping_add(stored.0)),
        saturated(source.1.wrapping_add(stored.1)),
    );
    /// What is stored less the source, at least zero.
    Subtract by subtract_from_pairs: source, stored => Eights(
        difference(stored.0, source.0),
        difference(stored.1, source.1),
    );
    /// The product, where full is one.
    Multiply by multiply_pairs: source, stored => {
        let product = |a: u32, b: u32| {
            // Rounded division by 255.
            let product = a.wrapping_mul(b).wrapping_add(128);
            product.wrapping_add(product >> 8) >> 8
        };
        let blue = product(source.0 >> 16, stored.0 >> 16);
        let red = product(source.0 & 0xFF, stored.0 & 0xFF);
        Eights(blue << 16 | red, product(source.1, stored.1))
    };
}

/// Any mode, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyBlend {
    /// As [`Replace`](struct@Replace).
    Replace,
    /// As [`Alpha`](struct@Alpha).
    Alpha,
    /// As [`ConstantAlpha`](struct@ConstantAlpha).
    ConstantAlpha(u8),
    /// As [`Premultiplied`](struct@Premultiplied).
    Premultiplied,
    /// As [`Add`](struct@Add).
    Add,
    /// As [`Multiply`](struct@Multiply).
    Multiply,
    /// As [`Subtract`](struct@Subtract).
    Subtract,
    /// As [`Average`](struct@Average).
    Average,
}

impl Blend for AnyBlend {
    const READS: bool = true;
    type Source = Color;

    fn reads(&self) -> bool {
        *self != Self::Replace
    }

    #[inline(always)]
    fn source<F: Format>(&self, color: Color) -> Color {
        color
    }

    fn blend<F: Format>(&self, color: &Color, stored: F::Raw) -> Color {
        fn by<F: Format, B: Blend>(mode: &B, color: Color, stored: F::Raw) -> Color {
            mode.blend::<F>(&mode.source::<F>(color), stored)
        }
        match self {
            Self::Replace => by::<F, _>(&Replace, *color, stored),
            Self::Alpha => by::<F, _>(&Alpha, *color, stored),
            Self::ConstantAlpha(alpha) => by::<F, _>(&ConstantAlpha(*alpha), *color, stored),
            Self::Premultiplied => by::<F, _>(&Premultiplied, *color, stored),
            Self::Add => by::<F, _>(&Add, *color, stored),
            Self::Multiply => by::<F, _>(&Multiply, *color, stored),
            Self::Subtract => by::<F, _>(&Subtract, *color, stored),
            Self::Average => by::<F, _>(&Average, *color, stored),
        }
    }
}
