//! Pairs of surfaces that cross, from near to far: how much of what is in front is seen in front.

#![allow(clippy::cast_possible_truncation, clippy::cast_precision_loss, reason = "few columns")]

use microraster::math::{Mat4, Vec3};
use microraster::{Camera, Flat, Less, Pass, Rgb, Stats};

use super::{case, Shape};
use crate::scenes::standard::{camera, facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

/// Columns of the picture, each with a pair at a distance of its own.
pub(crate) const COLUMNS: u16 = 16;

/// By how much of its distance each of a pair leans away at its sides.
const LEAN: f32 = 0.01;

/// The near distance of all ranges; the last number is where the range ends.
pub(crate) const NEAR: f32 = 0.5;

const REACH: i16 = 1 << 14;
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];
/// Near on the left, far on the right, and the other way round.
static LEANING: [[[i16; 3]; 4]; 2] = [
    [
        [-REACH, -REACH, REACH],
        [REACH, -REACH, -REACH],
        [REACH, REACH, -REACH],
        [-REACH, REACH, REACH],
    ],
    [
        [-REACH, -REACH, -REACH],
        [REACH, -REACH, REACH],
        [REACH, REACH, REACH],
        [-REACH, REACH, -REACH],
    ],
];
pub(crate) const COLORS: [Rgb; 2] = [Rgb::new(255, 96, 0), Rgb::new(0, 96, 255)];

/// The two surfaces of a column, in front where their side is the near one. `ratio` is how far the
/// range reaches, in near distances.
pub(crate) fn pair(column: u16, ratio: f32) -> [Shape<'static>; 2] {
    // From 1.2 near distances to 0.9 of the range, by equal factors.
    let part = f32::from(column) / f32::from(COLUMNS - 1);
    let distance = NEAR * 1.2 * power(ratio * 0.75, part);
    let (width, height) = (0.552 / f32::from(COLUMNS) * distance, 0.38 * distance);
    let middle = (f32::from(column) * 2.0 + 1.0 - f32::from(COLUMNS)) * width;
    LEANING.each_ref().map(|positions| Shape {
        positions,
        indices: &INDICES,
        scale: Vec3::new(width, height, LEAN * distance) * (1.0 / f32::from(REACH)),
        offset: Vec3::new(middle, 0.0, -distance),
        model: Mat4::identity(),
    })
}

/// `base` to a power of 0 to 1, within a thousandth: 64 roots of roots.
fn power(base: f32, part: f32) -> f32 {
    let (mut result, mut root, mut rest) = (1.0, base, part);
    for _ in 0..12 {
        root = microraster::math::sqrt(root);
        rest *= 2.0;
        if rest >= 1.0 {
            rest -= 1.0;
            result *= root;
        }
    }
    result
}

/// The camera: with the end of its range as a far plane, or without any.
pub(crate) fn camera_of(far: Option<f32>) -> Camera {
    far.map_or_else(camera, |far| camera().far(far))
}

fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, ratio: f32, is_far: bool) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let camera = camera_of(is_far.then_some(NEAR * ratio));
        for column in 0..COLUMNS {
            for (shape, color) in pair(column, ratio).into_iter().zip(COLORS) {
                let (shader, mesh) = (Flat::solid(color), shape.mesh(&[(); 4]));
                measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
                    &mut frame,
                    &shape.model,
                    &mesh,
                    &shader
                ));
            }
        }
    }
    facts(u32::from(COLUMNS) * 4)
}

macro_rules! ranges {
    ($($ratio:literal => $value:literal),+ $(,)?) => {
        [$(
            case(concat!("range/depth+range=infinite+", $ratio),
                |stage, _, probe| draw(stage, probe, $value, false)),
            case(concat!("range/depth+range=far-plane+", $ratio),
                |stage, _, probe| draw(stage, probe, $value, true)),
        )+]
    };
}

/// Ranges of ten to a million near distances, with a far plane and without.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let ranges = ranges!(
        "1e1" => 1e1,
        "1e2" => 1e2,
        "1e3" => 1e3,
        "1e4" => 1e4,
        "1e5" => 1e5,
        "1e6" => 1e6,
    );
    ranges.into_iter()
}
