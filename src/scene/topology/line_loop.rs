use super::{NumberCursor, Sequence, Step, Topology};

/// Each vertex makes a line with the one before it, and the last one a line to the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LineLoop<S> {
    sequence: S,
}

/// How far one is in a [`LineLoop`].
#[derive(Clone, Copy, Debug, Default)]
pub struct LoopCursor {
    place: NumberCursor,
    /// The first vertex and the latest.
    ends: Option<[u32; 2]>,
    /// Whether there is a line already.
    is_open: bool,
    continues: bool,
}

impl<S> LineLoop<S> {
    /// The loop through these vertices; two make two lines, there and back, and one makes none.
    pub const fn new(sequence: S) -> Self {
        Self { sequence }
    }
}

impl<S: Sequence> Topology for LineLoop<S> {
    type Primitive = [u32; 2];
    type Cursor = LoopCursor;

    #[inline(always)]
    fn next<const LAST: bool>(&self, cursor: &mut LoopCursor) -> Option<(u32, [u32; 2])> {
        loop {
            let step = cursor.place.step(&self.sequence);
            if let Some(Step::Vertex(b)) = step {
                let [first, a] = cursor.ends.unwrap_or([b, b]);
                let is_first = cursor.ends.replace([first, b]).is_none();
                if is_first {
                    continue;
                }
                cursor.continues = core::mem::replace(&mut cursor.is_open, true);
                return Some((cursor.place.number(), [a, b]));
            }
            // A restart, or the end.
            let ends = cursor.ends.take();
            if core::mem::take(&mut cursor.is_open) {
                if let Some([first, last]) = ends {
                    cursor.continues = true;
                    return Some((cursor.place.number(), [last, first]));
                }
            }
            step?;
        }
    }

    #[inline(always)]
    fn continues(&self, cursor: &LoopCursor) -> bool {
        cursor.continues
    }
}
