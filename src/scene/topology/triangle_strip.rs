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
    /// Vertices since the beginning or the last restart, at most 2.
    held: u32,
    is_turned: bool,
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
            let [a, b] = cursor.before;
            cursor.before = [b, c];
            if cursor.held < 2 {
                (cursor.held, cursor.is_turned) = (cursor.held.wrapping_add(1), false);
                continue;
            }
            let is_turned = cursor.is_turned;
            cursor.is_turned = !is_turned;
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
