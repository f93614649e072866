use super::varying::mix_word;
use super::{Interpolated, Stepped, Varying};
use crate::raster::{Gradients, Span};

/// `N` numbers of 16 bits over the triangle, 16.16 while they are interpolated: a normal, a weight,
/// a distance. Linear on the screen; wrap them in a [`Perspective`](super::Perspective) for more.
///
/// # Rounding
/// Within 1/8 of a step, and rounded to nearest by [`get`](Self::get).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scalars<const N: usize>([u32; N]);

/// The planes of [`Scalars`]: values at pixel (0, 0), and slopes by column and by row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScalarsPlanes<const N: usize> {
    origin: [u32; N],
    right: [u32; N],
    down: [u32; N],
}

/// A half, that makes a cut a rounding.
const HALF: u32 = 0x8000;

impl<const N: usize> Scalars<N> {
    /// The numbers at this pixel, rounded to nearest.
    #[inline(always)]
    pub fn get(&self) -> [u16; N] {
        self.0.map(|word| (word >> 16) as u16)
    }
}

impl<const N: usize> Stepped for Scalars<N> {
    type Step = [u32; N];

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, step: &[u32; N]) {
        for (word, step) in self.0.iter_mut().zip(step) {
            *word = word.wrapping_add(*step);
        }
    }

    #[inline(always)]
    fn jump(&mut self, step: &[u32; N], pixels: i32) {
        for (word, step) in self.0.iter_mut().zip(step) {
            *word = word.wrapping_add(step.wrapping_mul(pixels.cast_unsigned()));
        }
    }
}

impl<const N: usize> Varying for Scalars<N>
where
    [u16; N]: Default,
{
    type Corner = [u16; N];
    type Planes = ScalarsPlanes<N>;
    type Runs = ();

    const INTERPOLATED: bool = true;
    const PIECE: i32 = 0;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        [a, b, c]: &[[u16; N]; 3],
        _: &[u16; N],
        _in_pieces: bool,
    ) -> ScalarsPlanes<N> {
        let mut planes = ScalarsPlanes { origin: [0; N], right: [0; N], down: [0; N] };
        let places = planes.origin.iter_mut().zip(&mut planes.right).zip(&mut planes.down);
        for (((a, b), c), ((origin, right), down)) in a.iter().zip(b).zip(c).zip(places) {
            let plane = gradients.plane(*a, *b, *c);
            (*origin, *right, *down) = (plane.origin.wrapping_add(HALF), plane.dx, plane.dy);
        }
        planes
    }

    #[inline(always)]
    fn runs(_: &ScalarsPlanes<N>, _: &Span) {}

    #[inline(always)]
    fn run(planes: &ScalarsPlanes<N>, (): &mut (), span: &Span, x: i32) -> (Self, [u32; N], i32) {
        let mut words = planes.origin;
        for ((word, right), down) in words.iter_mut().zip(planes.right).zip(planes.down) {
            *word = word
                .wrapping_add(right.wrapping_mul(x.cast_unsigned()))
                .wrapping_add(down.wrapping_mul(span.y.cast_unsigned()));
        }
        (Self(words), planes.right, i32::MAX)
    }

    #[inline(always)]
    fn settle(_: &mut ScalarsPlanes<N>, _x: i32, _y: i32) {}

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 16 bits just before")]
    fn mix([a, b, c]: [&[u16; N]; 3], u: i32, v: i32) -> [u16; N] {
        let mut mixed = *a;
        for (word, (b, c)) in mixed.iter_mut().zip(b.iter().zip(c)) {
            let between = mix_word((*word).into(), (*b).into(), (*c).into(), u, v);
            *word = between.clamp(0, u16::MAX.into()) as u16;
        }
        mixed
    }
}

impl<const N: usize> Interpolated for Scalars<N>
where
    [u16; N]: Default,
{
    type Words = [u32; N];
    type Base = ();

    #[inline(always)]
    fn words(corners: &[[u16; N]; 3]) -> ([[u32; N]; 3], ()) {
        (corners.map(|corner| corner.map(u32::from)), ())
    }

    #[inline(always)]
    fn value((): &(), words: [u32; N]) -> Self {
        // No word is more than 65535 and a half.
        Self(words.map(|word| (word << 1).wrapping_add(HALF)))
    }

    #[inline(always)]
    fn step_of((): &(), right: [u32; N], _down: [u32; N]) -> [u32; N] {
        right.map(|word| word << 1)
    }
}
