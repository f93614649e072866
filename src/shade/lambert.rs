use super::{Coloring, DrawContext, VertexInput};
use crate::color::{Rgb, Rgb16};
use crate::math::Vec3;
use crate::scene::{Light, Normal};

/// Diffuse light: ambient, and up to `N` lights by Lambert's cosine law.
///
/// # Range
/// Normals are turned by the model matrix as by a rotation with a uniform scale; under a scale that
/// differs by axis the light is only near.
///
/// # Cost
/// About 40 instructions a vertex and light on Cortex-M4; directions go into model space once a
/// draw, so that normals are never transformed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambert<const N: usize> {
    lights: [Light; N],
    ambient: Rgb,
    material: Rgb,
}

impl<const N: usize> Lambert<N> {
    /// White material under these lights, with an ambient light of a fifth.
    pub const fn new(lights: &[Light; N]) -> Self {
        Self { lights: *lights, ambient: Rgb::new(51, 51, 51), material: Rgb::WHITE }
    }

    /// The light that is everywhere.
    #[must_use]
    pub const fn ambient(mut self, ambient: Rgb) -> Self {
        self.ambient = ambient;
        self
    }

    /// The colour of the surface: what it gives back of white light.
    #[must_use]
    pub const fn material(mut self, material: Rgb) -> Self {
        self.material = material;
        self
    }
}

/// Length of a light's direction in model space: with normals of length 127 their product is 2^21
/// where light falls straight on.
const LENGTH: f32 = 16_512.0;

/// Lights in model space, multiplied with the material.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLambert<const N: usize> {
    ambient: Rgb16,
    lights: [([i32; 3], Rgb16); N],
}

impl<const N: usize> Coloring for Lambert<N> {
    type Vertex = Normal;
    type Prepared = PreparedLambert<N>;

    #[allow(
        clippy::cast_possible_truncation,
        reason = "a float cast saturates; channels are clamped"
    )]
    fn prepare(&self, draw: &DrawContext) -> PreparedLambert<N> {
        // R^T l: for a rotation and a uniform scale the same as turning every normal by R.
        let turned = draw.model.transpose();
        let lights = self.lights.map(|light| {
            let direction = turned.transform_vector(-light.direction()).normalize() * LENGTH;
            let Vec3 { x, y, z } = direction;
            // `as` saturates and turns what is no number into 0.
            ([x as i32, y as i32, z as i32], times(light.color(), self.material))
        });
        PreparedLambert { ambient: times(self.ambient, self.material), lights }
    }

    #[inline]
    #[allow(
        clippy::cast_possible_truncation,
        reason = "a float cast saturates; channels are clamped"
    )]
    fn color(&self, prepared: &PreparedLambert<N>, vertex: VertexInput<'_, Normal>) -> Rgb16 {
        let [x, y, z] = vertex.attributes;
        let (x, y, z) = (i32::from(*x), i32::from(*y), i32::from(*z));
        let mut sum = [prepared.ambient.r, prepared.ambient.g, prepared.ambient.b].map(u32::from);
        for ([lx, ly, lz], color) in &prepared.lights {
            let cosine = x
                .wrapping_mul(*lx)
                .wrapping_add(y.wrapping_mul(*ly))
                .wrapping_add(z.wrapping_mul(*lz));
            // 0 to 2^15: normals longer than 127 do not shine brighter.
            let cosine = (cosine >> 6).clamp(0, 1 << 15) as u32;
            for (sum, channel) in sum.iter_mut().zip([color.r, color.g, color.b]) {
                *sum = sum.wrapping_add(cosine.wrapping_mul(channel.into()) >> 15);
            }
        }
        let [r, g, b] = sum.map(|channel| channel.min(Rgb16::FULL.into()) as u16);
        // Limited just before.
        Rgb16 { r, g, b }
    }
}

/// The product of two colours, 255 x 255 being full; rounded to nearest.
#[allow(clippy::cast_possible_truncation, reason = "a float cast saturates; channels are clamped")]
fn times(a: Rgb, b: Rgb) -> Rgb16 {
    let channel = |a: u8, b: u8| ((u32::from(a) * u32::from(b) * 256 + 127) / 255) as u16;
    Rgb16::new(channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b))
}
