use super::depth::{DepthAccess, Supplies};
use super::Frame;
use crate::color::Format;
use crate::raster::Span;

/// Colours and cells of a frame, both by one number a pixel, so that one check serves both: those of
/// all rows, or of a part of one row where rows of cells are further apart than those of colour, or
/// less far.
pub(crate) struct Window<'a, F: Format, A: DepthAccess> {
    pixels: &'a mut [F::Raw],
    cells: A::Cells<'a>,
    /// From one row to the next.
    stride: usize,
    /// What pixel (0, 0) of the picture is before the window's first.
    before: usize,
    /// Its number: the same, below zero.
    origin: usize,
}

impl<F: Format, A: DepthAccess> Window<'_, F, A> {
    /// The same with as many cells as colours.
    #[inline(always)]
    pub(crate) fn level(&mut self) -> Option<Window<'_, F, A>> {
        let length = self.pixels.len().min(A::length(&self.cells));
        let cells = A::part(&mut self.cells, 0, length)?;
        let pixels = self.pixels.get_mut(..length)?;
        Some(Window {
            pixels,
            cells,
            stride: self.stride,
            before: self.before,
            origin: self.origin,
        })
    }

    /// Colours and cells of so many columns of picture row `y`, from `left` on; `None` where the
    /// window does not reach.
    #[inline(always)]
    pub(crate) fn row(
        &mut self,
        y: i32,
        left: i32,
        length: usize,
    ) -> Option<(&mut [F::Raw], A::Cells<'_>)> {
        let at = self.number(left, y);
        // Two steps: a range would have its order checked besides its end.
        let pixels = self.pixels.get_mut(at..)?.get_mut(..length)?;
        Some((pixels, A::part(&mut self.cells, at, length)?))
    }

    /// The same of no more columns than a row can have, where the compiler knows that.
    #[inline(always)]
    pub(crate) fn short_row(
        &mut self,
        y: i32,
        left: i32,
        length: usize,
    ) -> Option<(&mut [F::Raw], A::Cells<'_>)> {
        // No slice is longer: the end is not before the beginning then, and is checked alone.
        let at = self.number(left, y) & (usize::MAX >> 1);
        let range = at..at.wrapping_add(length);
        Some((self.pixels.get_mut(range.clone())?, A::range(&mut self.cells, range)?))
    }

    /// The same of a row whose beginning is found in one step: where rows follow each other.
    #[inline(always)]
    pub(crate) fn next_row(
        &mut self,
        y: i32,
        left: i32,
        length: usize,
    ) -> Option<(&mut [F::Raw], A::Cells<'_>)> {
        let beginning = self.origin.wrapping_add((y as usize).wrapping_mul(self.stride));
        let at = beginning.wrapping_add(left as usize) & (usize::MAX >> 1);
        let range = at..at.wrapping_add(length);
        Some((self.pixels.get_mut(range.clone())?, A::range(&mut self.cells, range)?))
    }

    /// The number of a pixel in the window.
    #[inline(always)]
    pub(crate) fn number(&self, x: i32, y: i32) -> usize {
        (x as usize).wrapping_sub(self.before).wrapping_add((y as usize).wrapping_mul(self.stride))
    }

    /// From one row to the next.
    #[inline(always)]
    pub(crate) fn stride(&self) -> usize {
        self.stride
    }

    /// Colour and cell of the pixel with a number; `None` where the window does not reach.
    #[inline(always)]
    pub(crate) fn one(&mut self, at: usize) -> Option<(&mut [F::Raw], A::Cells<'_>)> {
        let pixel = core::slice::from_mut(self.pixels.get_mut(at)?);
        Some((pixel, A::one(&mut self.cells, at)?))
    }
}

/// What spans are drawn on.
pub(crate) enum Target<'t, 'a, F: Format, D, A: DepthAccess> {
    /// All rows at once.
    Whole(Window<'t, F, A>),
    /// One row at a time: of a frame whose rows of cells are not as far apart as those of colour.
    Rows(&'t mut Frame<'a, F, D>),
}

impl<'a, F: Format, D> Frame<'a, F, D> {
    /// What spans are drawn on.
    #[inline(always)]
    pub(crate) fn target<A: DepthAccess>(&mut self) -> Target<'_, 'a, F, D, A>
    where
        D: Supplies<A>,
    {
        if !self.has_one_stride::<A>() {
            return Target::Rows(self);
        }
        let stride = self.stride;
        let before = usize::from(self.first_row).wrapping_mul(stride);
        let origin = before.wrapping_neg();
        let (pixels, cells) = (&mut *self.pixels, self.depth.all());
        Target::Whole(Window { pixels, cells, stride, before, origin })
    }

    /// A window of a span alone; `None` if the frame does not reach so far.
    ///
    /// Not inlined: there is one copy for all shaders.
    #[inline(never)]
    pub(crate) fn window<A: DepthAccess>(&mut self, span: &Span) -> Option<Window<'_, F, A>>
    where
        D: Supplies<A>,
    {
        let stride = self.stride;
        let before = (span.y as usize).wrapping_mul(stride).wrapping_add(span.left as usize);
        let origin = before.wrapping_neg();
        let (pixels, cells) = self.row_with_depth::<A>(span.y, span.left, span.right)?;
        Some(Window { pixels, cells, stride, before, origin })
    }
}
