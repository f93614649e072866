//! The teapot and the bunny, lit: normals, vertex caches, bands, samples, formats, angles.

use microraster::math::{Angle, Mat4, Vec3, Vec4};
use microraster::models::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_POSITIONS};
use microraster::{
    Color, Cull, DepthBuffer, Flat, Format, Frame, Gouraud, Less, Normal, Pass, Phong, Rgb, Rgb565,
    Rgb565Be, Rgba8888, Shader, Size, Stats, VertexCache,
};

use super::{knob, sampled, Shape};
use crate::scenes::standard::{camera, facts, light, measured, placement, SIZE};
use crate::scenes::{Facts, Model, Probe, Scene, Stage, ROOM};

/// Which mesh, and how far away.
pub(crate) trait Subject {
    /// Distance of its middle.
    const DISTANCE: f32;
    /// The mesh, turned as `model` says, and its normals.
    fn shape<'a>(model: Option<Model<'a>>) -> (Shape<'a>, &'a [Normal]);
}

pub(crate) struct Teapot;
pub(crate) struct Bunny;
/// The teapot so far away that its triangles are smaller than pixels.
pub(crate) struct Distant;

/// A mesh of a box height of 2 about its middle, turned.
fn fitted<'a>(
    distance: f32,
    positions: &'a [[i16; 3]],
    indices: &'a [u16],
    normals: &'a [Normal],
) -> (Shape<'a>, &'a [Normal]) {
    let (scale, offset) = placement(positions);
    let model = model(distance, Angle::from_degrees(TURN).sin_cos());
    (Shape { positions, indices, scale, offset, model }, normals)
}

impl Subject for Teapot {
    const DISTANCE: f32 = 3.0178;

    fn shape<'a>(_: Option<Model<'a>>) -> (Shape<'a>, &'a [Normal]) {
        fitted(Self::DISTANCE, &TEAPOT_POSITIONS, &TEAPOT_INDICES, &TEAPOT_NORMALS)
    }
}

impl Subject for Bunny {
    const DISTANCE: f32 = 3.0178;

    fn shape<'a>(model: Option<Model<'a>>) -> (Shape<'a>, &'a [Normal]) {
        match model {
            Some(Model { positions, indices, normals, .. }) => {
                fitted(Self::DISTANCE, positions, indices, normals)
            }
            None => fitted(Self::DISTANCE, &[], &[], &[]),
        }
    }
}

impl Subject for Distant {
    const DISTANCE: f32 = 24.0;

    fn shape<'a>(_: Option<Model<'a>>) -> (Shape<'a>, &'a [Normal]) {
        fitted(Self::DISTANCE, &TEAPOT_POSITIONS, &TEAPOT_INDICES, &TEAPOT_NORMALS)
    }
}

/// By how much a subject is turned.
pub(crate) const TURN: f32 = 22.5;

/// A subject turned about its axis: by sine and cosine of the angle, however they were made.
pub(crate) fn model(distance: f32, (sine, cosine): (f32, f32)) -> Mat4 {
    let turn = Mat4 {
        x: Vec4::new(cosine, 0.0, -sine, 0.0),
        z: Vec4::new(sine, 0.0, cosine, 0.0),
        ..Mat4::IDENTITY
    };
    Mat4::translation(Vec3::new(0.0, 0.0, -distance)) * turn
}

fn exactly() -> (f32, f32) {
    Angle::from_degrees(TURN).sin_cos()
}

/// Draws a subject by a shader, with the cache that a draw brings.
fn draw<P, W, S>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    shader: &S,
    turn: impl FnOnce() -> (f32, f32),
) -> Facts
where
    P: Probe,
    W: Subject,
    S: Shader<Vertex = Normal>,
{
    let (shape, normals) = W::shape(stage.bunny);
    let mesh = shape.mesh(normals);
    if let Ok(mut frame) = crate::scenes::standard::frame(stage.color, stage.depth) {
        let camera = camera();
        measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| {
            let model = model(W::DISTANCE, turn());
            pass.draw(&mut frame, &model, &mesh, shader);
        });
    }
    facts(mesh.triangles())
}

fn by_face<P: Probe, W: Subject>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    draw::<P, W, _>(stage, probe, &Flat::new(light()), exactly)
}

fn by_vertex<P: Probe, W: Subject>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    draw::<P, W, _>(stage, probe, &Gouraud::new(light()), exactly)
}

fn by_pixel<P: Probe, W: Subject>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    draw::<P, W, _>(stage, probe, &Phong::new(light()), exactly)
}

fn fast_angle<P: Probe, W: Subject>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let fast = || Angle::from_degrees(TURN).sin_cos_fast();
    draw::<P, W, _>(stage, probe, &Gouraud::new(light()), fast)
}

/// With a vertex cache of `N`.
fn cached<P, W, const N: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts
where
    P: Probe,
    W: Subject,
{
    let (shape, normals) = W::shape(stage.bunny);
    let mesh = shape.mesh(normals);
    if let Ok(mut frame) = crate::scenes::standard::frame(stage.color, stage.depth) {
        let (camera, shader) = (camera(), Gouraud::new(light()));
        measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| {
            // As `draw` does it: the cache is made within what is measured.
            let mut cache = VertexCache::<Color, N>::new();
            pass.draw_cached(&mut frame, &shape.model, &mesh, &shader, &mut cache);
        });
    }
    facts(mesh.triangles())
}

/// With the stage's cache, which has room for every vertex.
fn all_cached<P: Probe, W: Subject>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let (shape, normals) = W::shape(stage.bunny);
    let mesh = shape.mesh(normals);
    let Stage { color, depth, cache, .. } = stage;
    if let Ok(mut frame) = crate::scenes::standard::frame(color, depth) {
        let (camera, shader) = (camera(), Gouraud::new(light()));
        measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| pass.draw_cached(
            &mut frame,
            &shape.model,
            &mesh,
            &shader,
            cache
        ));
    }
    facts(mesh.triangles())
}

/// In bands of `ROWS`, the scene drawn again for each.
fn bands<P, W, const ROWS: u16>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts
where
    P: Probe,
    W: Subject,
{
    let (shape, normals) = W::shape(stage.bunny);
    let mesh = shape.mesh(normals);
    let (camera, shader) = (camera(), Gouraud::new(light()));
    let words = usize::from(SIZE.width) / 2 * usize::from(ROWS);
    let Stage { color, depth, .. } = stage;
    let bands = color.chunks_mut(words).zip((0..SIZE.height).step_by(ROWS.into()));
    for (words, first) in bands {
        let size = Size::new(SIZE.width, ROWS.min(SIZE.height - first));
        let frame = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(words), size)
            .and_then(|frame| frame.with_depth(depth))
            .and_then(|frame| frame.band(first, SIZE.height));
        let Ok(mut frame) = frame else { break };
        frame.clear(Rgb::BLACK);
        measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| pass.draw(
            &mut frame,
            &shape.model,
            &mesh,
            &shader
        ));
    }
    facts(mesh.triangles())
}

fn samples<P, W, const FACTOR: u16>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts
where
    P: Probe,
    W: Subject,
{
    let (shape, normals) = W::shape(stage.bunny);
    let mesh = shape.mesh(normals);
    let (camera, shader) = (camera(), Gouraud::new(light()));
    sampled::draw::<P, FACTOR>(stage, probe, |frame, probe| {
        measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| pass.draw(
            frame,
            &shape.model,
            &mesh,
            &shader
        ));
    });
    facts(mesh.triangles())
}

/// In a format other than RGB565.
fn formatted<P: Probe, F: Format>(
    mut frame: Frame<'_, F, DepthBuffer<'_>>,
    probe: &mut P,
) -> Facts {
    frame.clear(Rgb::BLACK);
    let (camera, shader) = (camera(), Gouraud::new(light()));
    let (shape, normals) = Teapot::shape(None);
    let mesh = shape.mesh(normals);
    measured!(probe, Pass::new(&camera).depth(Less).cull(Cull::Back), |pass| pass.draw(
        &mut frame,
        &shape.model,
        &mesh,
        &shader
    ));
    Facts { bytes: ROOM * core::mem::size_of::<F::Raw>(), triangles: mesh.triangles() }
}

fn big_endian<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    Frame::<Rgb565Be>::new(bytemuck::cast_slice_mut(stage.color), SIZE)
        .and_then(|frame| frame.with_depth(stage.depth))
        .map_or(facts(0), |frame| formatted(frame, probe))
}

fn true_color<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    Frame::<Rgba8888>::new(stage.color, SIZE)
        .and_then(|frame| frame.with_depth(stage.depth))
        .map_or(facts(0), |frame| formatted(frame, probe))
}

/// Every knob of the teapot, those of the bunny that depend on the size of a mesh, and the teapot
/// far away.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let normals = knob!("teapot", "normals",
        "face" => by_face::<P, Teapot>,
        "vertex" => by_vertex::<P, Teapot>,
        "pixel" => by_pixel::<P, Teapot>,
    );
    let angles = knob!("teapot", "trigonometry",
        "fast" => fast_angle::<P, Teapot>,
        "exact" => by_vertex::<P, Teapot>,
    );
    let samples = knob!("teapot", "samples",
        "1" => by_vertex::<P, Teapot>,
        "2x2" => samples::<P, Teapot, 2>,
        "4x4" => samples::<P, Teapot, 4>,
    );
    let formats = knob!("teapot", "format",
        "rgb565" => by_vertex::<P, Teapot>,
        "rgb565-be" => big_endian::<P>,
        "rgba8888" => true_color::<P>,
    );
    let bands = knob!("teapot", "rows",
        "240" => bands::<P, Teapot, 240>,
        "120" => bands::<P, Teapot, 120>,
        "60" => bands::<P, Teapot, 60>,
        "30" => bands::<P, Teapot, 30>,
        "16" => bands::<P, Teapot, 16>,
        "8" => bands::<P, Teapot, 8>,
        "4" => bands::<P, Teapot, 4>,
        "1" => bands::<P, Teapot, 1>,
    );
    let caches = knob!("teapot", "cache",
        "1" => cached::<P, Teapot, 1>,
        "8" => cached::<P, Teapot, 8>,
        "32" => by_vertex::<P, Teapot>,
        "128" => cached::<P, Teapot, 128>,
        "512" => cached::<P, Teapot, 512>,
        "2048" => all_cached::<P, Teapot>,
    );
    let distant = knob!("distant", "normals",
        "face" => by_face::<P, Distant>,
        "vertex" => by_vertex::<P, Distant>,
        "pixel" => by_pixel::<P, Distant>,
    );
    let bunny = knob!("bunny", "normals",
        "face" => by_face::<P, Bunny>,
        "vertex" => by_vertex::<P, Bunny>,
        "pixel" => by_pixel::<P, Bunny>,
    );
    let bunny_caches = knob!("bunny", "cache",
        "1" => cached::<P, Bunny, 1>,
        "32" => by_vertex::<P, Bunny>,
        "512" => cached::<P, Bunny, 512>,
        "2048" => all_cached::<P, Bunny>,
    );
    let needs_bunny = bunny.into_iter().chain(bunny_caches);
    normals
        .into_iter()
        .chain(angles)
        .chain(samples)
        .chain(formats)
        .chain(bands)
        .chain(caches)
        .chain(distant)
        .chain(needs_bunny.map(|scene| Scene { bunny: true, ..scene }))
}
