//! Light on surfaces, by the formulas that the crate's lights stand for.
//!
//! All in world space. With the unit normal n, the direction to the eye v, and for each light
//! the direction l towards it, its strength s and its colour c:
//!
//! ```text
//! Lambert      ambient material + sum of  c s  material min(max(n.l, 0), 1)
//! Blinn-Phong  emissive + ambient material
//!              + sum of  c s (material n.l + specular max(n.h, 0)^shininess),  where n.l > 0
//!              with h = (l + v) / |l + v|
//! ```
//!
//! Colours are 0 to 255, and products of two are divided by 255. The sum is limited to 255.

use crate::math::Vec3;
use crate::scene::{AnyLightKind, Attenuation, Light, PointLight};

type Vector = [f64; 3];

/// What light falls on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Where it is, in the world.
    pub point: [f64; 3],
    /// Its normal, of length 1; as long as it is stored, if that is to be seen in diffuse light.
    pub normal: [f64; 3],
}

/// What a surface makes of light; colours are 0 to 255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// The light that is everywhere.
    pub ambient: [f64; 3],
    /// What the surface gives back of white light.
    pub color: [f64; 3],
    /// The colour of highlights.
    pub specular: [f64; 3],
    /// The exponent of highlights.
    pub shininess: f64,
    /// Light of the surface's own.
    pub emissive: [f64; 3],
    /// Whether a normal that points away from the eye is turned; for highlights and what comes
    /// with them.
    pub two_sided: bool,
}

impl Material {
    /// White without highlights, under an ambient light of a fifth.
    pub const WHITE: Self = Self {
        ambient: [51.0; 3],
        color: [255.0; 3],
        specular: [0.0; 3],
        shininess: 1.0,
        emissive: [0.0; 3],
        two_sided: false,
    };
}

fn wide(v: Vec3) -> Vector {
    [v.x, v.y, v.z].map(f64::from)
}

fn difference(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: Vector) -> Vector {
    let length = dot(v, v).sqrt();
    v.map(|component| component / length)
}

fn from_point(light: &PointLight, point: Vector) -> (Vector, f64) {
    let way = difference(wide(light.position), point);
    let d = dot(way, way).sqrt();
    let Attenuation { constant, linear, quadratic } = light.attenuation;
    let [constant, linear, quadratic] =
        [constant, linear, quadratic].map(|coefficient| f64::from(coefficient.max(0.0)));
    (unit(way), (1.0 / (constant + linear * d + quadratic * d * d)).min(1.0))
}

/// The direction towards a light from a point, of length 1, and how much of it arrives, 0 to 1.
///
/// | kind | how much, at distance d and angle a to the axis |
/// | --- | --- |
/// | directional | 1 |
/// | point | `1 / (constant + linear d + quadratic d^2)`, at most 1 |
/// | spot | that, times `(cos a - outer) / (inner - outer)` as 0 to 1 |
#[must_use]
pub fn arriving(light: &Light<AnyLightKind>, point: [f64; 3]) -> ([f64; 3], f64) {
    match &light.kind {
        AnyLightKind::Directional(light) => (unit(wide(-light.direction)), 1.0),
        AnyLightKind::Point(light) => from_point(light, point),
        AnyLightKind::Spot(light) => {
            let (towards, strength) = from_point(&light.point, point);
            let cosine = -dot(towards, unit(wide(light.direction)));
            let (inner, outer) = (f64::from(light.inner), f64::from(light.outer));
            (towards, strength * ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0))
        }
    }
}

fn channels(light: &Light<AnyLightKind>) -> Vector {
    let color = light.color();
    [color.r, color.g, color.b].map(f64::from)
}

/// Diffuse light: ambient, and all lights by Lambert's cosine law, as
/// [`Lambert`](crate::Lambert).
#[must_use]
pub fn lambert(lights: &[Light<AnyLightKind>], material: &Material, surface: &Surface) -> [f64; 3] {
    let mut sum = [0, 1, 2].map(|i| material.ambient[i] * material.color[i] / 255.0);
    for light in lights {
        let (towards, strength) = arriving(light, surface.point);
        let share = strength * dot(surface.normal, towards).clamp(0.0, 1.0);
        let color = channels(light);
        sum = [0, 1, 2].map(|i| sum[i] + share * color[i] * material.color[i] / 255.0);
    }
    sum.map(|channel| channel.min(255.0))
}

/// Ambient, diffuse and specular light and the surface's own, as [`BlinnPhong`](crate::BlinnPhong);
/// `to_eye` is the direction towards the eye, of any length.
#[must_use]
pub fn blinn_phong(
    lights: &[Light<AnyLightKind>],
    material: &Material,
    surface: &Surface,
    to_eye: [f64; 3],
) -> [f64; 3] {
    let to_eye = unit(to_eye);
    let is_turned = material.two_sided && dot(surface.normal, to_eye) < 0.0;
    let normal = if is_turned { surface.normal.map(|v| -v) } else { surface.normal };
    let own = |i: usize| material.emissive[i] + material.ambient[i] * material.color[i] / 255.0;
    let mut sum = [0, 1, 2].map(own);
    for light in lights {
        let (towards, strength) = arriving(light, surface.point);
        let facing = dot(normal, towards);
        if facing <= 0.0 {
            continue;
        }
        let halfway = unit([0, 1, 2].map(|i| towards[i] + to_eye[i]));
        let shine = dot(normal, halfway).max(0.0).powf(material.shininess);
        let color = channels(light);
        let lit = |i: usize| material.color[i] * facing + material.specular[i] * shine;
        sum = [0, 1, 2].map(|i| sum[i] + strength * color[i] / 255.0 * lit(i));
    }
    sum.map(|channel| channel.min(255.0))
}
