use super::{ColorOutput, Counter, DepthTest, Off, Output, Uncounted};
use crate::raster::{Scanline, Traversal};

/// The state that changes the pixel loop, gathered in one type parameter.
pub trait State {
    /// The depth test.
    type Depth: DepthTest;
    /// What counts, if anything does.
    type Counter: Counter;
    /// How the pixels of a triangle are found.
    type Traversal: Traversal;
    /// What becomes of a fragment's colour.
    type Output: ColorOutput;

    /// How the pixels of a triangle are found.
    fn traversal(&self) -> Self::Traversal;

    /// What the loop reads (test and output) and what it writes (counter), at once.
    fn parts(&mut self) -> (&Self::Depth, &Self::Output, &mut Self::Counter);

    /// What counts.
    #[inline(always)]
    fn counter(&mut self) -> &mut Self::Counter {
        self.parts().2
    }
}

/// The state of a [`Pass`](crate::Pass): each setting is a type, and one that is not named costs
/// nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct States<D = Off, C = Uncounted, T = Scanline, O = Output> {
    /// The depth test.
    pub depth: D,
    /// What counts.
    pub counter: C,
    /// How the pixels of a triangle are found.
    pub traversal: T,
    /// What becomes of a fragment's colour.
    pub output: O,
}

impl<D, C, T, O> States<D, C, T, O> {
    /// The same with another output.
    pub(crate) fn map_output<N>(self, change: impl FnOnce(O) -> N) -> States<D, C, T, N> {
        let Self { depth, counter, traversal, output } = self;
        States { depth, counter, traversal, output: change(output) }
    }
}

impl<D: DepthTest, C: Counter, T: Traversal, O: ColorOutput> State for States<D, C, T, O> {
    type Depth = D;
    type Counter = C;
    type Traversal = T;
    type Output = O;

    #[inline(always)]
    fn traversal(&self) -> T {
        self.traversal
    }

    #[inline(always)]
    fn parts(&mut self) -> (&D, &O, &mut C) {
        (&self.depth, &self.output, &mut self.counter)
    }
}
