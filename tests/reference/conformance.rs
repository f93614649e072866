//! The conformance scenes, drawn by the reference.
//!
//! All that the expected pictures say and do not call ambiguous is compared, with the bounds of
//! their own rounding: depth is stored as `f32`, colours are rounded to 8 bits.

use std::path::Path;

use microraster::host::reference::{
    self, Fragment, Interpolation, Kind, Progress, Reference, Snap, Space, State, TexelGrid,
};
use microraster::texture::AnyWrap;
use microraster::{AnyBlend, AnyDepth, AnyDepthState, Cull, Rect, Size, Winding};

use crate::expected::{Coverage, Expected};
use crate::folder::{say, scenes};
use crate::scene::{Draw, Scene, Texels, Vertex};

/// What an `f32` of 0 to 1 is rounded by at most, in codes, and as much again.
const DEPTH: f64 = 2.0 / 512.0;

/// Half a step of 8 bits, and the rounding of sums in `f64`.
const COLOR: f64 = 0.5 + 1e-6;

/// A texture as the reference takes it.
fn texture(texels: &Texels) -> reference::Texture {
    let colors: Vec<[f64; 4]> = if texels.is_rgb565 {
        let words = texels.bytes.chunks_exact(2);
        let word = |word: &[u8]| {
            let [r, g, b] = reference::compare::rgb565(u16::from_le_bytes([word[0], word[1]]));
            [r, g, b, 255.0]
        };
        words.map(word).collect()
    } else {
        let words = texels.bytes.chunks_exact(4);
        words.map(|word| [0, 1, 2, 3].map(|i| f64::from(word[i]))).collect()
    };
    let wrap = if texels.repeats { AnyWrap::Repeat } else { AnyWrap::Clamp };
    let (width, height) = (texels.width.into(), texels.height.into());
    let grid = TexelGrid { width, height, wraps: [wrap; 2] };
    reference::Texture::new(grid, &colors).expect("texels for its size")
}

fn state(draw: &Draw) -> State {
    let test = match draw.setting("depth_test") {
        "less" => AnyDepth::Less,
        "lequal" => AnyDepth::LessEqual,
        "equal" => AnyDepth::Equal,
        "greater" => AnyDepth::Greater,
        _ => AnyDepth::Always,
    };
    let read_only = draw.setting("depth_write") == "0";
    State {
        cull: match draw.setting("cull") {
            "back" => Cull::Back,
            "front" => Cull::Front,
            _ => Cull::None,
        },
        front: match draw.setting("front_face") {
            "cw" => Winding::Clockwise,
            _ => Winding::CounterClockwise,
        },
        depth: AnyDepthState { read_only, ..AnyDepthState::new(test) },
        blend: match draw.setting("blend") {
            "alpha" => AnyBlend::Alpha,
            "add" => AnyBlend::Add,
            "mul" => AnyBlend::Multiply,
            "premul" => AnyBlend::Premultiplied,
            _ => AnyBlend::Replace,
        },
        ..State::PLAIN
    }
}

/// A vertex with red, green, blue and alpha of 0 to 255, u and v.
fn vertex(scene: &Scene, vertex: &Vertex) -> reference::Vertex {
    let [x, y, z, w] = vertex.position.map(f64::from);
    let position = if scene.clip {
        // Depth runs from 1 at the near plane to 0.
        [x, y, w - z, w]
    } else {
        [x / 16.0, y / 16.0, 65_535.0 * (1.0 - z), w]
    };
    let color = vertex.color.map(|channel| f64::from(channel).clamp(0.0, 1.0) * 255.0);
    let varyings = color.into_iter().chain(vertex.uv.map(f64::from)).collect();
    reference::Vertex { position, varyings }
}

/// Draws primitives of one draw.
fn draw(picture: &mut Reference, scene: &Scene, draw: &Draw, primitives: &[Vertex]) {
    let vertices: Vec<_> = primitives.iter().map(|v| vertex(scene, v)).collect();
    let corners: Vec<u32> = (0..vertices.len() as u32).collect();
    let kind = match draw.kind {
        crate::scene::Kind::Triangles => Kind::Triangles,
        crate::scene::Kind::Lines => Kind::Lines { width: 1, progress: Progress::Nearest },
        crate::scene::Kind::Points => {
            Kind::Points { side: draw.setting("point_size").parse().expect("a size") }
        }
    };
    let is_last = draw.setting("provoking") == "last";
    let interpolation = match (draw.setting("shade"), draw.setting("perspective")) {
        ("flat", _) => {
            Interpolation::Flat { provoking: if is_last { draw.kind.corners() - 1 } else { 0 } }
        }
        (_, "0") => Interpolation::Linear,
        _ => Interpolation::Perspective,
    };
    let viewport = Rect::from_size(picture.size());
    let space = if scene.clip { Space::Clip { viewport, far: true } } else { Space::Window };
    let texels = scene.texture.as_ref().filter(|_| draw.setting("textured") == "1");
    let texture = texels.map(|texels| (texture(texels), texels.is_linear));
    let shade = |fragment: &Fragment<'_>| {
        let [r, g, b, a, u, v] = *fragment.varyings else { return None };
        let texel = match &texture {
            Some((texture, true)) => texture.bilinear([u, v]),
            Some((texture, false)) => texture.nearest([u, v]),
            None => [255.0; 4],
        };
        let color = [r, g, b, a];
        Some([0, 1, 2, 3].map(|i| color[i] * texel[i] / 255.0))
    };
    picture.draw(&reference::Draw {
        space,
        kind,
        vertices: &vertices,
        corners: &corners,
        interpolation,
        state: state(draw),
        shade: &shade,
    });
}

/// How far the reference is from what is expected.
#[derive(Clone, Copy, Debug, Default)]
struct Report {
    /// Primitives whose coverage differs where the hash is exact.
    coverage: usize,
    /// Pixels covered another number of times.
    counts: usize,
    /// Pixels that show another primitive.
    seen: usize,
    /// The largest difference of depth in codes.
    depth: f64,
    /// The largest difference of a channel in 1/255, the expected one's rounding included.
    color: f64,
    /// Pixels that were compared.
    compared: usize,
}

impl Report {
    fn is_right(&self) -> bool {
        self.coverage + self.counts + self.seen == 0
            && self.depth <= DEPTH
            && self.color <= COLOR
            && self.compared > 0
    }
}

fn compare(scene: &Scene, expected: &Expected, snap: Snap) -> Report {
    let size = Size::new(scene.width, scene.height);
    let [r, g, b, _] = scene.clear.map(f64::from);
    let blank = || Reference::new(size, [r, g, b]).snap(snap);
    let mut report = Report::default();
    let all = scene.draws.iter().flat_map(|draw| draw.primitives().map(move |p| (draw, p)));
    for ((of, primitive), expected) in all.zip(&expected.primitives) {
        let mut alone = blank();
        draw(&mut alone, scene, of, primitive);
        let width = usize::from(scene.width);
        let covered = alone.counts().iter().enumerate().filter(|(_, count)| **count > 0);
        let pixels: Vec<_> =
            covered.map(|(i, _)| ((i % width) as u16, (i / width) as u16)).collect();
        let is_exact = !scene.clip && of.kind != crate::scene::Kind::Lines;
        report.coverage += usize::from(is_exact && *expected != Coverage::of(&pixels));
    }
    let mut picture = blank();
    for of in &scene.draws {
        draw(&mut picture, scene, of, &of.vertices);
    }
    for (i, pixel) in expected.pixels.iter().enumerate().filter(|(_, p)| !p.ambiguous) {
        report.compared += 1;
        report.counts += usize::from(picture.counts()[i].min(127) != u32::from(pixel.count));
        let seen = picture.seen()[i].map_or(-1, i64::from);
        if seen != i64::from(pixel.primitive) {
            report.seen += 1;
            continue;
        }
        let code = picture.depths()[i];
        let written = scene.draws.iter().all(|draw| draw.setting("depth_write") == "1");
        if seen >= 0 && written {
            let expected = 1.0 - f64::from(pixel.depth);
            let expected = if scene.clip { 2.0 + 65_531.0 * expected } else { 65_535.0 * expected };
            report.depth = report.depth.max((code - expected).abs());
        }
        for (channel, expected) in picture.colors()[i].iter().zip(pixel.color) {
            report.color = report.color.max((channel - f64::from(expected)).abs());
        }
    }
    report
}

fn check(path: &Path) -> (Report, Report) {
    let text = std::fs::read_to_string(path).expect("a scene that can be read");
    let scene = Scene::parse(&text).expect("a scene");
    let bytes = std::fs::read(path.with_extension("exp")).expect("its picture");
    let expected = Expected::parse(&bytes).expect("a picture");
    let exact = compare(&scene, &expected, Snap::Exact);
    // Positions in windows lie on the grid of the crate.
    let snapped = if scene.clip { exact } else { compare(&scene, &expected, Snap::Bits(4)) };
    (exact, snapped)
}

#[test]
fn scenes_look_as_another_reference_says() {
    let mut wrong = 0;
    let scenes = scenes();
    for path in &scenes {
        let (exact, snapped) = check(path);
        let is_right = exact.is_right() && snapped.is_right();
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        println!("{name}: {}, {exact:?}", if is_right { "right" } else { "WRONG" });
        wrong += usize::from(!is_right);
    }
    say(&format!("{} scenes drawn by the reference", scenes.len()));
    assert_eq!(wrong, 0, "of {} scenes these are wrong", scenes.len());
}
