use super::{saturated, turned, Topology};

/// Three indices a triangle, of 8, 16 or 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct IndexedList<'a, I> {
    triples: &'a [[I; 3]],
}

impl<'a, I> IndexedList<'a, I> {
    /// The list of these indices; one or two that are left over make no triangle.
    pub const fn new(indices: &'a [I]) -> Self {
        Self { triples: indices.as_chunks().0 }
    }
}

impl<I: Copy + Into<u32>> Topology for IndexedList<'_, I> {
    type Primitive = [u32; 3];
    type Cursor = u32;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut u32) -> Option<(u32, [u32; 3])> {
        let number = *cursor;
        self.triples.get(number as usize).map(|three| {
            *cursor = number.wrapping_add(1);
            (number, turned::<LAST>(three.map(Into::into)))
        })
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        saturated(self.triples.len())
    }

    #[inline(always)]
    fn skip_to(&self, cursor: &mut u32, number: u32) {
        *cursor = number;
    }
}
