use super::{Facing, PlaneScale, Topology};

/// The same primitives, where flat shading takes its colour from the last vertex of each: the
/// default of OpenGL, whereas the first is that of this crate, of Vulkan and of Direct3D.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LastProvoking<T>(pub T);

impl<T: Topology> Topology for LastProvoking<T> {
    type Primitive = T::Primitive;
    type Cursor = T::Cursor;

    const LAST_PROVOKES: bool = true;
    const LEAVES_OUT: bool = T::LEAVES_OUT;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut T::Cursor) -> Option<(u32, T::Primitive)> {
        self.0.next::<true>(cursor)
    }

    #[inline(always)]
    fn continues(&self, cursor: &T::Cursor) -> bool {
        self.0.continues(cursor)
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        self.0.count()
    }

    #[inline(always)]
    fn face(&mut self, facing: impl FnOnce(&PlaneScale) -> Facing) {
        self.0.face(facing);
    }

    #[inline(always)]
    fn skip_to(&self, cursor: &mut T::Cursor, number: u32) {
        self.0.skip_to(cursor, number);
    }
}
