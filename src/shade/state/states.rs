use super::{Counter, DepthTest, Off, Uncounted};
use crate::raster::{Scanline, Traversal};

/// The state that changes the pixel loop, gathered in one type parameter.
pub trait State {
    /// The depth test.
    type Depth: DepthTest;
    /// What counts, if anything does.
    type Counter: Counter;
    /// How the pixels of a triangle are found.
    type Traversal: Traversal;

    /// How the pixels of a triangle are found.
    fn traversal(&self) -> Self::Traversal;

    /// Test and counter at once: the loop reads the one and writes the other.
    fn parts(&mut self) -> (&Self::Depth, &mut Self::Counter);
}

/// The state of a [`Pass`](crate::Pass): each setting is a type, and one that is not named costs
/// nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct States<D = Off, C = Uncounted, T = Scanline> {
    /// The depth test.
    pub depth: D,
    /// What counts.
    pub counter: C,
    /// How the pixels of a triangle are found.
    pub traversal: T,
}

impl<D: DepthTest, C: Counter, T: Traversal> State for States<D, C, T> {
    type Depth = D;
    type Counter = C;
    type Traversal = T;

    #[inline(always)]
    fn traversal(&self) -> T {
        self.traversal
    }

    #[inline(always)]
    fn parts(&mut self) -> (&D, &mut C) {
        (&self.depth, &mut self.counter)
    }
}
