//! Points, without a detour by spans.

use super::fill::Access;
use crate::color::Format;
use crate::frame::{Frame, Rect, Supplies};
use crate::raster::{PointSquare, ScreenVertex};
use crate::shade::{Corner, Event, Row, Shader, State, Varying};

/// Draws a point of `size` sixteenths of a pixel.
#[inline(always)]
pub(super) fn draw_point<H, S, F, D>(
    vertex: &ScreenVertex,
    corner: &Corner<H::Varying>,
    size: u32,
    area: &Rect,
    frame: &mut Frame<'_, F, D>,
    state: &mut S,
    shader: &H,
) -> Event
where
    H: Shader,
    S: State,
    F: Format,
    D: Supplies<Access<S>>,
{
    let square = PointSquare::new(vertex, size);
    let pixels = square.pixels(area);
    if size == 0 {
        return Event::Degenerate;
    }
    if pixels.left >= pixels.right || pixels.top >= pixels.bottom {
        return Event::Outside;
    }
    let Rect { left, right, bottom, .. } = pixels;
    let (depth, counter) = state.parts();
    let mut y = pixels.top;
    while y < bottom {
        let Some((pixels, cells)) = frame.row_with_depth::<Access<S>>(y, left, right) else {
            break;
        };
        let (varying, step) = H::Varying::on_point(corner, &square, left, y);
        shader.span(Row::<S, F, H::Varying> {
            x: left,
            y,
            pixels,
            cells,
            z: u32::from(vertex.z) << 16 | 0x8000,
            z_step: 0,
            varying,
            step,
            depth,
            counter: &mut *counter,
        });
        y = y.wrapping_add(1);
    }
    Event::Drawn
}
