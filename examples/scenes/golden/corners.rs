//! Primitives in screen space, for pictures of 96x64.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "small numbers of corners; colours wrap"
)]

use microraster::math::{Angle, Vec2};
use microraster::Rgb;

use super::ScreenCorner;

/// The middle of the picture, a little off the grid.
const MIDDLE: (i32, i32) = (48 * 16 + 5, 32 * 16 - 3);

/// The point on a circle about the middle, in subpixels, at part `i` of `n`.
fn around(i: u32, n: u32, radius: f32) -> (i32, i32) {
    let (sine, cosine) = Angle::from_degrees(360.0 * i as f32 / n as f32).sin_cos();
    let Vec2 { x, y } = Vec2::new(cosine, sine) * (radius * 16.0);
    (MIDDLE.0 + x as i32, MIDDLE.1 + y as i32)
}

/// A colour of the wheel, at part `i` of `n`.
fn hue(i: u32, n: u32) -> Rgb {
    let at = 6 * 256 * (i % n) / n;
    let (up, down) = ((at % 256) as u8, 255 - (at % 256) as u8);
    match at / 256 {
        0 => Rgb::new(255, up, 0),
        1 => Rgb::new(down, 255, 0),
        2 => Rgb::new(0, 255, up),
        3 => Rgb::new(0, down, 255),
        4 => Rgb::new(up, 0, 255),
        _ => Rgb::new(255, 0, down),
    }
}

/// A fan of 96 thin triangles that share all their sides.
pub(crate) fn fan(i: u32) -> Option<ScreenCorner> {
    const PARTS: u32 = 96;
    let (part, corner) = (i / 3, i % 3);
    let (x, y, color) = match corner {
        0 => (MIDDLE.0, MIDDLE.1, Rgb::WHITE),
        _ => {
            let at = (part + corner - 1) % PARTS;
            let (x, y) = around(at, PARTS, if at.is_multiple_of(2) { 58.0 } else { 44.0 });
            (x, y, hue(at, PARTS))
        }
    };
    (part < PARTS).then_some((x, y, 0, color))
}

/// A star of 40 lines, from black to colours.
pub(crate) fn star(i: u32) -> Option<ScreenCorner> {
    const LINES: u32 = 40;
    let line = i / 2;
    let (radius, color) =
        if i.is_multiple_of(2) { (6.0, Rgb::BLACK) } else { (46.0, hue(line, LINES)) };
    let (x, y) = around(line, LINES, radius);
    (line < LINES).then_some((x, y, 20_000 + 500 * line as u16, color))
}

/// Squares on a spiral, the nearest outside.
pub(crate) fn spiral(i: u32) -> Option<ScreenCorner> {
    const POINTS: u32 = 60;
    let (x, y) = around(i * 5, POINTS, 4.0 + 0.62 * i as f32);
    (i < POINTS).then_some((x, y, 1_000 + 1_000 * i as u16, hue(i, POINTS)))
}

/// Dust everywhere, behind most of the spiral.
pub(crate) fn dust(i: u32) -> Option<ScreenCorner> {
    let x = (i.wrapping_mul(2_654_435_761) >> 20) % (96 * 16);
    let y = (i.wrapping_mul(2_246_822_519) >> 19) % (64 * 16);
    (i < 200).then_some((x as i32, y as i32, 9_000, Rgb::new(200, 200, 220)))
}

/// A rectangle of two triangles, from its upper left corner to its lower right one, in pixels, of
/// colours above and below.
fn rectangle(i: u32, corners: [i32; 4], z: u16, [above, below]: [Rgb; 2]) -> Option<ScreenCorner> {
    let [left, top, right, bottom] = corners.map(|pixels| 16 * pixels);
    let (column, row) = *[(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)].get(i as usize)?;
    let (x, y) = ([left, right][column], [top, bottom][row]);
    Some((x, y, z, [above, below][row]))
}

/// The whole picture, from light to dark.
pub(crate) fn backdrop(i: u32) -> Option<ScreenCorner> {
    rectangle(i, [0, 0, 96, 64], 100, [Rgb::new(240, 220, 160), Rgb::new(20, 40, 90)])
}

/// The whole picture in dark tones, so that steps are seen.
pub(crate) fn dusk(i: u32) -> Option<ScreenCorner> {
    rectangle(i, [0, 0, 96, 64], 100, [Rgb::new(12, 16, 40), Rgb::new(72, 40, 24)])
}

/// Patch `N` of five beside each other, from green to red.
pub(crate) fn patch<const N: i32>(i: u32) -> Option<ScreenCorner> {
    let left = 3 + 18 * N;
    let colors = [Rgb::new(60, 200, 100), Rgb::new(230, 70, 50)];
    rectangle(i, [left, 8, left + 15, 56], 200, colors)
}
