use super::spans::first_center;
use super::{Point, Span, SpanBatch, Triangle};
use crate::frame::Rect;

/// Twice the area of the largest triangles that are looked at, in square subpixels: a little more than
/// half of two by two pixels. Of larger ones few fit the box.
const LARGEST: u32 = 1088;

/// Whether to look at a triangle's box: of most others this costs three instructions.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "if the area is larger, the box is too")]
pub(super) fn may_be_few(triangle: &Triangle) -> bool {
    triangle.area as u32 <= LARGEST
}

/// Edge functions count in these parts of a square subpixel, so that none is zero at a centre.
const PARTS: u32 = 12;

/// Takes the spans of a triangle whose box holds two by two pixel centres at most and does not reach
/// beyond `area`, by edge functions: a walk along its edges would cost more to start. Whether it is
/// one.
///
/// A centre on an edge belongs to the triangle if it still does when it is moved to the right by
/// very little, and down by very much less: by 1/64 and 1/4096 of a subpixel, which moves no edge
/// function of sides below 64 across zero that is not zero.
///
/// # Cost
/// Some 145 instructions on Cortex-M4; of a triangle that is none 20 to 50.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "an area below the largest")]
pub(super) fn take_few(triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) -> bool {
    let [a, b, c] = triangle.v.each_ref().map(Point::of);
    // Columns and rows from the first centre at or behind the least corner to the last before the
    // greatest.
    let left = first_center(a.x.min(b.x).min(c.x));
    let right = first_center(a.x.max(b.x).max(c.x));
    if left.wrapping_add(2) < right {
        return false;
    }
    let top = first_center(a.y.min(b.y).min(c.y));
    let bottom = first_center(a.y.max(b.y).max(c.y));
    // Below zero where something is too much.
    let left_over = left.wrapping_sub(area.left) | top.wrapping_sub(area.top);
    let right_over = area.right.wrapping_sub(right) | area.bottom.wrapping_sub(bottom);
    let size_over = top.wrapping_add(2).wrapping_sub(bottom);
    if left_over | right_over | size_over < 0 {
        return false;
    }
    let (x1, y1) = (b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y));
    let (x2, y2) = (c.x.wrapping_sub(a.x), c.y.wrapping_sub(a.y));
    // From the first corner to the first centre, moved.
    let moved = |to: i32, by: i32| to.wrapping_shl(PARTS).wrapping_add((8 << PARTS) + by);
    let x = moved(left.wrapping_mul(16).wrapping_sub(a.x), 1 << (PARTS / 2));
    let y = moved(top.wrapping_mul(16).wrapping_sub(a.y), 1);
    // Above zero inside; their sum is the area.
    let ab = x1.wrapping_mul(y).wrapping_sub(y1.wrapping_mul(x));
    let ca = y2.wrapping_mul(x).wrapping_sub(x2.wrapping_mul(y));
    let sum = (triangle.area as i32).wrapping_shl(PARTS);
    let pixel = |side: i32| side.wrapping_shl(PARTS + 4);
    let mut length = 0_usize;
    let mut row = |y: i32, ab: i32, ca: i32| {
        // -1 outside.
        let outside = |ab: i32, ca: i32| (ab | ca | sum.wrapping_sub(ab).wrapping_sub(ca)) >> 31;
        let first = left.wrapping_sub(outside(ab, ca));
        let next = outside(ab.wrapping_sub(pixel(y1)), ca.wrapping_add(pixel(y2)));
        let behind = left.wrapping_add(2).wrapping_add(next);
        if first < behind {
            if let Some(place) = batch.spans.get_mut(length) {
                *place = Span { y, first, left: first, right: behind, behind };
                length = length.wrapping_add(1);
            }
        }
    };
    row(top, ab, ca);
    // No centre of a row that is not in the box is covered.
    row(top.wrapping_add(1), ab.wrapping_add(pixel(x1)), ca.wrapping_sub(pixel(x2)));
    batch.length = length;
    batch.last = true;
    true
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
            if take_few(&triangle, &area, &mut batch) {
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
        let takes = |area: Rect| take_few(triangle, &area, &mut SpanBatch::default());
        assert!(takes(Rect::new(1, 1, 3, 3)), "the area holds it");
        for area in [(2, 1, 3, 3), (1, 2, 3, 3), (1, 1, 2, 3), (1, 1, 3, 2), (3, 1, 1, 3)] {
            let (left, top, right, bottom) = area;
            assert!(!takes(Rect { left, top, right, bottom }), "{area:?}");
        }
    }
}
