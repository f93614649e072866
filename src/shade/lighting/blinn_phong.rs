use super::lambert::times;
use super::light_kind::Eye;
use super::mesh_space::normalized;
use super::shininess::Shininess;
use super::surface::{cosine, dot};
use super::{Beam, LightKind, Lighting, Surface};
use crate::color::{Rgb, Rgb16};
use crate::scene::{DirectionalLight, Light, Normal};
use crate::shade::{Coloring, DrawContext, VertexInput};

/// Ambient, diffuse and specular light from up to `N` lights, and light of the surface's own.
///
/// Source: J. Blinn, *Models of Light Reflection for Computer Synthesized Pictures*, SIGGRAPH 1977:
/// the highlight is a power of the cosine between the normal and the direction halfway from the
/// light to the eye. Kinds of light are types, as [`Light`] says.
///
/// # Range
/// As [`Lambert`](super::Lambert): model matrices with one scale for all axes.
///
/// # Rounding
/// Within 2 of 255 of the exact formula; within 8 where a light lies nearly behind the surface, seen
/// from the eye, so that the direction halfway is made of little.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlinnPhong<const N: usize, K = DirectionalLight> {
    lights: [Light<K>; N],
    ambient: Rgb,
    material: Rgb,
    specular: Rgb,
    emissive: Rgb,
    shininess: u8,
    two_sided: bool,
}

impl<const N: usize, K: Copy> BlinnPhong<N, K> {
    /// White material with a white highlight of shininess 32 under these lights, and an ambient
    /// light of a fifth.
    pub const fn new(lights: &[Light<K>; N]) -> Self {
        Self {
            lights: *lights,
            ambient: Rgb::new(51, 51, 51),
            material: Rgb::WHITE,
            specular: Rgb::WHITE,
            emissive: Rgb::BLACK,
            shininess: 32,
            two_sided: false,
        }
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

    /// The colour of highlights, and how small they are: the exponent of the cosine, 0 counting as
    /// 1.
    #[must_use]
    pub const fn specular(mut self, specular: Rgb, shininess: u8) -> Self {
        (self.specular, self.shininess) = (specular, shininess);
        self
    }

    /// Light of the surface's own.
    #[must_use]
    pub const fn emissive(mut self, emissive: Rgb) -> Self {
        self.emissive = emissive;
        self
    }

    /// Turns normals that point away from the eye, for surfaces that are seen from both sides.
    #[must_use]
    pub const fn two_sided(mut self) -> Self {
        self.two_sided = true;
        self
    }
}

/// A [`BlinnPhong`] in mesh space.
#[derive(Clone, Copy, Debug)]
pub struct PreparedBlinnPhong<const N: usize, K: LightKind> {
    /// What is there without lights.
    base: Rgb16,
    /// Each light, and its colour times that of the material and that of highlights.
    lights: [(K::Prepared, Rgb16, Rgb16); N],
    eye: Eye,
    shininess: Shininess,
}

impl<const N: usize, K: LightKind> Lighting for BlinnPhong<N, K> {
    type Lights = PreparedBlinnPhong<N, K>;

    fn lights(&self, draw: &DrawContext) -> PreparedBlinnPhong<N, K> {
        let base = times(self.ambient, self.material);
        let own = Rgb16::from(self.emissive);
        PreparedBlinnPhong {
            base: Rgb16::new(
                base.r.saturating_add(own.r),
                base.g.saturating_add(own.g),
                base.b.saturating_add(own.b),
            ),
            lights: self.lights.map(|light| {
                let color = light.color();
                let kind = light.kind.prepare(draw);
                (kind, times(color, self.material), times(color, self.specular))
            }),
            eye: Eye::new(draw),
            shininess: Shininess::new(self.shininess),
        }
    }

    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn shine(&self, lights: &PreparedBlinnPhong<N, K>, surface: &Surface) -> Rgb16 {
        let Surface { normal, position } = *surface;
        // Powers would make much of what normals of three bytes are longer or shorter than a unit.
        let (mut normal, _) = normalized(normal, Surface::LENGTH);
        let to_eye = lights.eye.seen_from(position);
        if self.two_sided && dot(&normal, &to_eye) < 0 {
            normal = normal.map(i32::wrapping_neg);
        }
        let Rgb16 { r, g, b } = lights.base;
        let mut sum = [r, g, b].map(u32::from);
        for (kind, diffuse, specular) in &lights.lights {
            let Beam { direction, strength } = K::beam(kind, position);
            let facing = cosine(&normal, &direction);
            if facing == 0 {
                continue;
            }
            let [x, y, z] = direction;
            let [u, v, w] = to_eye;
            let between = [x.wrapping_add(u), y.wrapping_add(v), z.wrapping_add(w)];
            let (halfway, _) = normalized(between, Beam::LENGTH);
            let facing = facing.wrapping_mul(strength) >> 15;
            let shine = lights.shininess.of(cosine(&normal, &halfway)).wrapping_mul(strength) >> 15;
            let channels =
                [(diffuse.r, specular.r), (diffuse.g, specular.g), (diffuse.b, specular.b)];
            for (sum, (diffuse, specular)) in sum.iter_mut().zip(channels) {
                let diffuse = facing.wrapping_mul(diffuse.into()) >> 15;
                let specular = shine.wrapping_mul(specular.into()) >> 15;
                *sum = sum.wrapping_add(diffuse).wrapping_add(specular);
            }
        }
        let [r, g, b] = sum.map(|channel| channel.min(Rgb16::FULL.into()) as u16);
        Rgb16::new(r, g, b)
    }
}

impl<const N: usize, K: LightKind> Coloring for BlinnPhong<N, K> {
    type Vertex = Normal;
    type Prepared = PreparedBlinnPhong<N, K>;

    fn prepare(&self, draw: &DrawContext) -> PreparedBlinnPhong<N, K> {
        self.lights(draw)
    }

    #[inline]
    fn color(&self, prepared: &PreparedBlinnPhong<N, K>, vertex: VertexInput<'_, Normal>) -> Rgb16 {
        self.shine(prepared, &Surface::of(vertex))
    }
}
