//! Rows under a depth test by several pixels at a time, for cores with vectors.

use super::row::{Access, Row};
use super::{ColorOutput, Counter, DepthTest, State, Stepped};
use crate::color::{Channel, Color, Format, LANES};
use crate::frame::DepthAccess;
use crate::texture::Squares;

/// Groups of [`LANES`] pixels that are gathered before the first of them is blended: what was stored
/// word by word has then reached memory, from where vectors are loaded.
const GROUPS: usize = 4;

impl<S: State, F: Format, V: Stepped> Row<'_, S, F, V> {
    /// The same as [`each`](Self::each), [`LANES`] pixels at a time.
    ///
    /// `gather` looks up what some groups of pixels are made of, from the first one's varying and its
    /// step on, or `None` where they are to be drawn one by one; `blend` makes pixels of a group.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
    pub(super) fn each_in_lanes(
        self,
        mut fragment: impl FnMut(&V) -> Option<Color>,
        gather: impl Fn(&V, &V::Step, &mut [Squares]) -> Option<()>,
        blend: impl Fn(&Squares) -> [F::Raw; LANES],
    ) {
        if !S::Output::PLAIN || !V::JUMPS || self.pixels.len() < LANES {
            return self.each(fragment);
        }
        let codes = match <Access<S>>::codes(self.cells) {
            Ok(codes) => codes,
            Err(cells) => return Self { cells, ..self }.each(fragment),
        };
        let Self { pixels, mut z, z_step, mut varying, step, depth, counter, .. } = self;
        let mut groups = [Squares::default(); GROUPS];
        let blocks = pixels.chunks_mut(GROUPS * LANES).zip(codes.chunks_mut(GROUPS * LANES));
        for (pixels, codes) in blocks {
            let length = pixels.len();
            let groups = groups.get_mut(..length / LANES).unwrap_or_default();
            let mut done = 0;
            if !is_visible((z, z_step), codes, depth) {
                done = length;
            } else if gather(&varying, &step, groups).is_some() {
                let wholes = pixels.as_chunks_mut().0.iter_mut().zip(codes.as_chunks_mut().0);
                let mut z = z;
                for (squares, (pixels, codes)) in groups.iter().zip(wholes) {
                    store::<F>(pixels, codes, (z, z_step), &blend(squares), depth, counter);
                    z = z.wrapping_add(z_step.wrapping_mul(LANES as u32));
                    done = done.wrapping_add(LANES);
                }
            }
            varying.jump(&step, done as i32);
            z = z.wrapping_add(z_step.wrapping_mul(done as u32));
            for (pixel, stored) in pixels.iter_mut().zip(codes).skip(done) {
                let code = (z >> 16) as u16;
                if depth.passes(code, *stored) {
                    if let Some(color) = fragment(&varying) {
                        if depth.writes() {
                            *stored = code;
                        }
                        *pixel = F::pack(color);
                        counter.pixels(1);
                    }
                }
                z = z.wrapping_add(z_step);
                varying.step(&step);
            }
        }
    }
}

/// Whether any pixel passes the depth test.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the upper half")]
fn is_visible((mut z, z_step): (u32, u32), codes: &[u16], depth: &impl DepthTest) -> bool {
    codes.iter().fold(false, |any, stored| {
        let passes = depth.passes((z >> 16) as u16, *stored);
        z = z.wrapping_add(z_step);
        any | passes
    })
}

/// Stores the pixels that pass the depth test. Apart, so that the compiler knows what does not
/// overlap.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "the upper half")]
fn store<F: Format>(
    pixels: &mut [F::Raw; LANES],
    codes: &mut [u16; LANES],
    (z, z_step): (u32, u32),
    raw: &[F::Raw; LANES],
    depth: &impl DepthTest,
    counter: &mut impl Counter,
) {
    let new: Channel = core::array::from_fn(|lane| {
        (z.wrapping_add(z_step.wrapping_mul(lane as u32)) >> 16) as u16
    });
    // Copies, so that all is chosen before any of it is stored.
    let (old, stored) = (*pixels, *codes);
    let passes = |lane: usize| depth.passes(new[lane], stored[lane]);
    *pixels = core::array::from_fn(|lane| if passes(lane) { raw[lane] } else { old[lane] });
    if depth.writes() {
        *codes = core::array::from_fn(|lane| if passes(lane) { new[lane] } else { stored[lane] });
    }
    counter.pixels((0..LANES).map(|lane| u32::from(passes(lane))).sum());
}
