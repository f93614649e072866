use super::cache::{slot, Entry};
use super::clipper::Fan;
use super::mapping::Mapping;
use super::projected::{flag, Projected};
use super::transform::Transform;
use super::{Clip, CulledWindings};
use crate::frame::Rect;
use crate::raster::{area_of_sides, Triangle};
use crate::scene::Topology;
use crate::shade::{Counter, Event};

/// Where positions in clip space come from.
pub(super) trait Positions {
    /// The position of a vertex; `None` where there is none.
    fn clip(&self, index: u32) -> Option<Clip>;
}

/// Positions of a mesh through a transform: one copy for every shader that leaves them to the mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct MeshPositions<'a> {
    pub(super) transform: &'a Transform,
    pub(super) positions: &'a [[i16; 3]],
}

impl Positions for MeshPositions<'_> {
    #[inline(always)]
    fn clip(&self, index: u32) -> Option<Clip> {
        self.positions.get(index as usize).map(|position| self.transform.apply(position))
    }
}

/// A triangle to be drawn: one of the mesh's, or a piece of one that was clipped.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// Its number in the mesh.
    pub(super) number: u32,
    /// Its vertices' numbers: in the triangle's order, a piece's in the mesh's.
    pub(super) vertices: [u32; 3],
    /// On the screen, oriented.
    pub(super) triangle: Triangle,
    /// Whether this is a piece.
    pub(super) clipped: bool,
    /// Whether a piece of the mesh's triangle covered a pixel.
    pub(super) covered: bool,
}

impl Face {
    /// None yet.
    pub(super) const NONE: Self = Self {
        number: 0,
        vertices: [0; 3],
        triangle: Triangle::EMPTY,
        clipped: false,
        covered: false,
    };
}

/// Goes through a mesh's triangles, leaves out what cannot be seen, clips, and hands out the rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Assembly<T: Topology> {
    pub(super) topology: T,
    pub(super) cursor: T::Cursor,
    pub(super) mapping: Mapping,
    /// What is drawn of the picture.
    pub(super) area: Rect,
    pub(super) culled: CulledWindings,
    /// The pieces of a clipped triangle.
    pub(super) fan: Fan,
}

/// Transforms a vertex and keeps it. Apart, so that it is there once for a triangle's corners.
#[inline(never)]
fn keep<P: Positions>(entry: &mut Entry, index: u32, positions: &P, mapping: &Mapping) {
    let vertex = positions.clip(index).map_or(Projected::INVALID, |clip| mapping.project(&clip));
    entry.keep(index, vertex);
}

/// A vertex, from the cache or made for it.
#[inline(always)]
pub(super) fn vertex<P: Positions>(
    cache: &mut [Entry],
    index: u32,
    positions: &P,
    mapping: &Mapping,
) -> Projected {
    let Some(entry) = cache.get_mut(slot(index, cache.len())) else {
        return Projected::INVALID;
    };
    if !entry.holds(index) {
        keep(entry, index, positions, mapping);
    }
    entry.vertex
}

impl<T: Topology<Primitive = [u32; 3]>> Assembly<T> {
    /// The next triangle that may be seen; whether there is one.
    ///
    /// # Cost
    /// About 70 instructions for a triangle whose vertices are known and that is culled.
    #[inline(never)]
    pub(super) fn next<P: Positions, C: Counter>(
        &mut self,
        positions: &P,
        cache: &mut [Entry],
        counter: &mut C,
        face: &mut Face,
    ) -> bool {
        if face.clipped {
            if self.fan.next(&mut face.triangle) {
                return true;
            }
            counter.event(if face.covered { Event::Drawn } else { Event::Outside });
            face.clipped = false;
        }
        while let Some((number, vertices)) = self.topology.next::<false>(&mut self.cursor) {
            counter.event(Event::Triangle);
            let mapping = &self.mapping;
            let [a, b, c] = vertices.map(|index| vertex(cache, index, positions, mapping));
            let any = a.flags | b.flags | c.flags;
            if any != 0 {
                if any & flag::INVALID != 0 {
                    counter.event(Event::Skipped);
                    continue;
                }
                if a.flags & b.flags & c.flags & flag::OUTSIDE != 0 {
                    counter.event(Event::Outside);
                    continue;
                }
                if any & flag::CLIP != 0 {
                    let Some(event) = self.clip(positions, vertices) else {
                        counter.event(Event::Skipped);
                        continue;
                    };
                    counter.event(Event::Clipped);
                    if event != Event::Clipped {
                        counter.event(event);
                        continue;
                    }
                    face.number = number;
                    face.vertices = vertices;
                    (face.clipped, face.covered) = (true, false);
                    if self.fan.next(&mut face.triangle) {
                        return true;
                    }
                    counter.event(Event::Outside);
                    face.clipped = false;
                    continue;
                }
            }
            let side = |to: i16, from: i16| i32::from(to).wrapping_sub(from.into());
            let area =
                area_of_sides(side(b.x, a.x), side(b.y, a.y), side(c.x, a.x), side(c.y, a.y));
            if area == 0 {
                counter.event(Event::Degenerate);
                continue;
            }
            if self.culled.contain(area) {
                counter.event(Event::Culled);
                continue;
            }
            face.number = number;
            let [i, j, k] = vertices;
            let (v, numbers) =
                if area > 0 { ([a, b, c], [i, j, k]) } else { ([a, c, b], [i, k, j]) };
            face.vertices = numbers;
            face.triangle = Triangle {
                v: v.map(|vertex| mapping.place(&vertex)),
                area: area.wrapping_abs(),
                flipped: area < 0,
            };
            return true;
        }
        false
    }

    /// Cuts a triangle into the fan's pieces, to be taken where this says
    /// [`Clipped`](Event::Clipped); otherwise it says what became of it. `None` if a vertex is not
    /// there.
    #[inline(never)]
    fn clip<P: Positions>(&mut self, positions: &P, vertices: [u32; 3]) -> Option<Event> {
        self.fan.cut(&self.mapping, |index| positions.clip(index), &vertices)?;
        Some(if self.fan.is_empty() {
            Event::Outside
        } else if self.fan.area == 0 {
            Event::Degenerate
        } else if self.culled.contain(self.fan.area) {
            Event::Culled
        } else {
            Event::Clipped
        })
    }
}
