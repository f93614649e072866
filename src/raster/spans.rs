use super::short_edge::{ShortEdge, TALLEST, WIDEST};
use super::{EdgeWalk, ScreenVertex, Span, SpanBatch, SpanWalk, Triangle};
use crate::frame::Rect;

/// A triangle walked row by row: each row's first and last covered pixel by an exact integer walk along
/// the edges, so that no pixel is tested.
///
/// # Cost
/// About 20 instructions a row on Cortex-M4 and a division an edge where the core has one; not
/// generic, so that one copy serves every shader, state and format.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans {
    long: EdgeWalk,
    short: EdgeWalk,
    y: i32,
    /// The row at which the short side changes over to its second edge, or the end.
    turn: i32,
    end: i32,
    left: i32,
    right: i32,
    /// Whether the long edge is the right one.
    long_is_right: bool,
    middle: ScreenVertex,
    low: ScreenVertex,
}

/// The first row whose centre is at or below `y`.
#[inline(always)]
fn first_row(vertex: &ScreenVertex) -> i32 {
    vertex.y_bits().wrapping_add(7) >> 4
}

/// A triangle's corners from top to bottom, and the rows between them that are drawn.
#[derive(Clone, Copy, Debug)]
struct Sorted<'a> {
    high: &'a ScreenVertex,
    middle: &'a ScreenVertex,
    low: &'a ScreenVertex,
    long_is_right: bool,
    start: i32,
    turn: i32,
    end: i32,
}

impl Spans {
    /// Starts on a triangle, limited to `area`, and takes its first spans: none if no pixel of it
    /// is covered. A short triangle ends here, and the walk stays as it is.
    #[inline(never)]
    pub fn start(&mut self, triangle: &Triangle, area: Rect, batch: &mut SpanBatch) {
        batch.clear();
        // Sort by y; each exchange turns the orientation over.
        let [a, b, c] = &triangle.v;
        let (mut high, mut middle, mut low) = (a, b, c);
        let mut flip = false;
        if middle.y_bits() < high.y_bits() {
            core::mem::swap(&mut high, &mut middle);
            flip = !flip;
        }
        if low.y_bits() < middle.y_bits() {
            core::mem::swap(&mut middle, &mut low);
            flip = !flip;
            if middle.y_bits() < high.y_bits() {
                core::mem::swap(&mut high, &mut middle);
                flip = !flip;
            }
        }
        // Rows from the first centre at or below the top to the last above the bottom.
        let start = first_row(high).max(area.top);
        let end = first_row(low).min(area.bottom);
        if start >= end {
            return;
        }
        // The same for columns: a narrow triangle may pass between the centres.
        let column = |x: i32| x.wrapping_add(7) >> 4;
        let (x, y, z) = (a.x_bits(), b.x_bits(), c.x_bits());
        let (least, most) = (x.min(y).min(z), x.max(y).max(z));
        if column(least).max(area.left) >= column(most).min(area.right) {
            return;
        }
        let turn = first_row(middle).max(area.top).min(end);
        let sorted = Sorted { high, middle, low, long_is_right: flip, start, turn, end };
        let height = low.y_bits().wrapping_sub(high.y_bits());
        if height <= TALLEST && most.wrapping_sub(least) < WIDEST {
            sorted.take_short(area, batch);
        } else {
            *self = sorted.walk(area);
            self.next_spans(batch);
        }
    }
}

impl Sorted<'_> {
    /// All spans of a short triangle.
    #[inline(always)]
    fn take_short(&self, area: Rect, batch: &mut SpanBatch) {
        let Self { high, middle, low, long_is_right, start, turn, end } = *self;
        let origin = high.x_bits() >> 4;
        let edge = |a, b, y| ShortEdge::new(a, b, y, origin);
        let long = edge(high, low, start);
        let (short, mut stop) = if start < turn {
            (edge(high, middle, start), turn)
        } else {
            (edge(middle, low, start), end)
        };
        let (mut left, mut right) = if long_is_right { (short, long) } else { (long, short) };
        let (mut y, mut taken) = (start, 0_usize);
        loop {
            while y < stop {
                let first = left.column().wrapping_add(origin);
                let last = right.column().wrapping_add(origin);
                left.step();
                right.step();
                let (from, to) = (first.max(area.left), last.min(area.right));
                if from < to {
                    if let Some(span) = batch.spans.get_mut(taken) {
                        *span = Span { y, first, left: from, right: to };
                        taken = taken.wrapping_add(1);
                    }
                }
                y = y.wrapping_add(1);
                // Keeps the compiler from unrolling: four copies of this cost more than they save.
                core::hint::black_box(());
            }
            if stop >= end {
                batch.length = taken;
                return;
            }
            // Over to the short side's second edge.
            stop = end;
            let second = edge(middle, low, y);
            if long_is_right {
                left = second;
            } else {
                right = second;
            }
        }
    }

    /// The walk over any other triangle.
    #[inline(never)]
    fn walk(&self, area: Rect) -> Spans {
        let Self { high, middle, low, long_is_right, start, turn, end } = *self;
        let (short, turn) = if start < turn {
            (EdgeWalk::new(high, middle, start), turn)
        } else {
            (EdgeWalk::new(middle, low, start), end)
        };
        Spans {
            long: EdgeWalk::new(high, low, start),
            short,
            y: start,
            turn,
            end,
            left: area.left,
            right: area.right,
            long_is_right,
            middle: *middle,
            low: *low,
        }
    }
}

impl SpanWalk for Spans {
    #[inline(never)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "at most the capacity of a batch"
    )]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        batch.clear();
        loop {
            // Rows down to the turn, or as many as fit.
            let room = SpanBatch::CAPACITY.wrapping_sub(batch.length) as i32;
            let end = self.turn.min(self.y.wrapping_add(room));
            // Copies, which stay in registers where fields would be stored in every row.
            let (mut long, mut short, mut y) = (self.long, self.short, self.y);
            while y < end {
                let (first, last) =
                    if self.long_is_right { (short.x, long.x) } else { (long.x, short.x) };
                let (left, right) = (first.max(self.left), last.min(self.right));
                if left < right {
                    batch.push(Span { y, first, left, right });
                }
                long.step();
                short.step();
                y = y.wrapping_add(1);
                core::hint::black_box(());
            }
            (self.long, self.short, self.y) = (long, short, y);
            if self.y >= self.turn {
                if self.turn >= self.end {
                    return;
                }
                // Over to the short side's second edge.
                self.turn = self.end;
                self.short = EdgeWalk::new(&self.middle, &self.low, self.y);
            }
            if !batch.has_room() {
                batch.more();
                return;
            }
        }
    }
}
