use crate::math::Vec3;

/// A unit normal in three bytes, 127 being 1.
///
/// # Rounding
/// Directions are off by at most 0.38 degrees.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Normal(pub [i8; 3]);

impl Normal {
    /// The nearest normal to a direction of any length; zero for a zero direction.
    pub fn from_direction(direction: Vec3) -> Self {
        let Vec3 { x, y, z } = direction.normalize() * 127.0;
        let round = |v: f32| (v + if v < 0.0 { -0.5 } else { 0.5 }) as i8;
        Self([round(x), round(y), round(z)])
    }
}
