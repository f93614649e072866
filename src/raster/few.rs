use super::spans::first_center;
use super::{Point, Span, SpanBatch, Triangle};
use crate::frame::Rect;

/// Sides below this many subpixels are looked at.
const SHORT: i32 = 64;

/// Takes the spans of a triangle whose box holds two by two pixel centres at most and does not reach
/// beyond `area`, by edge functions: a walk along its edges would cost more to start. Whether it is
/// one.
#[inline(always)]
pub(super) fn take_few(triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) -> bool {
    let [a, b, c] = triangle.v.each_ref().map(Point::of);
    let (x1, y1) = (b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y));
    let (x2, y2) = (c.x.wrapping_sub(a.x), c.y.wrapping_sub(a.y));
    let bits = |side: i32| side ^ (side >> 31);
    if bits(x1) | bits(y1) | bits(x2) | bits(y2) >= SHORT {
        return false;
    }
    // Columns and rows from the first centre at or behind the least corner to the last before the
    // greatest.
    let left = first_center(a.x.wrapping_add(x1.min(0).min(x2)));
    let right = first_center(a.x.wrapping_add(x1.max(0).max(x2)));
    let top = first_center(a.y.wrapping_add(y1.min(0).min(y2)));
    let bottom = first_center(a.y.wrapping_add(y1.max(0).max(y2)));
    let (width, height) = (right.wrapping_sub(left), bottom.wrapping_sub(top));
    if width <= 0 || height <= 0 {
        return true;
    }
    // Below zero where something is too much.
    let left_over = left.wrapping_sub(area.left) | top.wrapping_sub(area.top);
    let right_over = area.right.wrapping_sub(right) | area.bottom.wrapping_sub(bottom);
    let size_over = 2_i32.wrapping_sub(width) | 2_i32.wrapping_sub(height);
    if left_over | right_over | size_over < 0 {
        return false;
    }
    // From the first corner to the first centre.
    let x = left.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.x);
    let y = top.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
    // Edge functions, whose sum is the area; one less where a centre on the edge is not covered, so
    // that the signs tell.
    let bias = |dx: i32, dy: i32| dx.wrapping_sub(dy.wrapping_shl(16)) >> 31;
    let edge =
        |dx: i32, dy: i32, x: i32, y: i32| dx.wrapping_mul(y).wrapping_sub(dy.wrapping_mul(x));
    let (from_first, to_first) = (bias(x1, y1), bias(x2.wrapping_neg(), y2.wrapping_neg()));
    let between = bias(x2.wrapping_sub(x1), y2.wrapping_sub(y1));
    #[allow(clippy::cast_possible_truncation, reason = "sides below 64")]
    let sum = (triangle.area as i32)
        .wrapping_add(from_first)
        .wrapping_add(between)
        .wrapping_add(to_first);
    let ab = edge(x1, y1, x, y).wrapping_add(from_first);
    let ca = edge(x2, y2, x, y).wrapping_neg().wrapping_add(to_first);
    let mut length = 0_usize;
    let mut row = |y: i32, ab: i32, ca: i32| {
        // -1 outside.
        let outside = |ab: i32, ca: i32| (ab | ca | sum.wrapping_sub(ab).wrapping_sub(ca)) >> 31;
        let first = left.wrapping_sub(outside(ab, ca));
        let (next_ab, next_ca) =
            (ab.wrapping_sub(y1.wrapping_mul(16)), ca.wrapping_add(y2.wrapping_mul(16)));
        let behind = left.wrapping_add(2).wrapping_add(outside(next_ab, next_ca));
        if first < behind {
            if let Some(place) = batch.spans.get_mut(length) {
                *place = Span { y, first, left: first, right: behind, behind };
                length = length.wrapping_add(1);
            }
        }
    };
    row(top, ab, ca);
    if height > 1 {
        let ab = ab.wrapping_add(x1.wrapping_mul(16));
        row(top.wrapping_add(1), ab, ca.wrapping_sub(x2.wrapping_mul(16)));
    }
    batch.length = length;
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
