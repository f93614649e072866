use super::{BlockWalk, Blocks, BoundingBox, Rows};
use crate::frame::Rect;
use crate::raster::{Scanline, SpanBatch, SpanWalk, Spans, Traversal, Triangle};

/// Any traversal, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AnyTraversal {
    /// The shipped one: [`Scanline`].
    #[default]
    Spans,
    /// [`BoundingBox`].
    Box,
    /// [`Blocks`].
    Blocks,
    /// [`BlockWalk`].
    Walk,
}

/// A triangle being walked in any way.
#[derive(Clone, Debug, Default)]
pub struct AnyWalk {
    spans: Spans,
    rows: Rows,
    by_rows: bool,
}

impl Traversal for AnyTraversal {
    type Walk = AnyWalk;

    fn start(&self, walk: &mut AnyWalk, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        walk.by_rows = *self != Self::Spans;
        match self {
            Self::Spans => Scanline.start(&mut walk.spans, triangle, area, batch),
            Self::Box => BoundingBox.start(&mut walk.rows, triangle, area, batch),
            Self::Blocks => Blocks.start(&mut walk.rows, triangle, area, batch),
            Self::Walk => BlockWalk.start(&mut walk.rows, triangle, area, batch),
        }
    }
}

impl SpanWalk for AnyWalk {
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        if self.by_rows {
            self.rows.next_spans(batch);
        } else {
            self.spans.next_spans(batch);
        }
    }
}
