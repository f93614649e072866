//! Rows in one colour, under a depth test.

use super::row::{Access, Row};
use super::{Counter, DepthTest, State, Stepped};
use crate::color::Format;
use crate::frame::DepthAccess;
use crate::math::BY_HALVES;

/// Pixels that the loop over rows of one depth takes at a turn.
const TURN: usize = 4;

/// Pixels from which on a row is long: what entering that loop costs is less than what it spares.
const LONG: usize = 12;

impl<S: State, F: Format, V: Stepped> Row<'_, S, F, V> {
    /// Stores one value in each pixel that passes the depth test.
    #[inline(always)]
    pub(super) fn fill_visible(self, raw: F::Raw) {
        let Self { pixels, cells, z, z_step, behind, depth, counter, .. } = self;
        let is_level = self.may_be_level && pixels.len() >= LONG && z_step == 0;
        let cells = if !is_level && (BY_HALVES || behind.is_some() || pixels.len() == 1) {
            // With few registers, the loop over both is the longer one; of lines, it is none; from
            // the last pixel on there is a shorter one.
            cells
        } else {
            match <Access<S>>::codes(cells) {
                Ok(codes) if is_level => {
                    return fill_level::<S::Depth, F, _>(pixels, codes, z, raw, depth, counter);
                }
                Ok(codes) => {
                    return fill_sloping(pixels, codes, (z, z_step), raw, depth, counter);
                }
                Err(cells) => cells,
            }
        };
        let row = Self { pixels, cells, z, counter, ..self };
        row.each_packed(|_| Some(raw));
    }
}

/// Stores one value in a pixel that passes the depth test.
#[inline(always)]
fn store_visible<T>(
    code: u16,
    raw: T,
    pixel: &mut T,
    stored: &mut u16,
    depth: &impl DepthTest,
    counter: &mut impl Counter,
) {
    if depth.passes(code, *stored) {
        if depth.writes() {
            *stored = code;
        }
        *pixel = raw;
        counter.pixels(1);
    }
}

/// Stores one value in each pixel of a row that passes the depth test.
#[inline(always)]
fn fill_sloping<T: Copy>(
    pixels: &mut [T],
    codes: &mut [u16],
    (mut z, z_step): (u32, u32),
    raw: T,
    depth: &impl DepthTest,
    counter: &mut impl Counter,
) {
    pixels.iter_mut().zip(codes).for_each(|(pixel, stored)| {
        store_visible((z >> 16) as u16, raw, pixel, stored, depth, counter);
        z = z.wrapping_add(z_step);
        // Not unrolled, here and below: the copies would need more registers.
        core::hint::black_box(());
    });
}

/// Stores one value in each pixel of a long row of one depth that passes the depth test, a few at
/// a turn: apart, so that other rows pay nothing for it.
#[inline(never)]
fn fill_level<D: DepthTest, F: Format, C: Counter>(
    pixels: &mut [F::Raw],
    codes: &mut [u16],
    z: u32,
    raw: F::Raw,
    depth: &D,
    counter: &mut C,
) {
    let code = (z >> 16) as u16;
    let mut store = |(pixel, stored)| store_visible(code, raw, pixel, stored, depth, counter);
    let (turns, rest) = pixels.as_chunks_mut::<TURN>();
    let (code_turns, code_rest) = codes.as_chunks_mut::<TURN>();
    for (pixels, codes) in turns.iter_mut().zip(code_turns) {
        pixels.iter_mut().zip(codes).for_each(&mut store);
        core::hint::black_box(());
    }
    for pixel in rest.iter_mut().zip(code_rest) {
        store(pixel);
        core::hint::black_box(());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Color;
    use crate::shade::{Counting, LessEqual, Output, ReadOnly, States, Stats};
    use crate::{raster::Scanline, Rgb565};

    /// Fills a row under a test in every way, and does the same pixel by pixel.
    fn check<D: DepthTest<Access = crate::frame::ReadWrite>>(
        depth: D,
        codes: &[u16],
        z: u32,
        z_step: u32,
    ) {
        const COLOR: Color = Color::new(255, 0, 0);
        let (mut expected, mut visible) = (([7u16; 64], [0u16; 64]), 0);
        let mut along = z;
        for (i, &stored) in codes.iter().enumerate() {
            let code = (along >> 16) as u16;
            let passes = depth.passes(code, stored);
            visible += u32::from(passes);
            expected.0[i] = if passes { 0xF800 } else { 7 };
            expected.1[i] = if passes && depth.writes() { code } else { stored };
            along = along.wrapping_add(z_step);
        }
        let ways = [
            ("as this core does", false),
            ("by codes", false),
            ("by pixels", false),
            ("as this core does", true),
            ("by pixels", true),
        ];
        for (way, from_last) in ways {
            let (mut pixels, mut cells) = ([7u16; 64], [0u16; 64]);
            let (pixels, cells) = (&mut pixels[..codes.len()], &mut cells[..codes.len()]);
            cells.copy_from_slice(codes);
            let (output, mut stats) = (Output::default(), Stats::default());
            let mut counter = Counting(&mut stats);
            if way == "by codes" {
                fill_sloping(pixels, cells, (z, z_step), 0xF800, &depth, &mut counter);
            } else {
                let row = Row::<States<D, Counting<'_>, Scanline, Output>, Rgb565, ()> {
                    x: 0,
                    y: 0,
                    pixels,
                    cells,
                    z,
                    z_step,
                    may_be_level: true,
                    varying: (),
                    step: (),
                    behind: from_last.then_some(((), along)),
                    depth: &depth,
                    output: &output,
                    counter: &mut counter,
                };
                if way == "by pixels" {
                    row.each_packed(|_| Some(0xF800));
                } else {
                    row.fill(COLOR);
                }
            }
            let case = (way, from_last, z, z_step);
            assert_eq!(pixels, &expected.0[..codes.len()], "colours {case:x?}");
            assert_eq!(cells, &expected.1[..codes.len()], "codes {case:x?}");
            assert_eq!(stats.pixels, visible, "pixels {case:x?}");
        }
    }

    #[test]
    fn rows_of_all_lengths_and_slopes_are_filled_where_they_are_visible() {
        let mut bits = 1u32;
        let mut word = || {
            bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
            bits
        };
        for case in 0..2000 {
            let z = if case % 5 == 0 { u32::MAX } else { word() };
            let z_step = if case % 2 == 0 { 0 } else { word() };
            let mut codes = [0u16; 64];
            for code in &mut codes {
                let near = (z >> 16) as u16;
                *code = match word() >> 30 {
                    0 => near,
                    1 => near.wrapping_add(1),
                    2 => near.wrapping_sub(1),
                    _ => (word() >> 16) as u16,
                };
            }
            let codes = &codes[..case % 65];
            check(crate::Less, codes, z, z_step);
            check(ReadOnly::new(LessEqual), codes, z, z_step);
        }
    }
}
