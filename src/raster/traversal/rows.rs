use std::vec::Vec;

use crate::frame::Rect;
use crate::raster::{Span, SpanBatch, SpanWalk, Triangle};

/// The pixels of a triangle by rows, found before they are handed out.
#[derive(Clone, Debug, Default)]
pub struct Rows {
    spans: Vec<Span>,
    next: usize,
}

/// The pixels whose centres lie in a triangle's box: all columns, and the rows of the area.
pub(super) fn pixel_box(triangle: &Triangle, area: Rect) -> Rect {
    let ends = |values: [i32; 3]| {
        let [a, b, c] = values.map(|bits| bits.wrapping_add(7) >> 4);
        (a.min(b).min(c), a.max(b).max(c))
    };
    let (left, right) = ends(triangle.vertices().map(|vertex| vertex.x_bits()));
    let (top, bottom) = ends(triangle.vertices().map(|vertex| vertex.y_bits()));
    Rect::new(left, top.max(area.top), right, bottom.min(area.bottom))
}

impl Rows {
    /// Keeps rows as `(y, first, behind the last)`, in any order of y, cut to the area; then hands
    /// out the first batch.
    pub(super) fn start(
        &mut self,
        rows: impl IntoIterator<Item = (i32, i32, i32)>,
        area: Rect,
        batch: &mut SpanBatch,
    ) {
        self.next = 0;
        self.spans.clear();
        for (y, first, behind) in rows {
            let (left, right) = (first.max(area.left), behind.min(area.right));
            if left < right {
                self.spans.push(Span { y, first, left, right, behind });
            }
        }
        self.spans.sort_by_key(|span| span.y);
        self.next_spans(batch);
    }
}

impl SpanWalk for Rows {
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        batch.clear();
        while batch.has_room() {
            let Some(span) = self.spans.get(self.next) else { return };
            batch.push(*span);
            self.next += 1;
        }
        if self.next < self.spans.len() {
            batch.more();
        }
    }
}
