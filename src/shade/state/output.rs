use super::color_mask::masked;
use super::{AllChannels, Blend, ColorMask, Dither, Replace, Undithered};
use crate::color::{Color, Format};

/// What becomes of a fragment's colour: it is blended, dithered, and masked, in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Output<B = Replace, W = Undithered, M = AllChannels> {
    /// How it meets what is stored.
    pub blend: B,
    /// Whether it is dithered.
    pub dither: W,
    /// Which channels are written.
    pub mask: M,
}

/// The way from a fragment's colour to the stored pixel: an [`Output`].
pub trait ColorOutput {
    /// Whether colours are stored just as the format packs them.
    const PLAIN: bool;
    /// How colours are blended.
    type Blend: Blend;
    /// How they are dithered.
    type Dither: Dither;

    /// How colours are blended.
    fn blend(&self) -> &Self::Blend;
    /// How they are dithered.
    fn dither(&self) -> &Self::Dither;

    /// The pixel to store for a source where `stored` was.
    #[doc(hidden)]
    fn pixel<F: Format>(
        &self,
        source: &<Self::Blend as Blend>::Source,
        stored: &F::Raw,
        thresholds: &<Self::Dither as Dither>::Thresholds,
    ) -> F::Raw;

    /// The channels of a packed colour that are written, and the others of `stored`.
    #[doc(hidden)]
    fn masked<F: Format>(&self, packed: F::Raw, stored: &F::Raw) -> F::Raw;

    /// Whether colours are best [dimmed](Format::dim) at the corners: they are dithered and not
    /// blended.
    #[doc(hidden)]
    #[inline(always)]
    fn dims(&self) -> bool {
        self.dither().dithers() && !self.blend().reads()
    }

    /// Stores one colour in pixels of row `y` from `x` on.
    #[doc(hidden)]
    fn fill<F: Format>(&self, pixels: &mut [F::Raw], color: Color, x: i32, y: i32);
}

impl<B: Blend, W: Dither, M: ColorMask> ColorOutput for Output<B, W, M> {
    const PLAIN: bool = !(B::READS || W::DITHERS || M::MASKS);
    type Blend = B;
    type Dither = W;

    #[inline(always)]
    fn blend(&self) -> &B {
        &self.blend
    }

    #[inline(always)]
    fn dither(&self) -> &W {
        &self.dither
    }

    #[inline(always)]
    fn pixel<F: Format>(
        &self,
        source: &B::Source,
        stored: &F::Raw,
        thresholds: &W::Thresholds,
    ) -> F::Raw {
        let color = self.blend.blend::<F>(source, *stored);
        let packed = match W::first(thresholds) {
            Some(thresholds) => F::pack_dithered(color, thresholds),
            None => F::pack(color),
        };
        self.masked::<F>(packed, stored)
    }

    #[inline(always)]
    fn masked<F: Format>(&self, packed: F::Raw, stored: &F::Raw) -> F::Raw {
        if M::MASKS {
            masked::<F>(&self.mask, packed, *stored)
        } else {
            packed
        }
    }

    #[inline(always)]
    fn fill<F: Format>(&self, pixels: &mut [F::Raw], color: Color, x: i32, y: i32) {
        let source = self.blend.source::<F>(color);
        if W::DITHERS || M::MASKS {
            let mut thresholds = self.dither.thresholds(x, y);
            for pixel in pixels {
                *pixel = self.pixel::<F>(&source, pixel, &thresholds);
                W::step(&mut thresholds);
            }
        } else {
            self.blend.fill::<F>(&source, pixels);
        }
    }
}
