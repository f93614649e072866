use super::super::fill::Access;
use super::stroke::{Continuous, LineDraw, Outcome, Replicated};
use super::LineStyle;
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::shade::{Fragments, State};

/// Lines of some width as OpenGL has them: the pixels of a [`Thin`](super::Thin) line, replicated
/// across its longer side, so that slanting lines are thinner than they should be and ends are not
/// square to the line.
///
/// # Range
/// 1 to 32 pixels; what lies outside is taken as the nearest.
///
/// # Rounding
/// None: the line is moved up (to the left) by half of width - 1, and each of its pixels becomes a
/// column (a row) of so many, downwards (to the right). Source: OpenGL 4.6 (compatibility), section
/// 14.5.2.2.
///
/// # Cost
/// That of as many thin lines, less their planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide(pub u8);

impl Wide {
    /// The widest line.
    pub const WIDEST: u8 = 32;
}

impl LineStyle for Wide {
    #[inline(always)]
    fn draw<H, S, F, D>(
        &self,
        line: &LineDraw<'_, H::Varying>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
    ) -> Outcome
    where
        H: Fragments,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.draw_with(Continuous, line, frame, state, shader)
    }
}

impl Replicated for Wide {
    #[inline(always)]
    fn width(&self) -> i32 {
        self.0.clamp(1, Self::WIDEST).into()
    }

    const EXACT: bool = true;
}
