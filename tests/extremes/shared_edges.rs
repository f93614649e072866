//! Every pixel of a mesh is drawn exactly once: in the picture, through the guard box and through
//! the near plane.
//!
//! The counter says how many pixels were written, the picture says which: where both numbers are
//! the same, none was written twice; where the pixels are those of the outline, none is missing.

use crate::support::{covers, Random};
use crate::tally::{cases, random};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::{
    Camera, Color, Flat, Frame, IndexedList, Mesh, Pass, Rgb, Rgba8888, ScreenPass, Size, Stats,
};

const SIZE: Size = Size::new(48, 40);

/// The pixels that a drawing sets, row by row, and what it counts.
pub(crate) fn drawn(
    draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats),
) -> (Vec<(i32, i32)>, Stats) {
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

/// Fails where a grid does not cover its rectangle once; returns how many triangles it has.
fn check_grid(random: &mut Random) -> u64 {
    let outline = match random.range(0, 2) {
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
    let (columns, points) = jittered(random, outline);
    let triangles = grid_triangles(random, columns, points.len());
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
    triangles.len() as u64
}

/// Fails where a fan about a point does not cover its polygon once; returns how many triangles it
/// has.
fn check_fan(random: &mut Random) -> u64 {
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
    triangles.len() as u64
}

#[test]
fn grids_and_fans_cover_what_they_outline_once_at_any_subpixel_offset() {
    let wanted = cases(150_000, 9_000_000);
    random("shared edges are drawn once, up to the guard box", wanted, 21, |random| {
        // A fan is compared triangle by triangle, which takes longer.
        if random.range(0, 7) == 0 {
            check_fan(random)
        } else {
            check_grid(random)
        }
    });
}

/// A jittered floor in 16-bit positions: x and z from -32000 to 32000.
pub(crate) fn floor(random: &mut Random) -> Floor {
    let (columns, points) = jittered(random, [-32_000, -32_000, 32_000, 32_000]);
    let positions =
        points.iter().map(|v| [v.x.to_bits() as i16, 0, v.y.to_bits() as i16]).collect();
    let triangles = grid_triangles(random, columns, points.len());
    (positions, triangles.into_iter().flatten().map(|i| i as u16).collect())
}

/// A camera above the middle of a floor of this reach, looking down or ahead.
pub(crate) fn above(random: &mut Random) -> Camera {
    let mut number = |from: f64, to: f64| (from + (to - from) * random.unit()) as f32;
    let eye = Vec3::new(number(-3.0, 3.0), number(0.05, 2.0), number(-3.0, 3.0));
    let target = eye + Vec3::new(number(-1.0, 1.0), number(-2.0, -0.1), -1.0);
    Camera::perspective(60.0.degrees(), number(0.01, 0.6)).look_at(eye, target, Vec3::Y)
}

/// Where a point of the world is seen in the picture, in pixels; `None` behind the near plane.
fn seen_at(camera: &Camera, point: [f64; 3]) -> Option<(f64, f64)> {
    let [x, y, z, w] = camera.view().to_columns().map(|column| column.map(f64::from));
    let eye = |i: usize| x[i] * point[0] + y[i] * point[1] + z[i] * point[2] + w[i];
    let lens = camera.projection(48.0 / 40.0).to_columns();
    let (across, up, near) = (f64::from(lens[0][0]), f64::from(lens[1][1]), f64::from(lens[3][2]));
    let distance = -eye(2);
    let at = (24.0 + 24.0 * across * eye(0) / distance, 20.0 - 20.0 * up * eye(1) / distance);
    (distance >= near).then_some(at)
}

/// Whether a pixel lies at a triangle so thin that rounding its corners to 1/16 pixel may have
/// turned it about: its neighbours then overlap by its pixels, on any grid.
fn is_at_a_fold(corners: [(f64, f64); 3], (x, y): (i32, i32)) -> bool {
    let to = |a: (f64, f64), b: (f64, f64)| (b.0 - a.0, b.1 - a.1);
    let cross = |a: (f64, f64), b: (f64, f64)| a.0 * b.1 - a.1 * b.0;
    let sides = [0, 1, 2].map(|i| (corners[i], to(corners[i], corners[(i + 1) % 3])));
    let length = |(_, side): &((f64, f64), (f64, f64))| side.0.hypot(side.1);
    let longest = sides.iter().max_by(|a, b| length(a).total_cmp(&length(b)));
    let (from, side) = *longest.expect("three sides");
    let long = side.0.hypot(side.1);
    let height = cross(sides[0].1, sides[1].1).abs() / long;
    let center = to(from, (f64::from(x) + 0.5, f64::from(y) + 0.5));
    let along = (center.0 * side.0 + center.1 * side.1) / long;
    let beside = cross(side, center).abs() / long;
    height < 0.125 && beside < 0.25 && (-0.25..long + 0.25).contains(&along)
}

/// Fails unless every pixel that was drawn twice lies at a triangle that is thinner than 1/8 pixel.
fn assert_folded(mesh: &FloorMesh<'_>, floor: &Floor, reach: f32, camera: &Camera) {
    let mut times = vec![0; 48 * 40];
    for triangle in floor.1.chunks_exact(3) {
        let (pixels, _) = drawn(|frame, stats| {
            let mut pass = Pass::new(camera).count(stats);
            pass.draw(frame, &Mat4::identity(), &mesh.indexed(triangle), &Flat::colored());
        });
        for (x, y) in pixels {
            times[(y * 48 + x) as usize] += 1;
        }
    }
    let world = |i: &u16| {
        let position = floor.0[usize::from(*i)];
        position.map(|v| f64::from(v) * f64::from(reach / 32_000.0))
    };
    let thin = |triangle: &[u16], at: (i32, i32)| {
        let corners: Vec<_> = triangle.iter().filter_map(|i| seen_at(camera, world(i))).collect();
        <[_; 3]>::try_from(corners).is_ok_and(|corners| is_at_a_fold(corners, at))
    };
    for (i, times) in times.into_iter().enumerate().filter(|(_, times)| *times > 1) {
        let at = (i as i32 % 48, i as i32 / 48);
        let is_known = floor.1.chunks_exact(3).any(|triangle| thin(triangle, at));
        assert!(is_known, "{at:?} {times} times: {camera:?}, reach {reach}, {floor:?}");
    }
}

type Floor = (Vec<[i16; 3]>, Vec<u16>);

/// What of a picture a band of some rows shows, all bands one after the other.
fn in_bands(rows: u16, camera: &Camera, mesh: &FloorMesh<'_>) -> (Vec<(i32, i32)>, u32) {
    let (mut pixels, mut written) = (Vec::new(), 0);
    for first in (0..40).step_by(rows.into()) {
        let height = rows.min(40 - first);
        let mut words = vec![0; 48 * usize::from(height)];
        let frame = Frame::<Rgba8888>::new(&mut words, Size::new(48, height));
        let mut frame = frame.and_then(|frame| frame.band(first, 40)).expect("a band that fits");
        let mut stats = Stats::default();
        let mut pass = Pass::new(camera).count(&mut stats);
        pass.draw(&mut frame, &Mat4::identity(), mesh, &Flat::colored());
        written += stats.pixels;
        let set = words.iter().enumerate().filter(|(_, word)| **word != 0);
        pixels.extend(set.map(|(i, _)| (i as i32 % 48, i as i32 / 48 + i32::from(first))));
    }
    (pixels, written)
}

type FloorMesh<'a> = Mesh<'a, Rgb, IndexedList<'a, u16>>;

#[test]
fn floors_through_the_near_plane_and_the_guard_box_have_no_holes_in_any_band() {
    let (mut clipped, mut filled, mut floors, mut folded) = (0, 0, 0, 0);
    let property = "shared edges are drawn once, through any camera and in bands";
    random(property, cases(100_000, 7_000_000), 23, |random| {
        let floor = floor(random);
        let (positions, indices) = (&floor.0, &floor.1);
        let colors = vec![Rgb::WHITE; positions.len()];
        let reach = [20.0, 200.0][random.range(0, 1) as usize];
        let mesh = Mesh::new(positions, &colors)
            .indexed(indices)
            .placed(Vec3::splat(reach / 32_000.0), Vec3::ZERO);
        let camera = above(random);
        let (pixels, stats) = drawn(|frame, stats| {
            Pass::new(&camera).count(stats).draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
        });
        if stats.pixels as usize != pixels.len() {
            assert_folded(&mesh, &floor, reach, &camera);
            folded += 1;
        }
        assert_eq!(stats.skipped, 0, "{camera:?}");
        // A plane that is cut by the near plane and by its own far rim: what is seen of it is
        // convex, so that no row and no column of pixels has a hole.
        for line in 0..48 {
            let row: Vec<i32> = pixels.iter().filter(|p| p.1 == line).map(|p| p.0).collect();
            assert!(row.windows(2).all(|w| w[1] == w[0] + 1), "a hole in row {line}: {camera:?}");
            let column: Vec<i32> = pixels.iter().filter(|p| p.0 == line).map(|p| p.1).collect();
            assert!(
                column.windows(2).all(|w| w[1] == w[0] + 1),
                "a hole in column {line}: {camera:?}"
            );
        }
        let banded = in_bands(random.range(1, 39) as u16, &camera, &mesh);
        assert!(banded == (pixels.clone(), stats.pixels), "in bands: {camera:?}");
        clipped += stats.clipped;
        filled += usize::from(pixels.len() > 400);
        floors += 1;
        stats.triangles.into()
    });
    println!("{folded} of {floors} floors have a triangle that rounding turned about");
    assert!(folded * 2_000 <= floors, "{folded} folds of {floors} floors are too many");
    let is_enough = clipped > floors && filled > floors as usize / 2;
    assert!(is_enough || floors == 0, "{clipped} clipped, {filled} filled of {floors}");
}
