use super::{Corner, DrawContext, Shader, Uv, VertexInput};
use crate::color::Color;
use crate::math::{whole, Mat4, Vec3};
use crate::scene::Normal;
use crate::texture::Sample;

/// A texture of a lit sphere, looked up by the normal as the eye sees it: the cheapest shiny metal.
///
/// The texture shows the sphere as it fills a square: its middle faces the eye, up is up. Samplers
/// need no wrap beyond [`Clamp`](crate::texture::Clamp) and the default of 12
/// [unit bits](crate::texture::Sampler::unit_bits). Source: P. Sloan et al., *The Lit Sphere: A Model
/// for Capturing NPR Shading from Art*, Graphics Interface 2001.
///
/// # Range
/// As [`Lambert`](super::Lambert): model matrices with one scale for all axes.
///
/// # Rounding
/// Normals are turned once a vertex, as long as their three bytes say: within 1/127, and linear on
/// the screen.
#[derive(Clone, Copy, Debug)]
pub struct Matcap<S> {
    sampler: S,
}

impl<S: Sample> Matcap<S> {
    /// Shades by the sphere that `sampler` shows.
    pub const fn new(sampler: S) -> Self {
        Self { sampler }
    }
}

/// Half a repeat of the texture.
const HALF: i32 = 1 << 11;

/// What a normal of length 127 is multiplied with, so that it comes to 2^11 x 2^16: the rim of the
/// sphere is left out, beyond which the texture shows nothing.
const SCALE: f32 = 0.98 * (HALF as f32 / 127.0) * 65_536.0;

impl<S: Sample> Shader for Matcap<S> {
    type Vertex = Normal;
    type Varying = Uv;
    /// Two rows of the matrix from mesh to eye: to the right, and up.
    type Prepared = [[i32; 3]; 2];

    fn prepare(&self, draw: &DrawContext) -> [[i32; 3]; 2] {
        let to_eye: Mat4 = (draw.view * draw.model).transpose();
        let row = |row: Vec3| {
            let Vec3 { x, y, z } = row.normalize() * SCALE;
            [x, y, z].map(whole)
        };
        [row(to_eye.x.truncate()), row(to_eye.y.truncate())]
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to the texture just before")]
    fn vertex(&self, [right, up]: &[[i32; 3]; 2], vertex: VertexInput<'_, Normal>) -> Corner<Uv> {
        let along = |row: &[i32; 3]| {
            // Each product is below 2^27.
            let products = row.iter().zip(vertex.attributes);
            let sum = products.fold(0_i32, |sum, (factor, component)| {
                sum.wrapping_add((factor >> 5).wrapping_mul(i32::from(*component)))
            });
            sum >> 11
        };
        let place = |at: i32| at.clamp(0, 2 * HALF - 1) as i16;
        [place(HALF.wrapping_add(along(right))), place(HALF.wrapping_sub(along(up)))]
    }

    #[inline(always)]
    fn fragment(&self, _: &Self::Prepared, uv: &Uv) -> Option<Color> {
        self.sampler.fetch(uv.u, uv.v)
    }
}
