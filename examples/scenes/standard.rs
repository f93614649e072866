//! The measured scenes: 320x240, RGB565, clears excluded.
//!
//! Field of view 45 degrees, aspect 4/3, near 0.5. Meshes are centred on their box, scaled to a
//! box height of 2, at z = -3.0178, and turn by 22.5 degrees a frame; light falls along
//! (-0.3, -0.6, -1), 0.2 ambient and 0.8 diffuse.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "counts of a grid that fits 16 bits; colours wrap"
)]

use microraster::math::{Angle, Mat4, Vec3};
use microraster::models::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_PLANES, TEAPOT_POSITIONS};
use microraster::raster::ScreenVertex;
use microraster::{
    Camera, ConstantDepth, Cull, DepthBuffer, FacePlanes, Flat, Frame, FrameError, Gouraud,
    IndexedList, Lambert, Less, Light, Mesh, Normal, Pass, PlaneScale, Rgb, Rgb565, ScreenPass,
    Shader, Size, Topology, WithPlanes,
};

use super::{grid, Facts, Group, Probe, Scene, Stage, ROOM};

pub(crate) const SIZE: Size = Size::new(320, 240);
/// Bytes of an RGB565 picture.
const BYTES: usize = ROOM * 2;

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 13] {
    let scene =
        |name, frames, bunny, draw| Scene { name, group: Group::Standard, frames, bunny, draw };
    [
        scene("clear", 1, false, clear::<P>),
        scene("F1", 1, false, f1::<P>),
        scene("F2", 1, false, f2::<P>),
        scene("F2-constant", 1, false, f2_constant::<P>),
        scene("F3", 1, false, f3::<P>),
        scene("S1", 1, false, s1::<P>),
        scene("S1-raster", 1, false, s1_raster::<P>),
        scene("M1-teapot", 16, false, m1_teapot::<P>),
        scene("M2-teapot", 16, false, m2_teapot::<P>),
        scene("M1-bunny", 16, true, m1_bunny::<P>),
        scene("M2-bunny", 16, true, m2_bunny::<P>),
        scene("M1-bunny-no-planes", 16, true, m1_bunny_no_planes::<P>),
        scene("M2-bunny-no-planes", 16, true, m2_bunny_no_planes::<P>),
    ]
}

/// A frame with depth over the stage's buffers, cleared.
pub(crate) fn frame<'a>(
    color: &'a mut [u32],
    depth: &'a mut [u16],
) -> Result<Frame<'a, Rgb565, DepthBuffer<'a>>, FrameError> {
    let mut frame = Frame::new(bytemuck::cast_slice_mut(color), SIZE)?.with_depth(depth)?;
    frame.clear(Rgb::BLACK);
    Ok(frame)
}

/// What a frame of these scenes says.
pub(crate) fn facts(triangles: u32) -> Facts {
    Facts { bytes: BYTES, triangles }
}

pub(crate) fn camera() -> Camera {
    Camera::perspective(Angle::from_degrees(45.0), 0.5)
}

/// Clearing colour and depth, measured.
fn clear<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        probe.measure(|| frame.clear(Rgb::new(32, 64, 96)));
        probe.pixels(ROOM as u64);
    }
    facts(0)
}

static QUAD: [[i16; 3]; 4] = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]];
static QUAD_COLORS: [Rgb; 4] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE, Rgb::WHITE];
static QUAD_INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];

/// A quad 0.2 % larger than the screen, at z = -2.
pub(super) fn quad() -> Mesh<'static, Rgb, IndexedList<'static, u16>> {
    // Half the height of the screen at distance 2: 2 tan(22.5 degrees).
    let half = 2.0 * 0.414_213_56 * 1.002;
    Mesh::new(&QUAD, &QUAD_COLORS)
        .indexed(&QUAD_INDICES)
        .placed(Vec3::new(half * 4.0 / 3.0, half, 1.0), Vec3::new(0.0, 0.0, -2.0))
}

/// Runs a measured draw; counted instead where the probe asks for it.
macro_rules! measured {
    ($probe:ident, $pass:expr, |$with:ident| $draw:expr) => {
        if P::COUNTING {
            let mut stats = microraster::Stats::default();
            {
                let mut $with = $pass.count(&mut stats);
                $draw;
            }
            $probe.pixels(stats.pixels.into());
            $probe.skipped(stats.skipped);
        } else {
            let mut $with = $pass;
            $probe.measure(|| $draw);
        }
    };
}
pub(crate) use measured;

/// Fill without depth.
fn f1<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        measured!(probe, Pass::new(&camera), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// Fill with depth.
fn f2<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// Fill with the mean depth of each triangle.
fn f2_constant<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        measured!(probe, Pass::new(&camera).depth(ConstantDepth::new(Less)), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// Gouraud with depth.
fn f3<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Gouraud::colored();
        measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// A grid of 160x120 quads of 2x2 pixels, each triangle in its own colour, through the API.
fn s1<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let Stage { color, depth, cache, .. } = stage;
    if let Ok(mut frame) = frame(color, depth) {
        let camera = camera();
        let half = 2.0 * 0.414_213_56;
        let mesh =
            Mesh::new(&grid::POSITIONS, &grid::COLORS).by_face().indexed(&grid::INDICES).placed(
                Vec3::new(half * 4.0 / 3.0, half, 1.0) * (1.0 / grid::REACH),
                Vec3::new(0.0, 0.0, -2.0),
            );
        let shader = Flat::colored();
        measured!(probe, Pass::new(&camera).depth(Less), |pass| pass.draw_cached(
            &mut frame,
            &Mat4::identity(),
            &mesh,
            &shader,
            cache
        ));
    }
    facts(grid::TRIANGLES as u32)
}

/// The same grid from screen coordinates: the rasterizer alone.
fn s1_raster<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let shader = Flat::colored();
        measured!(probe, ScreenPass::new().depth(Less), |pass| {
            // A few quads at a time: the stack is measured too.
            const QUADS: usize = 16;
            for row in 0..grid::ROWS as i32 {
                for first in (0..grid::COLUMNS).step_by(QUADS) {
                    let mut triangles = [Default::default(); 2 * QUADS];
                    for (column, pair) in (first..).zip(triangles.chunks_exact_mut(2)) {
                        let (x, y) = (column as i32 * 32, row * 32);
                        let color = Rgb::new(column as u8, row as u8, 128).into();
                        let corner = |dx: i32, dy: i32| {
                            (ScreenVertex::from_bits(x + dx, y + dy, 30_000), color)
                        };
                        let [a, b, c, d] =
                            [corner(0, 0), corner(32, 0), corner(32, 32), corner(0, 32)];
                        pair.copy_from_slice(&[[a, c, b], [a, d, c]]);
                    }
                    pass.triangles(&mut frame, &shader, &triangles);
                }
            }
        });
    }
    facts(grid::TRIANGLES as u32)
}

/// An indexed mesh with normals.
pub(super) type Lit<'a> = Mesh<'a, Normal, IndexedList<'a, u16>>;
/// The same with the planes of its triangles.
pub(super) type LitWithPlanes<'a> = Mesh<'a, Normal, WithPlanes<'a, IndexedList<'a, u16>>>;

/// A lit mesh, centred at z = -3.0178 and turned.
#[derive(Clone, Copy)]
struct Turning<'a, T> {
    mesh: Mesh<'a, Normal, T>,
    frame: u32,
}

impl<T: Topology<Primitive = [u32; 3]>> Turning<'_, T> {
    fn draw<P, S>(&self, stage: &mut Stage<'_>, probe: &mut P, shader: &S) -> Facts
    where
        P: Probe,
        S: Shader<Vertex = Normal>,
        S::Varying: microraster::Varying<Corner = microraster::Color>,
    {
        let Stage { color, depth, cache, .. } = stage;
        if let Ok(mut frame) = frame(color, depth) {
            let camera = camera();
            let model = Mat4::translation(Vec3::new(0.0, 0.0, -3.0178))
                * Mat4::rotation_y(Angle::from_degrees(22.5 * self.frame as f32));
            measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| pass
                .draw_cached(&mut frame, &model, &self.mesh, shader, cache));
        }
        facts(self.mesh.triangles())
    }
}

/// The light of the meshes, and what they make of it.
pub(crate) const SUN: Vec3 = Vec3::new(-0.3, -0.6, -1.0);
pub(crate) const SUN_COLOR: Rgb = Rgb::new(204, 204, 204);
pub(crate) const AMBIENT: Rgb = Rgb::new(51, 51, 51);
pub(crate) const MATERIAL: Rgb = Rgb::new(230, 190, 140);

pub(crate) fn light() -> Lambert<1> {
    Lambert::new(&[Light::directional(SUN, SUN_COLOR)]).ambient(AMBIENT).material(MATERIAL)
}

/// A mesh centred on its box and scaled to a box height of 2.
fn fitted<'a>(positions: &'a [[i16; 3]], normals: &'a [Normal], indices: &'a [u16]) -> Lit<'a> {
    let (scale, offset) = placement(positions);
    Mesh::new(positions, normals).indexed(indices).placed(scale, offset)
}

/// The scale and the offset that do that.
pub(crate) fn placement(positions: &[[i16; 3]]) -> (Vec3, Vec3) {
    let (mut low, mut high) = ([i16::MAX; 3], [i16::MIN; 3]);
    for position in positions {
        for axis in 0..3 {
            low[axis] = low[axis].min(position[axis]);
            high[axis] = high[axis].max(position[axis]);
        }
    }
    let middle = |axis: usize| (f32::from(low[axis]) + f32::from(high[axis])) * 0.5;
    let scale = 2.0 / (f32::from(high[1]) - f32::from(low[1]));
    (Vec3::new(scale, scale, scale), Vec3::new(middle(0), middle(1), middle(2)) * -scale)
}

fn bunny_without_planes<'a>(stage: &Stage<'a>) -> Lit<'a> {
    stage.bunny.map_or(Mesh::new(&[], &[]).indexed(&[]), |model| {
        fitted(model.positions, model.normals, model.indices)
    })
}

pub(super) fn bunny<'a>(stage: &Stage<'a>) -> LitWithPlanes<'a> {
    let none = FacePlanes::new(&[], PlaneScale { radius: 1, reach: [0; 3] });
    let planes = stage.bunny.map_or(none, |model| FacePlanes::new(model.planes, model.plane_scale));
    bunny_without_planes(stage).with_planes(planes)
}

fn teapot() -> LitWithPlanes<'static> {
    fitted(&TEAPOT_POSITIONS, &TEAPOT_NORMALS, &TEAPOT_INDICES).with_planes(TEAPOT_PLANES)
}

fn m1_teapot<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    Turning { mesh: teapot(), frame }.draw(stage, probe, &Gouraud::new(light()))
}

fn m2_teapot<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    Turning { mesh: teapot(), frame }.draw(stage, probe, &Flat::new(light()))
}

fn m1_bunny<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    let mesh = bunny(stage);
    Turning { mesh, frame }.draw(stage, probe, &Gouraud::new(light()))
}

fn m2_bunny<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    let mesh = bunny(stage);
    Turning { mesh, frame }.draw(stage, probe, &Flat::new(light()))
}

fn m1_bunny_no_planes<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    let mesh = bunny_without_planes(stage);
    Turning { mesh, frame }.draw(stage, probe, &Gouraud::new(light()))
}

fn m2_bunny_no_planes<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    let mesh = bunny_without_planes(stage);
    Turning { mesh, frame }.draw(stage, probe, &Flat::new(light()))
}
