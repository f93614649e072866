//! Thin triangles all around a point: what the grid of subpixels and samples make of edges.

#![allow(clippy::cast_possible_truncation, reason = "directions of 16 bits")]

use microraster::math::{Angle, Mat4, Vec3};
use microraster::{Flat, Less, Pass, Rgb, Stats};

use super::{knob, sampled, Shape};
use crate::scenes::standard::{camera, facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

/// Triangles.
pub(crate) const COUNT: usize = 90;

/// Two corners on a circle, and the middle of it, a little beside the picture's.
pub(crate) static POSITIONS: [[i16; 3]; 3 * COUNT] = {
    let (mut positions, mut i) = ([[0; 3]; 3 * COUNT], 0);
    while i < COUNT {
        let turn = 360.0 * i as f32 / COUNT as f32;
        positions[3 * i] = [137, 211, 0];
        positions[3 * i + 1] = rim(turn);
        // From a twentieth of a degree to one and a half.
        positions[3 * i + 2] = rim(turn + 0.05 + 1.45 * i as f32 / COUNT as f32);
        i += 1;
    }
    positions
};

const fn rim(degrees: f32) -> [i16; 3] {
    let (sin, cos) = Angle::from_degrees(degrees).sin_cos();
    [(cos * 32_000.0) as i16, (sin * 32_000.0) as i16, 0]
}

static INDICES: [u16; 3 * COUNT] = {
    let (mut indices, mut i) = ([0; 3 * COUNT], 0);
    while i < indices.len() {
        indices[i] = i as u16;
        i += 1;
    }
    indices
};

/// One a triangle: two by turns.
pub(crate) static COLORS: [Rgb; COUNT] = {
    let (mut colors, mut i) = ([Rgb::WHITE; COUNT], 0);
    while i < COUNT {
        if i % 2 == 1 {
            colors[i] = Rgb::new(255, 200, 0);
        }
        i += 1;
    }
    colors
};

pub(crate) fn shape() -> Shape<'static> {
    // A disc of 0.95 of the picture's height.
    let scale = 2.0 * 0.414_213_56 * 0.95 / 32_000.0;
    Shape {
        positions: &POSITIONS,
        indices: &INDICES,
        scale: Vec3::new(scale, scale, 0.0),
        offset: Vec3::new(0.0, 0.0, -2.0),
        model: Mat4::identity(),
    }
}

fn plain<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, shape, shader) = (camera(), shape(), Flat::colored());
        let mesh = shape.mesh(&COLORS).by_face();
        measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
            &mut frame,
            &shape.model,
            &mesh,
            &shader
        ));
    }
    facts(COUNT as u32)
}

fn samples<P: Probe, const FACTOR: u16>(
    stage: &mut Stage<'_>,
    _frame: u32,
    probe: &mut P,
) -> Facts {
    let (camera, shape, shader) = (camera(), shape(), Flat::colored());
    let mesh = shape.mesh(&COLORS).by_face();
    sampled::draw::<P, FACTOR>(stage, probe, |frame, probe| {
        measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
            frame,
            &shape.model,
            &mesh,
            &shader
        ));
    });
    facts(COUNT as u32)
}

/// With more and more samples a pixel.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let samples = knob!("slivers", "samples",
        "1" => plain::<P>,
        "2x2" => samples::<P, 2>,
        "4x4" => samples::<P, 4>,
    );
    samples.into_iter()
}
