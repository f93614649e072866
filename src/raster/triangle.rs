use super::few::{few_of, Sides};
use super::{Few, Limits, Nothing, Point, ScreenVertex, GUARD, SUBPIXELS};
use crate::frame::Size;
use crate::math::{rare, BY_HALVES};

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

/// The square in which corners must lie: that of [`GUARD`] about the centre of a picture.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Guard {
    /// Its least coordinates, in subpixels.
    left: i32,
    top: i32,
}

/// The side of the square, in subpixels. Corners on its last line are in range.
const SIDE: u32 = 2 * (GUARD * SUBPIXELS).cast_unsigned();

impl Guard {
    /// About the centre of `picture`.
    pub(crate) fn about(picture: Size) -> Self {
        let least = |length: u16| i32::from(length) * SUBPIXELS / 2 - GUARD * SUBPIXELS;
        Self { left: least(picture.width), top: least(picture.height) }
    }

    /// The least coordinates in it, and the greatest.
    pub(super) fn ends(&self) -> (Point, Point) {
        let Self { left: x, top: y } = *self;
        let last = |least: i32| least.wrapping_add(SIDE.cast_signed());
        (Point { x, y }, Point { x: last(x), y: last(y) })
    }

    /// Whether three corners lie in it.
    #[inline(always)]
    fn contains(&self, a: &ScreenVertex, b: &ScreenVertex, c: &ScreenVertex) -> bool {
        let right = |v: &ScreenVertex| v.x_bits().wrapping_sub(self.left).cast_unsigned();
        let down = |v: &ScreenVertex| v.y_bits().wrapping_sub(self.top).cast_unsigned();
        // The side is a power of two: one question for all but what lies on the last line.
        let any = right(a) | down(a) | right(b) | down(b) | right(c) | down(c);
        any < SIDE || [a, b, c].iter().all(|v| right(v) <= SIDE && down(v) <= SIDE)
    }
}

const _: () = assert!(SIDE.is_power_of_two(), "one question serves");

/// A triangle of corners that may be anywhere, and what must hold of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fitted {
    guard: Guard,
    /// Of those that are asked whether they cover [few](Few) pixels.
    limits: Limits,
    /// Whether those are left out whose corners run clockwise, and counter-clockwise.
    culled: [bool; 2],
    /// The triangle, where [`set`](Self::set) makes it.
    pub(crate) triangle: Triangle,
}

impl Fitted {
    /// No triangle yet, of a picture.
    pub(crate) fn new(picture: Size, limits: Limits, culled: [bool; 2]) -> Self {
        let guard = Guard::about(picture);
        Self { guard, limits: limits.within(&guard), culled, triangle: Triangle::EMPTY }
    }

    /// Takes three corners, in any order: which few pixels they cover, where that is asked and so, or that
    /// they are no triangle to be drawn; otherwise puts the triangle in place of the one before.
    ///
    /// # Cost
    /// Some 125 instructions of few pixels on Cortex-M4, 180 on Cortex-M0+; 90 and 130 of all others. One
    /// copy for all shaders.
    #[inline(never)]
    pub(crate) fn set(&mut self, a: &ScreenVertex, b: &ScreenVertex, c: &ScreenVertex) -> Few {
        let [p, q, r] = [a, b, c].map(Point::of);
        let sides = &Sides::of(p, q, r);
        // What wraps here is nothing of short sides, which few pixels have.
        let area = sides.short_area();
        // One less than the area of those that are turned.
        if ((area ^ (area >> 31)).cast_unsigned()) < self.limits.largest {
            // Without an area too: edge functions of corners in one place are zero, and not below.
            let (turned, few) = if area <= 0 {
                (true, few_of::<true>(p, sides, area, &self.limits))
            } else {
                (false, few_of::<false>(p, sides, area, &self.limits))
            };
            if few != Few::UNKNOWN {
                if !self.culls(turned) {
                    return few;
                }
                // Whether there is an area is asked here alone.
                rare();
                let has_none = core::hint::black_box(area) == 0;
                return Few::none(if has_none { Nothing::Degenerate } else { Nothing::Culled });
            }
        }
        self.set_any(a, b, c)
    }

    /// The same of a triangle that is not one of few pixels.
    #[inline(never)]
    fn set_any(&mut self, a: &ScreenVertex, b: &ScreenVertex, c: &ScreenVertex) -> Few {
        if !self.guard.contains(a, b, c) {
            return Few::none(Nothing::Beyond);
        }
        let area = area_of_sides(
            b.x_bits().wrapping_sub(a.x_bits()),
            b.y_bits().wrapping_sub(a.y_bits()),
            c.x_bits().wrapping_sub(a.x_bits()),
            c.y_bits().wrapping_sub(a.y_bits()),
        );
        if area == 0 {
            return Few::none(Nothing::Degenerate);
        }
        if self.culls(area < 0) {
            return Few::none(Nothing::Culled);
        }
        let (flipped, triangle) = (area < 0, &mut self.triangle);
        let (second, third) = if flipped { (c, b) } else { (b, c) };
        triangle.v = [*a, *second, *third];
        triangle.area = if flipped { area.wrapping_neg() } else { area };
        triangle.flipped = flipped;
        Few::UNKNOWN
    }

    /// Whether a triangle is left out whose corners run counter-clockwise, or clockwise.
    #[inline(always)]
    fn culls(&self, turned: bool) -> bool {
        let [clockwise, counter_clockwise] = self.culled;
        if turned {
            counter_clockwise
        } else {
            clockwise
        }
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
    /// Whether it is known to have no centre beyond what is drawn of the picture.
    pub(crate) is_inside: bool,
}

impl Triangle {
    /// A triangle without area: a place to put another.
    pub(crate) const EMPTY: Self = Self::of([ScreenVertex::from_bits(0, 0, 0); 3], 0, false);

    /// A triangle of which is known where its corners are, and no more.
    #[inline(always)]
    pub(crate) const fn of(v: [ScreenVertex; 3], area: i64, flipped: bool) -> Self {
        Self { v, area, flipped, is_inside: false }
    }

    /// Makes a triangle of three corners in any order, of which twice the area is given. One copy
    /// for all that is rare.
    #[inline(never)]
    pub(crate) fn turn(&mut self, area: i64) {
        self.flipped = area < 0;
        self.area = area.wrapping_abs();
        if self.flipped {
            self.v.swap(1, 2);
        }
    }

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
            1.. => Some(Self::of(v, area, false)),
            _ => Some(Self::of([a, c, b], area.wrapping_neg(), true)),
        }
    }

    /// The first corner's depth code, as planes have it: 16.16, raised by a half so that cutting off
    /// rounds. And by how much the others' codes are above.
    #[inline(always)]
    pub(crate) fn depth_codes(&self) -> (u32, i32, i32) {
        let [a, b, c] = &self.v;
        let from = i32::from(a.z);
        let rise = |z: u16| i32::from(z).wrapping_sub(from);
        (u32::from(a.z) << 16 | 0x8000, rise(b.z), rise(c.z))
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

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;
    use crate::frame::Rect;
    use crate::math::hard_numbers::Random;

    #[test]
    fn set_is_in_range_and_oriented() {
        let mut random = Random::new(12);
        let sizes = [Size::new(1, 8192), Size::new(320, 240), Size::new(33, 7)];
        let area = Rect::new(0, 0, 1 << 14, 1 << 14);
        let limits = [Limits::NONE, Limits::new(&area, true)];
        let culls = [[false, false], [true, false], [false, true]];
        let mut seen = [0; 6];
        for round in 0..200_000 {
            let (picture, limits, culls) =
                (sizes[round % 3], limits[round % 2], culls[round / 2 % 3]);
            let mut axis = |length: u16| {
                let (word, middle) = (random.word(), i32::from(length) * 8);
                match if round / 6 % 2 == 0 { 15 } else { word & 15 } {
                    // About the ends of the range, and far beyond them.
                    0 => middle + (GUARD * 16) + (word >> 8 & 3).cast_signed() - 2,
                    1 => middle - (GUARD * 16) + (word >> 8 & 3).cast_signed() - 2,
                    2 => (word & !15).cast_signed(),
                    3 => i32::MIN + (word >> 30).cast_signed(),
                    // Two corners that are about as far apart as numbers are.
                    4 => i32::MIN + (word >> 28).cast_signed() + 8,
                    5 => (word >> 28).cast_signed(),
                    _ => middle + (word >> 27).cast_signed() - 8,
                }
            };
            let mut v = [0, 1, 2].map(|z| {
                let (x, y) = (axis(picture.width), axis(picture.height));
                ScreenVertex::from_bits(x, y, z)
            });
            // Two corners in one place, and all three.
            if round % 7 < 2 {
                v[1] = v[0];
            }
            if round % 7 == 1 {
                v[2] = v[0];
            }
            let mut fitted = Fitted::new(picture, limits, culls);
            let fit = fitted.set(&v[0], &v[1], &v[2]);
            let (expected, made) = match Triangle::oriented(v) {
                _ if !Triangle::in_range(&v, picture) => {
                    (Few::none(Nothing::Beyond), Triangle::EMPTY)
                }
                None => (Few::none(Nothing::Degenerate), Triangle::EMPTY),
                Some(made) if culls[usize::from(made.flipped)] => {
                    (Few::none(Nothing::Culled), Triangle::EMPTY)
                }
                Some(made) => match Few::of(&made, &limits) {
                    Few::UNKNOWN => (Few::UNKNOWN, made),
                    few => (few, Triangle::EMPTY),
                },
            };
            assert_eq!((fit, fitted.triangle), (expected, made), "{v:?} in {picture:?}");
            let kind = match fit {
                Few::UNKNOWN => 0,
                few if few.covered() != 0 => 5,
                few => few.nothing() as usize,
            };
            seen[kind] += 1;
        }
        assert!(seen.iter().all(|count| *count > 400), "{seen:?}");
    }
}
