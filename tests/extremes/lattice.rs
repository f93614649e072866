//! All triangles whose corners are on the half pixels of a window of 8x8 pixels.

use crate::support::{covers, spans};
use crate::tally::{exhaustive, is_thorough};
use microraster::raster::{ScreenVertex, Triangle};
use microraster::{Rect, Size};

/// Half pixels on a side, both ends included.
const SIDE: i32 = 17;
const POINTS: usize = (SIDE * SIDE) as usize;
const WINDOW: Size = Size::new(8, 8);

fn point(number: usize) -> ScreenVertex {
    let number = number as i32;
    ScreenVertex::from_bits(number % SIDE * 8, number / SIDE * 8, 0)
}

/// The pixels whose centres lie on the inner side of a directed edge, a bit each: one half-plane of
/// the definition. What is covered is in all three of a triangle.
fn inner_side(a: ScreenVertex, b: ScreenVertex) -> u64 {
    let (dx, dy) = (b.x_bits() - a.x_bits(), b.y_bits() - a.y_bits());
    let bias = i32::from(!(dy < 0 || dy == 0 && dx > 0));
    let is_inside = |i: &i32| {
        let (px, py) = (i % 8 * 16 + 8, i / 8 * 16 + 8);
        dx * (py - a.y_bits()) - dy * (px - a.x_bits()) >= bias
    };
    (0..64).filter(is_inside).fold(0, |pixels, i| pixels | 1 << i)
}

fn twice_area([a, b, c]: [ScreenVertex; 3]) -> i32 {
    let (x1, y1) = (b.x_bits() - a.x_bits(), b.y_bits() - a.y_bits());
    let (x2, y2) = (c.x_bits() - a.x_bits(), c.y_bits() - a.y_bits());
    x1 * y2 - x2 * y1
}

#[test]
fn every_triangle_with_corners_on_half_pixels_covers_what_the_definition_says() {
    exhaustive("coverage of all triangles on the half pixels of 8x8", || {
        let sides: Vec<u64> = (0..POINTS * POINTS)
            .map(|i| inner_side(point(i / POINTS), point(i % POINTS)))
            .collect();
        let side = |a: usize, b: usize| sides[a * POINTS + b];
        let whole = Rect::from_size(WINDOW);
        let (step, mut tried) = (if is_thorough() { 1 } else { 4 }, 0);
        for a in 0..POINTS {
            for b in a + 1..POINTS {
                // Other thirds for each pair, so that a stride meets all points.
                for c in (b + 1 + (a + b) % step..POINTS).step_by(step) {
                    for v in [[a, b, c], [a, c, b]] {
                        let corners = v.map(point);
                        let found = Triangle::new(corners, WINDOW).map(|t| (t.is_flipped(), t));
                        tried += 1;
                        let Some((flipped, triangle)) = found else {
                            assert_eq!(twice_area(corners), 0, "{corners:?} is left out");
                            continue;
                        };
                        let [p, q, r] = if flipped { [v[0], v[2], v[1]] } else { v };
                        let expected = side(p, q) & side(q, r) & side(r, p);
                        let rows = spans(&triangle, whole);
                        let found =
                            rows.iter().rev().fold(0, |all, row| all << 8 | u64::from(*row));
                        assert!(found == expected, "{corners:?}: {found:x} for {expected:x}");
                    }
                }
            }
        }
        tried
    });
}

#[test]
fn half_planes_are_the_definition() {
    for (a, b, c) in [(0, 16, 288), (3, 140, 77), (144, 1, 200), (17, 18, 34), (5, 6, 7)] {
        let v = [a, b, c].map(point);
        let area = twice_area(v);
        let [p, q, r] = if area < 0 { [v[0], v[2], v[1]] } else { v };
        let planes = inner_side(p, q) & inner_side(q, r) & inner_side(r, p);
        for i in 0..64 {
            let is_covered = planes >> i & 1 == 1 && area != 0;
            assert_eq!(is_covered, covers(&v, i % 8, i / 8), "{v:?} at {i}");
        }
    }
}
