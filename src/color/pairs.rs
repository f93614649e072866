//! Two RGB565 pixels in a word, met by one source colour.

use super::{Color, EIGHTS};

/// Three fields of one pixel and the other, with room for more bits: blue and red of the lower,
/// green of the upper. The others are in the same places when both halves change places.
pub(super) const FIELDS: u32 = 0x07E0_F81F;

/// The bits above eight of blue at bit 0, red at bit 11 and green at bit 22.
const GUARDS: u32 = 1 << 8 | 1 << 19 | 1 << 30;

/// Both pixels with their bytes swapped.
#[inline(always)]
const fn swapped<const SWAP: bool>(pair: u32) -> u32 {
    if SWAP {
        pair.swap_bytes().rotate_left(16)
    } else {
        pair
    }
}

/// Replaces pixels by what `change` makes of two in a word, neither of which knows of the other;
/// `TURN` pairs at a turn; `SWAP` where bytes are stored the other way round than the machine's.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "half of a pair")]
pub(super) fn change_pairs<const SWAP: bool, const TURN: usize>(
    pixels: &mut [u16],
    change: impl Fn(u32) -> u32,
) {
    let change = |pair: u32| swapped::<SWAP>(change(swapped::<SWAP>(pair)));
    let (head, pairs, tail) = bytemuck::pod_align_to_mut::<u16, u32>(pixels);
    for pixel in [head, tail].into_iter().flat_map(<[u16]>::first_mut) {
        *pixel = change(u32::from(*pixel)) as u16;
    }
    let mut rest = pairs;
    if TURN > 1 {
        let (turns, pairs) = rest.as_chunks_mut::<TURN>();
        for turn in turns {
            *turn = turn.map(change);
        }
        rest = pairs;
    }
    for pair in rest {
        *pair = change(*pair);
        core::hint::black_box(());
    }
}

/// Both pixels of a pair by what `change` makes of [`FIELDS`].
#[inline(always)]
fn by_fields(pair: u32, change: impl Fn(u32) -> u32) -> u32 {
    change(pair & FIELDS) | change(pair.rotate_left(16) & FIELDS).rotate_left(16)
}

/// Fields widened to eight bits, at bits 0, 11 and 22.
#[inline(always)]
const fn widened(fields: u32) -> u32 {
    let repeated = fields >> 2 & 0x3807 | fields >> 3 & 0x00C0_0000;
    (fields << 3).wrapping_add(repeated)
}

/// Eight bits of each channel, placed like [`widened`] fields.
#[inline(always)]
const fn placed(color: Color) -> u32 {
    (color.green() as u32) << 22 | (color.red() as u32) << 11 | color.blue() as u32
}

/// The lower eight bits of the numbers whose guard is set.
#[inline(always)]
const fn below(guards: u32) -> u32 {
    guards.wrapping_sub(guards >> 8)
}

/// The sum of each pixel and a colour, at most full.
#[inline(never)]
pub(crate) fn add_to_pairs<const SWAP: bool>(pixels: &mut [u16], color: Color) {
    let add = placed(color);
    change_pairs::<SWAP, 1>(pixels, |pair| {
        by_fields(pair, |fields| {
            let sum = widened(fields).wrapping_add(add);
            (sum | below(sum & GUARDS)) >> 3 & FIELDS
        })
    });
}

/// Each pixel less a colour, at least zero.
#[inline(never)]
pub(crate) fn subtract_from_pairs<const SWAP: bool>(pixels: &mut [u16], color: Color) {
    let guarded = GUARDS.wrapping_sub(placed(color));
    change_pairs::<SWAP, 1>(pixels, |pair| {
        by_fields(pair, |fields| {
            let difference = widened(fields).wrapping_add(guarded);
            (difference & below(difference & GUARDS)) >> 3 & FIELDS
        })
    });
}

/// The product of each pixel and a colour, where full is one.
#[inline(never)]
pub(crate) fn multiply_pairs<const SWAP: bool>(pixels: &mut [u16], color: Color) {
    let [red, green, blue] = [color.red(), color.green(), color.blue()].map(u32::from);
    // One channel of both pixels, eight bits in sixteen: the product and its rounded 255th.
    let product = |stored: u32, by: u32| {
        let product = stored.wrapping_mul(by).wrapping_add(0x0080_0080);
        product.wrapping_add(product >> 8 & EIGHTS)
    };
    // Five and six bits, repeated into eight.
    let five = |stored: u32| stored.wrapping_mul(33) >> 2 & EIGHTS;
    let six = |stored: u32| stored.wrapping_mul(65) >> 4 & EIGHTS;
    change_pairs::<SWAP, 1>(pixels, |pair| {
        let red = product(five(pair >> 11 & 0x001F_001F), red);
        let green = product(six(pair >> 5 & 0x003F_003F), green);
        let blue = product(five(pair & 0x001F_001F), blue);
        red & 0xF800_F800 | green >> 5 & 0x07E0_07E0 | blue >> 11 & 0x001F_001F
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Format, Rgb565, Rgb565Be};
    use crate::shade::{Add, Blend, Multiply, Subtract};

    fn check<F: Format<Raw = u16>>(mode: &impl Blend, color: Color, stored: [u16; 3]) {
        let source = mode.source::<F>(color);
        let expected = stored.map(|stored| F::pack(mode.blend::<F>(&source, stored)));
        for length in 1..=3 {
            let mut pixels = stored;
            mode.fill::<F>(&source, &mut pixels[..length]);
            assert_eq!(pixels[..length], expected[..length], "{color:?} on {stored:04x?}");
        }
    }

    fn check_all(color: Color, stored: [u16; 3]) {
        check::<Rgb565>(&Add, color, stored);
        check::<Rgb565>(&Subtract, color, stored);
        check::<Rgb565>(&Multiply, color, stored);
        check::<Rgb565Be>(&Add, color, stored);
        check::<Rgb565Be>(&Subtract, color, stored);
        check::<Rgb565Be>(&Multiply, color, stored);
    }

    #[test]
    fn every_channel_of_every_colour_beside_full_and_empty_ones() {
        for value in 0..=255 {
            let color = Color::new(value, value, value);
            for step in 0..64 {
                let stored = (step & 31) << 11 | step << 5 | (step & 31);
                check_all(color, [stored, !0, stored]);
                check_all(color, [0, stored, 0]);
            }
        }
    }

    #[test]
    fn random_pixels_meet_random_colours_as_one_by_one() {
        let mut bits = 1u32;
        let mut word = || {
            bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
            bits
        };
        for _ in 0..50_000 {
            let color = Color { blue_red: word(), green: word() };
            check_all(color, [word(), word(), word()].map(|word| (word >> 16) as u16));
        }
    }
}
