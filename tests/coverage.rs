//! Coverage against the definition: every pixel, in 64 bits.

mod support;

use microraster::raster::{
    Scanline, ScreenVertex, SpanBatch, SpanWalk, Spans, Traversal, Triangle,
};
use microraster::{Rect, Size};
use support::{any_corner, covers, Random};

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
