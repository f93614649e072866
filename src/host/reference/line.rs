//! Which pixels a line covers: the diamond-exit rule as it is written.

use super::snap::{Place, PIXEL};

/// A number and what it has of e and of e^2, where e is smaller than any number: compared in this
/// order.
type Nearly = [i128; 3];

/// The four sides of a diamond about `center`: a point moved by (-e, -e^2) is inside where each is
/// below half a pixel.
fn sides([x, y]: Place, center: Place) -> [Nearly; 4] {
    let (x, y) = (x - center[0], y - center[1]);
    [[x + y, -1, -1], [x - y, -1, 1], [y - x, 1, -1], [-x - y, 1, 1]]
}

/// Whether the line from `a` to `b` intersects the open diamond about a pixel's centre, and `b` does
/// not lie in it (OpenGL 4.6, section 14.5.1).
fn leaves_diamond(a: Place, b: Place, center: Place) -> bool {
    const HALF: i128 = PIXEL / 2;
    let (from, to) = (sides(a, center), sides(b, center));
    if to.iter().all(|side| *side < [HALF, 0, 0]) {
        return false;
    }
    // Each side is inside for the t of an open half line: t slope < room. Bounds of t are fractions
    // with a denominator above zero; 0 <= t <= 1 belong to the line.
    let times = |number: Nearly, factor: i128| number.map(|part| part * factor);
    let (mut low, mut low_is_in) = (([0, 0, 0], 1), true);
    let (mut high, mut high_is_in) = (([1, 0, 0], 1), true);
    for (from, to) in from.into_iter().zip(to) {
        let slope = to[0] - from[0];
        let room = [HALF - from[0], -from[1], -from[2]];
        let (rising, falling) = (slope > 0, slope < 0);
        if slope == 0 && room <= [0, 0, 0] {
            return false;
        }
        if rising && times(room, high.1) <= times(high.0, slope) {
            (high, high_is_in) = ((room, slope), false);
        }
        if falling && times(room, -low.1) >= times(low.0, -slope) {
            (low, low_is_in) = ((room.map(|part| -part), -slope), false);
        }
    }
    let (low, high) = (times(low.0, high.1), times(high.0, low.1));
    low < high || (low == high && low_is_in && high_is_in)
}

/// A line on the screen, a pixel wide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line {
    pub(super) from: Place,
    pub(super) to: Place,
    /// Where pixels are looked at, from their upper left corners.
    pub(super) look: Place,
}

impl Line {
    /// The axis of the longer side: 0 for columns.
    pub(super) fn axis(&self) -> usize {
        let [across, down] = [0, 1].map(|axis| (self.to[axis] - self.from[axis]).abs());
        usize::from(across < down)
    }

    /// The same line so far away along an axis.
    pub(super) fn moved(mut self, axis: usize, by: i128) -> Self {
        self.from[axis] += by;
        self.to[axis] += by;
        self
    }

    /// The last column or row whose middle does not lie behind a coordinate.
    fn pixel(&self, axis: usize, at: i128) -> i128 {
        (at - self.look[axis]).div_euclid(PIXEL)
    }

    /// The covered pixel in column `along` (a row, where the line is higher than wide): its row.
    pub(super) fn across(&self, along: i128) -> Option<i128> {
        let axis = self.axis();
        let other = 1 - axis;
        let length = self.to[axis] - self.from[axis];
        if length == 0 {
            return None;
        }
        let center = along * PIXEL + self.look[axis];
        let way = (center - self.from[axis]) * (self.to[other] - self.from[other]);
        let near = self.pixel(other, self.from[other] + way.div_euclid(length));
        (near - 2..=near + 2).find(|across| {
            let mut place = [center; 2];
            place[other] = across * PIXEL + self.look[other];
            leaves_diamond(self.from, self.to, place)
        })
    }

    /// The first and the last covered column (or row), in the line's direction.
    pub(super) fn ends(&self) -> Option<[i128; 2]> {
        let axis = self.axis();
        let [from, to] = [self.from, self.to].map(|end| self.pixel(axis, end[axis]));
        let step = if from <= to { 1 } else { -1 };
        let is_covered = |at: &i128| self.across(*at).is_some();
        // An end lies in this column or the next, and its own may be left out.
        let first = (-2..=2).map(|i| from + i * step).find(is_covered)?;
        let last = (-2..=2).map(|i| to - i * step).find(is_covered)?;
        Some([first, last])
    }
}
