use super::vector::{greater, lesser, scale_to_one, vector_operations};

/// A vector of three floats: a point, a direction, a colour of light.
///
/// ```
/// use microraster::math::Vec3;
///
/// assert_eq!(Vec3::X.cross(Vec3::Y), Vec3::Z);
/// assert_eq!(Vec3::new(2.0, 3.0, 6.0).length(), 7.0);
/// assert_eq!(Vec3::new(1.0, -1.0, 0.0).reflect(Vec3::Y), Vec3::new(1.0, 1.0, 0.0));
/// ```
///
/// # Rounding
///
/// Each addition and multiplication rounds once, in the order written: the bits are the same on
/// every target.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Vec3 {
    /// To the right, in the spaces of this crate.
    pub x: f32,
    /// Up.
    pub y: f32,
    /// Towards the viewer.
    pub z: f32,
}

impl Vec3 {
    /// The unit vector of the first axis.
    pub const X: Self = Self::new(1.0, 0.0, 0.0);

    /// The unit vector of the second axis.
    pub const Y: Self = Self::new(0.0, 1.0, 0.0);

    /// The unit vector of the third axis.
    pub const Z: Self = Self::new(0.0, 0.0, 1.0);

    /// A vector of its components.
    #[must_use]
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Self { x, y, z }
    }

    /// The cross product, by the right-hand rule: perpendicular to both, as long as the area of
    /// their parallelogram.
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// With a fourth component: 1 for a point, 0 for a direction.
    #[must_use]
    pub const fn extend(self, w: f32) -> super::Vec4 {
        super::Vec4::new(self.x, self.y, self.z, w)
    }

    /// Some vector of length 1 that is perpendicular to this one; X for zero.
    #[must_use]
    pub fn any_perpendicular(self) -> Self {
        // Crossing with the axis of the smallest component keeps away from zero.
        let size = self.abs();
        let axis = if size.x <= size.y && size.x <= size.z {
            Self::X
        } else if size.y <= size.z {
            Self::Y
        } else {
            Self::Z
        };
        let perpendicular = self.normalize().cross(axis).normalize();
        if perpendicular == Self::ZERO {
            Self::X
        } else {
            perpendicular
        }
    }
}

vector_operations!(Vec3, 3, x, y, z);

#[cfg(test)]
mod tests {
    extern crate std;
    use super::Vec3;
    use crate::math::hard_numbers::{Random, FLOATS};
    use crate::math::{Vec2, Vec4};

    #[test]
    fn products_have_their_geometry() {
        let (a, b) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(-4.0, 5.0, 0.5));
        assert_eq!(a.cross(b), -b.cross(a));
        assert!(a.cross(b).dot(a).abs() < 1e-5);
        assert_eq!([a.dot(b).to_bits()], [7.5f32.to_bits()]);
        assert_eq!(a * b, a.component_mul(b));
        assert_eq!(2.0 * a, a + a);
        assert_eq!(a.lerp(b, 0.0), a);
        assert_eq!(a.lerp(b, 1.0), b);
        assert_eq!(a.min(b), Vec3::new(-4.0, 2.0, 0.5));
        assert_eq!(a.max(b), Vec3::new(1.0, 5.0, 3.0));
        assert_eq!(b.abs(), Vec3::new(4.0, 5.0, 0.5));
        assert_eq!(Vec3::from(<[f32; 3]>::from(a)), a);
        assert_eq!(Vec2::X.cross(Vec2::Y).to_bits(), 1.0f32.to_bits());
    }

    #[test]
    fn normalize_makes_length_one_at_every_magnitude() {
        let mut random = Random::new(9);
        let (mut worst, mut worst_fast) = (0.0, 0.0);
        for magnitude in [1e-38, 1e-30, 1e-10, 1.0, 1e10, 1e19, 1e30, 1e38] {
            for _ in 0..20_000 {
                let v = Vec3::from([(); 3].map(|()| random.float(magnitude)));
                let truth = v.to_array().map(f64::from);
                let length = truth.iter().map(|c| c * c).sum::<f64>().sqrt();
                for (ours, truth) in v.normalize().to_array().into_iter().zip(truth) {
                    worst = f64::max(worst, (f64::from(ours) - truth / length).abs());
                }
                // Subnormal lengths have a step of 1.4e-45.
                let error = (f64::from(v.length()) - length).abs();
                assert!(error <= 2.4e-7 * length + 0.8e-45, "{v:?}");
                if (1.1e-19..1e19).contains(&length) {
                    let fast = v.normalize_fast();
                    worst_fast = f64::max(worst_fast, f64::from(fast.length() - 1.0).abs());
                }
            }
        }
        std::println!("normalize: worst {worst:e}, fast {worst_fast:e}");
        assert!(worst <= 2.4e-7, "{worst:e}");
        assert!(worst_fast <= 3.5e-2, "{worst_fast:e}");
    }

    #[test]
    fn hard_numbers_never_panic_and_never_give_a_bad_direction() {
        for x in FLOATS {
            for y in FLOATS {
                let v = Vec3::new(x, 1.0, y);
                for unit in [v.normalize(), Vec2::new(x, y).normalize().extend(0.0)] {
                    let length = unit.length();
                    assert!(unit == Vec3::ZERO || (length - 1.0).abs() < 1e-6, "{v:?}");
                }
                assert_eq!(v.normalize() == Vec3::ZERO, !v.is_finite());
                assert_eq!(v.length().is_nan(), x.is_nan() || y.is_nan());
                assert!(v.normalize_fast().is_finite());
                assert!((v.any_perpendicular().length() - 1.0).abs() < 1e-6, "{v:?}");
                assert!(Vec4::new(x, y, x, y).normalize().is_finite());
                let _ = v.reflect(v).lerp(v.cross(v), x) / y;
                let _ = v.min(-v).max(v);
            }
        }
        assert_eq!(Vec3::ZERO.normalize(), Vec3::ZERO);
        assert_eq!(Vec3::new(0.0, -3.0e-45, 0.0).normalize(), -Vec3::Y);
    }
}
