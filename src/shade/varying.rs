use crate::raster::Gradients;

/// What a shader's `vertex` gives for one corner of a triangle.
pub type Corner<V> = <V as Varying>::Corner;

/// A value that varies over a triangle: made at its corners, interpolated to its pixels.
///
/// Building blocks are `()` (nothing), [`FlatColor`](super::FlatColor),
/// [`SmoothColor`](super::SmoothColor), [`Scalar`](super::Scalar), and pairs of them.
pub trait Varying: Copy {
    /// The value at a corner.
    type Corner: Copy + Default;
    /// What is prepared once a triangle.
    type Planes: Copy;
    /// What is added from one pixel to the next.
    type Step: Copy;

    /// Whether planes are needed. Otherwise the provoking corner alone decides, and the other two
    /// are never made.
    const INTERPOLATED: bool;
    /// Longest run of pixels for which planes are good, across and down together, or 0 for any. Where
    /// a triangle's corners are half as far from the first one along either axis, its rows are drawn
    /// in pieces so long, counted from the row's first covered pixel, and planes are
    /// [settled](Self::settle) on each.
    const PIECE: i32;

    /// The planes of a triangle; `corners` in its own order, the provoking one apart. `in_pieces`
    /// says whether they will be [settled](Self::settle).
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        provoking: &Self::Corner,
        in_pieces: bool,
    ) -> Self::Planes;

    /// The value at pixel (x, y), and the step to its right neighbour.
    fn start(planes: &Self::Planes, x: i32, y: i32) -> (Self, Self::Step);

    /// Goes one pixel to the right.
    fn step(&mut self, step: &Self::Step);

    /// Makes planes good for the [`PIECE`](Self::PIECE) pixels of row `y` from `x` on.
    fn settle(planes: &mut Self::Planes, x: i32, y: i32);

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

impl Varying for () {
    type Corner = ();
    type Planes = ();
    type Step = ();

    const INTERPOLATED: bool = false;
    const PIECE: i32 = 0;

    #[inline(always)]
    fn planes(_: &Gradients, _: &[(); 3], (): &(), _in_pieces: bool) {}

    #[inline(always)]
    fn start((): &(), _x: i32, _y: i32) -> ((), ()) {
        ((), ())
    }

    #[inline(always)]
    fn step(&mut self, (): &()) {}

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

impl<A: Varying, B: Varying> Varying for (A, B) {
    type Corner = (A::Corner, B::Corner);
    type Planes = (A::Planes, B::Planes);
    type Step = (A::Step, B::Step);

    const INTERPOLATED: bool = A::INTERPOLATED || B::INTERPOLATED;
    const PIECE: i32 = shorter(A::PIECE, B::PIECE);

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[Self::Corner; 3],
        provoking: &Self::Corner,
        in_pieces: bool,
    ) -> Self::Planes {
        (
            A::planes(gradients, &corners.map(|corner| corner.0), &provoking.0, in_pieces),
            B::planes(gradients, &corners.map(|corner| corner.1), &provoking.1, in_pieces),
        )
    }

    #[inline(always)]
    fn start(planes: &Self::Planes, x: i32, y: i32) -> (Self, Self::Step) {
        let (a, a_step) = A::start(&planes.0, x, y);
        let (b, b_step) = B::start(&planes.1, x, y);
        ((a, b), (a_step, b_step))
    }

    #[inline(always)]
    fn step(&mut self, step: &Self::Step) {
        self.0.step(&step.0);
        self.1.step(&step.1);
    }

    #[inline(always)]
    fn settle(planes: &mut Self::Planes, x: i32, y: i32) {
        A::settle(&mut planes.0, x, y);
        B::settle(&mut planes.1, x, y);
    }

    #[inline(always)]
    fn mix([a, b, c]: [&Self::Corner; 3], u: i32, v: i32) -> Self::Corner {
        (A::mix([&a.0, &b.0, &c.0], u, v), B::mix([&a.1, &b.1, &c.1], u, v))
    }
}
