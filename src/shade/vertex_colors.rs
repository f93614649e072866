use super::{Coloring, DrawContext, VertexInput};
use crate::color::{Rgb, Rgb16};

/// The colours that the mesh holds, unlit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct VertexColors;

impl Coloring for VertexColors {
    type Vertex = Rgb;
    type Prepared = ();

    #[inline(always)]
    fn prepare(&self, _draw: &DrawContext) {}

    #[inline(always)]
    fn color(&self, (): &(), vertex: VertexInput<'_, Rgb>) -> Rgb16 {
        (*vertex.attributes).into()
    }
}
