//! From clip space to the screen: every size of w, w of zero and below.

use crate::support::{InClipSpace, Random};
use crate::tally::{cases, random};
use microraster::math::{Mat4, Vec3, Vec4};
use microraster::{
    Camera, Clip, Consecutive, Cull, Frame, Gouraud, Mesh, Pass, Points, Rgb, Rgba8888, Size, Stats,
};

const SIZE: Size = Size::new(64, 48);

/// Draws into an empty picture: its pixels, and what was counted.
fn drawn(draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats)) -> (Vec<u32>, Stats) {
    let mut pixels = vec![0; 64 * 48];
    let mut stats = Stats::default();
    draw(&mut Frame::new(&mut pixels, SIZE).expect("it fits"), &mut stats);
    (pixels, stats)
}

/// The pixel of the only point of a mesh, and what was counted.
fn point(at: [i32; 4]) -> (Option<(i32, i32)>, Stats) {
    let camera = Camera::custom(Mat4::identity());
    let (pixels, stats) = drawn(|frame, stats| {
        let mesh = Mesh::new(&[], std::slice::from_ref(&at));
        let mesh = mesh.with_topology(Points::new(Consecutive::new(1)));
        let mut pass = Pass::new(&camera).count(stats);
        pass.draw_points(frame, &Mat4::identity(), &mesh, &InClipSpace, &1_u16);
    });
    let set = pixels.iter().position(|pixel| *pixel != 0).map(|i| i as i32);
    (set.map(|i| (i % 64, i / 64)), stats)
}

/// The columns (or rows) in which a point of one pixel may be: its place in subpixels is rounded
/// to nearest, and a hundredth of one that products may be off.
fn columns(v: i32, w: i32, side: i32) -> (i32, i32) {
    let exact = f64::from(side) * 8.0 * (1.0 + f64::from(v) / f64::from(w));
    let of = |subpixels: f64| ((subpixels.round() as i32) - 1).div_euclid(16);
    (of(exact - 0.01), of(exact + 0.01))
}

#[test]
fn points_lie_where_their_clip_coordinates_say_for_every_w() {
    let property = "points lie where clip coordinates say, w from 1 to 2^30";
    let mut seen = 0_u64;
    random(property, cases(100_000, 5_000_000), 61, |random| {
        let bits = random.range(0, 29);
        let w = (1 << bits) + random.range(0, (1 << bits) - 1);
        // A little beside the view, too.
        let beyond = (i64::from(w) * 33 / 32).min((1 << 30) - 1) as i32;
        let (x, y) = (random.range(-beyond, beyond), random.range(-beyond, beyond));
        let (found, stats) = point([x, y, random.range(0, w), w]);
        assert_eq!((stats.points, stats.skipped), (1, 0), "{x}, {y}, {w}");
        let (left, right) = columns(x, w, 64);
        let (above, below) = columns(y.wrapping_neg(), w, 48);
        let may_be =
            |at: (i32, i32)| (left..=right).contains(&at.0) && (above..=below).contains(&at.1);
        match found {
            Some(at) => assert!(may_be(at), "{x}, {y}, {w}: {at:?}"),
            None => {
                let inside = (0..64).contains(&left)
                    && (0..64).contains(&right)
                    && (0..48).contains(&above)
                    && (0..48).contains(&below);
                assert!(!inside, "{x}, {y}, {w} is not there");
            }
        }
        seen += u64::from(found.is_some());
        1
    });
    assert!(seen > 0 || !cfg!(debug_assertions), "no point was seen");
}

#[test]
fn clip_coordinates_end_just_below_their_limit() {
    let limit = Clip::LIMIT;
    for place in 0..4 {
        for sign in [-1, 1] {
            let at = |v: i32| {
                let mut clip = [0, 0, 0, 1];
                clip[place] = sign * v;
                clip
            };
            let made = |v: i32| {
                let [x, y, z, w] = at(v);
                Clip::new(x, y, z, w).is_some()
            };
            let ends = [limit - 2, limit - 1, limit, limit + 1].map(made);
            assert_eq!(ends, [true, true, false, false], "coordinate {place}");
            let (_, stats) = point(at(limit));
            assert_eq!(stats.skipped, 1, "beyond the end is skipped, coordinate {place}");
            let (_, stats) = point(at(limit - 1));
            assert_eq!(stats.skipped, 0, "the end is not, coordinate {place}");
        }
    }
}

#[test]
fn a_w_of_zero_or_below_draws_no_point_and_no_triangle() {
    for w in [0, -1, -2, -(1 << 20), 1 - Clip::LIMIT] {
        for v in [0, 1, -1, 1 << 20, Clip::LIMIT - 1, 1 - Clip::LIMIT] {
            assert_eq!(point([v, v / 2, 0, w]).0, None, "{v} with w {w}");
            let camera = Camera::custom(Mat4::identity());
            let triangle = [[v, 0, 0, w], [0, v, 0, w], [-v, 1, 0, w]];
            let (pixels, stats) = drawn(|frame, stats| {
                let mut pass = Pass::new(&camera).count(stats);
                pass.draw(frame, &Mat4::identity(), &Mesh::new(&[], &triangle), &InClipSpace);
            });
            assert!(pixels.iter().all(|pixel| *pixel == 0), "{triangle:?}");
            assert_eq!((stats.triangles, stats.drawn), (1, 0), "{triangle:?}");
        }
    }
}

/// Clip z of all corners, so that the near plane is where w is as much: large enough for the
/// rounding of a matrix that it is granted, 98304 units, to be less than a 64th of it.
const NEAR: i32 = 1 << 24;

/// Of a point of the picture at pixel coordinates (x, y): on which side it is of each edge of a
/// triangle of clip space and of the near plane, positive inside. This homogeneous definition needs
/// no clipping.
fn sides(v: &[[f64; 4]; 3], (x, y): (f64, f64)) -> [f64; 4] {
    let at = [x / 32.0 - 1.0, 1.0 - y / 24.0, 1.0];
    let row = |v: [f64; 4]| [v[0], v[1], v[3]];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let rows = v.map(row);
    let determinant = dot(rows[0], cross(rows[1], rows[2]));
    // How much of each corner makes the point with w = 1, and what is left of w to z.
    let [a, b, c] =
        [0, 1, 2].map(|k| dot(cross(rows[(k + 1) % 3], rows[(k + 2) % 3]), at) / determinant);
    [a, b, c, 1.0 - (a + b + c) * f64::from(NEAR)]
}

/// Whether a square about a point is wholly inside of a triangle, or wholly outside; `None` if its
/// corners do not tell.
fn is_inside(v: &[[f64; 4]; 3], x: f64, y: f64, half: f64) -> Option<bool> {
    let corners = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
    let corners = corners.map(|(dx, dy)| sides(v, (x + half * dx, y + half * dy)));
    if corners.iter().flatten().all(|side| *side >= 0.0) {
        return Some(true);
    }
    // All beyond one and the same line. The near plane lets a 64th of w pass.
    let outside = [0.0, 0.0, 0.0, -1.0 / 63.0];
    (0..4).any(|k| corners.iter().all(|sides| sides[k] < outside[k])).then_some(false)
}

#[test]
fn triangles_with_corners_behind_the_eye_or_at_w_zero_show_what_lies_before_it() {
    let mut random = Random(62);
    let camera = Camera::custom(Mat4::identity());
    let (mut compared, mut behind) = (0, 0);
    for _ in 0..5_000 {
        let mut number = || random.range(-(1 << 29), 1 << 29);
        let mut triangle = [(); 3].map(|()| [number(), number(), NEAR, number()]);
        if random.range(0, 3) == 0 {
            triangle[0][3] = 0;
        }
        let (pixels, stats) = drawn(|frame, stats| {
            let mut pass = Pass::new(&camera).count(stats);
            pass.draw(frame, &Mat4::identity(), &Mesh::new(&[], &triangle), &InClipSpace);
        });
        assert_eq!(stats.skipped, 0, "{triangle:?}");
        behind += u32::from(triangle.iter().any(|corner| corner[3] <= 0));
        let v = triangle.map(|corner| corner.map(f64::from));
        for (i, pixel) in pixels.iter().enumerate() {
            let (x, y) = (f64::from(i as u32 % 64) + 0.5, f64::from(i as u32 / 64) + 0.5);
            // An eighth of a pixel, for corners and cuts that are rounded.
            if let Some(inside) = is_inside(&v, x, y, 0.125) {
                assert_eq!(*pixel != 0, inside, "at {x}, {y}: {triangle:?}");
                compared += 1;
            }
        }
    }
    assert!(compared > 10_000_000 && behind > 3_000, "{compared} pixels, {behind} behind");
}

/// A small mesh through a matrix times a factor: homogeneous coordinates do not change by it.
fn scaled(factor: f32, cull: Cull) -> (Vec<u32>, Stats) {
    let positions = [[-9_000, -4_000, 3_000], [8_000, -7_000, -2_000], [500, 9_000, 7_000]];
    let colors = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];
    let row = |x: f32, y: f32, z: f32, w: f32| Vec4::new(x, y, z, w) * factor;
    let camera = Camera::custom(Mat4::from_rows(
        row(1.0, 0.2, 0.0, 0.0),
        row(0.1, 1.1, 0.0, 0.0),
        row(0.0, 0.0, 0.25, 0.5),
        row(0.0, 0.0, 0.5, 1.0),
    ));
    let mesh = Mesh::new(&positions, &colors).placed(Vec3::splat(1.0 / 10_000.0), Vec3::ZERO);
    drawn(|frame, stats| {
        let mut pass = Pass::new(&camera).cull(cull).count(stats);
        pass.draw(frame, &Mat4::identity(), &mesh, &Gouraud::colored());
    })
}

#[test]
fn a_w_of_any_power_of_two_from_2_to_the_minus_30_to_2_to_the_30_gives_the_same_picture() {
    let (expected, stats) = scaled(1.0, Cull::Back);
    assert!(stats.drawn == 1 && stats.pixels > 500, "{stats:?}");
    for exponent in -30..=30 {
        let (pixels, stats) = scaled((exponent as f32).exp2(), Cull::Back);
        assert!(pixels == expected, "times 2^{exponent}: {stats:?}");
    }
}
