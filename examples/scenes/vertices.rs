//! Measured scenes of the vertex stage: points of a mesh, each a vertex of its own.
//!
//! A point beside the picture is transformed and projected and no more. In the picture it is also
//! given its colour and written, one pixel without depth; what a light adds to that is the light's
//! cost.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "random numbers are cut to what is wanted"
)]

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::{
    BlinnPhong, Consecutive, Flat, Lambert, Light, Mesh, Normal, Pass, Points, Rgb, Shader,
};

use super::standard::{camera, facts, frame, measured};
use super::{Facts, Group, Probe, Scene, Stage};

const COUNT: usize = 2048;

/// Positions all over a cube, and normals to all sides.
const fn cloud() -> ([[i16; 3]; COUNT], [Normal; COUNT]) {
    let (mut positions, mut normals) = ([[0; 3]; COUNT], [[0; 3]; COUNT]);
    let (mut i, mut seed) = (0, 54_321_u32);
    while i < COUNT {
        let mut axis = 0;
        while axis < 3 {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            positions[i][axis] = (seed >> 16) as i16;
            // The three together are no longer than a normal may be.
            normals[i][axis] = (seed >> 8) as i8 / 2;
            axis += 1;
        }
        i += 1;
    }
    (positions, normals)
}

static POSITIONS: [[i16; 3]; COUNT] = cloud().0;
static NORMALS: [Normal; COUNT] = cloud().1;

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 7] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("vertex", |stage, _, probe: &mut P| {
            let shader = Flat::new(Lambert::new(&[sun()]));
            points(stage, probe, &NORMALS, Vec3::new(100.0, 0.0, -4.0), &shader)
        }),
        scene("vertex-unlit", |stage, _, probe: &mut P| {
            points(stage, probe, &[(); COUNT], MIDDLE, &Flat::solid(Rgb::WHITE))
        }),
        scene("vertex-sun", |stage, _, probe: &mut P| {
            points(stage, probe, &NORMALS, MIDDLE, &Flat::new(Lambert::new(&[sun()])))
        }),
        scene("vertex-3-suns", |stage, _, probe: &mut P| {
            let [mut left, mut right] = [sun(); 2];
            left = Light::directional(Vec3::new(1.0, 0.0, -1.0), left.color());
            right = Light::directional(Vec3::new(-1.0, 0.0, -1.0), right.color());
            points(stage, probe, &NORMALS, MIDDLE, &Flat::new(Lambert::new(&[sun(), left, right])))
        }),
        scene("vertex-lamp", |stage, _, probe: &mut P| {
            let lamp = Light::point(LAMP, Rgb::WHITE);
            points(stage, probe, &NORMALS, MIDDLE, &Flat::new(Lambert::new(&[lamp])))
        }),
        scene("vertex-spot", |stage, _, probe: &mut P| {
            let (inner, outer) = (20.0.degrees(), 40.0.degrees());
            let spot = Light::spot(LAMP, Vec3::new(0.0, -1.0, -1.0), inner, outer, Rgb::WHITE);
            points(stage, probe, &NORMALS, MIDDLE, &Flat::new(Lambert::new(&[spot])))
        }),
        scene("vertex-highlight", |stage, _, probe: &mut P| {
            let shiny = BlinnPhong::new(&[sun()]).specular(Rgb::WHITE, 20);
            points(stage, probe, &NORMALS, MIDDLE, &Flat::new(shiny))
        }),
    ]
}

/// Where the whole cube is in the picture.
const MIDDLE: Vec3 = Vec3::new(0.0, 0.0, -4.0);
const LAMP: Vec3 = Vec3::new(0.0, 2.0, -2.0);

fn sun() -> Light {
    Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204))
}

/// Draws the cloud about a place.
fn points<P: Probe, S: Shader>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    attributes: &[S::Vertex],
    at: Vec3,
    shader: &S,
) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let camera = camera();
        let (scale, model) = (1.0 / 32768.0, Mat4::translation(at));
        let mesh = Mesh::new(&POSITIONS, attributes)
            .with_topology(Points::new(Consecutive::new(COUNT)))
            .placed(Vec3::new(scale, scale, scale), Vec3::ZERO);
        measured!(probe, Pass::new(&camera), |pass| pass
            .draw_points(&mut frame, &model, &mesh, shader, &1));
    }
    facts(COUNT as u32)
}
