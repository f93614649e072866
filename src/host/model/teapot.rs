//! The bundled model: Newell's teapot, tessellated.

use super::builder::{Builder, RawCorner};
use super::vector::{add, cross, unit, Vector};
use super::{Material, Model};
use crate::models::newell::{PATCHES, POINTS, UNITS};
use std::prelude::rust_2021::*;

impl Model {
    /// Newell's teapot, each of its 32 patches cut into `divisions` x `divisions` cells of two
    /// triangles; y is up, the spout points along x, normals are those of the surface.
    ///
    /// # Range
    ///
    /// `divisions` is brought into 1..=64. There are 64 n² triangles less 8 n without area, at the
    /// knob and under the bottom, where an edge of a patch is one point.
    ///
    /// ```
    /// use microraster::host::Model;
    ///
    /// assert_eq!(Model::teapot(10).triangle_count(), 6320);
    /// ```
    #[must_use]
    pub fn teapot(divisions: u8) -> Self {
        let divisions = divisions.clamp(1, 64);
        let mut builder = Builder::default();
        let group = builder.group(Material::named("teapot"));
        for patch in &PATCHES {
            let steps = || (0..=divisions).map(|i| f64::from(i) / f64::from(divisions));
            let mut grid = Vec::new();
            for v in steps() {
                grid.extend(steps().map(|u| corner(&mut builder, patch, u, v)));
            }

            // Two triangles a cell, counter-clockwise as seen from outside.
            let side = usize::from(divisions) + 1;
            for row in 0..side - 1 {
                for column in 0..side - 1 {
                    let at = |row: usize, column: usize| grid.get(row * side + column).copied();
                    let cell = [
                        at(row, column),
                        at(row, column + 1),
                        at(row + 1, column + 1),
                        at(row + 1, column),
                    ];
                    let [Some(a), Some(b), Some(c), Some(d)] = cell else {
                        continue;
                    };
                    for triangle in [[a, b, c], [a, c, d]] {
                        let [p, q, r] = triangle.map(|corner| corner.position);
                        if p != q && q != r && r != p {
                            builder.triangle(group, triangle);
                        }
                    }
                }
            }
        }
        builder.finish()
    }
}

/// The corner at (`u`, `v`) of a patch, both within 0..=1.
fn corner(builder: &mut Builder, patch: &[u16; 16], u: f64, v: f64) -> RawCorner {
    let position = point(patch, u, v);
    // Where an edge is one point its derivative vanishes: take it a little further inside.
    let inside = |t: f64| t.clamp(1e-4, 1.0 - 1e-4);
    let (s, t) = (inside(u), inside(v));
    let normal = cross(sum(patch, slope(s), bernstein(t)), sum(patch, bernstein(s), slope(t)));
    RawCorner {
        position: builder.position(narrow(position)),
        normal: unit(normal).and_then(|normal| builder.normal(normal)),
        texture: None,
    }
}

fn point(patch: &[u16; 16], u: f64, v: f64) -> Vector {
    sum(patch, bernstein(u), bernstein(v))
}

/// The control points, each times its two weights.
fn sum(patch: &[u16; 16], u: [f64; 4], v: [f64; 4]) -> Vector {
    let weights = v.into_iter().flat_map(|v| u.map(|u| u * v));
    patch.iter().zip(weights).fold([0.0; 3], |sum, (&number, weight)| {
        let place = usize::from(number).saturating_sub(1);
        let [x, y, z] = POINTS.get(place).copied().unwrap_or_default();
        // From z up to y up.
        let point = [x, z, -y].map(|c| f64::from(c) / UNITS as f64 * weight);
        add(sum, point)
    })
}

/// The cubic Bernstein polynomials.
fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t]
}

/// Their derivatives.
fn slope(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t]
}

/// Seams between patches are computed twice, from either side: in `f64`, and rounded to a grid far
/// coarser than its errors, both give the same bits.
fn narrow(point: Vector) -> [f32; 3] {
    const GRID: f64 = 65536.0;
    #[allow(
        clippy::cast_possible_truncation,
        reason = "the grid is coarser than f32 in this range"
    )]
    point.map(|component| ((component * GRID).round() / GRID) as f32)
}

#[cfg(test)]
mod tests {
    use super::super::vector::wide;
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn triangles_are_those_that_the_patches_promise() {
        for n in [1, 4, 6, 10] {
            let triangles = Model::teapot(n).triangle_count();
            let n = usize::from(n);
            assert_eq!(triangles, 64 * n * n - 8 * n, "{n} divisions");
        }
    }

    #[test]
    fn normals_and_faces_look_the_same_way() {
        let model = Model::teapot(10);
        for triangle in model.groups.iter().flat_map(|group| &group.triangles) {
            let [x, y, z] = model.face_normal(triangle).expect("an area");
            for corner in triangle {
                let [a, b, c] = model.normals[corner.normal as usize];
                assert!(x * a + y * b + z * c > 0.0, "{triangle:?}");
            }
        }
    }

    #[test]
    fn faces_look_outwards() {
        // Six times the volume, by tetrahedra from the origin: of an inside-out teapot negative.
        let model = Model::teapot(10);
        let triangles = model.groups.iter().flat_map(|group| &group.triangles);
        let volume: f64 = triangles
            .map(|triangle| {
                let [a, b, c] = triangle.map(|corner| model.positions[corner.position as usize]);
                let [x, y, z] = cross(wide(a), wide(b));
                x * f64::from(c[0]) + y * f64::from(c[1]) + z * f64::from(c[2])
            })
            .sum();
        assert!(volume > 6.0 * 8.0, "{volume}");
    }

    #[test]
    fn seams_between_patches_are_closed() {
        let model = Model::teapot(7);
        let mut edges = HashMap::new();
        for &[a, b, c] in model.groups.iter().flat_map(|group| &group.triangles) {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges.entry((from.position, to.position)).or_insert(0) += 1;
            }
        }
        // Open are only the rims: the lid's, the body's, and the ends of spout and handle, each a
        // ring of four patches or a half ring of two.
        let open = edges.keys().filter(|&&(from, to)| !edges.contains_key(&(to, from))).count();
        assert_eq!(open % 7, 0, "{open} open edges");
        assert!(open <= 7 * 16, "{open} open edges");
    }
}
