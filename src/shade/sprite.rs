use core::marker::PhantomData;

use super::{Corner, DrawContext, PointCoordinates, Shader, VertexInput};
use crate::color::Color;
use crate::texture::Sample;

/// Points that show a texture, upright and whole: its first texel is at the point's upper left.
///
/// The sampler keeps its default of 12 [unit bits](crate::texture::Sampler::unit_bits). For sprites
/// with holes see [`Cutout`](super::Cutout). What the mesh holds for its vertices, `A`, is not looked
/// at, but may be by the [size](crate::PointSize).
#[derive(Debug)]
pub struct Sprite<S, A = ()> {
    sampler: S,
    attributes: PhantomData<fn() -> A>,
}

impl<S, A> Sprite<S, A> {
    /// Shows what `sampler` gives.
    pub const fn new(sampler: S) -> Self {
        Self { sampler, attributes: PhantomData }
    }
}

impl<S: Copy, A> Clone for Sprite<S, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Copy, A> Copy for Sprite<S, A> {}

impl<S: Sample, A> Shader for Sprite<S, A> {
    type Vertex = A;
    type Varying = PointCoordinates;
    type Prepared = ();

    #[inline(always)]
    fn prepare(&self, _: &DrawContext) {}

    #[inline(always)]
    fn vertex(&self, (): &(), _: VertexInput<'_, A>) -> Corner<PointCoordinates> {}

    #[inline(always)]
    fn fragment(&self, (): &(), at: &PointCoordinates) -> Option<Color> {
        let uv = at.uv();
        self.sampler.fetch(uv.u, uv.v)
    }
}
