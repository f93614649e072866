//! Styles of lines against their definitions, pixel by pixel.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "pixels of a small picture"
)]

#[path = "support/lines.rs"]
mod lines;
mod support;

use lines::{draw_lines, line_pixels, seen};
use microraster::host::reference::{Reference, State};
use microraster::raster::ScreenVertex;
use microraster::{
    Always, Color, Flat, Format, Frame, Gouraud, LineStyle, Midpoint, Rect, Rectangle, Rgb,
    Rgba8888, ScreenPass, Size, Smooth, Stats, Stippled, Thin, Wide,
};
use support::{any_corner, Random};

const SIZE: Size = Size::new(20, 16);
const PIXELS: usize = 20 * 16;

type Shaded = (ScreenVertex, Color);

fn white(v: ScreenVertex) -> Shaded {
    (v, Rgb::WHITE.into())
}

/// A format that keeps alpha.
struct Alphas;

impl Format for Alphas {
    type Raw = u32;

    fn pack(color: Color) -> u32 {
        0x100 | u32::from(color.alpha())
    }

    fn unpack(_: u32) -> Color {
        Color::new(0, 0, 0)
    }

    fn fill(pixels: &mut [u32], raw: u32) {
        pixels.fill(raw);
    }
}

/// What a drawing makes of a picture of zeros, and what it counts.
fn picture<F: Format<Raw = u32>>(
    draw: impl FnOnce(&mut Frame<'_, F>, &mut Stats),
) -> ([u32; PIXELS], Stats) {
    let (mut pixels, mut stats) = ([0; PIXELS], Stats::default());
    draw(&mut Frame::new(&mut pixels, SIZE).expect("the buffer fits"), &mut stats);
    let sum = stats.degenerate + stats.outside + stats.skipped + stats.drawn;
    assert_eq!(stats.lines, sum, "every line became something");
    (pixels, stats)
}

/// The pixels that are not zero.
fn set(pixels: &[u32]) -> Vec<(i32, i32)> {
    let set = pixels.iter().enumerate().filter(|(_, word)| **word != 0);
    set.map(|(i, _)| (i as i32 % 20, i as i32 / 20)).collect()
}

/// The pixels of a line, and of a pixel twice none.
fn drawn(style: impl LineStyle, line: [ScreenVertex; 2]) -> Vec<(i32, i32)> {
    let (pixels, stats) = picture::<Rgba8888>(|frame, stats| {
        ScreenPass::new().count(stats).lines(frame, &Flat::colored(), style, &[line.map(white)]);
    });
    let pixels = set(&pixels);
    assert_eq!(stats.pixels as usize, pixels.len(), "a pixel twice: {line:?}");
    pixels
}

/// The pixels of the picture of which something holds.
fn pixels_where(holds: impl Fn(i32, i32) -> bool) -> Vec<(i32, i32)> {
    let all = (0..16).flat_map(|y| (0..20).map(move |x| (x, y)));
    all.filter(|&(x, y)| holds(x, y)).collect()
}

fn sides([a, b]: &[ScreenVertex; 2]) -> (i32, i32) {
    (b.x.to_bits() - a.x.to_bits(), b.y.to_bits() - a.y.to_bits())
}

#[test]
fn wide_lines_are_copies_of_thin_ones_beside_each_other() {
    let mut random = Random(41);
    for i in 0..12_000 {
        let line = [(); 2].map(|()| any_corner(&mut random, i % 10, SIZE));
        let width = [1, 2, 3, 4, 7, 31, 32][(i / 10 % 7) as usize];
        let expected = line_pixels(SIZE, width, line);
        assert_eq!(drawn(Wide(width as u8), line), expected, "{width} wide: {line:?}");
    }
    let line = [(3, 200), (300, 17)].map(|(x, y)| ScreenVertex::from_bits(x, y, 0));
    assert_eq!(drawn(Wide(0), line), drawn(Thin, line), "no width is the least");
    assert_eq!(drawn(Wide(255), line), drawn(Wide(32), line), "beyond the widest");
}

#[test]
fn midpoint_lines_are_the_nearest_pixels() {
    let mut random = Random(42);
    for i in 0..20_000 {
        let class = [0, 1, 4, 5, 6, 8][i % 6];
        let line = [(); 2].map(|()| any_corner(&mut random, class, SIZE));
        let [(ax, ay), (bx, by)] =
            line.map(|v| (i64::from(v.x.to_bits() >> 4), i64::from(v.y.to_bits() >> 4)));
        let (w, h) = (bx - ax, by - ay);
        let by_columns = w.abs() >= h.abs();
        let (along, across) = if by_columns { (w, h) } else { (h, w) };
        let expected = pixels_where(|x, y| {
            let (x, y) = (i64::from(x), i64::from(y));
            let (at, minor) = if by_columns { (x - ax, y - ay) } else { (y - ay, x - ax) };
            let within = if along > 0 { 0 <= at && at < along } else { along < at && at <= 0 };
            // Twice the way across, times the length, and a half: rounded down.
            within
                && minor
                    == (2 * at * across * along.signum() + along.abs()).div_euclid(2 * along.abs())
        });
        assert_eq!(drawn(Midpoint, line), expected, "{line:?}");
    }
}

#[test]
fn stipple_counts_pixels_along_lines_and_goes_on_in_strips() {
    let mut random = Random(43);
    for i in 0..1_500 {
        let corners: Vec<_> = (0..4)
            .map(|_| ScreenVertex::from_bits(random.range(-500, 800), random.range(-500, 800), 0))
            .collect();
        let (pattern, factor) = (random.next() as u16, [1, 2, 3, 255][i % 4]);
        let strip = i % 2 == 0;
        let lines: Vec<_> =
            corners.windows(2).map(|pair| [pair[0], pair[1]].map(|v| (v, 0.0))).collect();
        let keeps = |step: u32| pattern >> (step / u32::from(factor) % 16) & 1 != 0;
        let mut exact = Reference::new(SIZE, [0.0; 3]);
        // A strip's pixels are counted through, those of lines by line.
        for lines in lines.chunks(if strip { lines.len() } else { 1 }) {
            draw_lines(&mut exact, State::PLAIN, 1, lines, keeps);
        }
        let expected = seen(&exact);
        let style = Stippled::new(pattern, factor, Thin);
        let corners: Vec<Shaded> = corners.into_iter().map(white).collect();
        let (pixels, _) = picture::<Rgba8888>(|frame, stats| {
            let mut pass = ScreenPass::new().count(stats);
            if strip {
                pass.line_strip(frame, &Flat::colored(), style, &corners);
            } else {
                let lines: Vec<[Shaded; 2]> = corners.windows(2).map(|w| [w[0], w[1]]).collect();
                pass.lines(frame, &Flat::colored(), style, &lines);
            }
        });
        assert_eq!(set(&pixels), expected, "{pattern:016b} by {factor}: {corners:?}");
    }
}

/// Where a pixel's centre lies from a line, in pixels: along it and beside it.
fn from_line(line: &[ScreenVertex; 2], x: i32, y: i32) -> (f64, f64) {
    let (w, h) = sides(line);
    let (w, h) = (f64::from(w) / 16.0, f64::from(h) / 16.0);
    let length = w.hypot(h);
    let (dx, dy) = (
        f64::from(x) + 0.5 - f64::from(line[0].x.to_bits()) / 16.0,
        f64::from(y) + 0.5 - f64::from(line[0].y.to_bits()) / 16.0,
    );
    ((dx * w + dy * h) / length, (dx * h - dy * w) / length)
}

/// How far beyond a line's ends a pixel's centre lies; negative between them.
fn beyond(line: &[ScreenVertex; 2], along: f64) -> f64 {
    let (w, h) = sides(line);
    (-along).max(along - f64::from(w).hypot(f64::from(h)) / 16.0)
}

#[test]
fn rectangles_are_as_wide_as_they_say_in_every_direction() {
    let mut random = Random(44);
    let mut inside = 0;
    for i in 0..12_000 {
        let class = [0, 1, 4, 5, 6, 8][i % 6];
        let line = [(); 2].map(|()| any_corner(&mut random, class, SIZE));
        if sides(&line) == (0, 0) {
            assert!(drawn(Rectangle(4), line).is_empty(), "a line without length");
            continue;
        }
        let width = random.range(1, 32);
        let pixels = drawn(Rectangle(width as u8), line);
        // Half a subpixel of rounding on either axis, and 2^-12.8 of half the width. Ends turn with
        // the way across, by as much of its length as rounding is of it.
        let error = 0.5_f64.hypot(0.5) / 16.0 + f64::from(width) / 2.0 / 7100.0 + 1e-9;
        for (x, y) in pixels_where(|_, _| true) {
            let (along, beside) = from_line(&line, x, y);
            let out = (beside.abs() - f64::from(width) / 2.0).max(beyond(&line, along));
            let is_drawn = pixels.contains(&(x, y));
            assert!(out > -error || is_drawn, "{out} outside is missing: {x}, {y}, {line:?}");
            assert!(out < error || !is_drawn, "{out} outside is drawn: {x}, {y}, {line:?}");
            inside += usize::from(is_drawn);
        }
    }
    assert!(inside > 50_000, "hardly tested: {inside}");
}

#[test]
fn the_alpha_of_smooth_lines_is_their_coverage() {
    let mut random = Random(45);
    let mut partly = 0;
    for i in 0..12_000 {
        let class = [0, 1, 4, 5, 6, 8][i % 6];
        let line = [(); 2].map(|()| any_corner(&mut random, class, SIZE));
        if sides(&line) == (0, 0) {
            continue;
        }
        let width = random.range(1, 32);
        let (pixels, _) = picture::<Alphas>(|frame, stats| {
            let mut pass = ScreenPass::new().count(stats);
            pass.lines(frame, &Flat::colored(), Smooth(width as u8), &[line.map(white)]);
        });
        for (i, word) in pixels.iter().enumerate() {
            let (x, y) = (i as i32 % 20, i as i32 / 20);
            let (along, beside) = from_line(&line, x, y);
            let out = beyond(&line, along);
            if out.abs() < 0.05 {
                // Ends are cut by rounded sides.
                continue;
            }
            let coverage = (f64::from(width) / 2.0 + 0.5 - beside.abs()).clamp(0.0, 1.0);
            let expected = if out < 0.0 { coverage } else { 0.0 };
            let got = f64::from(word & 0xFF) / 255.0;
            assert!((got - expected).abs() <= 0.01, "{got} for {expected}: {x}, {y}, {line:?}");
            partly += usize::from(expected > 0.1 && expected < 0.9);
        }
    }
    assert!(partly > 5_000, "hardly tested: {partly}");
}

#[test]
fn scissors_bands_and_strides_change_no_bit() {
    fn check(random: &mut Random, style: impl LineStyle) {
        let corners: Vec<Shaded> = (0..3)
            .map(|_| {
                let color =
                    Rgb::new(random.next() as u8, random.next() as u8, random.next() as u8 | 1);
                let v = any_corner(random, 6, SIZE);
                (ScreenVertex::new(v.x, v.y, random.next() as u16), color.into())
            })
            .collect();
        let draw = |scissors: &[Rect], stride: usize| {
            let (mut pixels, mut depth) = ([0; PIXELS], vec![0; stride * 16]);
            let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
            let mut frame =
                frame.with_depth_stride(&mut depth, stride as u32).expect("the buffer fits");
            for scissor in scissors {
                frame.set_scissor(*scissor);
                let mut pass = ScreenPass::new().depth(Always);
                pass.line_strip(&mut frame, &Gouraud::colored(), style, &corners);
            }
            let depth: Vec<u16> =
                depth.chunks(stride).flat_map(|row| row[..20].iter().copied()).collect();
            (pixels, depth)
        };
        let (x, y) = (random.range(0, 20), random.range(0, 16));
        let whole = draw(&[Rect::from_size(SIZE)], 20);
        let quarters = [
            Rect::new(0, 0, x, y),
            Rect::new(x, 0, 20, y),
            Rect::new(0, y, x, 16),
            Rect::new(x, y, 20, 16),
        ];
        assert!(whole == draw(&quarters, 20), "cut at {x}, {y}: {corners:?}");
        assert!(whole == draw(&[Rect::from_size(SIZE)], 27), "another stride: {corners:?}");
        let mut bands = ([0; PIXELS], vec![0; PIXELS]);
        let rows = bands.0.chunks_mut(20 * 5).zip(bands.1.chunks_mut(20 * 5));
        for (first, (pixels, depth)) in (0..).step_by(5).zip(rows) {
            let size = Size::new(20, (pixels.len() / 20) as u16);
            let frame = Frame::<Rgba8888>::new(pixels, size).expect("the buffer fits");
            let frame = frame.with_depth(depth).expect("the buffer fits");
            let mut frame = frame.band(first, 16).expect("a band of the picture");
            let mut pass = ScreenPass::new().depth(Always);
            pass.line_strip(&mut frame, &Gouraud::colored(), style, &corners);
        }
        assert!(whole == bands, "bands: {corners:?}");
    }
    let mut random = Random(46);
    for _ in 0..800 {
        check(&mut random, Thin);
        check(&mut random, Midpoint);
        check(&mut random, Wide(5));
        check(&mut random, Stippled::new(0x5C9B, 2, Wide(3)));
        check(&mut random, Stippled::new(0x5C9B, 1, Midpoint));
        check(&mut random, Rectangle(5));
        check(&mut random, Smooth(3));
    }
}
