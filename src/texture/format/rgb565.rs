use crate::color::{Color, Format, Rgb565, HAS_VECTORS};
use crate::math::{forget, rare, BY_HALVES};
use crate::texture::{Axis, PaletteEntry, TexelFormat, Weights};

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
        if index < words.len() {
            words.get(index).copied()
        } else {
            rare();
            None
        }
    }

    #[inline(always)]
    fn blend_square(
        words: &[u16],
        place: Option<usize>,
        row: usize,
        corners: impl FnOnce() -> Option<[u16; 4]>,
        weights: Weights,
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        let [x, y] = weights.coarse();
        let fields = place.and_then(|index| {
            if BY_HALVES {
                let texels = square_apart(words, index, row)?;
                return Some(blended(texels, [x, y], constants));
            }
            let rows = square_at(words, index, row)?;
            let [upper, lower] = rows.map(|pair| mixed(pair, x, constants));
            Some(between(upper, lower, y, constants))
        });
        let fields = match fields {
            Some(fields) => fields,
            None => at_edge(corners, [x, y], constants)?,
        };
        Some(match surface {
            Some(surface) => modulated(fields, surface),
            None => shown(fields),
        })
    }

    #[inline(always)]
    fn modulate(texel: u16, surface: Color) -> Color {
        modulated((u32::from(texel) | u32::from(texel) << 16) & FIELDS, surface)
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
        shown(blended([&a, &b, &c, &d], weights.coarse(), constants))
    }

    const IN_LANES: bool = HAS_VECTORS;

    #[inline(always)]
    fn pair(first: u16, second: u16) -> u32 {
        u32::from(first) | u32::from(second) << 16
    }

    #[inline(always)]
    fn pairs(words: &[u16], index: usize, row: usize) -> Option<[u32; 2]> {
        let [[a, b], [c, d]] = square_at(words, index, row)?;
        Some([Self::pair(*a, *b), Self::pair(*c, *d)])
    }

    const IN_ROWS: bool = true;

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
    fn mix_row(
        rows: [&[u16]; 2],
        y: u32,
        axis: &Axis,
        [u, way]: [i32; 2],
        mixed: &mut [u32],
    ) -> Option<()> {
        let constants = core::hint::black_box(Self::CONSTANTS);
        let [fields, halves] = constants;
        let spread = |number: u32| {
            let texels = rows.map(|row| row.get(number as usize));
            let [Some(upper), Some(lower)] = texels else { return None };
            Some([upper, lower].map(|t| (u32::from(*t) | u32::from(*t) << 16) & fields))
        };
        // From behind the last pixel: what is made of four texels is kept until the fraction goes below zero, and then
        // those on the left are the ones on the right.
        let behind = u.wrapping_add(way.wrapping_mul(mixed.len() as i32));
        let ((mut left, mut fraction), (_, step)) = (axis.fine_place(behind), axis.fine_place(way));
        let mut from = spread(left)?;
        let mut ways = difference(spread(axis.next(left))?, from);
        let step = core::hint::black_box(&step);
        for mixed in mixed.iter_mut().rev() {
            // What the compiler knows of the step it makes a multiple of the pixel's number of.
            forget();
            let borrows;
            (fraction, borrows) = fraction.overflowing_sub(*step);
            if borrows {
                left = axis.previous(left);
                let next = spread(left)?;
                ways = difference(from, next);
                from = next;
            }
            let x = fraction >> 27;
            let across = |from: u32, way: u32| {
                from.wrapping_add(way.wrapping_mul(x).wrapping_add(halves) >> 5) & fields
            };
            let (upper, lower) = (across(from[0], ways[0]), across(from[1], ways[1]));
            *mixed = between(upper, lower, y, constants);
        }
        Some(())
    }

    #[inline(always)]
    fn show_mixed<F: Format>(mixed: u32, surface: Option<Color>) -> F::Raw {
        match surface {
            Some(surface) => {
                F::pack_products(products(mixed, surface), surface.green & Color::OPAQUE)
            }
            None => F::pack(shown(mixed)),
        }
    }
}

/// The ways from two texels' fields to others.
#[inline(always)]
const fn difference([a, b]: [u32; 2], [from_a, from_b]: [u32; 2]) -> [u32; 2] {
    [a.wrapping_sub(from_a), b.wrapping_sub(from_b)]
}

/// The three channels of a texel in one word, green in the upper half: each has room for five bits of
/// fraction.
const FIELDS: u32 = 0x07E0_F81F;

/// Half a step of each channel, with five bits of fraction.
const HALVES: u32 = 0x0200_8010;

/// Texel `index` and the next one, and both a row behind.
#[inline(always)]
fn square_at(words: &[u16], index: usize, row: usize) -> Option<[&[u16; 2]; 2]> {
    let below = words.get(row.min(words.len())..)?;
    let above = words.get(..below.len())?;
    let pair = index..index.wrapping_add(2);
    Some([above.get(pair.clone())?.first_chunk()?, below.get(pair)?.first_chunk()?])
}

/// The same where they are read one by one: from four parts of the data that are of one length, so
/// that one check serves all.
#[inline(always)]
fn square_apart(words: &[u16], index: usize, row: usize) -> Option<[&u16; 4]> {
    let lower = words.get(row.min(words.len())..)?;
    let upper = words.get(..lower.len())?;
    let second = 1.min(lower.len());
    let (upper_right, lower_right) = (upper.get(second..)?, lower.get(second..)?);
    let length = lower_right.len();
    let (upper_left, lower_left) = (upper.get(..length)?, lower.get(..length)?);
    if index >= length {
        rare();
        return None;
    }
    Some([
        upper_left.get(index)?,
        upper_right.get(index)?,
        lower_left.get(index)?,
        lower_right.get(index)?,
    ])
}

/// The fields between four texels.
#[inline(always)]
fn blended([a, b, c, d]: [&u16; 4], [x, y]: [u32; 2], constants: [u32; 2]) -> u32 {
    let [fields, _] = constants;
    // Through references: loads stay where the halves are wanted.
    let doubled = |texel: &u16| (u32::from(*texel) | u32::from(*texel) << 16) & fields;
    let across = |from: &u16, to: &u16| between(doubled(from), doubled(to), x, constants);
    between(across(a, b), across(c, d), y, constants)
}

/// The same of texels that are no square of the data: apart, so that the pixel loop keeps its
/// registers.
#[cold]
#[inline(never)]
fn at_edge(
    corners: impl FnOnce() -> Option<[u16; 4]>,
    weights: [u32; 2],
    constants: [u32; 2],
) -> Option<u32> {
    Some(blended(corners()?.each_ref(), weights, constants))
}

/// Two texels, each in both halves of a word: read as one word, wherever it lies, whose lower half is
/// the first, where that is cheaper.
#[inline(always)]
fn doubled(texels: &[u16; 2]) -> [u32; 2] {
    if cfg!(all(target_endian = "little", not(target_arch = "riscv32"))) {
        let pair = bytemuck::cast::<_, u32>(*texels);
        [pair & 0xFFFF | pair << 16, pair & 0xFFFF_0000 | pair >> 16]
    } else {
        let [from, to] = texels;
        [from, to].map(|texel| u32::from(*texel) | u32::from(*texel) << 16)
    }
}

/// The fields of a texel between two others, rounded; `weight` from 0 to 31.
#[inline(always)]
fn mixed(texels: &[u16; 2], weight: u32, constants: [u32; 2]) -> u32 {
    let [fields, _] = constants;
    let [from, to] = doubled(texels).map(|doubled| doubled & fields);
    between(from, to, weight, constants)
}

/// Fields between others, rounded.
#[inline(always)]
const fn between(from: u32, to: u32, weight: u32, [fields, halves]: [u32; 2]) -> u32 {
    // What a field lends to its neighbour comes back with the sum.
    let way = to.wrapping_sub(from).wrapping_mul(weight).wrapping_add(halves);
    from.wrapping_add(way >> 5) & fields
}

/// The colour of fields.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the lower half")]
const fn shown(fields: u32) -> Color {
    Rgb565::decode((fields | fields >> 16) as u16)
}

/// Red, green and blue of fields [multiplied](crate::texture::Modulate) with those of a surface, times 512.
///
/// A channel of eight bits, and the half that lies above it, are twice the channel and one in 512ths:
/// bits of a field that is repeated once.
#[inline(always)]
const fn products(fields: u32, surface: Color) -> [u32; 3] {
    // Green stays above.
    let blue_red = fields.wrapping_mul(33) | 0x1002;
    let (blue, red) = (blue_red >> 1 & 0x1FF, blue_red >> 12 & 0x1FF);
    let green = fields >> 18 | fields >> 24 | 1;
    [
        red.wrapping_mul(surface.blue_red & 0xFFFF),
        green.wrapping_mul(surface.green >> 16),
        blue.wrapping_mul(surface.blue_red >> 16),
    ]
}

/// The colour of that.
#[inline(always)]
const fn modulated(fields: u32, surface: Color) -> Color {
    let [red, green, blue] = products(fields, surface);
    let green = green >> 9 << 16 | surface.green & Color::OPAQUE;
    Color { blue_red: blue >> 9 << 16 | red >> 9, green }
}

impl PaletteEntry for Rgb565 {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::{Environment, Modulate};

    /// Between two values of a channel, rounded; at most 63, so that 16 bits hold the sum.
    fn between_two(from: u16, to: u16, weight: u16) -> u16 {
        (from * (32 - weight) + to * weight + 16) / 32
    }

    #[test]
    fn a_square_shows_each_channel_mixed_across_and_then_down() {
        let mut bits = 1u32;
        let mut texel = || {
            bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
            match bits >> 29 {
                0 => 0,
                1 => u16::MAX,
                _ => (bits >> 16) as u16,
            }
        };
        const ROW: usize = 3;
        for case in 0..2000u32 {
            let words: [u16; 2 * ROW + 2] = core::array::from_fn(|_| texel());
            let (x, y) = (texel() & 255, texel() & 255);
            for index in 0..=ROW + 1 {
                let weights = Weights::new(x.into(), y.into());
                let known = [words[0], words[4], words[2], words[5]];
                let constants = Rgb565::CONSTANTS;
                let place = (case % 7 != 0).then_some(index);
                let corners = || Some(known);
                let got =
                    Rgb565::blend_square(&words, place, ROW, corners, weights, constants, None);
                let fits = place.is_some() && index + ROW + 2 <= words.len();
                let at = |offset: usize| words[(index + offset) % words.len()];
                let square = if fits { [at(0), at(1), at(ROW), at(ROW + 1)] } else { known };
                let channel = |shift: u32, mask: u16| {
                    let [a, b, c, d] = square.map(|texel| texel >> shift & mask);
                    let (upper, lower) = (between_two(a, b, x >> 3), between_two(c, d, x >> 3));
                    between_two(upper, lower, y >> 3) << shift
                };
                let expected = channel(11, 31) | channel(5, 63) | channel(0, 31);
                assert_eq!(got.map(Rgb565::encode), Some(expected), "{square:x?} at {x}, {y}");
                let surface = Rgb565::decode(texel());
                let lit = Rgb565::blend_square(
                    &words,
                    place,
                    ROW,
                    corners,
                    weights,
                    constants,
                    Some(surface),
                );
                let expected = got.map(|color| Modulate.combine(color, surface));
                assert_eq!(lit, expected, "{square:x?} at {x}, {y}, under {surface:x?}");
            }
        }
    }

    #[test]
    fn texels_are_multiplied_as_their_colours_are() {
        for level in 0..64u16 {
            let texel = (level & 31) << 11 | level << 5 | (31 - (level & 31));
            let color = Rgb565::decode(texel);
            for channel in 0..=0xFFFFu32 {
                let blue_red = channel << 16 | (0xFFFF - channel);
                let surface = Color { blue_red, green: channel << 16 | (channel * 7) & 0xFFFF };
                let expected = Modulate.combine(color, surface);
                let got = <Rgb565 as TexelFormat>::modulate(texel, surface);
                assert_eq!(got, expected, "{texel:04x} and {surface:x?}");
            }
        }
    }

    #[test]
    fn squares_are_the_same_texels_however_they_are_read() {
        let mut word = 7;
        let words: [u16; 12] = core::array::from_fn(|_| {
            word += 5000;
            word
        });
        for row in 0..14 {
            for index in (0..14).chain([usize::MAX - 1, usize::MAX]) {
                let apart = square_apart(&words, index, row).map(|texels| texels.map(|t| *t));
                let fits = index.checked_add(row + 1).is_some_and(|last| last < words.len());
                let expected = fits.then(|| [0, 1, row, row + 1].map(|i| words[index + i]));
                assert_eq!(apart, expected, "texel {index}, rows of {row}");
                if index < 14 {
                    let pairs = square_at(&words, index, row);
                    let together = pairs.map(|[[a, b], [c, d]]| [*a, *b, *c, *d]);
                    assert_eq!(together, expected, "texel {index}, rows of {row}, by pairs");
                }
            }
        }
    }

    #[test]
    fn two_texels_are_doubled_in_their_order() {
        for [from, to] in [[0x1234u16, 0xFEDC], [0, u16::MAX], [u16::MAX, 0]] {
            let twice = |texel: u16| u32::from(texel) * 0x0001_0001;
            assert_eq!(doubled(&[from, to]), [from, to].map(twice), "{from:x}, {to:x}");
        }
    }
}
