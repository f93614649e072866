use super::{Spans, Trapezoid, Triangle};
use crate::frame::Rect;

/// A run of covered pixels in one row, in picture coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The row.
    pub y: i32,
    /// The row's first covered pixel before any scissor: where pieces are counted from, so that no
    /// scissor changes a bit. At most `left`.
    pub first: i32,
    /// The first pixel to draw.
    pub left: i32,
    /// The first pixel behind those to draw; above `left`.
    pub right: i32,
    /// The first pixel behind the row's covered ones before any scissor: no less than `right`.
    pub behind: i32,
}

/// A way of finding the pixels of a triangle; all ways find the same ones.
pub trait Traversal: Copy {
    /// One triangle being walked.
    type Walk: SpanWalk + Default;

    /// Starts `walk` on a triangle, limited to `area`, and takes its first spans: none if no pixel
    /// of it is covered.
    fn start(&self, walk: &mut Self::Walk, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch);

    /// The same for those who draw trapezoids too, or [expand](SpanBatch::expand) them: a short
    /// triangle's spans need not be made then. Whether any pixel is covered.
    #[doc(hidden)]
    #[inline(always)]
    fn start_any(
        &self,
        walk: &mut Self::Walk,
        triangle: &Triangle,
        area: &Rect,
        batch: &mut SpanBatch,
    ) -> bool {
        self.start(walk, triangle, area, batch);
        !batch.is_empty()
    }

    /// Whether passes are to ask before whether a triangle covers few pixels, which they then draw
    /// without it.
    #[doc(hidden)]
    #[inline(always)]
    fn leaves_few(&self) -> bool {
        false
    }

    /// Whether triangles that are known to lie in the area may be started without a look at it: not
    /// where this starts another way on a part of the area.
    #[doc(hidden)]
    #[inline(always)]
    fn takes_whole_area(&self) -> bool {
        false
    }
}

/// A triangle being walked.
pub trait SpanWalk {
    /// Takes the next spans that are not empty; [`SpanBatch::is_last`] says when they are the last.
    fn next_spans(&mut self, batch: &mut SpanBatch);
}

/// A few spans of one triangle: taken together, they cost half of what they do one by one, since
/// the walk's state stays in registers.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub struct SpanBatch {
    /// Those whose rows are to be spans, and how many there are: none where spans are made. First, so that
    /// several words are loaded at once.
    pub(super) trapezoids: [Trapezoid; 2],
    pub(super) parts: usize,
    pub(super) length: usize,
    pub(super) last: bool,
    pub(super) spans: [Span; Self::CAPACITY],
}

impl SpanBatch {
    /// Spans that fit.
    pub const CAPACITY: usize = 16;

    /// One without spans, as [`default`](Self::default) makes it by `memset`: that takes four
    /// instructions a word, which counts where few triangles are drawn at a time.
    #[inline(never)]
    pub(crate) fn made_by_stores() -> Self {
        // Opaque: the compiler would call `memset` all the same.
        let zero = core::hint::black_box(0);
        let span = Span { y: zero, first: zero, left: zero, right: zero, behind: zero };
        Self {
            spans: [span; Self::CAPACITY],
            length: 0,
            last: false,
            parts: 0,
            trapezoids: [Trapezoid::of(zero); 2],
        }
    }

    /// Forgets the spans; those that come are the last ones until [`more`](Self::more) is said.
    #[inline(always)]
    pub fn clear(&mut self) {
        self.length = 0;
        self.last = true;
        self.parts = 0;
    }

    /// Says that more spans will follow these.
    #[inline(always)]
    pub fn more(&mut self) {
        self.last = false;
    }

    /// Whether another span fits.
    #[inline(always)]
    pub fn has_room(&self) -> bool {
        self.length < Self::CAPACITY
    }

    /// Adds a span that holds a pixel; one too many is lost. Of a triangle with a span that holds none,
    /// those that follow may not be drawn.
    #[inline(always)]
    pub fn push(&mut self, span: Span) {
        if let Some(place) = self.spans.get_mut(self.length) {
            *place = span;
            self.length = self.length.wrapping_add(1);
        }
    }

    /// Limits the spans to the columns `left..right`.
    #[inline(never)]
    pub(super) fn clip(&mut self, left: i32, right: i32) {
        let taken = core::mem::take(&mut self.length);
        for at in 0..taken {
            let Some(span) = self.spans.get(at).copied() else { return };
            let span = Span { left: span.left.max(left), right: span.right.min(right), ..span };
            if span.left < span.right {
                self.push(span);
            }
            // A loop: this is about flash.
            core::hint::black_box(());
        }
    }

    /// Whether there are trapezoids whose rows are the spans, which are not made yet.
    #[inline(always)]
    pub(crate) fn has_trapezoids(&self) -> bool {
        self.parts != 0
    }

    /// The first trapezoid, which is not without rows.
    #[inline(always)]
    pub(crate) fn rows(&mut self) -> &mut Trapezoid {
        let [first, _] = &mut self.trapezoids;
        first
    }

    /// Puts the second trapezoid in the place of the first; whether there was one.
    #[inline(always)]
    pub(crate) fn next_rows(&mut self) -> bool {
        let is_any = self.parts == 2;
        if is_any {
            let [first, second] = &mut self.trapezoids;
            *first = *second;
            self.parts = 1;
        }
        is_any
    }

    /// The trapezoids, none of which is without rows.
    #[cfg(test)]
    pub(super) fn trapezoids(&self) -> &[Trapezoid] {
        self.trapezoids.get(..self.parts).unwrap_or(&[])
    }

    /// Makes the spans of trapezoids.
    ///
    /// # Cost
    /// 20 instructions a row on Cortex-M4, for whom spans are asked: apart, so that it is there once.
    #[inline(never)]
    pub(crate) fn expand(&mut self) {
        let parts = core::mem::take(&mut self.parts);
        self.last = true;
        let mut places = self.spans.iter_mut();
        for trapezoid in self.trapezoids.iter().take(parts) {
            let mut rows = *trapezoid;
            while rows.has_row() {
                if let Some(span) = rows.span() {
                    let Some(place) = places.next() else { break };
                    *place = span;
                }
                rows.step();
                // Not unrolled.
                core::hint::black_box(());
            }
        }
        self.length = Self::CAPACITY.wrapping_sub(places.len());
    }

    /// The spans that were taken.
    #[inline(always)]
    pub fn spans(&self) -> &[Span] {
        self.spans.get(..self.length).unwrap_or(&[])
    }

    /// Whether none were taken.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Whether these were the triangle's last.
    #[inline(always)]
    pub fn is_last(&self) -> bool {
        self.last
    }
}

/// The shipped traversal: row by row between two edges. See [`Spans`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Scanline;

impl Traversal for Scanline {
    type Walk = Spans;

    #[inline(always)]
    fn start(&self, walk: &mut Spans, triangle: &Triangle, area: &Rect, batch: &mut SpanBatch) {
        walk.start(triangle, area, batch);
    }

    #[inline(always)]
    fn start_any(
        &self,
        walk: &mut Spans,
        triangle: &Triangle,
        area: &Rect,
        batch: &mut SpanBatch,
    ) -> bool {
        walk.start_any(triangle, area, batch)
    }

    #[inline(always)]
    fn leaves_few(&self) -> bool {
        true
    }

    #[inline(always)]
    fn takes_whole_area(&self) -> bool {
        true
    }
}
