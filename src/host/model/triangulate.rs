//! Faces of any number of corners become triangles.

use super::corner_grid::CornerGrid;
use super::vector::{add, cross, sub, wide, Vector};
use std::prelude::rust_2021::*;

/// Splits polygons into triangles; keeps its buffers from face to face.
///
/// The polygon is projected along the main axis of its normal (Newell's sum, which a corner out of
/// the plane hardly disturbs). If it is convex a fan does, otherwise ears are cut (Meisters 1975).
///
/// A polygon of n corners always gives n - 2 triangles that are joined along whole edges, and each
/// of its own edges is an edge of one: also where corners lie on a straight line, coincide, or the
/// outline crosses itself. So no crack opens, neither inside the face nor towards its neighbours;
/// triangulators that drop such corners do open some.
#[derive(Debug)]
pub(super) struct Triangulator {
    plane: Vec<[f64; 2]>,
    /// The corners that are left: those before and after each.
    before: Vec<usize>,
    after: Vec<usize>,
    /// Corners that may lie in an ear: those that turn right at the beginning, for cutting an ear
    /// only narrows the corners beside it.
    reflex: CornerGrid,
    triangles: Vec<[usize; 3]>,
    /// How many more corners are compared with ears.
    budget: usize,
}

/// Which corners may be cut off; the next is tried when the polygon has none of the one before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Ear {
    /// With area, and empty: the only kind that a simple polygon needs.
    Proper,
    /// Empty, perhaps without area: a corner on a straight line, or one that occurs twice.
    Flat,
    /// Whatever it holds: the outline crosses itself.
    Any,
}

impl Triangulator {
    /// What all faces of a model may cost together, in comparisons: about two seconds.
    const BUDGET: usize = 1 << 28;

    pub(super) fn new() -> Self {
        Self {
            plane: Vec::new(),
            before: Vec::new(),
            after: Vec::new(),
            reflex: CornerGrid::default(),
            triangles: Vec::new(),
            budget: Self::BUDGET,
        }
    }

    /// Whether faces were so intricate that some were not cut properly.
    pub(super) fn is_exhausted(&self) -> bool {
        self.budget == 0
    }

    /// The triangles of the polygon with these corners, as indices into `polygon`.
    pub(super) fn triangles(&mut self, polygon: &[[f32; 3]]) -> &[[usize; 3]] {
        self.triangles.clear();
        if polygon.len() > 3 && self.project(polygon) && !is_convex(&self.plane) {
            self.cut_ears();
        } else {
            let fan = (2..polygon.len()).map(|last| [0, last - 1, last]);
            self.triangles.extend(fan);
        }
        &self.triangles
    }

    /// Projects the polygon so that it is counter-clockwise; false if it has no area.
    fn project(&mut self, polygon: &[[f32; 3]]) -> bool {
        let Some(&first) = polygon.first() else {
            return false;
        };
        // Relative to the first corner: a small polygon far from the origin keeps its digits.
        let relative = |corner: &[f32; 3]| sub(wide(*corner), wide(first));
        let mut normal: Vector = [0.0; 3];
        for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
            normal = add(normal, cross(relative(a), relative(b)));
        }
        let [nx, ny, nz] = normal;
        let largest = nx.abs().max(ny.abs()).max(nz.abs());
        if largest <= 0.0 {
            return false;
        }

        // Dropping an axis keeps the other two exact, and straight edges straight.
        self.plane.clear();
        self.plane.extend(polygon.iter().map(|corner| {
            let [x, y, z] = relative(corner);
            let (component, [a, b]) = if nz.abs() >= largest {
                (nz, [x, y])
            } else if ny.abs() >= largest {
                (ny, [z, x])
            } else {
                (nx, [y, z])
            };
            if component > 0.0 {
                [a, b]
            } else {
                [b, a]
            }
        }));
        true
    }

    /// Cuts the projected polygon by ears.
    fn cut_ears(&mut self) {
        let corners = self.plane.len();
        self.before.clear();
        self.before.extend((0..corners).map(|i| (i + corners - 1) % corners));
        self.after.clear();
        self.after.extend((0..corners).map(|i| (i + 1) % corners));
        let reflex = (0..corners).filter(|&corner| self.turn_at(corner) <= 0.0);
        let reflex = Vec::from_iter(reflex);
        self.reflex.fill(&self.plane, &reflex);

        let (mut left, mut corner, mut failures) = (corners, 0, 0);
        let mut ear = Ear::Proper;
        while left > 3 {
            if self.is_ear(corner, ear) {
                let (before, after) = (self.before_of(corner), self.after_of(corner));
                self.triangles.push([before, corner, after]);
                set(&mut self.after, before, after);
                set(&mut self.before, after, before);
                // Mark as gone.
                set(&mut self.after, corner, corner);
                (left, failures, ear) = (left - 1, 0, Ear::Proper);
                // Step over a neighbour: fans of long thin triangles come of not doing so.
                corner = self.after_of(after);
                continue;
            }
            corner = self.after_of(corner);
            failures += 1;
            if failures > left {
                failures = 0;
                ear = if ear == Ear::Proper { Ear::Flat } else { Ear::Any };
            }
        }
        let (before, after) = (self.before_of(corner), self.after_of(corner));
        self.triangles.push([before, corner, after]);
    }

    fn is_ear(&mut self, corner: usize, ear: Ear) -> bool {
        let turn = self.turn_at(corner);
        let shape = match ear {
            Ear::Proper => turn > 0.0,
            Ear::Flat => turn >= 0.0,
            Ear::Any => true,
        };
        // Out of budget, cut whatever comes.
        if !shape || ear == Ear::Any || self.budget == 0 {
            return shape || self.budget == 0;
        }
        let [a, b, c] = [self.before_of(corner), corner, self.after_of(corner)].map(|i| self.at(i));
        let mut cost = 1;
        let is_empty = self.reflex.around([a, b, c]).all(|row| {
            cost += 1 + row.len();
            !row.iter().any(|&other| {
                let p = self.at(other);
                let is_left = self.after_of(other) != other;
                // A corner in the place of one of the ear's is a seam, no obstacle.
                is_left
                    && ![a, b, c].iter().any(|&corner| is_same(p, corner))
                    && turn_of(a, b, p) >= 0.0
                    && turn_of(b, c, p) >= 0.0
                    && turn_of(c, a, p) >= 0.0
            })
        });
        self.budget = self.budget.saturating_sub(cost);
        is_empty
    }

    fn turn_at(&self, corner: usize) -> f64 {
        let [a, b, c] = [self.before_of(corner), corner, self.after_of(corner)].map(|i| self.at(i));
        turn_of(a, b, c)
    }

    fn at(&self, corner: usize) -> [f64; 2] {
        self.plane.get(corner).copied().unwrap_or_default()
    }

    fn before_of(&self, corner: usize) -> usize {
        self.before.get(corner).copied().unwrap_or_default()
    }

    fn after_of(&self, corner: usize) -> usize {
        self.after.get(corner).copied().unwrap_or_default()
    }
}

fn set(list: &mut [usize], at: usize, value: usize) {
    if let Some(place) = list.get_mut(at) {
        *place = value;
    }
}

/// Whether two corners are in one place, to the bit: coordinates are copied, not computed.
fn is_same([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> bool {
    (ax - bx).abs() <= 0.0 && (ay - by).abs() <= 0.0
}

/// Twice the area of a triangle: positive if counter-clockwise.
fn turn_of([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]) -> f64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Whether the polygon never turns right and goes round once.
fn is_convex(polygon: &[[f64; 2]]) -> bool {
    let next = polygon.iter().cycle();
    let turns_left = polygon
        .iter()
        .zip(next.clone().skip(1))
        .zip(next.skip(2))
        .all(|((&a, &b), &c)| turn_of(a, b, c) >= 0.0);
    turns_left && reversals(polygon, |&[x, _]| x) <= 2 && reversals(polygon, |&[_, y]| y) <= 2
}

/// How often the way along the polygon changes its direction on an axis: twice if convex.
fn reversals(polygon: &[[f64; 2]], coordinate: impl Fn(&[f64; 2]) -> f64) -> usize {
    let mut rising = polygon
        .iter()
        .zip(polygon.iter().cycle().skip(1))
        .map(|(a, b)| coordinate(b) - coordinate(a))
        .filter(|&step| step.abs() > 0.0)
        .map(|step| step > 0.0);
    let Some(first) = rising.next() else { return 0 };
    let (mut last, mut count) = (first, 0);
    for direction in rising {
        count += usize::from(direction != last);
        last = direction;
    }
    count + usize::from(last != first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    fn area(polygon: &[[f32; 3]], triangles: &[[usize; 3]]) -> (f64, f64) {
        let plane = |i: usize| [f64::from(polygon[i][0]), f64::from(polygon[i][1])];
        let turns = triangles.iter().map(|t| {
            let [a, b, c] = t.map(plane);
            turn_of(a, b, c) / 2.0
        });
        turns.fold((0.0, 0.0), |(sum, size), t| (sum + t, size + t.abs()))
    }

    /// n - 2 triangles; each edge of the outline once, each inner edge once in either direction.
    fn assert_joined(corners: usize, triangles: &[[usize; 3]]) {
        assert_eq!(triangles.len(), corners - 2, "{triangles:?}");
        let mut edges = HashMap::new();
        for &[a, b, c] in triangles {
            for edge in [(a, b), (b, c), (c, a)] {
                *edges.entry(edge).or_insert(0) += 1;
            }
        }
        for (&(a, b), &count) in &edges {
            assert_eq!(count, 1, "edge {a} {b} in {triangles:?}");
            let outline = b == (a + 1) % corners;
            assert_eq!(edges.contains_key(&(b, a)), !outline, "edge {a} {b}");
        }
    }

    #[test]
    fn concave_outlines_keep_their_area() {
        let l: &[[f32; 3]] =
            &[[0., 0., 0.], [4., 0., 0.], [4., 1., 0.], [1., 1., 0.], [1., 4., 0.], [0., 4., 0.]];
        // The same with corners on straight edges.
        let l_with_more: &[[f32; 3]] = &[
            [0., 0., 0.],
            [1., 0., 0.],
            [2., 0., 0.],
            [4., 0., 0.],
            [4., 1., 0.],
            [2., 1., 0.],
            [1., 1., 0.],
            [1., 3., 0.],
            [1., 4., 0.],
            [0., 4., 0.],
            [0., 1., 0.],
        ];
        for polygon in [l, l_with_more] {
            for start in 0..polygon.len() {
                let mut turned = polygon.to_vec();
                turned.rotate_left(start);
                let mut triangulator = Triangulator::new();
                let triangles = triangulator.triangles(&turned);
                assert_joined(turned.len(), triangles);
                assert_eq!(area(&turned, triangles), (7.0, 7.0), "no part twice");
                // Clockwise from here: seen from behind, and cut alike.
                turned.reverse();
                let triangles = triangulator.triangles(&turned);
                assert_joined(turned.len(), triangles);
                assert_eq!(area(&turned, triangles), (-7.0, 7.0), "no part twice");
            }
        }
    }

    #[test]
    fn any_outline_gives_joined_triangles() {
        let mut state = 1_u32;
        let mut random = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as f32 / 16.0
        };
        let mut triangulator = Triangulator::new();
        for corners in (3..40).cycle().take(2000) {
            let polygon: Vec<[f32; 3]> = (0..corners)
                .map(|_| [random().floor(), random().floor(), random().floor()])
                .collect();
            assert_joined(corners, triangulator.triangles(&polygon));
        }
    }

    #[test]
    fn long_stars_keep_their_area() {
        let mut state = 1_u32;
        let mut random = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 16) as f32 / 65536.0
        };
        let mut triangulator = Triangulator::new();
        for corners in [5, 30, 300, 5000] {
            let polygon: Vec<[f32; 3]> = (0..corners)
                .map(|i| {
                    let angle = i as f32 / corners as f32 * core::f32::consts::TAU;
                    let radius = 1.0 + 9.0 * random();
                    [radius * angle.cos(), radius * angle.sin(), 0.0]
                })
                .collect();
            let triangles = triangulator.triangles(&polygon);
            assert_joined(corners, triangles);
            let (sum, size) = area(&polygon, triangles);
            assert!((sum - size).abs() < 1e-9, "{corners}: no part twice");
        }
        assert!(!triangulator.is_exhausted(), "no face here is too intricate");
    }
}
