use super::vector::{greater, lesser, scale_to_one, vector_operations};

/// A vector of two floats: a place on the screen, a texture coordinate.
///
/// ```
/// use microraster::math::Vec2;
///
/// let corner = Vec2::new(3.0, 4.0);
/// assert_eq!(corner.length(), 5.0);
/// assert_eq!(corner.perpendicular(), Vec2::new(-4.0, 3.0));
/// ```
///
/// # Rounding
///
/// Each addition and multiplication rounds once, in the order written: the bits are the same on
/// every target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec2 {
    /// To the right.
    pub x: f32,
    /// The second axis; whether up or down is the space's business.
    pub y: f32,
}

impl Vec2 {
    /// The unit vector of the first axis.
    pub const X: Self = Self::new(1.0, 0.0);

    /// The unit vector of the second axis.
    pub const Y: Self = Self::new(0.0, 1.0);

    /// A vector of its components.
    #[must_use]
    pub const fn new(x: f32, y: f32) -> Self {
        Self { x, y }
    }

    /// This vector turned by 90 degrees from x towards y.
    #[must_use]
    pub fn perpendicular(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// The cross product's only component: twice the area of the triangle of the two vectors,
    /// positive if `other` lies on the side to which x turns into y.
    #[must_use]
    pub fn cross(self, other: Self) -> f32 {
        self.x * other.y - self.y * other.x
    }

    /// With a third component.
    #[must_use]
    pub const fn extend(self, z: f32) -> super::Vec3 {
        super::Vec3::new(self.x, self.y, z)
    }
}

vector_operations!(Vec2, 2, x, y);
