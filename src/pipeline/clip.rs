use crate::math::Vec4;

/// A position in clip space: homogeneous, 32-bit integers of one common scale.
///
/// Visible is what has `|x| <= w`, `|y| <= w`, `0 <= z <= w` and `w > 0`; y points up, and z / w is
/// 1 at the near plane and falls with distance.
///
/// # Range
/// Below [`Clip::LIMIT`] in magnitude. All positions of one draw share one scale: the largest w
/// should come near the limit, since what is left below counts in units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clip {
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) z: i32,
    pub(crate) w: i32,
}

impl Clip {
    /// What coordinates stay below in magnitude: 2^30.
    pub const LIMIT: i32 = 1 << 30;

    /// A position from integers; `None` if one is not below [`LIMIT`](Self::LIMIT).
    pub const fn new(x: i32, y: i32, z: i32, w: i32) -> Option<Self> {
        const fn fits(v: i32) -> bool {
            v.unsigned_abs() < Clip::LIMIT as u32
        }
        if fits(x) && fits(y) && fits(z) && fits(w) {
            Some(Self { x, y, z, w })
        } else {
            None
        }
    }

    /// A position from floats, multiplied by `scale`, which must be the same for all vertices of a
    /// draw: `0.99 * LIMIT / (largest coordinate)` uses the range best.
    ///
    /// `None` where a product is not finite or not below [`LIMIT`](Self::LIMIT).
    #[allow(clippy::cast_possible_truncation, reason = "in range as compared just before")]
    pub fn from_f32(position: Vec4, scale: f32) -> Option<Self> {
        let coordinate = |v: f32| {
            let scaled = v * scale;
            // False for what is no number.
            let fits = scaled > -(Self::LIMIT as f32) && scaled < Self::LIMIT as f32;
            fits.then(|| (scaled + if scaled < 0.0 { -0.5 } else { 0.5 }) as i32)
        };
        let Vec4 { x, y, z, w } = position;
        Self::new(coordinate(x)?, coordinate(y)?, coordinate(z)?, coordinate(w)?)
    }
}
