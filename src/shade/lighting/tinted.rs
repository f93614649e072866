use super::super::{Coloring, DrawContext, VertexInput};
use super::lambert::product;
use crate::color::{Rgb, Rgb16};

/// Light times the colour of each vertex: the mesh holds what the light needs, and a colour.
#[derive(Clone, Copy, Debug)]
pub struct Tinted<C>(pub C);

impl<C: Coloring> Coloring for Tinted<C> {
    type Vertex = (C::Vertex, Rgb);
    type Prepared = C::Prepared;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> C::Prepared {
        self.0.prepare(draw)
    }

    #[inline(always)]
    fn color(&self, prepared: &C::Prepared, vertex: VertexInput<'_, Self::Vertex>) -> Rgb16 {
        let (attributes, tint) = vertex.attributes;
        let light = self.0.color(prepared, VertexInput { attributes, position: vertex.position });
        let times = |a: u16, b: u8| product(a.into(), u32::from(b) * 257);
        Rgb16::new(times(light.r, tint.r), times(light.g, tint.g), times(light.b, tint.b))
    }
}
