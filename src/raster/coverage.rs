use super::{Spans, Triangle};
use crate::frame::Rect;

/// A run of covered pixels in one row, in picture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The row.
    pub y: i32,
    /// The row's first covered pixel before any scissor: where stepping is anchored, so that no
    /// scissor changes a bit. At most `left`.
    pub first: i32,
    /// The first pixel to draw.
    pub left: i32,
    /// The first pixel behind those to draw; above `left`.
    pub right: i32,
}

/// A way of finding the pixels of a triangle; all ways find the same ones.
pub trait Traversal: Copy {
    /// One triangle being walked.
    type Walk: SpanWalk;

    /// Starts on a triangle, limited to `area`; `None` when no pixel can be covered.
    fn walk(&self, triangle: &Triangle, area: Rect) -> Option<Self::Walk>;
}

/// A triangle being walked.
pub trait SpanWalk {
    /// Goes to the next span that is not empty; false when there is none.
    fn next_span(&mut self, span: &mut Span) -> bool;

    /// Takes up to eight spans at once; fewer are taken only at the end.
    #[inline]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        batch.length = 0;
        for span in &mut batch.spans {
            if !self.next_span(span) {
                return;
            }
            batch.length = batch.length.wrapping_add(1);
        }
    }
}

/// A few spans of one triangle: taken together, they cost half of what they do one by one, since
/// the walk's state stays in registers.
#[derive(Clone, Copy, Debug, Default)]
pub struct SpanBatch {
    pub(super) spans: [Span; Self::CAPACITY],
    pub(super) length: usize,
}

impl SpanBatch {
    /// Spans that fit.
    pub const CAPACITY: usize = 8;

    /// The spans that were taken.
    #[inline(always)]
    pub fn spans(&self) -> &[Span] {
        self.spans.get(..self.length).unwrap_or(&[])
    }

    /// Whether these were the triangle's last.
    #[inline(always)]
    pub fn is_last(&self) -> bool {
        self.length < Self::CAPACITY
    }
}

/// The shipped traversal: row by row between two edges. See [`Spans`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scanline;

impl Traversal for Scanline {
    type Walk = Spans;

    #[inline(always)]
    fn walk(&self, triangle: &Triangle, area: Rect) -> Option<Spans> {
        Spans::new(triangle, area)
    }
}
