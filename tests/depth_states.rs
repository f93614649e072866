//! Depth without writing, of one code a triangle, offset, and in a range.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use fixed::types::I8F8;
use microraster::raster::ScreenVertex;
use microraster::{
    Always, AnyDepth, AnyDepthState, Color, ConstantDepth, DepthRange, DepthTest, Equal, Flat,
    Frame, Gouraud, Less, LessEqual, Midpoint, PolygonOffset, ReadOnly, Rectangle, Rgb, Rgb565,
    ScreenPass, Size, Smooth, Thin, Wide,
};
use support::{any_corner, Random};

const SIZE: Size = Size::new(32, 24);
const PIXELS: usize = 32 * 24;

type Triangle = [(ScreenVertex, Color); 3];

/// Triangles of all sizes in all depths.
fn triangles(seed: u64) -> Vec<Triangle> {
    let mut random = Random(seed);
    (0..120)
        .map(|i| {
            [0; 3].map(|_: i32| {
                let at = any_corner(&mut random, i % 10, SIZE);
                let z = [0, 65_535, random.next() as u16][random.range(0, 2) as usize];
                let color = Rgb::new(random.next() as u8, random.next() as u8, 200);
                (ScreenVertex::new(at.x, at.y, z), color.into())
            })
        })
        .collect()
}

/// The codes and colours that triangles leave, interpolated or flat, from `before`.
fn drawn<D: DepthTest>(
    depth: D,
    flat: bool,
    triangles: &[Triangle],
    before: u16,
) -> (Vec<u16>, Vec<u16>)
where
    for<'a> microraster::DepthBuffer<'a>: microraster::frame::Supplies<D::Access>,
{
    let (mut pixels, mut codes) = (vec![0; PIXELS], vec![0; PIXELS]);
    let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("sizes fit");
    let mut frame = frame.with_depth(&mut codes).expect("sizes fit");
    frame.clear_depth(before);
    let mut pass = ScreenPass::new().depth(depth);
    if flat {
        pass.triangles(&mut frame, &Flat::colored(), triangles);
    } else {
        pass.triangles(&mut frame, &Gouraud::colored(), triangles);
    }
    (codes, pixels)
}

#[test]
fn wrappers_that_change_nothing_change_no_bit() {
    let triangles = triangles(1);
    for flat in [false, true] {
        let plain = drawn(Less, flat, &triangles, 0);
        let unmoved = PolygonOffset::new(Less, I8F8::ZERO, 0);
        assert_eq!(drawn(unmoved, flat, &triangles, 0), plain, "offset 0");
        let whole = DepthRange::new(Less, 0, 65_535);
        assert_eq!(drawn(whole, flat, &triangles, 0), plain, "the whole range");
        let any = AnyDepthState::new(AnyDepth::Less);
        assert_eq!(drawn(any, flat, &triangles, 0), plain, "chosen at run time");
    }
}

#[test]
fn read_only_depth_draws_the_same_and_leaves_no_code() {
    let triangles = triangles(2);
    let (codes, _) = drawn(ReadOnly::new(LessEqual), false, &triangles, 30_000);
    assert!(codes.iter().all(|code| *code == 30_000), "untouched");
    // One triangle alone meets the same codes.
    for triangle in triangles.chunks(1) {
        let (_, written) = drawn(LessEqual, false, triangle, 30_000);
        let (_, read) = drawn(ReadOnly::new(LessEqual), false, triangle, 30_000);
        assert_eq!(written, read, "{triangle:?}");
    }
}

#[test]
fn constant_depth_is_the_mean_of_the_corners() {
    for triangle in triangles(3).chunks(1) {
        let sum: u32 = triangle[0].iter().map(|(at, _)| u32::from(at.z)).sum();
        for flat in [false, true] {
            let (plain, _) = drawn(Always, flat, triangle, 0);
            let (codes, pixels) = drawn(ConstantDepth::new(Always), flat, triangle, 1);
            let mean = (sum / 3) as u16;
            for ((code, pixel), plain) in codes.iter().zip(&pixels).zip(&plain) {
                assert!(*code == mean || (*code == 1 && *pixel == 0 && *plain == 0), "{code}");
            }
        }
    }
}

#[test]
fn offsets_move_away_by_slope_and_codes_and_never_wrap() {
    let mut random = Random(4);
    for triangle in triangles(4).chunks(1) {
        let slope = I8F8::from_bits(random.range(-600, 600) as i16);
        let units = random.range(-3000, 3000) as i16;
        let (before, _) = drawn(Always, false, triangle, 0);
        let (after, _) = drawn(PolygonOffset::new(Always, slope, units), false, triangle, 0);
        let flat = drawn(PolygonOffset::new(Always, slope, units), true, triangle, 0);
        assert_eq!(flat.0, after, "flat and interpolated triangles are moved alike");
        // The exact slopes, from the corners.
        let v = triangle[0]
            .map(|(at, _)| [f64::from(at.x.to_bits()), f64::from(at.y.to_bits()), f64::from(at.z)]);
        let side = |k: usize| [0, 1, 2].map(|axis| v[k][axis] - v[0][axis]);
        let ([x1, y1, z1], [x2, y2, z2]) = (side(1), side(2));
        let area = x1 * y2 - x2 * y1;
        if area == 0.0 {
            continue;
        }
        let dx = 16.0 * (z1 * y2 - z2 * y1) / area;
        let dy = 16.0 * (x1 * z2 - x2 * z1) / area;
        let steepest = dx.abs().max(dy.abs());
        if steepest > 32_000.0 {
            // A sliver's slopes wrap, and what is limited is checked by the others.
            continue;
        }
        let codes = v.map(|v| v[2]);
        let least = codes.iter().copied().fold(f64::MAX, f64::min);
        let most = codes.iter().copied().fold(0.0, f64::max);
        let moved =
            (steepest * slope.to_num::<f64>() + f64::from(units)).clamp(most - 65_535.0, least);
        // An eighth of a code over the triangle is the planes' own error; the slope's is that of
        // one pixel, and rounding makes it a code.
        let bound = 1.6 + slope.to_num::<f64>().abs() * 0.2;
        for (before, after) in before.iter().zip(&after).filter(|(before, _)| **before != 0) {
            let off = (f64::from(*before) - f64::from(*after) - moved).abs();
            assert!(off < bound, "{before} to {after} is not {moved}: {triangle:?}");
        }
    }
}

#[test]
fn equal_depth_passes_at_offset_0_and_no_other() {
    let triangles =
        [triangles(5)[0].map(|(at, color)| (ScreenVertex::new(at.x, at.y, 9000), color))];
    let (mut pixels, mut codes) = (vec![0; PIXELS], vec![0; PIXELS]);
    let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("sizes fit");
    let mut frame = frame.with_depth(&mut codes).expect("sizes fit");
    let mut stats = microraster::Stats::default();
    ScreenPass::new().depth(Less).triangles(&mut frame, &Flat::colored(), &triangles);
    let unmoved = PolygonOffset::new(Equal, I8F8::ZERO, 0);
    ScreenPass::new().depth(unmoved).count(&mut stats).triangles(
        &mut frame,
        &Gouraud::colored(),
        &triangles,
    );
    let all = stats.pixels;
    assert!(all > 0, "drawn");
    for units in [-1, 1] {
        let moved = PolygonOffset::new(Equal, I8F8::ZERO, units);
        ScreenPass::new().depth(moved).count(&mut stats).triangles(
            &mut frame,
            &Gouraud::colored(),
            &triangles,
        );
    }
    assert_eq!(stats.pixels, all, "a code away is not equal");
}

#[test]
fn a_range_maps_codes_between_its_ends() {
    let mut random = Random(6);
    for _ in 0..100_000 {
        let (farthest, nearest) = (random.next() as u16, random.next() as u16);
        let code = [0, 65_535, random.next() as u16][random.range(0, 2) as usize];
        let range = DepthRange::new(Less, farthest, nearest);
        let exact = f64::from(farthest)
            + (f64::from(nearest) - f64::from(farthest)) * f64::from(code) / 65_535.0;
        let off = (f64::from(range.map(code)) - exact).abs();
        assert!(off <= 0.5001, "{code} in {farthest}..{nearest}: {off}");
        assert_eq!((range.map(0), range.map(65_535)), (farthest, nearest), "both ends");
    }
    let (codes, _) = drawn(DepthRange::new(Always, 20_000, 40_000), false, &triangles(6), 0);
    let inside = |code: &u16| *code == 0 || (20_000..=40_000).contains(code);
    assert!(codes.iter().all(inside), "all in range");
    assert!(codes.iter().any(|code| *code > 20_000), "something is drawn");
}

#[test]
fn runtime_depth_states_give_the_same_bits() {
    let triangles = triangles(7);
    let plain = AnyDepthState::new(AnyDepth::LessEqual);
    for flat in [false, true] {
        let slope = I8F8::from_num(1.25);
        let moved = drawn(PolygonOffset::new(LessEqual, slope, -7), flat, &triangles, 0);
        let any = AnyDepthState { offset: (slope, -7), ..plain };
        assert_eq!(drawn(any, flat, &triangles, 0), moved, "offset");
        let read = drawn(ReadOnly::new(LessEqual), flat, &triangles, 777);
        let any = AnyDepthState { read_only: true, ..plain };
        assert_eq!(drawn(any, flat, &triangles, 777), read, "read only");
        let constant = drawn(ConstantDepth::new(LessEqual), flat, &triangles, 0);
        let any = AnyDepthState { constant: true, ..plain };
        assert_eq!(drawn(any, flat, &triangles, 0), constant, "constant");
        let ranged = drawn(DepthRange::new(LessEqual, 50_000, 3), flat, &triangles, 0);
        let any = AnyDepthState { range: (50_000, 3), ..plain };
        assert_eq!(drawn(any, flat, &triangles, 0), ranged, "range");
        let all = DepthRange::new(
            PolygonOffset::new(ConstantDepth::new(ReadOnly::new(LessEqual)), slope, 9),
            9,
            60_000,
        );
        let any = AnyDepthState {
            test: AnyDepth::LessEqual,
            read_only: true,
            constant: true,
            offset: (slope, 9),
            range: (9, 60_000),
        };
        assert_eq!(drawn(any, flat, &triangles, 0), drawn(all, flat, &triangles, 0), "all");
    }
}

/// What lines and points of all kinds leave, each kind in a frame of its own.
fn strokes<D: DepthTest + Copy>(depth: D, corners: &[(ScreenVertex, Color)]) -> Vec<Vec<u16>>
where
    for<'a> microraster::DepthBuffer<'a>: microraster::frame::Supplies<D::Access>,
{
    let lines: Vec<_> = corners.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
    let (smooth, flat) = (Gouraud::colored(), Flat::colored());
    (0..8)
        .map(|kind| {
            let (mut pixels, mut codes) = (vec![0; PIXELS], vec![0; PIXELS]);
            let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("sizes fit");
            let mut frame = frame.with_depth(&mut codes).expect("sizes fit");
            let mut pass = ScreenPass::new().depth(depth);
            match kind {
                0 => pass.lines(&mut frame, &smooth, Thin, &lines),
                1 => pass.lines(&mut frame, &flat, Thin, &lines),
                2 => pass.lines(&mut frame, &flat, Midpoint, &lines),
                3 => pass.lines(&mut frame, &smooth, Wide(3), &lines),
                4 => pass.lines(&mut frame, &smooth, Rectangle(3), &lines),
                5 => pass.lines(&mut frame, &smooth, Smooth(2), &lines),
                6 => pass.points(&mut frame, &flat, 1, corners),
                _ => pass.points(&mut frame, &smooth, 3, corners),
            }
            codes
        })
        .collect()
}

#[test]
fn ranges_are_for_lines_and_points_and_offsets_are_not() {
    for triangle in triangles(8) {
        let [a, b, c] = triangle;
        let corners = [a, b, c, a];
        let plain = strokes(Always, &corners);
        let moved = PolygonOffset::new(Always, I8F8::from_num(2), 900);
        assert_eq!(strokes(moved, &corners), plain, "lines and points are not moved");
        let range = DepthRange::new(Always, 50_000, 1000);
        let mapped = corners.map(|(at, color)| (ScreenVertex { z: range.map(at.z), ..at }, color));
        assert_eq!(strokes(range, &corners), strokes(Always, &mapped), "in a range");
        let any = AnyDepthState {
            offset: (I8F8::from_num(2), 900),
            range: (50_000, 1000),
            ..AnyDepthState::new(AnyDepth::Always)
        };
        assert_eq!(strokes(any, &corners), strokes(Always, &mapped), "chosen at run time");
    }
}

#[test]
fn constant_depth_is_the_mean_of_a_lines_ends() {
    let mut seen = 0;
    for [a, b, _] in triangles(9) {
        let mean = (u32::from(a.0.z) + u32::from(b.0.z)) / 2;
        let plain = strokes(Always, &[a, b]);
        let constant = strokes(ConstantDepth::new(Always), &[a, b]);
        // Lines as such; rectangles have the mean of their triangles' corners, and points their own.
        for (plain, constant) in plain.iter().zip(&constant).take(4) {
            let allowed = |code: &u16| *code == 0 || u32::from(*code) == mean;
            assert!(constant.iter().all(allowed), "{mean}: {a:?} to {b:?}");
            assert!(
                plain.iter().zip(constant).all(|(a, b)| *a == 0 || *b != 0 || mean == 0),
                "same"
            );
            seen += constant.iter().filter(|code| **code != 0).count();
        }
        assert_eq!(plain[6..], constant[6..], "points");
    }
    assert!(seen > 1000, "lines are drawn");
}
