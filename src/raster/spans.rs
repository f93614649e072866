use super::{EdgeWalk, ScreenVertex, Span, SpanBatch, SpanWalk, Triangle};
use crate::frame::Rect;

/// A triangle walked row by row: each row's first and last covered pixel by an exact integer walk along
/// the edges, so that no pixel is tested.
///
/// # Cost
/// About 20 instructions a row on Cortex-M4 and a division an edge where the core has one; not
/// generic, so that one copy serves every shader, state and format.
#[derive(Clone, Copy, Debug)]
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
    /// Starts on a triangle, limited to `area`; `None` when it covers no row of it.
    #[inline(never)]
    pub fn new(triangle: &Triangle, area: Rect) -> Option<Self> {
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
            return None;
        }
        // The same for columns: a narrow triangle may pass between the centres.
        let column = |x: i32| x.wrapping_add(7) >> 4;
        let (x, y, z) = (a.x_bits(), b.x_bits(), c.x_bits());
        if column(x.min(y).min(z)).max(area.left) >= column(x.max(y).max(z)).min(area.right) {
            return None;
        }
        let turn = first_row(middle).max(area.top).min(end);
        let long = EdgeWalk::new(high, low, start);
        let (short, turn) = if start < turn {
            (EdgeWalk::new(high, middle, start), turn)
        } else {
            (EdgeWalk::new(middle, low, start), end)
        };
        Some(Self {
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
        })
    }
}

impl Spans {
    /// Goes over to the short side's second edge; false at the end. Apart, so that the common way
    /// stays short.
    #[inline(never)]
    fn turn(&mut self) -> bool {
        if self.turn >= self.end {
            return false;
        }
        self.turn = self.end;
        self.short = EdgeWalk::new(&self.middle, &self.low, self.y);
        true
    }
}

impl SpanWalk for Spans {
    #[inline]
    fn next_span(&mut self, span: &mut Span) -> bool {
        loop {
            if self.y >= self.turn && !self.turn() {
                return false;
            }
            let (long, short) = (self.long.x, self.short.x);
            let (first, last) = if self.long_is_right { (short, long) } else { (long, short) };
            let (y, left, right) = (self.y, first.max(self.left), last.min(self.right));
            self.long.step();
            self.short.step();
            self.y = y.wrapping_add(1);
            if left < right {
                *span = Span { y, first, left, right };
                return true;
            }
        }
    }

    #[inline(never)]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        let mut taken = 0_usize;
        let (mut long, mut y) = (self.long, self.y);
        let (left, right) = (self.left, self.right);
        let spans = &mut batch.spans;
        while y < self.turn || self.turn() {
            // Rows down to the turn, or as many as fit.
            let room = SpanBatch::CAPACITY.wrapping_sub(taken) as i32;
            let end = self.turn.min(y.wrapping_add(room));
            let mut short = self.short;
            while y < end {
                let (first, last) =
                    if self.long_is_right { (short.x, long.x) } else { (long.x, short.x) };
                let (left, right) = (first.max(left), last.min(right));
                if left < right {
                    if let Some(span) = spans.get_mut(taken) {
                        *span = Span { y, first, left, right };
                    }
                    taken = taken.wrapping_add(1);
                }
                long.step();
                short.step();
                y = y.wrapping_add(1);
            }
            self.y = y;
            self.short = short;
            if taken >= SpanBatch::CAPACITY {
                break;
            }
        }
        self.long = long;
        batch.length = taken;
    }
}
