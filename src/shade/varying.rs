use crate::color::Format;
use crate::raster::{Gradients, Plane, PointSquare, Span, Triangle};

/// What a shader's `vertex` gives for one corner of a triangle.
pub type Corner<V> = <V as Varying>::Corner;

/// A value that goes from pixel to pixel in equal steps.
pub trait Stepped: Copy {
    /// What is added from one pixel to the next.
    type Step: Copy;

    /// Whether it can [jump](Self::jump).
    const JUMPS: bool = false;

    /// Goes one pixel to the right.
    fn step(&mut self, step: &Self::Step);

    /// Goes so many pixels to the right, or back where they are negative: the same bits as so many
    /// [steps](Self::step). Where [`JUMPS`](Self::JUMPS) says so; then rows may be drawn from their
    /// last pixel.
    ///
    /// Who says that without a `jump` of its own does not compile, once it is drawn:
    ///
    /// ```compile_fail,E0080
    /// use microraster::Stepped;
    ///
    /// #[derive(Clone, Copy)]
    /// struct Own(u32);
    ///
    /// impl Stepped for Own {
    ///     type Step = u32;
    ///     const JUMPS: bool = true;
    ///     fn step(&mut self, step: &u32) {
    ///         self.0 += step;
    ///     }
    /// }
    /// Own(0).jump(&1, -1);
    /// ```
    #[inline(always)]
    fn jump(&mut self, _step: &Self::Step, _pixels: i32) {
        const { assert!(!Self::JUMPS, "what jumps has a jump of its own") };
    }
}

/// A triangle's planes, ready for its spans.
#[doc(hidden)]
#[allow(missing_debug_implementations, reason = "planes need have none")]
pub struct Ready<V: Varying> {
    /// Of what is interpolated, and of depth.
    pub(crate) set: (V::Planes, Plane),
}

/// A value that varies over a triangle: made at its corners, interpolated to its pixels.
///
/// Building blocks are `()` (nothing), [`FlatColor`](super::FlatColor),
/// [`SmoothColor`](super::SmoothColor), [`Scalar`](super::Scalar), and up to
/// eight of them side by side, as a tuple.
pub trait Varying: Stepped {
    /// The value at a corner.
    type Corner: Copy + Default;
    /// What is prepared once a triangle.
    type Planes: Copy;
    /// What is known of a row between its runs.
    type Runs: Copy;

    /// Whether planes are needed. Otherwise the provoking corner alone decides, and the other two
    /// are never made.
    const INTERPOLATED: bool;
    /// Longest run of pixels for which planes are good, across and down together, or 0 for any. Where
    /// a triangle's corners are half as far from the first one along either axis, its rows are drawn
    /// in pieces so long, counted from the row's first covered pixel, and planes are
    /// [settled](Self::settle) on each.
    const PIECE: i32;

    /// Whether a row may need more than one [`run`](Self::run).
    const IN_RUNS: bool;

    /// The planes of a triangle; `corners` in its own order, the provoking one apart. `in_pieces`
    /// says whether they will be [settled](Self::settle).
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        provoking: &Self::Corner,
        in_pieces: bool,
    ) -> Self::Planes;

    /// Whether [`at_once`](Self::at_once) makes planes; no provoking corner is asked for then, here or there.
    #[doc(hidden)]
    const AT_ONCE: bool = false;

    /// The same with the plane of depth: in fewer instructions, where a triangle's set-up is for both
    /// alone.
    #[doc(hidden)]
    #[inline(always)]
    fn at_once(triangle: &Triangle, corners: &[Self::Corner; 3], made: &mut Option<Ready<Self>>) {
        let gradients = Gradients::new(triangle);
        let in_pieces = Self::PIECE != 0 && gradients.reach_beyond(Self::PIECE / 2);
        let (first, to_second, to_third) = triangle.depth_codes();
        let depth = gradients.plane_from(first, to_second, to_third);
        let planes = Self::planes(&gradients, corners, &corners[0], in_pieces);
        *made = Some(Ready { set: (planes, depth) });
    }

    /// Whether planes will be [settled](Self::settle), as they were told.
    #[doc(hidden)]
    #[inline(always)]
    fn are_in_pieces(_planes: &Self::Planes) -> bool {
        false
    }

    /// Begins a row: the first [`run`](Self::run) will be at `span.left`.
    fn runs(planes: &Self::Planes, span: &Span) -> Self::Runs;

    /// The value at pixel `x` of a span, the step to its right neighbour, and the first pixel for
    /// which that step is no longer good: beyond the span unless varyings come
    /// [in runs](Self::IN_RUNS). From run to run `x` grows.
    ///
    /// Of a varying that [jumps](Stepped::JUMPS) and does not come in runs, the value behind the span
    /// may be asked for instead, at `span.right`: no pixel there need be covered.
    fn run(
        planes: &Self::Planes,
        runs: &mut Self::Runs,
        span: &Span,
        x: i32,
    ) -> (Self, Self::Step, i32);

    /// The value at a pixel of a point whose corner has this value, and the step to the pixel's
    /// right neighbour: the same everywhere, unless it is about the point's square.
    #[inline(always)]
    fn on_point(
        corner: &Self::Corner,
        _square: &PointSquare,
        _x: i32,
        _y: i32,
    ) -> (Self, Self::Step) {
        let planes = Self::planes(&Gradients::NONE, &[*corner; 3], corner, false);
        let span = Span::default();
        let mut runs = Self::runs(&planes, &span);
        let (value, step, _) = Self::run(&planes, &mut runs, &span, 0);
        (value, step)
    }

    /// Makes planes good for the [`PIECE`](Self::PIECE) pixels of row `y` from `x` on.
    fn settle(planes: &mut Self::Planes, x: i32, y: i32);

    /// Tells a corner the w of its position in clip space, above zero: what is interpolated in
    /// perspective keeps it.
    #[inline(always)]
    fn place(_corner: &mut Self::Corner, _w: impl Fn() -> i32) {}

    /// A corner whose colour is [dimmed](Format::dim), of varyings that carry one.
    #[inline(always)]
    fn dim<F: Format>(corner: &Self::Corner) -> Self::Corner {
        *corner
    }

    /// The corner `a + (b - a) u + (c - a) v`, both weights in units of 2^-30: where clipping makes
    /// a new one. (0, 0), (2^30, 0) and (0, 2^30) give the three corners exactly.
    fn mix(corners: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner;
}

/// One attribute mixed as [`Varying::mix`] says, rounded to nearest.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "a value between others")]
pub(crate) fn mix_word(a: i32, b: i32, c: i32, u: i32, v: i32) -> i32 {
    let (d1, d2) = (i64::from(b.wrapping_sub(a)), i64::from(c.wrapping_sub(a)));
    let sum = d1.wrapping_mul(u.into()).wrapping_add(d2.wrapping_mul(v.into()));
    a.wrapping_add((sum.wrapping_add(1 << 29) >> 30) as i32)
}

impl Stepped for () {
    type Step = ();

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, (): &()) {}

    #[inline(always)]
    fn jump(&mut self, (): &(), _pixels: i32) {}
}

impl Varying for () {
    type Corner = ();
    type Planes = ();
    type Runs = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(_: &Gradients, _: &[(); 3], (): &(), _in_pieces: bool) {}

    #[inline(always)]
    fn runs((): &(), _: &Span) {}

    #[inline(always)]
    fn run((): &(), (): &mut (), _: &Span, _x: i32) -> ((), (), i32) {
        ((), (), i32::MAX)
    }

    #[inline(always)]
    fn settle((): &mut (), _x: i32, _y: i32) {}

    #[inline(always)]
    fn mix(_: [&(); 3], _u: i32, _v: i32) {}
}

/// The shorter of two pieces, where 0 is endless.
const fn shorter(a: i32, b: i32) -> i32 {
    if a == 0 || (b != 0 && b < a) {
        b
    } else {
        a
    }
}

/// Varyings side by side.
macro_rules! groups {
    ($($group:ident $value:ident $number:tt),+) => {
        impl<$($group: Stepped),+> Stepped for ($($group,)+) {
            type Step = ($($group::Step,)+);

            const JUMPS: bool = true $(&& $group::JUMPS)+;

            #[inline(always)]
            fn step(&mut self, step: &Self::Step) {
                $(self.$number.step(&step.$number);)+
            }

            #[inline(always)]
            fn jump(&mut self, step: &Self::Step, pixels: i32) {
                $(self.$number.jump(&step.$number, pixels);)+
            }
        }

        impl<$($group: Varying),+> Varying for ($($group,)+) {
            type Corner = ($($group::Corner,)+);
            type Planes = ($($group::Planes,)+);
            type Runs = ($($group::Runs,)+);

            const INTERPOLATED: bool = false $(|| $group::INTERPOLATED)+;
            const PIECE: i32 = {
                let piece = 0;
                $(let piece = shorter(piece, $group::PIECE);)+
                piece
            };
            const IN_RUNS: bool = false $(|| $group::IN_RUNS)+;

            #[inline(always)]
            fn planes(
                gradients: &Gradients,
                corners: &[Self::Corner; 3],
                provoking: &Self::Corner,
                in_pieces: bool,
            ) -> Self::Planes {
                ($($group::planes(
                    gradients,
                    &corners.map(|corner| corner.$number),
                    &provoking.$number,
                    in_pieces,
                ),)+)
            }

            #[inline(always)]
            fn runs(planes: &Self::Planes, span: &Span) -> Self::Runs {
                ($($group::runs(&planes.$number, span),)+)
            }

            #[inline(always)]
            fn on_point(
                corner: &Self::Corner,
                square: &PointSquare,
                x: i32,
                y: i32,
            ) -> (Self, Self::Step) {
                $(let $value = $group::on_point(&corner.$number, square, x, y);)+
                (($($value.0,)+), ($($value.1,)+))
            }

            #[inline(always)]
            fn run(
                planes: &Self::Planes,
                runs: &mut Self::Runs,
                span: &Span,
                x: i32,
            ) -> (Self, Self::Step, i32) {
                $(let $value = $group::run(&planes.$number, &mut runs.$number, span, x);)+
                let end = i32::MAX;
                $(let end = end.min($value.2);)+
                (($($value.0,)+), ($($value.1,)+), end)
            }

            #[inline(always)]
            fn settle(planes: &mut Self::Planes, x: i32, y: i32) {
                $($group::settle(&mut planes.$number, x, y);)+
            }

            #[inline(always)]
            fn place(corner: &mut Self::Corner, w: impl Fn() -> i32) {
                $($group::place(&mut corner.$number, &w);)+
            }

            #[inline(always)]
            fn mix([a, b, c]: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner {
                ($($group::mix([&a.$number, &b.$number, &c.$number], u, v),)+)
            }
        }
    };
}

groups!(A a 0, B b 1);
groups!(A a 0, B b 1, C c 2);
groups!(A a 0, B b 1, C c 2, D d 3);
groups!(A a 0, B b 1, C c 2, D d 3, E e 4);
groups!(A a 0, B b 1, C c 2, D d 3, E e 4, F f 5);
groups!(A a 0, B b 1, C c 2, D d 3, E e 4, F f 5, G g 6);
groups!(A a 0, B b 1, C c 2, D d 3, E e 4, F f 5, G g 6, H h 7);

#[cfg(test)]
mod tests {
    use crate::shade::{
        Affine, FlatColor, Interpolated, Perspective, Scalar, Scalars, SmoothColor, Stepped, Uv,
        UvStep,
    };

    /// Goes forth and comes back.
    fn check<V: Stepped + PartialEq + core::fmt::Debug>(first: V, step: V::Step) {
        const { assert!(V::JUMPS, "what is checked") };
        let mut way = [first; 50];
        for i in 1..way.len() {
            way[i] = way[i - 1];
            way[i].step(&step);
        }
        let mut back = first;
        back.jump(&step, 49);
        for expected in way.iter().rev() {
            assert_eq!(back, *expected, "on the way back");
            back.jump(&step, -1);
        }
    }

    #[test]
    fn varyings_come_back_to_the_same_bits() {
        let mut bits = 1u32;
        let mut word = || {
            bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
            bits
        };
        for _ in 0..200 {
            let [a, b, c, d] = core::array::from_fn(|_| word());
            let smooth = SmoothColor::value(&(), [a, b, c]);
            check(smooth, (c, d));
            check(Scalar(a), b);
            check(Scalars::<3>::value(&(), [a, b, c]), [d, a, b]);
            let at = |u: u32, v: u32| Uv { u: u.cast_signed(), v: v.cast_signed() };
            let step = UvStep { right: at(a, b), down: at(c, d) };
            check(at(c, d), step);
            check((smooth, (Scalar(c), ())), ((a, b), (d, ())));
        }
        const { assert!(FlatColor::JUMPS && <Perspective<Uv, Affine>>::JUMPS, "by others") };
        const { assert!(<Perspective<Uv>>::JUMPS, "along a run") };
    }
}
