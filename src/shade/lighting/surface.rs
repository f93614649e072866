use super::super::{DrawContext, VertexInput};
use crate::color::Rgb16;
use crate::scene::Normal;

/// A point of a surface, in mesh space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Surface {
    /// Its normal, [`LENGTH`](Self::LENGTH) long where it is a unit.
    pub normal: [i32; 3],
    /// Where it is, in steps of the mesh's positions.
    pub position: [i16; 3],
}

impl Surface {
    /// The length of a unit normal: 127 x 128.
    pub const LENGTH: i32 = 127 << 7;

    /// The surface at a vertex.
    #[inline(always)]
    pub fn of(vertex: VertexInput<'_, Normal>) -> Self {
        let normal = vertex.attributes.map(|component| i32::from(component) << 7);
        Self { normal, position: vertex.position }
    }
}

/// What a surface makes of light: [`Lambert`](super::Lambert) or
/// [`BlinnPhong`](super::BlinnPhong).
pub trait Lighting {
    /// Lights and material in mesh space, made once a draw.
    type Lights: Copy;

    /// Runs once a draw.
    fn lights(&self, draw: &DrawContext) -> Self::Lights;

    /// The colour that a point of the surface shows.
    fn shine(&self, lights: &Self::Lights, surface: &Surface) -> Rgb16;
}

/// The cosine between a normal and a direction, 0 where it is negative; 2^15 is 1, which normals
/// longer than a unit do not exceed.
#[inline(always)]
pub(super) fn cosine(normal: &[i32; 3], direction: &[i32; 3]) -> u32 {
    (dot(normal, direction) >> 13).clamp(0, 1 << 15).cast_unsigned()
}

/// The same for a normal as the mesh holds it, 127 long where it is a unit: the same bits, since no
/// sum of products is as large as 2^31 / 128.
#[inline(always)]
pub(super) fn vertex_cosine(normal: &[i32; 3], direction: &[i32; 3]) -> u32 {
    (dot(normal, direction) >> 6).clamp(0, 1 << 15).cast_unsigned()
}

/// The sum of products, below 2^31 for normals of up to twice the unit's length.
#[inline(always)]
pub(super) fn dot([x, y, z]: &[i32; 3], [u, v, w]: &[i32; 3]) -> i32 {
    x.wrapping_mul(*u).wrapping_add(y.wrapping_mul(*v)).wrapping_add(z.wrapping_mul(*w))
}
