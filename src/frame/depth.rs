use core::ops::Range;
use core::slice::{Iter, IterMut};

/// A frame without depth: no field, no branch, no cycle.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NoDepth;

/// The caller's 16-bit depth codes, one a pixel: larger is nearer, 0 is farthest.
#[derive(Debug)]
pub struct DepthBuffer<'a> {
    pub(super) codes: &'a mut [u16],
    pub(super) stride: usize,
}

/// What a pass touches beside colours: nothing ([`Untouched`]), depth ([`ReadWrite`]), or stencil
/// values too ([`WithStencil`](super::WithStencil)).
///
/// It gives the type of one row of cells, which the pixel loop walks beside the colours.
pub trait DepthAccess {
    /// Whether anything is touched at all.
    const TOUCHES: bool;
    /// Whether depth is.
    const HAS_DEPTH: bool;
    /// Whether stencil values are.
    const HAS_STENCIL: bool;
    /// A row of cells.
    type Cells<'a>;
    /// What one pixel has.
    type Cell<'a>;
    /// Walks a row.
    type Iter<'a>: Iterator<Item = Self::Cell<'a>>;

    /// So many cells of a row from number `from` on; `None` where there are fewer.
    fn part<'a>(
        cells: &'a mut Self::Cells<'_>,
        from: usize,
        length: usize,
    ) -> Option<Self::Cells<'a>>;
    /// The same of a range, which is checked in one step where the compiler knows its order.
    #[inline(always)]
    fn range<'a>(cells: &'a mut Self::Cells<'_>, range: Range<usize>) -> Option<Self::Cells<'a>> {
        Self::part(cells, range.start, range.len())
    }
    /// One cell, as a row of its own.
    fn one<'a>(cells: &'a mut Self::Cells<'_>, at: usize) -> Option<Self::Cells<'a>>;

    /// How many there are; `usize::MAX` of what is not touched.
    fn length(cells: &Self::Cells<'_>) -> usize;

    /// The row as codes, where cells are nothing else.
    #[inline(always)]
    fn codes<'a>(cells: Self::Cells<'a>) -> Result<&'a mut [u16], Self::Cells<'a>> {
        Err(cells)
    }

    /// The walk over a row.
    fn iter<'a>(cells: Self::Cells<'a>) -> Self::Iter<'a>;
    /// The stored code.
    fn read<'a>(cell: &Self::Cell<'a>) -> u16;
    /// Stores a code.
    fn write<'a>(cell: Self::Cell<'a>, code: u16);
}

/// The pass neither reads nor writes depth.
#[derive(Clone, Copy, Debug, Default)]
pub struct Untouched;

/// The pass reads and may write depth.
#[derive(Clone, Copy, Debug, Default)]
pub struct ReadWrite;

/// Cells of nothing, more than any row has: a slice, so that the compiler knows the end of a walk
/// over it and another slice from the beginning.
const ENDLESS: &[()] = &[(); usize::MAX];

impl DepthAccess for Untouched {
    const TOUCHES: bool = false;
    const HAS_DEPTH: bool = false;
    const HAS_STENCIL: bool = false;
    type Cells<'a> = ();
    type Cell<'a> = &'a ();
    type Iter<'a> = Iter<'a, ()>;

    #[inline(always)]
    fn one((): &mut Self::Cells<'_>, _at: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn part((): &mut Self::Cells<'_>, _from: usize, _length: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn length((): &Self::Cells<'_>) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn iter<'a>((): Self::Cells<'a>) -> Self::Iter<'a> {
        ENDLESS.iter()
    }

    #[inline(always)]
    fn read<'a>(_cell: &Self::Cell<'a>) -> u16 {
        0
    }

    #[inline(always)]
    fn write<'a>(_cell: Self::Cell<'a>, _code: u16) {}
}

impl DepthAccess for ReadWrite {
    const TOUCHES: bool = true;
    const HAS_DEPTH: bool = true;
    const HAS_STENCIL: bool = false;
    type Cells<'a> = &'a mut [u16];
    type Cell<'a> = &'a mut u16;
    type Iter<'a> = IterMut<'a, u16>;

    #[inline(always)]
    fn one<'a>(cells: &'a mut Self::Cells<'_>, at: usize) -> Option<&'a mut [u16]> {
        cells.get_mut(at).map(core::slice::from_mut)
    }

    #[inline(always)]
    fn part<'a>(
        cells: &'a mut Self::Cells<'_>,
        from: usize,
        length: usize,
    ) -> Option<&'a mut [u16]> {
        cells.get_mut(from..)?.get_mut(..length)
    }

    #[inline(always)]
    fn range<'a>(cells: &'a mut Self::Cells<'_>, range: Range<usize>) -> Option<&'a mut [u16]> {
        cells.get_mut(range)
    }

    #[inline(always)]
    fn length(cells: &Self::Cells<'_>) -> usize {
        cells.len()
    }

    #[inline(always)]
    fn codes<'a>(cells: Self::Cells<'a>) -> Result<&'a mut [u16], Self::Cells<'a>> {
        Ok(cells)
    }

    #[inline(always)]
    fn iter<'a>(cells: Self::Cells<'a>) -> Self::Iter<'a> {
        cells.iter_mut()
    }

    #[inline(always)]
    fn read<'a>(cell: &Self::Cell<'a>) -> u16 {
        **cell
    }

    #[inline(always)]
    fn write<'a>(cell: Self::Cell<'a>, code: u16) {
        *cell = code;
    }
}

/// What a frame can give to a pass: a frame with depth serves every pass without a stencil, one
/// without depth serves those that do not touch it. A pass with a depth test on a frame without
/// depth does not compile, nor does one with a stencil on a frame without that.
pub trait Supplies<A: DepthAccess> {
    /// `length` columns of held row `row` from `left` on; `None` where the buffer does not reach.
    fn cells(&mut self, row: usize, left: usize, length: usize) -> Option<A::Cells<'_>>;

    /// All cells.
    fn all(&mut self) -> A::Cells<'_>;

    /// The first cells, so many of them, whatever rows they are in; `None` where there are fewer.
    fn run(&mut self, length: usize) -> Option<A::Cells<'_>>;

    /// How many cells there are; `usize::MAX` of what is not touched.
    fn length(&self) -> usize;

    /// Whether rows start so many cells apart.
    fn has_stride(&self, stride: usize) -> bool;
}

impl Supplies<Untouched> for NoDepth {
    #[inline(always)]
    fn cells(&mut self, _row: usize, _left: usize, _length: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn all(&mut self) {}

    #[inline(always)]
    fn run(&mut self, _length: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn length(&self) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn has_stride(&self, _stride: usize) -> bool {
        true
    }
}

impl Supplies<Untouched> for DepthBuffer<'_> {
    #[inline(always)]
    fn cells(&mut self, _row: usize, _left: usize, _length: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn all(&mut self) {}

    #[inline(always)]
    fn run(&mut self, _length: usize) -> Option<()> {
        Some(())
    }

    #[inline(always)]
    fn length(&self) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn has_stride(&self, _stride: usize) -> bool {
        true
    }
}

impl Supplies<ReadWrite> for DepthBuffer<'_> {
    #[inline(always)]
    fn cells(&mut self, row: usize, left: usize, length: usize) -> Option<&mut [u16]> {
        let start = row.wrapping_mul(self.stride).wrapping_add(left);
        self.codes.get_mut(start..start.wrapping_add(length))
    }

    #[inline(always)]
    fn all(&mut self) -> &mut [u16] {
        self.codes
    }

    #[inline(always)]
    fn run(&mut self, length: usize) -> Option<&mut [u16]> {
        self.codes.get_mut(..length)
    }

    #[inline(always)]
    fn length(&self) -> usize {
        self.codes.len()
    }

    #[inline(always)]
    fn has_stride(&self, stride: usize) -> bool {
        self.stride == stride
    }
}
