//! A ball, made by the compiler.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use microraster::math::{Angle, Vec3};
use microraster::{Mesh, Normal, RestartIndices, TriangleStrip};

/// Strips from pole to pole, and the steps of each.
const STRIPS: usize = 24;
const STEPS: usize = 12;
const VERTICES: usize = (STRIPS + 1) * (STEPS + 1);
const INDICES: usize = STRIPS * (2 * (STEPS + 1) + 1);

/// A mesh with normals, in strips.
type Strips = Mesh<'static, Normal, TriangleStrip<RestartIndices<'static, u16>>>;

/// A ball of radius 1, closed.
pub(crate) static BALL: Strips = Mesh::new(&POSITIONS, &NORMALS)
    .with_topology(TriangleStrip::new(RestartIndices::new(&STRIP_INDICES)))
    .placed(Vec3::splat(1.0 / 32_767.0), Vec3::ZERO);

static POSITIONS: [[i16; 3]; VERTICES] = {
    let (mut positions, mut i) = ([[0; 3]; VERTICES], 0);
    while i < VERTICES {
        let [x, y, z] = direction(i);
        positions[i] = [(x * 32_767.0) as i16, (y * 32_767.0) as i16, (z * 32_767.0) as i16];
        i += 1;
    }
    positions
};

static NORMALS: [Normal; VERTICES] = {
    let (mut normals, mut i) = ([[0; 3]; VERTICES], 0);
    while i < VERTICES {
        let [x, y, z] = direction(i);
        normals[i] = [(x * 127.0) as i8, (y * 127.0) as i8, (z * 127.0) as i8];
        i += 1;
    }
    normals
};

static STRIP_INDICES: [u16; INDICES] = {
    let (mut indices, mut i) = ([u16::MAX; INDICES], 0);
    while i < INDICES {
        let (strip, place) = (i / (2 * STEPS + 3), i % (2 * STEPS + 3));
        if place < 2 * STEPS + 2 {
            let meridian = strip + place % 2;
            indices[i] = (meridian * (STEPS + 1) + place / 2) as u16;
        }
        i += 1;
    }
    indices
};

/// Where vertex `i` lies: by meridians, from the upper pole.
const fn direction(i: usize) -> [f32; 3] {
    // The last meridian is the first, to the bit.
    let (meridian, step) = (i / (STEPS + 1) % STRIPS, i % (STEPS + 1));
    let (sin, cos) = Angle::from_turns(meridian as f32 / STRIPS as f32).sin_cos();
    let (radius, height) = Angle::from_turns(step as f32 / STEPS as f32 / 2.0).sin_cos();
    [radius * sin, height, radius * cos]
}
