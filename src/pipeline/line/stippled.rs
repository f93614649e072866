use super::super::fill::Access;
use super::stroke::{LineDraw, Outcome, Pattern, Replicated};
use super::LineStyle;
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::shade::{Fragments, State};

/// Lines with gaps: a pattern of sixteen bits, from the lowest one up, each for `factor` pixels
/// along the line.
///
/// A strip or a loop continues the pattern from line to line, every other line begins it anew; it is
/// counted from the line's own first pixel, so that no scissor and no band moves it.
///
/// Source: OpenGL 4.6 (compatibility), section 14.5.2.1.
///
/// ```
/// use microraster::{Stippled, Thin, Wide};
///
/// let dotted = Stippled::new(0x5555, 1, Thin);
/// let dashed = Stippled::new(0x00FF, 2, Wide(3));
/// # let _ = (dotted, dashed);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stippled<L> {
    pattern: u16,
    factor: u8,
    style: L,
}

impl<L> Stippled<L> {
    /// Lines of a style ([`Thin`](super::Thin), [`Midpoint`](super::Midpoint) or
    /// [`Wide`](super::Wide)) where the pattern has ones; a factor of 0 is taken as 1.
    pub const fn new(pattern: u16, factor: u8, style: L) -> Self {
        Self { pattern, factor: if factor == 0 { 1 } else { factor }, style }
    }
}

impl<L: Replicated> LineStyle for Stippled<L> {
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
        let dashes = Dashes { pattern: self.pattern, factor: self.factor.max(1), had: 0 };
        self.style.draw_with(dashes, line, frame, state, shader)
    }
}

/// A [`Stippled`] line at one of its pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dashes {
    /// The pixel's bit is the lowest.
    pattern: u16,
    factor: u8,
    /// Pixels that the bit had already.
    had: u8,
}

impl Pattern for Dashes {
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "less than the factor")]
    fn started(self, pixel: u32) -> Self {
        let factor = u32::from(self.factor.max(1));
        let bit = pixel / factor;
        let had = pixel.wrapping_sub(bit.wrapping_mul(factor)) as u8;
        Self { pattern: self.pattern.rotate_right(bit & 15), had, ..self }
    }

    #[inline(always)]
    fn is_on(&self) -> bool {
        self.pattern & 1 != 0
    }

    #[inline(always)]
    fn step(&mut self, forwards: bool) {
        let last = self.factor.wrapping_sub(1);
        if forwards {
            if self.had == last {
                (self.had, self.pattern) = (0, self.pattern.rotate_right(1));
            } else {
                self.had = self.had.wrapping_add(1);
            }
        } else if self.had == 0 {
            (self.had, self.pattern) = (last, self.pattern.rotate_left(1));
        } else {
            self.had = self.had.wrapping_sub(1);
        }
    }
}
