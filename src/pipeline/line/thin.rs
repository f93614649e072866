use super::super::fill::Access;
use super::stroke::{Continuous, LineDraw, Outcome, Replicated};
use super::LineStyle;
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::shade::{Fragments, State};

/// Lines one pixel wide by the diamond-exit rule: of a chain of lines every joint is drawn once.
///
/// # Rounding
/// None: the pixels are those of OpenGL 4.6, section 14.5.1. Attributes run from corner to corner
/// along the longer side, in equal steps.
///
/// # Cost
/// On Cortex-M4, with depth and one colour a line, 11 instructions a pixel of a line that is higher
/// than wide and 14 (16 where it rises) of one that is wider than high, after 680 a line.
///
/// # Measured
/// <!-- tradeoff: heads-up/line=thin -->
/// `thin` in the scene `heads-up`: 17.2 (M4F), 30.8 (M0+), 20.3 (RV32) instructions a pixel; PSNR 22.7 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Thin;

impl LineStyle for Thin {
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

impl Replicated for Thin {
    #[inline(always)]
    fn width(&self) -> i32 {
        1
    }

    const EXACT: bool = true;
}
