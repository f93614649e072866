//! Meshes that are recorded once a picture and drawn in each of its bands.

use super::assembly::{Assembly, Face, MeshPositions, Positions};
use super::cache::CacheView;
use super::clipper::Fan;
use super::display_list::{first_row, Recorded};
use super::draw::Draw;
use super::fill::{find, limits_of_few, Access, Fill, Walk};
use super::pass::SetUp;
use super::transform::Transform;
use super::{DisplayList, ListError, Pass, VertexCache};
use crate::color::Format;
use crate::frame::{Frame, Rect, Size, Supplies, Target};
use crate::math::Mat4;
use crate::raster::{Limits, ScreenVertex, SpanBatch, Traversal};
use crate::scene::{Mesh, Topology};
use crate::shade::{Bound, Corner, Counter, Event, Shader, State, Varying};

/// A mesh as a [`Pass`] puts it on the screen: transformed, shaded, culled and clipped.
pub struct Recording<'a, H: Shader> {
    list: DisplayList<'a, Corner<H::Varying>>,
    shader: &'a H,
    /// None where nothing of the mesh can be drawn.
    prepared: Option<H::Prepared>,
    /// What is drawn of the picture.
    area: Rect,
}

impl<H: Shader> core::fmt::Debug for Recording<'_, H> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Recording")
            .field("vertices", &self.list.vertices())
            .field("triangles", &self.list.triangles())
            .field("area", &self.area)
            .finish_non_exhaustive()
    }
}

impl<'a, H: Shader> Recording<'a, H> {
    /// Takes what is left of the list's memory, for another mesh whose shader gives its corners the
    /// same: in each band one is replayed after the other. `bands` is that mesh's own.
    pub fn take_rest(&mut self, bands: &'a mut [u16]) -> DisplayList<'a, Corner<H::Varying>> {
        self.list.take_rest(bands)
    }

    /// Whether all of the mesh found room in the list. Where it did not, nothing is replayed, and the
    /// memory is still there: [`into_list`](Self::into_list).
    ///
    /// # Errors
    /// [`ListError::Full`] says what all of the mesh would take.
    pub fn check(&self) -> Result<(), ListError> {
        self.list.check_room()
    }

    /// Vertices that the mesh takes in the list.
    pub fn vertices(&self) -> u32 {
        self.list.vertices()
    }

    /// Triangles that the mesh takes in the list, pieces of clipped ones each for itself.
    pub fn triangles(&self) -> u32 {
        self.list.triangles()
    }

    /// The pixels that may be drawn, as one rectangle: what is to be added to a
    /// [`Damage`](crate::Damage) before anything is drawn, so that bands beside it need not be. Where
    /// the list was too short, all that the pass draws to.
    ///
    /// # Cost
    /// A look at each vertex.
    pub fn bounds(&self) -> Rect {
        match self.check() {
            Ok(()) => self.list.bounds().intersection(self.area),
            Err(_) => self.area,
        }
    }

    /// Gives the list back, for the next picture: what outlives a picture, such as a list in
    /// `static` memory that cores share, cannot be borrowed anew for each. What
    /// [`take_rest`](Self::take_rest) took of it stays with whom it went to.
    ///
    /// ```
    /// use microraster::math::{AngleUnits, Mat4, Vec3};
    /// use microraster::models::TEAPOT;
    /// use microraster::{
    ///     Camera, DisplayList, Flat, Light, ListTriangle, ListVertex, Pass, Rgb, Size, VertexCache,
    /// };
    ///
    /// let (mut vertices, mut triangles) = ([ListVertex::default(); 1024], [ListTriangle::BLANK; 1024]);
    /// let mut list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    /// let camera = Camera::perspective(45.0.degrees(), 0.5);
    /// let shader = Flat::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    /// let (mut pass, mut cache) = (Pass::new(&camera), VertexCache::<u16, 64>::new());
    /// for distance in 4..6 {
    ///     let (model, size) = (Mat4::translation(Vec3::new(0.0, 0.0, -distance as f32)), Size::new(64, 48));
    ///     let recording = pass.record(list, size, &model, &TEAPOT, &shader, &mut cache);
    ///     // Here is the place to replay it, in each band.
    ///     # recording.check()?;
    ///     list = recording.into_list();
    /// }
    /// # Ok::<(), microraster::ListError>(())
    /// ```
    pub fn into_list(self) -> DisplayList<'a, Corner<H::Varying>> {
        self.list
    }
}

/// Draws recorded triangles into a band.
struct Replay<'r, 'f, S: State, F: Format, D> {
    target: Target<'r, 'f, F, D, Access<S>>,
    state: &'r mut S,
    area: Rect,
    limits: Limits,
    walk: Walk<S>,
    batch: SpanBatch,
}

impl<'r, 'f, S: State, F: Format, D: Supplies<Access<S>>> Replay<'r, 'f, S, F, D> {
    /// Within `area`, as far as the frame reaches.
    #[inline(always)]
    fn new<V: Varying>(frame: &'r mut Frame<'f, F, D>, state: &'r mut S, area: Rect) -> Self {
        let area = frame.scissor().intersection(area);
        let target = frame.target();
        let limits = limits_of_few::<V, S, F, D>(state, &target, &area);
        let (walk, batch) = (Walk::<S>::default(), SpanBatch::made_by_stores());
        Self { target, state, area, limits, walk, batch }
    }

    #[inline(always)]
    fn draw<H: Shader>(&mut self, recorded: &Recorded<Corner<H::Varying>>, bound: &Bound<'_, H>) {
        let Self { target, state, area, limits, walk, batch } = self;
        let Recorded { triangle, corners, provoking } = recorded;
        if let Some(few) = find::<H::Varying, S>(state, triangle, area, limits, walk, batch) {
            let fill = Fill { triangle, corners, provoking };
            fill.draw_known(few, target, *state, bound, walk, batch);
        }
    }
}

impl<S: State> Pass<'_, S> {
    /// Records what a mesh puts on the screen, for [`replay`](Self::replay) in each band of a
    /// picture: vertices are transformed and shaded once, whatever the number of bands. Triangles
    /// only; lines and points are drawn again.
    ///
    /// Of the pass it is the camera, the viewport, culling and the counter that matter here; each
    /// triangle is counted once, and is outside only if its box holds no pixel of the picture. The cache
    /// says which vertices are in the list already: those that it forgets come in again.
    ///
    /// ```
    /// use microraster::math::{Mat4, Vec3};
    /// use microraster::models::TEAPOT;
    /// use microraster::{Bands, Camera, Cull, DisplayList, Gouraud, Less, Light, ListTriangle};
    /// use microraster::{ListVertex, Pass, Rgb, Rgb565, Size, VertexCache};
    /// # use microraster::math::AngleUnits;
    ///
    /// let (mut pixels, mut depth) = ([0u16; 128 * 8], [0u16; 128 * 8]);
    /// let picture = Size::new(128, 64);
    /// let mut bands = Bands::<Rgb565>::new(&mut pixels, picture)?.with_depth(&mut depth)?;
    /// let camera = Camera::perspective(45.0.degrees(), 0.5)
    ///     .look_at(Vec3::new(0.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y);
    /// let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE);
    /// let (model, shader) = (Mat4::identity(), Gouraud::lit(&[sun]));
    ///
    /// let (mut vertices, mut triangles) = ([ListVertex::default(); 600], [ListTriangle::default(); 600]);
    /// let (mut numbers, mut cache) = ([0; 8], VertexCache::<u16, 512>::new());
    /// let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
    /// let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    /// let mut recording = pass.record(list, picture, &model, &TEAPOT, &shader, &mut cache);
    /// # assert!(recording.check().is_ok(), "{recording:?}");
    /// let sent = bands.draw::<()>(
    ///     |frame| {
    ///         frame.clear(Rgb::BLACK);
    ///         // Where the list was too short, the mesh itself.
    ///         pass.replay_or_draw(frame, &mut recording, &model, &TEAPOT, &shader);
    ///     },
    ///     |_band| Ok(()),
    /// );
    /// # assert!(sent.is_ok());
    /// # Ok::<(), microraster::FrameError>(())
    /// ```
    ///
    /// A list that is too short is an error when it is [checked](Recording::check) or replayed.
    ///
    /// # Cost
    /// 8 bytes a triangle, and 8 a vertex plus what its shader gives it: 12 in all for a colour. The
    /// pieces of a triangle that is clipped have four vertices each, triangles with attributes of
    /// their own three.
    pub fn record<'a, H, T, const N: usize>(
        &mut self,
        mut list: DisplayList<'a, Corner<H::Varying>>,
        picture: Size,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &'a H,
        cache: &mut VertexCache<u16, N>,
    ) -> Recording<'a, H>
    where
        H: Shader,
        T: Topology<Primitive = [u32; 3]>,
    {
        list.start(picture);
        let (vertices, whole) = (mesh.vertices(), Rect::from_size(picture));
        let mut transform = Transform::NONE;
        let ready = self.set_up(picture, whole, model, vertices, shader, &mut transform);
        let Some(SetUp { mapping, area, is_whole, culled, prepared }) = ready else {
            for _ in 0..mesh.triangles() {
                self.state.counter().event(Event::Triangle);
                self.state.counter().event(Event::Skipped);
            }
            return Recording { list, shader, prepared: None, area: Rect::default() };
        };
        let (cursor, fan) = (T::Cursor::default(), Fan::default());
        let topology = mesh.topology;
        let assembly =
            Assembly { topology, cursor, mapping, area, is_whole, culled, fan, next_number: 0 };
        let draw = Draw { vertices, shader, prepared: &prepared };
        let counter = self.state.counter();
        if H::OWN_POSITIONS {
            draw.record(&draw, assembly, counter, cache.start(), &mut list);
        } else {
            let positions = MeshPositions { transform: &transform, positions: vertices.positions };
            draw.record(&positions, assembly, counter, cache.start(), &mut list);
        }
        Recording { list, shader, prepared: Some(prepared), area }
    }

    /// Draws what was recorded into a band, with the state of this pass: the same bits as drawing
    /// the mesh.
    ///
    /// Bands that come one after the other, all of the same height but for the last, are cheapest;
    /// any other order costs another look at all triangles.
    ///
    /// # Errors
    /// The list was too short for the mesh or has no room for the number of bands, or the frame is of
    /// another picture; then nothing is drawn.
    pub fn replay<H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        recording: &mut Recording<'_, H>,
    ) -> Result<(), ListError>
    where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Recording { list, shader, prepared, area } = recording;
        let Some(prepared) = prepared else { return Ok(()) };
        let bound = Bound { shader: *shader, prepared };
        let Size { width: frame_width, height: rows } = frame.size();
        let mut band = list.band(frame.picture(), frame.first_row(), rows)?;
        let end = i32::from(frame.first_row()).wrapping_add(rows.into());
        let mut replay = Replay::new::<H::Varying>(frame, &mut self.state, *area);
        // Triangles that neither come from above nor go on below do not reach beyond the band.
        let (width, top) = (frame_width.into(), end.wrapping_sub(rows.into()));
        let band_area = Rect { left: 0, top, right: width, bottom: end };
        let is_whole = list.are_inside()
            && replay.area == band_area.intersection(*area)
            && replay.state.traversal().takes_whole_area();
        while let Some((number, begins)) = list.next(&mut band) {
            let Some((mut recorded, bottom)) = list.recorded(number, !H::Varying::AT_ONCE) else {
                break;
            };
            if bottom > end {
                list.carry(number);
            } else if begins {
                recorded.triangle.is_inside = is_whole;
            }
            replay.draw(&recorded, &bound);
        }
        Ok(())
    }

    /// The same from a recording that others draw from at the same time: two cores or more, each
    /// with a pass and a band of its own.
    ///
    /// ```
    /// use microraster::math::{AngleUnits, Mat4, Vec3};
    /// use microraster::models::TEAPOT;
    /// use microraster::{
    ///     Camera, DisplayList, Frame, Gouraud, Less, Light, ListTriangle, ListVertex, Pass, Rgb,
    ///     Rgb565, Size, VertexCache,
    /// };
    ///
    /// let (mut vertices, mut triangles) = ([ListVertex::default(); 1024], [ListTriangle::BLANK; 1024]);
    /// let (camera, picture) = (Camera::perspective(45.0.degrees(), 0.5), Size::new(64, 48));
    /// let model = Mat4::translation(Vec3::new(0.0, 0.0, -4.0));
    /// let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    /// let list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    /// let mut cache = VertexCache::<u16, 64>::new();
    /// let mut pass = Pass::new(&camera).depth(Less);
    /// let recording = pass.record(list, picture, &model, &TEAPOT, &shader, &mut cache);
    /// let halves = [0, 24].map(|first_row| (first_row, &recording));
    /// std::thread::scope(|scope| {
    ///     for (first_row, recording) in halves {
    ///         scope.spawn(move || {
    ///             let (mut pixels, mut depth) = ([0u16; 64 * 24], [0u16; 64 * 24]);
    ///             let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(64, 24))
    ///                 .and_then(|frame| frame.with_depth(&mut depth)?.band(first_row, 48));
    ///             let mut frame = frame.expect("buffers are as large as the band");
    ///             let drawn = Pass::new(&Camera::perspective(45.0.degrees(), 0.5))
    ///                 .depth(Less)
    ///                 .replay_shared(&mut frame, recording);
    ///             assert!(drawn.is_ok() && depth.iter().any(|code| *code > 0));
    ///         });
    ///     }
    /// });
    /// ```
    ///
    /// # Cost
    /// Every band looks at the rows of every triangle, some 40 instructions on Cortex-M4; the list
    /// needs no numbers of bands.
    ///
    /// # Errors
    /// The list was too short for the mesh, or the frame is of another picture; then nothing is drawn.
    /// A mesh of which nothing can be drawn is no error in any picture.
    pub fn replay_shared<H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        recording: &Recording<'_, H>,
    ) -> Result<(), ListError>
    where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let Recording { list, shader, prepared, area } = recording;
        let Some(prepared) = prepared else { return Ok(()) };
        list.check_room()?;
        list.check(frame.picture())?;
        let bound = Bound { shader: *shader, prepared };
        let mut replay = Replay::new::<H::Varying>(frame, &mut self.state, *area);
        let Rect { top, bottom, .. } = replay.area;
        for number in list.numbers_within(top, bottom) {
            if let Some((recorded, _)) = list.recorded(number, !H::Varying::AT_ONCE) {
                replay.draw(&recorded, &bound);
            }
        }
        Ok(())
    }

    /// Draws what was recorded or, where that was not possible, the mesh itself: the same bits
    /// either way.
    pub fn replay_or_draw<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        recording: &mut Recording<'_, H>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 3]>,
    {
        if self.replay(frame, recording).is_err() {
            self.draw(frame, model, mesh, shader);
        }
    }
}

impl<H: Shader> Draw<'_, H> {
    /// Records all triangles that may be seen.
    fn record<P, T, C>(
        &self,
        positions: &P,
        mut assembly: Assembly<T>,
        counter: &mut C,
        mut cache: CacheView<'_, u16>,
        list: &mut DisplayList<'_, Corner<H::Varying>>,
    ) where
        P: Positions,
        T: Topology<Primitive = [u32; 3]>,
        C: Counter,
    {
        assembly.face(positions);
        let (mut face, mut are_inside) = (Face::NONE, true);
        while assembly.next(positions, cache.entries, counter, &mut face) {
            are_inside &= face.triangle.is_inside;
            let Some(first_row) = first_row(&face.triangle, &assembly.area) else {
                if !face.clipped {
                    counter.event(Event::Outside);
                }
                continue;
            };
            let taken = if face.clipped || self.vertices.by_face {
                self.record_alone(&mut face, first_row, positions, &assembly.fan, list)
            } else {
                self.record_shared(&face, first_row, positions, &mut cache, list)
            };
            if taken.is_none() {
                counter.event(Event::Skipped);
                face.clipped = false;
            } else if !face.clipped {
                counter.event(Event::Drawn);
            }
        }
        list.end(are_inside);
    }

    /// Records a triangle whose vertices others may share; `None` if the mesh lacks one.
    #[inline(always)]
    fn record_shared<P: Positions>(
        &self,
        face: &Face,
        first_row: u16,
        positions: &P,
        cache: &mut CacheView<'_, u16>,
        list: &mut DisplayList<'_, Corner<H::Varying>>,
    ) -> Option<()> {
        let mut numbers = [0; 3];
        let vertices = face.in_order(face.vertices);
        self.vertices.attributes.get(*vertices.first()? as usize)?;
        for (at, number) in numbers.iter_mut().enumerate() {
            let (index, vertex) = (*vertices.get(at)?, face.triangle.v.get(at)?);
            *number = match cache.corner(index) {
                Some(number) => number,
                None => self.record_vertex((index, at), vertex, positions, cache, list)?,
            };
        }
        list.push(numbers, first_row);
        Some(())
    }

    /// Makes a vertex's attributes and records it; corner number `at` of a triangle.
    #[inline(never)]
    fn record_vertex<P: Positions>(
        &self,
        (index, at): (u32, usize),
        vertex: &ScreenVertex,
        positions: &P,
        cache: &mut CacheView<'_, u16>,
        list: &mut DisplayList<'_, Corner<H::Varying>>,
    ) -> Option<u16> {
        let corner = match self.made(index, index, positions) {
            Some(corner) => corner,
            // Nobody looks at it.
            None if at > 0 && !H::Varying::INTERPOLATED => Corner::<H::Varying>::default(),
            None => return None,
        };
        let number = list.push_vertex(vertex, corner);
        cache.keep_corner(index, number);
        Some(number)
    }

    /// Records a triangle with attributes of its own, or a piece of a clipped one.
    #[inline(never)]
    fn record_alone<P: Positions>(
        &self,
        face: &mut Face,
        first_row: u16,
        positions: &P,
        fan: &Fan,
        list: &mut DisplayList<'_, Corner<H::Varying>>,
    ) -> Option<()> {
        let corners = if self.vertices.by_face {
            self.face_corners(face, positions)?
        } else {
            let [a, b, c] = face.vertices;
            let corner = |index| self.made(index, index, positions);
            let provoking = corner(a)?;
            if H::Varying::INTERPOLATED {
                [provoking, corner(b)?, corner(c)?]
            } else {
                [provoking; 3]
            }
        };
        let [provoking, ..] = corners;
        if face.clipped {
            face.covered = true;
            let mixed = fan.mixed::<H::Varying>(&corners, face.triangle.flipped);
            list.push_piece(&face.triangle, &mixed, provoking, first_row);
            return Some(());
        }
        let [a, b, c] = &face.triangle.v;
        let [p, q, r] = face.in_order(corners);
        let numbers = [(a, p), (b, q), (c, r)].map(|(v, corner)| list.push_vertex(v, corner));
        list.push(numbers, first_row);
        Some(())
    }
}
