//! From meshes to clip space, in `f64`.

use microraster::host::reference::{Space, Vertex};
use microraster::math::{Mat4, Vec3};
use microraster::{Camera, Normal, Rect};

use crate::scenes::standard::SIZE;
use crate::tradeoff::Shape;

pub(super) type Vector = [f64; 3];

fn wide(v: Vec3) -> Vector {
    [v.x, v.y, v.z].map(f64::from)
}

fn times(m: &Mat4, [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    let [a, b, c, d] = m.to_columns().map(|column| column.map(f64::from));
    [0, 1, 2, 3].map(|i| a[i] * x + b[i] * y + c[i] * z + d[i] * w)
}

pub(super) fn unit(v: Vector) -> Vector {
    let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
    v.map(|v| if length > 0.0 { v / length } else { 0.0 })
}

/// The mesh's positions in its model space.
pub(super) fn in_model(shape: &Shape<'_>) -> Vec<Vector> {
    let (scale, offset) = (wide(shape.scale), wide(shape.offset));
    let place = |p: &[i16; 3]| [0, 1, 2].map(|i| f64::from(p[i]) * scale[i] + offset[i]);
    shape.positions.iter().map(place).collect()
}

/// Where a place of model space is in the world.
pub(super) fn in_world(model: &Mat4, [x, y, z]: Vector) -> Vector {
    let [x, y, z, _] = times(model, [x, y, z, 1.0]);
    [x, y, z]
}

/// A normal of the mesh in the world, of length 1.
pub(super) fn normal_in_world(model: &Mat4, normal: Normal) -> Vector {
    let [x, y, z] = normal.map(f64::from);
    let [x, y, z, _] = times(model, [x, y, z, 0.0]);
    unit([x, y, z])
}

/// Where a place of the world is in clip space.
pub(super) fn in_clip(camera: &Camera, [x, y, z]: Vector) -> [f64; 4] {
    let aspect = f32::from(SIZE.width) / f32::from(SIZE.height);
    times(&camera.projection(aspect), times(&camera.view(), [x, y, z, 1.0]))
}

/// How far along the view a place of the world is.
pub(super) fn distance(camera: &Camera, [x, y, z]: Vector) -> f64 {
    -times(&camera.view(), [x, y, z, 1.0])[2]
}

/// Clip space over the whole picture.
pub(super) fn space(far: bool) -> Space {
    Space::Clip { viewport: Rect::from_size(SIZE), far }
}

/// Vertices of a shape seen by a camera; `varyings` by the number of the vertex and its place in the
/// world.
pub(super) fn vertices(
    places: &[Vector],
    model: &Mat4,
    camera: &Camera,
    mut varyings: impl FnMut(usize, Vector) -> Vec<f64>,
) -> Vec<Vertex> {
    let vertex = |(i, place): (usize, &Vector)| {
        let world = in_world(model, *place);
        Vertex { position: in_clip(camera, world), varyings: varyings(i, world) }
    };
    places.iter().enumerate().map(vertex).collect()
}
