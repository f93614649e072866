use super::{Edge, LongEdge, SpanBatch};

/// An edge of a triangle of medium size, walked by one addition of 32 bits a row, a batch of rows
/// at a time: exact all the same.
///
/// At the centre of a row the edge is crossed at a multiple of 1 / (16 dy) of a pixel, which is 17
/// units of 2^-21 or more while the triangle is at most 480 pixels high. So the column, which is
/// ceil(crossing - 1/2), is floor(crossing + 1/2 - e) for any e above zero and up to 17 units. What is
/// lost is such an e, for all of it is cut off downwards: less than a unit in the [`LongEdge`] that a
/// batch begins with, less than another where its lower bits are left out, and less than one more in
/// each of up to 15 steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct MediumEdge {
    /// Columns with 21 fraction bits.
    x: i32,
    step: i32,
}

/// Fraction bits of a column.
const FRACTION: u32 = 21;
/// Tallest triangle, in subpixels: 480 pixels.
pub(super) const TALLEST: i32 = 480 * 16;
/// How far corners may lie to either side of column 0, in subpixels: 1023 pixels.
pub(super) const FARTHEST: i32 = 1023 * 16;
/// Fraction bits that a [`LongEdge`] has besides.
const LOW: u32 = LongEdge::FRACTION - FRACTION;

const _: () = assert!(
    16 * TALLEST as usize * (1 + SpanBatch::CAPACITY) <= 1 << FRACTION,
    "what a batch loses is no more than the distance of crossings"
);
const _: () = assert!(LongEdge::SHORT_BY <= 1 << LOW, "less than a unit");
const _: () = assert!(FARTHEST / 16 < 1 << (31 - FRACTION), "columns fit");

impl LongEdge {
    /// The same with its highest bits, which are those of the sign, left out: the upper word is the
    /// medium edge.
    #[inline(always)]
    pub(super) const fn scaled(&self) -> Self {
        Self { x: self.x << (32 - LOW), step: self.step << (32 - LOW) }
    }
}

impl MediumEdge {
    /// A [scaled](LongEdge::scaled) edge in the rows that follow, as many as a batch holds.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the upper word")]
    pub(super) const fn of(edge: &LongEdge) -> Self {
        Self { x: (edge.x >> 32) as i32, step: (edge.step >> 32) as i32 }
    }

    /// Brings the scaled edge to this one's row, which is so many further down.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the lower words")]
    pub(super) const fn leave(self, edge: &mut LongEdge, rows: u32) {
        // What the walk left out: less than a unit a row.
        let (low, low_step) = ((edge.x as u32) >> (32 - LOW), (edge.step as u32) >> (32 - LOW));
        let low = low.wrapping_add(low_step.wrapping_mul(rows));
        let x = self.x.wrapping_add((low >> LOW).cast_signed());
        edge.x = (x as i64) << 32 | (low << (32 - LOW)) as i64;
    }
}

impl Edge for MediumEdge {
    #[inline(always)]
    fn column(&self) -> i32 {
        self.x >> FRACTION
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;
    use crate::raster::{first_center, Point};

    /// Rows of a batch.
    const ROWS: i32 = 16;
    const _: () = assert!(ROWS as usize == SpanBatch::CAPACITY, "rows of a batch");

    /// Walks an edge in batches and compares each row's column with the definition.
    fn check(a: Point, b: Point, skipped: i32) {
        let start = first_center(a.y) + skipped;
        let end = first_center(b.y);
        if start >= end {
            return;
        }
        let (dx, dy) = (i64::from(b.x - a.x), i64::from(b.y - a.y));
        let mut long = LongEdge::new(a, b, start).scaled();
        let mut y = start;
        while y < end {
            let rows = ROWS.min(end - y);
            let mut edge = MediumEdge::of(&long);
            let expected = long.after(rows);
            for row in y..y + rows {
                let down = i64::from(16 * row + 8 - a.y);
                // The first column whose centre is not left of the crossing.
                let crossing = i64::from(a.x - 8) * dy + dx * down;
                let column = -(-crossing).div_euclid(16 * dy);
                assert_eq!(i64::from(edge.column()), column, "row {row} of {a:?} to {b:?}");
                edge.step();
            }
            y += rows;
            edge.leave(&mut long, rows.cast_unsigned());
            if y < end {
                assert_eq!((long.x, long.step), (expected.x, expected.step), "{a:?} to {b:?}");
            }
        }
    }

    #[test]
    fn columns_are_those_of_the_definition() {
        let mut random = Random::new(9);
        let mut side = || (random.word() >> 16).cast_signed() % (FARTHEST + 1);
        let x = [-FARTHEST, FARTHEST, 0, 1, -1, 8, 9, 16];
        for dy in 1..=TALLEST {
            let top = side() & 31;
            for from in [-side(), side(), x[dy as usize % 8]] {
                for to in [-side(), side(), x[side() as usize % 8]] {
                    let (a, b) = (Point { x: from, y: top }, Point { x: to, y: top + dy });
                    check(a, b, side() % 20);
                }
            }
        }
    }

    #[test]
    fn crossings_next_to_a_column_are_told_apart_at_the_tallest() {
        // dx such that dx down is one more, or one less, than a multiple of 16 dy in some row.
        for dy in TALLEST - 40..=TALLEST {
            for dx in (0..FARTHEST).step_by(37).chain([1, 2, 3, FARTHEST]) {
                for x in [8, 9] {
                    check(Point { x, y: 0 }, Point { x: x + dx - FARTHEST, y: dy }, 0);
                    check(Point { x: -x, y: 7 }, Point { x: dx - x, y: dy + 7 }, 0);
                }
            }
        }
    }
}
