use super::varying::mix_word;
use super::{Interpolated, Stepped, Varying};
use crate::raster::{Gradients, Plane, Span};

/// Texture coordinates over the triangle, linear on the screen; wrap them in
/// [`Adaptive`](super::Adaptive) or its kin for perspective.
///
/// A corner is `[u, v]`, two 16-bit numbers; how many make one repeat of the texture is the
/// sampler's. u points right and v down, from the texture's first texel.
///
/// # Range
/// All of 16 bits; the difference of two corners may be as much as 65535.
///
/// # Rounding
/// As [`Gradients`]: within 1/8 of a unit, with 16 fraction bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Uv {
    /// To the right, 16.16 and modulo 2^32.
    pub u: i32,
    /// Down, 16.16 and modulo 2^32.
    pub v: i32,
}

/// How far texture coordinates go from one pixel to the next, 16.16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UvStep {
    /// To the right neighbour.
    pub right: Uv,
    /// To the neighbour below; in perspective, at the first pixel of the run.
    pub down: Uv,
}

impl UvStep {
    /// The longer way of the two, of the larger coordinate: what a pixel covers of the texture.
    #[inline(always)]
    pub fn footprint(&self) -> u32 {
        let Self { right, down } = self;
        let longer = |a: i32, b: i32| a.unsigned_abs().max(b.unsigned_abs());
        longer(right.u, right.v).max(longer(down.u, down.v))
    }
}

/// The planes of a [`Uv`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UvPlanes {
    u: Plane,
    v: Plane,
}

impl Stepped for Uv {
    type Step = UvStep;

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, step: &UvStep) {
        self.u = self.u.wrapping_add(step.right.u);
        self.v = self.v.wrapping_add(step.right.v);
    }

    #[inline(always)]
    fn jump(&mut self, step: &UvStep, pixels: i32) {
        self.u = self.u.wrapping_add(step.right.u.wrapping_mul(pixels));
        self.v = self.v.wrapping_add(step.right.v.wrapping_mul(pixels));
    }
}

impl Varying for Uv {
    type Corner = [i16; 2];
    type Planes = UvPlanes;
    type Runs = ();

    const INTERPOLATED: bool = true;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[[i16; 2]; 3],
        _: &[i16; 2],
        _in_pieces: bool,
    ) -> UvPlanes {
        let plane = |[a, b, c]: [i16; 3]| {
            let [a, b, c] = [a, b, c].map(i32::from);
            let first = a.wrapping_shl(16).cast_unsigned();
            gradients.plane_from(first, b.wrapping_sub(a), c.wrapping_sub(a))
        };
        UvPlanes { u: plane(corners.map(|[u, _]| u)), v: plane(corners.map(|[_, v]| v)) }
    }

    #[inline(always)]
    fn runs(_: &UvPlanes, _: &Span) {}

    #[inline(always)]
    fn run(planes: &UvPlanes, (): &mut (), span: &Span, x: i32) -> (Self, UvStep, i32) {
        let UvPlanes { u, v } = planes;
        let of = |u: u32, v: u32| Self { u: u.cast_signed(), v: v.cast_signed() };
        let step = UvStep { right: of(u.dx, v.dx), down: of(u.dy, v.dy) };
        (of(u.at(x, span.y), v.at(x, span.y)), step, i32::MAX)
    }

    #[inline(always)]
    fn settle(_: &mut UvPlanes, _x: i32, _y: i32) {}

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn mix(corners: [&[i16; 2]; 3], u: i32, v: i32) -> [i16; 2] {
        let word = |[a, b, c]: [i16; 3]| {
            let word = mix_word(a.into(), b.into(), c.into(), u, v);
            word.clamp(i16::MIN.into(), i16::MAX.into()) as i16
        };
        [word(corners.map(|[u, _]| *u)), word(corners.map(|[_, v]| *v))]
    }
}

/// Where a triangle's texture coordinates begin, and how they lie in its words.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UvBase {
    least: Uv,
    u: Shift,
    v: Shift,
}

/// How a word becomes a difference of coordinates again: to the left, then to the right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Shift {
    left: u32,
    right: u32,
}

impl Shift {
    /// A value, 16.15, as a difference of coordinates, 16.16.
    #[inline(always)]
    fn value(self, word: u32) -> i32 {
        word.wrapping_shl(self.left).wrapping_shr(self.right).cast_signed()
    }

    /// The same of a step.
    #[inline(always)]
    fn step(self, word: u32) -> i32 {
        word.cast_signed().wrapping_shl(self.left).wrapping_shr(self.right)
    }
}

/// The least of three coordinates, and by how much a difference to it may be shifted so that words
/// use all of 16 bits.
#[inline(always)]
fn base([a, b, c]: [i16; 3]) -> (i32, u32) {
    let (least, most) = (a.min(b).min(c), a.max(b).max(c));
    let reach = i32::from(most).wrapping_sub(least.into()).cast_unsigned();
    (least.into(), (reach | 1).leading_zeros().wrapping_sub(16))
}

impl Interpolated for Uv {
    type Words = [u32; 2];
    type Base = UvBase;

    const LONGEST: u32 = 9;

    #[inline(always)]
    fn words(corners: &[[i16; 2]; 3]) -> ([[u32; 2]; 3], UvBase) {
        let (u, up_u) = base(corners.map(|[u, _]| u));
        let (v, up_v) = base(corners.map(|[_, v]| v));
        let word = |value: i16, least: i32, up: u32| {
            i32::from(value).wrapping_sub(least).cast_unsigned().wrapping_shl(up)
        };
        let words = corners.map(|corner| [word(corner[0], u, up_u), word(corner[1], v, up_v)]);
        let least = Self { u: u.wrapping_shl(16), v: v.wrapping_shl(16) };
        // One to the left from 16.15 to 16.16, and back what words are larger.
        let shift = |up: u32| Shift { left: u32::from(up == 0), right: up.saturating_sub(1) };
        (words, UvBase { least, u: shift(up_u), v: shift(up_v) })
    }

    #[inline(always)]
    fn value(base: &UvBase, [u, v]: [u32; 2]) -> Self {
        Self {
            u: base.least.u.wrapping_add(base.u.value(u)),
            v: base.least.v.wrapping_add(base.v.value(v)),
        }
    }

    #[inline(always)]
    fn step_of(base: &UvBase, right: [u32; 2], down: [u32; 2]) -> UvStep {
        let of = |[u, v]: [u32; 2]| Self { u: base.u.step(u), v: base.v.step(v) };
        UvStep { right: of(right), down: of(down) }
    }
}
