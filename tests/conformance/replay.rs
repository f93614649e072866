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
use microraster::texture::{AnyFilter, AnySampler, AnyTexture, AnyWrap, Environment};
use microraster::texture::{Modulate, Sample, Texture};
use microraster::{
    AnyBlend, AnyDepth, AnyDepthState, Camera, Clip, Color, Cull, DepthBuffer, DrawContext, Exact,
    Frame, Mesh, Pass, Perspective, PerspectiveCorner, Rgb16, Rgba8888, Scalar, ScreenPass, Shader,
    Size, SmoothColor, Stats, Thin, Uv, VertexInput, Winding,
};

use crate::expected::{Coverage, Expected};
use crate::scene::{Draw, Kind, Scene, Texels, Vertex};

/// A corner as a scene gives it: colour and alpha, and a place in the texture.
type Attributes = (PerspectiveCorner<(Color, u16)>, PerspectiveCorner<[i16; 2]>);

/// Takes positions and attributes as they come; multiplies with the texture, if there is one.
struct SceneShader<'a> {
    sampler: Option<AnySampler<'a>>,
}

impl Shader for SceneShader<'_> {
    type Vertex = (Clip, Attributes);
    type Varying = (Perspective<(SmoothColor, Scalar), Exact>, Perspective<Uv, Exact>);
    type Prepared = ();
    const OWN_POSITIONS: bool = true;

    fn prepare(&self, _: &DrawContext) {}

    fn position(&self, (): &(), (clip, _): &(Clip, Attributes)) -> Option<Clip> {
        Some(*clip)
    }

    fn vertex(&self, (): &(), vertex: VertexInput<'_, (Clip, Attributes)>) -> Attributes {
        vertex.attributes.1
    }

    fn fragment(&self, (): &(), (surface, uv): &Self::Varying) -> Option<Color> {
        let (color, alpha) = **surface;
        let color = color.color().with_alpha((alpha.get() >> 8) as u8);
        match &self.sampler {
            Some(sampler) => Some(Modulate.combine(sampler.fetch(uv.u, uv.v)?, color)),
            None => Some(color),
        }
    }
}

/// A texture in the crate's own words.
enum Words {
    Rgb565(Vec<u16>),
    Rgba8888(Vec<u32>),
}

impl Words {
    fn of(texels: &Texels) -> Self {
        if texels.is_rgb565 {
            let words = texels.bytes.chunks_exact(2);
            Self::Rgb565(words.map(|word| u16::from_le_bytes([word[0], word[1]])).collect())
        } else {
            let words = texels.bytes.chunks_exact(4);
            let word = |word: &[u8]| u32::from_ne_bytes([word[0], word[1], word[2], word[3]]);
            Self::Rgba8888(words.map(word).collect())
        }
    }

    fn sampler(&self, texels: &Texels, unit_bits: u32) -> AnySampler<'_> {
        let (width, height) = (texels.width, texels.height);
        let texture = match self {
            Self::Rgb565(words) => Texture::new(words, width, height).map(AnyTexture::Rgb565),
            Self::Rgba8888(words) => Texture::new(words, width, height).map(AnyTexture::Rgba8888),
        };
        let filter = if texels.is_linear { AnyFilter::FineBilinear } else { AnyFilter::Nearest };
        let wrap = if texels.repeats { AnyWrap::Repeat } else { AnyWrap::Clamp };
        let texture = texture.expect("texels for its size");
        let sampler = AnySampler::new(texture, filter, wrap, wrap);
        sampler.expect("sides that are powers of two").unit_bits(unit_bits)
    }
}

/// The most units a repeat may have for coordinates to fit 16 bits: log2.
fn unit_bits(draw: &Draw) -> u32 {
    let largest = draw.vertices.iter().flat_map(|v| v.uv).fold(0.0, |a: f32, b| a.max(b.abs()));
    (0..=15).rev().find(|bits| largest * (1 << bits) as f32 <= 32_767.0).unwrap_or(0)
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
    let alpha = |v: &Vertex| {
        let v = if flat { &corners[provoking] } else { v };
        (f64::from(v.color[3].clamp(0.0, 1.0)) * 65535.0).round() as u16
    };
    let bits = unit_bits(draw);
    let uv = |v: &Vertex| v.uv.map(|c| (f64::from(c) * f64::from(1 << bits)).round() as i16);
    // Screen vertices bring their w along; the largest of a primitive comes near 2^30.
    let largest_w = corners.iter().map(|v| v.position[3]).fold(0.0, f32::max);
    // A number is not interpolated.
    let even = draw.setting("perspective") == "0" || paint != Paint::Color;
    let w = |v: &Vertex| match scene.clip || even {
        true => 1,
        false => (f64::from(v.position[3]) / f64::from(largest_w) * 1e9) as i32,
    };
    let attributes = |v: &Vertex| {
        let (surface, w) = ((color(v), alpha(v)), w(v));
        (PerspectiveCorner::new(surface, w), PerspectiveCorner::new(uv(v), w))
    };
    let test = match draw.setting("depth_test") {
        "less" => AnyDepth::Less,
        "lequal" => AnyDepth::LessEqual,
        "equal" => AnyDepth::Equal,
        "greater" => AnyDepth::Greater,
        _ => AnyDepth::Always,
    };
    let mut depth = AnyDepthState::new(if paint == Paint::Coverage { AnyDepth::Off } else { test });
    depth.read_only = draw.setting("depth_write") == "0";
    let blend = match (paint, draw.setting("blend")) {
        (Paint::Color, "alpha") => AnyBlend::Alpha,
        (Paint::Color, "add") => AnyBlend::Add,
        (Paint::Color, "mul") => AnyBlend::Multiply,
        (Paint::Color, "premul") => AnyBlend::Premultiplied,
        _ => AnyBlend::Replace,
    };
    let is_textured = paint == Paint::Color && draw.setting("textured") == "1";
    let texture = scene.texture.as_ref().filter(|_| is_textured);
    let words = texture.map(|texels| (Words::of(texels), texels));
    let sampler = words.as_ref().map(|(words, texels)| words.sampler(texels, bits));
    let shader = SceneShader { sampler };
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
            Some((clip, attributes(v)))
        };
        let vertices: Option<Vec<_>> = corners.iter().map(vertex).collect();
        let Some(vertices) = vertices else {
            return false;
        };
        let camera = Camera::custom(Mat4::identity());
        let mesh = Mesh::new(&[], &vertices);
        let pass = Pass::new(&camera).cull(cull).front_face(winding).depth(depth).blend(blend);
        pass.count(&mut stats).draw(frame, &Mat4::identity(), &mesh, &shader);
        return stats.skipped == 0;
    }
    let vertex = |v: &Vertex| {
        let [x, y, z, _] = v.position;
        (ScreenVertex::from_bits(x as i32, y as i32, screen_code(z)), attributes(v))
    };
    let pass = ScreenPass::new().cull(cull).front_face(winding).depth(depth).blend(blend);
    let mut pass = pass.count(&mut stats);
    match corners {
        [a, b, c] => pass.triangle(frame, &shader, &[a, b, c].map(vertex)),
        [a, b] => pass.lines(frame, &shader, Thin, &[[a, b].map(vertex)]),
        _ => {
            let size = draw.setting("point_size").parse().expect("a whole size");
            pass.points(frame, &shader, size, &[vertex(&corners[0])]);
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
pub(crate) fn replay(scene: &Scene, expected: &Expected) -> Report {
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
        if paint == Paint::Color {
            let [r, g, b, _] = scene.clear;
            frame.clear_color(Color::new(r, g, b));
        }
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
        for (k, channel) in colors[i].to_le_bytes().into_iter().enumerate().take(3) {
            let difference = f64::from((i32::from(channel) - i32::from(pixel.color[k])).abs());
            // As of depth; and what is rounded to whole steps moves by whole ones.
            let slope = || expected.color_slope(i, scene.width.into(), k) / 32.0;
            let moved = if scene.clip { slope().ceil() } else { 0.0 };
            report.color = report.color.max((difference - moved) as i32);
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
