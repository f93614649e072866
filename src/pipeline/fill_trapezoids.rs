//! Short triangles, drawn as they are walked: no span goes through memory.

use super::fill::Access;
use crate::color::Format;
use crate::frame::Window;
use crate::math::rare;
use crate::raster::{Span, SpanBatch, Trapezoid};
use crate::shade::{Fragments, Ready, Row, State, Varying};

impl<V: Varying> Ready<V> {
    /// Draws a short triangle's rows as they are walked; `None` if the frame does not reach so far.
    ///
    /// # Cost
    /// On Cortex-M4 some 30 instructions a row in one colour, 40 where it varies, besides the pixel
    /// loop: 6 less than by spans.
    #[inline(never)]
    pub(super) fn draw_trapezoids<H, S, F>(
        &self,
        batch: &mut SpanBatch,
        window: &mut Window<'_, F, Access<S>>,
        state: &mut S,
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        let (depth, output, counter) = state.parts();
        let mut window = window.level()?;
        // Kept in memory, which the pixel loop may change for all that the compiler knows.
        let batch = core::hint::black_box(batch);
        loop {
            let rows = batch.rows();
            let (mut y, mut x) = rows.place();
            loop {
                let (left, right, length) = Trapezoid::row(x);
                if length != 0 {
                    let parts = (depth, output, &mut *counter);
                    let columns = (left, right, length);
                    self.draw_row::<H, S, F>(y, columns, &mut window, parts, shader)?;
                } else {
                    rare();
                }
                core::hint::black_box(());
                if !rows.step() {
                    break;
                }
                (y, x) = rows.place();
            }
            if !batch.next_rows() {
                return Some(());
            }
        }
    }

    /// Draws a row of a short triangle; `None` if the frame does not reach so far.
    #[inline(always)]
    fn draw_row<H, S, F>(
        &self,
        y: i32,
        (left, right, length): (i32, i32, usize),
        window: &mut Window<'_, F, Access<S>>,
        (depth, output, counter): (&S::Depth, &S::Output, &mut S::Counter),
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        let Self { set: (planes, z_plane) } = self;
        let span = Span { y, first: left, left, right, behind: right };
        let mut runs = V::runs(planes, &span);
        let (pixels, cells) = window.next_row(y, left, length)?;
        let (mut varying, step, _) = V::run(planes, &mut runs, &span, right);
        let behind = Some((varying, z_plane.at(right, y)));
        // For a shader's own loop.
        varying.jump(&step, left.wrapping_sub(right));
        shader.span(Row::<S, F, V> {
            x: left,
            y,
            pixels,
            cells,
            z: z_plane.at(left, y),
            z_step: z_plane.dx,
            may_be_level: false,
            varying,
            step,
            behind,
            depth,
            output,
            counter,
        });
        Some(())
    }
}
