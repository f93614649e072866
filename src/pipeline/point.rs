//! Points, without a detour by spans.

use super::fill::Access;
use crate::color::Format;
use crate::frame::{DepthAccess, Frame, Rect, Size, Supplies};
use crate::raster::{PointSquare, ScreenVertex};
use crate::shade::{
    ColorOutput, Corner, Counter, DepthTest, Event, Fragments, Row, State, Varying,
};

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
    H: Fragments,
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
    let (depth, output, counter) = state.parts();
    let corner =
        if H::COLOR_AS_IS && output.dims() { &H::Varying::dim::<F>(corner) } else { corner };
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
            z: depth.corner(vertex.z),
            z_step: 0,
            may_be_level: false,
            varying,
            step,
            behind: None,
            depth,
            output,
            counter: &mut *counter,
        });
        y = y.wrapping_add(1);
    }
    Event::Drawn
}

/// Draws points of one pixel each, in a frame with one stride: what does not depend on the point is
/// done once.
///
/// # Cost
/// About a third of what a square of any size costs.
#[inline(always)]
pub(super) fn single_points<'t, H, S, F, D>(
    frame: &mut Frame<'_, F, D>,
    state: &mut S,
    shader: &H,
    picture: Size,
    area: &Rect,
    points: impl IntoIterator<Item = &'t (ScreenVertex, Corner<H::Varying>)>,
) where
    H: Fragments,
    H::Varying: 't,
    S: State,
    F: Format,
    D: Supplies<Access<S>>,
{
    let Rect { left, top, right, bottom } = *area;
    let (width, height) = (right.wrapping_sub(left), bottom.wrapping_sub(top));
    let stride = frame.stride();
    let (depth, output, counter) = state.parts();
    let Some((pixels, mut cells, first)) = frame.all_from::<Access<S>>(left, top) else { return };
    for (vertex, corner) in points {
        counter.event(Event::Point);
        // The half-open square holds the centre of one pixel.
        let x = vertex.x_bits().wrapping_sub(1) >> 4;
        let y = vertex.y_bits().wrapping_sub(1) >> 4;
        let (column, row) = (x.wrapping_sub(left), y.wrapping_sub(top));
        if column.cast_unsigned() >= width.cast_unsigned()
            || row.cast_unsigned() >= height.cast_unsigned()
        {
            let is_far = !vertex.in_range(picture);
            counter.event(if is_far { Event::Skipped } else { Event::Outside });
            continue;
        }
        let at = first.wrapping_add((row as usize).wrapping_mul(stride));
        let at = at.wrapping_add(column as usize);
        let Some(pixel) = pixels.get_mut(at) else { return };
        let Some(cells) = <Access<S>>::one(&mut cells, at) else { return };
        let corner =
            if H::COLOR_AS_IS && output.dims() { &H::Varying::dim::<F>(corner) } else { corner };
        let square = PointSquare::new(vertex, 16);
        let (varying, step) = H::Varying::on_point(corner, &square, x, y);
        shader.span(Row::<S, F, H::Varying> {
            x,
            y,
            pixels: core::slice::from_mut(pixel),
            cells,
            z: depth.corner(vertex.z),
            z_step: 0,
            may_be_level: false,
            varying,
            step,
            behind: None,
            depth,
            output,
            counter: &mut *counter,
        });
        counter.event(Event::Drawn);
    }
}
