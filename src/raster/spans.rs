use super::medium_edge::{self, MediumEdge, FARTHEST};
use super::short_edge::{ShortEdge, TALLEST, WIDEST};
use super::{Edge, LongEdge, Point, Span, SpanBatch, SpanWalk, Trapezoid, Triangle};
use crate::frame::Rect;
use crate::math::rare;

/// A triangle walked row by row: each row's first and last covered pixel by an exact integer walk
/// along the edges, so that no pixel is tested.
///
/// # Cost
/// On Cortex-M4 some 140 instructions to start, 15 more where the triangle may reach beyond the area;
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

/// A triangle's corners from its highest to its lowest, and the rows between them that are drawn.
#[derive(Clone, Copy, Debug)]
struct Descent {
    high: Point,
    middle: Point,
    low: Point,
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

    /// The same without making the spans of a short triangle that lies in the area; whether there are any.
    #[inline(never)]
    pub(super) fn start_any(
        &mut self,
        triangle: &Triangle,
        area: &Rect,
        batch: &mut SpanBatch,
    ) -> bool {
        // Clockwise from the highest corner: the next one is on its right side.
        let [a, b, c] = triangle.v.each_ref().map(Point::of);
        let (high, right, left) = if a.y <= b.y && a.y <= c.y {
            (a, b, c)
        } else if b.y <= c.y {
            (b, c, a)
        } else {
            (c, a, b)
        };
        // Two copies, in which no side is chosen any more.
        if right.y < left.y {
            self.descend::<true>([high, right, left], triangle.is_inside, area, batch)
        } else {
            self.descend::<false>([high, left, right], triangle.is_inside, area, batch)
        }
    }

    /// The same from the highest corner to the lowest; the right side is the one with two edges, or the left one.
    #[inline(always)]
    fn descend<const TURNS_RIGHT: bool>(
        &mut self,
        [high, middle, low]: [Point; 3],
        is_inside: bool,
        area: &Rect,
        batch: &mut SpanBatch,
    ) -> bool {
        // Rows from the first centre at or below the top to the last above the bottom.
        // The turn is at the first of them below the middle corner, or at the end.
        let (mut start, mut end) = (first_center(high.y), first_center(low.y));
        let mut turn = first_center(middle.y);
        let mut reaches_beyond = false;
        if !is_inside {
            (start, end) = (start.max(area.top), end.min(area.bottom));
            turn = turn.min(end).max(start);
            let least = high.x.min(middle.x).min(low.x);
            let most = high.x.max(middle.x).max(low.x);
            // Below zero where the triangle reaches beyond a side.
            let left_over = first_center(least).wrapping_sub(area.left);
            let right_over = area.right.wrapping_sub(first_center(most));
            reaches_beyond = left_over | right_over < 0;
        }
        if start >= end {
            batch.clear();
            return false;
        }
        // Made where it is used, so that a short triangle's never goes through memory.
        let descent = || Descent { high, middle, low, start, turn, end };
        // Above zero, as the compiler knows it.
        let tall = low.y.wrapping_sub(high.y);
        if tall.wrapping_sub(1).cast_unsigned() < TALLEST.cast_unsigned() && descent().is_narrow() {
            let is_any = descent().take_short::<TURNS_RIGHT>(tall, batch);
            if is_any && reaches_beyond {
                batch.expand();
                batch.clip(area.left, area.right);
                return !batch.is_empty();
            }
            is_any
        } else {
            descent().walk(TURNS_RIGHT, self);
            self.columns = reaches_beyond.then_some((area.left, area.right));
            self.next_spans(batch);
            !batch.is_empty()
        }
    }
}

impl Descent {
    /// Whether sides are short enough along rows: those from the highest corner half as much.
    #[inline(always)]
    fn is_narrow(&self) -> bool {
        let raised = |to: Point| to.x.wrapping_sub(self.high.x).wrapping_add(WIDEST / 2);
        (raised(self.middle) | raised(self.low)).cast_unsigned() < WIDEST.cast_unsigned()
    }

    /// The trapezoids of a short triangle of a height; whether there are any.
    #[inline(always)]
    fn take_short<const TURNS_RIGHT: bool>(&self, tall: i32, batch: &mut SpanBatch) -> bool {
        let Self { high, middle, low, start, turn, end } = *self;
        let trapezoid = |long, short, y, end| {
            let (left, right) = if TURNS_RIGHT { (long, short) } else { (short, long) };
            Trapezoid::new(left, right, y, end)
        };
        let [first, second] = &mut batch.trapezoids;
        let mut parts = 0;
        let long = ShortEdge::of_height(high, low, tall, start);
        let upper_height = middle.y.wrapping_sub(high.y);
        if upper_height > 0 {
            let short = ShortEdge::of_height(high, middle, upper_height, start);
            let mut upper = trapezoid(long, short, start, turn);
            if upper.skip_empty_rows() {
                *first = upper;
                parts = 1;
            }
        }
        let lower_height = low.y.wrapping_sub(middle.y);
        if turn < end && lower_height > 0 {
            let long = long.after(turn.wrapping_sub(start));
            let short = ShortEdge::of_height(middle, low, lower_height, turn);
            let mut lower = trapezoid(long, short, turn, end);
            if parts != 0 {
                *second = lower;
                parts = 2;
            } else if lower.skip_empty_rows() {
                *first = lower;
                parts = 1;
            }
        }
        if parts == 0 {
            batch.clear();
            return false;
        }
        batch.parts = parts;
        true
    }

    /// Makes the walk over any other triangle.
    #[inline(never)]
    fn walk(&self, turns_right: bool, walk: &mut Spans) {
        let Self { high, middle, low, start, turn, end } = *self;
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
