use crate::color::Rgb;
use crate::math::{Angle, Vec3};

/// A light of a kind: [`DirectionalLight`], [`PointLight`], [`SpotLight`], or [`AnyLightKind`].
///
/// The kind is a type, so that a scene with nothing but a sun contains nothing but that.
///
/// ```
/// use microraster::math::{AngleUnits, Vec3};
/// use microraster::{Attenuation, Light, Rgb};
///
/// let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE);
/// let lamp = Light::point(Vec3::new(0.0, 2.0, 0.0), Rgb::WHITE)
///     .attenuation(Attenuation::new(1.0, 0.0, 0.25));
/// let torch = Light::spot(Vec3::ZERO, -Vec3::Z, 20.0.degrees(), 30.0.degrees(), Rgb::WHITE);
/// let mixed = [sun.any(), lamp.any(), torch.any()];
/// # let _ = mixed;
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light<K = DirectionalLight> {
    pub(crate) kind: K,
    color: Rgb,
}

/// Light from everywhere along one direction, like the sun's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionalLight {
    /// Where the light travels to, in world space, of any length.
    pub direction: Vec3,
}

/// Light from one point to all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointLight {
    /// Where it is, in world space.
    pub position: Vec3,
    /// How it fades with distance.
    pub attenuation: Attenuation,
}

/// Light from one point in a cone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLight {
    /// Where it is, in world space, and how it fades with distance.
    pub point: PointLight,
    /// The cone's axis, in world space, of any length.
    pub direction: Vec3,
    /// Cosine of the angle to the axis up to which light is full.
    pub inner: f32,
    /// Cosine of the angle from which on there is none; between them it falls with the cosine.
    pub outer: f32,
}

/// A light of any kind, chosen when the program runs.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnyLightKind {
    /// As [`DirectionalLight`].
    Directional(DirectionalLight),
    /// As [`PointLight`].
    Point(PointLight),
    /// As [`SpotLight`].
    Spot(SpotLight),
}

/// How light fades with distance d, in units of the world: `1 / (constant + linear d + quadratic
/// d^2)`, and never more than 1.
///
/// Source: OpenGL 1.5, section 2.14.1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attenuation {
    pub(crate) constant: f32,
    pub(crate) linear: f32,
    pub(crate) quadratic: f32,
}

impl Attenuation {
    /// Light that does not fade.
    pub const NONE: Self = Self::new(1.0, 0.0, 0.0);

    /// An attenuation from its three coefficients; negative ones count as 0.
    pub const fn new(constant: f32, linear: f32, quadratic: f32) -> Self {
        Self { constant, linear, quadratic }
    }
}

impl Light<DirectionalLight> {
    /// Light that travels in `direction` (of any length, in world space) everywhere.
    pub const fn directional(direction: Vec3, color: Rgb) -> Self {
        Self { kind: DirectionalLight { direction }, color }
    }

    /// Where the light travels to, in world space.
    pub const fn direction(&self) -> Vec3 {
        self.kind.direction
    }

    /// The same as a light of any kind.
    pub const fn any(self) -> Light<AnyLightKind> {
        Light { kind: AnyLightKind::Directional(self.kind), color: self.color }
    }
}

impl Light<PointLight> {
    /// Light from a position in world space to all sides, which does not fade.
    pub const fn point(position: Vec3, color: Rgb) -> Self {
        Self { kind: PointLight { position, attenuation: Attenuation::NONE }, color }
    }

    /// Sets how it fades with distance.
    #[must_use]
    pub const fn attenuation(mut self, attenuation: Attenuation) -> Self {
        self.kind.attenuation = attenuation;
        self
    }

    /// The same as a light of any kind.
    pub const fn any(self) -> Light<AnyLightKind> {
        Light { kind: AnyLightKind::Point(self.kind), color: self.color }
    }
}

impl Light<SpotLight> {
    /// Light from a position along a direction, both in world space: full up to the angle `inner`
    /// from the axis, none from `outer` on, and not fading with distance.
    pub const fn spot(
        position: Vec3,
        direction: Vec3,
        inner: Angle,
        outer: Angle,
        color: Rgb,
    ) -> Self {
        let point = PointLight { position, attenuation: Attenuation::NONE };
        let kind = SpotLight { point, direction, inner: inner.cos(), outer: outer.cos() };
        Self { kind, color }
    }

    /// Sets how it fades with distance.
    #[must_use]
    pub const fn attenuation(mut self, attenuation: Attenuation) -> Self {
        self.kind.point.attenuation = attenuation;
        self
    }

    /// The same as a light of any kind.
    pub const fn any(self) -> Light<AnyLightKind> {
        Light { kind: AnyLightKind::Spot(self.kind), color: self.color }
    }
}

impl<K> Light<K> {
    /// Its colour at full strength.
    pub const fn color(&self) -> Rgb {
        self.color
    }
}
