//! What has no light: the filled screen, ranges of depth, slivers, the head-up display.

use microraster::host::reference::{
    Draw, Fragment, Interpolation, Kind, Reference, Space, State, Vertex,
};
use microraster::{AnyBlend, AnyDepth, AnyDepthState, Color, Rgb};

use super::geometry::{in_model, space, vertices};
use super::Shading;
use crate::scenes::standard::camera;
use crate::tradeoff::{depth, fill as filled, heads_up as display, slivers as thin, Shape};

/// Red, green and blue, 0 to 255.
pub(super) fn channels(color: Rgb) -> [f64; 3] {
    [color.r, color.g, color.b].map(f64::from)
}

pub(super) fn opaque([r, g, b]: [f64; 3]) -> [f64; 4] {
    [r, g, b, 255.0]
}

/// What is nearer is seen.
pub(super) fn tested() -> AnyDepthState {
    AnyDepthState::new(AnyDepth::Less)
}

/// Draws a shape at rest in colours that come with each vertex.
fn shape(
    shape: &Shape<'_>,
    camera: &microraster::Camera,
    color: impl Fn(usize) -> [f64; 3],
    picture: &mut Reference,
) {
    let vertices = vertices(&in_model(shape), &shape.model, camera, |i, _| color(i).to_vec());
    let corners: Vec<u32> = shape.indices.iter().map(|index| u32::from(*index)).collect();
    picture.draw(&Draw {
        space: space(false),
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Linear,
        state: State { depth: tested(), ..State::PLAIN },
        shade: &as_interpolated,
    });
}

/// The colour that is interpolated.
pub(super) fn as_interpolated(fragment: &Fragment<'_>) -> Option<[f64; 4]> {
    match fragment.varyings {
        &[r, g, b] => Some(opaque([r, g, b])),
        _ => None,
    }
}

pub(super) fn fill(picture: &mut Reference) {
    shape(&filled::shape(), &camera(), |i| channels(filled::COLORS[i]), picture);
}

pub(super) fn slivers(picture: &mut Reference) {
    // Every triangle has three vertices of its own.
    shape(&thin::shape(), &camera(), |i| channels(thin::COLORS[i / 3]), picture);
}

pub(super) fn range(shading: &Shading, picture: &mut Reference) {
    let Shading::Range(setting) = shading else { return };
    let Some(ratio) = ratio_of(setting) else { return };
    // Depth without limits: what is in front is seen, wherever a range ends.
    let camera = depth::camera_of(None);
    for column in 0..depth::COLUMNS {
        for (pair, color) in depth::pair(column, ratio).iter().zip(depth::COLORS) {
            shape(pair, &camera, |_| channels(color), picture);
        }
    }
}

/// The ratio of a setting of the range, such as `infinite + 1e3`.
pub(crate) fn ratio_of(setting: &str) -> Option<f32> {
    setting.rsplit(' ').next()?.parse().ok()
}

fn window(corner: &display::Corner) -> Vertex {
    let (place, color) = corner;
    let pixels = |bits: i32| f64::from(bits) / 16.0;
    Vertex {
        position: [pixels(place.x.to_bits()), pixels(place.y.to_bits()), 0.0, 1.0],
        varyings: components(*color).to_vec(),
    }
}

fn components(color: Color) -> [f64; 4] {
    [color.red(), color.green(), color.blue(), color.alpha()].map(f64::from)
}

pub(super) fn heads_up(shading: &Shading, picture: &mut Reference) {
    match shading {
        Shading::Blended(blend) => {
            triangles(&display::BEHIND, AnyBlend::Replace, picture);
            let blend = match blend.as_str() {
                "constant-alpha" => AnyBlend::ConstantAlpha(display::ALPHA),
                "alpha" => AnyBlend::Alpha,
                "average" => AnyBlend::Average,
                "add" => AnyBlend::Add,
                "multiply" => AnyBlend::Multiply,
                _ => AnyBlend::Replace,
            };
            triangles(&display::PANEL, blend, picture);
        }
        _ => lines(picture),
    }
}

fn triangles(triangles: &[[display::Corner; 3]], blend: AnyBlend, picture: &mut Reference) {
    let vertices: Vec<Vertex> = triangles.iter().flatten().map(window).collect();
    let corners: Vec<u32> = (0..).take(vertices.len()).collect();
    picture.draw(&Draw {
        space: Space::Window,
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Linear,
        state: State { blend, ..State::PLAIN },
        shade: &|fragment| fragment.varyings.try_into().ok(),
    });
}

/// Each line as the rectangle a pixel wide about it.
fn lines(picture: &mut Reference) {
    for line in display::dial() {
        let [a, b] = line.map(|corner| window(&corner));
        let along = [0, 1].map(|i| b.position[i] - a.position[i]);
        let length = along[0].hypot(along[1]);
        let aside = [-along[1] * 0.5 / length, along[0] * 0.5 / length];
        let moved = |vertex: &Vertex, by: f64| {
            let [x, y, z, w] = vertex.position;
            let position = [x + by * aside[0], y + by * aside[1], z, w];
            Vertex { position, varyings: vertex.varyings.clone() }
        };
        let vertices = [moved(&a, -1.0), moved(&b, -1.0), moved(&b, 1.0), moved(&a, 1.0)];
        picture.draw(&Draw {
            space: Space::Window,
            kind: Kind::Triangles,
            vertices: &vertices,
            corners: &[0, 1, 2, 0, 2, 3],
            interpolation: Interpolation::Linear,
            state: State::PLAIN,
            shade: &|fragment| fragment.varyings.try_into().ok(),
        });
    }
}
