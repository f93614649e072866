use super::Divisor;

/// A pixel, in picture coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Pixel {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

/// One pixel in each of some columns (or rows) that follow each other: a line.
pub(crate) trait Path {
    /// The walk along it.
    type Steps: Steps + Copy;

    /// Whether there is one pixel a column, else one a row.
    fn by_columns(&self) -> bool;

    /// The first column (or row), and the one behind the last.
    fn ends(&self) -> (i32, i32);

    /// The row (or column) of the pixel in a column (or row): it only rises or only falls.
    fn minor(&self, at: i32) -> i32;

    /// The walk from a column (or row) on.
    fn steps(&self, at: i32) -> Self::Steps;

    /// How many rows (or columns) further the next pixel lies, and how many more when a step
    /// carries.
    fn least_step(&self) -> (i32, i32);

    /// What divides by the longer side, in subpixels.
    #[inline(always)]
    fn divisor(&self, side: u32) -> Divisor {
        Divisor::new(side)
    }

    /// How far a walk that begins at `at` is exact: the column (or row) behind.
    fn good_until(&self, at: i32) -> i32;
}

/// A walk along a [`Path`]: a number that grows by as much with each step, and by one more when the
/// step carries.
pub(crate) trait Steps {
    /// The number at first, and what every step adds.
    fn begin(&mut self, number: u32, least: u32);

    /// The number.
    fn number(&self) -> u32;

    /// Goes to the next column (or row).
    fn step(&mut self);

    /// The same, for a walk that does not ask for the number: whether the step carries.
    fn carries(&mut self) -> bool;
}

/// The part of a path's columns in `from..to` whose rows lie in `low..high`.
#[inline(never)]
pub(crate) fn limited<P: Path>(path: &P, from: i32, to: i32, low: i32, high: i32) -> (i32, i32) {
    if from >= to {
        return (from, from);
    }
    let (first, last) = (path.minor(from), path.minor(to.wrapping_sub(1)));
    if first.min(last) >= low && first.max(last) < high {
        return (from, to);
    }
    let rises = first <= last;
    // The first column that is no longer before the range, and the first that is behind it.
    let start = first_where(path, from, to, |row| if rises { row >= low } else { row < high });
    let end = first_where(path, start, to, |row| if rises { row >= high } else { row < low });
    (start, end)
}

/// The first column in `from..to` of which something holds that holds of all that follow.
fn first_where<P: Path>(path: &P, from: i32, to: i32, holds: impl Fn(i32) -> bool) -> i32 {
    let (mut low, mut high) = (from, to);
    while low < high {
        let middle = low.wrapping_add(high.wrapping_sub(low) >> 1);
        if holds(path.minor(middle)) {
            high = middle;
        } else {
            low = middle.wrapping_add(1);
        }
    }
    low
}
