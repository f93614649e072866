use super::{NumberCursor, Sequence, Step, Topology};

/// Each vertex makes a triangle with the one before it and the first.
///
/// # The provoking vertex
/// Of triangle i vertex i + 1 of the fan, by the convention of the last vertex i + 2: never the
/// first, which all share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleFan<S> {
    sequence: S,
}

/// How far one is in a [`TriangleFan`].
#[derive(Clone, Copy, Debug, Default)]
pub struct FanCursor {
    place: NumberCursor,
    /// Vertices since the beginning or the last restart, at most 2.
    held: u32,
    hub: u32,
    before: u32,
}

impl<S> TriangleFan<S> {
    /// The fan of these vertices; one or two alone make no triangle.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for TriangleFan<S> {
    type Primitive = [u32; 3];
    type Cursor = FanCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut FanCursor) -> Option<(u32, [u32; 3])> {
        loop {
            let Step::Vertex(c) = cursor.place.step(&self.sequence)? else {
                cursor.held = 0;
                continue;
            };
            if cursor.held == 0 {
                (cursor.hub, cursor.held) = (c, 1);
                continue;
            }
            let (hub, b) = (cursor.hub, cursor.before);
            cursor.before = c;
            if cursor.held == 1 {
                cursor.held = 2;
                continue;
            }
            let triangle = if LAST { [c, hub, b] } else { [b, c, hub] };
            return Some((cursor.place.number(), triangle));
        }
    }
}
