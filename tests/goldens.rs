//! Small pictures against the ones that were kept, exactly, and against a renderer in `f64`.
//!
//! `MICRORASTER_REWRITE_GOLDENS=1 cargo test --all-features --test goldens` writes the pictures
//! anew; one that the `f64` renderer does not agree with is refused.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "channels and pixels of small pictures"
)]
#![allow(dead_code, reason = "the scenes serve other programs too")]

#[path = "support/reference.rs"]
mod reference;
#[path = "../examples/scenes/mod.rs"]
mod scenes;

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use microraster::host::reference::{looks as reference_looks, Snap};
use microraster::{AnyBlend, Color, Format, Rgb565, Rgb565Be, Rgba8888, Supersampling};
use reference::{colors, Colors};
use scenes::golden::render::{render, Written};
use scenes::golden::{pictures, Draw, Picture, PixelFormat};

type Rgb = [u8; 3];

/// What the crate draws, row by row without gaps, as 8-bit channels.
fn drawn(picture: &Picture) -> (Vec<Rgb>, Written) {
    let (mut color, mut depth) = (vec![0u32; scenes::ROOM], vec![0u16; scenes::ROOM]);
    let written = render(&mut color, &mut depth, picture);
    let (width, height) = (usize::from(picture.size.width), usize::from(picture.size.height));
    let stride = width.max(picture.stride as usize);
    let halves: &[u16] = bytemuck::cast_slice(&color);
    let unpacked = |i: usize| {
        let color: Color = match picture.format {
            PixelFormat::Rgb565 => Rgb565::unpack(halves[i]),
            PixelFormat::Rgb565Be => Rgb565Be::unpack(halves[i]),
            PixelFormat::Rgba8888 => Rgba8888::unpack(color[i]),
        };
        [color.red(), color.green(), color.blue()]
    };
    let rows = (0..height).flat_map(|y| (0..width).map(move |x| y * stride + x));
    (rows.map(unpacked).collect(), written)
}

/// One step of a channel of the format in 8 bits.
fn steps(format: PixelFormat) -> [f64; 3] {
    match format {
        PixelFormat::Rgba8888 => [1.0; 3],
        PixelFormat::Rgb565 | PixelFormat::Rgb565Be => [255.0 / 31.0, 255.0 / 63.0, 255.0 / 31.0],
    }
}

/// How a picture agrees with the reference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Agreement {
    /// Pixels that are further from the reference than one step of the format.
    moved: usize,
    /// Pixels that are further even from everything between what the reference sees around their
    /// centres.
    wrong: usize,
    /// Pixels that are further from the reference on the crate's own grid of corners.
    off_grid: usize,
}

/// What the reference draws of a picture.
struct Truth {
    /// What is seen at the centres of pixels, then around them.
    looks: Vec<Colors>,
    /// What is seen at the centres with corners on the crate's grid.
    snapped: Colors,
}

/// What the reference sees at the centres of pixels and around them.
///
/// Corners are rounded to the subpixel grid, half of 1/16 pixel by axis, and come out of the
/// vertex stage with an error of at most as much. So a pixel shows what lies within 1/16 pixel of
/// its centre. Looked at in 25 places: triangles may be thin.
fn truth(number: usize) -> &'static Truth {
    static TRUTHS: [OnceLock<Truth>; 64] = [const { OnceLock::new() }; 64];
    let steps = [0.0, -2.0, -1.0, 1.0, 2.0].map(|step| step / 32.0);
    TRUTHS[number].get_or_init(|| {
        let picture = &pictures()[number];
        let factor = picture.samples.map_or(1, Supersampling::factor);
        // The samples of a pixel, each a picture of its own, in which a sample is a pixel.
        let grid = Snap::Bits(4 + factor.ilog2());
        let side = f64::from(factor);
        let samples: Vec<Vec<Colors>> = reference_looks(factor)
            .map(|[x, y]| {
                let look = |dx: f64, dy: f64| [x + dx / side, y + dy / side];
                let looks = steps.iter().flat_map(|dy| steps.map(|dx| look(dx, *dy)));
                let exact = looks.map(|look| colors(picture, look, Snap::Exact));
                exact.chain([colors(picture, [x, y], grid)]).collect()
            })
            .collect();
        let mut looks = match samples.as_slice() {
            [looks] => looks.clone(),
            _ => means(&samples),
        };
        let snapped = looks.pop().expect("the last one");
        Truth { looks, snapped }
    })
}

/// The means of samples at their centres, where each of them is as dark and as bright as it is
/// seen to be, and of those on the grid, which come last.
fn means(samples: &[Vec<Colors>]) -> Vec<Colors> {
    let mean = |of: &dyn Fn(&[Colors], usize, usize) -> f64| {
        let mut canvas = samples[0][0].clone();
        for (i, color) in canvas.iter_mut().enumerate() {
            *color = [0, 1, 2].map(|k| {
                samples.iter().map(|looks| of(looks, i, k)).sum::<f64>() / samples.len() as f64
            });
        }
        canvas
    };
    let seen = |looks: &[Colors], i: usize, k: usize| -> Vec<f64> {
        looks[..looks.len() - 1].iter().map(|canvas| canvas[i][k]).collect()
    };
    vec![
        mean(&|looks, i, k| looks[0][i][k]),
        mean(&|looks, i, k| seen(looks, i, k).into_iter().fold(255.0, f64::min)),
        mean(&|looks, i, k| seen(looks, i, k).into_iter().fold(0.0, f64::max)),
        mean(&|looks, i, k| looks[looks.len() - 1][i][k]),
    ]
}

/// How often colours are stored of which a blended one is made: each time up to a step of the
/// format is lost.
fn stores(picture: &Picture) -> f64 {
    let blends = picture.draws.iter().any(|draw| {
        let fragments = match draw {
            Draw::Mesh(draw) => draw.fragments,
            Draw::Screen(draw) => draw.fragments,
        };
        fragments.is_some_and(|fragments| fragments.blend != AnyBlend::Replace)
    });
    if blends {
        2.0
    } else {
        1.0
    }
}

/// Compares with the first of the looks, with all of them, and with what is on the grid.
fn agreement(picture: &Picture, pixels: &[Rgb], truth: &Truth) -> Agreement {
    let Truth { looks, snapped } = truth;
    let mut agreement = Agreement::default();
    for (i, pixel) in pixels.iter().enumerate() {
        // Colours are cut off to the format, which is up to one step, and a quarter of an 8-bit
        // step is the planes' own.
        let is_between = |canvases: &[Colors]| {
            (0..3).all(|k| {
                let seen = || canvases.iter().map(|canvas| canvas[i][k]);
                let step = steps(picture.format)[k] * stores(picture) + 0.25;
                let (low, high) = (seen().fold(255.0, f64::min), seen().fold(0.0, f64::max));
                (low - step..=high + step).contains(&f64::from(pixel[k]))
            })
        };
        agreement.moved += usize::from(!is_between(&looks[..1]));
        agreement.wrong += usize::from(!is_between(looks));
        agreement.off_grid += usize::from(!is_between(std::slice::from_ref(snapped)));
    }
    agreement
}

/// No pixel is wrong, and few are moved: those on edges, of which no picture has more than a pixel
/// in three, times the sixteenth by which an edge may move, to both sides. On the grid only those
/// corners move whose places the vertex stage rounds the other way: there are far fewer.
fn is_good(picture: &Picture, agreement: Agreement) -> bool {
    let pixels = usize::from(picture.size.width) * usize::from(picture.size.height);
    agreement.wrong == 0 && agreement.moved <= pixels / 24 && agreement.off_grid <= pixels / 512
}

fn file(picture: &Picture) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/goldens/{}.png", picture.name))
}

#[test]
fn pictures_are_the_kept_ones_and_those_of_the_reference() {
    let rewrite = std::env::var_os("MICRORASTER_REWRITE_GOLDENS").is_some();
    let mut failures = Vec::new();
    for (number, picture) in pictures().iter().enumerate() {
        let (pixels, written) = drawn(picture);
        assert_eq!(written.skipped, 0, "{}: nothing is out of range", picture.name);
        let agreement = agreement(picture, &pixels, truth(number));
        println!("{}: {agreement:?}", picture.name);
        if !is_good(picture, agreement) {
            failures
                .push(format!("{} is not what the reference draws: {agreement:?}", picture.name));
            continue;
        }
        let (width, height) = (picture.size.width.into(), picture.size.height.into());
        let bytes = pixels.as_flattened();
        if rewrite {
            image::save_buffer(file(picture), bytes, width, height, image::ColorType::Rgb8)
                .expect("the picture can be written");
            continue;
        }
        let kept = image::open(file(picture)).map(image::DynamicImage::into_rgb8);
        if kept.as_ref().ok().map(|kept| kept.as_raw().as_slice()) != Some(bytes) {
            failures.push(format!("{} is not the kept one", picture.name));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn bands_and_formats_show_the_same_teapot() {
    let named = |name: &str| {
        let picture = pictures().iter().find(|picture| picture.name == name);
        drawn(picture.expect("a picture of that name")).0
    };
    let whole = named("teapot-gouraud");
    assert!(whole == named("teapot-bands"), "bands");
    assert!(whole == named("teapot-swapped"), "swapped bytes");
    let rgba = named("teapot-rgba");
    let cut = |[r, g, b]: Rgb| [r >> 3, g >> 2, b >> 3];
    assert!(whole.iter().zip(&rgba).all(|(a, b)| cut(*a) == cut(*b)), "8-bit channels, cut off");
}

#[test]
fn the_reference_refuses_pictures_that_are_wrong() {
    for (number, picture) in pictures().iter().enumerate() {
        let (pixels, _) = drawn(picture);
        let refused =
            |changed: &[Rgb]| !is_good(picture, agreement(picture, changed, truth(number)));
        let width = usize::from(picture.size.width);
        let mut shifted = pixels.clone();
        shifted.rotate_right(1);
        let mut lower = pixels.clone();
        lower.rotate_right(width);
        assert!(refused(&shifted) || refused(&lower), "{}: moved by a pixel", picture.name);
        let brighter: Vec<Rgb> =
            pixels.iter().map(|[r, g, b]| [*r, g.saturating_add(12), *b]).collect();
        assert!(refused(&brighter), "{}: green by three steps", picture.name);
        let mut spotted = pixels.clone();
        spotted[width * 31 + 47] = [255, 0, 255];
        spotted[width * 33 + 47] = [0, 255, 0];
        assert!(refused(&spotted), "{}: two wrong pixels", picture.name);
    }
}
