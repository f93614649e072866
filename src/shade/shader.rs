use super::{Corner, Row, State, Varying};
use crate::color::{Color, Format};
use crate::frame::Size;
use crate::math::{Mat4, Vec3};
use crate::pipeline::Clip;

/// What a shader may know once a draw.
#[derive(Clone, Copy, Debug)]
pub struct DrawContext {
    /// From model space to world space.
    pub model: Mat4,
    /// From world space to eye space: the camera looks along -z.
    pub view: Mat4,
    /// From eye space to clip space.
    pub projection: Mat4,
    /// What one step of a mesh position is in model space, by axis.
    pub scale: Vec3,
    /// Where mesh position 0 lies in model space.
    pub offset: Vec3,
    /// The viewport in pixels.
    pub viewport: Size,
}

/// A vertex as the mesh holds it.
#[derive(Debug)]
pub struct VertexInput<'a, A> {
    /// What the mesh holds beside the position.
    pub attributes: &'a A,
    /// The mesh's own position, in steps from the place of 0 ([`DrawContext`] says of both where
    /// they are in model space); zero where the shader brings positions of its own. Of a face with
    /// attributes of its own, the first corner's.
    pub position: [i16; 3],
}

impl<A> Clone for VertexInput<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for VertexInput<'_, A> {}

impl DrawContext {
    /// From model space to clip space.
    pub fn model_view_projection(&self) -> Mat4 {
        self.projection * (self.view * self.model)
    }
}

/// Makes pixels of triangles: two short methods, and more for those who want it.
///
/// Methods take `&self`: uniforms are fields. See `examples/shader/toon.rs` for one of a user's kind.
///
/// # Cost
/// [`prepare`](Self::prepare) runs once a draw, [`vertex`](Self::vertex) once a vertex of
/// triangles that survive culling, [`fragment`](Self::fragment) once a visible pixel, inlined into
/// the loop: a `Some` and the `&self` are free.
pub trait Shader {
    /// What the mesh holds for each vertex beside its position.
    type Vertex;
    /// What is interpolated: `()`, a building block, or pairs of them.
    type Varying: Varying;
    /// What is made once a draw: lights in model space, palettes, combined matrices.
    type Prepared;

    /// Whether [`position`](Self::position) gives the positions instead of the mesh.
    const OWN_POSITIONS: bool = false;

    /// Whether fragments are the colour that the varying carries, as it is, and
    /// [`span`](Self::span) draws them by [`Row::each_as_is`]: then dithering may begin at the
    /// corners.
    const COLOR_AS_IS: bool = false;

    /// Runs once a draw.
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared;

    /// The position of a vertex in clip space, where [`OWN_POSITIONS`](Self::OWN_POSITIONS) says
    /// so; `None` skips its triangles.
    #[inline(always)]
    fn position(&self, _prepared: &Self::Prepared, _vertex: &Self::Vertex) -> Option<Clip> {
        None
    }

    /// The varyings of a vertex.
    fn vertex(
        &self,
        prepared: &Self::Prepared,
        vertex: VertexInput<'_, Self::Vertex>,
    ) -> Corner<Self::Varying>;

    /// The colour of a pixel; `None` discards it: neither colour nor depth is written.
    fn fragment(&self, prepared: &Self::Prepared, varying: &Self::Varying) -> Option<Color>;

    /// A run of pixels. Override to hoist work out of the loop, or to fill.
    #[inline(always)]
    fn span<S: State, F: Format>(
        &self,
        prepared: &Self::Prepared,
        row: Row<'_, S, F, Self::Varying>,
    ) {
        row.each(|varying| self.fragment(prepared, varying));
    }
}

/// What draws pixels: a shader, and what it prepared for the draw.
#[doc(hidden)]
pub trait Fragments {
    /// What is interpolated.
    type Varying: Varying;
    /// As [`Shader::COLOR_AS_IS`].
    const COLOR_AS_IS: bool;

    /// The colour of a pixel.
    fn fragment(&self, varying: &Self::Varying) -> Option<Color>;

    /// A run of pixels.
    fn span<S: State, F: Format>(&self, row: Row<'_, S, F, Self::Varying>);
}

/// A shader that is ready for a draw.
#[derive(Debug)]
pub(crate) struct Bound<'a, H: Shader> {
    pub(crate) shader: &'a H,
    pub(crate) prepared: &'a H::Prepared,
}

impl<H: Shader> Fragments for Bound<'_, H> {
    type Varying = H::Varying;
    const COLOR_AS_IS: bool = H::COLOR_AS_IS;

    #[inline(always)]
    fn fragment(&self, varying: &H::Varying) -> Option<Color> {
        self.shader.fragment(self.prepared, varying)
    }

    #[inline(always)]
    fn span<S: State, F: Format>(&self, mut row: Row<'_, S, F, H::Varying>) {
        row.announce();
        self.shader.span(self.prepared, row);
    }
}
