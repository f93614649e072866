//! Draws a scene with the crate, and says what differs from what is expected.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "numbers of a small scene; floats that come from the same text are the same"
)]

use microraster::math::{Mat4, Vec4};
use microraster::raster::{ScreenVertex, SUBPIXELS};
use microraster::{
    AnyDepth, Camera, Clip, Color, Cull, DepthBuffer, DrawContext, Flat, Frame, Gouraud, Mesh,
    Pass, Rgb16, Rgba8888, ScreenPass, Shader, Size, SmoothColor, Stats, Thin, VertexInput,
    Winding,
};

use crate::expected::{Coverage, Expected};
use crate::scene::{Draw, Kind, Scene, Vertex};

/// Takes positions and colours as they come.
struct ClipShader;

impl Shader for ClipShader {
    type Vertex = (Clip, Color);
    type Varying = SmoothColor;
    type Prepared = ();
    const OWN_POSITIONS: bool = true;

    fn prepare(&self, _: &DrawContext) {}

    fn position(&self, (): &(), (clip, _): &(Clip, Color)) -> Option<Clip> {
        Some(*clip)
    }

    fn vertex(&self, (): &(), vertex: VertexInput<'_, (Clip, Color)>) -> Color {
        vertex.attributes.1
    }

    fn fragment(&self, _: &Self::Prepared, varying: &SmoothColor) -> Option<Color> {
        Some(varying.color())
    }
}

/// What of a draw the crate cannot do yet, so that its colours or depths are not compared.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Limits {
    pub(crate) color: Option<&'static str>,
    pub(crate) depth: Option<&'static str>,
}

impl Limits {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut limits = Self::default();
        for draw in &scene.draws {
            let uneven_w = |p: &[Vertex]| p.iter().any(|v| v.position[3] != p[0].position[3]);
            let uneven_color = |p: &[Vertex]| p.iter().any(|v| v.color != p[0].color);
            let perspective = draw.setting("perspective") == "1" && draw.setting("shade") != "flat";
            if draw.setting("textured") == "1" {
                limits.color = Some("textures");
            } else if draw.setting("blend") != "none" {
                limits.color = Some("blending");
            } else if perspective && draw.primitives().any(|p| uneven_w(p) && uneven_color(p)) {
                limits.color = Some("perspective-correct varyings");
            }
            let tested = !matches!(draw.setting("depth_test"), "none" | "always");
            if draw.setting("depth_write") == "0" && tested {
                limits.depth = Some("a depth test that does not write");
            }
            if draw.kind == Kind::Lines {
                // The rules leave how attributes run along a line to the implementation.
                limits.color = Some("attributes of lines");
                if tested {
                    limits.depth = Some("attributes of lines");
                }
            }
        }
        limits
    }
}

/// What colours are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Paint {
    /// White, without depth.
    Coverage,
    /// The number of the primitive plus 1, as a colour.
    Number,
    /// As the scene says.
    Color,
}

type Picture<'a> = Frame<'a, Rgba8888, DepthBuffer<'a>>;

/// The depth code of a depth from 0 (near) to 1.
fn screen_code(depth: f32) -> u16 {
    ((1.0 - f64::from(depth)) * 65535.0).round() as u16
}

fn color_of([r, g, b, _]: [f32; 4]) -> Color {
    let full = f64::from(Rgb16::FULL);
    let channel = |v: f32| (f64::from(v).clamp(0.0, 1.0) * full).round() as u16;
    Rgb16::new(channel(r), channel(g), channel(b)).into()
}

/// Draws one primitive; `false` if the crate skips it, being out of its range.
fn draw_primitive(
    frame: &mut Picture<'_>,
    scene: &Scene,
    draw: &Draw,
    number: usize,
    corners: &[Vertex],
    paint: Paint,
) -> bool {
    let flat = draw.setting("shade") == "flat";
    let provoking = if draw.setting("provoking") == "last" { corners.len() - 1 } else { 0 };
    let color = |v: &Vertex| match paint {
        Paint::Coverage => color_of([1.0; 4]),
        Paint::Number => {
            let [low, high, ..] = (number as u32 + 1).to_le_bytes();
            Rgb16::new(u16::from(low) << 8, u16::from(high) << 8, 0).into()
        }
        Paint::Color if flat => color_of(corners[provoking].color),
        Paint::Color => color_of(v.color),
    };
    let depth = match (paint, draw.setting("depth_test"), draw.setting("depth_write")) {
        (Paint::Coverage, ..) | (_, _, "0") => AnyDepth::Off,
        (_, "less", _) => AnyDepth::Less,
        (_, "lequal", _) => AnyDepth::LessEqual,
        (_, "equal", _) => AnyDepth::Equal,
        (_, "greater", _) => AnyDepth::Greater,
        _ => AnyDepth::Always,
    };
    let cull = match draw.setting("cull") {
        "back" => Cull::Back,
        "front" => Cull::Front,
        _ => Cull::None,
    };
    let clockwise = draw.setting("front_face") == "cw";
    let winding = if clockwise { Winding::Clockwise } else { Winding::CounterClockwise };
    let mut stats = Stats::default();
    if scene.clip {
        let largest = corners.iter().flat_map(|v| v.position).fold(0.0, |a: f32, b| a.max(b.abs()));
        let scale = 0.99 * Clip::LIMIT as f32 / largest;
        let vertex = |v: &Vertex| {
            let [x, y, z, w] = v.position;
            // The crate's depth runs from 1 at the near plane to 0.
            let clip = Clip::from_f32(Vec4::new(x, y, w - z, w), scale)?;
            Some((clip, color(v)))
        };
        let vertices: Option<Vec<_>> = corners.iter().map(vertex).collect();
        let Some(vertices) = vertices else {
            return false;
        };
        let camera = Camera::custom(Mat4::identity());
        let mesh = Mesh::new(&[], &vertices);
        let pass = Pass::new(&camera).cull(cull).front_face(winding).depth(depth);
        pass.count(&mut stats).draw(frame, &Mat4::identity(), &mesh, &ClipShader);
        return stats.skipped == 0;
    }
    let vertex = |v: &Vertex| {
        let [x, y, z, _] = v.position;
        (ScreenVertex::from_bits(x as i32, y as i32, screen_code(z)), color(v))
    };
    let mut pass = ScreenPass::new().cull(cull).front_face(winding).depth(depth).count(&mut stats);
    match (corners, flat) {
        ([a, b, c], true) => pass.triangle(frame, &Flat::colored(), &[a, b, c].map(vertex)),
        ([a, b, c], false) => pass.triangle(frame, &Gouraud::colored(), &[a, b, c].map(vertex)),
        ([a, b], _) => pass.lines(frame, &Gouraud::colored(), Thin, &[[a, b].map(vertex)]),
        _ => {
            let size = draw.setting("point_size").parse().expect("a whole size");
            pass.points(frame, &Gouraud::colored(), size, &[vertex(&corners[0])]);
        }
    }
    stats.skipped == 0
}

/// How far a picture is from what is expected.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    /// Primitives that the crate leaves out, being out of its range.
    pub(crate) skipped: usize,
    /// Primitives whose coverage alone differs, where it has to be exact.
    pub(crate) coverage: usize,
    /// Pixels covered another number of times.
    pub(crate) counts: usize,
    /// Pixels that show another primitive.
    pub(crate) primitives: usize,
    /// The largest difference of depth in 1/65535, beyond what moving a corner onto the subpixel
    /// grid makes.
    pub(crate) depth: f64,
    /// The largest difference of a channel in 1/255.
    pub(crate) color: i32,
    /// What was compared, at least once.
    pub(crate) compared: usize,
}

/// Draws the scene and compares.
pub(crate) fn replay(scene: &Scene, expected: &Expected, limits: Limits) -> Report {
    let size = Size::new(scene.width, scene.height);
    let pixels = usize::from(scene.width) * usize::from(scene.height);
    let mut report = Report::default();
    let numbered = || {
        let all = scene.draws.iter().flat_map(|draw| draw.primitives().map(move |p| (draw, p)));
        all.enumerate()
    };
    let draw_all = |paint: Paint, only: Option<usize>| {
        let (mut color, mut depth) = (vec![0u32; pixels], vec![0u16; pixels]);
        let frame = Frame::<Rgba8888>::new(&mut color, size).expect("a buffer that fits");
        let mut frame = frame.with_depth(&mut depth).expect("a buffer that fits");
        let mut skipped = 0;
        for (number, (draw, corners)) in numbered() {
            if only.is_none_or(|only| only == number) {
                let drawn = draw_primitive(&mut frame, scene, draw, number, corners, paint);
                skipped += usize::from(!drawn);
            }
        }
        (color, depth, skipped)
    };
    // Coverage, each primitive alone.
    let mut counts = vec![0_u8; pixels];
    for (number, (draw, _)) in numbered() {
        let (alone, _, _) = draw_all(Paint::Coverage, Some(number));
        let set = alone.iter().enumerate().filter(|(_, word)| **word != 0);
        let set: Vec<(u16, u16)> = set
            .map(|(i, _)| ((i % size.width as usize) as u16, (i / size.width as usize) as u16))
            .collect();
        let exact = !scene.clip && draw.kind != Kind::Lines;
        let differs = expected.primitives.get(number) != Some(&Coverage::of(&set));
        report.coverage += usize::from(exact && differs);
        for (count, word) in counts.iter_mut().zip(&alone) {
            *count = count.saturating_add(u8::from(*word != 0)).min(127);
        }
    }
    let (numbers, depths, skipped) = draw_all(Paint::Number, None);
    let (colors, _, _) = draw_all(Paint::Color, None);
    report.skipped = skipped;
    for (i, pixel) in expected.pixels.iter().enumerate().filter(|(_, p)| !p.ambiguous) {
        report.compared += 1;
        report.counts += usize::from(counts[i] != pixel.count);
        if limits.depth.is_some() {
            continue;
        }
        let seen = (numbers[i] & 0xFFFF) as i32 - 1;
        if seen != i32::from(pixel.primitive) {
            report.primitives += 1;
            continue;
        }
        if seen < 0 {
            continue;
        }
        let is_line = scene.draws.iter().any(|draw| draw.kind == Kind::Lines);
        let written = scene.draws.iter().all(|draw| draw.setting("depth_write") == "1");
        if written && !is_line {
            let code = f64::from(depths[i]);
            let far = if scene.clip { (code - 2.0) / 65531.0 } else { code / 65535.0 };
            let difference = (1.0 - far - f64::from(pixel.depth)).abs() * 65535.0;
            // Corners from clip space are rounded to the subpixel grid, half a subpixel by axis,
            // and inside of a triangle a plane is off by no more than at its corners.
            let moved = if scene.clip { expected.slope(i, scene.width.into()) / 32.0 } else { 0.0 };
            report.depth = report.depth.max(difference - moved * 65535.0);
        }
        if limits.color.is_none() {
            for (channel, expected) in colors[i].to_le_bytes().into_iter().zip(pixel.color).take(3)
            {
                let difference = (i32::from(channel) - i32::from(expected)).abs();
                report.color = report.color.max(difference);
            }
        }
    }
    report
}

/// Whether every coordinate lies in the range that the rasterizer states.
pub(crate) fn is_in_range(scene: &Scene) -> bool {
    let reach = |side: u16| f32::from(side) * 8.0 + 4096.0 * SUBPIXELS as f32;
    let within = |v: &Vertex| {
        v.position[0].abs() <= reach(scene.width) && v.position[1].abs() <= reach(scene.height)
    };
    scene.clip || scene.draws.iter().flat_map(|draw| &draw.vertices).all(within)
}
