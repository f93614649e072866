use super::{ChannelLanes, Color, LANES};

/// How one pixel lies in the caller's buffer.
///
/// The built-in formats are [`Rgb565`](super::Rgb565), [`Rgb565Be`](super::Rgb565Be) and
/// [`Rgba8888`](super::Rgba8888); a format of your own needs [`pack`](Self::pack) and
/// [`unpack`](Self::unpack).
///
/// ```
/// use microraster::{Color, Format};
///
/// /// Eight bits of green: a monochrome display's grey.
/// #[derive(Clone, Copy, Debug)]
/// struct Grey8;
///
/// impl Format for Grey8 {
///     type Raw = u8;
///     fn pack(color: Color) -> u8 {
///         color.green()
///     }
///     fn unpack(raw: u8) -> Color {
///         Color::new(raw, raw, raw)
///     }
/// }
/// assert_eq!(Grey8::pack(Color::new(1, 200, 3)), 200);
/// ```
pub trait Format {
    /// The stored value of one pixel.
    type Raw: bytemuck::Pod;

    /// The stored value of a colour; fractions are cut off.
    fn pack(color: Color) -> Self::Raw;

    /// The same for several pixels.
    #[doc(hidden)]
    #[inline(always)]
    fn pack_lanes(channels: &ChannelLanes) -> [Self::Raw; LANES] {
        core::array::from_fn(|lane| Self::pack(channels.at(lane)))
    }

    /// The stored value of a colour whose channels, red, green and blue, are products below 2^25: 512 times
    /// a colour's. Its alpha is that of a [`Color`].
    #[doc(hidden)]
    #[inline(always)]
    fn pack_products([red, green, blue]: [u32; 3], alpha: u32) -> Self::Raw {
        Self::pack(Color { blue_red: blue >> 9 << 16 | red >> 9, green: green >> 9 << 16 | alpha })
    }

    /// The colour of a stored value; `pack(unpack(raw)) == raw`.
    fn unpack(raw: Self::Raw) -> Color;

    /// Sets all of `pixels` to `raw`.
    ///
    /// # Cost
    /// As written here, one store a pixel; the built-in formats store whole words, those of 16 bits
    /// eight at once: some 30 instructions a row on Cortex-M4 and one for 16 pixels.
    #[inline(always)]
    fn fill(pixels: &mut [Self::Raw], raw: Self::Raw) {
        for pixel in pixels {
            *pixel = raw;
        }
    }

    /// The middle of the colours that are stored as `raw`, where that is cheaper than
    /// [`unpack`](Self::unpack): what blending by weights takes for the stored colour.
    ///
    /// # Rounding
    /// With a fraction of zero, and not beyond half a step of the format from what `unpack` gives.
    #[inline(always)]
    fn middle(raw: Self::Raw) -> Color {
        Self::unpack(raw)
    }

    /// The weight that blending takes for one of 0 to 256: the same, unless the format resolves
    /// fewer.
    #[inline(always)]
    fn weight(weight: u32) -> u32 {
        weight
    }

    /// Replaces each pixel by `keep / 256` of itself and `add`: blending of one source colour by
    /// weights.
    ///
    /// # Range
    /// `keep` a [weight](Self::weight); `add` such that no channel's sum exceeds 255.996.
    ///
    /// # Rounding
    /// Cut off, as [`pack`](Self::pack) does: the bits of [`pack`](Self::pack) of
    /// [`middle`](Self::middle) by weights.
    ///
    /// # Cost
    /// As written here, a loop over the pixels; the built-in formats take two channels or two
    /// pixels in a word.
    #[inline(always)]
    fn fade(pixels: &mut [Self::Raw], keep: u32, add: Color) {
        for pixel in pixels {
            *pixel = Self::pack(Self::middle(*pixel).weighted(keep, add));
        }
    }

    /// The pixels as those of RGB565, of which two are blended in a word, and whether their bytes
    /// are the other way round than the machine's; `None` of other formats.
    #[doc(hidden)]
    #[inline(always)]
    fn as_rgb565(_pixels: &mut [Self::Raw]) -> Option<(&mut [u16], bool)> {
        None
    }

    /// The stored value of a colour under dither: [`pack`](Self::pack), where that keeps eight
    /// bits of each channel.
    ///
    /// `thresholds` holds two of them in 256ths of a step, in bits 0 to 7 (for red and green) and 16
    /// to 23 (for blue); all other bits may be anything.
    #[inline(always)]
    fn pack_dithered(color: Color, _thresholds: u32) -> Self::Raw {
        Self::pack(color)
    }

    /// A corner's colour made ready for [`raise`](Self::raise) and
    /// [`pack_dimmed`](Self::pack_dimmed).
    #[inline(always)]
    fn dim(color: Color) -> Color {
        color
    }

    /// What is added to a colour between [dimmed](Self::dim) ones before it is packed, for
    /// thresholds as [`pack_dithered`](Self::pack_dithered) takes them.
    #[inline(always)]
    fn raise(_thresholds: u32) -> Color {
        Color::NOTHING
    }

    /// As [`pack_dithered`](Self::pack_dithered), of a colour between [dimmed](Self::dim) ones:
    /// what can be done at the corners is not done at the pixels.
    #[inline(always)]
    fn pack_dimmed(color: Color, thresholds: u32) -> Self::Raw {
        let Color { blue_red, green } = Self::raise(thresholds);
        Self::pack(Color {
            blue_red: color.blue_red.wrapping_add(blue_red),
            green: color.green.wrapping_add(green),
        })
    }
}
