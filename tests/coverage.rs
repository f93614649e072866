//! Coverage against the definition: every pixel, in 64 bits.

mod support;

use microraster::raster::{
    Scanline, ScreenVertex, SpanBatch, SpanWalk, Spans, Traversal, Triangle, GUARD,
};
use microraster::{Rect, Size};
use support::{covers, Random};

const PICTURE: Size = Size::new(32, 24);

/// The pixels of the picture that the spans cover.
fn spans(triangle: &Triangle, area: Rect) -> Vec<(i32, i32)> {
    let mut pixels = Vec::new();
    let mut batch = SpanBatch::default();
    let mut walk = Spans::default();
    Scanline.start(&mut walk, triangle, area, &mut batch);
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

fn corner(random: &mut Random, class: i32) -> ScreenVertex {
    let (w, h) = (i32::from(PICTURE.width) * 16, i32::from(PICTURE.height) * 16);
    let side = GUARD * 16;
    let (x, y) = match class {
        // In the picture, on subpixels, on pixel corners, on centres, on halves.
        0 => (random.range(0, w), random.range(0, h)),
        1 => (random.range(0, w / 16) * 16, random.range(0, h / 16) * 16),
        2 => (random.range(0, w / 16) * 16 + 8, random.range(0, h / 16) * 16 + 8),
        3 => (random.range(0, w / 8) * 8, random.range(0, h / 8) * 8),
        // A few subpixels.
        4 => (random.range(150, 190), random.range(150, 190)),
        // Far outside, and at the very ends.
        5 => (random.range(-side + w / 2, side + w / 2), random.range(-side + h / 2, side + h / 2)),
        6 => (random.range(-2000, 3000), random.range(-2000, 3000)),
        // Sixteen pixels high at most.
        7 => (random.range(-300, 600), random.range(100, 356)),
        _ => (
            w / 2 + [-side, side, 0, -8, 8][random.range(0, 4) as usize],
            h / 2 + [-side, side, 0, -8, 8][random.range(0, 4) as usize],
        ),
    };
    ScreenVertex::from_bits(x, y, 0)
}

#[test]
fn spans_cover_what_the_definition_says_in_all_size_classes() {
    let mut random = Random(1);
    let cases = if cfg!(debug_assertions) { 20_000 } else { 1_000_000 };
    let whole = Rect::from_size(PICTURE);
    for i in 0..cases {
        let class = i % 10;
        let v = [0; 3].map(|_: i32| {
            let class = if class == 9 { random.range(0, 8) } else { class };
            corner(&mut random, class)
        });
        check(v, whole);
    }
}
