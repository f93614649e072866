use super::{NumberCursor, Sequence, Step, Topology};

/// Each vertex makes a triangle with the two before it, every other one turned so that all of them
/// run the same way round.
///
/// # The provoking vertex
/// Of triangle i vertex i of the strip, by the convention of the last vertex i + 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TriangleStrip<S> {
    sequence: S,
}

/// How far one is in a [`TriangleStrip`].
#[derive(Clone, Copy, Debug, Default)]
pub struct StripCursor {
    place: NumberCursor,
    /// Vertices since the beginning or the last restart.
    held: u32,
    before: [u32; 2],
}

impl<S> TriangleStrip<S> {
    /// The strip through these vertices; one or two alone make no triangle.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for TriangleStrip<S> {
    type Primitive = [u32; 3];
    type Cursor = StripCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut StripCursor) -> Option<(u32, [u32; 3])> {
        loop {
            let Step::Vertex(c) = cursor.place.step(&self.sequence)? else {
                cursor.held = 0;
                continue;
            };
            let ([a, b], held) = (cursor.before, cursor.held);
            cursor.before = [b, c];
            cursor.held = held.wrapping_add(1);
            if held < 2 {
                continue;
            }
            if held == u32::MAX {
                // On, with the same turn.
                cursor.held = u32::MAX - 1;
            }
            let is_turned = held & 1 != 0;
            let triangle = match (LAST, is_turned) {
                (false, false) => [a, b, c],
                (false, true) => [a, c, b],
                (true, false) => [c, a, b],
                (true, true) => [c, b, a],
            };
            return Some((cursor.place.number(), triangle));
        }
    }
}
