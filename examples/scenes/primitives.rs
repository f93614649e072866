//! The measured scenes of lines and points: from screen coordinates, 320x240, RGB565, depth.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "random numbers are cut to what is wanted"
)]

use microraster::raster::ScreenVertex;
use microraster::{
    Color, Flat, Frame, Gouraud, Less, LineStyle, Midpoint, Rgb, Rgb565, ScreenPass, Shader, Size,
    Stats, Stippled, Thin, Varying, Wide,
};

use super::{Facts, Group, Probe, Scene, Stage, ROOM};

const SIZE: Size = Size::new(320, 240);

type Shaded = (ScreenVertex, Color);

/// Pseudo-random corners all over the picture, for as many lines or points.
const fn corners<const N: usize>() -> [Shaded; N] {
    let mut corners = [(ScreenVertex::from_bits(0, 0, 0), Color::new(0, 0, 0)); N];
    let (mut i, mut seed) = (0, 12_345_u32);
    while i < N {
        let mut numbers = [0_u32; 4];
        let mut k = 0;
        while k < 4 {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            numbers[k] = seed >> 8;
            k += 1;
        }
        let [x, y, z, c] = numbers;
        let (x, y) = ((x % (320 * 16)) as i32, (y % (240 * 16)) as i32);
        let color = Color::new(c as u8 | 32, (c >> 8) as u8 | 32, (c >> 16) as u8);
        corners[i] = (ScreenVertex::from_bits(x, y, (i * 24) as u16 | (z as u16 & 15)), color);
        i += 1;
    }
    corners
}

const LINES: usize = 400;
const POINTS: usize = 2048;

static ENDS: [Shaded; 2 * LINES] = corners();
static DUST: [Shaded; POINTS] = corners();

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 7] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("line", |stage, _, probe: &mut P| lines(stage, probe, &Flat::colored(), Thin)),
        scene("line-gouraud", |stage, _, probe: &mut P| {
            lines(stage, probe, &Gouraud::colored(), Thin)
        }),
        scene("line-midpoint", |stage, _, probe: &mut P| {
            lines(stage, probe, &Flat::colored(), Midpoint)
        }),
        scene("line-wide", |stage, _, probe: &mut P| {
            lines(stage, probe, &Flat::colored(), Wide(3))
        }),
        scene("line-stippled", |stage, _, probe: &mut P| {
            lines(stage, probe, &Flat::colored(), Stippled::new(0x00FF, 1, Thin))
        }),
        scene("point", |stage, _, probe: &mut P| points(stage, probe, 1)),
        scene("point-8", |stage, _, probe: &mut P| points(stage, probe, 8)),
    ]
}

fn lines<P: Probe, H: Shader>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    shader: &H,
    style: impl LineStyle,
) -> Facts
where
    H::Varying: Varying<Corner = Color>,
{
    let frame = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(stage.color), SIZE);
    if let Ok(mut frame) = frame.and_then(|frame| frame.with_depth(stage.depth)) {
        frame.clear(Rgb::BLACK);
        let lines = ENDS.as_chunks::<2>().0;
        if P::COUNTING {
            let mut stats = Stats::default();
            ScreenPass::new().depth(Less).count(&mut stats).lines(&mut frame, shader, style, lines);
            probe.pixels(stats.pixels.into());
            probe.skipped(stats.skipped);
        } else {
            let mut pass = ScreenPass::new().depth(Less);
            probe.measure(|| pass.lines(&mut frame, shader, style, lines));
        }
    }
    Facts { bytes: ROOM * 2, triangles: LINES as u32 }
}

fn points<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, size: u16) -> Facts {
    let frame = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(stage.color), SIZE);
    if let Ok(mut frame) = frame.and_then(|frame| frame.with_depth(stage.depth)) {
        frame.clear(Rgb::BLACK);
        let shader = Flat::colored();
        if P::COUNTING {
            let mut stats = Stats::default();
            ScreenPass::new()
                .depth(Less)
                .count(&mut stats)
                .points(&mut frame, &shader, size, &DUST);
            probe.pixels(stats.pixels.into());
            probe.skipped(stats.skipped);
        } else {
            let mut pass = ScreenPass::new().depth(Less);
            probe.measure(|| pass.points(&mut frame, &shader, size, &DUST));
        }
    }
    Facts { bytes: ROOM * 2, triangles: POINTS as u32 }
}
