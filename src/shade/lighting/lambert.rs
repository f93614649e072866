use super::surface::cosine;
use super::{Beam, LightKind, Lighting, Surface};
use crate::color::{Rgb, Rgb16};
use crate::scene::{DirectionalLight, Light, Normal};
use crate::shade::{Coloring, DrawContext, VertexInput};

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
pub struct Lambert<const N: usize, K = DirectionalLight> {
    lights: [Light<K>; N],
    ambient: Rgb,
    material: Rgb,
}

impl<const N: usize, K: Copy> Lambert<N, K> {
    /// White material under these lights, with an ambient light of a fifth.
    pub const fn new(lights: &[Light<K>; N]) -> Self {
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

/// Lights in mesh space, multiplied with the material.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLambert<const N: usize, K: LightKind = DirectionalLight> {
    ambient: Rgb16,
    lights: [(K::Prepared, Rgb16); N],
}

impl<const N: usize, K: LightKind> Lighting for Lambert<N, K> {
    type Lights = PreparedLambert<N, K>;

    #[inline]
    fn lights(&self, draw: &DrawContext) -> PreparedLambert<N, K> {
        let lights = self
            .lights
            .map(|light| (light.kind.prepare(draw), times(light.color(), self.material)));
        PreparedLambert { ambient: times(self.ambient, self.material), lights }
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn shine(&self, lights: &PreparedLambert<N, K>, surface: &Surface) -> Rgb16 {
        let mut sum = [lights.ambient.r, lights.ambient.g, lights.ambient.b].map(u32::from);
        for (kind, color) in &lights.lights {
            let Beam { direction, strength } = K::beam(kind, surface.position);
            let share = cosine(&surface.normal, &direction).wrapping_mul(strength) >> 15;
            for (sum, channel) in sum.iter_mut().zip([color.r, color.g, color.b]) {
                *sum = sum.wrapping_add(share.wrapping_mul(channel.into()) >> 15);
            }
        }
        let [r, g, b] = sum.map(|channel| channel.min(Rgb16::FULL.into()) as u16);
        // Limited just before.
        Rgb16 { r, g, b }
    }
}

impl<const N: usize, K: LightKind> Coloring for Lambert<N, K> {
    type Vertex = Normal;
    type Prepared = PreparedLambert<N, K>;

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> PreparedLambert<N, K> {
        self.lights(draw)
    }

    #[inline]
    fn color(&self, prepared: &PreparedLambert<N, K>, vertex: VertexInput<'_, Normal>) -> Rgb16 {
        self.shine(prepared, &Surface::of(vertex))
    }
}

/// The product of two colours, 255 x 255 being full; rounded to nearest.
#[allow(clippy::cast_possible_truncation, reason = "at most 255 x 256")]
pub(super) fn times(a: Rgb, b: Rgb) -> Rgb16 {
    let channel = |a: u8, b: u8| ((u32::from(a) * u32::from(b) * 256 + 127) / 255) as u16;
    Rgb16::new(channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b))
}

/// The product of a channel and a share of it, 65535 being all; rounded to nearest.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "no more than the channel")]
pub(super) fn product(channel: u32, share: u32) -> u16 {
    (channel.wrapping_mul(share).wrapping_add(0x8000) / 65_535) as u16
}
