use super::mesh_space::{from_world, world_step, MeshPoint};
use super::surface::dot;
use super::{Beam, Surface};
use crate::math::{reciprocal_of_some, Mat4, Vec3};
use crate::scene::{AnyLightKind, Attenuation, DirectionalLight, PointLight, SpotLight};
use crate::shade::DrawContext;

/// A kind of light, as a type: what reaches a point of a mesh.
pub trait LightKind: Copy {
    /// The light in mesh space.
    type Prepared: Copy;

    /// Runs once a draw.
    fn prepare(&self, draw: &DrawContext) -> Self::Prepared;

    /// What arrives at a position of the mesh.
    fn beam(prepared: &Self::Prepared, position: [i16; 3]) -> Beam;
}

/// A direction of the world in mesh space, of a length: for a rotation and a uniform scale the
/// transpose is the inverse but for the length.
#[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
fn turned(draw: &DrawContext, direction: Vec3, length: f32) -> [i32; 3] {
    let Vec3 { x, y, z } = draw.model.transpose().transform_vector(direction).normalize() * length;
    // `as` saturates and turns what is no number into 0.
    [x as i32, y as i32, z as i32]
}

impl LightKind for DirectionalLight {
    type Prepared = [i32; 3];

    #[inline(always)]
    fn prepare(&self, draw: &DrawContext) -> [i32; 3] {
        turned(draw, -self.direction, Beam::LENGTH as f32)
    }

    #[inline(always)]
    fn beam(direction: &[i32; 3], _position: [i16; 3]) -> Beam {
        Beam { direction: *direction, strength: Beam::FULL }
    }
}

/// A term of the attenuation: mantissa 2^-down, 16.16 when multiplied.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Term {
    mantissa: u32,
    down: u32,
}

impl Term {
    /// A coefficient; what is negative or no number is 0.
    #[allow(clippy::cast_possible_truncation, reason = "below 2^24, the float's own mantissa")]
    fn new(coefficient: f32) -> Self {
        // What is no number is not above 0 either.
        let mut mantissa = if coefficient > 0.0 { coefficient * 65_536.0 } else { 0.0 };
        let mut down = 0;
        while mantissa < 8_388_608.0 && mantissa > 0.0 && down < 60 {
            mantissa *= 2.0;
            down += 1;
        }
        Self { mantissa: mantissa as u32, down }
    }

    /// Times a number of up to 36 bits.
    fn times(self, number: u64) -> u64 {
        number.saturating_mul(self.mantissa.into()) >> (self.down & 63)
    }
}

/// A [`PointLight`] light in mesh space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreparedPoint {
    at: MeshPoint,
    constant: Term,
    linear: Term,
    quadratic: Term,
}

impl PreparedPoint {
    /// How much of the light is left after so many steps.
    #[allow(clippy::cast_possible_truncation, reason = "limited just before")]
    fn strength(&self, steps: u32) -> u32 {
        let steps = u64::from(steps);
        let sum = self
            .constant
            .times(1)
            .saturating_add(self.linear.times(steps))
            .saturating_add(self.quadratic.times(steps.saturating_mul(steps)));
        let sum = sum.min(u32::MAX.into()) as u32;
        if sum <= 1 << 16 {
            return Beam::FULL;
        }
        // 2^31 / sum; the shift is at least 46.
        let reciprocal = reciprocal_of_some(sum);
        reciprocal.mantissa >> (reciprocal.shift.wrapping_sub(31) & 31)
    }
}

impl LightKind for PointLight {
    type Prepared = PreparedPoint;

    fn prepare(&self, draw: &DrawContext) -> PreparedPoint {
        let at = MeshPoint::new(draw, self.position);
        let step = world_step(draw) * at.steps();
        let Attenuation { constant, linear, quadratic } = self.attenuation;
        PreparedPoint {
            at,
            constant: Term::new(constant),
            linear: Term::new(linear * step),
            quadratic: Term::new(quadratic * step * step),
        }
    }

    fn beam(prepared: &PreparedPoint, position: [i16; 3]) -> Beam {
        let (direction, steps) = prepared.at.seen_from(position);
        Beam { direction, strength: prepared.strength(steps) }
    }
}

/// A [`SpotLight`] light in mesh space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreparedSpot {
    point: PreparedPoint,
    /// From the cone's end to its tip, as long as a normal: so cosines come out alike.
    axis: [i32; 3],
    /// Cosine of the outer angle, 2^15 being 1, and one over the difference to the inner one's, 2^8
    /// being 1.
    outer: i32,
    slope: u32,
}

/// Of a cone without a rim.
const LEAST_WIDTH: f32 = 1.0 / 32_768.0;

impl LightKind for SpotLight {
    type Prepared = PreparedSpot;

    #[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
    fn prepare(&self, draw: &DrawContext) -> PreparedSpot {
        let width = self.inner - self.outer;
        let width = if width > LEAST_WIDTH { width } else { LEAST_WIDTH };
        PreparedSpot {
            point: self.point.prepare(draw),
            axis: turned(draw, -self.direction, Surface::LENGTH as f32),
            outer: (self.outer * 32_768.0) as i32,
            slope: (256.0 / width) as u32,
        }
    }

    #[allow(clippy::cast_possible_truncation, reason = "limited just before")]
    fn beam(prepared: &PreparedSpot, position: [i16; 3]) -> Beam {
        let mut beam = PointLight::beam(&prepared.point, position);
        let cosine = dot(&prepared.axis, &beam.direction) >> 13;
        let inside = u64::from(cosine.saturating_sub(prepared.outer).max(0).cast_unsigned());
        let share = inside.saturating_mul(prepared.slope.into()) >> 8;
        let share = share.min(Beam::FULL.into()) as u32;
        beam.strength = beam.strength.wrapping_mul(share) >> 15;
        beam
    }
}

/// A light of any kind in mesh space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PreparedAnyLight(Prepared);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Prepared {
    Directional([i32; 3]),
    Point(PreparedPoint),
    Spot(PreparedSpot),
}

impl LightKind for AnyLightKind {
    type Prepared = PreparedAnyLight;

    fn prepare(&self, draw: &DrawContext) -> PreparedAnyLight {
        PreparedAnyLight(match self {
            Self::Directional(light) => Prepared::Directional(light.prepare(draw)),
            Self::Point(light) => Prepared::Point(light.prepare(draw)),
            Self::Spot(light) => Prepared::Spot(light.prepare(draw)),
        })
    }

    fn beam(PreparedAnyLight(light): &PreparedAnyLight, position: [i16; 3]) -> Beam {
        match light {
            Prepared::Directional(light) => DirectionalLight::beam(light, position),
            Prepared::Point(light) => PointLight::beam(light, position),
            Prepared::Spot(light) => SpotLight::beam(light, position),
        }
    }
}

/// The eye seen from a mesh: a point of the world, or a direction where there is no perspective.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Eye {
    At(MeshPoint),
    Along([i32; 3]),
}

impl Eye {
    pub(super) fn new(draw: &DrawContext) -> Self {
        // From eye space to the world: the eye is its origin, and looks along -z.
        let to_world = draw.view.inverse().unwrap_or(Mat4::identity());
        let rows = draw.projection.transpose();
        let has_perspective = rows.w.x != 0.0 || rows.w.y != 0.0 || rows.w.z != 0.0;
        if has_perspective {
            Self::At(MeshPoint::new(draw, to_world.transform_point(Vec3::ZERO)))
        } else {
            let world = to_world.transform_vector(Vec3::Z);
            let Vec3 { x, y, z } = from_world(draw).transform_vector(world);
            let along = Vec3::new(x, y, z).normalize() * Beam::LENGTH as f32;
            Self::Along([along.x, along.y, along.z].map(crate::math::whole))
        }
    }

    /// Towards the eye, [`Beam::LENGTH`] long.
    pub(super) fn seen_from(&self, position: [i16; 3]) -> [i32; 3] {
        match self {
            Self::At(point) => point.seen_from(position).0,
            Self::Along(direction) => *direction,
        }
    }
}
