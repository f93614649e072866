//! Which vertices make a primitive.

mod any;
mod face_planes;
mod indexed_list;
mod last_provoking;
mod line_list;
mod line_loop;
mod line_strip;
mod list;
mod points;
mod sequence;
#[cfg(test)]
mod tests;
mod triangle_fan;
mod triangle_strip;
mod with_planes;

pub use any::{AnyCursor, AnyTopology};
pub use face_planes::{FacePlane, FacePlanes, PlaneScale};
pub use indexed_list::IndexedList;
pub use last_provoking::LastProvoking;
pub use line_list::LineList;
pub use line_loop::{LineLoop, LoopCursor};
pub use line_strip::{LineStrip, LineStripCursor};
pub use list::List;
pub use points::Points;
pub use sequence::{Consecutive, Index, Indices, NumberCursor, RestartIndices, Sequence, Step};
pub use triangle_fan::{FanCursor, TriangleFan};
pub use triangle_strip::{StripCursor, TriangleStrip};
pub use with_planes::{Facing, PlaneCursor, WithPlanes};

/// Which vertices make the primitives of a mesh: triangles, lines or points.
///
/// Of triangles [`List`], [`IndexedList`], [`TriangleStrip`] and [`TriangleFan`]; of lines
/// [`LineList`], [`LineStrip`] and [`LineLoop`]; and [`Points`]. Those that are no plain lists take
/// their vertices from a [`Sequence`], with or without indices. [`AnyTopology`] is a triangle
/// topology chosen when the program runs.
///
/// A type and no flag: a program contains the code of those that its meshes have.
///
/// ```
/// use microraster::{Indices, Topology, TriangleStrip};
///
/// let strip = TriangleStrip::new(Indices::new(&[4_u8, 5, 6, 7]));
/// let triangles: Vec<_> = strip.iter().collect();
/// // Both run the same way round.
/// assert_eq!(triangles, [[4, 5, 6], [5, 7, 6]]);
/// ```
///
/// # The provoking vertex
/// The one from which flat shading takes its colour is that of OpenGL 4.6, table 13.2, in the
/// convention of the first vertex; [`LastProvoking`] turns to the other. A triangle comes with it
/// in front, turned as the mesh has it.
pub trait Topology: Copy {
    /// The vertices of a primitive: `[u32; 3]` of triangles, `[u32; 2]` of lines, `[u32; 1]` of
    /// points.
    type Primitive: Copy;
    /// How far one is.
    type Cursor: Copy + Default + core::fmt::Debug;

    /// Whether of a line the last vertex provokes. Triangles have the provoking one in front.
    const LAST_PROVOKES: bool = false;

    /// Whether a draw may get a triangle's number that does not follow the one before: those between show the side
    /// that is left out.
    #[doc(hidden)]
    const LEAVES_OUT: bool = false;

    /// The next primitive and its number; `None` behind the last. `LAST` puts the vertex in front
    /// that provokes by the convention of the last vertex.
    fn next<const LAST: bool>(&self, cursor: &mut Self::Cursor) -> Option<(u32, Self::Primitive)>;

    /// Whether the line that came last goes on where the one before it ended.
    #[inline(always)]
    fn continues(&self, _cursor: &Self::Cursor) -> bool {
        false
    }

    /// How many primitives there are, as far as 32 bits count.
    ///
    /// # Cost
    /// Strips, fans and loops are walked.
    fn count(&self) -> u32 {
        self.iter().fold(0, |count: u32, _| count.saturating_add(1))
    }

    /// Leaves out triangles of a draw, as `facing` says of planes with a scale.
    #[doc(hidden)]
    #[inline(always)]
    fn face(&mut self, _facing: impl FnOnce(&PlaneScale) -> Facing) {}

    /// Goes on with primitive `number`, which is not behind the next one.
    #[doc(hidden)]
    #[inline]
    fn skip_to(&self, cursor: &mut Self::Cursor, number: u32) {
        let mut ahead = *cursor;
        while self.next::<false>(&mut ahead).is_some_and(|(passed, _)| passed < number) {
            *cursor = ahead;
        }
    }

    /// All primitives, one after the other.
    #[inline]
    fn iter(&self) -> impl Iterator<Item = Self::Primitive> {
        let (topology, mut cursor) = (*self, Self::Cursor::default());
        core::iter::from_fn(move || {
            topology.next::<false>(&mut cursor).map(|(_, primitive)| primitive)
        })
    }
}

/// A number of primitives, as far as 32 bits count.
#[allow(clippy::cast_possible_truncation, reason = "compared just before")]
const fn saturated(primitives: usize) -> u32 {
    if primitives > u32::MAX as usize {
        u32::MAX
    } else {
        primitives as u32
    }
}

/// A triangle whose last vertex came last, with the provoking one in front.
#[inline(always)]
const fn turned<const LAST: bool>([a, b, c]: [u32; 3]) -> [u32; 3] {
    if LAST {
        [c, a, b]
    } else {
        [a, b, c]
    }
}
