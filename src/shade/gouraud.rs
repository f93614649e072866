use super::{
    Coloring, Corner, DrawContext, Lambert, LightKind, Row, Shader, SmoothColor, State,
    VertexColors, VertexInput,
};
use crate::color::{Color, Format};
use crate::scene::Light;

/// Gouraud shading: colours made at the vertices and interpolated between them.
///
/// Source: H. Gouraud, *Continuous Shading of Curved Surfaces*, IEEE Transactions on Computers
/// C-20 (1971).
///
/// # Measured
/// <!-- tradeoff: teapot/normals=vertex -->
/// `vertex` in the scene `teapot`: 1.61 M (M4F), 2.69 M (M0+), 1.75 M (RV32) instructions a frame; PSNR 37.2 dB.
#[derive(Clone, Copy, Debug)]
pub struct Gouraud<C>(C);

impl<C: Coloring> Gouraud<C> {
    /// Gouraud shading with colours from `coloring`.
    pub const fn new(coloring: C) -> Self {
        Self(coloring)
    }
}

impl Gouraud<VertexColors> {
    /// The colours that the mesh holds.
    pub const fn colored() -> Self {
        Self(VertexColors)
    }
}

impl<const N: usize, K: LightKind> Gouraud<Lambert<N, K>> {
    /// Lit by `lights`, white, with the ambient light of [`Lambert::new`].
    pub fn lit(lights: &[Light<K>; N]) -> Self {
        Self(Lambert::new(lights))
    }
}

impl<C: Coloring> Shader for Gouraud<C> {
    type Vertex = C::Vertex;
    type Varying = SmoothColor;
    type Prepared = C::Prepared;

    const COLOR_AS_IS: bool = true;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> C::Prepared {
        self.0.prepare(draw)
    }

    #[inline(always)]
    fn vertex(
        &self,
        prepared: &C::Prepared,
        vertex: VertexInput<'_, C::Vertex>,
    ) -> Corner<SmoothColor> {
        self.0.color(prepared, vertex).into()
    }

    #[inline(always)]
    fn fragment(&self, _: &Self::Prepared, varying: &SmoothColor) -> Option<Color> {
        Some(varying.color())
    }

    #[inline(always)]
    fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, SmoothColor>) {
        row.each_as_is();
    }
}
