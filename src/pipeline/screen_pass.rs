use super::fill::{find, find_spans, limits_of_few, Access, Fill, Walk};
use super::fill_few::draw_few;
use super::line::{LineDraw, Outcome};
use super::point::{draw_point, single_points};
use super::{Cull, CulledWindings, LineStyle, Winding};
use crate::color::Format;
use crate::frame::{Damage, Frame, Size, Supplies};
use crate::math::{Mat4, Vec3};
#[cfg(doc)]
use crate::raster::PointSquare;
use crate::raster::{Few, Fitted, Limits, Nothing, ScreenVertex, SpanBatch, Traversal};
use crate::shade::{
    Blend, Bound, ColorMask, Corner, Counter, Counting, DepthTest, Dither, DrawContext, Event,
    Fragments, Output, Shader, State, States, Stats, Tracking, Uncounted, Varying,
};

/// A corner on the screen and what shader `H` interpolates from it.
pub type ShadedVertex<H> = (ScreenVertex, Corner<<H as Shader>::Varying>);

/// Draws primitives that are in screen space already: below the vertex stage, with the same state,
/// shaders and pixel loop.
///
/// Corners come with their varyings; a shader's `vertex` is not called, and its `prepare` sees no
/// matrices but those that change nothing. Coordinates
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

    /// Adds to `damage` where triangles, lines and points are drawn, also where they are hidden: what
    /// of the picture a display has to be sent. In a pass that also
    /// counts, [`count`](Self::count) comes before this.
    ///
    /// # Cost
    /// Some ten instructions a row of each primitive, or each run of pixels in which a varying is
    /// interpolated between divisions.
    pub fn track_damage(self, damage: &mut Damage) -> ScreenPass<States<D, Tracking<'_, C>, T, O>> {
        self.map(|States { depth, counter, traversal, output }| States {
            depth,
            counter: Tracking(damage, counter),
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

impl<D, T, O> ScreenPass<States<D, Uncounted, T, O>> {
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

    /// Draws lines in a style, each on its own; flat shaders take the first corner's colour.
    ///
    /// ```
    /// use microraster::raster::ScreenVertex;
    /// use microraster::{Flat, Frame, Rgb, Rgb565, ScreenPass, Size, Stippled, Thin, Wide};
    ///
    /// let mut pixels = [0u16; 16 * 8];
    /// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(16, 8))?;
    /// let end = |x: i32, y: i32| (ScreenVertex::from_bits(16 * x, 16 * y, 0), Rgb::RED.into());
    /// let line = [end(1, 1), end(14, 4)];
    /// ScreenPass::new().lines(&mut frame, &Flat::colored(), Wide(3), &[line]);
    /// ScreenPass::new().lines(&mut frame, &Flat::colored(), Stippled::new(0x5555, 1, Thin), &[line]);
    /// # Ok::<(), microraster::FrameError>(())
    /// ```
    pub fn lines<'t, H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        style: impl LineStyle,
        lines: impl IntoIterator<Item = &'t [ShadedVertex<H>; 2]>,
    ) where
        H: Shader,
        H::Varying: 't,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let prepared = &shader.prepare(&context(frame.picture()));
        let bound = &Bound { shader, prepared };
        for [a, b] in lines {
            self.line(frame, bound, style, [a, b], 0);
        }
    }

    /// Draws lines from each corner to the next, in a style whose stipple goes on from line to line;
    /// flat shaders take the first corner's colour of each.
    pub fn line_strip<'t, H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        style: impl LineStyle,
        corners: impl IntoIterator<Item = &'t ShadedVertex<H>>,
    ) where
        H: Shader,
        H::Varying: 't,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let prepared = &shader.prepare(&context(frame.picture()));
        let bound = &Bound { shader, prepared };
        let mut corners = corners.into_iter();
        let Some(mut a) = corners.next() else { return };
        let mut before = 0_u32;
        for b in corners {
            before = before.wrapping_add(self.line(frame, bound, style, [a, b], before));
            a = b;
        }
    }

    /// Draws a line; how many pixels it has.
    #[inline(always)]
    fn line<H, F, D>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        shader: &H,
        style: impl LineStyle,
        [(a, p), (b, q)]: [&(ScreenVertex, Corner<H::Varying>); 2],
        before: u32,
    ) -> u32
    where
        H: Fragments,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.event(Event::Line);
        if !a.in_range(frame.picture()) || !b.in_range(frame.picture()) {
            self.event(Event::Skipped);
            return 0;
        }
        let (ends, corners) = ([*a, *b], &[*p, *q]);
        let line = LineDraw { ends, corners, provoking: p, area: frame.scissor(), before };
        let Outcome { event, pixels } = style.draw(&line, frame, &mut self.state, shader);
        self.event(event);
        pixels
    }

    /// Draws points as squares of `size` pixels about their corners, one depth each.
    ///
    /// # Rounding
    /// None: the pixels are those of [`PointSquare`].
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
        let (area, picture) = (frame.scissor(), frame.picture());
        let prepared = &shader.prepare(&context(picture));
        let bound = &Bound { shader, prepared };
        let state = &mut self.state;
        if size == 1 && frame.has_one_stride::<Access<S>>() {
            single_points(frame, state, bound, picture, &area, points);
            return;
        }
        let size = u32::from(size).wrapping_mul(16);
        for (vertex, corner) in points {
            state.counter().event(Event::Point);
            let event = if vertex.in_range(picture) {
                draw_point(vertex, corner, size, &area, frame, state, bound)
            } else {
                Event::Skipped
            };
            state.counter().event(event);
        }
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
        let prepared = &shader.prepare(&context(frame.picture()));
        let bound = &Bound { shader, prepared };
        let mut walk = Walk::<S>::default();
        let mut batch = SpanBatch::made_by_stores();
        let culled = CulledWindings::new(self.cull, self.front);
        let (area, picture) = (frame.scissor(), frame.picture());
        let mut target = frame.target::<Access<S>>();
        let limits = limits_of_few::<H::Varying, S, F, D>(&self.state, &target, &area);
        let asked = if H::Varying::INTERPOLATED { Limits::NONE } else { limits };
        let mut fitted = Fitted::new(picture, asked, culled.by_winding());
        for corners in triangles {
            let [(a, p), (b, q), (c, r)] = corners;
            self.state.counter().event(Event::Triangle);
            let few = fitted.set(a, b, c);
            let (triangle, state) = (&fitted.triangle, &mut self.state);
            if !H::Varying::INTERPOLATED && few.covered() != 0 {
                state.counter().event(Event::Drawn);
                draw_few::<_, _, S, F, D, _>(corners, p, few, &mut target, state, bound);
                continue;
            }
            if few != Few::UNKNOWN {
                state.counter().event(match few.nothing() {
                    Nothing::Outside => Event::Outside,
                    Nothing::Culled => Event::Culled,
                    Nothing::Degenerate => Event::Degenerate,
                    Nothing::Beyond => Event::Skipped,
                });
                continue;
            }
            let found = if H::Varying::INTERPOLATED {
                let (walk, batch) = (&mut walk, &mut batch);
                find::<H::Varying, S>(state, triangle, &area, &limits, walk, batch).is_some()
            } else {
                find_spans::<H::Varying, S>(state, triangle, &area, &mut walk, &mut batch)
            };
            if !found {
                state.counter().event(Event::Outside);
                continue;
            }
            state.counter().event(Event::Drawn);
            let ordered = if triangle.flipped { [*p, *r, *q] } else { [*p, *q, *r] };
            Fill { triangle, corners: &ordered, provoking: p }.draw(
                &mut target,
                state,
                bound,
                &mut walk,
                &mut batch,
            );
        }
    }
}

/// What a shader sees of a draw without a camera: the screen, and matrices that change nothing.
fn context(viewport: Size) -> DrawContext {
    let none = Mat4::identity();
    let (scale, offset) = (Vec3::ONE, Vec3::ZERO);
    DrawContext { model: none, view: none, projection: none, scale, offset, viewport }
}
