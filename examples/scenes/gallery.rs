//! The pictures of the gallery as scenes: the same bits on every board.

#[path = "../gallery/mod.rs"]
pub(crate) mod pictures;

use microraster::Stats;

use super::{Facts, Group, Probe, Scene, Stage};
use pictures::{Canvas, PICTURES, PIXELS};

/// Draws picture number `I`, clears and counting included.
fn at<P: Probe, const I: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let Some(picture) = PICTURES.get(I) else { return Facts { bytes: 0, triangles: 0 } };
    // Pixels of two bytes leave half of the words.
    let (pixels, words) = stage.color.split_at_mut(PIXELS / 2);
    let mut canvas = Canvas {
        picture: picture.size,
        first_row: 0,
        rows: picture.size.height,
        pixels: bytemuck::cast_slice_mut(pixels),
        depth: stage.depth,
        words,
    };
    let mut stats = Stats::default();
    let drawn = probe.measure(|| (picture.draw)(&mut canvas, picture.turn, &mut stats));
    probe.pixels(stats.pixels.into());
    probe.skipped(stats.skipped);
    let pixels = usize::from(picture.size.width) * usize::from(picture.size.height);
    Facts { bytes: if drawn.is_ok() { 2 * pixels } else { 0 }, triangles: stats.triangles }
}

/// The list.
pub(crate) fn scenes<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let draws = [
        at::<P, 0>,
        at::<P, 1>,
        at::<P, 2>,
        at::<P, 3>,
        at::<P, 4>,
        at::<P, 5>,
        at::<P, 6>,
        at::<P, 7>,
        at::<P, 8>,
        at::<P, 9>,
        at::<P, 10>,
    ];
    PICTURES.iter().zip(draws).map(|(picture, draw)| Scene {
        name: picture.name,
        group: Group::Gallery,
        frames: 1,
        bunny: false,
        draw,
    })
}
