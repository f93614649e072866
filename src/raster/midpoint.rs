use super::{Path, ScreenVertex, Steps};

/// A line between the centres of two pixels by the midpoint algorithm: without a division, and
/// without a look at diamonds.
///
/// There is one pixel a column (a row, where the line is higher than wide), from the first pixel to
/// the one before the last: the nearest to the line, and of two that are as near the one farther
/// down (to the right).
///
/// Source: J. Bresenham, *Algorithm for computer control of a digital plotter*, IBM Systems
/// Journal 4 (1965).
#[derive(Clone, Copy, Debug)]
pub(crate) struct MidpointPath {
    by_columns: bool,
    from: i32,
    to: i32,
    /// The column and the row where the line is exactly in the middle.
    at: i32,
    minor: i32,
    /// Pixels across on a way of `length` pixels along.
    across: i32,
    length: i32,
}

impl MidpointPath {
    /// The line from the pixel that holds one corner to the one that holds the other; `None` if
    /// they are the same.
    pub(crate) fn between(first: &ScreenVertex, last: &ScreenVertex) -> Option<Self> {
        let (x, y) = (first.x_bits() >> 4, first.y_bits() >> 4);
        let width = (last.x_bits() >> 4).wrapping_sub(x);
        let height = (last.y_bits() >> 4).wrapping_sub(y);
        let by_columns = width.unsigned_abs() >= height.unsigned_abs();
        let (at, minor, along, across) =
            if by_columns { (x, y, width, height) } else { (y, x, height, width) };
        let length = along.wrapping_abs();
        // From whichever end comes first: the line is exactly in the middle of both.
        Some(match along {
            0 => return None,
            1.. => {
                let to = at.wrapping_add(length);
                Self { by_columns, from: at, to, at, minor, across, length }
            }
            _ => {
                let (end, to) = (at.wrapping_add(along), at.wrapping_add(1));
                let minor = minor.wrapping_add(across);
                let (from, across) = (end.wrapping_add(1), across.wrapping_neg());
                Self { by_columns, from, to, at: end, minor, across, length }
            }
        })
    }

    /// Twice the way across to a column, raised by a half, as whole rows and a rest below twice the
    /// length.
    fn parts(&self, at: i32) -> (i32, i32) {
        // Below 2^13 x 2^13 x 2, as lines are in the square of corners.
        let way = at.wrapping_sub(self.at).wrapping_mul(self.across).wrapping_mul(2);
        let (whole, twice) = (way.wrapping_add(self.length), self.length.wrapping_mul(2).max(1));
        let rows = if whole < 0 {
            whole.wrapping_add(1).wrapping_div(twice).wrapping_sub(1)
        } else if whole < twice {
            // As where a line begins, if it is flat: no division.
            0
        } else {
            whole.wrapping_div(twice)
        };
        (rows, whole.wrapping_sub(rows.wrapping_mul(twice)))
    }
}

impl Path for MidpointPath {
    type Steps = MidpointSteps;

    #[inline(always)]
    fn by_columns(&self) -> bool {
        self.by_columns
    }

    #[inline(always)]
    fn ends(&self) -> (i32, i32) {
        (self.from, self.to)
    }

    #[inline(always)]
    fn minor(&self, at: i32) -> i32 {
        self.minor.wrapping_add(self.parts(at).0)
    }

    #[inline(always)]
    fn steps(&self, at: i32) -> MidpointSteps {
        let twice = self.length.wrapping_mul(2);
        let (_, rest) = self.parts(at);
        // What a step adds beside the least one: -1 where the line rises, else 0.
        let up = self.across.wrapping_mul(2);
        let up = if up < 0 { up.wrapping_add(twice) } else { up };
        MidpointSteps { error: rest.wrapping_sub(twice), up, twice, number: 0, least: 0 }
    }

    #[inline(always)]
    fn least_step(&self) -> (i32, i32) {
        (self.across >> 31, 1)
    }

    #[inline(always)]
    fn good_until(&self, _at: i32) -> i32 {
        i32::MAX
    }
}

/// Steps across a line, by an error that is kept below zero.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MidpointSteps {
    error: i32,
    up: i32,
    twice: i32,
    number: u32,
    least: u32,
}

impl Steps for MidpointSteps {
    #[inline(always)]
    fn begin(&mut self, number: u32, least: u32) {
        (self.number, self.least) = (number, least);
    }

    #[inline(always)]
    fn number(&self) -> u32 {
        self.number
    }

    #[inline(always)]
    fn step(&mut self) {
        let carries = self.carries();
        self.number = self.number.wrapping_add(self.least).wrapping_add(carries.into());
    }

    #[inline(always)]
    fn carries(&mut self) -> bool {
        self.error = self.error.wrapping_add(self.up);
        let carries = self.error >= 0;
        if carries {
            self.error = self.error.wrapping_sub(self.twice);
        }
        carries
    }
}
