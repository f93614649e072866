//! Coverage against the definition: every pixel, in 64 bits.

use crate::support::{any_corner, covered, covers, spans, Random};
use crate::tally::{cases, random};
use microraster::raster::{ScreenVertex, Triangle, GUARD};
use microraster::{Rect, Size};

pub(crate) const PICTURE: Size = Size::new(32, 24);
/// The square in which corners may lie, in subpixels.
pub(crate) const LEFT: i32 = 256 - GUARD * 16;
pub(crate) const RIGHT: i32 = 256 + GUARD * 16;
pub(crate) const TOP: i32 = 192 - GUARD * 16;
pub(crate) const BOTTOM: i32 = 192 + GUARD * 16;
pub(crate) const ENDS: [(i32, i32); 4] =
    [(LEFT, TOP), (RIGHT, TOP), (RIGHT, BOTTOM), (LEFT, BOTTOM)];

/// Fails where the spans of a triangle are not the definition's; returns how many pixels it has.
pub(crate) fn check(v: [ScreenVertex; 3], area: Rect) -> u32 {
    let found = Triangle::new(v, PICTURE).map(|triangle| spans(&triangle, area));
    let expected = covered(&v, area);
    match found {
        Some(found) => assert!(found == expected, "{v:?}: {found:x?} for {expected:x?}"),
        None => assert!(expected.iter().all(|row| *row == 0), "{v:?} is not there"),
    }
    expected.iter().map(|row| row.count_ones()).sum()
}

/// The same of corners in subpixels, all over the picture.
pub(crate) fn check_at(v: [(i32, i32); 3]) -> u32 {
    check(v.map(|(x, y)| ScreenVertex::from_bits(x, y, 0)), Rect::from_size(PICTURE))
}

#[test]
fn whole_rows_of_the_definition_are_the_definition_at_each_pixel() {
    let mut random = Random(3);
    let whole = Rect::from_size(PICTURE);
    for i in 0..3_000 {
        let v = [0; 3].map(|_: i32| any_corner(&mut random, i % 10, PICTURE));
        for (y, row) in covered(&v, whole).into_iter().enumerate() {
            for x in 0..32 {
                assert_eq!(row >> x & 1 == 1, covers(&v, x, y as i32), "{v:?} at {x}, {y}");
            }
        }
    }
}

#[test]
fn spans_cover_what_the_definition_says_in_all_size_classes() {
    let (mut class, mut pixels) = (0, 0_u64);
    let wanted = cases(400_000, 44_000_000);
    let whole = Rect::from_size(PICTURE);
    random("coverage is the definition's, in all size classes", wanted, 1, |random| {
        class = (class + 1) % 10;
        let v = [0; 3].map(|_: i32| any_corner(random, class, PICTURE));
        pixels += u64::from(check(v, whole));
        1
    });
    assert!(pixels >= 20 * wanted || !cfg!(debug_assertions), "{pixels} pixels are too few");
}

#[test]
fn every_triangle_of_a_small_lattice_is_right() {
    // Corners, centres and sides of pixels, and what lies just beside them.
    let steps = [0, 1, 7, 8, 9, 16, 24, 31];
    let points: Vec<ScreenVertex> = steps
        .iter()
        .flat_map(|y| steps.map(|x| ScreenVertex::from_bits(160 + x, 160 + y, 0)))
        .collect();
    let near = Rect::new(9, 9, 13, 13);
    for a in &points {
        for b in &points {
            for c in &points {
                check([*a, *b, *c], near);
            }
        }
    }
}

#[test]
fn triangles_that_reach_from_end_to_end_of_the_range_are_right() {
    for a in ENDS {
        for b in ENDS {
            for c in ENDS {
                check_at([a, b, c]);
            }
        }
    }
}

#[test]
fn slivers_needles_and_edges_through_centres_are_right() {
    let wanted = cases(150_000, 12_000_000);
    random("coverage at the ends of the range and of slivers", wanted, 2, |random| {
        let mut inside = || (random.range(0, 512), random.range(0, 384));
        let (p, q) = (inside(), inside());
        let far = ENDS[random.range(0, 3) as usize];
        let edge = [(LEFT, random.range(TOP, BOTTOM)), (random.range(LEFT, RIGHT), BOTTOM)];
        // Slivers from end to end, a subpixel wide; huge ones with a corner in the picture; ones
        // of the least area; edges that graze centres.
        check_at([far, (far.0.clamp(LEFT + 1, RIGHT - 1), far.1), p]);
        check_at([edge[0], edge[1], q]);
        check_at([p, (p.0 + 1, p.1), (p.0, p.1 + 1)]);
        let center = (p.0 / 16 * 16 + 8, p.1 / 16 * 16 + 8);
        let through = (2 * center.0 - q.0, 2 * center.1 - q.1);
        check_at([q, through, far]);
        4
    });
}
