use super::spans::first_center;
use super::{Point, Span, SpanBatch, Triangle};
use crate::frame::Rect;

/// Edge functions count in these parts of a square subpixel, so that none is zero at a centre.
const PARTS: u32 = 12;

/// Which of two by two pixels a small triangle covers, where its box holds no more centres.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Few {
    /// The first of the pixels: its column, and its row in the upper half.
    place: u32,
    /// A bit for each that is covered, row by row; more bits of a triangle that is not one of these.
    covered: u32,
}

impl Few {
    /// Twice the area of the largest triangles to look at, in square subpixels: a little more than half
    /// of two by two pixels. Of larger ones few fit the box.
    pub(crate) const LARGEST: u32 = 1088;
    /// Of a triangle that is not one of these.
    pub(crate) const UNKNOWN: Self = Self { place: 0, covered: u32::MAX };

    /// No pixels.
    pub(crate) const NONE: Self = Self { place: 0, covered: 0 };

    /// The pixels of a triangle that does not reach beyond `area`; unknown if twice its area is above
    /// `largest`.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "if the area is larger, the box is too")]
    pub(super) fn of(triangle: &Triangle, area: &Rect, largest: u32) -> Self {
        if triangle.area as u32 <= largest {
            few(triangle, area)
        } else {
            Self::UNKNOWN
        }
    }

    /// Whether this says what the triangle covers.
    #[inline(always)]
    pub(crate) const fn is_known(self) -> bool {
        self.covered != u32::MAX
    }

    /// Whether it covers nothing.
    #[inline(always)]
    pub(crate) const fn is_empty(self) -> bool {
        self.covered == 0
    }

    /// The first of the pixels.
    #[inline(always)]
    pub(crate) const fn place(self) -> (i32, i32) {
        ((self.place & 0xFFFF).cast_signed(), (self.place >> 16).cast_signed())
    }

    /// Whether the left and the right pixel of the first row are covered.
    #[inline(always)]
    pub(crate) const fn row(self) -> (bool, bool) {
        (self.covered & 1 != 0, self.covered & 2 != 0)
    }

    /// Goes to the next row.
    #[inline(always)]
    pub(crate) const fn next_row(&mut self) {
        self.covered >>= 2;
    }

    /// The same as spans.
    #[inline(never)]
    pub(crate) fn take(mut self, batch: &mut SpanBatch) {
        batch.clear();
        let (x, mut y) = self.place();
        while !self.is_empty() {
            let (left, right) = self.row();
            let (first, behind) =
                (x.wrapping_add((!left).into()), x.wrapping_add(1 + i32::from(right)));
            if first < behind {
                batch.push(Span { y, first, left: first, right: behind, behind });
            }
            self.next_row();
            y = y.wrapping_add(1);
        }
    }
}

/// The pixels of a triangle whose box holds two by two pixel centres at most and does not reach
/// beyond `area`, by edge functions: a walk along its edges would cost more to start.
///
/// A centre on an edge belongs to the triangle if it still does when it is moved to the right by
/// very little, and down by very much less: by 1/64 and 1/4096 of a subpixel, which moves no edge
/// function of sides below 64 across zero that is not zero.
///
/// # Cost
/// Some 130 instructions on Cortex-M4; of a triangle that is none of these 20 to 50.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "an area below the largest")]
fn few(triangle: &Triangle, area: &Rect) -> Few {
    let [a, b, c] = triangle.v.each_ref().map(Point::of);
    // Columns and rows from the first centre at or behind the least corner to the last before the
    // greatest.
    let left = first_center(a.x.min(b.x).min(c.x));
    let right = first_center(a.x.max(b.x).max(c.x));
    if left.wrapping_add(2) < right {
        return Few::UNKNOWN;
    }
    let top = first_center(a.y.min(b.y).min(c.y));
    let bottom = first_center(a.y.max(b.y).max(c.y));
    // Below zero where something is too much.
    let left_over = left.wrapping_sub(area.left) | top.wrapping_sub(area.top);
    let right_over = area.right.wrapping_sub(right) | area.bottom.wrapping_sub(bottom);
    let size_over = top.wrapping_add(2).wrapping_sub(bottom);
    if left_over | right_over | size_over < 0 {
        return Few::UNKNOWN;
    }
    let (x1, y1) = (b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y));
    let (x2, y2) = (c.x.wrapping_sub(a.x), c.y.wrapping_sub(a.y));
    // From the first corner to the first centre, moved.
    let moved = |to: i32, by: i32| to.wrapping_shl(PARTS).wrapping_add((8 << PARTS) + by);
    let x = moved(left.wrapping_mul(16).wrapping_sub(a.x), 1 << (PARTS / 2));
    let y = moved(top.wrapping_mul(16).wrapping_sub(a.y), 1);
    // Above zero inside; their sum is the area. No centre beyond the box is inside.
    let ab = x1.wrapping_mul(y).wrapping_sub(y1.wrapping_mul(x));
    let ca = y2.wrapping_mul(x).wrapping_sub(x2.wrapping_mul(y));
    let sum = (triangle.area as i32).wrapping_shl(PARTS);
    let pixel = |side: i32| side.wrapping_shl(PARTS + 4);
    // One bit each.
    let outside =
        |ab: i32, ca: i32| (ab | ca | sum.wrapping_sub(ab).wrapping_sub(ca)).cast_unsigned() >> 31;
    let row = |ab: i32, ca: i32| {
        let next = outside(ab.wrapping_sub(pixel(y1)), ca.wrapping_add(pixel(y2)));
        outside(ab, ca) | next << 1
    };
    let below = row(ab.wrapping_add(pixel(x1)), ca.wrapping_sub(pixel(x2)));
    let covered = (row(ab, ca) | below << 2) ^ 15;
    Few { place: left.cast_unsigned() | top.cast_unsigned() << 16, covered }
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
            let few = few(&triangle, &area);
            if few.is_known() {
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
        let takes = |area: Rect| few(triangle, &area).is_known();
        assert!(takes(Rect::new(1, 1, 3, 3)), "the area holds it");
        for area in [(2, 1, 3, 3), (1, 2, 3, 3), (1, 1, 2, 3), (1, 1, 3, 2), (3, 1, 1, 3)] {
            let (left, top, right, bottom) = area;
            assert!(!takes(Rect { left, top, right, bottom }), "{area:?}");
        }
    }
}
