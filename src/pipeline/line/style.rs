use super::super::fill::Access;
use super::stroke::{LineDraw, Outcome};
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::shade::{Fragments, State};

/// What lines look like: [`Thin`](super::Thin), [`Midpoint`](super::Midpoint),
/// [`Wide`](super::Wide), one of these [`Stippled`](super::Stippled),
/// [`Rectangle`](super::Rectangle), or [`Smooth`](super::Smooth).
///
/// A type, so that a program contains the styles that it uses.
pub trait LineStyle: Copy {
    /// Draws a line.
    #[doc(hidden)]
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
        D: Supplies<Access<S>>;
}
