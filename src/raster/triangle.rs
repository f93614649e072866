use super::ScreenVertex;
#[cfg(doc)]
use super::GUARD;
use crate::frame::Size;
use crate::math::BY_HALVES;

/// Twice the area of a triangle in square subpixels; positive when its corners run clockwise on
/// the screen.
///
/// # Range
/// Exact for coordinates in the square of [`GUARD`]: at most 2^35 in magnitude.
///
/// # Cost
/// On ARMv6-M, which has no long products, 32-bit ones while every side is shorter than 1448
/// pixels.
#[inline(always)]
pub fn twice_area(v: &[ScreenVertex; 3]) -> i64 {
    let [a, b, c] = v;
    area_of_sides(
        b.x_bits().wrapping_sub(a.x_bits()),
        b.y_bits().wrapping_sub(a.y_bits()),
        c.x_bits().wrapping_sub(a.x_bits()),
        c.y_bits().wrapping_sub(a.y_bits()),
    )
}

/// The cross product of two sides.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "a constant below 2^15")]
pub(crate) fn area_of_sides(x1: i32, y1: i32, x2: i32, y2: i32) -> i64 {
    /// Two sides this long span a box whose area fits an i32: floor(sqrt(2^31) / 2).
    const SHORT: u32 = 23_170;
    let within = |side: i32| side.wrapping_add(SHORT as i32) as u32 <= 2 * SHORT;
    // Where long products are a single instruction, they are cheaper than the question.
    if BY_HALVES && within(x1) && within(y1) && within(x2) && within(y2) {
        // The result fits, so that a wrap of one product is undone by the difference.
        i64::from(x1.wrapping_mul(y2).wrapping_sub(x2.wrapping_mul(y1)))
    } else {
        let (x1, y1, x2, y2) = (i64::from(x1), i64::from(y1), i64::from(x2), i64::from(y2));
        x1.wrapping_mul(y2).wrapping_sub(x2.wrapping_mul(y1))
    }
}

/// A triangle ready to be drawn: corners clockwise on the screen, area above zero, in range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// The corners, clockwise on the screen.
    pub(crate) v: [ScreenVertex; 3],
    /// Twice the area in square subpixels, above zero.
    pub(crate) area: i64,
    /// Whether the second and the third corner changed places to make it clockwise.
    pub(crate) flipped: bool,
}

impl Triangle {
    /// A triangle without area: a place to put another.
    pub(crate) const EMPTY: Self =
        Self { v: [ScreenVertex::from_bits(0, 0, 0); 3], area: 0, flipped: false };

    /// Takes three corners in any order.
    ///
    /// `None` if the area is zero or a corner lies outside of the square of [`GUARD`] about the
    /// centre of `picture`.
    pub fn new(v: [ScreenVertex; 3], picture: Size) -> Option<Self> {
        if Self::in_range(&v, picture) {
            Self::oriented(v)
        } else {
            None
        }
    }

    /// Whether all corners lie in the square of [`GUARD`] about the centre of `picture`.
    pub fn in_range(v: &[ScreenVertex; 3], picture: Size) -> bool {
        v.iter().all(|v| v.in_range(picture))
    }

    /// Takes three corners that lie in range, in any order; `None` if the area is zero.
    #[inline(always)]
    pub(crate) fn oriented(v: [ScreenVertex; 3]) -> Option<Self> {
        let area = twice_area(&v);
        let [a, b, c] = v;
        match area {
            0 => None,
            1.. => Some(Self { v, area, flipped: false }),
            _ => Some(Self { v: [a, c, b], area: area.wrapping_neg(), flipped: true }),
        }
    }

    /// The corners, clockwise on the screen.
    pub fn vertices(&self) -> &[ScreenVertex; 3] {
        &self.v
    }

    /// Twice the area in square subpixels.
    pub fn twice_area(&self) -> i64 {
        self.area
    }

    /// Whether the second and the third corner changed places.
    pub fn is_flipped(&self) -> bool {
        self.flipped
    }
}
