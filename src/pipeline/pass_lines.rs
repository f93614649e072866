//! Lines of meshes, and the edges of their triangles.

use super::assembly::{area_of, sign, vertex, Positions};
use super::cache::CacheView;
use super::clipper::{cut_line, Fan};
use super::fill::Access;
use super::line::{LineDraw, Outcome};
use super::pass::{Ready, Work};
use super::projected::flag;
use super::{LineStyle, Pass, VertexCache};
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::math::Mat4;
use crate::scene::{Mesh, Topology};
use crate::shade::{Corner, Counter, Event, Shader, State, Varying};

impl<S: State> Pass<'_, S> {
    /// Draws the lines of a mesh: `model` leads from its own space to the world.
    ///
    /// Lines are cut at the near and far planes and at the guard box, never at the sides of the
    /// viewport.
    ///
    /// ```
    /// use microraster::math::{AngleUnits, Mat4, Vec3};
    /// use microraster::{Camera, Consecutive, Flat, Frame, LineLoop, Mesh, Pass, Rgb, Rgb565, Size, Thin};
    ///
    /// static CORNERS: [[i16; 3]; 4] = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]];
    /// let square = Mesh::new(&CORNERS, &[(); 4]).with_topology(LineLoop::new(Consecutive::new(4)));
    /// let mut pixels = [0u16; 32 * 32];
    /// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(32, 32))?;
    /// let camera = Camera::perspective(45.0.degrees(), 0.5);
    /// let model = Mat4::translation(Vec3::new(0.0, 0.0, -4.0));
    /// Pass::new(&camera).draw_lines(&mut frame, &model, &square, &Flat::solid(Rgb::RED), Thin);
    /// # assert!(pixels.iter().filter(|pixel| **pixel != 0).count() > 60);
    /// # Ok::<(), microraster::FrameError>(())
    /// ```
    pub fn draw_lines<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        style: impl LineStyle,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 2]>,
    {
        let mut cache = VertexCache::<Corner<H::Varying>, 32>::new();
        let work = Lines { topology: mesh.topology, style, cache: cache.start() };
        self.perform(frame, model, mesh.vertices(), shader, work);
    }

    /// Draws the edges of a mesh's triangles, of those that are not culled: each triangle its three,
    /// so that edges that triangles share are drawn for both.
    ///
    /// For hidden lines, draw the filled mesh first into depth, farther away by a polygon offset,
    /// then its edges with a depth test.
    ///
    /// # Rounding
    /// An edge runs from one vertex of its triangle to the next; the last one's stipple goes on
    /// around the triangle.
    pub fn draw_wireframe<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        style: impl LineStyle,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 3]>,
    {
        let mut cache = VertexCache::<Corner<H::Varying>, 32>::new();
        let work = Edges { topology: mesh.topology, style, cache: cache.start() };
        self.perform(frame, model, mesh.vertices(), shader, work);
    }
}

/// Draws lines.
struct Lines<'a, T, L, C> {
    topology: T,
    style: L,
    cache: CacheView<'a, C>,
}

impl<H, T, L> Work<H> for Lines<'_, T, L, Corner<H::Varying>>
where
    H: Shader,
    T: Topology<Primitive = [u32; 2]>,
    L: LineStyle,
{
    #[inline(always)]
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Self { topology, style, mut cache } = self;
        let (mut cursor, mut before) = (T::Cursor::default(), 0_u32);
        while let Some((number, ends)) = topology.next::<false>(&mut cursor) {
            let counter = state.counter();
            counter.event(Event::Line);
            if !topology.continues(&cursor) {
                before = 0;
            }
            let provoking = ends[usize::from(T::LAST_PROVOKES)];
            let line = Segment { number, ends, provoking, before };
            let outcome = ready.line(&line, style, &mut cache, frame, state);
            state.counter().event(outcome.event);
            before = before.wrapping_add(outcome.pixels);
        }
    }

    fn skip<C: Counter>(self, counter: &mut C) {
        for _ in 0..self.topology.count() {
            counter.event(Event::Line);
            counter.event(Event::Skipped);
        }
    }
}

/// Draws the edges of triangles.
struct Edges<'a, T, L, C> {
    topology: T,
    style: L,
    cache: CacheView<'a, C>,
}

impl<H, T, L> Work<H> for Edges<'_, T, L, Corner<H::Varying>>
where
    H: Shader,
    T: Topology<Primitive = [u32; 3]>,
    L: LineStyle,
{
    #[inline(always)]
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Self { topology, style, mut cache } = self;
        let (mut cursor, mut fan) = (T::Cursor::default(), Fan::default());
        while let Some((number, vertices)) = topology.next::<false>(&mut cursor) {
            state.counter().event(Event::Triangle);
            if let Some(event) = ready.left_out(vertices, &mut cache, &mut fan) {
                state.counter().event(event);
                continue;
            }
            let [a, b, c] = vertices;
            let (mut before, mut event) = (0_u32, Event::Outside);
            for ends in [[a, b], [b, c], [c, a]] {
                let line = Segment { number, ends, provoking: a, before };
                let outcome = ready.line(&line, style, &mut cache, frame, state);
                before = before.wrapping_add(outcome.pixels);
                if matches!(outcome.event, Event::Drawn | Event::Skipped) {
                    event = outcome.event;
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

/// A line of a mesh.
struct Segment {
    /// The number of the primitive.
    number: u32,
    ends: [u32; 2],
    provoking: u32,
    /// Pixels of the strip that came before.
    before: u32,
}

impl<H: Shader, P: Positions> Ready<'_, H, P> {
    /// Draws a line of the mesh, cut where it has to be.
    #[inline(never)]
    fn line<S, F, D, L>(
        &self,
        line: &Segment,
        style: L,
        cache: &mut CacheView<'_, Corner<H::Varying>>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
    ) -> Outcome
    where
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        L: LineStyle,
    {
        let Self { positions, mapping, area, .. } = self;
        let none = |event| Outcome { event, pixels: 0 };
        let Segment { number, ends: [i, j], provoking, before } = *line;
        let [a, b] = [i, j].map(|index| vertex(cache.entries, index, *positions, mapping));
        let any = a.flags() | b.flags();
        if any & flag::INVALID != 0 {
            return none(Event::Skipped);
        }
        // The sides of the viewport are no reason where a line is wide.
        if a.flags() & b.flags() & (flag::NEAR | flag::FAR) != 0 {
            return none(Event::Outside);
        }
        let mut ends = [mapping.place(&a), mapping.place(&b)];
        let mut cuts = None;
        if any & flag::CLIP != 0 {
            let (Some(from), Some(to)) = (positions.clip(i), positions.clip(j)) else {
                return none(Event::Skipped);
            };
            let Some([first, last]) = cut_line(mapping, [from, to]) else {
                return none(Event::Outside);
            };
            ends = [first.0, last.0];
            cuts = Some([first.1, last.1]);
        }
        let mut corner = |index| self.draw.corner(index, number, *positions, cache);
        let Some(first) = corner(provoking) else { return none(Event::Skipped) };
        let mut corners = [first; 2];
        if H::Varying::INTERPOLATED {
            let (Some(p), Some(q)) = (corner(i), corner(j)) else { return none(Event::Skipped) };
            corners = match cuts {
                Some(cuts) => cuts.map(|along| H::Varying::mix([&p, &q, &p], along, 0)),
                None => [p, q],
            };
        }
        let line = LineDraw { ends, corners: &corners, provoking: &first, area: *area, before };
        style.draw(&line, frame, state, &self.draw.bound())
    }

    /// Why nothing of a triangle is drawn, not even its edges or corners; `None` if it is.
    #[inline(never)]
    pub(super) fn left_out<C>(
        &self,
        vertices: [u32; 3],
        cache: &mut CacheView<'_, C>,
        fan: &mut Fan,
    ) -> Option<Event> {
        let Self { positions, mapping, culled, .. } = self;
        let corners = vertices.map(|index| vertex(cache.entries, index, *positions, mapping));
        let [a, b, c] = &corners;
        let any = a.flags() | b.flags() | c.flags();
        if any & flag::INVALID != 0 {
            return Some(Event::Skipped);
        }
        if a.flags() & b.flags() & c.flags() & (flag::NEAR | flag::FAR) != 0 {
            return Some(Event::Outside);
        }
        let area = if any & flag::CLIP != 0 {
            if fan.cut(mapping, |index| positions.clip(index), &vertices).is_none() {
                return Some(Event::Skipped);
            }
            if fan.is_empty() {
                return Some(Event::Outside);
            }
            fan.area
        } else {
            area_of(&corners)
        };
        if area == 0 {
            Some(Event::Degenerate)
        } else {
            culled.contain(sign(area)).then_some(Event::Culled)
        }
    }
}
