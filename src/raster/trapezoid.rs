use super::short_edge::{ShortEdge, FRACTION};
use super::Span;

/// Rows of a short triangle between one edge on the left and one on the right.
///
/// Two of them are a triangle. They are drawn as they are walked, so that no span goes through memory.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(crate) struct Trapezoid {
    /// Both edges in the first row, and their steps.
    x: [i32; 2],
    steps: [i32; 2],
    /// The first row, and the one behind the last.
    pub(crate) y: i32,
    end: i32,
}

impl Trapezoid {
    /// Between two edges in row `y`, down to `end`.
    #[inline(always)]
    pub(super) fn new(left: ShortEdge, right: ShortEdge, y: i32, end: i32) -> Self {
        Self { x: [left.x, right.x], steps: [left.step, right.step], y, end }
    }

    /// One with a number everywhere.
    #[inline(always)]
    pub(super) const fn of(number: i32) -> Self {
        Self { x: [number; 2], steps: [number; 2], y: number, end: number }
    }

    /// Whether a row is left.
    #[inline(always)]
    pub(crate) const fn has_row(&self) -> bool {
        self.y < self.end
    }

    /// The next row's first covered column, and the one behind the last; none are covered where that is
    /// not above.
    #[inline(always)]
    pub(crate) fn columns(&self) -> (i32, i32) {
        let [left, right] = self.x.map(|x| x >> FRACTION);
        (left, right)
    }

    /// The next row, and both edges in it.
    #[inline(always)]
    pub(crate) const fn place(&self) -> (i32, [i32; 2]) {
        (self.y, self.x)
    }

    /// The first covered column between two edges, the one behind the last, and how many there are: 16 bits
    /// hold it.
    #[inline(always)]
    pub(crate) const fn row([left, right]: [i32; 2]) -> (i32, i32, usize) {
        let (first, behind) = (left >> FRACTION, right >> FRACTION);
        (first, behind, behind.wrapping_sub(first) as usize & 0xFFFF)
    }

    /// The next row's pixels, if it holds any.
    #[inline(always)]
    pub(crate) fn span(&self) -> Option<Span> {
        let (first, behind) = self.columns();
        (first < behind).then_some(Span { y: self.y, first, left: first, right: behind, behind })
    }

    /// Goes one row down; whether that is one.
    #[inline(always)]
    pub(crate) fn step(&mut self) -> bool {
        let Self { x: [left, right], steps: [left_step, right_step], y, end } = *self;
        let y = y.wrapping_add(1);
        self.x = [left.wrapping_add(left_step), right.wrapping_add(right_step)];
        self.y = y;
        y < end
    }

    /// Leaves out the rows before the first that holds a pixel; whether there is one.
    #[inline(always)]
    pub(super) fn skip_empty_rows(&mut self) -> bool {
        while self.has_row() {
            if self.span().is_some() {
                return true;
            }
            self.step();
            // Not unrolled.
            core::hint::black_box(());
        }
        false
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::vec::Vec;

    use crate::frame::{Rect, Size};
    use crate::math::hard_numbers::Random;
    use crate::raster::{ScreenVertex, Span, SpanBatch, Spans, Triangle};

    /// The definition of coverage.
    fn covers(v: &[ScreenVertex; 3], x: i32, y: i32) -> bool {
        [(0, 1), (1, 2), (2, 0)].iter().all(|&(from, to)| {
            let (a, b): (&ScreenVertex, &ScreenVertex) = (&v[from], &v[to]);
            let (dx, dy) = (b.x_bits() - a.x_bits(), b.y_bits() - a.y_bits());
            let value = dx * (16 * y + 8 - a.y_bits()) - dy * (16 * x + 8 - a.x_bits());
            let is_top_or_left = dy < 0 || (dy == 0 && dx > 0);
            value >= i32::from(!is_top_or_left)
        })
    }

    #[test]
    fn rows_are_those_of_the_definition_and_begin_with_one_that_holds_a_pixel() {
        const WIDTH: u16 = 100;
        const HEIGHT: u16 = 24;
        let (area, mut random) = (Rect::from_size(Size::new(WIDTH, HEIGHT)), Random::new(17));
        let (mut walk, mut batch) = (Spans::default(), SpanBatch::default());
        let mut seen = [0; 3];
        for round in 0..60_000 {
            let mut below = |limit: u32| (random.word() % limit).cast_signed();
            // From a few subpixels to the largest that are walked so, on centres or not.
            let (wide, high) = [(16, 16), (40, 40), (90, 120), (900, 224)][round % 4];
            let (right, down) = (below(600), below(120));
            let v = [0; 3].map(|_: i32| {
                let (x, y) = (right + below(wide), down + below(high));
                let mask = if round % 3 == 0 { !7 } else { -1 };
                ScreenVertex::from_bits(x & mask, y & mask, 0)
            });
            let Some(mut triangle) = Triangle::oriented(v) else { continue };
            triangle.is_inside = round % 2 == 0;
            let is_any = walk.start_any(&triangle, &area, &mut batch);

            let mut expected: Vec<Span> = Vec::new();
            for y in 0..i32::from(HEIGHT) {
                let mut columns =
                    (0..i32::from(WIDTH)).filter(|x| covers(triangle.vertices(), *x, y));
                if let Some(first) = columns.next() {
                    let behind = columns.next_back().unwrap_or(first) + 1;
                    expected.push(Span { y, first, left: first, right: behind, behind });
                }
            }
            assert_eq!(is_any, !expected.is_empty(), "{v:?}");
            seen[batch.trapezoids().len()] += 1;
            let mut rows = Vec::new();
            for (number, trapezoid) in batch.trapezoids().iter().enumerate() {
                let mut trapezoid = *trapezoid;
                assert!(trapezoid.has_row(), "{v:?}");
                assert!(number > 0 || trapezoid.span().is_some(), "{v:?}");
                while trapezoid.has_row() {
                    rows.extend(trapezoid.span());
                    trapezoid.step();
                }
            }
            if batch.has_trapezoids() {
                assert_eq!(rows, expected, "{v:?}");
                batch.expand();
            }
            if batch.is_last() {
                assert_eq!(batch.spans(), expected, "{v:?}");
            }
        }
        assert!(seen.iter().all(|count| *count > 3000), "{seen:?}");
    }
}
