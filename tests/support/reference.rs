//! Golden pictures as the reference renderer takes them.

use microraster::host::reference::lighting::{lambert, Material, Surface};
use microraster::host::reference::{
    self, DepthPrecision, Fragment, Interpolation, Progress, Reference, Snap, Space, State, Vertex,
};
use microraster::math::{Mat4, Vec3};
use microraster::{AnyDepth, AnyDepthState, AnyOperation, Light, Rect, Rgb, Stencil, Topology};

use crate::scenes::golden::render::{AMBIENT, MATERIAL, SUN, SUN_COLOR, TONES, TOWARDS_LIGHT};
use crate::scenes::golden::shapes::Attributes;
use crate::scenes::golden::{
    Draw, FragmentState, Kind, MeshDraw, Picture, ScreenCorner, ScreenDraw, Shade,
};

/// A colour of 0 to 255.
type Color = [f64; 3];

/// The colours of a picture, by rows.
pub(crate) type Colors = Vec<Color>;

fn channels(color: Rgb) -> Color {
    [color.r, color.g, color.b].map(f64::from)
}

fn vector(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|v| v * v).sum::<f64>().sqrt()
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Columns of a matrix.
fn columns(m: &Mat4) -> [[f64; 4]; 4] {
    m.to_columns().map(|column| column.map(f64::from))
}

fn transform(m: &Mat4, [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    let [a, b, c, d] = columns(m);
    [0, 1, 2, 3].map(|i| a[i] * x + b[i] * y + c[i] * z + d[i] * w)
}

fn opaque([r, g, b]: Color) -> Option<[f64; 4]> {
    Some([r, g, b, 255.0])
}

/// The colours of a picture as it is seen `look` pixels beside each pixel's centre, with corners on
/// a grid.
pub(crate) fn colors(picture: &Picture, look: [f64; 2], snap: Snap) -> Colors {
    let mut canvas = Reference::new(picture.size, channels(picture.background))
        .depth_precision(DepthPrecision::Codes)
        .snap(snap);
    for draw in picture.draws {
        match draw {
            Draw::Mesh(draw) => {
                canvas = canvas.look(look);
                mesh(&mut canvas, draw);
            }
            // What lies on the grid is drawn where it is.
            Draw::Screen(draw) => {
                canvas = canvas.look([0.0; 2]);
                screen(&mut canvas, draw);
            }
        }
    }
    canvas.colors().to_vec()
}

fn state(test: AnyDepth, fragments: Option<FragmentState>) -> State {
    let FragmentState { blend, offset, range, stencil, .. } =
        fragments.unwrap_or(FragmentState::PLAIN);
    let (compare, reference, on_pass) = stencil;
    let keep = AnyOperation::Keep;
    let stencil = Stencil::new(compare, reference).on_fail(keep).on_depth_fail(keep);
    State {
        depth: AnyDepthState { offset, range, ..AnyDepthState::new(test) },
        stencil: Some(stencil.on_pass(on_pass)),
        blend,
        ..State::PLAIN
    }
}

fn mesh(canvas: &mut Reference, draw: &MeshDraw) {
    let arrays = draw.shape.arrays();
    let (camera, model) = ((draw.camera)(), (draw.model)());
    let viewport = draw.viewport.unwrap_or(Rect::from_size(canvas.size()));
    let projection = camera.projection(viewport.width() as f32 / viewport.height() as f32);
    // Without a far plane, clip z is the same everywhere.
    let far = columns(&projection).iter().take(3).any(|column| column[2] != 0.0);
    let vertex = |(i, position): (usize, &[i16; 3])| {
        let (scale, offset) = (vector(arrays.scale), vector(arrays.offset));
        let [x, y, z] = [0, 1, 2].map(|i| f64::from(position[i]) * scale[i] + offset[i]);
        let world = transform(&model, [x, y, z, 1.0]);
        let position = transform(&projection, transform(&camera.view(), world));
        Vertex { position, varyings: varyings(draw, &model, i) }
    };
    let vertices: Vec<Vertex> = arrays.positions.iter().enumerate().map(vertex).collect();
    let corners: Vec<u32> = arrays.topology.iter().flatten().collect();
    let interpolation = match draw.shade {
        Shade::Flat | Shade::Solid(_) => Interpolation::Flat { provoking: 0 },
        Shade::Gouraud | Shade::Toon => Interpolation::Linear,
    };
    let shade = |fragment: &Fragment<'_>| match (draw.shade, arrays.attributes) {
        (Shade::Solid(color), _) => opaque(channels(color)),
        (_, Attributes::FaceColors(colors)) => {
            opaque(channels(colors[fragment.primitive as usize]))
        }
        (Shade::Toon, _) => {
            let [tone] = *fragment.varyings else { return None };
            opaque(channels(TONES[tone.clamp(0.0, 3.999) as usize]))
        }
        _ => opaque(fragment.varyings.try_into().ok()?),
    };
    canvas.draw(&reference::Draw {
        space: Space::Clip { viewport, far },
        kind: reference::Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation,
        state: State {
            cull: draw.cull,
            front: draw.front,
            scissor: draw.scissor,
            ..state(draw.depth, draw.fragments)
        },
        shade: &shade,
    });
}

/// What a vertex of a mesh brings: its colour, or its tone.
fn varyings(draw: &MeshDraw, model: &Mat4, i: usize) -> Vec<f64> {
    let normals = match draw.shape.arrays().attributes {
        Attributes::FaceColors(_) => return Vec::new(),
        Attributes::Colors(colors) => return channels(colors[i]).to_vec(),
        Attributes::Normals(normals) => normals,
    };
    let own = normals[i].map(|v| f64::from(v) / 127.0);
    let [x, y, z, _] = transform(model, [own[0], own[1], own[2], 0.0]);
    // In the world, and as long as it is stored.
    let normal = [x, y, z].map(|v| v / length([x, y, z]) * length(own));
    if draw.shade == Shade::Toon {
        let towards = vector(TOWARDS_LIGHT);
        let cosine = dot(normal, towards) / length(towards);
        return vec![(cosine + 1.0) * 127.0 * 4096.0 / 16.0 / 16_384.0];
    }
    let material =
        Material { ambient: channels(AMBIENT), color: channels(MATERIAL), ..Material::WHITE };
    let sun = Light::directional(SUN, SUN_COLOR).any();
    lambert(&[sun], &material, &Surface { point: [0.0; 3], normal }).to_vec()
}

fn screen(canvas: &mut Reference, draw: &ScreenDraw) {
    let corners: Vec<ScreenCorner> = (0..).map_while(draw.corner).collect();
    let vertex = |&(x, y, code, color): &ScreenCorner| {
        let [x, y] = [x, y].map(|subpixels| f64::from(subpixels) / 16.0);
        let [r, g, b] = channels(color);
        Vertex { position: [x, y, code.into(), 1.0], varyings: vec![r, g, b, x, y] }
    };
    let vertices: Vec<Vertex> = corners.iter().map(vertex).collect();
    let each = 0..vertices.len() as u32;
    let line = |width| reference::Kind::Lines { width, progress: Progress::Longer };
    let point = |side: u16| reference::Kind::Points { side: side.into() };
    let (kind, corners): (_, Vec<u32>) = match draw.kind {
        Kind::Triangles => (reference::Kind::Triangles, each.collect()),
        Kind::Lines => (line(1), each.collect()),
        Kind::Wide(width) => (line(width.into()), each.collect()),
        Kind::Stippled(..) => (line(1), each.skip(1).flat_map(|i| [i - 1, i]).collect()),
        Kind::Points(side) | Kind::Round(side) => (point(side), each.collect()),
    };
    let shade = |fragment: &Fragment<'_>| {
        let [r, g, b, x, y] = *fragment.varyings else { return None };
        let is_drawn = match draw.kind {
            Kind::Stippled(pattern, factor) => {
                pattern >> (fragment.step / u32::from(factor) % 16) & 1 != 0
            }
            Kind::Round(side) => {
                let (column, row) = (f64::from(fragment.x), f64::from(fragment.y));
                (column + 0.5 - x).hypot(row + 0.5 - y) < f64::from(side) / 2.0
            }
            _ => true,
        };
        is_drawn.then_some([r, g, b, 255.0])
    };
    canvas.draw(&reference::Draw {
        space: Space::Window,
        kind,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Linear,
        state: state(draw.depth, draw.fragments),
        shade: &shade,
    });
}
