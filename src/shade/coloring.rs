use super::{DrawContext, VertexInput};
use crate::color::Rgb16;

/// Where the colours of [`Flat`](super::Flat) and [`Gouraud`](super::Gouraud) come from.
///
/// [`Lambert`](super::Lambert) lights normals, [`VertexColors`](super::VertexColors) takes colours
/// from the mesh, [`Solid`](super::Solid) is one colour for all.
pub trait Coloring {
    /// What the mesh holds for each vertex, or for each face.
    type Vertex;
    /// What is made once a draw.
    type Prepared;

    /// Runs once a draw.
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared;

    /// The colour of a vertex.
    fn color(&self, prepared: &Self::Prepared, vertex: VertexInput<'_, Self::Vertex>) -> Rgb16;
}
