//! Rows of pixels, in every state's way.

use super::*;
use crate::frame::ReadWrite;
use crate::raster::Scanline;
use crate::shade::{
    AllChannels, AnyDither, Average, Counting, Dither4, Dither8, Less, LessEqual, Output, ReadOnly,
    Replace, States, Stats, Undithered,
};
use crate::Rgb565;

const LENGTH: usize = 40;

/// Draws a row at once, and does the same pixel by pixel.
fn check<D: DepthTest<Access = ReadWrite>, B: Blend, W: Dither>(
    depth: &D,
    output: &Output<B, W, AllChannels>,
    codes: &[u16],
    mut word: impl FnMut() -> u32,
) {
    let (x, y) = ((word() >> 20).cast_signed(), (word() >> 20).cast_signed());
    let (z, z_step) = (word(), word() >> (word() & 31));
    let first = SmoothColor::of_bits(word(), word());
    let step = (word() & 0x00FF_00FF, word() >> 8);
    let stored: [u16; LENGTH] = core::array::from_fn(|_| (word() >> 16) as u16);

    let mut expected = (stored, [0; LENGTH], 0);
    expected.1[..codes.len()].copy_from_slice(codes);
    let (mut along, mut value) = (z, first);
    for (i, at) in (0..codes.len()).zip(x..) {
        let (pixel, cell) = (&mut expected.0[i], &mut expected.1[i]);
        let code = (along >> 16) as u16;
        if depth.passes(code, *cell) {
            let thresholds = output.dither.thresholds(at, y);
            *pixel = if output.dims() {
                let mut raised = value;
                let raise = W::first(&thresholds).map_or(Color::NOTHING, Rgb565::raise);
                raised.step(&(raise.blue_red, raise.green));
                Rgb565::pack(raised.color())
            } else {
                let source = output.blend.source::<Rgb565>(value.color());
                output.pixel::<Rgb565>(&source, pixel, &thresholds)
            };
            if depth.writes() {
                *cell = code;
            }
            expected.2 += 1;
        }
        along = along.wrapping_add(z_step);
        value.step(&step);
    }

    let (mut pixels, mut cells) = (stored, [0; LENGTH]);
    cells[..codes.len()].copy_from_slice(codes);
    let mut stats = Stats::default();
    Row::<States<D, Counting<'_>, Scanline, Output<B, W, AllChannels>>, Rgb565, SmoothColor> {
        x,
        y,
        pixels: &mut pixels[..codes.len()],
        cells: &mut cells[..codes.len()],
        z,
        z_step,
        may_be_level: true,
        varying: first,
        step,
        behind: None,
        depth,
        output,
        counter: &mut Counting(&mut stats),
    }
    .each_as_is();
    assert_eq!((pixels, cells, stats.pixels), expected, "{} pixels at {x}, {y}", codes.len());
}

#[test]
fn rows_that_are_dithered_or_blended_are_what_their_pixels_are_one_by_one() {
    let mut bits = 1u32;
    let mut word = || {
        bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
        bits
    };
    let mask = AllChannels;
    for case in 0..3000 {
        let codes: [u16; LENGTH] = core::array::from_fn(|_| (word() >> 16) as u16);
        let codes = &codes[..case % (LENGTH + 1)];
        let read_only = ReadOnly::new(LessEqual);
        check(&Less, &Output { blend: Replace, dither: Dither4, mask }, codes, &mut word);
        check(&read_only, &Output { blend: Replace, dither: Dither8, mask }, codes, &mut word);
        for dither in [AnyDither::Undithered, AnyDither::Four, AnyDither::Eight] {
            check(&Less, &Output { blend: Replace, dither, mask }, codes, &mut word);
        }
        check(&Less, &Output { blend: Average, dither: Undithered, mask }, codes, &mut word);
        check(&read_only, &Output { blend: Average, dither: Dither4, mask }, codes, &mut word);
    }
}
