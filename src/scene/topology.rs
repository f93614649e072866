/// Which vertices make a triangle: a [`List`], an [`IndexedList`], or one of them chosen when the
/// program runs.
///
/// A type and no flag: a program contains the code of those that its meshes have.
pub trait Topology: Copy {
    /// How many triangles there are; at most `u32::MAX`.
    fn triangles(&self) -> u32;

    /// The vertices of a triangle; `None` behind the last.
    fn triangle(&self, number: u32) -> Option<[u32; 3]>;
}

/// Three vertices after the other make a triangle: none is shared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct List {
    triangles: u32,
}

impl List {
    /// The list of as many vertices; one or two that are left over make no triangle.
    pub const fn new(vertices: usize) -> Self {
        Self { triangles: saturated(vertices / 3) }
    }
}

impl Topology for List {
    #[inline(always)]
    fn triangles(&self) -> u32 {
        self.triangles
    }

    #[inline(always)]
    fn triangle(&self, number: u32) -> Option<[u32; 3]> {
        (number < self.triangles).then(|| {
            let first = number.wrapping_mul(3);
            [first, first.wrapping_add(1), first.wrapping_add(2)]
        })
    }
}

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
    #[inline(always)]
    fn triangles(&self) -> u32 {
        saturated(self.triples.len())
    }

    #[inline(always)]
    fn triangle(&self, number: u32) -> Option<[u32; 3]> {
        self.triples.get(number as usize).map(|three| three.map(Into::into))
    }
}

/// Any topology, chosen when the program runs: for host tools, and for scenes that are data.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyTopology<'a> {
    /// As [`List`].
    List(List),
    /// As [`IndexedList`] of 8 bits.
    Indexed8(IndexedList<'a, u8>),
    /// As [`IndexedList`] of 16 bits.
    Indexed16(IndexedList<'a, u16>),
}

impl Topology for AnyTopology<'_> {
    fn triangles(&self) -> u32 {
        match self {
            Self::List(list) => list.triangles(),
            Self::Indexed8(list) => list.triangles(),
            Self::Indexed16(list) => list.triangles(),
        }
    }

    fn triangle(&self, number: u32) -> Option<[u32; 3]> {
        match self {
            Self::List(list) => list.triangle(number),
            Self::Indexed8(list) => list.triangle(number),
            Self::Indexed16(list) => list.triangle(number),
        }
    }
}

/// A number of triangles, as far as 32 bits count.
#[allow(clippy::cast_possible_truncation, reason = "compared just before")]
const fn saturated(triangles: usize) -> u32 {
    if triangles > u32::MAX as usize {
        u32::MAX
    } else {
        triangles as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_over_makes_no_triangle() {
        for vertices in 0..9 {
            let list = List::new(vertices);
            assert_eq!(list.triangles() as usize, vertices / 3, "{vertices} vertices");
            assert_eq!(list.triangle(list.triangles()), None, "behind the last");
        }
        let indexed = IndexedList::new(&[7_u8, 8, 9, 1, 2]);
        assert_eq!((indexed.triangles(), indexed.triangle(0)), (1, Some([7, 8, 9])), "indexed");
        assert_eq!(indexed.triangle(1), None, "behind the last");
    }

    #[test]
    fn the_runtime_topology_agrees_with_the_types() {
        let (bytes, words) = ([3_u8, 1, 2, 0, 2, 1], [3_u16, 1, 2, 0, 2, 1]);
        let list = List::new(6);
        let (small, large) = (IndexedList::new(&bytes), IndexedList::new(&words));
        for number in 0..4 {
            let pairs = [
                (AnyTopology::List(list).triangle(number), list.triangle(number)),
                (AnyTopology::Indexed8(small).triangle(number), small.triangle(number)),
                (AnyTopology::Indexed16(large).triangle(number), large.triangle(number)),
            ];
            for (any, typed) in pairs {
                assert_eq!(any, typed, "triangle {number}");
            }
        }
    }
}
