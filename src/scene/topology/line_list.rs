use super::{NumberCursor, Sequence, Step, Topology};

/// Two vertices after the other make a line: none is shared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineList<S> {
    sequence: S,
}

impl<S> LineList<S> {
    /// The lines between these vertices; one that is left over makes no line.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for LineList<S> {
    type Primitive = [u32; 2];
    type Cursor = NumberCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut NumberCursor) -> Option<(u32, [u32; 2])> {
        loop {
            let Step::Vertex(a) = cursor.step(&self.sequence)? else { continue };
            // What is left over before a restart is forgotten.
            let Step::Vertex(b) = cursor.step(&self.sequence)? else { continue };
            return Some((cursor.number(), [a, b]));
        }
    }

    #[inline(always)]
    fn count(&self) -> u32 {
        if S::RESTARTS {
            self.iter().fold(0, |count: u32, _| count.saturating_add(1))
        } else {
            self.sequence.places() / 2
        }
    }
}
