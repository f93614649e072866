//! All traversals find the same pixels, and so draw the same pictures.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::raster::{
    AnyTraversal, BoundingBox, Scanline, ScreenVertex, Span, SpanBatch, SpanWalk, Spans, Traversal,
    Triangle,
};
use microraster::{
    Camera, Color, Cull, Flat, Frame, Gouraud, Less, Light, Pass, Rect, Rgb, Rgb565, ScreenPass,
    Size, Stats,
};
use support::{any_corner, Random};

const PICTURE: Size = Size::new(32, 24);
const OTHERS: [AnyTraversal; 3] = [AnyTraversal::Box, AnyTraversal::Blocks, AnyTraversal::Walk];

fn spans(traversal: AnyTraversal, triangle: &Triangle, area: Rect) -> Vec<Span> {
    let (mut walk, mut batch) = (Default::default(), SpanBatch::default());
    traversal.start(&mut walk, triangle, &area, &mut batch);
    let mut spans = batch.spans().to_vec();
    while !batch.is_last() {
        walk.next_spans(&mut batch);
        spans.extend(batch.spans());
    }
    spans
}

#[test]
fn all_traversals_find_the_same_spans() {
    let mut random = Random(7);
    for i in 0..100_000 {
        let corners = [0; 3].map(|_: i32| any_corner(&mut random, i % 10, PICTURE));
        let Some(triangle) = Triangle::new(corners, PICTURE) else { continue };
        let area = if i % 3 == 0 {
            Rect::new(5, random.range(0, 12), 19, random.range(12, 24))
        } else {
            Rect::from_size(PICTURE)
        };
        let expected = spans(AnyTraversal::Spans, &triangle, area);
        for other in OTHERS {
            assert_eq!(spans(other, &triangle, area), expected, "{other:?} of {corners:?}");
        }
    }
}

#[test]
fn all_traversals_draw_the_same_colours_and_depths() {
    let draw = |traversal| {
        let mut random = Random(8);
        let (mut pixels, mut depth) = (vec![0; 32 * 24], vec![0; 32 * 24]);
        let frame = Frame::<Rgb565>::new(&mut pixels, PICTURE).expect("sizes fit");
        let mut frame = frame.with_depth(&mut depth).expect("sizes fit");
        for i in 0..300 {
            let triangle = [0; 3].map(|_: i32| {
                let at = any_corner(&mut random, i % 10, PICTURE);
                let z = random.range(0, 65_535) as u16;
                let color = Rgb::new(random.next() as u8, random.next() as u8, random.next() as u8);
                (ScreenVertex::new(at.x, at.y, z), Color::from(color))
            });
            ScreenPass::new().depth(Less).traversal(traversal).triangle(
                &mut frame,
                &Gouraud::colored(),
                &triangle,
            );
        }
        (pixels, depth)
    };
    let expected = draw(AnyTraversal::Spans);
    assert!(expected.0.iter().any(|&pixel| pixel != 0), "something is drawn");
    for other in OTHERS {
        assert_eq!(draw(other), expected, "{other:?}");
    }
}

/// Draws small triangles of one colour each, with corners in one place among them.
fn draw_small(traversal: impl Traversal, round: u64) -> (Vec<u16>, Vec<u16>, Stats) {
    let mut random = Random(round);
    let (mut pixels, mut depth) = (vec![0; 32 * 24], vec![0; 32 * 24]);
    let frame = Frame::<Rgb565>::new(&mut pixels, PICTURE).expect("sizes fit");
    let mut frame = frame.with_depth(&mut depth).expect("sizes fit");
    if round.is_multiple_of(2) {
        frame.set_scissor(Rect::new(5, random.range(0, 12), 19, random.range(12, 24)));
    }
    let mut stats = Stats::default();
    let mut pass = ScreenPass::new().depth(Less).traversal(traversal).count(&mut stats);
    for _ in 0..200 {
        pass = pass.cull([Cull::None, Cull::Back, Cull::Front][random.range(0, 2) as usize]);
        let (x, y) = (random.range(-16, 32 * 16), random.range(-16, 24 * 16));
        // Many on a grid of half pixels, where edges go through centres.
        let grid = if random.range(0, 1) == 0 { !7 } else { !0 };
        let is_level = random.range(0, 1) == 0;
        let mut corners = [0; 3].map(|_: i32| {
            let at = |from: i32, random: &mut Random| (from + random.range(0, 40)) & grid;
            let (x, y) = (at(x, &mut random), at(y, &mut random));
            let z = if is_level { 9 } else { random.range(0, 65_535) };
            let color = Rgb::new(random.next() as u8, random.next() as u8, random.next() as u8);
            (ScreenVertex::from_bits(x, y, z as u16), Color::from(color))
        });
        match random.range(0, 9) {
            0 => corners[1].0 = corners[0].0,
            1 => corners = [corners[0]; 3],
            _ => {}
        }
        pass.triangle(&mut frame, &Flat::colored(), &corners);
    }
    (pixels, depth, stats)
}

#[test]
fn few_pixels_are_those_of_any_traversal() {
    let mut seen = [0; 4];
    for round in 0..200 {
        let (few, expected) = (draw_small(Scanline, round), draw_small(BoundingBox, round));
        assert!(few == expected, "round {round}: {:?} for {:?}", few.2, expected.2);
        let Stats { degenerate, culled, outside, drawn, .. } = expected.2;
        for (seen, count) in seen.iter_mut().zip([degenerate, culled, outside, drawn]) {
            *seen += count;
        }
    }
    assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
}

/// Starts another traversal on the left half of the area alone.
#[derive(Clone, Copy)]
struct LeftHalf;

impl Traversal for LeftHalf {
    type Walk = Spans;

    fn start(&self, walk: &mut Spans, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        let middle = (area.left + area.right) / 2;
        Scanline.start(walk, triangle, &Rect { right: middle, ..*area }, batch);
    }
}

#[test]
fn a_traversal_may_start_another_on_a_part_of_the_area() {
    let camera = Camera::perspective(45.0.degrees(), 0.5);
    let model = Mat4::translation(Vec3::new(0.0, 0.0, -8.0));
    let shader = Flat::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    let (mut pixels, mut depth) = (vec![0; 32 * 24], vec![0; 32 * 24]);
    let frame = Frame::<Rgb565>::new(&mut pixels, PICTURE).expect("sizes fit");
    let mut frame = frame.with_depth(&mut depth).expect("sizes fit");
    Pass::new(&camera).depth(Less).traversal(LeftHalf).draw(&mut frame, &model, &TEAPOT, &shader);
    let (left, right): (Vec<_>, Vec<_>) = (0..32 * 24).partition(|at| at % 32 < 16);
    let drawn = |places: &[usize]| places.iter().filter(|at| depth[**at] != 0).count();
    assert!(drawn(&left) > 50, "half of it is drawn");
    assert_eq!(drawn(&right), 0, "the other half is not");
}
