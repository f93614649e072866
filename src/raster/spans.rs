use super::medium_edge::{self, MediumEdge, FARTHEST};
use super::short_edge::{ShortEdge, TALLEST, WIDEST};
use super::{Edge, LongEdge, Point, Span, SpanBatch, SpanWalk, Trapezoid, Triangle};
use crate::frame::Rect;
use crate::math::rare;

/// A triangle walked row by row: each row's first and last covered pixel by an exact integer walk
/// along the edges, so that no pixel is tested.
///
/// # Cost
/// On Cortex-M4 some 150 instructions to start, 15 more where the triangle may reach beyond the area;
/// one division an edge, by a table where the core has none. Then some 20 a row of a short triangle,
/// but where passes draw its rows as they are walked: 12. Passes ask before whether a triangle is one
/// of very few pixels, which do without. Not generic, so that one copy serves every shader, state and
/// format.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spans {
    left: LongEdge,
    right: LongEdge,
    y: i32,
    /// The row at which the short side changes over to its second edge, or the end.
    turn: i32,
    end: i32,
    /// The second edge of the short side, and whether it is the right one.
    middle: Point,
    low: Point,
    turns_right: bool,
    /// Whether the edges are those of a triangle of medium size.
    is_medium: bool,
    /// The columns to draw, where the triangle reaches beyond them.
    columns: Option<(i32, i32)>,
}

/// The first row whose centre is at or below `y`; likewise of columns.
#[inline(always)]
pub(crate) const fn first_center(bits: i32) -> i32 {
    bits.wrapping_add(7) >> 4
}

/// Takes so many rows from `y` on between two edges, of which there is at least one and no more than
/// places: those that hold a pixel. How many those are.
#[inline(always)]
fn take_all_rows<E: Edge>(
    left: &mut E,
    right: &mut E,
    mut y: i32,
    places: &mut [Span],
    rows: usize,
) -> usize {
    let mut taken = rows;
    // As many places as rows are left: only one of both is counted.
    let mut places = places.get_mut(..rows).unwrap_or(&mut []).iter_mut();
    while !places.as_slice().is_empty() {
        let (first, behind) = (left.column(), right.column());
        left.step();
        right.step();
        if first < behind {
            if let Some(place) = places.next() {
                *place = Span { y, first, left: first, right: behind, behind };
            }
        } else {
            rare();
            taken = taken.wrapping_sub(1);
            places.next_back();
        }
        y = y.wrapping_add(1);
        // Keeps the compiler from unrolling.
        core::hint::black_box(());
    }
    taken
}

/// A triangle's corners from its highest, and the rows between them that are drawn.
#[derive(Clone, Copy, Debug)]
struct Descent {
    high: Point,
    right: Point,
    left: Point,
    start: i32,
    /// Where the shorter side changes over to its second edge: from the start to the end.
    turn: i32,
    end: i32,
}

impl Spans {
    /// Starts on a triangle, limited to `area`, and takes its first spans: none if no pixel of it
    /// is covered. A short triangle ends here, and the walk stays as it is.
    ///
    /// # Range
    /// Corners in the square of [`GUARD`](super::GUARD), as in all triangles that are drawn; sides
    /// of `area` below 2^30 in magnitude.
    #[inline(never)]
    pub fn start(&mut self, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        self.start_any(triangle, area, batch);
        if batch.has_trapezoids() {
            batch.expand();
        }
    }

    /// The same without making the spans of a short triangle that lies in the area.
    #[inline(never)]
    pub(super) fn start_any(&mut self, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        batch.last = true;
        batch.parts = 0;
        // Clockwise from the highest corner: the next one is on its right side.
        let [a, b, c] = triangle.v.each_ref().map(Point::of);
        let (high, right, left) = if a.y <= b.y && a.y <= c.y {
            (a, b, c)
        } else if b.y <= c.y {
            (b, c, a)
        } else {
            (c, a, b)
        };
        let (upper, lower) = (right.y.min(left.y), right.y.max(left.y));
        // Rows from the first centre at or below the top to the last above the bottom.
        // The turn is at the first of them below the middle corner, or at the end.
        let (mut start, mut end) = (first_center(high.y), first_center(lower));
        let mut turn = first_center(upper);
        let mut reaches_beyond = false;
        if !triangle.is_inside {
            (start, end) = (start.max(area.top), end.min(area.bottom));
            turn = turn.min(end).max(start);
            let (least, most) = (a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x));
            // Below zero where the triangle reaches beyond a side.
            let left_over = first_center(least).wrapping_sub(area.left);
            let right_over = area.right.wrapping_sub(first_center(most));
            reaches_beyond = left_over | right_over < 0;
        }
        if start >= end {
            batch.length = 0;
            return;
        }
        // Made where it is used, so that a short triangle's never goes through memory.
        let descent = || Descent { high, right, left, start, turn, end };
        if lower.wrapping_sub(high.y) <= TALLEST && descent().is_narrow() {
            descent().take_short(batch);
            if batch.has_trapezoids() && reaches_beyond {
                batch.expand();
                batch.clip(area.left, area.right);
            }
        } else {
            descent().walk(self);
            self.columns = reaches_beyond.then_some((area.left, area.right));
            self.next_spans(batch);
        }
    }
}

impl Descent {
    /// Whether sides are short enough along rows: those from the highest corner half as much.
    #[inline(always)]
    fn is_narrow(&self) -> bool {
        let raised = |to: Point| to.x.wrapping_sub(self.high.x).wrapping_add(WIDEST / 2);
        (raised(self.right) | raised(self.left)).cast_unsigned() < WIDEST.cast_unsigned()
    }

    /// The trapezoids of a short triangle.
    #[inline(always)]
    fn take_short(&self, batch: &mut SpanBatch) {
        let Self { high, right, left, start, turn, end } = *self;
        let left_edge = ShortEdge::new(high, left, start);
        let right_edge = ShortEdge::new(high, right, start);
        let mut upper = Trapezoid::new(left_edge, right_edge, start, turn);
        // Over to the second edge of the side that has two.
        let rows = turn.wrapping_sub(start);
        let (left_edge, right_edge) = if right.y < left.y {
            (left_edge.after(rows), ShortEdge::new(right, left, turn))
        } else {
            (ShortEdge::new(left, right, turn), right_edge.after(rows))
        };
        let mut lower = Trapezoid::new(left_edge, right_edge, turn, end);
        let [first, second] = &mut batch.trapezoids;
        (batch.length, batch.parts) = (1, 1);
        if upper.skip_empty_rows() {
            *first = upper;
            if lower.has_row() {
                *second = lower;
                batch.parts = 2;
            }
        } else if lower.skip_empty_rows() {
            *first = lower;
        } else {
            (batch.length, batch.parts) = (0, 0);
        }
    }

    /// Makes the walk over any other triangle.
    #[inline(never)]
    fn walk(&self, walk: &mut Spans) {
        let Self { high, right, left, start, turn, end } = *self;
        let turns_right = right.y < left.y;
        let (middle, low) = if turns_right { (right, left) } else { (left, right) };
        let long = LongEdge::new(high, low, start);
        let short = if start < turn {
            LongEdge::new(high, middle, start)
        } else {
            LongEdge::new(middle, low, start)
        };
        let (left, right) = if turns_right { (long, short) } else { (short, long) };
        let xs = [high.x, middle.x, low.x];
        walk.is_medium = low.y.wrapping_sub(high.y) <= medium_edge::TALLEST
            && xs.iter().all(|x| (-FARTHEST..=FARTHEST).contains(x));
        (walk.left, walk.right) =
            if walk.is_medium { (left.scaled(), right.scaled()) } else { (left, right) };
        (walk.y, walk.end) = (start, end);
        walk.turn = if start < turn { turn } else { end };
        (walk.middle, walk.low, walk.turns_right) = (middle, low, turns_right);
    }
}

impl Spans {
    /// Takes the spans of the next rows, in all columns.
    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "at most the capacity of a batch"
    )]
    fn take(&mut self, batch: &mut SpanBatch) {
        batch.clear();
        let mut places = batch.spans.as_mut_slice();
        loop {
            // Rows down to the turn, or as many as fit. Copies of the edges stay in registers.
            let end = self.turn.min(self.y.wrapping_add(places.len() as i32));
            let rows = end.wrapping_sub(self.y) as usize;
            let taken = if self.is_medium {
                let (mut left, mut right) =
                    (MediumEdge::of(&self.left), MediumEdge::of(&self.right));
                let taken = take_all_rows(&mut left, &mut right, self.y, places, rows);
                left.leave(&mut self.left, rows as u32);
                right.leave(&mut self.right, rows as u32);
                taken
            } else {
                let (mut left, mut right) = (self.left, self.right);
                let taken = take_all_rows(&mut left, &mut right, self.y, places, rows);
                (self.left, self.right) = (left, right);
                taken
            };
            places = places.get_mut(taken..).unwrap_or(&mut []);
            self.y = end;
            if end >= self.turn {
                if end >= self.end {
                    break;
                }
                self.turn_over();
            }
            if places.is_empty() {
                batch.last = false;
                break;
            }
        }
        batch.length = SpanBatch::CAPACITY.wrapping_sub(places.len());
    }
}

impl Spans {
    /// Over to the short side's second edge. Apart, so that the walk's registers are the rows'.
    #[inline(never)]
    fn turn_over(&mut self) {
        self.turn = self.end;
        let mut second = LongEdge::new(self.middle, self.low, self.y);
        if self.is_medium {
            second = second.scaled();
        }
        if self.turns_right {
            self.right = second;
        } else {
            self.left = second;
        }
    }
}

impl SpanWalk for Spans {
    #[inline(never)]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        loop {
            self.take(batch);
            if let Some((left, right)) = self.columns {
                batch.clip(left, right);
            }
            if !batch.is_empty() || batch.is_last() {
                return;
            }
        }
    }
}
