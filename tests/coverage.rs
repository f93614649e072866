//! Coverage against the definition: every pixel, in 64 bits.

mod support;

use microraster::raster::{
    Scanline, ScreenVertex, SpanBatch, SpanWalk, Spans, Traversal, Triangle, GUARD,
};
use microraster::{Rect, Size};
use support::{any_corner, covers, Random};

const PICTURE: Size = Size::new(32, 24);

/// The pixels of the picture that the spans cover.
fn spans(triangle: &Triangle, area: Rect) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    let mut batch = SpanBatch::default();
    let mut walk = Spans::default();
    Scanline.start(&mut walk, triangle, &area, &mut batch);
    loop {
        for span in batch.spans() {
            assert!(span.first <= span.left && span.left < span.right, "{span:?}");
            pixels.extend((span.left..span.right).map(|x| (x, span.y)));
        }
        if batch.is_last() {
            break;
        }
        walk.next_spans(&mut batch);
    }
    pixels
}

fn check(v: [ScreenVertex; 3], area: Rect) {
    let found = Triangle::new(v, PICTURE).map_or(Vec::new(), |t| spans(&t, area));
    let mut expected = Vec::new();
    for y in area.top..area.bottom {
        expected.extend((area.left..area.right).filter(|&x| covers(&v, x, y)).map(|x| (x, y)));
    }
    assert_eq!(found, expected, "{v:?}");
}

#[test]
fn spans_cover_what_the_definition_says_in_all_size_classes() {
    let mut random = Random(1);
    let cases = 1_000_000;
    let whole = Rect::from_size(PICTURE);
    for i in 0..cases {
        let class = i % 10;
        let v = [0; 3].map(|_: i32| {
            let class = if class == 9 { random.range(0, 8) } else { class };
            any_corner(&mut random, class, PICTURE)
        });
        check(v, whole);
    }
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
fn extreme_triangles_are_right() {
    let mut random = Random(2);
    let whole = Rect::from_size(PICTURE);
    // The square in which corners may lie.
    let (left, right) = (256 - GUARD * 16, 256 + GUARD * 16);
    let (top, bottom) = (192 - GUARD * 16, 192 + GUARD * 16);
    let ends = [(left, top), (right, top), (right, bottom), (left, bottom)];
    let at = |(x, y): (i32, i32)| ScreenVertex::from_bits(x, y, 0);
    for a in ends {
        for b in ends {
            for c in ends {
                check([a, b, c].map(at), whole);
            }
        }
    }
    for _ in 0..50_000 {
        let mut inside = || (random.range(0, 512), random.range(0, 384));
        let (p, q) = (inside(), inside());
        let far = ends[random.range(0, 3) as usize];
        let edge = [(left, random.range(top, bottom)), (random.range(left, right), bottom)];
        // Slivers from end to end, a subpixel wide; huge ones with a corner in the picture; ones
        // of the least area; edges that graze centres.
        check([far, (far.0.clamp(left + 1, right - 1), far.1), p].map(at), whole);
        check([edge[0], edge[1], q].map(at), whole);
        check([p, (p.0 + 1, p.1), (p.0, p.1 + 1)].map(at), whole);
        let center = (p.0 / 16 * 16 + 8, p.1 / 16 * 16 + 8);
        let through = (2 * center.0 - q.0, 2 * center.1 - q.1);
        check([q, through, far].map(at), whole);
    }
}
