//! Lines pixel by pixel.

use super::super::fill::Access;
use crate::color::Format;
use crate::frame::{DepthAccess, Frame, Rect, Supplies};
use crate::raster::{
    depth_along, limited, plane_triangle, Gradients, Line, MidpointPath, Path, Pixel, Plane,
    PointSquare, ScreenVertex, Span, Steps,
};
use crate::shade::{ColorOutput, Corner, DepthTest, Event, Fragments, Row, State, Varying};

/// A line to be drawn.
pub struct LineDraw<'a, V: Varying> {
    pub(in crate::pipeline) ends: [ScreenVertex; 2],
    pub(in crate::pipeline) corners: &'a [Corner<V>; 2],
    pub(in crate::pipeline) provoking: &'a Corner<V>,
    /// What is drawn of the picture.
    pub(in crate::pipeline) area: Rect,
    /// Pixels of the strip that came before.
    pub(in crate::pipeline) before: u32,
}

impl<V: Varying> core::fmt::Debug for LineDraw<'_, V> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("LineDraw").field("ends", &self.ends).finish_non_exhaustive()
    }
}

/// What became of a line.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    pub(in crate::pipeline) event: Event,
    /// Pixels along the line, drawn or not.
    pub(in crate::pipeline) pixels: u32,
}

/// Which pixels of a line are drawn.
pub trait Pattern: Copy {
    /// The pattern at a pixel, counted from its beginning.
    fn started(self, pixel: u32) -> Self;
    /// Whether the pixel is drawn.
    fn is_on(&self) -> bool;
    /// Goes to the next pixel, or back.
    fn step(&mut self, forwards: bool);
}

/// All of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Continuous;

impl Pattern for Continuous {
    #[inline(always)]
    fn started(self, _pixel: u32) -> Self {
        self
    }

    #[inline(always)]
    fn is_on(&self) -> bool {
        true
    }

    #[inline(always)]
    fn step(&mut self, _forwards: bool) {}
}

/// Lines that are made of one pixel a column or row, and of copies of them beside it.
pub trait Replicated: Copy {
    /// By the diamond-exit rule; else by the midpoint algorithm.
    const EXACT: bool;

    /// How many copies there are.
    fn width(&self) -> i32;

    /// Draws a line.
    #[inline(always)]
    fn draw_with<H, S, F, D, P>(
        &self,
        pattern: P,
        line: &LineDraw<'_, H::Varying>,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
    ) -> Outcome
    where
        H: Fragments,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        P: Pattern,
    {
        let width = self.width();
        let none = Outcome { event: Event::Degenerate, pixels: 0 };
        if Self::EXACT {
            let Some(found) = exact(&line.ends, width) else { return none };
            let (path, head) = (found.path(), found.head());
            Stroke { line, path, head, style: *self, pattern }.draw(frame, state, shader)
        } else {
            let [a, b] = &line.ends;
            let Some(path) = MidpointPath::between(a, b) else { return none };
            Stroke { line, path, head: None, style: *self, pattern }.draw(frame, state, shader)
        }
    }
}

/// The line by the diamond-exit rule whose copies make one of this width.
#[inline(never)]
fn exact(ends: &[ScreenVertex; 2], width: i32) -> Option<Line> {
    let [a, b] = *ends;
    if width == 1 {
        return Line::between(a, b);
    }
    let side = |to: i32, from: i32| to.wrapping_sub(from).unsigned_abs();
    let by_columns = side(b.x_bits(), a.x_bits()) >= side(b.y_bits(), a.y_bits());
    let back = width.wrapping_sub(1).wrapping_mul(8);
    let (x, y) = if by_columns { (0, back) } else { (back, 0) };
    let moved = |v: ScreenVertex| {
        ScreenVertex::from_bits(v.x_bits().wrapping_sub(x), v.y_bits().wrapping_sub(y), v.z)
    };
    Line::between(moved(a), moved(b))
}

/// Whether a line one pixel wide is sure to lie in rows (or columns) `low..high`, and the pixels
/// beside it too.
#[inline(always)]
fn lies_within([a, b]: &[ScreenVertex; 2], by_columns: bool, low: i32, high: i32) -> bool {
    let (p, q) = if by_columns { (a.y_bits(), b.y_bits()) } else { (a.x_bits(), b.x_bits()) };
    p.min(q) >> 4 > low && (p.max(q) >> 4).wrapping_add(1) < high
}

/// The plane that has the mean of both ends' codes everywhere, rounded down.
fn mean([a, b]: &[ScreenVertex; 2]) -> Plane {
    let sum = u32::from(a.z).wrapping_add(b.z.into());
    Plane { origin: sum >> 1 << 16 | 0x8000, dx: 0, dy: 0 }
}

/// A line on its way into the frame.
struct Stroke<'a, V: Varying, R, L, P> {
    line: &'a LineDraw<'a, V>,
    path: R,
    /// The pixel about the first corner that has the corner's attributes.
    head: Option<Pixel>,
    style: L,
    pattern: P,
}

/// Pixels of one column (or row) each, to be drawn in one go.
struct Pixels<V: Varying, T> {
    first: Pixel,
    last: Pixel,
    count: u32,
    by_columns: bool,
    steps: T,
    least_step: (i32, i32),
    z: u32,
    z_step: u32,
    varying: V,
    step: V::Step,
}

impl<V: Varying, R: Path, L: Replicated, P: Pattern> Stroke<'_, V, R, L, P> {
    /// Draws it.
    ///
    /// One copy of this, with the pixel loop, is what a shader, a state and a style cost in flash.
    #[inline(never)]
    fn draw<H, S, F, D>(&self, frame: &mut Frame<'_, F, D>, state: &mut S, shader: &H) -> Outcome
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let LineDraw { ends, corners, provoking, area, before } = *self.line;
        let width = self.style.width();
        let (depth, output, _) = state.parts();
        let ends = if depth.maps() {
            ends.map(|end| ScreenVertex { z: depth.map(end.z), ..end })
        } else {
            ends
        };
        let is_constant = depth.is_constant();
        let corners = if H::COLOR_AS_IS && output.dims() {
            &corners.each_ref().map(V::dim::<F>)
        } else {
            corners
        };
        let by_columns = self.path.by_columns();
        let (from, to) = self.path.ends();
        let along = to.wrapping_sub(from).max(0).cast_unsigned();
        let headed = i32::from(self.head.is_some());
        let pixels = along.wrapping_add(headed.cast_unsigned());
        let forwards = if by_columns {
            ends[1].x_bits() > ends[0].x_bits()
        } else {
            ends[1].y_bits() > ends[0].y_bits()
        };
        let mut is_drawn = false;
        if let Some(head) = self.head {
            let (varying, step) = V::on_point(&corners[0], &PointSquare::NONE, head.x, head.y);
            let z =
                if is_constant { mean(&ends).origin } else { u32::from(ends[0].z) << 16 | 0x8000 };
            let pattern = self.pattern.started(before);
            for copy in 0..width {
                let (x, y) = if by_columns { (0, copy) } else { (copy, 0) };
                let first = Pixel { x: head.x.wrapping_add(x), y: head.y.wrapping_add(y) };
                if area.contains(first.x, first.y) {
                    is_drawn = true;
                    let (steps, least_step) = (self.path.steps(from), (0, 0));
                    Pixels {
                        first,
                        last: first,
                        count: 1,
                        by_columns,
                        steps,
                        least_step,
                        z,
                        z_step: 0,
                        varying,
                        step,
                    }
                    .draw::<H, S, F, D, P>(pattern, forwards, frame, state, shader);
                }
            }
        }
        let (low, high, left, right) = if by_columns {
            (area.top, area.bottom, area.left, area.right)
        } else {
            (area.left, area.right, area.top, area.bottom)
        };
        let (start, end) = (from.max(left), to.min(right));
        let (start, end) = if width == 1 && lies_within(&ends, by_columns, low, high) {
            (start, end)
        } else {
            let lowest = low.wrapping_sub(width).wrapping_add(1);
            limited(&self.path, start, end, lowest, high)
        };
        if start >= end {
            let event = if is_drawn { Event::Drawn } else { Event::Outside };
            return Outcome { event, pixels };
        }
        // What neither depth nor varyings ask for is not computed.
        let gradients = if V::INTERPOLATED {
            Gradients::new(&plane_triangle(&ends, by_columns))
        } else {
            Gradients::NONE
        };
        let z_plane = match <Access<S>>::HAS_DEPTH {
            true if is_constant => mean(&ends),
            true => depth_along(&ends, &self.path),
            false => Plane::default(),
        };
        let in_pieces = V::PIECE != 0 && gradients.reach_beyond(V::PIECE / 2);
        let [p, q] = *corners;
        let mut planes = V::planes(&gradients, &[p, q, p], provoking, in_pieces);
        // Planes are level across the line: any row will do.
        let level = if by_columns { ends[0].y_bits() } else { ends[0].x_bits() } >> 4;
        // Where rows of colour and of depth differ in length, pixel by pixel.
        let has_one_stride = frame.has_one_stride::<Access<S>>();
        let longest = |path: &R, at: i32| {
            if has_one_stride {
                path.good_until(at)
            } else {
                at.wrapping_add(1)
            }
        };
        for copy in 0..width {
            let (mut at, end) = if width == 1 {
                (start, end)
            } else {
                let (low, high) = (low.wrapping_sub(copy), high.wrapping_sub(copy));
                limited(&self.path, start, end, low, high)
            };
            is_drawn |= at < end;
            while at < end {
                let mut stop = end.min(longest(&self.path, at));
                if in_pieces {
                    let piece = at.wrapping_sub(from).wrapping_div(V::PIECE);
                    let begin = from.wrapping_add(piece.wrapping_mul(V::PIECE));
                    V::settle(&mut planes, begin, level);
                    stop = stop.min(begin.wrapping_add(V::PIECE));
                }
                let span = Span { y: level, first: from, left: at, right: stop, behind: to };
                let mut runs = V::runs(&planes, &span);
                let (varying, step, good) = V::run(&planes, &mut runs, &span, at);
                stop = stop.min(good);
                let pixel = |at: i32| {
                    let minor = self.path.minor(at).wrapping_add(copy);
                    if by_columns {
                        Pixel { x: at, y: minor }
                    } else {
                        Pixel { x: minor, y: at }
                    }
                };
                let behind = if forwards { at.wrapping_sub(from) } else { to.wrapping_sub(at) };
                let number = behind.wrapping_sub(i32::from(!forwards)).wrapping_add(headed);
                let pattern = self.pattern.started(before.wrapping_add(number.cast_unsigned()));
                Pixels {
                    first: pixel(at),
                    last: pixel(stop.wrapping_sub(1)),
                    count: stop.wrapping_sub(at).cast_unsigned(),
                    by_columns,
                    steps: self.path.steps(at),
                    least_step: self.path.least_step(),
                    z: z_plane.at(at, level),
                    z_step: z_plane.dx,
                    varying,
                    step,
                }
                .draw::<H, S, F, D, P>(pattern, forwards, frame, state, shader);
                at = stop;
            }
        }
        Outcome { event: if is_drawn { Event::Drawn } else { Event::Outside }, pixels }
    }
}

impl<V: Varying, T: Steps + Copy> Pixels<V, T> {
    /// Draws them.
    #[inline(always)]
    fn draw<H, S, F, D, P>(
        &self,
        pattern: P,
        forwards: bool,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
    ) where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        P: Pattern,
    {
        let stride = frame.stride();
        let (least, _) = self.least_step;
        // A step back across does not lead to the same place; places are below 2^13 x 2^16.
        if !(2..1 << 16).contains(&stride) || (self.by_columns && least < 0) {
            self.walk::<false, false, H, S, F, D, P>(pattern, forwards, frame, state, shader);
        } else if self.by_columns {
            self.walk::<true, false, H, S, F, D, P>(pattern, forwards, frame, state, shader);
        } else {
            self.walk::<true, true, H, S, F, D, P>(pattern, forwards, frame, state, shader);
        }
    }

    /// The pixel loop. Apart, so that the registers are its own. `ORDERED` says that each pixel lies
    /// behind the one before in the frame: then the loop ends where the frame's part that holds them
    /// ends, without a count. `ROWS` says that there is one pixel a row.
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation, reason = "of rows, strides are below 2^16")]
    fn walk<const ORDERED: bool, const ROWS: bool, H, S, F, D, P>(
        &self,
        mut pattern: P,
        forwards: bool,
        frame: &mut Frame<'_, F, D>,
        state: &mut S,
        shader: &H,
    ) where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        P: Pattern,
    {
        let Self { first, last, by_columns, mut steps, mut z, z_step, mut varying, step, .. } =
            *self;
        let (depth, output, counter) = state.parts();
        let stride = frame.stride();
        let (least, sign) = self.least_step;
        let Pixel { mut x, mut y } = first;
        let Some((pixels, mut cells, start)) = frame.all_from::<Access<S>>(x, y) else { return };
        let (columns, rows) = (last.x.wrapping_sub(x), last.y.wrapping_sub(y));
        let behind = start
            .wrapping_add(columns as usize)
            .wrapping_add(stride.wrapping_mul(rows as usize))
            .wrapping_add(1);
        let length = if ORDERED { behind } else { pixels.len() };
        let Some(pixels) = pixels.get_mut(..length) else { return };
        let Some(mut cells) = <Access<S>>::part(&mut cells, 0, length) else { return };
        let (along, across) = if by_columns { (1, stride) } else { (stride, 1) };
        let across = across.wrapping_mul(sign as usize);
        let least_across = least.wrapping_mul(sign).cast_unsigned();
        let by_columns = !ROWS && by_columns;
        let plain = along.wrapping_add(across.wrapping_mul(least_across.cast_signed() as usize));
        // Of rows in order the steps count the place itself.
        if ROWS {
            steps.begin(start as u32, plain as u32);
        }
        let (mut at, mut count) = (start, self.count);
        loop {
            let place = if ROWS { steps.number() as usize } else { at };
            let Some(pixel) = pixels.get_mut(place) else { return };
            if pattern.is_on() {
                let Some(cells) = <Access<S>>::one(&mut cells, place) else { return };
                shader.span(Row::<S, F, V> {
                    x,
                    y,
                    pixels: core::slice::from_mut(pixel),
                    cells,
                    z,
                    z_step,
                    may_be_level: false,
                    varying,
                    step,
                    behind: None,
                    depth,
                    output,
                    counter: &mut *counter,
                });
            }
            pattern.step(forwards);
            z = z.wrapping_add(z_step);
            varying.step(&step);
            let further = if ROWS {
                let before = steps.number();
                steps.step();
                steps.number().wrapping_sub(before).wrapping_sub(stride as u32)
            } else {
                let carries = steps.carries();
                at = at.wrapping_add(plain);
                if carries {
                    at = at.wrapping_add(across);
                }
                least_across.wrapping_add(carries.into())
            };
            let further = further.cast_signed().wrapping_mul(sign);
            if by_columns {
                (x, y) = (x.wrapping_add(1), y.wrapping_add(further));
            } else {
                (x, y) = (x.wrapping_add(further), y.wrapping_add(1));
            }
            if !ORDERED {
                count = count.wrapping_sub(1);
                if count == 0 {
                    return;
                }
            }
        }
    }
}
