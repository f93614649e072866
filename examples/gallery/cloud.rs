//! A point cloud: what a scanner of 32 beams sees of a yard, coloured by distance.
//!
//! The 20 000 points are made as they are drawn, a few sweeps at a time, so that they need no memory.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use microraster::math::{Angle, AngleUnits, Mat4, Vec3};
use microraster::{
    Camera, Consecutive, DepthBuffer, Flat, Frame, Less, Mesh, Pass, Points, Rgb, Rgb565, SizeOf,
    Stats, VertexInput,
};

/// Points of a sweep, one a beam, and sweeps all around.
const BEAMS: usize = 32;
const SWEEPS: usize = 625;
/// Sweeps that are drawn at once.
const BATCH: usize = 5;

/// Draws the cloud; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(Rgb::new(6, 8, 14));
    let (sin, cos) = turn.degrees().sin_cos();
    let camera = Camera::perspective(50.0.degrees(), 1.0).look_at(
        Vec3::new(20.0 * sin, 12.0, 20.0 * cos),
        Vec3::new(0.0, 1.0, -1.5),
        Vec3::Y,
    );
    let size = SizeOf(|_: VertexInput<'_, Rgb>, z: u16| if z > 4_200 { 32 } else { 16 });
    let mut pass = Pass::new(&camera).depth(Less).count(stats);
    for first in (0..SWEEPS).step_by(BATCH) {
        let mut positions = [[0; 3]; BATCH * BEAMS];
        let mut colors = [Rgb::BLACK; BATCH * BEAMS];
        let (rows, tints) = (positions.chunks_exact_mut(BEAMS), colors.chunks_exact_mut(BEAMS));
        for ((sweep, positions), colors) in (first..).zip(rows).zip(tints) {
            scan(sweep as f32 / SWEEPS as f32, positions, colors);
        }
        let points = Mesh::new(&positions, &colors)
            .with_topology(Points::new(Consecutive::new(positions.len())))
            .placed(Vec3::splat(1.0 / STEPS), Vec3::ZERO);
        pass.draw_points(frame, &Mat4::identity(), &points, &Flat::colored(), &size);
    }
}

/// Steps of a position in a metre: 32 metres reach everywhere.
const STEPS: f32 = 1000.0;
/// How high the scanner is above the ground.
const MAST: f32 = 2.2;

/// Half the sides of the walled yard that it stands in.
const YARD: [f32; 2] = [17.0, 23.0];

/// A house, a car, a post: from and to in x, from and to in z, height.
type Block = [f32; 5];

const BLOCKS: [Block; 13] = [
    // Houses on both sides.
    [-16.0, -7.0, -13.0, -2.5, 5.0],
    [-15.0, -8.0, 0.5, 9.0, 3.6],
    [-16.0, -8.5, 12.0, 20.0, 5.5],
    [8.0, 16.0, -12.0, -4.0, 4.2],
    [7.0, 15.0, -1.0, 5.5, 6.0],
    [8.5, 16.0, 9.0, 18.0, 4.0],
    // Cars: bodies and cabins.
    [-4.2, -2.4, -9.5, -5.2, 0.8],
    [-4.1, -2.5, -8.6, -6.2, 1.5],
    [2.5, 4.3, -6.0, -1.8, 0.8],
    [2.6, 4.2, -5.0, -2.6, 1.5],
    [2.4, 4.4, 6.0, 11.0, 2.3],
    // Posts.
    [-5.6, -5.3, -1.0, -0.7, 4.5],
    [5.3, 5.6, -9.0, -8.7, 4.5],
];

/// One sweep of all beams, so many turns about the mast.
fn scan(turns: f32, positions: &mut [[i16; 3]], colors: &mut [Rgb]) {
    let (sin, cos) = Angle::from_turns(turns).sin_cos();
    // Where the sweep enters and leaves the blocks that it meets, and how high they are.
    let (mut hits, mut count) = ([(0.0, 0.0, 0.0); BLOCKS.len()], 0);
    for [x0, x1, z0, z1, height] in BLOCKS {
        let ((a, b), (c, d)) = (slab(x0, x1, sin), slab(z0, z1, cos));
        let (enter, leave) = (larger(a, c), smaller(b, d));
        if 0.0 < enter && enter < leave {
            hits[count] = (enter, leave, height);
            count += 1;
        }
    }
    // The yard's own walls are hit from inside.
    let (wall, end) = (slab(-YARD[0], YARD[0], sin).1, slab(-YARD[1], YARD[1], cos).1);
    for ((beam, position), color) in (0_u8..).zip(positions).zip(colors) {
        // Beams from steeply down to a little up, closer towards the horizon.
        let up = (f32::from(beam) - 24.0) / 24.0;
        let slope = if up < 0.0 { -0.75 * up * up } else { 0.9 * up };
        let mut distance = smaller(wall, end);
        if slope * distance < -MAST {
            distance = -MAST / slope;
        }
        for (enter, leave, height) in hits.into_iter().take(count) {
            if MAST + slope * enter < height {
                distance = smaller(distance, enter);
            } else if MAST + slope * leave < height {
                distance = smaller(distance, (height - MAST) / slope);
            }
        }
        let up = MAST + slope * distance;
        *position = [sin * distance, up, cos * distance].map(steps);
        *color = tint(distance);
    }
}

/// Distances at which a ray along one axis is between two ends.
fn slab(from: f32, to: f32, speed: f32) -> (f32, f32) {
    // Never quite along the other axis.
    let speed = if speed.abs() < 1.0e-4 { 1.0e-4 } else { speed };
    let (a, b) = (from / speed, to / speed);
    (smaller(a, b), larger(a, b))
}

fn smaller(a: f32, b: f32) -> f32 {
    if a < b {
        a
    } else {
        b
    }
}

fn larger(a: f32, b: f32) -> f32 {
    if a > b {
        a
    } else {
        b
    }
}

fn steps(metres: f32) -> i16 {
    (metres * STEPS) as i16
}

/// The colour of a distance.
fn tint(distance: f32) -> Rgb {
    TINTS.get((distance * 4.0) as usize).copied().unwrap_or(Rgb::BLACK)
}

/// From red near to violet far, for each quarter of a metre.
static TINTS: [Rgb; 128] = {
    let scale: [[i32; 3]; 9] = [
        [255, 40, 40],
        [255, 80, 40],
        [255, 170, 40],
        [190, 235, 60],
        [60, 225, 140],
        [50, 170, 255],
        [90, 110, 250],
        [140, 80, 230],
        [140, 80, 230],
    ];
    let (mut tints, mut i) = ([Rgb::BLACK; 128], 0);
    while i < tints.len() {
        let (from, part) = (i / 16, (i % 16) as i32);
        let (a, b) = (scale[from], scale[from + 1]);
        tints[i] = Rgb::new(
            (a[0] + (b[0] - a[0]) * part / 16) as u8,
            (a[1] + (b[1] - a[1]) * part / 16) as u8,
            (a[2] + (b[2] - a[2]) * part / 16) as u8,
        );
        i += 1;
    }
    tints
};
