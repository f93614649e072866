use super::fill::{Access, Fill, Walk};
use super::{Cull, CulledWindings, Winding};
use crate::color::Format;
use crate::frame::{Frame, Supplies};
use crate::raster::{Line, PointWalk, ScreenVertex, SpanBatch, SpanWalk, Traversal, Triangle};
use crate::shade::{
    Blend, ColorMask, Corner, Counter, Counting, DepthTest, Dither, Event, Output, Shader, State,
    States, Stats,
};

/// A corner on the screen and what shader `H` interpolates from it.
pub type ShadedVertex<H> = (ScreenVertex, Corner<<H as Shader>::Varying>);

/// Draws primitives that are in screen space already: below the vertex stage, with the same state,
/// shaders and pixel loop.
///
/// Corners come with their varyings; a shader's `prepare` and `vertex` are not called. Coordinates
/// may reach 4096 pixels from the picture's centre; primitives beyond are skipped and counted.
///
/// ```
/// use microraster::raster::ScreenVertex;
/// use microraster::{Frame, Gouraud, Rgb, Rgb565, ScreenPass, Size};
///
/// let mut pixels = [0u16; 16 * 8];
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(16, 8))?;
/// let corner = |x: i32, y: i32, color: Rgb| (ScreenVertex::from_bits(16 * x, 16 * y, 0), color.into());
/// let triangle = [corner(0, 0, Rgb::RED), corner(16, 0, Rgb::GREEN), corner(0, 8, Rgb::BLUE)];
/// ScreenPass::new().triangle(&mut frame, &Gouraud::colored(), &triangle);
/// assert_ne!(pixels[0], 0);
/// # Ok::<(), microraster::FrameError>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct ScreenPass<S = States> {
    pub(super) cull: Cull,
    pub(super) front: Winding,
    pub(super) state: S,
}

impl ScreenPass {
    /// A pass that draws all primitives, without depth.
    pub fn new() -> Self {
        Self::default()
    }
}

impl<D, C, T, O> ScreenPass<States<D, C, T, O>> {
    /// Tests depth, and writes it where the test says so.
    pub fn depth<N: DepthTest>(self, depth: N) -> ScreenPass<States<N, C, T, O>> {
        self.map(|States { counter, traversal, output, .. }| States {
            depth,
            counter,
            traversal,
            output,
        })
    }

    /// Counts triangles and pixels into `stats`, on top of what it holds.
    pub fn count(self, stats: &mut Stats) -> ScreenPass<States<D, Counting<'_>, T, O>> {
        let counter = Counting(stats);
        self.map(|States { depth, traversal, output, .. }| States {
            depth,
            counter,
            traversal,
            output,
        })
    }

    /// Finds pixels in another way; all ways give the same picture.
    pub fn traversal<N: Traversal>(self, traversal: N) -> ScreenPass<States<D, C, N, O>> {
        self.map(|States { depth, counter, output, .. }| States {
            depth,
            counter,
            traversal,
            output,
        })
    }

    fn map<N>(self, change: impl FnOnce(States<D, C, T, O>) -> N) -> ScreenPass<N> {
        let Self { cull, front, state } = self;
        ScreenPass { cull, front, state: change(state) }
    }
}

#[allow(clippy::type_complexity, reason = "each parameter is one setting")]
impl<D, C, T, B, W, M> ScreenPass<States<D, C, T, Output<B, W, M>>> {
    /// Blends colours with those that are stored.
    pub fn blend<N: Blend>(self, blend: N) -> ScreenPass<States<D, C, T, Output<N, W, M>>> {
        self.map(|state| {
            state.map_output(|Output { dither, mask, .. }| Output { blend, dither, mask })
        })
    }

    /// Dithers colours where the format has fewer than eight bits a channel.
    pub fn dither<N: Dither>(self, dither: N) -> ScreenPass<States<D, C, T, Output<B, N, M>>> {
        self.map(|state| {
            state.map_output(|Output { blend, mask, .. }| Output { blend, dither, mask })
        })
    }

    /// Writes only some of the channels.
    pub fn color_mask<N: ColorMask>(self, mask: N) -> ScreenPass<States<D, C, T, Output<B, W, N>>> {
        self.map(|state| {
            state.map_output(|Output { blend, dither, .. }| Output { blend, dither, mask })
        })
    }
}

impl<S> ScreenPass<S> {
    /// Leaves out triangles by the side that they show.
    #[must_use]
    pub fn cull(mut self, cull: Cull) -> Self {
        self.cull = cull;
        self
    }

    /// Says which winding is the front.
    #[must_use]
    pub fn front_face(mut self, winding: Winding) -> Self {
        self.front = winding;
        self
    }
}

impl<S: State> ScreenPass<S> {
    /// Draws a triangle; flat shaders take the first corner's colour.
    pub fn triangle<H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        corners: &[ShadedVertex<H>; 3],
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.triangles(frame, shader, core::slice::from_ref(corners));
    }

    /// Draws lines one pixel wide; flat shaders take the first corner's colour.
    ///
    /// # Rounding
    /// The pixels are exact by the diamond-exit rule of OpenGL 4.6, section 14.5.1, so that the
    /// joints of a chain are drawn once. Attributes run from corner to corner along the longer
    /// side, in equal steps.
    pub fn lines<'t, H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        lines: impl IntoIterator<Item = &'t [ShadedVertex<H>; 2]>,
    ) where
        H: Shader,
        H::Varying: 't,
        F: Format,
        D: Supplies<Access<S>>,
    {
        for [(a, p), (b, q)] in lines {
            self.event(Event::Line);
            if !a.in_range(frame.picture()) || !b.in_range(frame.picture()) {
                self.event(Event::Skipped);
                continue;
            }
            let Some(line) = Line::between(*a, *b) else {
                self.event(Event::Degenerate);
                continue;
            };
            // The pixel before the first corner has the corner's attributes, the others their own.
            let (triangle, area) = (line.plane_triangle(), frame.scissor());
            let head = line.head(area).is_some_and(|mut walk| {
                let triangle = &Triangle { v: [*a; 3], ..triangle };
                let fill = Fill { triangle, corners: &[*p; 3], provoking: p };
                self.fill(frame, shader, &fill, &mut walk)
            });
            let fill = Fill { triangle: &triangle, corners: &[*p, *q, *p], provoking: p };
            let rest = self.fill(frame, shader, &fill, &mut line.walk(area));
            self.event(if head || rest { Event::Drawn } else { Event::Outside });
        }
    }

    /// Draws points as squares of `size` pixels about their corners, one colour and depth each.
    ///
    /// # Rounding
    /// None: the pixels are those whose centres lie in the half-open square about the corner as it
    /// is (OpenGL 4.6, section 14.4).
    pub fn points<'t, H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        size: u16,
        points: impl IntoIterator<Item = &'t ShadedVertex<H>>,
    ) where
        H: Shader,
        H::Varying: 't,
        F: Format,
        D: Supplies<Access<S>>,
    {
        for (vertex, corner) in points {
            self.event(Event::Point);
            if !vertex.in_range(frame.picture()) {
                self.event(Event::Skipped);
                continue;
            }
            if size == 0 {
                self.event(Event::Degenerate);
                continue;
            }
            let triangle = &Triangle { v: [*vertex; 3], area: 1, flipped: false };
            let fill = Fill { triangle, corners: &[*corner; 3], provoking: corner };
            let mut walk = PointWalk::new(vertex, size, frame.scissor());
            let drawn = self.fill(frame, shader, &fill, &mut walk);
            self.event(if drawn { Event::Drawn } else { Event::Outside });
        }
    }

    /// Draws what a walk finds; whether that was anything.
    fn fill<H, F, D, W>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        fill: &Fill<'_, H::Varying>,
        walk: &mut W,
    ) -> bool
    where
        W: SpanWalk,
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let mut batch = SpanBatch::default();
        walk.next_spans(&mut batch);
        if batch.is_empty() {
            return false;
        }
        fill.draw(frame, &mut self.state, shader, walk, &mut batch);
        true
    }

    #[inline(always)]
    fn event(&mut self, event: Event) {
        self.state.counter().event(event);
    }

    /// Draws triangles one after the other: cheaper than one call for each.
    pub fn triangles<'t, H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        triangles: impl IntoIterator<Item = &'t [ShadedVertex<H>; 3]>,
    ) where
        H: Shader,
        H::Varying: 't,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let (mut walk, mut batch) = (Walk::<S>::default(), SpanBatch::default());
        let culled = CulledWindings::new(self.cull, self.front);
        let area = frame.scissor();
        for [(a, p), (b, q), (c, r)] in triangles {
            let counter = self.state.counter();
            counter.event(Event::Triangle);
            let vertices = [*a, *b, *c];
            if !Triangle::in_range(&vertices, frame.picture()) {
                counter.event(Event::Skipped);
                continue;
            }
            let triangle = Triangle::oriented(vertices);
            let Some(triangle) = &triangle else {
                counter.event(Event::Degenerate);
                continue;
            };
            if culled.contain(if triangle.flipped { -1 } else { 1 }) {
                counter.event(Event::Culled);
                continue;
            }
            self.state.traversal().start(&mut walk, triangle, &area, &mut batch);
            if batch.is_empty() {
                self.state.counter().event(Event::Outside);
                continue;
            }
            self.state.counter().event(Event::Drawn);
            let ordered = if triangle.flipped { [*p, *r, *q] } else { [*p, *q, *r] };
            Fill { triangle, corners: &ordered, provoking: p }.draw(
                frame,
                &mut self.state,
                shader,
                &mut walk,
                &mut batch,
            );
        }
    }
}
