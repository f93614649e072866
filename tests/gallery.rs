//! The gallery's pictures against the ones that were kept, exactly; whole and in bands.
//!
//! `MICRORASTER_REWRITE_GOLDENS=1 cargo test --all-features --test gallery` writes the pictures
//! anew: look at them.
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]

#[path = "../examples/gallery/mod.rs"]
mod gallery;

use std::path::{Path, PathBuf};

use gallery::{Canvas, Picture, PICTURES, PIXELS, WORDS};
use microraster::{Format, Rgb565, Stats};

/// A picture at a turn, drawn so many rows at a time, and what was counted.
fn drawn(picture: &Picture, turn: f32, band: u16) -> (Vec<u16>, Stats) {
    let width = usize::from(picture.size.width);
    let mut pixels = vec![0; width * usize::from(picture.size.height)];
    let mut stats = Stats::default();
    let bands = pixels.chunks_mut(width * usize::from(band));
    for (first_row, pixels) in (0..).step_by(band.into()).zip(bands) {
        // What a picture does not set itself would show.
        let (mut depth, mut words) = (vec![0xA5A5; PIXELS], vec![0x5A5A_5A5A; WORDS]);
        pixels.fill(0xF81F);
        let mut canvas = Canvas {
            picture: picture.size,
            first_row,
            rows: band.min(picture.size.height - first_row),
            pixels,
            depth: &mut depth,
            words: &mut words,
        };
        (picture.draw)(&mut canvas, turn, &mut stats).expect("buffers are large enough");
    }
    (pixels, stats)
}

fn rgb(pixels: &[u16]) -> Vec<u8> {
    let colors = pixels.iter().map(|pixel| Rgb565::unpack(*pixel));
    colors.flat_map(|color| [color.red(), color.green(), color.blue()]).collect()
}

fn file(picture: &Picture) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/gallery/{}.png", picture.name))
}

#[test]
fn pictures_are_the_kept_ones() {
    let rewrite = std::env::var_os("MICRORASTER_REWRITE_GOLDENS").is_some();
    let mut failures = Vec::new();
    for picture in &PICTURES {
        let bytes = rgb(&drawn(picture, picture.turn, picture.size.height).0);
        let (width, height) = (picture.size.width.into(), picture.size.height.into());
        if rewrite {
            image::save_buffer(file(picture), &bytes, width, height, image::ColorType::Rgb8)
                .expect("the picture can be written");
            continue;
        }
        let kept = image::open(file(picture)).map(image::DynamicImage::into_rgb8);
        let is_kept = |kept: &image::RgbImage| {
            kept.dimensions() == (width, height) && kept.as_raw() == &bytes
        };
        if !kept.is_ok_and(|kept| is_kept(&kept)) {
            failures.push(format!("{} is not the kept one", picture.name));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn bands_make_the_same_pictures() {
    for picture in &PICTURES {
        for turn in [picture.turn, picture.turn + 111.0] {
            let (whole, _) = drawn(picture, turn, picture.size.height);
            for band in [7, 31] {
                let (bands, _) = drawn(picture, turn, band);
                assert!(whole == bands, "{} at {turn} in bands of {band}", picture.name);
            }
        }
    }
}

#[test]
fn nothing_is_skipped_and_pictures_turn() {
    for picture in &PICTURES {
        let (first, stats) = drawn(picture, picture.turn, picture.size.height);
        assert_eq!(stats.skipped, 0, "{}: nothing is out of range", picture.name);
        assert!(stats.drawn > 0 && stats.pixels > 1000, "{}: {stats:?}", picture.name);
        for turn in [45.0, 150.0, 260.0] {
            let (other, stats) = drawn(picture, picture.turn + turn, picture.size.height);
            assert_eq!(stats.skipped, 0, "{} at {turn}", picture.name);
            assert!(first != other, "{} is the same at {turn}", picture.name);
        }
    }
}
