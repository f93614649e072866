//! From vertices to corners on the screen.

use std::vec::Vec;

use super::snap::{Place, Snap};
use super::{Space, Vertex};

/// A corner on the screen.
#[derive(Clone, Debug)]
pub(super) struct Corner {
    pub(super) place: Place,
    /// The depth code.
    pub(super) code: f64,
    pub(super) w: f64,
    pub(super) varyings: Vec<f64>,
}

/// Part `t` of the way.
fn between(a: &Vertex, b: &Vertex, t: f64) -> Vertex {
    let mix = |a: f64, b: f64| a + (b - a) * t;
    Vertex {
        position: [0, 1, 2, 3].map(|i| mix(a.position[i], b.position[i])),
        varyings: a.varyings.iter().zip(&b.varyings).map(|(a, b)| mix(*a, *b)).collect(),
    }
}

/// Cuts off what lies beyond a plane: of a polygon, or of a line, of which the second corner does
/// not lead back to the first.
///
/// An edge is always cut from its inner end, so that triangles which share it get the same point.
fn cut(polygon: &[Vertex], distance: impl Fn(&[f64; 4]) -> f64) -> Vec<Vertex> {
    let mut kept = Vec::new();
    for (i, here) in polygon.iter().enumerate() {
        let at = distance(&here.position);
        if at >= 0.0 {
            kept.push(here.clone());
        }
        let is_last = i + 1 == polygon.len();
        if is_last && polygon.len() < 3 {
            break;
        }
        let next = &polygon[(i + 1) % polygon.len()];
        let beyond = distance(&next.position);
        if (at >= 0.0) != (beyond >= 0.0) {
            kept.push(if at >= 0.0 {
                between(here, next, at / (at - beyond))
            } else {
                between(next, here, beyond / (beyond - at))
            });
        }
    }
    kept
}

impl Space {
    /// What is left of a primitive between the near and the far plane, on the screen.
    pub(super) fn corners(self, primitive: &[Vertex], snap: Snap) -> Vec<Corner> {
        match self {
            Self::Window => primitive.iter().map(|vertex| in_window(vertex, snap)).collect(),
            Self::Clip { far, .. } => {
                let mut polygon = cut(primitive, |[_, _, z, w]| w - z);
                if far {
                    polygon = cut(&polygon, |[_, _, z, _]| *z);
                }
                // What lies in the plane of the eye has no place.
                let largest = polygon.iter().fold(0.0_f64, |w, v| w.max(v.position[3].abs()));
                let least = largest * 1e-9;
                polygon = cut(&polygon, |[_, _, _, w]| w - least);
                polygon.iter().map(|vertex| self.project(vertex, snap)).collect()
            }
        }
    }

    fn project(self, vertex: &Vertex, snap: Snap) -> Corner {
        let Self::Clip { viewport, .. } = self else { return in_window(vertex, snap) };
        let [x, y, z, w] = vertex.position;
        let middle =
            |from: i32, to: i32| Snap::Exact.round(f64::from(from) / 2.0 + f64::from(to) / 2.0);
        let half = |pixels: u32| f64::from(pixels) / 2.0;
        // Rounded from the viewport's middle, and up while y still points there.
        let right = snap.round(x / w * half(viewport.width()));
        let up = snap.round(y / w * half(viewport.height()));
        Corner {
            place: [
                middle(viewport.left, viewport.right) + right,
                middle(viewport.top, viewport.bottom) - up,
            ],
            code: 2.0 + 65_531.0 * z / w,
            w,
            varyings: vertex.varyings.clone(),
        }
    }
}

fn in_window(vertex: &Vertex, snap: Snap) -> Corner {
    let [x, y, code, w] = vertex.position;
    Corner { place: [snap.round(x), snap.round(y)], code, w, varyings: vertex.varyings.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::Rect;
    use std::vec;

    #[test]
    fn triangles_that_share_an_edge_are_cut_at_the_same_places() {
        let space = Space::Clip { viewport: Rect::new(0, 0, 320, 240), far: true };
        let mut seed = 1_u64;
        let mut number = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 40) as f64 / f64::from(1 << 24) * 2.0 - 1.0
        };
        let mut cut = 0;
        for _ in 0..2_000 {
            let mut vertex = || {
                let position = [number(), number(), number(), number()].map(|v| v * 3.0);
                Vertex { position, varyings: vec![number()] }
            };
            let [a, b, c, d] = [vertex(), vertex(), vertex(), vertex()];
            let left = space.corners(&[a.clone(), b.clone(), c], Snap::Exact);
            let right = space.corners(&[b.clone(), a.clone(), d], Snap::Exact);
            for corner in space.corners(&[a, b], Snap::Exact) {
                let has = |corners: &[Corner]| corners.iter().any(|c| c.place == corner.place);
                assert!(has(&left) && has(&right), "{corner:?}: {left:?} {right:?}");
                cut += 1;
            }
        }
        assert!(cut > 500, "hardly tested: {cut}");
    }
}
