use super::{NumberCursor, Sequence, Step, Topology};

/// Each vertex makes a line with the one before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineStrip<S> {
    sequence: S,
}

/// How far one is in a [`LineStrip`].
#[derive(Clone, Copy, Debug, Default)]
pub struct LineStripCursor {
    place: NumberCursor,
    before: Option<u32>,
    continues: bool,
}

impl<S> LineStrip<S> {
    /// The line through these vertices; one alone makes none.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for LineStrip<S> {
    type Primitive = [u32; 2];
    type Cursor = LineStripCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut LineStripCursor) -> Option<(u32, [u32; 2])> {
        // From what the line before left behind.
        cursor.continues = cursor.before.is_some();
        loop {
            let Step::Vertex(b) = cursor.place.step(&self.sequence)? else {
                (cursor.before, cursor.continues) = (None, false);
                continue;
            };
            if let Some(a) = cursor.before.replace(b) {
                return Some((cursor.place.number(), [a, b]));
            }
        }
    }

    #[inline(always)]
    fn continues(&self, cursor: &LineStripCursor) -> bool {
        cursor.continues
    }
}
