//! Pixels that are the mean of their samples.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use microraster::raster::ScreenVertex;
use microraster::{
    Color, Dither, Dither4, Format, Frame, Gouraud, Rect, Rgb, Rgb565, Rgba8888, ScreenPass, Size,
    Supersampling, Undithered,
};
use support::Random;

const WIDTH: u16 = 24;
const HEIGHT: u16 = 16;

fn sampled(factor: u16, first: u16, rows: u16) -> Vec<u32> {
    let size = Size::new(WIDTH * factor, rows * factor);
    let mut samples = vec![0; usize::from(size.width) * usize::from(size.height)];
    let fine = Frame::<Rgba8888>::new(&mut samples, size).expect("sizes fit");
    let mut fine = fine.band(first * factor, HEIGHT * factor).expect("in the picture");
    fine.clear(Rgb::new(9, 30, 60));
    let mut random = Random(3);
    for _ in 0..12 {
        let triangle = [0; 3].map(|_: i32| {
            let x = random.range(-40, i32::from(WIDTH) * 16 + 40) * i32::from(factor);
            let y = random.range(-40, i32::from(HEIGHT) * 16 + 40) * i32::from(factor);
            let mut channel = || random.next() as u8;
            let color = Rgb::new(channel(), channel(), channel());
            (ScreenVertex::from_bits(x, y, 0), Color::from(color))
        });
        ScreenPass::new().triangle(&mut fine, &Gouraud::colored(), &triangle);
    }
    samples
}

/// A picture in bands of so many rows.
fn resolved<F: Format>(samples: Supersampling, rows: u16, dither: &impl Dither) -> Vec<F::Raw> {
    let mut picture = vec![F::pack(Color::default()); usize::from(WIDTH) * usize::from(HEIGHT)];
    let factor = samples.factor();
    let bands = picture.chunks_mut(usize::from(WIDTH) * usize::from(rows));
    for (first, band) in (0..).step_by(rows.into()).zip(bands) {
        let rows = rows.min(HEIGHT - first);
        let mut fine = sampled(factor, first, rows);
        let size = Size::new(WIDTH * factor, rows * factor);
        let fine = Frame::<Rgba8888>::new(&mut fine, size).expect("sizes fit");
        let fine = fine.band(first * factor, HEIGHT * factor).expect("in the picture");
        let frame = Frame::<F>::new(band, Size::new(WIDTH, rows)).expect("sizes fit");
        let mut frame = frame.band(first, HEIGHT).expect("in the picture");
        samples.resolve(&fine, &mut frame, dither);
    }
    picture
}

#[test]
fn a_pixel_is_the_mean_of_its_samples() {
    for samples in [Supersampling::Two, Supersampling::Four] {
        let factor = usize::from(samples.factor());
        let fine = sampled(samples.factor(), 0, HEIGHT);
        let got = resolved::<Rgba8888>(samples, HEIGHT, &Undithered);
        let coarse = resolved::<Rgb565>(samples, HEIGHT, &Undithered);
        for (i, pixel) in got.iter().enumerate() {
            let (x, y) = (i % usize::from(WIDTH), i / usize::from(WIDTH));
            for channel in 0..3 {
                let mut sum = 0.0;
                for (dx, dy) in (0..factor * factor).map(|k| (k % factor, k / factor)) {
                    let at = (y * factor + dy) * usize::from(WIDTH) * factor + x * factor + dx;
                    sum += f64::from(fine[at].to_ne_bytes()[channel]);
                }
                let mean = sum / (factor * factor) as f64;
                let off = (f64::from(pixel.to_ne_bytes()[channel]) - mean).abs();
                assert!(off <= 0.5, "{samples:?}, channel {channel} at {x}, {y}: {off}");
                let raw = coarse[i];
                let (steps, full) =
                    [(raw >> 11, 31.0), (raw >> 5 & 63, 63.0), (raw & 31, 31.0)][channel];
                let off = (f64::from(steps) - mean * full / 255.0).abs();
                assert!(off < 1.0, "{samples:?}, 565 channel {channel} at {x}, {y}: {off}");
            }
        }
    }
}

#[test]
fn bands_of_any_height_change_no_bit() {
    for samples in [Supersampling::Two, Supersampling::Four] {
        let whole = resolved::<Rgb565>(samples, HEIGHT, &Dither4);
        assert_ne!(whole, resolved::<Rgb565>(samples, HEIGHT, &Undithered), "dithered");
        for rows in [1, 2, 3, 5, 7] {
            assert_eq!(whole, resolved::<Rgb565>(samples, rows, &Dither4), "{samples:?}, {rows}");
        }
    }
}

#[test]
fn what_has_no_samples_or_is_outside_of_the_scissor_stays() {
    let (mut pixels, mut samples) = ([7u16; 8 * 4], [0u32; 12 * 6]);
    let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(8, 4)).expect("sizes fit");
    let mut fine = Frame::<Rgba8888>::new(&mut samples, Size::new(12, 6)).expect("sizes fit");
    fine.clear(Rgb::WHITE);
    // Too narrow: no row has all samples.
    Supersampling::Two.resolve(&fine, &mut frame, &Undithered);
    frame.set_scissor(Rect::new(1, 1, 5, 4));
    Supersampling::Two.resolve(&fine, &mut frame, &Undithered);
    for (i, pixel) in pixels.iter().enumerate() {
        let set = Rect::new(1, 1, 5, 3).contains((i % 8) as i32, (i / 8) as i32);
        assert_eq!(*pixel, if set { 0xFFFF } else { 7 }, "pixel {i}");
    }
}
