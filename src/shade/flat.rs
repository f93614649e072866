use super::{
    Coloring, Corner, DrawContext, FlatColor, Lambert, LightKind, Row, Shader, Solid, State,
    VertexColors, VertexInput,
};
use crate::color::{Color, Format, Rgb};
use crate::scene::Light;

/// Flat shading: one colour a triangle, taken from its first vertex or from its face.
///
/// # Cost
/// Only one of a triangle's corners is lit; without depth, pixels are filled by whole words.
///
/// # Measured
/// <!-- tradeoff: teapot/normals=face -->
/// `face` in the scene `teapot`: 1.14 M (M4F), 1.66 M (M0+), 1.18 M (RV32) instructions a frame; PSNR 23.2 dB.
#[derive(Clone, Copy, Debug)]
pub struct Flat<C>(C);

impl<C: Coloring> Flat<C> {
    /// Flat shading with colours from `coloring`.
    pub const fn new(coloring: C) -> Self {
        Self(coloring)
    }
}

impl<A> Flat<Solid<A>> {
    /// One colour for the whole mesh.
    pub const fn solid(color: Rgb) -> Self {
        Self(Solid::new(color))
    }
}

impl Flat<VertexColors> {
    /// The colours that the mesh holds.
    pub const fn colored() -> Self {
        Self(VertexColors)
    }
}

impl<const N: usize, K: LightKind> Flat<Lambert<N, K>> {
    /// Lit by `lights`, white, with the ambient light of [`Lambert::new`].
    pub fn lit(lights: &[Light<K>; N]) -> Self {
        Self(Lambert::new(lights))
    }
}

impl<C: Coloring> Shader for Flat<C> {
    type Vertex = C::Vertex;
    type Varying = FlatColor;
    type Prepared = C::Prepared;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> C::Prepared {
        self.0.prepare(draw)
    }

    #[inline(always)]
    fn vertex(
        &self,
        prepared: &C::Prepared,
        vertex: VertexInput<'_, C::Vertex>,
    ) -> Corner<FlatColor> {
        self.0.color(prepared, vertex).into()
    }

    #[inline(always)]
    fn fragment(&self, _: &Self::Prepared, varying: &FlatColor) -> Option<Color> {
        Some(varying.color())
    }

    #[inline(always)]
    fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, FlatColor>) {
        let color = row.varying.color();
        row.fill(color);
    }
}
