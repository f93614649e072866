//! Points of meshes, and the corners of their triangles.

use core::hint::black_box;

use super::assembly::Positions;
use super::cache::CacheView;
use super::clipper::Fan;
use super::fill::Access;
use super::mapping::Mapping;
use super::pass::{Ready, Work};
use super::point::draw_point;
use super::{Pass, PointSize, VertexCache};
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::math::{forget, Mat4};
use crate::scene::{Mesh, Topology, Vertices};
use crate::shade::{Corner, Counter, Event, Shader, State, VertexInput};

impl<S: State> Pass<'_, S> {
    /// Draws the points of a mesh: `model` leads from its own space to the world.
    ///
    /// Points whose vertices lie before the near plane or beyond the far one are left out; at the
    /// sides of the viewport a point is drawn as far as its square reaches in, wherever its vertex
    /// lies.
    ///
    /// ```
    /// use microraster::math::{AngleUnits, Mat4};
    /// use microraster::{Camera, Consecutive, Flat, Frame, Mesh, Pass, Points, Rgb, Rgb565, Size};
    ///
    /// static STARS: [[i16; 3]; 3] = [[-1, 0, -4], [0, 1, -5], [1, 0, -6]];
    /// let stars = Mesh::new(&STARS, &[(); 3]).with_topology(Points::new(Consecutive::new(3)));
    /// let mut pixels = [0u16; 32 * 32];
    /// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(32, 32))?;
    /// let camera = Camera::perspective(45.0.degrees(), 0.5);
    /// let white = Flat::solid(Rgb::WHITE);
    /// Pass::new(&camera).draw_points(&mut frame, &Mat4::identity(), &stars, &white, &2);
    /// assert_eq!(pixels.iter().filter(|pixel| **pixel != 0).count(), 3 * 2 * 2);
    /// # Ok::<(), microraster::FrameError>(())
    /// ```
    ///
    /// # Cost
    /// Points share no vertices: there is no cache.
    pub fn draw_points<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        size: &impl PointSize<H::Vertex>,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 1]>,
    {
        let work = PointsOf { topology: mesh.topology, size };
        self.perform(frame, model, mesh.vertices(), shader, work);
    }

    /// Draws the corners of a mesh's triangles as points, of those that are not culled: each
    /// triangle its three.
    pub fn draw_corners<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        size: &impl PointSize<H::Vertex>,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 3]>,
    {
        let mut cache = VertexCache::<(), 32>::new();
        let work = Corners { topology: mesh.topology, size, cache: cache.start() };
        self.perform(frame, model, mesh.vertices(), shader, work);
    }
}

/// Draws points.
struct PointsOf<'a, T, Z> {
    topology: T,
    size: &'a Z,
}

impl<H, T, Z> Work<H> for PointsOf<'_, T, Z>
where
    H: Shader,
    T: Topology<Primitive = [u32; 1]>,
    Z: PointSize<H::Vertex>,
{
    #[inline(always)]
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Self { topology, size } = self;
        let mut cursor = T::Cursor::default();
        // In memory, for `forget`.
        let _ = black_box(ready.draw.prepared);
        let mapping = ready.mapping;
        let listed = Listed::of(ready.draw.vertices, &mapping);
        while let Some((number, [index])) = topology.next::<false>(&mut cursor) {
            state.counter().event(Event::Point);
            let event = ready.inlined_point(index, number, &listed, size, frame, state);
            state.counter().event(event);
        }
    }

    fn skip<C: Counter>(self, counter: &mut C) {
        for _ in 0..self.topology.count() {
            counter.event(Event::Point);
            counter.event(Event::Skipped);
        }
    }
}

/// Draws the corners of triangles.
struct Corners<'a, T, Z> {
    topology: T,
    size: &'a Z,
    cache: CacheView<'a, ()>,
}

impl<H, T, Z> Work<H> for Corners<'_, T, Z>
where
    H: Shader,
    T: Topology<Primitive = [u32; 3]>,
    Z: PointSize<H::Vertex>,
{
    #[inline(always)]
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Self { topology, size, mut cache } = self;
        let (mut cursor, mut fan) = (T::Cursor::default(), Fan::default());
        let mapping = ready.mapping;
        let listed = Listed::of(ready.draw.vertices, &mapping);
        while let Some((number, vertices)) = topology.next::<false>(&mut cursor) {
            state.counter().event(Event::Triangle);
            if let Some(event) = ready.left_out(vertices, &mut cache, &mut fan) {
                state.counter().event(event);
                continue;
            }
            let mut event = Event::Outside;
            for index in vertices {
                let corner = ready.point(index, number, &listed, size, frame, state);
                if matches!(corner, Event::Drawn | Event::Skipped) {
                    event = corner;
                }
            }
            state.counter().event(event);
        }
    }

    fn skip<C: Counter>(self, counter: &mut C) {
        for _ in 0..self.topology.count() {
            counter.event(Event::Triangle);
            counter.event(Event::Skipped);
        }
    }
}

/// What a loop over points reads.
struct Listed<'a, A> {
    /// Attributes of vertices that have a position under the same number: as many as positions, so
    /// that one question serves both.
    attributes: &'a [A],
    positions: &'a [[i16; 3]],
    mapping: &'a Mapping,
    /// The mapping's.
    easy_w: i32,
}

impl<'a, A> Listed<'a, A> {
    /// That of a mesh; no vertices where attributes are the primitives' own.
    #[inline(always)]
    fn of(vertices: &Vertices<'a, A>, mapping: &'a Mapping) -> Self {
        let Vertices { attributes, positions, by_face, .. } = vertices;
        let count = if *by_face { 0 } else { attributes.len() };
        // Or the question is asked of every point.
        let attributes = black_box(attributes.get(..count).unwrap_or_default());
        let count = attributes.len().min(positions.len());
        let easy_w = mapping.easy_w();
        match (attributes.get(..count), positions.get(..count)) {
            (Some(attributes), Some(positions)) => Self { attributes, positions, mapping, easy_w },
            _ => Self { attributes: &[], positions: &[], mapping, easy_w },
        }
    }
}

/// What the point `number` at a vertex is made of that is not listed; `None` if the mesh lacks it.
#[cold]
#[inline(never)]
fn found<'a, H: Shader>(
    vertices: &Vertices<'a, H::Vertex>,
    index: u32,
    number: u32,
) -> Option<(&'a H::Vertex, &'a [i16; 3])> {
    let Vertices { attributes, positions, by_face, .. } = vertices;
    let attributes = attributes.get(if *by_face { number } else { index } as usize)?;
    let position = positions.get(index as usize);
    Some((attributes, if H::OWN_POSITIONS { position.unwrap_or(&[0; 3]) } else { position? }))
}

impl<H: Shader, P: Positions> Ready<'_, H, P> {
    /// Draws a point of the mesh: for loops in which it has company.
    #[inline(never)]
    fn point<S, F, D>(
        &self,
        index: u32,
        number: u32,
        listed: &Listed<'_, H::Vertex>,
        size: &impl PointSize<H::Vertex>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
    ) -> Event
    where
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.inlined_point(index, number, listed, size, frame, state)
    }

    /// Draws a point of the mesh in place.
    #[inline(always)]
    fn inlined_point<S, F, D>(
        &self,
        index: u32,
        number: u32,
        listed: &Listed<'_, H::Vertex>,
        size: &impl PointSize<H::Vertex>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
    ) -> Event
    where
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Self { draw, positions, area, .. } = self;
        let at = index as usize;
        let (attributes, position) = match (listed.attributes.get(at), listed.positions.get(at)) {
            (Some(attributes), Some(position)) => (attributes, position),
            _ => match found::<H>(draw.vertices, index, number) {
                Some(found) => found,
                None => return Event::Skipped,
            },
        };
        forget();
        let place = match positions.point(index, position, listed.mapping, listed.easy_w) {
            Ok(place) => place,
            Err(event) => return event,
        };
        let input = VertexInput { attributes, position: *position };
        let size = size.size(input, place.z).clamp(0, MOST);
        let half = size.cast_signed().wrapping_add(1) >> 1;
        // Before the corner is shaded: whether any of its square may be seen.
        let is_beside = |v: i32, low: i32, high: i32| {
            let (low, length) = (low.wrapping_mul(16), high.wrapping_sub(low).wrapping_mul(16));
            let inside = v.wrapping_sub(low.wrapping_sub(half));
            inside as u32 > length.wrapping_add(half.wrapping_mul(2)) as u32
        };
        if is_beside(place.x_bits(), area.left, area.right) {
            return Event::Outside;
        }
        // Or both are asked of every point.
        forget();
        if is_beside(place.y_bits(), area.top, area.bottom) {
            return Event::Outside;
        }
        let corner: Corner<H::Varying> = draw.made_of(input, index, *positions);
        draw_point(&place, &corner, size, area, frame, state, &draw.bound())
    }
}

/// The largest point, in sixteenths of a pixel.
const MOST: u32 = 256 * 16;
