use super::vector::{greater, lesser, scale_to_one, vector_operations};
use super::Vec3;

/// A vector of four floats: homogeneous coordinates, where (x, y, z, w) stands for the point
/// (x/w, y/w, z/w) and w = 0 for a direction.
///
/// ```
/// use microraster::math::{Vec3, Vec4};
///
/// let clip = Vec4::new(2.0, 4.0, 1.0, 2.0);
/// assert_eq!(clip.project(), Vec3::new(1.0, 2.0, 0.5));
/// ```
///
/// # Rounding
///
/// Each addition and multiplication rounds once, in the order written: the bits are the same on
/// every target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec4 {
    /// The first component.
    pub x: f32,
    /// The second component.
    pub y: f32,
    /// The third component.
    pub z: f32,
    /// The divisor of the others; in clip space the distance from the eye along its axis.
    pub w: f32,
}

impl Vec4 {
    /// The unit vector of the first axis.
    pub const X: Self = Self::new(1.0, 0.0, 0.0, 0.0);

    /// The unit vector of the second axis.
    pub const Y: Self = Self::new(0.0, 1.0, 0.0, 0.0);

    /// The unit vector of the third axis.
    pub const Z: Self = Self::new(0.0, 0.0, 1.0, 0.0);

    /// The unit vector of the fourth axis, which is the origin as a point.
    pub const W: Self = Self::new(0.0, 0.0, 0.0, 1.0);

    /// A vector of its components.
    #[must_use]
    pub const fn new(x: f32, y: f32, z: f32, w: f32) -> Self {
        Self { x, y, z, w }
    }

    /// The first three components.
    #[must_use]
    pub const fn truncate(self) -> Vec3 {
        Vec3::new(self.x, self.y, self.z)
    }

    /// The point that these coordinates stand for: x, y and z divided by w.
    ///
    /// # Range
    ///
    /// For w = 0 the components are infinite or NaN.
    #[must_use]
    pub fn project(self) -> Vec3 {
        self.truncate() / self.w
    }
}

vector_operations!(Vec4, 4, x, y, z, w);
