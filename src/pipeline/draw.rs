use super::assembly::{Assembly, Face, Positions};
use super::cache::{is_shaded, note_shaded, CacheView};
use super::fill::{find, limits_of_few, Access, Fill, Walk};
use super::mapping::Mapping;
use super::projected::{flag, Projected};
use super::Clip;
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::raster::{ScreenVertex, SpanBatch};
use crate::scene::{Topology, Vertices};
use crate::shade::{Bound, Corner, Counter, Event, Shader, State, Varying, VertexInput};

/// The w of a vertex that was projected, or is behind the eye and has 1.
#[inline(always)]
fn w<P: Positions>(positions: &P, index: u32) -> i32 {
    positions.clip(index).map_or(1, |clip| clip.w)
}

/// One draw of a mesh: what depends on the shader, but not on state or format.
#[derive(Debug)]
pub(super) struct Draw<'a, H: Shader> {
    pub(super) vertices: &'a Vertices<'a, H::Vertex>,
    pub(super) shader: &'a H,
    pub(super) prepared: &'a H::Prepared,
}

impl<H: Shader> Positions for Draw<'_, H> {
    fn clip(&self, index: u32) -> Option<Clip> {
        let vertex = self.vertices.attributes.get(index as usize)?;
        self.shader.position(self.prepared, vertex)
    }

    fn projected(&self, index: u32, mapping: &Mapping) -> Projected {
        match self.clip(index) {
            Some(clip) => mapping.project_any(&clip),
            None => Projected::INVALID,
        }
    }

    fn point(
        &self,
        index: u32,
        _position: &[i16; 3],
        mapping: &Mapping,
        _easy_w: i32,
    ) -> Result<ScreenVertex, Event> {
        let clip = self.clip(index).ok_or(Event::Skipped)?;
        mapping.point(&clip).ok_or(Event::Outside)
    }
}

impl<H: Shader> Draw<'_, H> {
    /// What draws pixels.
    #[inline(always)]
    pub(super) fn bound(&self) -> Bound<'_, H> {
        Bound { shader: self.shader, prepared: self.prepared }
    }

    #[inline(always)]
    pub(super) fn run<P, T, S, F, D>(
        &self,
        positions: &P,
        mut assembly: Assembly<T>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        mut cache: CacheView<'_, Corner<H::Varying>>,
    ) where
        P: Positions,
        T: Topology<Primitive = [u32; 3]>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        assembly.face(positions);
        let mut face = Face::NONE;
        let mut walk = Walk::<S>::default();
        let mut batch = SpanBatch::made_by_stores();
        let mut target = frame.target::<Access<S>>();
        let limits = limits_of_few::<H::Varying, S, F, D>(state, &target, &assembly.area);
        while assembly.next(positions, cache.entries, state.counter(), &mut face) {
            let found = find::<H::Varying, S>(
                state,
                &face.triangle,
                &assembly.area,
                &limits,
                &mut walk,
                &mut batch,
            );
            let Some(few) = found else {
                if !face.clipped {
                    state.counter().event(Event::Outside);
                }
                continue;
            };
            // Only now, with a pixel to draw, are its vertices shaded.
            let Some(mut corners) = self.corners(&face, positions, &mut cache) else {
                state.counter().event(Event::Skipped);
                face.clipped = false;
                continue;
            };
            let first;
            let provoking = if face.clipped {
                face.covered = true;
                let [a, b, c] = corners;
                corners = assembly.fan.weights().map(|(u, v)| H::Varying::mix([&a, &b, &c], u, v));
                if face.triangle.flipped {
                    corners.swap(1, 2);
                }
                first = a;
                &first
            } else {
                state.counter().event(Event::Drawn);
                &corners[0]
            };
            Fill { triangle: &face.triangle, corners: &corners, provoking }.draw_known(
                few,
                &mut target,
                state,
                &self.bound(),
                &mut walk,
                &mut batch,
            );
        }
    }

    /// The attributes of a triangle's corners in its order, and of a piece those of the mesh's
    /// triangle; only the provoking one's where nothing is interpolated. `None` if the mesh lacks
    /// them.
    #[inline(always)]
    fn corners<P: Positions>(
        &self,
        face: &Face,
        positions: &P,
        cache: &mut CacheView<'_, Corner<H::Varying>>,
    ) -> Option<[Corner<H::Varying>; 3]> {
        if self.vertices.by_face {
            return self.face_corners(face, positions).map(|corners| face.in_order(corners));
        }
        let [a, ..] = face.vertices;
        let mut corner = |index| self.kept(index, positions, cache);
        if !H::Varying::INTERPOLATED {
            return Some([corner(a)?; 3]);
        }
        let turned = face.triangle.flipped && !face.clipped;
        let b = face.vertices[1 + usize::from(turned)];
        let c = face.vertices[2 - usize::from(turned)];
        if face.flags & flag::SHADED != 0 {
            return cache.known([a, b, c]);
        }
        Some([corner(a)?, corner(b)?, corner(c)?])
    }

    /// The same where attributes are the triangle's own, in the order of the mesh.
    #[inline(always)]
    pub(super) fn face_corners<P: Positions>(
        &self,
        face: &Face,
        positions: &P,
    ) -> Option<[Corner<H::Varying>; 3]> {
        let attributes = self.vertices.attributes.get(face.number as usize)?;
        let position = self.position(face.vertices[0]);
        let input = VertexInput { attributes, position };
        let corner = self.shader.vertex(self.prepared, input);
        Some(face.vertices.map(|index| {
            let mut corner = corner;
            H::Varying::place(&mut corner, || w(positions, index));
            corner
        }))
    }

    /// The attributes of one vertex of primitive `number`; `None` if the mesh lacks them.
    #[inline(always)]
    pub(super) fn corner<P: Positions>(
        &self,
        index: u32,
        number: u32,
        positions: &P,
        cache: &mut CacheView<'_, Corner<H::Varying>>,
    ) -> Option<Corner<H::Varying>> {
        if self.vertices.by_face {
            return self.made(number, index, positions);
        }
        self.kept(index, positions, cache)
    }

    /// The attributes of a vertex, from the cache or made for it; `None` if the mesh lacks them.
    #[inline(always)]
    fn kept<P: Positions>(
        &self,
        index: u32,
        positions: &P,
        cache: &mut CacheView<'_, Corner<H::Varying>>,
    ) -> Option<Corner<H::Varying>> {
        let (entry, place) = cache.slot(index)?;
        if !is_shaded(entry, index) {
            self.shade(index, positions, place)?;
            note_shaded(entry, index);
        }
        Some(*place)
    }

    /// The attributes with a number of a vertex, made anew; `None` if the mesh lacks them.
    #[inline(always)]
    pub(super) fn made<P: Positions>(
        &self,
        number: u32,
        index: u32,
        positions: &P,
    ) -> Option<Corner<H::Varying>> {
        let attributes = self.vertices.attributes.get(number as usize)?;
        let input = VertexInput { attributes, position: self.position(index) };
        Some(self.made_of(input, index, positions))
    }

    /// The same of what a vertex is made of.
    #[inline(always)]
    pub(super) fn made_of<P: Positions>(
        &self,
        input: VertexInput<'_, H::Vertex>,
        index: u32,
        positions: &P,
    ) -> Corner<H::Varying> {
        let mut corner = self.shader.vertex(self.prepared, input);
        H::Varying::place(&mut corner, || w(positions, index));
        corner
    }

    /// Where a vertex lies in the mesh, if the mesh says so.
    #[inline(always)]
    pub(super) fn position(&self, index: u32) -> [i16; 3] {
        self.vertices.positions.get(index as usize).copied().unwrap_or_default()
    }

    /// Puts a vertex's attributes in their place; `None` if the mesh lacks them. Apart, so that it is
    /// there once for a triangle's corners.
    #[inline(never)]
    fn shade<P: Positions>(
        &self,
        index: u32,
        positions: &P,
        place: &mut Corner<H::Varying>,
    ) -> Option<()> {
        *place = self.made(index, index, positions)?;
        Some(())
    }
}
