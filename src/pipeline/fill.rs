use super::fill_few::draw_few;
use crate::color::Format;
use crate::frame::{DepthAccess, Rect, Supplies, Target, Window};
use crate::math::BY_HALVES;
use crate::raster::{
    Few, Gradients, Limits, Plane, ScreenVertex, SmallGradients, Span, SpanBatch, SpanWalk,
    Traversal, Triangle,
};
use crate::shade::{ColorOutput, Corner, DepthTest, Fragments, Ready, Row, State, Varying};

/// How a state touches depth.
pub(crate) type Access<S> = <<S as State>::Depth as DepthTest>::Access;

/// A triangle being walked under a state.
pub(super) type Walk<S> = <<S as State>::Traversal as Traversal>::Walk;

/// Which triangles are to be asked whether they cover [few](Few) pixels: none where rows are drawn one
/// at a time.
#[inline(always)]
pub(super) fn limits_of_few<V: Varying, S: State, F: Format, D>(
    state: &S,
    target: &Target<'_, '_, F, D, Access<S>>,
    area: &Rect,
) -> Limits {
    let asks = V::INTERPOLATED || matches!(target, Target::Whole(_));
    Limits::new(area, asks && state.traversal().leaves_few())
}

/// Looks for a triangle's first pixels: what it covers, where it is one of few pixels and nothing is
/// interpolated, and its first spans otherwise. `None` if there are none.
#[inline(always)]
pub(super) fn find<V: Varying, S: State>(
    state: &S,
    triangle: &Triangle,
    area: &Rect,
    limits: &Limits,
    walk: &mut Walk<S>,
    batch: &mut SpanBatch,
) -> Option<Few> {
    // Interpolated, they cost as much again for their planes: where the walk is cheap, the question
    // is not worth it.
    let asks = !V::INTERPOLATED || BY_HALVES;
    let few = if asks { Few::of(triangle, limits) } else { Few::UNKNOWN };
    if few == Few::UNKNOWN {
        find_spans::<V, S>(state, triangle, area, walk, batch).then_some(few)
    } else if few.covered() == 0 {
        None
    } else if V::INTERPOLATED {
        few.take(batch);
        Some(Few::UNKNOWN)
    } else {
        Some(few)
    }
}

/// Looks for a triangle's first spans; whether there are any.
#[inline(always)]
pub(super) fn find_spans<V: Varying, S: State>(
    state: &S,
    triangle: &Triangle,
    area: &Rect,
    walk: &mut Walk<S>,
    batch: &mut SpanBatch,
) -> bool {
    if draws_trapezoids::<V, S>() {
        return state.traversal().start_any(walk, triangle, area, batch);
    }
    state.traversal().start(walk, triangle, area, batch);
    !batch.is_empty()
}

/// Whether rows are drawn from their last pixel on: RISC-V adds no two registers for an address, so
/// that one number instead of two pointers spares nothing there.
const fn draws_from_last<V: Varying, S: State>() -> bool {
    let by_numbers = cfg!(not(target_arch = "riscv32"));
    S::Output::PLAIN && <Access<S>>::TOUCHES && V::JUMPS && by_numbers
}

/// Whether the rows of short triangles are drawn as they are walked: of colours that are flat or smooth,
/// whose pixel loop is short enough to be there twice. A shader's own `span` would no longer be inlined
/// where it is called twice.
const fn draws_trapezoids<V: Varying, S: State>() -> bool {
    let is_short = V::AT_ONCE || !V::INTERPOLATED;
    draws_from_last::<V, S>() && is_short && !V::IN_RUNS && !<Access<S>>::HAS_STENCIL
}

/// A triangle ready for its pixels: where it is, and its attributes in the same order.
#[derive(Clone, Copy)]
pub(super) struct Fill<'a, V: Varying> {
    pub(super) triangle: &'a Triangle,
    pub(super) corners: &'a [Corner<V>; 3],
    pub(super) provoking: &'a Corner<V>,
}

/// The plane of the depth codes: 16.16, raised by a half so that cutting off rounds.
#[inline(always)]
pub(super) fn depth_plane(gradients: &Gradients, triangle: &Triangle) -> Plane {
    let (first, to_second, to_third) = triangle.depth_codes();
    gradients.plane_from(first, to_second, to_third)
}

/// The same where nothing else is interpolated: a triangle of one depth needs no gradients.
#[inline(never)]
pub(super) fn lone_depth_plane(triangle: &Triangle) -> Plane {
    let (first, to_second, to_third) = triangle.depth_codes();
    if to_second | to_third == 0 {
        return Plane { origin: first, dx: 0, dy: 0 };
    }
    let Some(gradients) = SmallGradients::of::<BY_HALVES>(triangle) else {
        return any_depth_plane(triangle);
    };
    gradients.plane(first, to_second, to_third)
}

/// The same of triangles that are not small.
#[cold]
#[inline(never)]
fn any_depth_plane(triangle: &Triangle) -> Plane {
    let (first, to_second, to_third) = triangle.depth_codes();
    // Where only this is drawn, there is no other copy of the gradients.
    Gradients::inlined(triangle).inlined_plane(first, to_second, to_third)
}

/// The plane of a triangle that has the mean of its corners' codes everywhere.
#[inline(never)]
fn mean_depth_plane(triangle: &Triangle) -> Plane {
    let sum = triangle.v.iter().fold(0, |sum: u32, v| sum.wrapping_add(v.z.into()));
    Plane { origin: (sum / 3) << 16 | 0x8000, dx: 0, dy: 0 }
}

/// Moves a plane away by 16.16 codes, as far as all corners stay in range.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "below 2^32, wrapping")]
fn move_away(plane: &mut Plane, triangle: &Triangle, by: i64) {
    let codes = triangle.v.each_ref().map(|v| i64::from(v.z) << 16);
    let (least, most) =
        codes.iter().fold((i64::MAX, 0), |(least, most), code| (least.min(*code), most.max(*code)));
    let by = by.clamp(most.wrapping_sub(0xFFFF_0000), least);
    plane.origin = plane.origin.wrapping_sub(by as u32);
}

/// The planes of what is interpolated.
#[inline(always)]
pub(super) fn planes<V, H, S, F>(
    gradients: &Gradients,
    corners: &[Corner<V>; 3],
    provoking: &Corner<V>,
    in_pieces: bool,
    state: &mut S,
) -> V::Planes
where
    V: Varying,
    H: Fragments<Varying = V>,
    S: State,
    F: Format,
{
    if H::COLOR_AS_IS && state.parts().1.dims() {
        V::planes(gradients, &corners.each_ref().map(V::dim::<F>), provoking, in_pieces)
    } else {
        V::planes(gradients, corners, provoking, in_pieces)
    }
}

impl<V: Varying> Fill<'_, V> {
    /// The plane of a triangle's depth codes under a test.
    #[inline(always)]
    pub(super) fn depth_plane<const MOVES: bool>(
        triangle: &Triangle,
        gradients: &Gradients,
        depth: &impl DepthTest,
    ) -> Plane {
        let mapped: Triangle;
        let mut triangle = triangle;
        if depth.maps() {
            let v = triangle.v.map(|v| ScreenVertex { z: depth.map(v.z), ..v });
            mapped = Triangle { v, ..*triangle };
            triangle = &mapped;
        }
        let mut plane = if depth.is_constant() {
            mean_depth_plane(triangle)
        } else if V::INTERPOLATED {
            depth_plane(gradients, triangle)
        } else {
            lone_depth_plane(triangle)
        };
        if MOVES {
            Self::offset(&mut plane, triangle, depth);
        }
        plane
    }

    /// Moves a plane as a test says.
    #[inline(always)]
    fn offset(plane: &mut Plane, triangle: &Triangle, depth: &impl DepthTest) {
        let offset = depth.offset(plane.dx.cast_signed(), plane.dy.cast_signed());
        if offset != 0 {
            move_away(plane, triangle, offset);
        }
    }

    /// Draws the triangle's pixels: those that are known, or those of `batch` and all that `walk`
    /// still finds.
    #[inline(always)]
    pub(super) fn draw_known<H, S, F, D, W>(
        &self,
        few: Few,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        W: SpanWalk,
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        if !V::INTERPOLATED && few.covered() != 0 {
            draw_few::<V, H, S, F, D, _>(self.triangle, self.provoking, few, target, state, shader);
            return;
        }
        self.draw_all::<true, H, S, F, D, W>(target, state, shader, walk, batch);
    }

    /// Draws the triangle's pixels: those of `batch` and all that `walk` still finds.
    #[inline(always)]
    pub(super) fn draw<H, S, F, D, W>(
        &self,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        W: SpanWalk,
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.draw_all::<true, H, S, F, D, W>(target, state, shader, walk, batch);
    }

    /// The same without a polygon offset: for lines.
    #[inline(always)]
    pub(super) fn draw_unmoved<H, S, F, D, W>(
        &self,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        W: SpanWalk,
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        self.draw_all::<false, H, S, F, D, W>(target, state, shader, walk, batch);
    }

    /// One copy of this, with the pixel loop inlined, is what a shader and state cost in flash.
    #[inline(never)]
    fn draw_all<const MOVES: bool, H, S, F, D, W>(
        &self,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        W: SpanWalk,
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
    {
        let depth = state.parts().0;
        let at_once = <Access<S>>::HAS_DEPTH && !depth.is_constant() && !depth.maps();
        let in_pieces;
        let mut made = None;
        if at_once && V::AT_ONCE {
            if H::COLOR_AS_IS && state.parts().1.dims() {
                let corners = self.corners.each_ref().map(V::dim::<F>);
                V::at_once(self.triangle, &corners, &mut made);
            } else {
                V::at_once(self.triangle, self.corners, &mut made);
            }
            // They are always made: one question for both.
            in_pieces = made.as_ref().is_none_or(|ready| V::are_in_pieces(&ready.set.0));
            if MOVES {
                if let Some(ready) = &mut made {
                    Self::offset(&mut ready.set.1, self.triangle, state.parts().0);
                }
            }
        } else {
            // What neither depth nor varyings ask for is not computed.
            let gradients =
                if V::INTERPOLATED { Gradients::new(self.triangle) } else { Gradients::NONE };
            let z_plane = if <Access<S>>::HAS_DEPTH {
                Self::depth_plane::<MOVES>(self.triangle, &gradients, state.parts().0)
            } else {
                Plane::default()
            };
            in_pieces = V::PIECE != 0 && gradients.reach_beyond(V::PIECE / 2);
            let set =
                planes::<V, H, S, F>(&gradients, self.corners, self.provoking, in_pieces, state);
            made = Some(Ready { set: (set, z_plane) });
        }
        if draws_trapezoids::<V, S>() {
            match &mut *target {
                _ if !batch.has_trapezoids() => {}
                Target::Whole(window) if !in_pieces => {
                    let Some(ready) = &made else { return };
                    ready.draw_trapezoids::<H, S, F>(batch, window, state, shader);
                    return;
                }
                _ => batch.expand(),
            }
        }
        match &mut *target {
            Target::Whole(window) if !in_pieces => loop {
                let Some(ready) = &made else { return };
                let drawn = ready.draw::<H, S, F>(batch.spans(), window, state, shader);
                if drawn.is_none() || batch.is_last() {
                    return;
                }
                walk.next_spans(batch);
            },
            // Where this cannot be, it is not there.
            target if V::PIECE != 0 || <Access<S>>::TOUCHES => {
                let Some(ready) = &mut made else { return };
                ready.draw_apart::<H, S, F, D, W>(in_pieces, target, state, shader, walk, batch);
            }
            _ => {}
        }
    }
}

impl<V: Varying> Ready<V> {
    /// Draws spans, in pieces or not; `None` if the frame does not reach so far.
    #[inline(always)]
    fn draw_any<H, S, F>(
        &mut self,
        in_pieces: bool,
        spans: &[Span],
        window: &mut Window<'_, F, Access<S>>,
        state: &mut S,
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        if V::PIECE != 0 && in_pieces {
            self.draw_pieces::<H, S, F>(spans, window, state, shader)
        } else {
            self.draw::<H, S, F>(spans, window, state, shader)
        }
    }

    /// Draws all spans, in pieces where planes are to be settled, or each on a window of its own.
    ///
    /// Apart, so that other triangles and frames do not pay for it.
    #[inline(never)]
    fn draw_apart<H, S, F, D, W>(
        &mut self,
        in_pieces: bool,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        W: SpanWalk,
    {
        loop {
            match target {
                Target::Whole(window) if V::PIECE != 0 => {
                    self.draw_pieces::<H, S, F>(batch.spans(), window, state, shader)?;
                }
                Target::Whole(_) => return None,
                Target::Rows(frame) => {
                    for span in batch.spans() {
                        let mut window = frame.window(span)?;
                        let spans = core::slice::from_ref(span);
                        self.draw_any::<H, S, F>(in_pieces, spans, &mut window, state, shader)?;
                    }
                }
            }
            if batch.is_last() {
                return None;
            }
            walk.next_spans(batch);
        }
    }

    /// Draws spans in pieces, from each row's first covered pixel, and settles planes on each.
    ///
    /// Apart, so that other triangles do not pay for it.
    #[inline(never)]
    fn draw_pieces<H, S, F>(
        &mut self,
        spans: &[Span],
        window: &mut Window<'_, F, Access<S>>,
        state: &mut S,
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        // Kept in memory, which the pixel loop may change for all that the compiler knows.
        let mut kept = (self, spans.iter());
        core::hint::black_box(&mut kept);
        let in_place = S::Output::PLAIN && !V::IN_RUNS;
        let mut level = window.level()?;
        for span in kept.1.by_ref() {
            let mut left = span.left;
            loop {
                let Span { y, first, right, .. } = *span;
                let beyond =
                    (left.wrapping_sub(first) as u32).checked_rem(V::PIECE.unsigned_abs())?;
                let start = left.wrapping_sub(beyond.cast_signed());
                let end = start.wrapping_add(V::PIECE).min(right);
                let piece = Span { left, right: end, ..*span };
                let ready = &mut *kept.0;
                V::settle(&mut ready.set.0, start, y);
                // Planes are read anew: there are no registers for them until here.
                core::hint::black_box(());
                if in_place {
                    ready.draw_span::<H, S, F>(&piece, &mut level, state.parts(), shader)?;
                } else {
                    let spans = core::slice::from_ref(&piece);
                    ready.draw::<H, S, F>(spans, &mut level, state, shader)?;
                }
                if end >= right {
                    break;
                }
                left = end;
            }
        }
        Some(())
    }

    /// Draws spans; `None` if the frame does not reach so far.
    ///
    /// Apart from the walk, so that the registers are the pixel loop's.
    #[inline(never)]
    fn draw<H, S, F>(
        &self,
        spans: &[Span],
        window: &mut Window<'_, F, Access<S>>,
        state: &mut S,
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        let (depth, output, counter) = state.parts();
        let mut window = window.level()?;
        let mut spans = spans.iter();
        if V::INTERPOLATED && !BY_HALVES {
            // Kept in memory, which the pixel loop may change for all that the compiler knows:
            // otherwise it has a register in that loop, and what the loop needs is made anew for
            // each pixel.
            core::hint::black_box(&mut spans);
        }
        // Where the pixel loop needs many registers, planes stay where they are.
        let does_more_than_store = !S::Output::PLAIN || <Access<S>>::HAS_STENCIL;
        let planes_stay = if BY_HALVES {
            does_more_than_store || V::IN_RUNS
        } else {
            does_more_than_store && !<Access<S>>::HAS_DEPTH
        };
        let ready = if planes_stay { core::hint::black_box(self) } else { self };
        for span in spans.by_ref() {
            let parts = (depth, output, &mut *counter);
            ready.draw_span::<H, S, F>(span, &mut window, parts, shader)?;
        }
        Some(())
    }

    /// Draws a span; `None` if the frame does not reach so far.
    #[inline(always)]
    fn draw_span<H, S, F>(
        &self,
        span: &Span,
        window: &mut Window<'_, F, Access<S>>,
        (depth, output, counter): (&S::Depth, &S::Output, &mut S::Counter),
        shader: &H,
    ) -> Option<()>
    where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
    {
        let Self { set: (planes, z_plane) } = self;
        let by_numbers = cfg!(not(target_arch = "riscv32"));
        let from_last = draws_from_last::<V, S>();
        let Span { y, left, right, .. } = *span;
        // No row is longer. As the compiler knows it, one number is a pixel's place among colours
        // and cells, and the count.
        let longest = if from_last { 0xFFFF } else { usize::MAX };
        let mut runs = V::runs(planes, span);
        if V::IN_RUNS {
            let mut x = left;
            while x < right {
                let (varying, step, end) = V::run(planes, &mut runs, span, x);
                let end = end.min(right);
                let length = end.wrapping_sub(x) as usize & longest;
                let (pixels, cells) = window.row(y, x, length)?;
                let behind = from_last.then(|| {
                    let mut behind = varying;
                    behind.jump(&step, end.wrapping_sub(x));
                    (behind, z_plane.at(end, y))
                });
                shader.span(Row::<S, F, V> {
                    x,
                    y,
                    pixels,
                    cells,
                    z: z_plane.at(x, y),
                    z_step: z_plane.dx,
                    may_be_level: true,
                    varying,
                    step,
                    behind,
                    depth,
                    output,
                    counter: &mut *counter,
                });
                x = end;
            }
            return Some(());
        }
        let length = right.wrapping_sub(left) as usize & longest;
        // No span is empty: where the compiler is told that this ends the drawing, rows are not jumped
        // over.
        if from_last && V::INTERPOLATED && !<Access<S>>::HAS_STENCIL && length == 0 {
            return None;
        }
        let in_one_step = if BY_HALVES { from_last && V::INTERPOLATED } else { by_numbers };
        let (pixels, cells) = if in_one_step && !<Access<S>>::HAS_STENCIL {
            window.short_row(y, left, length)?
        } else {
            window.row(y, left, length)?
        };
        // Evaluated once: behind the row where it is drawn from its last pixel.
        let at = if from_last { right } else { left };
        let (mut varying, step, _) = V::run(planes, &mut runs, span, at);
        // Where planes stay in memory, one is read after the other.
        core::hint::black_box(());
        let behind = from_last.then(|| (varying, z_plane.at(right, y)));
        if from_last {
            varying.jump(&step, left.wrapping_sub(right));
        }
        shader.span(Row::<S, F, V> {
            x: left,
            y,
            pixels,
            cells,
            z: z_plane.at(left, y),
            z_step: z_plane.dx,
            may_be_level: true,
            varying,
            step,
            behind,
            depth,
            output,
            counter,
        });
        Some(())
    }
}
