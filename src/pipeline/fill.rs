use crate::color::Format;
use crate::frame::{DepthAccess, Supplies, Target, Window};
use crate::math::BY_HALVES;
use crate::raster::{
    Gradients, Plane, ScreenVertex, Span, SpanBatch, SpanWalk, Traversal, Triangle,
};
use crate::shade::{ColorOutput, Corner, DepthTest, Fragments, Row, State, Varying};

/// How a state touches depth.
pub(crate) type Access<S> = <<S as State>::Depth as DepthTest>::Access;

/// A triangle being walked under a state.
pub(super) type Walk<S> = <<S as State>::Traversal as Traversal>::Walk;

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
    let [a, b, c] = &triangle.v;
    let from = i32::from(a.z);
    let rise = |z: u16| i32::from(z).wrapping_sub(from);
    gradients.plane_from(u32::from(a.z) << 16 | 0x8000, rise(b.z), rise(c.z))
}

/// The same where nothing else is interpolated: a triangle of one depth needs no gradients.
#[inline(never)]
pub(super) fn lone_depth_plane(triangle: &Triangle) -> Plane {
    let [a, b, c] = &triangle.v;
    if a.z == b.z && a.z == c.z {
        return Plane { origin: u32::from(a.z) << 16 | 0x8000, dx: 0, dy: 0 };
    }
    depth_plane(&Gradients::new(triangle), triangle)
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

impl<V: Varying> Fill<'_, V> {
    /// The plane of the depth codes under a test.
    #[inline(always)]
    fn depth_plane<const MOVES: bool>(
        &self,
        gradients: &Gradients,
        depth: &impl DepthTest,
    ) -> Plane {
        let plane = |triangle: &Triangle| {
            if depth.is_constant() {
                mean_depth_plane(triangle)
            } else if V::INTERPOLATED {
                depth_plane(gradients, triangle)
            } else {
                lone_depth_plane(triangle)
            }
        };
        let mapped: Triangle;
        let mut triangle = self.triangle;
        if depth.maps() {
            let v = triangle.v.map(|v| ScreenVertex { z: depth.map(v.z), ..v });
            mapped = Triangle { v, ..*triangle };
            triangle = &mapped;
        }
        let mut plane = plane(triangle);
        if MOVES {
            let offset = depth.offset(plane.dx.cast_signed(), plane.dy.cast_signed());
            if offset != 0 {
                move_away(&mut plane, triangle, offset);
            }
        }
        plane
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
        // What neither depth nor varyings ask for is not computed.
        let gradients =
            if V::INTERPOLATED { Gradients::new(self.triangle) } else { Gradients::NONE };
        let z_plane = if <Access<S>>::HAS_DEPTH {
            self.depth_plane::<MOVES>(&gradients, state.parts().0)
        } else {
            Plane::default()
        };
        let in_pieces = V::PIECE != 0 && gradients.reach_beyond(V::PIECE / 2);
        let planes = if H::COLOR_AS_IS && state.parts().1.dims() {
            let dimmed = self.corners.each_ref().map(V::dim::<F>);
            V::planes(&gradients, &dimmed, self.provoking, in_pieces)
        } else {
            V::planes(&gradients, self.corners, self.provoking, in_pieces)
        };
        let mut ready = Ready::<V> { planes, z_plane };
        match &mut *target {
            Target::Whole(window) if !in_pieces => loop {
                let drawn = ready.draw::<H, S, F>(batch.spans(), window, state, shader);
                if drawn.is_none() || batch.is_last() {
                    return;
                }
                walk.next_spans(batch);
            },
            // Where this cannot be, it is not there.
            target if V::PIECE != 0 || <Access<S>>::TOUCHES => {
                ready.draw_pieces::<H, S, F, D, W>(in_pieces, target, state, shader, walk, batch);
            }
            _ => {}
        }
    }
}

/// Spans in pieces of `length` pixels from each row's first covered one, as far as they are drawn.
struct Pieces<'a> {
    spans: core::slice::Iter<'a, Span>,
    /// The latest piece.
    piece: Span,
    /// Where the next one begins, and where its row ends.
    from: i32,
    right: i32,
    length: i32,
}

impl<'a> Pieces<'a> {
    fn new(spans: &'a [Span], length: i32) -> Self {
        Self { spans: spans.iter(), piece: Span::default(), from: 0, right: 0, length }
    }

    /// Goes on to the next piece; where it would begin if all of it were drawn.
    #[inline(never)]
    fn next(&mut self) -> Option<i32> {
        let mut start = self.from;
        self.piece.left = start;
        let mut end = start.wrapping_add(self.length);
        if start >= self.right {
            self.piece = *self.spans.next()?;
            self.right = self.piece.right;
            end = self.piece.first;
            while {
                start = end;
                end = start.wrapping_add(self.length);
                end <= self.piece.left
            } {}
        }
        self.from = end;
        self.piece.right = end.min(self.right);
        Some(start)
    }
}

/// Longer than any row, and nothing overflows.
const ENDLESS: i32 = 1 << 20;

/// A triangle's planes, ready for its spans.
struct Ready<V: Varying> {
    planes: V::Planes,
    z_plane: Plane,
}

impl<V: Varying> Ready<V> {
    /// Draws all spans one by one, in pieces where planes are to be settled on each.
    ///
    /// Apart, so that other triangles do not pay for it.
    #[inline(never)]
    fn draw_pieces<H, S, F, D, W>(
        &mut self,
        in_pieces: bool,
        target: &mut Target<'_, '_, F, D, Access<S>>,
        state: &mut S,
        shader: &H,
        walk: &mut W,
        batch: &mut SpanBatch,
    ) where
        H: Fragments<Varying = V>,
        S: State,
        F: Format,
        D: Supplies<Access<S>>,
        W: SpanWalk,
    {
        loop {
            let length = if in_pieces { V::PIECE } else { ENDLESS };
            let mut pieces = Pieces::new(batch.spans(), length);
            while let Some(start) = pieces.next() {
                let piece = &pieces.piece;
                // Asked anew for each piece, as the target is: the compiler makes a loop for every
                // answer that it can ask for once.
                if V::PIECE != 0 && pieces.length != ENDLESS {
                    V::settle(&mut self.planes, start, piece.y);
                }
                let spans = core::slice::from_ref(piece);
                let drawn = match core::hint::black_box(&mut *target) {
                    Target::Whole(window) => self.draw::<H, S, F>(spans, window, state, shader),
                    Target::Rows(frame) => frame.window(piece).and_then(|mut window| {
                        self.draw::<H, S, F>(spans, &mut window, state, shader)
                    }),
                };
                // The frame does not reach so far.
                if drawn.is_none() {
                    return;
                }
            }
            if batch.is_last() {
                return;
            }
            walk.next_spans(batch);
        }
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
        let Self { planes, z_plane } = if planes_stay { core::hint::black_box(self) } else { self };
        for span in spans.by_ref() {
            let Span { y, left, right, .. } = *span;
            let (pixels, cells) = window.row(y, left, right)?;
            let mut runs = V::runs(planes, span);
            if V::IN_RUNS {
                let mut cells = cells;
                let mut x = left;
                while x < right {
                    let (varying, step, end) = V::run(planes, &mut runs, span, x);
                    let end = end.min(right);
                    let (from, length) = (x.wrapping_sub(left), end.wrapping_sub(x));
                    let (from, length) = (from as usize, length as usize);
                    let pixels = pixels.get_mut(from..)?.get_mut(..length)?;
                    let cells = <Access<S>>::part(&mut cells, from, length)?;
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
                        depth,
                        output,
                        counter: &mut *counter,
                    });
                    x = end;
                }
                continue;
            }
            let (varying, step, _) = V::run(planes, &mut runs, span, left);
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
                depth,
                output,
                counter,
            });
        }
        Some(())
    }
}
