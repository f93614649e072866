use crate::color::Rgb;
use crate::math::Vec3;

/// A light: so far a directional one, like the sun.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    direction: Vec3,
    color: Rgb,
}

impl Light {
    /// Light that travels in `direction` (of any length, in world space) everywhere.
    pub const fn directional(direction: Vec3, color: Rgb) -> Self {
        Self { direction, color }
    }

    /// Where the light travels to, in world space.
    pub const fn direction(&self) -> Vec3 {
        self.direction
    }

    /// Its colour at full strength.
    pub const fn color(&self) -> Rgb {
        self.color
    }
}
