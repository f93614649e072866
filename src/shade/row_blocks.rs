//! Rows under a depth test of which something is made for several pixels before they are drawn.

use super::row::{Access, Row};
use super::{ColorOutput, Counter, DepthTest, State, Stepped};
use crate::color::{Color, Format};
use crate::frame::DepthAccess;
use crate::math::rare;

/// Pixels of which something is made at a time: words on the stack.
const BLOCK: usize = 128;

/// The shortest row that is worth it.
const SHORTEST: usize = 8;

impl<S: State, F: Format, V: Stepped> Row<'_, S, F, V> {
    /// The same as [`each`](Self::each) where `mix` makes a word of each of some pixels, from the first one's
    /// varying and its step on, and `show` a pixel of it and of the varying: two loops that have registers enough
    /// each, where one has not. `fragment` does both for a pixel.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
    pub(super) fn each_in_blocks(
        self,
        fragment: impl FnMut(&V) -> Option<Color>,
        mix: impl Fn(&V, &V::Step, &mut [u32]) -> Option<()>,
        show: impl Fn(&V, u32) -> Option<F::Raw>,
    ) {
        if !S::Output::PLAIN || !V::JUMPS || self.pixels.len() < SHORTEST {
            return self.each(fragment);
        }
        let codes = match <Access<S>>::codes(self.cells) {
            Ok(codes) => codes,
            Err(cells) => return Self { cells, ..self }.each(fragment),
        };
        let Self { pixels, mut z, z_step, mut varying, step, depth, counter, .. } = self;
        // What the compiler does not know it stores; what is zero it clears by a routine.
        let mut words = [z; BLOCK];
        for (pixels, codes) in pixels.chunks_mut(BLOCK).zip(codes.chunks_mut(BLOCK)) {
            let length = pixels.len();
            let words = words.get_mut(..length).unwrap_or_default();
            let is_seen = is_any_visible((z, z_step), codes, depth);
            let first = varying;
            varying.jump(&step, length as i32);
            z = z.wrapping_add(z_step.wrapping_mul(length as u32));
            if !is_seen || mix(&first, &step, words).is_none() {
                continue;
            }
            let (behind, steps) = ((varying, z), (&step, z_step));
            from_last::<F, V>(pixels, codes, words, behind, steps, depth, counter, &show);
        }
    }
}

/// The pixel loop of a block from its last pixel to its first; `behind`, which is one pixel further, and
/// `steps` are of the varying and of depth. Apart, so that it has all registers.
#[inline(never)]
#[allow(clippy::too_many_arguments, reason = "what a row is made of")]
fn from_last<F: Format, V: Stepped>(
    pixels: &mut [F::Raw],
    codes: &mut [u16],
    words: &[u32],
    (mut varying, mut z): (V, u32),
    (step, z_step): (&V::Step, u32),
    depth: &impl DepthTest,
    counter: &mut impl Counter,
    show: &impl Fn(&V, u32) -> Option<F::Raw>,
) {
    for ((pixel, stored), word) in pixels.iter_mut().zip(codes).zip(words).rev() {
        z = z.wrapping_sub(z_step);
        varying.jump(step, -1);
        let code = (z >> 16) as u16;
        if depth.passes(code, *stored) {
            if let Some(raw) = show(&varying, *word) {
                if depth.writes() {
                    *stored = code;
                }
                *pixel = raw;
                counter.pixels(1);
                core::hint::black_box(());
            } else {
                rare();
            }
        } else {
            rare();
        }
    }
}

/// Whether any pixel passes the depth test.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the upper half")]
fn is_any_visible((mut z, z_step): (u32, u32), codes: &[u16], depth: &impl DepthTest) -> bool {
    codes.iter().any(|stored| {
        let code = (z >> 16) as u16;
        z = z.wrapping_add(z_step);
        depth.passes(code, *stored)
    })
}

#[cfg(all(test, feature = "std"))]
#[allow(clippy::cast_possible_truncation, reason = "random numbers are cut to what is wanted")]
mod tests {
    extern crate std;
    use super::super::{
        Corner, DrawContext, Greater, Less, Shader, SmoothColor, State, Stats, Uv, VertexInput,
    };
    use super::*;
    use crate::color::{Rgb, Rgb565};
    use crate::frame::{Frame, Size};
    use crate::math::hard_numbers::Random;
    use crate::pipeline::ScreenPass;
    use crate::raster::ScreenVertex;
    use std::vec;
    use std::vec::Vec;

    /// Colours of two varyings, in blocks or not; some fragments are discarded.
    struct Mixed {
        in_blocks: bool,
    }

    /// What is made of the second varying.
    fn word(uv: &Uv) -> u32 {
        (uv.u ^ uv.v.rotate_left(9)).cast_unsigned() >> 16
    }

    fn color(surface: &SmoothColor, word: u32) -> Option<Color> {
        let Color { blue_red, green } = surface.color();
        (!word.is_multiple_of(7)).then_some(Color { blue_red: blue_red ^ word, green })
    }

    impl Shader for Mixed {
        type Vertex = ();
        type Varying = (SmoothColor, Uv);
        type Prepared = ();

        fn prepare(&self, _: &DrawContext) {}

        fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> Corner<Self::Varying> {
            Default::default()
        }

        fn fragment(&self, (): &(), (surface, uv): &Self::Varying) -> Option<Color> {
            color(surface, word(uv))
        }

        #[inline(always)]
        fn span<T: State, F: Format>(&self, (): &(), row: Row<'_, T, F, Self::Varying>) {
            let fragment = |varying: &Self::Varying| self.fragment(&(), varying);
            if !self.in_blocks {
                return row.each(fragment);
            }
            row.each_in_blocks(
                fragment,
                |first, step, words| {
                    let mut varying = *first;
                    for place in words {
                        *place = word(&varying.1);
                        varying.step(step);
                    }
                    Some(())
                },
                |(surface, _), word| color(surface, word).map(F::pack),
            );
        }
    }

    #[test]
    fn rows_in_blocks_are_those_drawn_one_by_one() {
        const SIZE: Size = Size::new(300, 24);
        const PIXELS: usize = 300 * 24;
        let mut random = Random::new(64);
        let mut pixels_written = 0;
        for round in 0..400 {
            let mut coordinate = |most: u32| (random.word() % most).cast_signed() - 200;
            let triangles: Vec<_> = (0..6)
                .map(|_| {
                    [(); 3].map(|()| {
                        let place = (coordinate(5200), coordinate(800));
                        let z = coordinate(65_000).cast_unsigned() as u16;
                        let channels = [coordinate(456), coordinate(456), coordinate(456)];
                        let [r, g, b] = channels.map(|v| v.clamp(0, 255) as u8);
                        let uv = [coordinate(60_000) as i16, coordinate(60_000) as i16];
                        let corner = ScreenVertex::from_bits(place.0, place.1, z);
                        (corner, (Color::from(Rgb::new(r, g, b)), uv))
                    })
                })
                .collect();
            let draw = |in_blocks: bool| {
                let (mut pixels, mut depth) = (vec![0; PIXELS], vec![30_000; PIXELS]);
                let mut stats = Stats::default();
                let mut frame = Frame::<Rgb565>::new(&mut pixels, SIZE)
                    .and_then(|frame| frame.with_depth(&mut depth))
                    .expect("buffers are as large as the picture");
                let shader = Mixed { in_blocks };
                let pass = ScreenPass::new();
                if round % 2 == 0 {
                    pass.depth(Less).count(&mut stats).triangles(&mut frame, &shader, &triangles);
                } else {
                    pass.depth(Greater)
                        .count(&mut stats)
                        .triangles(&mut frame, &shader, &triangles);
                }
                (pixels, depth, stats)
            };
            let (one_by_one, in_blocks) = (draw(false), draw(true));
            pixels_written += one_by_one.2.pixels;
            assert!(one_by_one == in_blocks, "round {round}: {triangles:?}");
        }
        assert!(pixels_written > 100_000, "{pixels_written} pixels were written");
    }
}
