use super::{Span, SpanBatch, Triangle};

/// Long spans cut into pieces, for varyings that may only be stepped so far.
///
/// Pieces are counted from a row's first covered pixel, so that no scissor changes a bit. A
/// triangle that is narrow does without, and the pixel loop, whose registers are few, knows
/// nothing of it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pieces {
    pieces: SpanBatch,
    /// The span that is being cut, and how much of it is done.
    span: usize,
    done: i32,
}

impl Pieces {
    /// Whether a row of the triangle may be longer than `length` pixels.
    #[inline(always)]
    pub(crate) fn are_needed(triangle: &Triangle, length: i32) -> bool {
        let [a, b, c] = triangle.v.map(|v| v.x_bits());
        a.max(b).max(c).wrapping_sub(a.min(b).min(c)) > length.wrapping_mul(16)
    }

    /// The next pieces of the batch, of at most `length` pixels; [`is_last`](Self::is_last) says
    /// whether there are more.
    #[inline(never)]
    pub(crate) fn take(&mut self, batch: &SpanBatch, length: i32) -> &[Span] {
        self.pieces.clear();
        while let Some(span) = batch.spans().get(self.span) {
            let first = span.first.wrapping_add(self.done);
            let right = span.right.min(first.wrapping_add(length));
            if right > span.left {
                if !self.pieces.has_room() {
                    self.pieces.more();
                    return self.pieces.spans();
                }
                let left = span.left.max(first);
                self.pieces.push(Span { y: span.y, first, left, right });
            }
            self.done = self.done.wrapping_add(length);
            if right >= span.right {
                self.span = self.span.wrapping_add(1);
                self.done = 0;
            }
        }
        self.span = 0;
        self.pieces.spans()
    }

    /// Whether these were the batch's last.
    #[inline(always)]
    pub(crate) fn is_last(&self) -> bool {
        self.pieces.is_last()
    }
}
