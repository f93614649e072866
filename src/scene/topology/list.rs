use super::{saturated, turned, Topology};

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
    type Primitive = [u32; 3];
    type Cursor = u32;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut u32) -> Option<(u32, [u32; 3])> {
        let number = *cursor;
        (number < self.triangles).then(|| {
            *cursor = number.wrapping_add(1);
            let first = number.wrapping_mul(3);
            (number, turned::<LAST>([first, first.wrapping_add(1), first.wrapping_add(2)]))
        })
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        self.triangles
    }

    #[inline(always)]
    fn skip_to(&self, cursor: &mut u32, number: u32) {
        *cursor = number;
    }
}
