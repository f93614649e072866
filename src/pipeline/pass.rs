use super::assembly::{Assembly, MeshPositions, Positions};
use super::cache::CacheView;
use super::clipper::Fan;
use super::draw::Draw;
use super::fill::Access;
use super::mapping::Mapping;
use super::transform::{Depth, Place, Transform};
use super::{Cull, CulledWindings, VertexCache, Winding};
use crate::color::Format;
use crate::frame::{Damage, Frame, Rect, Size, Supplies, MAX_SIDE};
use crate::math::Mat4;
use crate::raster::{Traversal, GUARD, SUBPIXELS};
use crate::scene::{Camera, Mesh, Topology, Vertices};
use crate::shade::{
    Blend, ColorMask, Corner, Counter, Counting, DepthTest, Dither, DrawContext, Event, Output,
    Shader, State, States, Stats, Tracking, Uncounted,
};

/// Draws meshes: a camera, and the state in which triangles are drawn.
///
/// State that changes the pixel loop ([`depth`](Self::depth), [`count`](Self::count)) is part of
/// the type, so that what is not asked for is not there; the rest are plain values.
///
/// ```
/// use microraster::math::{Mat4, Vec3};
/// use microraster::models::TEAPOT;
/// use microraster::{Camera, Cull, Frame, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size, Stats};
/// # use microraster::math::AngleUnits;
///
/// let (mut pixels, mut depth) = ([0u16; 128 * 64], [0u16; 128 * 64]);
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(128, 64))?.with_depth(&mut depth)?;
/// let camera = Camera::perspective(45.0.degrees(), 0.5)
///     .look_at(Vec3::new(0.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y);
/// let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE);
/// let mut stats = Stats::default();
/// Pass::new(&camera).cull(Cull::Back).depth(Less).count(&mut stats).draw(
///     &mut frame,
///     &Mat4::identity(),
///     &TEAPOT,
///     &Gouraud::lit(&[sun]),
/// );
/// assert_eq!((stats.triangles, stats.skipped), (992, 0));
/// # Ok::<(), microraster::FrameError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pass<'c, S = States> {
    camera: &'c Camera,
    cull: Cull,
    front: Winding,
    viewport: Option<Rect>,
    pub(super) state: S,
}

impl<'c> Pass<'c> {
    /// A pass that draws all triangles, without depth, into the whole picture.
    pub fn new(camera: &'c Camera) -> Self {
        Self {
            camera,
            cull: Cull::None,
            front: Winding::CounterClockwise,
            viewport: None,
            state: States::default(),
        }
    }
}

impl<'c, D, C, T, O> Pass<'c, States<D, C, T, O>> {
    /// Tests depth, and writes it where the test says so: [`Less`](crate::Less) and its kin.
    pub fn depth<N: DepthTest>(self, depth: N) -> Pass<'c, States<N, C, T, O>> {
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
    pub fn track_damage(self, damage: &mut Damage) -> Pass<'c, States<D, Tracking<'_, C>, T, O>> {
        self.map(|States { depth, counter, traversal, output }| States {
            depth,
            counter: Tracking(damage, counter),
            traversal,
            output,
        })
    }

    /// Finds pixels in another way; all ways give the same picture.
    pub fn traversal<N: Traversal>(self, traversal: N) -> Pass<'c, States<D, C, N, O>> {
        self.map(|States { depth, counter, output, .. }| States {
            depth,
            counter,
            traversal,
            output,
        })
    }

    fn map<N>(self, change: impl FnOnce(States<D, C, T, O>) -> N) -> Pass<'c, N> {
        let Self { camera, cull, front, viewport, state } = self;
        Pass { camera, cull, front, viewport, state: change(state) }
    }
}

impl<'c, D, T, O> Pass<'c, States<D, Uncounted, T, O>> {
    /// Counts triangles and pixels into `stats`, on top of what it holds.
    pub fn count(self, stats: &mut Stats) -> Pass<'c, States<D, Counting<'_>, T, O>> {
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
impl<'c, D, C, T, B, W, M> Pass<'c, States<D, C, T, Output<B, W, M>>> {
    /// Blends colours with those that are stored: [`Alpha`](crate::Alpha) and its kin.
    pub fn blend<N: Blend>(self, blend: N) -> Pass<'c, States<D, C, T, Output<N, W, M>>> {
        self.map(|state| {
            state.map_output(|Output { dither, mask, .. }| Output { blend, dither, mask })
        })
    }

    /// Dithers colours where the format has fewer than eight bits a channel:
    /// [`Dither4`](crate::Dither4) or [`Dither8`](crate::Dither8).
    pub fn dither<N: Dither>(self, dither: N) -> Pass<'c, States<D, C, T, Output<B, N, M>>> {
        self.map(|state| {
            state.map_output(|Output { blend, mask, .. }| Output { blend, dither, mask })
        })
    }

    /// Writes only some of the channels: [`Channels`](crate::Channels).
    pub fn color_mask<N: ColorMask>(self, mask: N) -> Pass<'c, States<D, C, T, Output<B, W, N>>> {
        self.map(|state| {
            state.map_output(|Output { blend, dither, .. }| Output { blend, dither, mask })
        })
    }
}

impl<S> Pass<'_, S> {
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

    /// Draws into a part of the picture; nothing is drawn outside of it.
    ///
    /// # Range
    /// At most 8192 pixels a side; a larger one, or an empty one, draws nothing.
    #[must_use]
    pub fn viewport(mut self, viewport: Rect) -> Self {
        self.viewport = Some(viewport);
        self
    }
}

/// An area without a pixel, beside every corner that there may be.
const NOWHERE: Rect = Rect { left: 1 << 24, top: 1 << 24, right: 1 << 24, bottom: 1 << 24 };

/// The largest coordinate of a viewport: far beyond any picture, and nothing overflows.
pub(super) const FARTHEST: u32 = 1 << 16;

const _: () = assert!(
    (FARTHEST as i64 + MAX_SIDE as i64 + 2 * GUARD as i64) * (SUBPIXELS as i64) < i32::MAX as i64,
    "corners about a viewport so far away have coordinates"
);

impl<S: State> Pass<'_, S> {
    /// Draws a mesh: `model` leads from its own space to the world.
    ///
    /// Vertices that triangles share are transformed once while they are among the 32 newest by
    /// slot; see [`draw_cached`](Self::draw_cached) for more.
    pub fn draw<H, F, D, T>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 3]>,
    {
        let mut cache = VertexCache::<Corner<H::Varying>, 32>::new();
        self.draw_cached(frame, model, mesh, shader, &mut cache);
    }

    /// Draws a mesh with a vertex cache of the caller's.
    pub fn draw_cached<H, F, D, T, const N: usize>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
        cache: &mut VertexCache<Corner<H::Varying>, N>,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        T: Topology<Primitive = [u32; 3]>,
    {
        let work = Triangles { topology: mesh.topology, cache: cache.start() };
        self.perform(frame, model, mesh.vertices(), shader, work);
    }

    /// What a draw of a mesh needs beside the mesh, within `scissor`; `transform` is set where the
    /// mesh has the positions. `None` if nothing can be drawn.
    #[inline(always)]
    pub(super) fn set_up<H: Shader>(
        &self,
        picture: Size,
        scissor: Rect,
        model: &Mat4,
        vertices: &Vertices<'_, H::Vertex>,
        shader: &H,
        transform: &mut Transform,
    ) -> Option<SetUp<H>> {
        let viewport = self.viewport.unwrap_or(Rect::from_size(picture));
        let near = self.camera.constant_near();
        let (scale, offset) = vertices.place();
        let place = (scale, offset.extend(1.0));
        let placed = (!H::OWN_POSITIONS).then_some(transform);
        let mapping = prepare(self.camera, near, model, &place, viewport, placed)?;
        let area = match scissor.intersection(viewport) {
            area if area.is_empty() => NOWHERE,
            area => area,
        };
        let culled = CulledWindings::new(self.cull, self.front);
        // What of this the shader does not look at is not made.
        let size = mapping.size();
        let context = DrawContext {
            model: *model,
            view: self.camera.view(),
            projection: self.camera.projection(aspect(size)),
            viewport: size,
            scale,
            offset,
        };
        let is_whole = area == viewport;
        Some(SetUp { mapping, area, is_whole, culled, prepared: shader.prepare(&context) })
    }

    /// Makes a mesh ready to be drawn, and draws it.
    #[inline(always)]
    pub(super) fn perform<H, F, D, W>(
        &mut self,
        frame: &mut Frame<'_, F, D>,
        model: &Mat4,
        vertices: &Vertices<'_, H::Vertex>,
        shader: &H,
        work: W,
    ) where
        H: Shader,
        F: Format,
        D: Supplies<Access<S>>,
        W: Work<H>,
    {
        let (picture, scissor) = (frame.picture(), frame.scissor());
        let mut transform = Transform::NONE;
        let ready = self.set_up(picture, scissor, model, vertices, shader, &mut transform);
        let Some(SetUp { mapping, area, is_whole, culled, prepared }) = ready else {
            work.skip(self.state.counter());
            return;
        };
        let draw = &Draw { vertices, shader, prepared: &prepared };
        let state = &mut self.state;
        if H::OWN_POSITIONS {
            work.run(
                &Ready { draw, positions: draw, mapping, area, is_whole, culled },
                frame,
                state,
            );
        } else {
            let positions = &MeshPositions { transform: &transform, positions: vertices.positions };
            work.run(&Ready { draw, positions, mapping, area, is_whole, culled }, frame, state);
        }
    }
}

/// What a draw of a mesh needs beside the mesh.
pub(super) struct SetUp<H: Shader> {
    pub(super) mapping: Mapping,
    /// What is drawn of the picture.
    pub(super) area: Rect,
    /// Whether that is all of the viewport.
    pub(super) is_whole: bool,
    pub(super) culled: CulledWindings,
    pub(super) prepared: H::Prepared,
}

/// What is done with a mesh that is ready to be drawn.
pub(super) trait Work<H: Shader> {
    /// Draws it.
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>;

    /// Says of all primitives that they cannot be drawn.
    fn skip<C: Counter>(self, counter: &mut C);
}

/// A mesh ready to be drawn.
pub(super) struct Ready<'a, H: Shader, P> {
    pub(super) draw: &'a Draw<'a, H>,
    pub(super) positions: &'a P,
    pub(super) mapping: Mapping,
    /// What is drawn of the picture.
    pub(super) area: Rect,
    /// Whether that is all of the viewport.
    pub(super) is_whole: bool,
    pub(super) culled: CulledWindings,
}

/// Draws filled triangles.
struct Triangles<'a, T, C> {
    topology: T,
    cache: CacheView<'a, C>,
}

impl<H, T> Work<H> for Triangles<'_, T, Corner<H::Varying>>
where
    H: Shader,
    T: Topology<Primitive = [u32; 3]>,
{
    #[inline(always)]
    fn run<P, S, F, D>(self, ready: &Ready<'_, H, P>, frame: &mut Frame<'_, F, D>, state: &mut S)
    where
        P: Positions,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let assembly = Assembly {
            topology: self.topology,
            cursor: T::Cursor::default(),
            mapping: ready.mapping,
            area: ready.area,
            is_whole: ready.is_whole && state.traversal().takes_whole_area(),
            culled: ready.culled,
            fan: Fan::default(),
            next_number: 0,
        };
        ready.draw.run(ready.positions, assembly, frame, state, self.cache);
    }

    fn skip<C: Counter>(self, counter: &mut C) {
        for _ in 0..self.topology.count() {
            counter.event(Event::Triangle);
            counter.event(Event::Skipped);
        }
    }
}

/// Width over height.
fn aspect(size: Size) -> f32 {
    f32::from(size.width) / f32::from(size.height)
}

/// The pixels of a side of a viewport; `None` if there are none, or what lies there is out of range.
#[inline(never)]
fn side(from: i32, to: i32) -> Option<u16> {
    // Wraps to something large where the viewport is empty.
    let pixels = u16::try_from(to.wrapping_sub(from)).ok()?;
    (from.unsigned_abs() <= FARTHEST && (1..=MAX_SIDE).contains(&pixels)).then_some(pixels)
}

/// From the matrices of a draw; `None` if they are not finite or the viewport is out of range.
///
/// `place` is the scale and the offset of the mesh's positions, and `transform` what they go
/// through, unless they come in clip space. That and `near`, the camera's
/// [`constant_near`](Camera::constant_near), are arguments because the compiler then sees what no
/// draw of a program asks for.
#[inline(never)]
fn prepare(
    camera: &Camera,
    near: Option<f32>,
    model: &Mat4,
    place: &Place,
    viewport: Rect,
    transform: Option<&mut Transform>,
) -> Option<Mapping> {
    let Rect { left, top, right, bottom } = viewport;
    let size = Size::new(side(left, right)?, side(top, bottom)?);
    let depth = match transform {
        Some(transform) => {
            let to_eye = camera.view().after(model);
            let matrix = camera.projection(aspect(size)).after(&to_eye);
            transform.set(&matrix, place, near)?
        }
        None => Depth::of_row(near.is_none()),
    };
    Some(Mapping::new(left, top, size, depth))
}
