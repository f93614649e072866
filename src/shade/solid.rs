use core::marker::PhantomData;

use super::{Coloring, DrawContext, VertexInput};
use crate::color::{Rgb, Rgb16};

/// One colour for the whole mesh, whatever else the mesh holds.
#[derive(Debug)]
pub struct Solid<A = ()> {
    color: Rgb,
    attributes: PhantomData<fn(&A)>,
}

impl<A> Clone for Solid<A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for Solid<A> {}

impl<A> Solid<A> {
    /// All of this colour.
    pub const fn new(color: Rgb) -> Self {
        Self { color, attributes: PhantomData }
    }
}

impl<A> Coloring for Solid<A> {
    type Vertex = A;
    type Prepared = ();

    #[inline(always)]
    fn prepare(&self, _draw: &DrawContext) {}

    #[inline(always)]
    fn color(&self, (): &(), _vertex: VertexInput<'_, A>) -> Rgb16 {
        self.color.into()
    }
}
