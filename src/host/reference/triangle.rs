//! Which pixels a triangle covers, and where in it they lie.

use super::corner::Corner;
use super::snap::{Place, PIXEL};

/// Twice the signed area of a triangle of places: positive where it runs clockwise on the screen.
pub(super) fn area([ax, ay]: Place, [bx, by]: Place, [px, py]: Place) -> i128 {
    (bx - ax) * (py - ay) - (by - ay) * (px - ax)
}

/// A triangle on the screen.
#[derive(Clone, Copy, Debug)]
pub(super) struct Triangle<'a> {
    /// In either order.
    pub(super) corners: [&'a Corner; 3],
}

impl Triangle<'_> {
    fn places(&self) -> [Place; 3] {
        self.corners.map(|corner| corner.place)
    }

    /// Twice the signed area.
    pub(super) fn area(&self) -> i128 {
        let [a, b, c] = self.places();
        area(a, b, c)
    }

    /// Whether a place lies inside, or on a left or an upper edge.
    pub(super) fn covers(&self, place: Place) -> bool {
        let [a, b, c] = self.places();
        let clockwise = match area(a, b, c) {
            0 => return false,
            1.. => [a, b, c],
            _ => [a, c, b],
        };
        [0, 1, 2].into_iter().all(|i| {
            let (from, to) = (clockwise[i], clockwise[(i + 1) % 3]);
            let is_top = from[1] == to[1] && to[0] > from[0];
            let is_left = to[1] < from[1];
            match area(from, to, place) {
                0 => is_top || is_left,
                side => side > 0,
            }
        })
    }

    /// How much of each corner is in a place: the weights have the sum 1.
    pub(super) fn weights(&self, place: Place) -> [f64; 3] {
        let [a, b, c] = self.places();
        let whole = self.area() as f64;
        [area(b, c, place), area(c, a, place), area(a, b, place)].map(|part| part as f64 / whole)
    }

    /// How the weights change by a pixel to the right, and by a pixel down.
    pub(super) fn slopes(&self) -> [[f64; 3]; 2] {
        let [a, b, c] = self.places();
        let whole = self.area() as f64;
        let change = |axis: usize, [from, to]: [Place; 2]| {
            let way = if axis == 0 { from[1] - to[1] } else { to[0] - from[0] };
            (way * PIXEL) as f64 / whole
        };
        [0, 1].map(|axis| [[b, c], [c, a], [a, b]].map(|edge| change(axis, edge)))
    }
}
