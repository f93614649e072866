use super::{ScreenVertex, Span, SpanBatch, SpanWalk};
use crate::frame::Rect;

/// The pixels of a point: those whose centres lie in the half-open square
/// `[x - size/2, x + size/2) x [y - size/2, y + size/2)` about the corner as it is, unrounded.
///
/// Source: OpenGL 4.6, section 14.4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointWalk {
    left: i32,
    right: i32,
    y: i32,
    end: i32,
    /// The first column before any scissor.
    first: i32,
    /// The first one behind, before any scissor.
    behind: i32,
}

impl PointWalk {
    /// The square of `size` pixels about `corner`, limited to `area`.
    pub(crate) fn new(corner: &ScreenVertex, size: u16, area: Rect) -> Self {
        let half = i32::from(size).wrapping_mul(8);
        // The first column whose centre is not before v.
        let from = |v: i32| v.wrapping_sub(half).wrapping_add(7) >> 4;
        let to = |v: i32| v.wrapping_add(half).wrapping_add(7) >> 4;
        let (x, y) = (corner.x_bits(), corner.y_bits());
        Self {
            left: from(x).max(area.left),
            right: to(x).min(area.right),
            y: from(y).max(area.top),
            end: to(y).min(area.bottom),
            first: from(x),
            behind: to(x),
        }
    }
}

impl SpanWalk for PointWalk {
    #[inline(never)]
    fn next_spans(&mut self, batch: &mut SpanBatch) {
        batch.clear();
        let Self { left, right, first, behind, .. } = *self;
        while left < right && self.y < self.end {
            if !batch.has_room() {
                batch.more();
                return;
            }
            batch.push(Span { y: self.y, first, left, right, behind });
            self.y = self.y.wrapping_add(1);
        }
    }
}
