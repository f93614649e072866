//! Tests of the teapot against the patches, evaluated in f64 by other formulas, and as a surface.

extern crate std;
use super::newell::{PATCHES, POINTS, UNITS};
use super::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_OFFSET, TEAPOT_POSITIONS, TEAPOT_SCALE};
use core::array::from_fn;
use std::collections::{HashMap, HashSet};
use std::vec::Vec;

type Point = [f64; 3];

fn combine(a: Point, b: Point, t: f64) -> Point {
    from_fn(|i| a[i] + (b[i] - a[i]) * t)
}

fn minus(a: Point, b: Point) -> Point {
    from_fn(|i| a[i] - b[i])
}

fn dot(a: Point, b: Point) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: Point, b: Point) -> Point {
    from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
}

fn unit(a: Point) -> Point {
    a.map(|x| x / dot(a, a).sqrt())
}

/// de Casteljau's algorithm: repeated linear interpolation.
fn curve([a, b, c, d]: [Point; 4], t: f64) -> Point {
    let (ab, bc, cd) = (combine(a, b, t), combine(b, c, t), combine(c, d, t));
    combine(combine(ab, bc, t), combine(bc, cd, t), t)
}

fn surface(patch: &[u16; 16], u: f64, v: f64) -> Point {
    let point = |i: u16| {
        let [x, y, z] = POINTS[usize::from(i) - 1].map(|c| f64::from(c) / UNITS as f64);
        [x, z, -y]
    };
    curve(from_fn(|row| curve(from_fn(|column| point(patch[4 * row + column])), v)), u)
}

/// The vertex positions in model space.
fn positions() -> Vec<Point> {
    let offset = TEAPOT_OFFSET.to_array().map(f64::from);
    let place = |p: &[i16; 3]| from_fn(|i| offset[i] + f64::from(TEAPOT_SCALE) * f64::from(p[i]));
    TEAPOT_POSITIONS.iter().map(place).collect()
}

fn triangles() -> impl Iterator<Item = [usize; 3]> {
    TEAPOT_INDICES.chunks_exact(3).map(|t| from_fn(|i| usize::from(t[i])))
}

#[test]
fn has_992_triangles_over_530_vertices_all_used() {
    assert_eq!(TEAPOT_INDICES.len(), 3 * 992);
    assert_eq!(TEAPOT_POSITIONS.len(), 530);
    assert_eq!(triangles().flatten().collect::<HashSet<_>>().len(), 530);
    // A single place belongs to two surfaces: where the tip of the handle touches the body.
    assert_eq!(TEAPOT_POSITIONS.iter().collect::<HashSet<_>>().len(), 529);
}

#[test]
fn control_points_have_the_published_box() {
    for (axis, bounds) in
        [[-300_000, 352_500], [-200_000, 200_000], [0, 315_000]].iter().enumerate()
    {
        let values = || POINTS.iter().map(|p| p[axis]);
        assert_eq!([values().min(), values().max()], bounds.map(Some));
    }
}

#[test]
fn box_of_the_mesh_is_centred() {
    let expected = [[-3.0, 3.428_125], [0.0, 3.15], [-2.0, 2.0]];
    let positions = positions();
    for (axis, [low, high]) in expected.into_iter().enumerate() {
        let values = || positions.iter().map(|p| p[axis]);
        assert!((values().fold(f64::MAX, f64::min) - low).abs() < f64::from(TEAPOT_SCALE));
        assert!((values().fold(f64::MIN, f64::max) - high).abs() < f64::from(TEAPOT_SCALE));
        let stored = || TEAPOT_POSITIONS.iter().map(|p| p[axis]);
        assert_eq!(stored().max(), stored().min().map(|x| -x));
    }
    assert_eq!(TEAPOT_POSITIONS.iter().map(|p| p[0]).max(), Some(i16::MAX));
}

#[test]
fn every_vertex_lies_on_its_patch_with_the_patch_normal() {
    let positions = positions();
    let step = f64::from(TEAPOT_SCALE);
    let (mut worst_position, mut worst_cosine) = (0.0, 1.0);
    let mut seen = HashSet::new();
    for patch in &PATCHES {
        for node in 0..25u8 {
            let (u, v) = (f64::from(node / 5) / 4.0, f64::from(node % 5) / 4.0);
            let point = surface(patch, u, v);
            // Differences across a small cell inside: also where a patch edge is a single point.
            let inside = |t: f64| t.clamp(1e-4, 1.0 - 1e-4);
            let (u, v, d) = (inside(u), inside(v), 1e-5);
            let du = minus(surface(patch, u + d, v), surface(patch, u - d, v));
            let dv = minus(surface(patch, u, v + d), surface(patch, u, v - d));
            let normal = unit(cross(dv, du));

            let distance =
                |i: usize| minus(positions[i], point).into_iter().map(f64::abs).fold(0.0, f64::max);
            let cosine = |i: usize| dot(unit(TEAPOT_NORMALS[i].map(f64::from)), normal);
            let here = (0..positions.len()).filter(|&i| distance(i) < 2.0 * step);
            let best = here.max_by(|&a, &b| cosine(a).total_cmp(&cosine(b))).unwrap();
            seen.insert(best);
            worst_position = f64::max(worst_position, distance(best) / step);
            worst_cosine = f64::min(worst_cosine, cosine(best));
        }
    }
    let degrees = worst_cosine.acos().to_degrees();
    std::println!("teapot: {worst_position} steps, {degrees} degrees");
    assert_eq!(seen.len(), positions.len());
    assert!(worst_position < 0.51, "{worst_position}");
    assert!(degrees < 0.4, "{degrees}");
}

#[test]
fn normals_are_127_long() {
    for normal in &TEAPOT_NORMALS {
        let length = dot(normal.map(f64::from), normal.map(f64::from)).sqrt();
        assert!((length - 127.0).abs() < 0.9, "{normal:?}");
    }
}

#[test]
fn left_and_right_are_mirror_images() {
    let vertices: HashSet<_> = TEAPOT_POSITIONS.iter().zip(&TEAPOT_NORMALS).collect();
    for (&[x, y, z], &[a, b, c]) in TEAPOT_POSITIONS.iter().zip(&TEAPOT_NORMALS) {
        assert!(vertices.contains(&(&[x, y, -z], &[a, b, -c])), "{x} {y} {z}");
    }
}

#[test]
fn no_triangle_is_degenerate_and_faces_agree_with_their_normals() {
    let positions = positions();
    let mut exceptions = 0;
    for corners in triangles() {
        let [a, b, c] = corners.map(|i| positions[i]);
        let face = cross(minus(b, a), minus(c, a));
        assert!(dot(face, face) > 0.0, "{corners:?}");

        let cosine = |i: usize| dot(unit(face), unit(TEAPOT_NORMALS[i].map(f64::from)));
        if corners.into_iter().map(cosine).fold(1.0, f64::min) < 0.25 {
            // The lip of the spout curls over within one cell: no triangle can follow it.
            assert!(a[0] > 3.3 && b[0] > 3.3 && c[0] > 3.3, "{corners:?}");
            exceptions += 1;
        }
    }
    assert_eq!(exceptions, 4);
}

#[test]
fn neighbours_agree_on_the_side_and_holes_are_where_newell_left_them() {
    // Each directed edge belongs to one triangle, and its neighbour runs it backwards.
    let mut edges = HashMap::new();
    for [a, b, c] in triangles() {
        for edge in [(a, b), (b, c), (c, a)] {
            assert_eq!(edges.insert(edge, ()), None, "{edge:?}");
        }
    }
    let open = edges.keys().filter(|&&(a, b)| !edges.contains_key(&(b, a)));
    let from: HashMap<_, _> = open.map(|&(a, b)| (a, b)).collect();
    // Rim of the body, rim of the lid, two ends of the handle, two of the spout.
    let mut rest: HashSet<_> = from.keys().copied().collect();
    let mut loops = Vec::new();
    while let Some(&start) = rest.iter().min() {
        let (mut vertex, mut length) = (start, 0);
        while rest.remove(&vertex) {
            length += 1;
            vertex = from[&vertex];
        }
        assert_eq!(vertex, start);
        loops.push(length);
    }
    loops.sort_unstable();
    assert_eq!(loops, [8, 8, 8, 8, 16, 16]);
}

#[test]
fn body_and_lid_face_away_from_the_axis() {
    let positions = positions();
    let mut volume = 0.0;
    let (mut outward, mut all) = (0, 0);
    for corners in triangles() {
        let [a, b, c] = corners.map(|i| positions[i]);
        let face = cross(minus(b, a), minus(c, a));
        let middle: Point = from_fn(|i| (a[i] + b[i] + c[i]) / 3.0);
        volume += dot(a, cross(b, c)) / 6.0;
        all += 1;
        outward += i32::from(dot(face, minus(middle, [0.0, 1.2, 0.0])) > 0.0);
    }
    std::println!("teapot: volume {volume}, outward {outward} of {all}");
    assert!(volume > 0.0);
    assert!(10 * outward > 7 * all, "{outward} of {all}");
}
