use super::{DrawContext, Shader, VertexInput};
use crate::color::Color;

/// White everywhere, without attributes: what is under a [`Textured`](super::Textured) that stands
/// alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unlit;

impl Shader for Unlit {
    type Vertex = ();
    type Varying = ();
    type Prepared = ();

    #[inline(always)]
    fn prepare(&self, _draw: &DrawContext) {}

    #[inline(always)]
    fn vertex(&self, (): &(), _vertex: VertexInput<'_, ()>) {}

    #[inline(always)]
    fn fragment(&self, _: &Self::Prepared, (): &()) -> Option<Color> {
        Some(Color::new(255, 255, 255))
    }
}
