use super::{Corner, DrawContext, Shader, VertexInput};
use crate::color::Color;
use crate::pipeline::Clip;

/// Another shader of which only what is opaque enough is drawn: the alpha test, for leaves, fences
/// and sprites. What is left out leaves colour, depth and stencil as they are.
///
/// ```
/// use microraster::texture::{Rgba5551, Sampler, Texture, TextureError};
/// use microraster::{Cutout, Textured};
///
/// # fn main() -> Result<(), TextureError> {
/// // Red, and a hole.
/// static FENCE: [u16; 2] = [0xF801, 0x0000];
/// let texture = Texture::<Rgba5551>::new(&FENCE, 2, 1)?;
/// let shader = Cutout::new(Textured::new(Sampler::nearest(texture)?), 128);
/// # let _ = shader;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Cutout<S> {
    shader: S,
    least: u8,
}

impl<S> Cutout<S> {
    /// Draws where the alpha of `shader` is at least `least`.
    pub const fn new(shader: S, least: u8) -> Self {
        Self { shader, least }
    }
}

impl<S: Shader> Shader for Cutout<S> {
    type Vertex = S::Vertex;
    type Varying = S::Varying;
    type Prepared = S::Prepared;

    const OWN_POSITIONS: bool = S::OWN_POSITIONS;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> S::Prepared {
        self.shader.prepare(draw)
    }

    #[inline(always)]
    fn position(&self, prepared: &S::Prepared, vertex: &S::Vertex) -> Option<Clip> {
        self.shader.position(prepared, vertex)
    }

    #[inline(always)]
    fn vertex(
        &self,
        prepared: &S::Prepared,
        vertex: VertexInput<'_, S::Vertex>,
    ) -> Corner<S::Varying> {
        self.shader.vertex(prepared, vertex)
    }

    #[inline(always)]
    fn fragment(&self, prepared: &S::Prepared, varying: &S::Varying) -> Option<Color> {
        self.shader.fragment(prepared, varying).filter(|color| color.alpha() >= self.least)
    }
}
