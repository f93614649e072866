use super::surface::{cosine, vertex_cosine};
use super::{Beam, LightKind, Lighting, Surface};
use crate::color::{Rgb, Rgb16};
use crate::math::forget;
use crate::scene::{DirectionalLight, Light, Normal};
use crate::shade::{Coloring, DrawContext, VertexInput};

/// Diffuse light: ambient, and up to `N` lights by Lambert's cosine law.
///
/// # Range
/// Normals are turned by the model matrix as by a rotation with a uniform scale; under a scale that
/// differs by axis the light is only near.
///
/// # Cost
/// About 30 instructions a vertex and light on Cortex-M4, 50 on Cortex-M0+; directions go into model
/// space once a draw, so that normals are never transformed.
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

/// Lights in mesh space, multiplied with the material, a word a channel: words load in pairs.
#[derive(Clone, Copy, Debug)]
pub struct PreparedLambert<const N: usize, K: LightKind = DirectionalLight> {
    ambient: [u32; 3],
    lights: [(K::Prepared, [u32; 3]); N],
    /// Whether all of the light together is more than a colour holds.
    is_bright: bool,
}

impl<const N: usize, K: LightKind> PreparedLambert<N, K> {
    /// The light at a place under cosines to directions.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits")]
    fn sum(&self, position: [i16; 3], cosine: impl Fn(&[i32; 3]) -> u32) -> Rgb16 {
        let mut sum = [0_u32; 3];
        for (kind, color) in &self.lights {
            let Beam { direction, strength } = K::beam(kind, position);
            // No more than all, whatever a kind of light says.
            let share = (cosine(&direction).wrapping_mul(strength) >> 15).min(1 << 15);
            if N == 1 {
                // Channels are read here, or the normal has no registers.
                forget();
            }
            for (sum, channel) in sum.iter_mut().zip(color) {
                *sum = sum.wrapping_add(share.wrapping_mul(*channel) >> 15);
            }
        }
        for (sum, channel) in sum.iter_mut().zip(&self.ambient) {
            *sum = sum.wrapping_add(*channel);
        }
        if self.is_bright {
            sum = sum.map(|channel| channel.min(Rgb16::FULL.into()));
        }
        // No more than full.
        let [r, g, b] = sum.map(|channel| channel as u16);
        Rgb16 { r, g, b }
    }
}

impl<const N: usize, K: LightKind> Lighting for Lambert<N, K> {
    type Lights = PreparedLambert<N, K>;

    #[inline]
    fn lights(&self, draw: &DrawContext) -> PreparedLambert<N, K> {
        let lights = self
            .lights
            .map(|light| (light.kind.prepare(draw), words(light.color(), self.material)));
        let ambient = words(self.ambient, self.material);
        let mut most = ambient;
        for (_, color) in &lights {
            for (most, channel) in most.iter_mut().zip(color) {
                *most = most.saturating_add(*channel);
            }
        }
        let is_bright = most.iter().any(|channel| *channel > u32::from(Rgb16::FULL));
        PreparedLambert { ambient, lights, is_bright }
    }

    #[inline(always)]
    fn shine(&self, lights: &PreparedLambert<N, K>, surface: &Surface) -> Rgb16 {
        lights.sum(surface.position, |direction| cosine(&surface.normal, direction))
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
        let [x, y, z] = vertex.attributes;
        let normal = [i32::from(*x), i32::from(*y), i32::from(*z)];
        prepared.sum(vertex.position, |direction| vertex_cosine(&normal, direction))
    }
}

/// The product of two colours, 255 x 255 being full; rounded to nearest.
#[allow(clippy::cast_possible_truncation, reason = "at most 255 x 256")]
pub(super) fn times(a: Rgb, b: Rgb) -> Rgb16 {
    let channel = |a: u8, b: u8| ((u32::from(a) * u32::from(b) * 256 + 127) / 255) as u16;
    Rgb16::new(channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b))
}

/// The same, a word a channel.
fn words(a: Rgb, b: Rgb) -> [u32; 3] {
    let Rgb16 { r, g, b } = times(a, b);
    [r, g, b].map(u32::from)
}

/// The product of a channel and a share of it, 65535 being all; rounded to nearest.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "no more than the channel")]
pub(super) fn product(channel: u32, share: u32) -> u16 {
    (channel.wrapping_mul(share).wrapping_add(0x8000) / 65_535) as u16
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;

    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "in range, or cut on purpose")]
    fn a_vertex_is_lit_as_its_surface_and_channels_stop_at_full() {
        let mut random = Random::new(34);
        let (mut bright, mut dim) = (0, 0);
        for _ in 0..20_000 {
            let mut byte = || u8::try_from(random.word() >> 24).unwrap_or(0);
            let mut rgb = || Rgb::new(byte(), byte(), byte());
            let (ambient, material) = (rgb(), rgb());
            let colors = [rgb(), rgb()];
            let scale = 1 + random.word() % 3;
            let halved = |channel: u8| u32::from(channel) / scale;
            let dimmed = |c: Rgb| Rgb::new(halved(c.r) as u8, halved(c.g) as u8, halved(c.b) as u8);
            let ambient = words(dimmed(ambient), material);
            let colors = colors.map(|color| words(dimmed(color), material));
            let lights = colors.map(|color| {
                // As long as a direction gets by rounding, or a little longer.
                let mut axis = || (random.float(16_520.0)) as i32;
                ([axis(), axis(), axis()], color)
            });
            let sum = |i: usize| ambient[i] + colors.iter().map(|color| color[i]).sum::<u32>();
            let most = sum(0).max(sum(1)).max(sum(2));
            let is_bright = most > u32::from(Rgb16::FULL);
            *(if is_bright { &mut bright } else { &mut dim }) += 1;
            let prepared = PreparedLambert::<2, DirectionalLight> { ambient, lights, is_bright };
            for _ in 0..20 {
                let [a, b, c, _] = random.word().to_le_bytes().map(u8::cast_signed);
                let input = VertexInput { attributes: &[a, b, c], position: [0; 3] };
                let surface = Surface::of(input);
                let lambert = Lambert::<2> {
                    lights: [Light::directional(crate::math::Vec3::X, Rgb::WHITE); 2],
                    ambient: Rgb::BLACK,
                    material: Rgb::WHITE,
                };
                // The definition: every channel limited.
                let channel = |i: usize| {
                    let sum = lights.iter().fold(ambient[i], |sum, (way, color)| {
                        sum + ((cosine(&surface.normal, way) * color[i]) >> 15)
                    });
                    sum.min(Rgb16::FULL.into()) as u16
                };
                let expected = Rgb16 { r: channel(0), g: channel(1), b: channel(2) };
                assert_eq!(lambert.color(&prepared, input), expected, "{input:?} by {prepared:?}");
                assert_eq!(
                    lambert.shine(&prepared, &surface),
                    expected,
                    "{input:?} by {prepared:?}"
                );
            }
        }
        assert!(bright > 1000 && dim > 1000, "{bright} bright, {dim} dim");
    }
}
