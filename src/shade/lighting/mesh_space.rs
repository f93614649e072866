use super::Beam;
use crate::math::{inverse_sqrt, whole, InverseSqrt, Mat4, Vec3};
use crate::shade::DrawContext;

/// A point of the world seen from a mesh: in steps of the mesh's longest axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct MeshPoint {
    at: [i32; 3],
    /// What a position of the mesh is multiplied with, 2^14 being 1: axes may differ in scale.
    factors: [i32; 3],
    /// By how many bits all is shifted down, so that a far point fits.
    down: u32,
}

/// From world space to model space; of a matrix that has no inverse, as if it were none.
pub(super) fn from_world(draw: &DrawContext) -> Mat4 {
    draw.model.inverse().unwrap_or(Mat4::identity())
}

/// The largest magnitude; by its bits, so that what is no number is larger than all.
fn largest([x, y, z]: [f32; 3]) -> f32 {
    let bits = |v: f32| v.abs().to_bits();
    f32::from_bits(bits(x).max(bits(y)).max(bits(z)))
}

/// What one step of a mesh's longest axis is, in model space; never zero.
fn step(draw: &DrawContext) -> f32 {
    let Vec3 { x, y, z } = draw.scale;
    let longest = largest([x, y, z]);
    if longest > 0.0 {
        longest
    } else {
        1.0
    }
}

/// The same in the world, for a model matrix with one scale for all axes.
pub(super) fn world_step(draw: &DrawContext) -> f32 {
    let Vec3 { x, y, z } = draw.model.transform_vector(Vec3::X);
    step(draw) * crate::math::sqrt(x * x + y * y + z * z)
}

/// The largest magnitude of a far point's coordinates.
const FAR: f32 = 65_535.0;

impl MeshPoint {
    pub(super) fn new(draw: &DrawContext, world: Vec3) -> Self {
        let step = step(draw);
        let steps = (from_world(draw).transform_point(world) - draw.offset) * (1.0 / step);
        let longest = largest([steps.x, steps.y, steps.z]);
        // Halved until it fits; what is farther yet keeps its direction.
        let (mut scale, mut down) = (1.0, 0);
        while longest * scale > FAR && down < 14 {
            scale *= 0.5;
            down += 1;
        }
        if longest * scale > FAR {
            scale = FAR / longest;
        }
        let numbers = |v: Vec3, by: f32| [v.x, v.y, v.z].map(|v| number(v * by));
        Self { at: numbers(steps, scale), factors: numbers(draw.scale, 16_384.0 / step), down }
    }

    /// The way from a position of the mesh to the point: its direction, [`Beam::LENGTH`] long, and
    /// its length, below 2^18, in so many [`steps`](Self::steps).
    #[inline(never)]
    pub(super) fn seen_from(&self, position: [i16; 3]) -> ([i32; 3], u32) {
        let mut way = self.at;
        for ((way, position), factor) in way.iter_mut().zip(position).zip(self.factors) {
            let position = i32::from(position).wrapping_mul(factor) >> (14 + (self.down & 15));
            *way = way.wrapping_sub(position);
        }
        normalized(way, Beam::LENGTH)
    }

    /// Steps of the mesh in one of the lengths that [`seen_from`](Self::seen_from) gives.
    pub(super) fn steps(&self) -> f32 {
        (1_u32 << (self.down & 15)) as f32
    }
}

/// A float as a number; 0 for what is none.
fn number(v: f32) -> i32 {
    if v.is_nan() {
        0
    } else {
        whole(v + 0.5_f32.copysign(v))
    }
}

/// A vector made `unit` long, and the length that it had: zero stays zero.
///
/// # Range
/// Components below 2^29, `unit` at most 2^15.
///
/// # Rounding
/// Within 0.02 % and one step, which is what [`inverse_sqrt`] and 14 bits give.
#[inline(never)]
pub(crate) fn normalized(vector: [i32; 3], unit: i32) -> ([i32; 3], u32) {
    let [x, y, z] = vector.map(|v| (v ^ (v >> 31)).cast_unsigned());
    // The longest component in 14 bits.
    let room = (x | y | z).leading_zeros();
    let (up, down) = (room.saturating_sub(18), 18_u32.saturating_sub(room));
    let scaled = vector.map(|v| v.wrapping_shl(up) >> (down & 31));
    let square = scaled.iter().fold(0_i32, |sum, v| sum.wrapping_add(v.wrapping_mul(*v)));
    let square = square.cast_unsigned();
    if square == 0 {
        return ([0; 3], 0);
    }
    // The shift is 16 to 31.
    let InverseSqrt { mantissa, shift } = inverse_sqrt(square);
    let one = |v: i32| {
        let of_one = v.wrapping_mul(mantissa.cast_signed()) >> (shift.wrapping_sub(15) & 31);
        of_one.wrapping_mul(unit) >> 15
    };
    let length = (square >> 13).wrapping_mul(mantissa >> 2) >> (shift.wrapping_sub(15) & 31);
    (scaled.map(one), length.wrapping_shl(down) >> (up & 31))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;

    #[test]
    fn any_vector_becomes_a_unit_in_its_direction() {
        let mut random = Random::new(17);
        for round in 0..200_000_u32 {
            let bits = round % 28;
            let mut component = || (random.word().cast_signed() >> 3) >> bits;
            let vector = [component(), component(), component()];
            let length = vector.iter().map(|v| f64::from(*v).powi(2)).sum::<f64>();
            let length = std_sqrt(length);
            let (unit, measured) = normalized(vector, Beam::LENGTH);
            if length == 0.0 {
                assert_eq!((unit, measured), ([0; 3], 0), "zero");
                continue;
            }
            for (seen, exact) in unit.iter().zip(vector) {
                let exact = f64::from(exact) / length * f64::from(Beam::LENGTH);
                let error = (f64::from(*seen) - exact).abs();
                assert!(error <= 2e-4 * f64::from(Beam::LENGTH) + 2.0, "{vector:?}: {unit:?}");
            }
            let error = (f64::from(measured) - length).abs();
            assert!(error <= 4e-4 * length + 2.0, "{vector:?}: {measured} is not {length}");
        }
    }

    fn std_sqrt(v: f64) -> f64 {
        extern crate std;
        v.sqrt()
    }
}
