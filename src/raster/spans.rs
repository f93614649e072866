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

impl Spans {
    /// Starts on a triangle, limited to `area`, and takes its first spans: none if no pixel of it
    /// is covered. Most triangles end here, so that the walk never leaves the registers.
    #[inline(never)]
    pub fn start(triangle: &Triangle, area: Rect, batch: &mut SpanBatch) -> Self {
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
        // The same for columns: a narrow triangle may pass between the centres.
        let column = |x: i32| x.wrapping_add(7) >> 4;
        let (x, y, z) = (a.x_bits(), b.x_bits(), c.x_bits());
        let left = column(x.min(y).min(z)).max(area.left);
        let right = column(x.max(y).max(z)).min(area.right);
        batch.clear();
        if start >= end || left >= right {
            return Self::default();
        }
        let turn = first_row(middle).max(area.top).min(end);
        let long = EdgeWalk::new(high, low, start);
        let (short, turn) = if start < turn {
            (EdgeWalk::new(high, middle, start), turn)
        } else {
            (EdgeWalk::new(middle, low, start), end)
        };
        let mut spans = Self {
            long,
            short,
            y: start,
            turn,
            end,
            left: area.left,
            right: area.right,
            long_is_right: flip,
            middle: *middle,
            low: *low,
        };
        spans.take(batch);
        spans
    }

    /// Takes the next spans.
    #[inline(always)]
    fn take(&mut self, batch: &mut SpanBatch) {
        let mut taken = 0_usize;
        loop {
            // Rows down to the turn, or as many as fit.
            let room = SpanBatch::CAPACITY.wrapping_sub(taken) as i32;
            let end = self.turn.min(self.y.wrapping_add(room));
            while self.y < end {
                let (long, short) = (self.long.x, self.short.x);
                let (first, last) = if self.long_is_right { (short, long) } else { (long, short) };
                let (left, right) = (first.max(self.left), last.min(self.right));
                if left < right {
                    if let Some(span) = batch.spans.get_mut(taken) {
                        *span = Span { y: self.y, first, left, right };
                        taken = taken.wrapping_add(1);
                    }
                }
                self.long.step();
                self.short.step();
                self.y = self.y.wrapping_add(1);
            }
            if self.y >= self.turn {
                if self.turn >= self.end {
                    break;
                }
                // Over to the short side's second edge.
                self.turn = self.end;
                self.short = EdgeWalk::new(&self.middle, &self.low, self.y);
            }
            if taken >= SpanBatch::CAPACITY {
                break;
            }
        }
        batch.length = taken;
    }
}

impl SpanWalk for Spans {
    #[inline(never)]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        self.take(batch);
    }
}
