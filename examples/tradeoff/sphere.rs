//! A ball with a highlight: where light is made, how normals become units, how finely vertices are
//! kept.

#![allow(clippy::cast_possible_truncation, reason = "parts of a ball in 8 and 16 bits")]

use core::marker::PhantomData;

use microraster::math::{Angle, Mat4, Vec3};
use microraster::{
    BlinnPhong, Camera, Clip, Color, Corner, Cull, DrawContext, Flat, Gouraud, Less, Light, Normal,
    Pass, Phong, Rgb, Scalars, Shader, SmoothColor, Stats, VertexInput,
};

use super::inverse_root::{Bits, Exact, InverseRoot, Table};
use super::{knob, Shape};
use crate::scenes::standard::{camera, facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

/// Meridians and rings of vertices.
const AROUND: usize = 32;
const RINGS: usize = 17;
const VERTICES: usize = AROUND * RINGS;
pub(crate) const TRIANGLES: usize = AROUND * (RINGS - 1) * 2;

/// The place of a vertex on a ball of radius 1.
pub(crate) const fn place(vertex: usize) -> [f32; 3] {
    let (around, ring) = (vertex % AROUND, vertex / AROUND);
    let (sine, cosine) = Angle::from_degrees(360.0 * around as f32 / AROUND as f32).sin_cos();
    let (wide, high) = Angle::from_degrees(180.0 * ring as f32 / (RINGS - 1) as f32).sin_cos();
    [wide * sine, high, wide * cosine]
}

const fn rounded(v: f32) -> f32 {
    v + if v < 0.0 { -0.5 } else { 0.5 }
}

/// What 1 is in positions of 16 bits.
const LONG: f32 = 32_767.0;

static POSITIONS: [[i16; 3]; VERTICES] = positions(1.0);
/// The same in steps of 258: positions of 8 bits, for the eye of what draws them.
static SHORT_POSITIONS: [[i16; 3]; VERTICES] = positions(258.0);
/// The places themselves.
static PLACES: [([f32; 3], Normal); VERTICES] = {
    let (mut places, mut i) = ([([0.0; 3], [0; 3]); VERTICES], 0);
    while i < VERTICES {
        places[i] = (place(i), NORMALS[i]);
        i += 1;
    }
    places
};

const fn positions(step: f32) -> [[i16; 3]; VERTICES] {
    let (mut positions, mut i) = ([[0; 3]; VERTICES], 0);
    while i < VERTICES {
        let [x, y, z] = place(i);
        positions[i] = [stepped(x, step), stepped(y, step), stepped(z, step)];
        i += 1;
    }
    positions
}

const fn stepped(v: f32, step: f32) -> i16 {
    (rounded(v * LONG / step) as i16 as f32 * step) as i16
}

pub(crate) static NORMALS: [Normal; VERTICES] = {
    let (mut normals, mut i) = ([[0; 3]; VERTICES], 0);
    while i < VERTICES {
        let [x, y, z] = place(i);
        normals[i] = [rounded(x * 127.0) as i8, rounded(y * 127.0) as i8, rounded(z * 127.0) as i8];
        i += 1;
    }
    normals
};

static INDICES: [u16; 3 * TRIANGLES] = {
    let (mut indices, mut i) = ([0; 3 * TRIANGLES], 0);
    while i < TRIANGLES {
        let (quad, half) = (i / 2, i % 2);
        let (around, ring) = (quad % AROUND, quad / AROUND);
        let next = (around + 1) % AROUND;
        let (above, below) = (ring * AROUND, (ring + 1) * AROUND);
        let corners = if half == 0 {
            [above + around, below + around, below + next]
        } else {
            [above + around, below + next, above + next]
        };
        let mut k = 0;
        while k < 3 {
            indices[3 * i + k] = corners[k] as u16;
            k += 1;
        }
        i += 1;
    }
    indices
};

/// The middle of the ball, seen whole.
const FAR: f32 = 3.2;
/// The camera that looks at a thousandth of it.
pub(crate) const CLOSE: Camera = Camera::perspective(Angle::from_degrees(45.0), 0.002);
/// The middle of the ball, seen close.
const NEAR: f32 = 1.02;

/// The ball whole, or close.
pub(crate) fn shape(is_close: bool) -> Shape<'static> {
    let distance = if is_close { NEAR } else { FAR };
    let unit = 1.0 / LONG;
    Shape {
        positions: &POSITIONS,
        indices: &INDICES,
        scale: Vec3::new(unit, unit, unit),
        offset: Vec3::ZERO,
        model: Mat4::translation(Vec3::new(0.0, 0.0, -distance))
            * Mat4::rotation_x(Angle::from_degrees(33.0))
            * Mat4::rotation_y(Angle::from_degrees(7.0)),
    }
}

pub(crate) const SUN: Vec3 = Vec3::new(-0.4, -0.5, -1.0);
pub(crate) const SUN_COLOR: Rgb = Rgb::new(204, 204, 204);
pub(crate) const AMBIENT: Rgb = Rgb::new(51, 51, 51);
pub(crate) const MATERIAL: Rgb = Rgb::new(200, 60, 40);
/// The exponent of the highlight: white, and of the sun's colour.
pub(crate) const SHININESS: u8 = 32;

fn light() -> BlinnPhong<1> {
    let sun = Light::directional(SUN, SUN_COLOR);
    BlinnPhong::new(&[sun]).ambient(AMBIENT).material(MATERIAL).specular(Rgb::WHITE, SHININESS)
}

/// Draws the ball by a shader.
fn draw<P, A, S>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    shader: &S,
    (shape, attributes): (Shape<'static>, &[A]),
    camera: &Camera,
) -> Facts
where
    P: Probe,
    S: Shader<Vertex = A>,
{
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let mesh = shape.mesh(attributes);
        measured!(probe, Pass::new(camera).depth(Less).cull(Cull::Back), |pass| pass.draw(
            &mut frame,
            &shape.model,
            &mesh,
            shader
        ));
    }
    facts(TRIANGLES as u32)
}

/// Normals that are made units again for each pixel, and light in floating-point numbers: 51 of
/// ambient light, 204 of the sun, and a highlight.
struct Shiny<R>(PhantomData<R>);

impl<R: InverseRoot> Shader for Shiny<R> {
    type Vertex = Normal;
    type Varying = Scalars<3>;
    /// The way to the sun and the way halfway to the eye, in the mesh's axes.
    type Prepared = [Vec3; 2];

    fn prepare(&self, draw: &DrawContext) -> [Vec3; 2] {
        let back = (draw.view * draw.model).transpose();
        let sun = (-SUN).normalize();
        [sun, (sun + Vec3::Z).normalize()].map(|way| back.transform_vector(way))
    }

    #[allow(clippy::cast_sign_loss, reason = "about the middle of 16 bits")]
    fn vertex(&self, _: &[Vec3; 2], vertex: VertexInput<'_, Normal>) -> Corner<Scalars<3>> {
        vertex.attributes.map(|v| ((i32::from(v) << 8) + MIDDLE) as u16)
    }

    #[inline(always)]
    #[allow(clippy::cast_sign_loss, reason = "none is negative")]
    fn fragment(&self, [sun, halfway]: &[Vec3; 2], normal: &Scalars<3>) -> Option<Color> {
        let [x, y, z] = normal.get().map(|v| (i32::from(v) - MIDDLE) as f32 * (1.0 / 32_768.0));
        let unit = R::of(x * x + y * y + z * z);
        let cosine = |way: &Vec3| (x * way.x + y * way.y + z * way.z) * unit;
        let diffuse = 51.0 + 204.0 * cosine(sun).max(0.0);
        let mut highlight = cosine(halfway).clamp(0.0, 1.0);
        // To the power of 32.
        for _ in 0..5 {
            highlight *= highlight;
        }
        let channel = |material: f32| {
            (diffuse * material * (1.0 / 255.0) + 204.0 * highlight).min(255.0) as u8
        };
        Some(Color::new(channel(200.0), channel(60.0), channel(40.0)))
    }
}

const MIDDLE: i32 = 1 << 15;

fn shiny<P: Probe, R: InverseRoot>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    draw(stage, probe, &Shiny::<R>(PhantomData), (shape(false), &NORMALS), &camera())
}

/// Light at vertices whose places are floating-point numbers, transformed as such.
struct Wide<'a>(&'a BlinnPhong<1>);

impl Shader for Wide<'_> {
    type Vertex = ([f32; 3], Normal);
    type Varying = SmoothColor;
    type Prepared =
        (microraster::math::Mat4, f32, <BlinnPhong<1> as microraster::Coloring>::Prepared);
    const OWN_POSITIONS: bool = true;

    fn prepare(&self, draw: &DrawContext) -> Self::Prepared {
        let matrix = draw.model_view_projection();
        // Nothing of the ball is farther away than this.
        let largest = FAR + 1.0;
        let lights = microraster::Coloring::prepare(self.0, draw);
        (matrix, 0.99 * Clip::LIMIT as f32 / (largest * 2.5), lights)
    }

    fn position(
        &self,
        (matrix, scale, _): &Self::Prepared,
        (at, _): &Self::Vertex,
    ) -> Option<Clip> {
        let [x, y, z] = *at;
        Clip::from_f32(*matrix * microraster::math::Vec4::new(x, y, z, 1.0), *scale)
    }

    fn vertex(
        &self,
        (_, _, lights): &Self::Prepared,
        vertex: VertexInput<'_, Self::Vertex>,
    ) -> Corner<SmoothColor> {
        let (at, normal) = vertex.attributes;
        // Light needs no more than the mesh's own steps.
        let position = at.map(|v| rounded(v * LONG) as i16);
        let normal = VertexInput { attributes: normal, position };
        microraster::Coloring::color(self.0, lights, normal).into()
    }

    #[inline(always)]
    fn fragment(&self, _: &Self::Prepared, color: &SmoothColor) -> Option<Color> {
        Some(color.color())
    }
}

/// How finely vertices are kept.
trait Vertices {
    fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, is_close: bool) -> Facts;
}

struct Bytes;
struct Words;
struct Floats;

fn view(is_close: bool) -> Camera {
    if is_close {
        CLOSE
    } else {
        camera()
    }
}

impl Vertices for Bytes {
    fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, is_close: bool) -> Facts {
        let shape = Shape { positions: &SHORT_POSITIONS, ..shape(is_close) };
        draw(stage, probe, &Gouraud::new(light()), (shape, &NORMALS), &view(is_close))
    }
}

impl Vertices for Words {
    fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, is_close: bool) -> Facts {
        draw(stage, probe, &Gouraud::new(light()), (shape(is_close), &NORMALS), &view(is_close))
    }
}

impl Vertices for Floats {
    fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, is_close: bool) -> Facts {
        let shape = Shape { positions: &[], ..shape(is_close) };
        draw(stage, probe, &Wide(&light()), (shape, &PLACES), &view(is_close))
    }
}

/// Where light is made, how normals become units, and how finely vertices are kept.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let normals = knob!("sphere", "normals",
        "face" => |stage, _, probe| draw(stage, probe, &Flat::new(light()), (shape(false), &NORMALS), &camera()),
        "vertex" => |stage, _, probe| draw(stage, probe, &Gouraud::new(light()), (shape(false), &NORMALS), &camera()),
        "pixel" => |stage, _, probe| draw(stage, probe, &Phong::new(light()), (shape(false), &NORMALS), &camera()),
    );
    let roots = knob!("sphere", "inverse-root",
        "micromath" => shiny::<P, Bits<0>>,
        "newton-1" => shiny::<P, Bits<1>>,
        "newton-2" => shiny::<P, Bits<2>>,
        "table" => shiny::<P, Table>,
        "exact" => shiny::<P, Exact>,
    );
    let vertices = knob!("sphere", "vertices",
        "i8" => |stage, _, probe| Bytes::draw(stage, probe, false),
        "i16" => |stage, _, probe| Words::draw(stage, probe, false),
        "f32" => |stage, _, probe| Floats::draw(stage, probe, false),
    );
    let close = knob!("sphere-close", "vertices",
        "i8" => |stage, _, probe| Bytes::draw(stage, probe, true),
        "i16" => |stage, _, probe| Words::draw(stage, probe, true),
        "f32" => |stage, _, probe| Floats::draw(stage, probe, true),
    );
    normals.into_iter().chain(roots).chain(vertices).chain(close)
}
