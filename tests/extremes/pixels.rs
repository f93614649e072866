//! Every stored pixel under every alpha, and every colour in every cell of a dither.

use crate::support::Random;
use crate::tally::{exhaustive, is_thorough};
use microraster::raster::ScreenVertex;
use microraster::{
    Add, Alpha, Average, Blend, Color, ConstantAlpha, Dither, Dither4, Dither8, Flat, Format,
    Frame, Multiply, Premultiplied, Rgb565, ScreenPass, Size, Subtract,
};

/// Steps of red, green and blue.
const FULL: [i32; 3] = [31, 63, 31];

fn steps(raw: u16) -> [i32; 3] {
    [raw >> 11, raw >> 5 & 63, raw & 31].map(i32::from)
}

/// Alpha in 32nds, as RGB565 resolves it; ties between 32nds go to the side of the 256ths.
fn in_32nds(alpha: u8) -> i32 {
    (i32::from(alpha) + i32::from(alpha > 127) + 4) / 8
}

/// A channel by its definition, in `255 x 32`nds of a step. `source` is of 255, alpha of 32, what
/// is stored and the result of `full`.
type Definition = fn(source: i32, alpha: i32, stored: i32, full: i32) -> i32;

/// What stands between two steps that may both be stored.
const STEP: i32 = 255 * 32;

/// Tries a mode with a colour on every stored pixel; fails where a channel is a step or more
/// beside the definition.
fn check(mode: impl Blend + std::fmt::Debug, color: Color, alpha: u8, definition: Definition) {
    let prepared = mode.source::<Rgb565>(color);
    let source = [color.red(), color.green(), color.blue()].map(i32::from);
    // Where a premultiplied colour is brighter than its alpha allows, a sixteenth more.
    let glows = source.iter().any(|channel| *channel > i32::from(color.alpha()));
    let bound = if glows { STEP + STEP / 16 } else { STEP };
    for stored in 0..=u16::MAX {
        let got = steps(Rgb565::pack(mode.blend::<Rgb565>(&prepared, stored)));
        let beneath = steps(stored);
        for k in 0..3 {
            let exact = definition(source[k], in_32nds(alpha), beneath[k], FULL[k]);
            let exact = exact.clamp(0, FULL[k] * STEP);
            let off = (got[k] * STEP - exact).abs();
            assert!(off < bound, "{mode:?} of {color:?} over {stored:04x}: {}", got[k]);
        }
    }
}

fn over(source: i32, alpha: i32, stored: i32, full: i32) -> i32 {
    source * full * alpha + stored * 255 * (32 - alpha)
}

/// Draws with a constant alpha into a frame of all stored values, in runs, and compares with the
/// same pixel by pixel.
fn check_run(color: Color, alpha: u8) {
    let mode = ConstantAlpha(alpha);
    let prepared = mode.source::<Rgb565>(color);
    let mut pixels: Vec<u16> = (0..=u16::MAX).collect();
    let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(256, 256)).expect("it fits");
    let at = |x: i32, y: i32| (ScreenVertex::from_bits(16 * x, 16 * y, 0), color);
    let triangle = [at(0, 0), at(512, 0), at(0, 512)];
    ScreenPass::new().blend(mode).triangle(&mut frame, &Flat::colored(), &triangle);
    for (stored, got) in (0..=u16::MAX).zip(&pixels) {
        let expected = Rgb565::pack(mode.blend::<Rgb565>(&prepared, stored));
        assert_eq!(*got, expected, "{mode:?} of {color:?} over {stored:04x}");
    }
}

#[test]
fn every_565_pixel_under_every_alpha_is_within_a_step_of_the_definition() {
    exhaustive("RGB565 pixels under every alpha and mode", || {
        let mut random = Random(51);
        let mut tried = 0;
        let step = if is_thorough() { 1 } else { 51 };
        for alpha in (0..=255_u8).step_by(step) {
            let [r, g, b, ..] = random.next().to_le_bytes();
            for source in [[0, 0, 0], [255, 255, 255], [255, 0, 128], [r, g, b]] {
                let color = Color::new(source[0], source[1], source[2]);
                check(Alpha, color.with_alpha(alpha), alpha, over);
                check(ConstantAlpha(alpha), color, alpha, over);
                check(
                    Premultiplied,
                    color.with_alpha(alpha),
                    alpha,
                    |source, alpha, stored, full| source * full * 32 + stored * 255 * (32 - alpha),
                );
                check_run(color, alpha);
                tried += 4 * 65_536;
            }
            // Alpha has no say in these: the source is what is gone through.
            let [g, b, ..] = random.next().to_le_bytes();
            let color = Color::new(alpha, g, b);
            check(Add, color, 255, |source, _, stored, full| (source * full + stored * 255) * 32);
            check(Subtract, color, 255, |source, _, stored, full| {
                (stored * 255 - source * full) * 32
            });
            check(Multiply, color, 255, |source, _, stored, _| source * stored * 32);
            check(Average, color, 255, |source, _, stored, full| {
                (source * full + stored * 255) * 16
            });
            tried += 4 * 65_536;
        }
        tried
    });
}

/// The Bayer matrix by its own recursion: four copies of the smaller one, times four, and 0, 2, 3
/// and 1 more.
fn bayer(size: usize) -> Vec<Vec<u32>> {
    if size == 1 {
        return vec![vec![0]];
    }
    let (half, small) = (size / 2, bayer(size / 2));
    let more = [[0, 2], [3, 1]];
    let at = |x: usize, y: usize| 4 * small[y % half][x % half] + more[y / half][x / half];
    (0..size).map(|y| (0..size).map(|x| at(x, y)).collect()).collect()
}

/// Tries all reds with all blues, and all greens, in every cell; returns how many that were.
fn check_cells(dither: impl Dither, size: usize) -> u64 {
    let matrix = bayer(size);
    let mut tried = 0;
    let step = if is_thorough() { 1 } else { 15 };
    for (y, row) in matrix.iter().enumerate() {
        let mut thresholds = dither.thresholds(0, y as i32);
        for (x, rank) in row.iter().enumerate() {
            let first = first_of(&dither, &thresholds);
            // The rank's place among the thresholds, from 9 to 245 256ths.
            let last = (size * size - 1) as u32;
            let threshold = 9 + (rank * 236 + last / 2) / last;
            assert_eq!(first & 0xFF, threshold, "{x}, {y} of {size}");
            for red in 0..=255_u8 {
                for blue in (0..=255_u8).step_by(step) {
                    let green = red ^ blue;
                    let got = steps(Rgb565::pack_dithered(Color::new(red, green, blue), first));
                    let colors = [red, green, blue].map(i32::from);
                    for k in 0..3 {
                        let off = got[k] * 255 - colors[k] * FULL[k];
                        assert!(off.abs() < 255, "{got:?} of {colors:?} at {x}, {y}");
                        let is_end = colors[k] == 0 || colors[k] == 255;
                        assert!(!is_end || off == 0, "{got:?} of {colors:?} at {x}, {y}");
                    }
                    tried += 1;
                }
            }
            step_of(&dither, &mut thresholds);
        }
    }
    tried
}

fn first_of<W: Dither>(_: &W, thresholds: &W::Thresholds) -> u32 {
    W::first(thresholds).expect("it dithers")
}

fn step_of<W: Dither>(_: &W, thresholds: &mut W::Thresholds) {
    W::step(thresholds);
}

#[test]
fn every_colour_in_every_cell_of_a_dither_is_the_step_below_or_above() {
    exhaustive("colours in every cell of both dithers", || {
        check_cells(Dither4, 4) + check_cells(Dither8, 8)
    });
}
