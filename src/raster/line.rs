use super::{Edge, LongEdge, Point, ScreenVertex, Span, SpanBatch, SpanWalk, Triangle};
use crate::frame::Rect;

/// A line one pixel wide, from a first corner to a last one, by the diamond-exit rule.
///
/// A pixel belongs to the line if the line leaves the diamond `|x - cx| + |y - cy| < 1/2` about its
/// centre: of a chain of lines every joint is drawn once. Both ends count as moved by
/// (-e, -e^2) for a very small e, so that nothing is left to chance where a line runs through the
/// diamonds' corners. Source: OpenGL 4.6, section 14.5.1.
///
/// A line that is wider than high crosses the vertical diagonal of every diamond that it enters,
/// except where it ends; so there is one pixel a column, the one whose row the line is in at the
/// column's centre, and only the diamonds about the two ends are looked at. The same holds for
/// rows of a line that is higher than wide.
///
/// # Rounding
/// None: the pixels are exact for every corner in the square of [`GUARD`](super::GUARD).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    first: ScreenVertex,
    last: ScreenVertex,
    /// Columns are counted, not rows.
    by_columns: bool,
    /// The columns (or rows) between the ends: from the first to behind the last.
    from: i32,
    to: i32,
    /// The pixel whose diamond the first corner lies in when its centre lies before the corner.
    head: Option<i32>,
}

/// The first column (or row) whose centre is not before `v`.
#[inline(always)]
const fn not_before(v: i32) -> i32 {
    v.wrapping_add(7) >> 4
}

/// Whether a corner, moved by (-e, -e^2), lies in the diamond of pixel (i, j).
fn is_in_diamond(corner: &ScreenVertex, i: i32, j: i32) -> bool {
    let x = corner.x_bits().wrapping_sub(i.wrapping_mul(16)).wrapping_sub(8);
    let y = corner.y_bits().wrapping_sub(j.wrapping_mul(16)).wrapping_sub(8);
    let distance = x.saturating_abs().saturating_add(y.saturating_abs());
    distance < 8 || (distance == 8 && x > 0)
}

impl Line {
    /// The line between two corners in range; `None` if it leaves no diamond.
    pub(crate) fn between(first: ScreenVertex, last: ScreenVertex) -> Option<Self> {
        let width = last.x_bits().wrapping_sub(first.x_bits());
        let height = last.y_bits().wrapping_sub(first.y_bits());
        let by_columns = width.unsigned_abs() >= height.unsigned_abs();
        let ascending = if by_columns { width > 0 } else { height > 0 };
        let start = |v: &ScreenVertex| not_before(if by_columns { v.x_bits() } else { v.y_bits() });
        let holds = |v: &ScreenVertex, at: i32| {
            // The column's left border belongs to the column before: corners move to the left.
            let (i, j) = if by_columns {
                (at, v.y_bits() >> 4)
            } else {
                (v.x_bits().wrapping_sub(1) >> 4, at)
            };
            is_in_diamond(v, i, j)
        };
        // The pixel just before each end, in the direction of the line.
        let before = |v: &ScreenVertex| start(v).wrapping_sub(i32::from(ascending));
        let (head, tail) = (before(&first), before(&last));
        let is_headed = holds(&first, head);
        let is_cut = holds(&last, tail);
        let (from, to, is_headed) = if ascending {
            let to = start(&last).wrapping_sub(i32::from(is_cut));
            (start(&first), to, is_headed && head < to)
        } else {
            let from = start(&last).wrapping_add(i32::from(is_cut));
            (from, start(&first), is_headed && head >= from)
        };
        let head = is_headed.then_some(head);
        (from < to || head.is_some()).then_some(Self { first, last, by_columns, from, to, head })
    }

    /// The pixels between the ends, limited to `area`; attributes are in range there.
    pub(crate) fn walk(&self, area: Rect) -> LineWalk {
        self.walk_over(self.from, self.to, area)
    }

    /// The pixel about the first corner whose centre lies before it, so that attributes have to be
    /// the corner's.
    pub(crate) fn head(&self, area: Rect) -> Option<LineWalk> {
        self.head.map(|head| self.walk_over(head, head.wrapping_add(1), area))
    }

    /// A triangle whose attribute planes are those of the line, steps along its longer side:
    /// the third corner has the attributes of the first.
    pub(crate) fn plane_triangle(&self) -> Triangle {
        let (a, b) = (self.first, self.last);
        let width = b.x_bits().wrapping_sub(a.x_bits());
        let height = b.y_bits().wrapping_sub(a.y_bits());
        let (x, y, side) = if self.by_columns { (0, width, width) } else { (height, 0, height) };
        let (x, y) = if self.by_columns { (x, y) } else { (x.wrapping_neg(), y) };
        let c =
            ScreenVertex::from_bits(a.x_bits().wrapping_add(x), a.y_bits().wrapping_add(y), a.z);
        let area = i64::from(side).wrapping_mul(side.into()).max(1);
        Triangle { v: [a, b, c], area, flipped: false }
    }

    fn walk_over(&self, from: i32, to: i32, area: Rect) -> LineWalk {
        let Self { first: a, last: b, by_columns, .. } = self;
        let (low, high) =
            if *by_columns { (area.left, area.right) } else { (area.top, area.bottom) };
        let (at, end) = (from.max(low), to.min(high));
        // Upright, going down, and less half a pixel: then the walk along an edge finds
        // ceil(crossing) - 1, the pixel that holds the crossing if a tie counts to the smaller side.
        let upright = |v: &ScreenVertex, mirror: bool| {
            let (minor, major) =
                if *by_columns { (v.y_bits(), v.x_bits()) } else { (v.x_bits(), v.y_bits()) };
            let minor = if mirror { minor.wrapping_neg() } else { minor };
            Point { x: minor.wrapping_sub(8), y: major }
        };
        // Columns: the line is moved to the left, so that one that falls to the right has its ties
        // on the larger side.
        let rise = (b.y_bits() > a.y_bits()) == (b.x_bits() > a.x_bits());
        let mirrored = *by_columns && rise && a.y_bits() != b.y_bits();
        let (a, b) = (upright(a, mirrored), upright(b, mirrored));
        let (a, b) = if a.y < b.y { (a, b) } else { (b, a) };
        let edge = if at < end { LongEdge::new(a, b, at) } else { LongEdge::default() };
        LineWalk { edge, at, end, first: from, behind: to, area, by_columns: *by_columns, mirrored }
    }
}

/// A line being walked.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineWalk {
    edge: LongEdge,
    /// The next column (or row), and the one behind the last.
    at: i32,
    end: i32,
    /// The first column before any scissor.
    first: i32,
    /// The first column behind, before any scissor.
    behind: i32,
    area: Rect,
    by_columns: bool,
    /// Rows are counted upwards.
    mirrored: bool,
}

impl LineWalk {
    /// The row of the next column.
    fn row(&self) -> i32 {
        if self.mirrored {
            !self.edge.column()
        } else {
            self.edge.column()
        }
    }

    fn step(&mut self) {
        self.edge.step();
        self.at = self.at.wrapping_add(1);
    }
}

impl SpanWalk for LineWalk {
    #[inline(never)]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        batch.clear();
        while self.at < self.end {
            if !batch.has_room() {
                batch.more();
                return;
            }
            let Rect { left, top, right, bottom } = self.area;
            if self.by_columns {
                let (y, start) = (self.row(), self.at);
                while self.at < self.end && self.row() == y {
                    self.step();
                }
                if top <= y && y < bottom {
                    batch.push(Span {
                        y,
                        first: self.first,
                        left: start,
                        right: self.at,
                        behind: self.behind,
                    });
                }
            } else {
                let (x, y) = (self.edge.column(), self.at);
                self.step();
                if left <= x && x < right {
                    batch.push(Span {
                        y,
                        first: x,
                        left: x,
                        right: x.wrapping_add(1),
                        behind: x.wrapping_add(1),
                    });
                }
            }
        }
    }
}
