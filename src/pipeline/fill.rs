use crate::color::Format;
use crate::frame::{DepthAccess, Frame, Supplies};
use crate::raster::{Gradients, Plane, SpanBatch, SpanWalk, Traversal, Triangle};
use crate::shade::{Corner, DepthTest, Row, Shader, State, Varying};

/// How a state touches depth.
pub(crate) type Access<S> = <<S as State>::Depth as DepthTest>::Access;

/// A triangle being walked under a state.
pub(super) type Walk<S> = <<S as State>::Traversal as Traversal>::Walk;

/// A triangle ready for its pixels: where it is, and its attributes in the same order.
#[derive(Clone, Copy)]
pub(super) struct Fill<'a, V: Varying> {
    pub(super) triangle: &'a Triangle,
    pub(super) corners: [&'a Corner<V>; 3],
    pub(super) provoking: &'a Corner<V>,
}

/// What the planes share, and the plane of the depth codes: 16.16, raised by a half so that cutting
/// off rounds.
#[inline(never)]
fn depth_gradients(triangle: &Triangle) -> (Gradients, Plane) {
    let gradients = Gradients::new(triangle);
    let [a, b, c] = &triangle.v;
    let mut plane = gradients.plane(a.z, b.z, c.z);
    plane.origin = plane.origin.wrapping_add(0x8000);
    (gradients, plane)
}

impl<V: Varying> Fill<'_, V> {
    /// Draws the triangle's pixels: those of `batch` and all that `walk` still finds.
    ///
    /// One copy of this, with the pixel loop inlined, is what a shader and state cost in flash.
    #[inline(never)]
    pub(super) fn draw<H, S, F, D, W>(
        &self,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        W: SpanWalk,
        H: Shader<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let (gradients, z_plane) = if <Access<S>>::TOUCHES {
            depth_gradients(self.triangle)
        } else if V::INTERPOLATED {
            (Gradients::new(self.triangle), Plane::default())
        } else {
            (Gradients::default(), Plane::default())
        };
        let planes = V::planes(&gradients, self.corners, self.provoking);
        let (depth, counter) = state.parts();
        loop {
            for span in batch.spans() {
                let mut left = span.left;
                loop {
                    // Where a varying may only be stepped so far, a span is drawn in pieces,
                    // counted from the row's first covered pixel.
                    let (start, right) = if V::PIECE == 0 {
                        (left, span.right)
                    } else {
                        let pieces = left.wrapping_sub(span.first) & V::PIECE.wrapping_neg();
                        let start = span.first.wrapping_add(pieces);
                        (start, start.wrapping_add(V::PIECE).min(span.right))
                    };
                    let (mut varying, step) = V::start(&planes, start, span.y);
                    if left != start {
                        varying.advance(&step, left.wrapping_sub(start));
                    }
                    let Some((pixels, cells)) =
                        frame.row_with_depth::<Access<S>>(span.y, left, right)
                    else {
                        return;
                    };
                    shader.span(Row::<S, F, V> {
                        pixels,
                        cells,
                        z: z_plane.at(left, span.y),
                        z_step: z_plane.dx,
                        varying,
                        step,
                        depth,
                        counter,
                    });
                    left = right;
                    if V::PIECE == 0 || left >= span.right {
                        break;
                    }
                }
            }
            if batch.is_last() {
                return;
            }
            walk.next_spans(batch);
        }
    }
}
