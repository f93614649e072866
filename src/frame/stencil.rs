use core::iter::Zip;
use core::slice::IterMut;

use super::depth::{DepthAccess, Supplies};
use super::view::{check_stride, clear_cells, clear_codes, length, needed};
use super::{DepthBuffer, Frame, FrameError, NoDepth};
use crate::color::{Color, Format};

/// The caller's 8-bit stencil values, one a pixel, beside depth `D` or none of it.
#[derive(Debug)]
pub struct StencilBuffer<'a, D> {
    depth: D,
    values: &'a mut [u8],
    stride: usize,
}

/// The pass reads and may write stencil values, and does with depth what `A` says.
#[derive(Clone, Copy, Debug, Default)]
pub struct WithStencil<A>(A);

impl<A: DepthAccess> DepthAccess for WithStencil<A> {
    const TOUCHES: bool = true;
    const HAS_DEPTH: bool = A::HAS_DEPTH;
    const HAS_STENCIL: bool = true;
    type Cells<'a> = (A::Cells<'a>, &'a mut [u8]);
    type Cell<'a> = (A::Cell<'a>, &'a mut u8);
    type Iter<'a> = Zip<A::Iter<'a>, IterMut<'a, u8>>;

    #[inline(always)]
    fn part<'a>(
        (depth, values): &'a mut Self::Cells<'_>,
        from: usize,
        length: usize,
    ) -> Option<Self::Cells<'a>> {
        Some((A::part(depth, from, length)?, values.get_mut(from..)?.get_mut(..length)?))
    }

    #[inline(always)]
    fn one<'a>((depth, values): &'a mut Self::Cells<'_>, at: usize) -> Option<Self::Cells<'a>> {
        Some((A::one(depth, at)?, values.get_mut(at).map(core::slice::from_mut)?))
    }

    #[inline(always)]
    fn length((depth, values): &Self::Cells<'_>) -> usize {
        A::length(depth).min(values.len())
    }

    #[inline(always)]
    fn iter<'a>((depth, values): Self::Cells<'a>) -> Self::Iter<'a> {
        A::iter(depth).zip(values)
    }

    #[inline(always)]
    fn read<'a>((depth, _): &Self::Cell<'a>) -> u16 {
        A::read(depth)
    }

    #[inline(always)]
    fn write<'a>((depth, _): Self::Cell<'a>, code: u16) {
        A::write(depth, code);
    }
}

impl<A: DepthAccess, D: Supplies<A>> Supplies<WithStencil<A>> for StencilBuffer<'_, D> {
    #[inline(always)]
    fn cells(
        &mut self,
        row: usize,
        left: usize,
        length: usize,
    ) -> Option<(A::Cells<'_>, &mut [u8])> {
        let start = row.wrapping_mul(self.stride).wrapping_add(left);
        let values = self.values.get_mut(start..)?.get_mut(..length)?;
        Some((self.depth.cells(row, left, length)?, values))
    }

    #[inline(always)]
    fn all(&mut self) -> (A::Cells<'_>, &mut [u8]) {
        (self.depth.all(), self.values)
    }

    #[inline(always)]
    fn run(&mut self, length: usize) -> Option<(A::Cells<'_>, &mut [u8])> {
        Some((self.depth.run(length)?, self.values.get_mut(..length)?))
    }

    #[inline(always)]
    fn length(&self) -> usize {
        self.values.len().min(self.depth.length())
    }

    #[inline(always)]
    fn has_stride(&self, stride: usize) -> bool {
        self.stride == stride && self.depth.has_stride(stride)
    }
}

/// Passes without a stencil see the depth alone.
macro_rules! without_stencil {
    ($($access:ty),*) => {
        $(
            impl<D: Supplies<$access>> Supplies<$access> for StencilBuffer<'_, D> {
                #[inline(always)]
                fn cells(
                    &mut self,
                    row: usize,
                    left: usize,
                    length: usize,
                ) -> Option<<$access as DepthAccess>::Cells<'_>> {
                    self.depth.cells(row, left, length)
                }

                #[inline(always)]
                fn all(&mut self) -> <$access as DepthAccess>::Cells<'_> {
                    self.depth.all()
                }

                #[inline(always)]
                fn run(&mut self, length: usize) -> Option<<$access as DepthAccess>::Cells<'_>> {
                    self.depth.run(length)
                }

                #[inline(always)]
                fn length(&self) -> usize {
                    self.depth.length()
                }

                #[inline(always)]
                fn has_stride(&self, stride: usize) -> bool {
                    self.depth.has_stride(stride)
                }
            }
        )*
    };
}

without_stencil!(super::Untouched, super::ReadWrite);

impl<'a, F: Format, D> Frame<'a, F, D> {
    /// The same frame with a stencil buffer whose rows follow each other without a gap.
    ///
    /// Depth comes first, where there is any: [`with_depth`](Frame::with_depth) is for frames
    /// without a stencil.
    ///
    /// ```
    /// use microraster::{Frame, FrameError, Rgb565, Size};
    ///
    /// let (mut pixels, mut depth, mut stencil) = ([0; 12], [0; 12], [9; 12]);
    /// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(4, 3))?
    ///     .with_depth(&mut depth)?
    ///     .with_stencil(&mut stencil)?;
    /// frame.clear_stencil(1);
    /// assert_eq!(stencil, [1; 12]);
    ///
    /// let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(4, 3))?;
    /// let error = frame.with_stencil(&mut stencil[1..]).err();
    /// assert_eq!(error, Some(FrameError::Stencil { needed: 12, got: 11 }));
    /// # Ok::<(), FrameError>(())
    /// ```
    ///
    /// # Errors
    /// Fewer values than width x height.
    pub fn with_stencil(
        self,
        values: &'a mut [u8],
    ) -> Result<Frame<'a, F, StencilBuffer<'a, D>>, FrameError> {
        let stride = self.size.width.into();
        self.with_stencil_stride(values, stride)
    }

    /// The same frame with a stencil buffer whose rows start `stride` values apart.
    ///
    /// # Errors
    /// As [`with_stencil`](Self::with_stencil), and a stride shorter than the width.
    pub fn with_stencil_stride(
        self,
        values: &'a mut [u8],
        stride: u32,
    ) -> Result<Frame<'a, F, StencilBuffer<'a, D>>, FrameError> {
        check_stride(self.size, stride)?;
        let needed = needed(self.size, stride);
        if length(values) < needed {
            return Err(FrameError::Stencil { needed, got: length(values) });
        }
        let Self { pixels, depth, size, first_row, picture_height, scissor, .. } = self;
        Ok(Frame {
            pixels,
            depth: StencilBuffer { depth, values, stride: stride as usize },
            stride: self.stride,
            size,
            first_row,
            picture_height,
            scissor,
        })
    }
}

impl<F: Format, D> Frame<'_, F, StencilBuffer<'_, D>> {
    /// Sets the stencil value of all pixels in the scissor.
    pub fn clear_stencil(&mut self, value: u8) {
        let area = self.held_scissor();
        let StencilBuffer { values, stride, .. } = &mut self.depth;
        clear_cells(values, *stride, area, |cells| cells.fill(value));
    }
}

impl<F: Format> Frame<'_, F, StencilBuffer<'_, NoDepth>> {
    /// Sets the colour of all pixels in the scissor, and their stencil values to 0.
    pub fn clear(&mut self, color: impl Into<Color>) {
        self.clear_color(color);
        self.clear_stencil(0);
    }
}

impl<'a, F: Format> Frame<'_, F, StencilBuffer<'_, DepthBuffer<'a>>> {
    /// Sets the colour of all pixels in the scissor, their depth to 0, the farthest, and their
    /// stencil values to 0.
    pub fn clear(&mut self, color: impl Into<Color>) {
        self.clear_color(color);
        self.clear_depth(0);
        self.clear_stencil(0);
    }

    /// Sets the depth code of all pixels in the scissor: 0 is farthest, 65535 nearest.
    pub fn clear_depth(&mut self, code: u16) {
        let area = self.held_scissor();
        clear_codes(&mut self.depth.depth, area, code);
    }
}
