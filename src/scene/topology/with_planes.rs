use super::{saturated, FacePlane, FacePlanes, PlaneScale, Topology};
use crate::math::leading_zeros;

/// Where a mesh is seen from, as its [`FacePlanes`] are asked: made once a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facing {
    /// The eye, or the direction towards it, with a fourth coordinate in 65536ths of a step; in units of which it has
    /// 20 bits.
    eye: [i32; 4],
    /// Added to a plane's bytes times the eye: what is not less than zero then certainly shows the side that is left
    /// out.
    added: i32,
}

impl Facing {
    /// Leaves out nothing.
    pub(crate) const NONE: Self = Self { eye: [0; 4], added: -1 };

    /// The largest coordinate of an eye.
    pub(crate) const FARTHEST: i32 = 1 << 20;

    /// Leaves out the triangles of which the product of plane and eye is at least this; coordinates are
    /// at most [`FARTHEST`](Self::FARTHEST).
    pub(crate) fn new(eye: [i32; 4], least: i32) -> Self {
        debug_assert!(eye.iter().all(|v| v.abs() <= Self::FARTHEST), "{eye:?}");
        // Bytes are 128 above their values.
        let raised = eye.iter().fold(0, |sum: i32, v| sum.wrapping_add(*v)).wrapping_shl(7);
        Self { eye, added: least.wrapping_add(raised).wrapping_neg() }
    }

    /// 1 for a triangle that may be seen, else 0.
    #[inline(always)]
    const fn shows(&self, [a, b, c, d]: &FacePlane) -> u32 {
        let Self { eye: [x, y, z, w], added } = self;
        let sum = (*a as i32)
            .wrapping_mul(*x)
            .wrapping_add(*added)
            .wrapping_add((*b as i32).wrapping_mul(*y))
            .wrapping_add((*c as i32).wrapping_mul(*z))
            .wrapping_add((*d as i32).wrapping_mul(*w));
        sum.cast_unsigned() >> 31
    }

    /// Whether a triangle certainly shows the side that is left out.
    #[cfg(test)]
    pub(crate) const fn leaves_out(&self, plane: &FacePlane) -> bool {
        self.shows(plane) == 0
    }

    /// Which of up to [`BLOCK`] triangles may be seen, the first in the highest bit; of those behind the last plane all
    /// may.
    #[inline(never)]
    fn block(&self, planes: &[FacePlane]) -> u32 {
        let shown = planes.iter().fold(0, |shown: u32, plane| {
            // Not unrolled, which spills.
            core::hint::black_box(());
            shown << 1 | self.shows(plane)
        });
        let known = saturated(planes.len());
        let behind = u32::MAX.checked_shr(known).unwrap_or(0);
        shown.checked_shl(BLOCK.wrapping_sub(known)).unwrap_or(0) | behind
    }
}

/// Triangles whose planes are asked at a time: the bits of a word.
const BLOCK: u32 = 32;

const _: () = assert!(Facing::FARTHEST * 255 < 1 << 28, "products of a plane and an eye");

/// Triangles that have planes: what [`Mesh::with_planes`](crate::Mesh::with_planes) makes of a topology.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WithPlanes<'a, T> {
    topology: T,
    planes: FacePlanes<'a>,
    facing: Facing,
}

impl<'a, T> WithPlanes<'a, T> {
    /// These triangles with these planes.
    pub const fn new(topology: T, planes: FacePlanes<'a>) -> Self {
        Self { topology, planes, facing: Facing::NONE }
    }
}

impl<T: Topology<Primitive = [u32; 3]>> Topology for WithPlanes<'_, T> {
    type Primitive = [u32; 3];
    type Cursor = PlaneCursor<T::Cursor>;

    const LAST_PROVOKES: bool = T::LAST_PROVOKES;
    const LEAVES_OUT: bool = true;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut Self::Cursor) -> Option<(u32, [u32; 3])> {
        let PlaneCursor { inner, shown, first } = cursor;
        loop {
            if *shown != 0 {
                let ahead = leading_zeros(*shown);
                *shown ^= (1 << 31_u32) >> (ahead & 31);
                self.topology.skip_to(inner, first.wrapping_sub(BLOCK).wrapping_add(ahead));
                return self.topology.next::<LAST>(inner);
            }
            let planes = self.planes.planes.get(*first as usize..).unwrap_or_default();
            *first = first.wrapping_add(BLOCK);
            *shown = self.facing.block(planes.get(..BLOCK as usize).unwrap_or(planes));
        }
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        self.topology.count()
    }

    #[inline(always)]
    fn face(&mut self, facing: impl FnOnce(&PlaneScale) -> Facing) {
        self.facing = facing(&self.planes.scale);
    }
}

/// How far one is in [`WithPlanes`].
#[derive(Clone, Copy, Debug, Default)]
pub struct PlaneCursor<C> {
    inner: C,
    /// Which of this block's triangles come still, its first in the highest bit.
    shown: u32,
    /// The number of the next block's first triangle.
    first: u32,
}
