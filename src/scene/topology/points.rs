use super::{NumberCursor, Sequence, Step, Topology};

/// Each vertex is a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Points<S> {
    sequence: S,
}

impl<S> Points<S> {
    /// The points at these vertices.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for Points<S> {
    type Primitive = [u32; 1];
    type Cursor = NumberCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut NumberCursor) -> Option<(u32, [u32; 1])> {
        loop {
            if let Step::Vertex(a) = cursor.step(&self.sequence)? {
                return Some((cursor.number(), [a]));
            }
        }
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        if S::RESTARTS {
            self.iter().fold(0, |count: u32, _| count.saturating_add(1))
        } else {
            self.sequence.places()
        }
    }
}
