use super::cache::{holds, kept, slot, Entry};
use super::clipper::{signed_area, Fan};
use super::mapping::Mapping;
use super::projected::{flag, Projected};
use super::transform::Transform;
use super::{Clip, CulledWindings};
use crate::frame::Rect;
use crate::math::HALVES_MULTIPLY;
use crate::raster::{area_of_sides, ScreenVertex, Triangle};
use crate::scene::{Facing, PlaneScale, Topology};
use crate::shade::{Counter, Event};

/// Where positions in clip space come from.
pub(super) trait Positions {
    /// The position of a vertex; `None` where there is none.
    fn clip(&self, index: u32) -> Option<Clip>;

    /// A vertex on the screen.
    fn projected(&self, index: u32, mapping: &Mapping) -> Projected;

    /// Where a vertex, which has this position in the mesh, lies as a point; what becomes of one that
    /// is not between the near and the far plane or has no place. `easy_w` is the mapping's.
    fn point(
        &self,
        index: u32,
        position: &[i16; 3],
        mapping: &Mapping,
        easy_w: i32,
    ) -> Result<ScreenVertex, Event>;

    /// From where planes of triangles are seen that were made with a scale.
    fn facing(&self, _mapping: &Mapping, _culled: CulledWindings, _scale: &PlaneScale) -> Facing {
        Facing::NONE
    }
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

    #[inline(always)]
    fn projected(&self, index: u32, mapping: &Mapping) -> Projected {
        match self.positions.get(index as usize) {
            Some(position) => mapping
                .project(self.transform.sides::<true>(position), || self.transform.z(position)),
            None => Projected::INVALID,
        }
    }

    #[inline(always)]
    fn point(
        &self,
        _index: u32,
        position: &[i16; 3],
        mapping: &Mapping,
        easy_w: i32,
    ) -> Result<ScreenVertex, Event> {
        let z = || self.transform.z(position);
        mapping
            .inlined_point(self.transform.sides::<false>(position), z, easy_w)
            .ok_or(Event::Outside)
    }

    fn facing(&self, mapping: &Mapping, culled: CulledWindings, scale: &PlaneScale) -> Facing {
        self.transform.facing(mapping, culled, scale)
    }
}

/// A triangle to be drawn: one of the mesh's, or a piece of one that was clipped.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// Its number in the mesh.
    pub(super) number: u32,
    /// Its vertices' numbers in the mesh's order.
    pub(super) vertices: [u32; 3],
    /// On the screen, oriented.
    pub(super) triangle: Triangle,
    /// What its vertices have all of: [`SHADED`](flag::SHADED) says that the cache holds the
    /// attributes of the three.
    pub(super) flags: u32,
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
        flags: 0,
        clipped: false,
        covered: false,
    };

    /// What belongs to the corners of the mesh's triangle, in the order of the one that is drawn;
    /// of a piece as it comes.
    #[inline(always)]
    pub(super) fn in_order<C: Copy>(&self, [a, b, c]: [C; 3]) -> [C; 3] {
        if self.triangle.flipped && !self.clipped {
            [a, c, b]
        } else {
            [a, b, c]
        }
    }

    /// Puts the triangle's corners in their places: the second and the third change them where it is
    /// turned.
    #[inline(always)]
    fn place(&mut self, mapping: &Mapping, [a, b, c]: &[Projected; 3], flipped: bool) {
        let (second, third) = (1 + usize::from(flipped), 2 - usize::from(flipped));
        let v = &mut self.triangle.v;
        v[0] = mapping.place(a);
        v[second] = mapping.place(b);
        v[third] = mapping.place(c);
        self.triangle.flipped = flipped;
        self.flags = a.flags() & b.flags() & c.flags();
    }
}

/// Goes through a mesh's triangles, leaves out what cannot be seen, clips, and hands out the rest.
#[derive(Clone, Copy, Debug)]
pub(super) struct Assembly<T: Topology> {
    pub(super) topology: T,
    pub(super) cursor: T::Cursor,
    pub(super) mapping: Mapping,
    /// What is drawn of the picture.
    pub(super) area: Rect,
    /// Whether that is all of the viewport, and taken as it is: then triangles in the view do not
    /// reach beyond it.
    pub(super) is_whole: bool,
    pub(super) culled: CulledWindings,
    /// The pieces of a clipped triangle.
    pub(super) fan: Fan,
    /// The number behind the last triangle that was counted, where some are left out.
    pub(super) next_number: u32,
}

/// Transforms a vertex and keeps it: in one piece, from the mesh's memory to the cache's.
///
/// # Cost
/// About 80 instructions on Cortex-M4 for a vertex in the view, 220 on Cortex-M0+.
#[inline(never)]
fn keep<P: Positions>(place: &mut [u32; 2], index: u32, positions: &P, mapping: &Mapping) {
    let Projected { xy, z_flags } = positions.projected(index, mapping);
    *place = [xy, z_flags];
}

/// A vertex, from the cache or made for it.
#[inline(always)]
pub(super) fn vertex<P: Positions>(
    cache: &mut [Entry],
    index: u32,
    positions: &P,
    mapping: &Mapping,
) -> Projected {
    let Some(place) = cache.get_mut(slot(index, cache.len())) else {
        return Projected::INVALID;
    };
    if !holds(place, index) {
        // Here, where the index is at hand: there it would wait in memory.
        let [of, vertex @ ..] = place;
        *of = index;
        keep(vertex, index, positions, mapping);
    }
    kept(place)
}

/// Twice the area of a triangle.
#[inline(always)]
pub(super) fn area_of([a, b, c]: &[Projected; 3]) -> i64 {
    let side = |to: i32, from: i32| to.wrapping_sub(from);
    area_of_sides(side(b.x(), a.x()), side(b.y(), a.y()), side(c.x(), a.x()), side(c.y(), a.y()))
}

/// The same of a triangle whose corners have no flag: they lie in a viewport that is not
/// [`LARGE`](flag::LARGE), so that what wraps of sums of products is right in the end.
#[inline(always)]
pub(super) fn area_in_view(corners: &[Projected; 3]) -> i32 {
    if HALVES_MULTIPLY {
        area_by_coordinates(corners)
    } else {
        area_by_sides(corners)
    }
}

/// The same by six products of coordinates.
#[inline(always)]
pub(super) fn area_by_coordinates([a, b, c]: &[Projected; 3]) -> i32 {
    let product = |p: &Projected, q: &Projected| p.x().wrapping_mul(q.y());
    let one = product(a, b).wrapping_add(product(b, c)).wrapping_add(product(c, a));
    let other = product(b, a).wrapping_add(product(c, b)).wrapping_add(product(a, c));
    one.wrapping_sub(other)
}

/// The same by two products of sides.
#[inline(always)]
pub(super) fn area_by_sides([a, b, c]: &[Projected; 3]) -> i32 {
    let side = |to: i32, from: i32| to.wrapping_sub(from);
    let one = side(b.x(), a.x()).wrapping_mul(side(c.y(), a.y()));
    let other = side(c.x(), a.x()).wrapping_mul(side(b.y(), a.y()));
    one.wrapping_sub(other)
}

/// The sign of an area.
#[inline(always)]
pub(super) const fn sign(area: i64) -> i32 {
    if area < 0 {
        -1
    } else {
        1
    }
}

impl<T: Topology<Primitive = [u32; 3]>> Assembly<T> {
    /// Finds out from where planes of triangles are seen, where there are any.
    #[inline(always)]
    pub(super) fn face<P: Positions>(&mut self, positions: &P) {
        let Self { topology, mapping, culled, .. } = self;
        topology.face(|scale| positions.facing(mapping, *culled, scale));
    }

    /// The next triangle that may be seen; whether there is one.
    ///
    /// # Cost
    /// About 60 instructions on Cortex-M4 for a triangle whose vertices are known and that is culled.
    #[inline(never)]
    pub(super) fn next<P: Positions, C: Counter>(
        &mut self,
        positions: &P,
        cache: &mut [Entry],
        counter: &mut C,
        face: &mut Face,
    ) -> bool {
        // After what was cut too: one question for both.
        if !face.triangle.is_inside {
            if face.clipped {
                if self.fan.next(&mut face.triangle) {
                    return true;
                }
                counter.event(if face.covered { Event::Drawn } else { Event::Outside });
                face.clipped = false;
            }
            face.triangle.is_inside = self.is_whole;
        }
        let mut cursor = self.cursor;
        let found = loop {
            let next = self.topology.next::<false>(&mut cursor);
            if C::COUNTS && T::LEAVES_OUT {
                let number = next.map_or_else(|| self.topology.count(), |(number, _)| number);
                for _ in self.next_number..number {
                    counter.event(Event::Triangle);
                    counter.event(Event::Culled);
                }
                self.next_number = number.saturating_add(1);
            }
            let Some((number, vertices)) = next else {
                break false;
            };
            counter.event(Event::Triangle);
            (face.number, face.vertices) = (number, vertices);
            let corners = vertices.map(|index| vertex(cache, index, positions, &self.mapping));
            let [a, b, c] = corners;
            let any = a.flags() | b.flags() | c.flags();
            if any & flag::ANY == 0 {
                let area = area_in_view(&corners);
                if area == 0 {
                    counter.event(Event::Degenerate);
                    continue;
                }
                if self.culled.contain(area) {
                    counter.event(Event::Culled);
                    continue;
                }
                face.place(&self.mapping, &corners, area < 0);
                face.triangle.area = area.unsigned_abs().into();
                break true;
            }
            if any & flag::INVALID != 0 {
                counter.event(Event::Skipped);
                continue;
            }
            if a.flags() & b.flags() & c.flags() & flag::OUTSIDE != 0 {
                counter.event(Event::Outside);
                continue;
            }
            if self.cut(positions, a, b, c, counter, face) {
                face.triangle.is_inside = false;
                break true;
            }
        };
        self.cursor = cursor;
        found
    }

    /// Whether the face's triangle, which lies partly beside the view, is drawn. One that has to be
    /// cut becomes pieces, and the first of them the face's triangle.
    #[inline(never)]
    fn cut<P: Positions, C: Counter>(
        &mut self,
        positions: &P,
        a: Projected,
        b: Projected,
        c: Projected,
        counter: &mut C,
        face: &mut Face,
    ) -> bool {
        let area = if (a.flags() | b.flags() | c.flags()) & flag::CLIP == 0 {
            face.triangle.v = [a, b, c].each_ref().map(|vertex| self.mapping.place(vertex));
            face.flags = a.flags() & b.flags() & c.flags();
            signed_area(&face.triangle.v)
        } else {
            let cut = self.fan.cut(&self.mapping, |index| positions.clip(index), &face.vertices);
            if cut.is_none() {
                counter.event(Event::Skipped);
                return false;
            }
            counter.event(Event::Clipped);
            if self.fan.is_empty() {
                counter.event(Event::Outside);
                return false;
            }
            face.clipped = true;
            self.fan.area
        };
        let event = if area == 0 {
            Event::Degenerate
        } else if self.culled.contain(sign(area)) {
            Event::Culled
        } else {
            if !face.clipped {
                face.triangle.turn(area);
                return true;
            }
            (face.covered, face.flags) = (false, 0);
            if self.fan.next(&mut face.triangle) {
                return true;
            }
            Event::Outside
        };
        counter.event(event);
        face.clipped = false;
        false
    }
}
