//! Every pixel of a mesh is drawn exactly once: in the picture, through the guard box and through
//! the near plane.
//!
//! The counter says how many pixels were written, the picture says which: where both numbers are
//! the same, none was written twice; where the pixels are those of the outline, none is missing.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small pictures and random numbers"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::{Camera, Color, Flat, Frame, Mesh, Pass, Rgb, Rgba8888, ScreenPass, Size, Stats};
use support::{covers, Random};

const SIZE: Size = Size::new(48, 40);

/// The pixels that a drawing sets, row by row, and what it counts.
fn drawn(draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats)) -> (Vec<(i32, i32)>, Stats) {
    let mut pixels = vec![0; 48 * 40];
    let mut stats = Stats::default();
    let mut frame = Frame::new(&mut pixels, SIZE).expect("the buffer fits");
    draw(&mut frame, &mut stats);
    let set = pixels.iter().enumerate().filter(|(_, word)| **word != 0);
    (set.map(|(i, _)| (i as i32 % 48, i as i32 / 48)).collect(), stats)
}

fn assert_once(pixels: &[(i32, i32)], stats: &Stats, what: &dyn std::fmt::Debug) {
    assert_eq!(stats.pixels as usize, pixels.len(), "a pixel twice: {what:?}");
    assert_eq!(stats.skipped, 0, "{what:?}");
}

/// Triangles of a grid of points, `columns` in a row, cut along one diagonal or the other.
fn grid_triangles(random: &mut Random, columns: usize, points: usize) -> Vec<[usize; 3]> {
    let mut triangles = Vec::new();
    for a in 0..points - columns {
        if a % columns + 1 < columns {
            let (b, c, d) = (a + 1, a + columns + 1, a + columns);
            let halves = if random.next().is_multiple_of(2) {
                [[a, b, c], [a, c, d]]
            } else {
                [[b, c, d], [b, d, a]]
            };
            for mut half in halves {
                // Any corner first.
                half.rotate_left((random.next() % 3) as usize);
                triangles.push(half);
            }
        }
    }
    triangles
}

fn screen_mesh(
    points: &[ScreenVertex],
    triangles: &[[usize; 3]],
) -> Vec<[(ScreenVertex, Color); 3]> {
    triangles.iter().map(|t| t.map(|i| (points[i], Rgb::WHITE.into()))).collect()
}

/// A grid over a rectangle whose inner points are moved by less than half a cell.
fn jittered(
    random: &mut Random,
    [left, top, right, bottom]: [i32; 4],
) -> (usize, Vec<ScreenVertex>) {
    let (columns, rows) = (random.range(2, 9), random.range(2, 9));
    let mut points = Vec::new();
    for j in 0..rows {
        for i in 0..columns {
            let (w, h) = ((right - left) / (columns - 1), (bottom - top) / (rows - 1));
            let mut x = if i + 1 == columns { right } else { left + i * w };
            let mut y = if j + 1 == rows { bottom } else { top + j * h };
            if (1..columns - 1).contains(&i) {
                x += random.range(-(w * 2 / 9), w * 2 / 9);
            }
            if (1..rows - 1).contains(&j) {
                y += random.range(-(h * 2 / 9), h * 2 / 9);
            }
            points.push(ScreenVertex::from_bits(x, y, 0));
        }
    }
    (columns as usize, points)
}

#[test]
fn jittered_grids_cover_their_rectangle_once() {
    let mut random = Random(21);
    for i in 0..4_000 {
        let outline = match i % 3 {
            // Inside, across the borders, to the ends of the range.
            0 => [
                random.range(0, 300),
                random.range(0, 300),
                random.range(400, 768),
                random.range(400, 640),
            ],
            1 => [
                random.range(-900, 300),
                random.range(-900, 300),
                random.range(400, 3_000),
                random.range(400, 3_000),
            ],
            _ => [-65_536 + 384, -65_536 + 320, 65_536 + 384, 65_536 + 320],
        };
        let (columns, points) = jittered(&mut random, outline);
        let triangles = grid_triangles(&mut random, columns, points.len());
        let mesh = screen_mesh(&points, &triangles);
        let (pixels, stats) = drawn(|frame, stats| {
            ScreenPass::new().count(stats).triangles(frame, &Flat::colored(), &mesh);
        });
        assert_once(&pixels, &stats, &points);
        // The rectangle's own pixels by the top-left rule.
        let [left, top, right, bottom] = outline;
        let within = |p: i32, from: i32, to: i32| (from..to).contains(&(16 * p + 8));
        let all = (0..40).flat_map(|y| (0..48).map(move |x| (x, y)));
        let expected: Vec<(i32, i32)> =
            all.filter(|&(x, y)| within(x, left, right) && within(y, top, bottom)).collect();
        assert_eq!(pixels, expected, "{outline:?}");
    }
}

#[test]
fn fans_cover_their_polygon_once() {
    let mut random = Random(22);
    for _ in 0..2_000 {
        let parts = random.range(3, 48);
        let reach = f64::from(random.range(20, 5_000));
        let (x, y) = (random.range(100, 600), random.range(100, 500));
        let turn = random.unit();
        let rim: Vec<ScreenVertex> = (0..parts)
            .map(|i| {
                let (s, c) =
                    ((f64::from(i) / f64::from(parts) + turn) * std::f64::consts::TAU).sin_cos();
                ScreenVertex::from_bits(x + (c * reach) as i32, y + (s * reach) as i32, 0)
            })
            .collect();
        let middle = ScreenVertex::from_bits(x, y, 0);
        let triangles: Vec<[ScreenVertex; 3]> =
            (0..rim.len()).map(|i| [middle, rim[i], rim[(i + 1) % rim.len()]]).collect();
        let mesh: Vec<_> = triangles.iter().map(|t| t.map(|v| (v, Rgb::WHITE.into()))).collect();
        let (pixels, stats) = drawn(|frame, stats| {
            ScreenPass::new().count(stats).triangles(frame, &Flat::colored(), &mesh);
        });
        assert_once(&pixels, &stats, &rim);
        let all = (0..40).flat_map(|y| (0..48).map(move |x| (x, y)));
        let expected: Vec<(i32, i32)> =
            all.filter(|&(x, y)| triangles.iter().any(|t| covers(t, x, y))).collect();
        assert_eq!(pixels, expected, "{rim:?}");
    }
}

/// A jittered floor in 16-bit positions: x and z from -32000 to 32000.
fn floor(random: &mut Random) -> (Vec<[i16; 3]>, Vec<u16>) {
    let (columns, points) = jittered(random, [-32_000, -32_000, 32_000, 32_000]);
    let positions =
        points.iter().map(|v| [v.x.to_bits() as i16, 0, v.y.to_bits() as i16]).collect();
    let triangles = grid_triangles(random, columns, points.len());
    (positions, triangles.into_iter().flatten().map(|i| i as u16).collect())
}

#[test]
fn floors_through_the_near_plane_and_the_guard_box_have_no_holes() {
    let mut random = Random(23);
    let (mut clipped, mut filled) = (0, 0);
    for i in 0..3_000 {
        let (positions, indices) = floor(&mut random);
        let colors = vec![Rgb::WHITE; positions.len()];
        let reach = [20.0, 200.0][i % 2];
        let mesh = Mesh::new(&positions, &colors)
            .indexed(&indices)
            .placed(Vec3::splat(reach / 32_000.0), Vec3::ZERO);
        let mut number = |from: f64, to: f64| (from + (to - from) * random.unit()) as f32;
        // Above the floor's middle, looking down or ahead.
        let eye = Vec3::new(number(-3.0, 3.0), number(0.05, 2.0), number(-3.0, 3.0));
        let target = eye + Vec3::new(number(-1.0, 1.0), number(-2.0, -0.1), -1.0);
        let near = number(0.01, 0.6);
        let camera = Camera::perspective(60.0.degrees(), near).look_at(eye, target, Vec3::Y);
        let (pixels, stats) = drawn(|frame, stats| {
            Pass::new(&camera).count(stats).draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
        });
        assert_eq!(stats.pixels as usize, pixels.len(), "a pixel twice: {eye:?} {target:?}");
        assert_eq!(stats.skipped, 0, "{eye:?} {target:?}");
        // A plane that is cut by the near plane and by its own far rim: what is seen of it is
        // convex, so that no row and no column of pixels has a hole.
        for line in 0..48 {
            let row: Vec<i32> = pixels.iter().filter(|p| p.1 == line).map(|p| p.0).collect();
            assert!(row.windows(2).all(|w| w[1] == w[0] + 1), "a hole in row {line}: {eye:?}");
            let column: Vec<i32> = pixels.iter().filter(|p| p.0 == line).map(|p| p.1).collect();
            assert!(
                column.windows(2).all(|w| w[1] == w[0] + 1),
                "a hole in column {line}: {eye:?}"
            );
        }
        clipped += stats.clipped;
        filled += usize::from(pixels.len() > 400);
    }
    assert!(clipped > 3_000 && filled > 1_500, "hardly tested: {clipped} clipped, {filled} filled");
}
