use super::PerspectiveCorner;
use crate::math::{mul_high_31, mul_high_signed, reciprocal_of_some};
use crate::raster::{Gradients, Plane};
use crate::shade::varying::mix_word;
use crate::shade::{Corner, Interpolated, Varying, Words};

/// The planes of a triangle in perspective: of q, which is 1 / w, and of each word times q.
///
/// Both are linear on the screen, and their quotient is the word (J. Blinn, *Hyperbolic
/// Interpolation*, IEEE CG&A 12, 1992).
///
/// # Range
/// q is 65535 at the nearest corner, 16.16; words times q lie below. Both are divided, so that
/// neither may wrap: a plane is off by less than 1/8, the words' planes are raised by a quarter, and
/// q is at least 1.
///
/// # Rounding
/// Corners are rounded to 1/2: a word is off by no more than its change over 1/100 pixel wherever q
/// differs by more than 100 a pixel, and by 2^-15 of the largest word where q does not differ.
#[derive(Clone, Copy, Debug)]
pub struct PerspectivePlanes<V: Interpolated> {
    pub(super) base: V::Base,
    pub(super) q: Plane,
    origin: V::Words,
    right: V::Words,
    down: V::Words,
}

/// What the planes of words are raised by, so that none wraps below zero: a quarter.
const RAISED: u32 = 0x4000;

/// The nearest corner's w over that of each, as 0.16 and at least 1.
#[inline(never)]
fn over_w(w: [i32; 3]) -> [u32; 3] {
    let w = w.map(|w| w.max(1).cast_unsigned());
    let [a, b, c] = w;
    let least = a.min(b).min(c);
    w.map(|w| {
        let reciprocal = reciprocal_of_some(w);
        let room = 62_u32.wrapping_sub(reciprocal.shift);
        // 0.30; what is added makes the cut a rounding.
        let ratio = mul_high_31(least.wrapping_shl(room), reciprocal.mantissa);
        let ratio = ratio.wrapping_add(1 << 13).min((1 << 30) - 1);
        mul_high_31(ratio << 2, 0xFFFF).max(1)
    })
}

impl<V: Interpolated> PerspectivePlanes<V> {
    #[inline(always)]
    pub(super) fn new(gradients: &Gradients, corners: &[PerspectiveCorner<Corner<V>>; 3]) -> Self {
        let [a, b, c] = over_w(corners.map(|corner| corner.w));
        let ([p, q, r], base) = V::words(&corners.map(|corner| corner.value));
        let times = |words: V::Words, over_w: u32| {
            words.map(|word| word.wrapping_mul(over_w).wrapping_add(0x8000) >> 16)
        };
        let plane = |[a, b, c]: [u32; 3]| {
            let difference = |word: u32| word.wrapping_sub(a).cast_signed();
            gradients.plane_from(a << 16, difference(b), difference(c))
        };
        let words = [times(p, a), times(q, b), times(r, c)];
        let [origin, right, down] = V::Words::planes(words, |corners| {
            let mut plane = plane(corners);
            plane.origin = plane.origin.wrapping_add(RAISED);
            plane
        });
        Self { base, q: plane([a, b, c]), origin, right, down }
    }

    /// The words at a pixel, 16.15: a reciprocal, and a product for each.
    #[inline(always)]
    pub(super) fn at(&self, x: i32, y: i32) -> V::Words {
        let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
        let along = |origin: u32, right: u32| origin.wrapping_add(right.wrapping_mul(x));
        let below = |word: u32, down: u32| word.wrapping_add(down.wrapping_mul(y));
        let words = self.origin.zip(self.right, along).zip(self.down, below);
        quotients(words, self.q.at(x.cast_signed(), y.cast_signed()))
    }

    /// What the words at a pixel, which are known, gain to the pixel below, 16.15.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "limited to 32 bits just before")]
    pub(super) fn down(&self, words: V::Words, x: i32, y: i32) -> V::Words {
        let reciprocal = reciprocal_of_some(self.q.at(x, y));
        words.zip(self.down, |word, down| {
            // d(n / q) = (dn - n / q dq) / q
            let drift = mul_high_signed(self.q.dy.cast_signed(), word).wrapping_shl(1);
            let change = i64::from(down.cast_signed().wrapping_sub(drift));
            let change = change.wrapping_mul(reciprocal.mantissa.into());
            let change = change >> (reciprocal.shift.wrapping_sub(31) & 63);
            change.clamp(i32::MIN.into(), i32::MAX.into()) as u32
        })
    }

    /// The words' planes at a pixel, and what they gain to the right.
    #[inline(always)]
    pub(super) fn linear(&self, x: i32, y: i32) -> (V::Words, V::Words) {
        let (x, y) = (x.cast_unsigned(), y.cast_unsigned());
        let along = |origin: u32, right: u32| origin.wrapping_add(right.wrapping_mul(x));
        let below = |word: u32, down: u32| word.wrapping_add(down.wrapping_mul(y));
        (self.origin.zip(self.right, along).zip(self.down, below), self.right)
    }
}

/// Words times q, over q: 16.15, limited to what corners can have.
#[inline(always)]
pub(super) fn quotients<W: Words>(words: W, q: u32) -> W {
    let reciprocal = reciprocal_of_some(q);
    let room = 62_u32.wrapping_sub(reciprocal.shift);
    // What a word of 65535 is: so that what is added to round it does not wrap.
    let most = q.wrapping_sub(q >> 16);
    words.map(|word| {
        // Below q, so that the shift loses nothing; 0.30 then.
        mul_high_31(word.min(most).wrapping_shl(room), reciprocal.mantissa) << 1
    })
}

/// A corner between three, as clipping makes one.
#[inline(always)]
pub(super) fn mix<V: Varying>(
    corners: [&PerspectiveCorner<Corner<V>>; 3],
    u: i32,
    v: i32,
) -> PerspectiveCorner<Corner<V>> {
    let [a, b, c] = corners.map(|corner| corner.w);
    let w = mix_word(a, b, c, u, v).max(1);
    PerspectiveCorner { w, value: V::mix(corners.map(|corner| &corner.value), u, v) }
}
