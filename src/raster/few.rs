use super::{Guard, Point, Span, SpanBatch, Triangle};
use crate::frame::{Rect, MAX_SIDE};

/// Edge functions count in these parts of a square subpixel, so that none is zero at a centre.
const PARTS: u32 = 12;

/// Which of two by two pixels a small triangle covers, where its box holds no more centres.
///
/// The first of the pixels: its row from bit 18 on and its column from bit 4 on. Below, a bit for each that
/// is covered, row by row. Of a triangle without pixels, what became of it from bit 4 on; no bits of one
/// that is not one of these.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Few(u32);

/// Why a triangle has no pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Nothing {
    /// It covers none in the area.
    Outside = 1,
    /// It is left out for its winding.
    Culled,
    /// It has no area.
    Degenerate,
    /// A corner is out of range.
    Beyond,
}

impl Few {
    /// Of a triangle that is not one of these.
    pub(crate) const UNKNOWN: Self = Self(0);

    /// No pixels, and why.
    #[inline(always)]
    pub(crate) const fn none(why: Nothing) -> Self {
        Self((why as u32) << 4)
    }

    /// Why there are none.
    #[inline(always)]
    pub(crate) const fn nothing(self) -> Nothing {
        const CULLED: u32 = Few::none(Nothing::Culled).0;
        const DEGENERATE: u32 = Few::none(Nothing::Degenerate).0;
        const BEYOND: u32 = Few::none(Nothing::Beyond).0;
        match self.0 {
            CULLED => Nothing::Culled,
            DEGENERATE => Nothing::Degenerate,
            BEYOND => Nothing::Beyond,
            _ => Nothing::Outside,
        }
    }

    /// A bit for each pixel that is covered, row by row; none if there are none or they are unknown.
    #[inline(always)]
    pub(crate) const fn covered(self) -> u32 {
        self.0 & 15
    }

    /// The first of the pixels.
    #[inline(always)]
    pub(crate) const fn place(self) -> (i32, i32) {
        ((self.0 >> 4 & 0x3FFF).cast_signed(), (self.0 >> 18).cast_signed())
    }

    /// The same as spans.
    #[inline(never)]
    pub(crate) fn take(self, batch: &mut SpanBatch) {
        batch.clear();
        let ((x, mut y), mut covered) = (self.place(), self.covered());
        while covered != 0 {
            let (left, right) = (covered & 1 != 0, covered & 2 != 0);
            let (first, behind) =
                (x.wrapping_add((!left).into()), x.wrapping_add(1 + i32::from(right)));
            if first < behind {
                batch.push(Span { y, first, left: first, right: behind, behind });
            }
            covered >>= 2;
            y = y.wrapping_add(1);
        }
    }
}

/// Which triangles are asked whether they cover [few](Few) pixels, in subpixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    /// Seven above the least coordinates that have no centre before those of the area, and the greatest
    /// that have none behind them.
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
    /// Twice the area of the largest, in square subpixels; 0 if none is asked.
    pub(super) largest: u32,
}

/// Twice the area of the largest triangles to look at, in square subpixels: a little more than half
/// of two by two pixels. Of larger ones few fit the box.
const LARGEST: u32 = 1088;
/// What no difference of coordinates reaches while corners are where they may be.
const ENDLESS: u32 = 1 << 18;

const _: () = assert!(MAX_SIDE as u32 * 16 + 8 < ENDLESS, "a picture ends before");
const _: () =
    assert!((MAX_SIDE as u32) < 0x3FFF, "a column has 14 bits, and no row has all of them");

impl Limits {
    /// No triangle is asked.
    pub(crate) const NONE: Self = Self { left: 0, top: 0, right: 0, bottom: 0, largest: 0 };

    /// Triangles that do not reach beyond `area`, if any are to be asked.
    pub(crate) fn new(area: &Rect, asks: bool) -> Self {
        let bits = |side: i32| side.clamp(0, MAX_SIDE.into()).wrapping_mul(16);
        Self {
            left: bits(area.left),
            top: bits(area.top),
            right: bits(area.right).wrapping_add(8),
            bottom: bits(area.bottom).wrapping_add(8),
            largest: if asks { LARGEST } else { 0 },
        }
    }

    /// Of these, those that have all corners in a square.
    pub(super) fn within(self, guard: &Guard) -> Self {
        let (first, last) = guard.ends();
        Self {
            left: self.left.max(first.x.wrapping_add(7)),
            top: self.top.max(first.y.wrapping_add(7)),
            right: self.right.min(last.x),
            bottom: self.bottom.min(last.y),
            ..self
        }
    }
}

/// The sides from a triangle's first corner, in subpixels; what wraps is no short side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides {
    pub(super) x1: i32,
    pub(super) y1: i32,
    pub(super) x2: i32,
    pub(super) y2: i32,
}

impl Sides {
    #[inline(always)]
    pub(super) const fn of(a: Point, b: Point, c: Point) -> Self {
        Self {
            x1: b.x.wrapping_sub(a.x),
            y1: b.y.wrapping_sub(a.y),
            x2: c.x.wrapping_sub(a.x),
            y2: c.y.wrapping_sub(a.y),
        }
    }

    /// Twice the area, as far as it fits: below zero where corners do not run clockwise.
    #[inline(always)]
    pub(super) const fn short_area(&self) -> i32 {
        self.x1.wrapping_mul(self.y2).wrapping_sub(self.x2.wrapping_mul(self.y1))
    }
}

impl Few {
    /// The pixels of a triangle, clockwise, if it is one of those within limits; unknown otherwise.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "if the area is larger, the box is too")]
    pub(crate) fn of(triangle: &Triangle, limits: &Limits) -> Self {
        if triangle.area as u32 <= limits.largest {
            few(triangle, limits)
        } else {
            Self::UNKNOWN
        }
    }
}

/// The pixels of a small triangle.
///
/// # Cost
/// Some 120 instructions on Cortex-M4; of a triangle that is none of these 35 to 70.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "an area below the largest")]
fn few(triangle: &Triangle, limits: &Limits) -> Few {
    let [a, b, c] = triangle.v.each_ref().map(Point::of);
    few_of::<false>(a, &Sides::of(a, b, c), triangle.area as i32, limits)
}

/// The pixels of a triangle whose box holds two by two pixel centres at most and is within limits, by
/// edge functions: a walk along its edges would cost more to start. `TURNED` if the area is below zero,
/// as where corners run counter-clockwise, or zero. Corners may be anywhere.
///
/// A centre on an edge belongs to the triangle if it still does when it is moved to the right by
/// very little, and down by very much less: by 1/64 and 1/4096 of a subpixel, which moves no edge
/// function of sides below 64 across zero that is not zero.
#[inline(always)]
pub(super) fn few_of<const TURNED: bool>(
    a: Point,
    sides: &Sides,
    area: i32,
    limits: &Limits,
) -> Few {
    let Sides { x1, y1, x2, y2 } = *sides;
    // From the least corner to the greatest, and sixteen times the column or row of the first centre
    // at or behind the least.
    let axis = |from: i32, one: i32, two: i32, first: i32, last: i32| {
        let least = one.min(0).min(two);
        let length = one.max(0).max(two).wrapping_sub(least);
        let raised = from.wrapping_add(7).wrapping_add(least);
        let (start, end) = (raised & !15, raised.wrapping_sub(7).wrapping_add(length));
        // All of them short of endless where the third centre is behind the greatest, and nothing is
        // beyond the limits.
        let over = length
            | raised.wrapping_sub(first)
            | last.wrapping_sub(end)
            | start.wrapping_add(40).wrapping_sub(end);
        (start, over)
    };
    let (left, over) = axis(a.x, x1, x2, limits.left, limits.right);
    if over.cast_unsigned() >= ENDLESS {
        return Few::UNKNOWN;
    }
    let (top, over) = axis(a.y, y1, y2, limits.top, limits.bottom);
    if over.cast_unsigned() >= ENDLESS {
        return Few::UNKNOWN;
    }
    // From the first corner to the first centre, moved.
    let moved = |to: i32, by: i32| to.wrapping_shl(PARTS).wrapping_add((8 << PARTS) + by);
    let x = moved(left.wrapping_sub(a.x), 1 << (PARTS / 2));
    let y = moved(top.wrapping_sub(a.y), 1);
    // Of one sign inside, and their sum is the area. No centre beyond the box is inside.
    let ab = x1.wrapping_mul(y).wrapping_sub(y1.wrapping_mul(x));
    let ca = y2.wrapping_mul(x).wrapping_sub(x2.wrapping_mul(y));
    let sum = area.wrapping_shl(PARTS);
    let pixel = |side: i32| side.wrapping_shl(PARTS + 4);
    // One bit each: of what is outside if clockwise, and of what is inside if not.
    let sign = |ab: i32, ca: i32| {
        let bc = sum.wrapping_sub(ab).wrapping_sub(ca);
        (if TURNED { ab & ca & bc } else { ab | ca | bc }).cast_unsigned() >> 31
    };
    let row = |ab: i32, ca: i32| {
        let next = sign(ab.wrapping_sub(pixel(y1)), ca.wrapping_add(pixel(y2)));
        sign(ab, ca) | next << 1
    };
    let below = row(ab.wrapping_add(pixel(x1)), ca.wrapping_sub(pixel(x2)));
    let signs = row(ab, ca) | below << 2;
    let covered = if TURNED { signs } else { signs ^ 15 };
    if covered == 0 {
        return Few::none(if area == 0 { Nothing::Degenerate } else { Nothing::Outside });
    }
    Few(covered | left.cast_unsigned() | top.cast_unsigned() << 14)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::super::ScreenVertex;
    use super::*;
    use crate::math::hard_numbers::Random;
    use std::vec::Vec;

    /// The spans by the definition: each centre of the box against each edge.
    fn spans(triangle: &Triangle) -> Vec<Span> {
        let covers = |x: i32, y: i32| {
            (0..3).all(|i| {
                let [from, to] = [triangle.v[i], triangle.v[(i + 1) % 3]].map(|v| Point::of(&v));
                let (dx, dy) = (to.x - from.x, to.y - from.y);
                let edge = dx * (16 * y + 8 - from.y) - dy * (16 * x + 8 - from.x);
                edge > 0 || (edge == 0 && (dy < 0 || (dy == 0 && dx > 0)))
            })
        };
        let rows = -8..16;
        let span = |y: i32| {
            let covered: Vec<i32> = (-8..16).filter(|x| covers(*x, y)).collect();
            let (first, behind) = (*covered.first()?, covered.last()? + 1);
            Some(Span { y, first, left: first, right: behind, behind })
        };
        rows.filter_map(span).collect()
    }

    #[test]
    fn spans_are_those_of_the_definition() {
        let mut random = Random::new(31);
        let area = Rect::new(0, 0, 4, 4);
        let (mut taken, mut empty) = (0, 0);
        for _ in 0..300_000 {
            let mut corner = || {
                let word = random.word().cast_signed();
                // Many on a grid of half pixels, where edges go through centres.
                let mask = if word & 1 == 0 { !7 } else { !0 };
                let at = |shift: u32| ((word >> shift & 63) - 4) & mask;
                ScreenVertex::from_bits(at(8), at(16), 0)
            };
            let Some(triangle) = Triangle::oriented([corner(), corner(), corner()]) else {
                continue;
            };
            let mut batch = SpanBatch::default();
            let few = few(&triangle, &Limits::new(&area, true));
            if few != Few::UNKNOWN {
                few.take(&mut batch);
                let expected = spans(&triangle);
                assert_eq!(batch.spans(), expected, "{triangle:?}");
                taken += 1;
                empty += usize::from(expected.is_empty());
            } else {
                assert!(batch.is_empty(), "{triangle:?}");
            }
        }
        assert!(taken > 10_000 && empty > 1000, "{taken} {empty}");
    }

    #[test]
    fn what_reaches_beyond_the_area_is_left_to_the_walk() {
        let corner = |x, y| ScreenVertex::from_bits(x, y, 0);
        let triangle = Triangle::oriented([corner(16, 16), corner(48, 16), corner(16, 48)]);
        let triangle = &triangle.unwrap_or(Triangle::EMPTY);
        let takes = |area: Rect| few(triangle, &Limits::new(&area, true)) != Few::UNKNOWN;
        assert!(takes(Rect::new(1, 1, 3, 3)), "the area holds it");
        for area in [(2, 1, 3, 3), (1, 2, 3, 3), (1, 1, 2, 3), (1, 1, 3, 2), (3, 1, 1, 3)] {
            let (left, top, right, bottom) = area;
            assert!(!takes(Rect { left, top, right, bottom }), "{area:?}");
        }
    }
}
