use crate::shade::VertexInput;

/// How large points are: a number of pixels for all of them, or [`SizeOf`] each.
pub trait PointSize<A> {
    /// The size of the point at a vertex in sixteenths of a pixel, at most 256 pixels; `z` is its
    /// depth code, larger the nearer.
    fn size(&self, vertex: VertexInput<'_, A>, z: u16) -> u32;
}

impl<A> PointSize<A> for u16 {
    #[inline(always)]
    fn size(&self, _vertex: VertexInput<'_, A>, _z: u16) -> u32 {
        u32::from(*self).wrapping_mul(16)
    }
}

/// A size for each point, in sixteenths of a pixel, by a function of its vertex and its depth code.
#[derive(Clone, Copy, Debug)]
pub struct SizeOf<F>(pub F);

impl<A, F: Fn(VertexInput<'_, A>, u16) -> u32> PointSize<A> for SizeOf<F> {
    #[inline(always)]
    fn size(&self, vertex: VertexInput<'_, A>, z: u16) -> u32 {
        (self.0)(vertex, z)
    }
}
