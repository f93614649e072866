//! Depth at both ends and at every code, through what writes and what compares it.

use crate::support::InClipSpace;
use crate::tally::{exhaustive, is_thorough};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::{
    Always, AnyDepth, Camera, Color, Consecutive, Flat, Frame, Less, Mesh, Pass, Points, Rgb,
    Rgb565, ScreenPass, Size, Stats,
};

const SIDE: Size = Size::new(256, 256);
const CODES: usize = 65_536;

/// What a test says of a new code and a stored one: larger is nearer.
fn passes(test: AnyDepth, new: u16, stored: u16) -> bool {
    match test {
        AnyDepth::Less => new > stored,
        AnyDepth::LessEqual => new >= stored,
        AnyDepth::Equal => new == stored,
        AnyDepth::Greater => new < stored,
        AnyDepth::GreaterEqual => new <= stored,
        AnyDepth::NotEqual => new != stored,
        AnyDepth::Always | AnyDepth::Off => true,
        other => panic!("no definition of {other:?}"),
    }
}

/// One point in each pixel of the picture, with the depth that `code` says.
fn dust(code: impl Fn(u16) -> u16) -> Vec<(ScreenVertex, Color)> {
    let at = |i: u16| {
        let (x, y) = (i32::from(i % 256), i32::from(i / 256));
        ScreenVertex::from_bits(16 * x + 8, 16 * y + 8, code(i))
    };
    (0..=u16::MAX).map(|i| (at(i), Rgb::WHITE.into())).collect()
}

#[test]
fn every_stored_code_is_compared_with_its_neighbours_and_both_ends() {
    const TESTS: [AnyDepth; 7] = [
        AnyDepth::Less,
        AnyDepth::LessEqual,
        AnyDepth::Equal,
        AnyDepth::Greater,
        AnyDepth::GreaterEqual,
        AnyDepth::NotEqual,
        AnyDepth::Always,
    ];
    const NEW: [fn(u16) -> u16; 8] = [
        |_| 0,
        |_| 1,
        |code| code.saturating_sub(1),
        |code| code,
        |code| code.saturating_add(1),
        |code| !code,
        |_| u16::MAX - 1,
        |_| u16::MAX,
    ];
    exhaustive("depth codes through encode and compare", || {
        let mut tried = 0;
        for (test, new) in TESTS.iter().flat_map(|test| NEW.map(|new| (*test, new))) {
            let mut pixels = vec![0; CODES];
            let mut codes: Vec<u16> = (0..=u16::MAX).collect();
            let frame = Frame::<Rgb565>::new(&mut pixels, SIDE).expect("it fits");
            let mut frame = frame.with_depth(&mut codes).expect("it fits");
            ScreenPass::new().depth(test).points(&mut frame, &Flat::colored(), 1, &dust(new));
            for (stored, (pixel, code)) in (0..=u16::MAX).zip(pixels.iter().zip(&codes)) {
                let new = new(stored);
                let expected = if passes(test, new, stored) { (0xFFFF, new) } else { (0, stored) };
                assert_eq!((*pixel, *code), expected, "{test:?} of {new} and {stored}");
                tried += 1;
            }
        }
        // All codes come out of clip space, at every size of w that holds them exactly.
        for shift in (0..14).step_by(if is_thorough() { 1 } else { 13 }) {
            tried += check_codes(65_531 << shift, shift);
        }
        tried
    });
}

/// Draws a point for each z from 0 to w in steps of 2^shift, and wants code 2 + z / 2^shift.
fn check_codes(w: i32, shift: u32) -> u64 {
    let place = |i: i32| {
        let (x, y) = (f64::from(i % 256) + 0.5, f64::from(i / 256) + 0.5);
        let on_axis = |v: f64| ((v / 128.0 - 1.0) * f64::from(w)).round() as i32;
        [on_axis(x), -on_axis(y), i << shift, w]
    };
    let points: Vec<[i32; 4]> = (0..=65_531).map(place).collect();
    let mut pixels = vec![0; CODES];
    let mut codes = vec![0; CODES];
    let frame = Frame::<Rgb565>::new(&mut pixels, SIDE).expect("it fits");
    let mut frame = frame.with_depth(&mut codes).expect("it fits");
    let camera = Camera::custom(Mat4::identity());
    let topology = Points::new(Consecutive::new(points.len()));
    let mesh = Mesh::new(&[], &points).with_topology(topology);
    let mut pass = Pass::new(&camera).depth(Always);
    pass.draw_points(&mut frame, &Mat4::identity(), &mesh, &InClipSpace, &1_u16);
    for (z, code) in (0..=65_531_u16).zip(&codes) {
        assert_eq!(*code, z + 2, "z {z} of w {w}");
    }
    65_532
}

/// A sheet across the view at some distance: the code in the middle of the picture.
fn code_at(camera: &Camera, distance: f32) -> Option<u16> {
    let size = Size::new(8, 8);
    let (mut pixels, mut depth) = ([0; 64], [0; 64]);
    let frame = Frame::<Rgb565>::new(&mut pixels, size).expect("it fits");
    let mut frame = frame.with_depth(&mut depth).expect("it fits");
    let corners = [[-32_000, -32_000, 0], [32_000, -32_000, 0], [0, 32_000, 0]];
    let colors = [Rgb::WHITE; 3];
    let scale = Vec3::new(distance / 8_000.0, distance / 8_000.0, 0.0);
    let mesh = Mesh::new(&corners, &colors).placed(scale, Vec3::new(0.0, 0.0, -distance));
    let mut stats = Stats::default();
    let mut pass = Pass::new(camera).depth(Less).count(&mut stats);
    pass.draw(&mut frame, &Mat4::identity(), &mesh, &Flat::colored());
    assert_eq!(stats.skipped, 0, "at {distance}");
    (pixels[36] != 0).then_some(depth[36])
}

#[test]
fn depth_runs_from_end_to_end_for_ratios_of_far_to_near_up_to_a_million() {
    for near in [1e-3_f32, 0.5, 1.0, 100.0] {
        for ratio in [1.001_f32, 2.0, 10.0, 1e3, 1e6] {
            let camera = Camera::perspective(60.0.degrees(), near).far(near * ratio);
            let at = |distance: f32| code_at(&camera, distance);
            assert_eq!(at(near), Some(65_533), "on the near plane: {near} to {ratio} times that");
            // What floats lose of 1 / (far - near) is as much as they lose of far - near.
            let far = at(near * ratio * (1.0 - 1e-4)).expect("just before the far plane");
            let exact = 1e-4 / (1.0 - 1.0 / f64::from(ratio)) / f64::from(ratio) * 65_531.0;
            let off = f64::from(far) - 2.0 - exact;
            assert!(off.abs() < 14.0, "{near} to {ratio} times that: {far}, {off} off");
            assert_eq!(at(near * ratio * 1.01), None, "beyond the far plane");
            assert_eq!(at(near * 0.98), None, "before the near plane");
            let mut last = 65_533;
            for step in 1..=64 {
                let distance = near * ratio.powf(step as f32 / 64.5);
                let code = at(distance).expect("between the planes");
                assert!(code <= last, "farther is no larger: {distance}");
                last = code;
            }
        }
    }
}

#[test]
fn depth_without_a_far_plane_is_the_nearest_code_a_million_times_as_far_as_near() {
    for near in [1e-3_f32, 0.5, 100.0] {
        let camera = Camera::perspective(60.0.degrees(), near);
        for ratio in [1.0_f32, 1.5, 3.0, 100.0, 30_000.0, 70_000.0, 140_000.0, 1e6, 1e12] {
            let code = code_at(&camera, near * ratio).expect("nothing is too far");
            let exact = 2.0 + 65_531.0 / f64::from(ratio);
            let off = f64::from(code) - exact;
            assert!(off.abs() <= 0.51, "{ratio} times {near}: {code} for {exact}");
        }
    }
}

#[test]
fn codes_at_both_ends_are_written_and_interpolated_as_they_are() {
    for z in [0, 1, u16::MAX - 1, u16::MAX] {
        let size = Size::new(64, 64);
        let (mut pixels, mut depth) = (vec![0; 64 * 64], vec![7; 64 * 64]);
        let frame = Frame::<Rgb565>::new(&mut pixels, size).expect("it fits");
        let mut frame = frame.with_depth(&mut depth).expect("it fits");
        let at = |x: i32, y: i32| (ScreenVertex::from_bits(x, y, z), Color::from(Rgb::WHITE));
        let triangle = [at(-30_000, -50_000), at(60_000, 3), at(-7, 64_000)];
        ScreenPass::new().depth(Always).triangle(&mut frame, &Flat::colored(), &triangle);
        for (pixel, code) in pixels.iter().zip(&depth) {
            assert_eq!(*code, if *pixel == 0 { 7 } else { z }, "a level triangle at {z}");
        }
        assert!(pixels.iter().any(|pixel| *pixel != 0), "nothing was drawn");
    }
}
