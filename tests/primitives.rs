//! Lines and points against their definitions, pixel by pixel.
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

use lines::{draw_lines, line_pixels};
use microraster::host::reference::{Reference, State};
use microraster::raster::ScreenVertex;
use microraster::{
    Always, AnyDepth, AnyDepthState, Color, Flat, Frame, Gouraud, Rect, Rgb, Rgba8888, ScreenPass,
    Size, Stats, Thin,
};
use support::{any_corner, Random};

const SIZE: Size = Size::new(20, 16);
const PIXELS: usize = 20 * 16;

type Shaded = (ScreenVertex, Color);

/// The pixels that a drawing changes in a black picture.
fn drawn(draw: impl FnOnce(&mut Frame<'_, Rgba8888>)) -> Vec<(i32, i32)> {
    let mut pixels = [0; PIXELS];
    let mut frame = Frame::new(&mut pixels, SIZE).expect("the buffer fits");
    draw(&mut frame);
    let set = pixels.iter().enumerate().filter(|(_, word)| **word != 0);
    set.map(|(i, _)| (i as i32 % 20, i as i32 / 20)).collect()
}

/// The pixels of the picture of which something holds.
fn pixels_where(holds: impl Fn(i32, i32) -> bool) -> Vec<(i32, i32)> {
    let all = (0..16).flat_map(|y| (0..20).map(move |x| (x, y)));
    all.filter(|&(x, y)| holds(x, y)).collect()
}

fn white(v: ScreenVertex) -> Shaded {
    (v, Rgb::WHITE.into())
}

fn check_line(a: ScreenVertex, b: ScreenVertex) {
    let expected = line_pixels(SIZE, 1, [a, b]);
    let mut stats = Stats::default();
    let found = drawn(|frame| {
        let mut pass = ScreenPass::new().count(&mut stats);
        pass.lines(frame, &Flat::colored(), Thin, &[[white(a), white(b)]]);
    });
    assert_eq!(found, expected, "{a:?} to {b:?}");
    assert_eq!(stats.pixels as usize, found.len(), "a pixel drawn twice: {a:?} to {b:?}");
    assert_eq!(stats.lines, stats.degenerate + stats.outside + stats.skipped + stats.drawn, "sum");
}

#[test]
fn lines_are_those_of_the_diamond_exit_rule() {
    let mut random = Random(11);
    for i in 0..60_000 {
        let [a, b] = [(); 2].map(|()| any_corner(&mut random, i % 10, SIZE));
        check_line(a, b);
    }
}

#[test]
fn every_short_line_about_a_pixel_is_right() {
    // All ends within a pixel and a half of each other, on every third subpixel and on all halves.
    let steps = || (0..=24).filter(|i| i % 3 == 0 || i % 8 == 0);
    let corner = |x, y| ScreenVertex::from_bits(64 + x, 64 + y, 0);
    for x in steps() {
        for y in steps() {
            for u in steps() {
                for v in steps() {
                    check_line(corner(x, y), corner(u, v));
                }
            }
        }
    }
}

#[test]
fn lines_through_the_whole_range_are_right() {
    let mut random = Random(12);
    for i in 0..4_000 {
        let class = if i % 2 == 0 { 5 } else { 8 };
        let [a, b] = [(); 2].map(|()| any_corner(&mut random, class, SIZE));
        check_line(a, b);
    }
}

#[test]
fn a_chain_draws_its_joints_once() {
    let mut random = Random(13);
    for _ in 0..2_000 {
        // Turns by less than a right angle, so that only joints could be drawn twice.
        let mut at = ScreenVertex::from_bits(random.range(0, 40), random.range(0, 60), 0);
        let mut lines = Vec::new();
        for _ in 0..8 {
            let next = ScreenVertex::from_bits(
                at.x.to_bits() + random.range(9, 40),
                at.y.to_bits() + random.range(0, 8),
                0,
            );
            lines.push([white(at), white(next)]);
            at = next;
        }
        let mut stats = Stats::default();
        let found = drawn(|frame| {
            ScreenPass::new().count(&mut stats).lines(frame, &Flat::colored(), Thin, &lines);
        });
        assert_eq!(stats.pixels as usize, found.len(), "{lines:?}");
    }
}

#[test]
fn scissors_and_bands_change_no_bit_of_a_line() {
    let mut random = Random(14);
    for _ in 0..3_000 {
        let line = [(); 2].map(|()| {
            let color = Rgb::new(random.next() as u8, random.next() as u8, random.next() as u8 | 1);
            (any_corner(&mut random, 6, SIZE), color.into())
        });
        let draw = |scissors: &[Rect]| {
            let (mut pixels, mut depth) = ([0; PIXELS], [0; PIXELS]);
            let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
            let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
            for scissor in scissors {
                frame.set_scissor(*scissor);
                ScreenPass::new().depth(Always).lines(
                    &mut frame,
                    &Gouraud::colored(),
                    Thin,
                    &[line],
                );
            }
            (pixels, depth)
        };
        let (x, y) = (random.range(0, 20), random.range(0, 16));
        let whole = draw(&[Rect::from_size(SIZE)]);
        let parts = draw(&[
            Rect::new(0, 0, x, y),
            Rect::new(x, 0, 20, y),
            Rect::new(0, y, x, 16),
            Rect::new(x, y, 20, 16),
        ]);
        assert!(whole == parts, "cut at {x}, {y}: {line:?}");
    }
}

#[test]
fn attributes_run_along_the_longer_side_and_stay_between_the_ends() {
    let mut random = Random(15);
    for i in 0..20_000 {
        let mut end = |class| {
            let (r, z) = (random.next() as u8, random.next() as u16);
            let v = any_corner(&mut random, class, SIZE);
            (ScreenVertex::new(v.x, v.y, z), Rgb::new(r, 255, 0))
        };
        let class = [0, 4, 6, 5, 8][i % 5];
        let [(a, p), (b, q)] = [end(class), end(class)];
        let (mut pixels, mut depth) = ([0u32; PIXELS], [0u16; PIXELS]);
        let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
        let line = [(a, p.into()), (b, q.into())];
        ScreenPass::new().depth(Always).lines(&mut frame, &Gouraud::colored(), Thin, &[line]);
        let mut exact = Reference::new(SIZE, [0.0; 3]);
        let state = State { depth: AnyDepthState::new(AnyDepth::Always), ..State::PLAIN };
        draw_lines(&mut exact, state, 1, &[[(a, p.r.into()), (b, q.r.into())]], |_| true);
        for (i, word) in pixels.iter().enumerate().filter(|(_, word)| **word != 0) {
            let [red, ..] = word.to_le_bytes();
            let color = exact.colors()[i][0] - f64::from(red);
            // Half a step of rounding and a quarter for stepping two channels in one word.
            assert!(color.abs() <= 0.76, "colour {color} at {i}: {line:?}");
            let code = exact.depths()[i] - f64::from(depth[i]);
            // Half a code of rounding, and a slope that is off by 2^-17 over at most 8192 pixels.
            assert!(code.abs() <= 0.5 + 0.0626, "depth {code} at {i}: {line:?}");
        }
    }
}

#[test]
fn points_are_half_open_squares_about_their_corners() {
    let mut random = Random(16);
    for i in 0..30_000 {
        let v = any_corner(&mut random, i % 10, SIZE);
        let size = match i % 7 {
            0 => 1,
            1 => random.range(0, 3),
            2 => random.range(0, 65535),
            _ => random.range(1, 40),
        } as u16;
        let half = i64::from(size) * 8;
        let (x0, y0) = (i64::from(v.x.to_bits()), i64::from(v.y.to_bits()));
        let within = |at: i32, v: i64| (v - half..v + half).contains(&(i64::from(at) * 16 + 8));
        let expected = pixels_where(|x, y| within(x, x0) && within(y, y0));
        let mut stats = Stats::default();
        let found = drawn(|frame| {
            let mut pass = ScreenPass::new().count(&mut stats);
            pass.points(frame, &Gouraud::colored(), size, &[white(v)]);
        });
        assert_eq!(found, expected, "{v:?} size {size}");
        assert_eq!(stats.points, stats.degenerate + stats.outside + stats.drawn, "sum");
    }
}

#[test]
fn what_is_out_of_range_is_skipped_and_counted() {
    let mut stats = Stats::default();
    let far = ScreenVertex::from_bits(i32::MAX, i32::MIN, 0);
    let found = drawn(|frame| {
        let mut pass = ScreenPass::new().count(&mut stats);
        pass.lines(frame, &Flat::colored(), Thin, &[[white(far), white(ScreenVertex::default())]]);
        pass.points(frame, &Flat::colored(), u16::MAX, &[white(far)]);
    });
    assert_eq!((found.len(), stats.skipped, stats.lines, stats.points), (0, 2, 1, 1), "skipped");
}
