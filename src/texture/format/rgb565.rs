use crate::color::{Color, Rgb565};
use crate::texture::{PaletteEntry, TexelFormat, Weights};

/// Bits are repeated: what goes into an RGB565 frame unchanged is the texel's own bits, and in
/// RGBA8888 it is within one step of r/31, g/63, b/31.
impl TexelFormat for Rgb565 {
    type Word = u16;
    type Palette = ();
    type Texel = u16;

    const PLACES: u32 = 5;
    const CONSTANTS: [u32; 2] = [FIELDS, HALVES];

    #[inline(always)]
    fn fetch(words: &[u16], (): &(), index: usize) -> Option<u16> {
        words.get(index).copied()
    }

    #[inline(always)]
    fn blend_square(
        words: &[u16],
        (): &(),
        [index, row]: [usize; 2],
        weights: Weights,
        constants: [u32; 2],
    ) -> Option<Color> {
        let words = words.get(index..)?.get(..row.wrapping_add(2))?;
        let ([a, b], [x, y]) = (words.first_chunk()?, weights.coarse());
        let upper = mixed([*a, *b], x, constants);
        // Read no sooner, lower texels need no registers before.
        core::hint::black_box(());
        let [c, d] = words.get(row..)?.first_chunk()?;
        let lower = mixed([*c, *d], x, constants);
        Some(shown(between(upper, lower, y, constants)))
    }

    #[inline(always)]
    fn decode(texel: u16) -> Color {
        Self::decode(texel)
    }

    /// # Rounding
    /// Channels keep all their bits under weights of 11: one 8-bit step, and what the place is off.
    /// Four equal texels give what the nearest one gives.
    #[inline(always)]
    fn mix(texels: [u16; 4], weights: Weights) -> Color {
        let (mut blue_red, mut green) = (0u32, 0u32);
        for (texel, weight) in texels.into_iter().zip(weights.fine()) {
            let texel = u32::from(texel);
            // 5 bits of channel and 11 of weight are 16.
            let pair = (texel & 31) << 16 | texel >> 11;
            blue_red = blue_red.wrapping_add(pair.wrapping_mul(weight));
            green = green.wrapping_add(((texel >> 5) & 63).wrapping_mul(weight));
        }
        // Bits are repeated as in `decode`: x 33/32 and x 65/64.
        Color {
            blue_red: blue_red.wrapping_add((blue_red >> 5) & 0x07FF_07FF),
            green: (green << 15).wrapping_add(green << 9) | 0xFFFF,
        }
    }

    /// # Rounding
    /// To the format's own colours, across and then down: at most one step of a channel (8.3 and
    /// 4.1 8-bit steps) beside what places of five bits are off. Four equal texels give what the
    /// nearest one gives.
    ///
    /// # Source
    /// Three channels in one multiplication, spread over a word.
    #[inline(always)]
    fn blend([a, b, c, d]: [u16; 4], weights: Weights, constants: [u32; 2]) -> Color {
        let [x, y] = weights.coarse();
        let (upper, lower) = (mixed([a, b], x, constants), mixed([c, d], x, constants));
        shown(between(upper, lower, y, constants))
    }
}

/// The three channels of a texel in one word, green in the upper half: each has room for five bits of
/// fraction.
const FIELDS: u32 = 0x07E0_F81F;

/// Half a step of each channel, with five bits of fraction.
const HALVES: u32 = 0x0200_8010;

/// The fields of a texel between two others, rounded; `weight` from 0 to 31.
#[inline(always)]
fn mixed(texels: [u16; 2], weight: u32, constants: [u32; 2]) -> u32 {
    let [fields, _] = constants;
    let [from, to] = texels.map(|texel| (u32::from(texel) | u32::from(texel) << 16) & fields);
    between(from, to, weight, constants)
}

/// Fields between others, rounded.
#[inline(always)]
const fn between(from: u32, to: u32, weight: u32, [fields, halves]: [u32; 2]) -> u32 {
    // What a field lends to its neighbour comes back with the sum.
    let way = to.wrapping_sub(from).wrapping_mul(weight).wrapping_add(halves);
    (from << 5).wrapping_add(way) >> 5 & fields
}

/// The colour of fields.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the lower half")]
const fn shown(fields: u32) -> Color {
    Rgb565::decode((fields | fields >> 16) as u16)
}

impl PaletteEntry for Rgb565 {}
