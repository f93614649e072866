use core::fmt::Debug;

use super::{Stepped, Varying};
use crate::raster::Plane;

/// A varying that is made of words which may be interpolated in perspective: what
/// [`Perspective`](super::Perspective) takes.
///
/// # Range
/// At most 16 bits a word. Between the corners a word is 16.15: 15 fraction bits, below 2^31, so
/// that the difference of two fits 32 bits.
///
/// It must [jump](Stepped::jump): where runs of pixels are interpolated, it does not compile otherwise.
pub trait Interpolated: Varying {
    /// One number for each word.
    type Words: Words;
    /// What leads from a triangle's words back to its values.
    type Base: Copy + Debug;

    /// Log2 of the most pixels over which a step is good: at most 9.
    const LONGEST: u32 = 7;

    /// The words of a triangle's corners.
    fn words(corners: &[Self::Corner; 3]) -> ([Self::Words; 3], Self::Base);

    /// The value of words, 16.15.
    fn value(base: &Self::Base, words: Self::Words) -> Self;

    /// The step that adds so much to the words for each pixel to the right, and for one down.
    fn step_of(base: &Self::Base, right: Self::Words, down: Self::Words)
        -> <Self as Stepped>::Step;
}

/// One that does not jump is an error of the compiler's, not a wrong picture.
///
/// ```compile_fail,E0080
/// # use microraster::raster::{Gradients, Plane, Span};
/// # use microraster::*;
/// #[derive(Clone, Copy)]
/// struct Own(Scalar);
///
/// impl Stepped for Own {
///     type Step = u32;
///     fn step(&mut self, step: &u32) {
///         self.0.step(step);
///     }
/// }
/// #
/// # impl Varying for Own {
/// #     type Corner = u16;
/// #     type Planes = Plane;
/// #     type Runs = ();
/// #     const INTERPOLATED: bool = true;
/// #     const PIECE: i32 = 0;
/// #     const IN_RUNS: bool = false;
/// #     fn planes(gradients: &Gradients, corners: &[u16; 3], first: &u16, pieces: bool) -> Plane {
/// #         Scalar::planes(gradients, corners, first, pieces)
/// #     }
/// #     fn runs(_: &Plane, _: &Span) {}
/// #     fn run(plane: &Plane, runs: &mut (), span: &Span, x: i32) -> (Self, u32, i32) {
/// #         let (value, step, end) = Scalar::run(plane, runs, span, x);
/// #         (Self(value), step, end)
/// #     }
/// #     fn settle(_: &mut Plane, _: i32, _: i32) {}
/// #     fn mix(corners: [&u16; 3], u: i32, v: i32) -> u16 {
/// #         Scalar::mix(corners, u, v)
/// #     }
/// # }
/// #
/// # impl Interpolated for Own {
/// #     type Words = [u32; 1];
/// #     type Base = ();
/// #     fn words(corners: &[u16; 3]) -> ([[u32; 1]; 3], ()) {
/// #         Scalar::words(corners)
/// #     }
/// #     fn value(base: &(), words: [u32; 1]) -> Self {
/// #         Self(Scalar::value(base, words))
/// #     }
/// #     fn step_of(base: &(), right: [u32; 1], down: [u32; 1]) -> u32 {
/// #         Scalar::step_of(base, right, down)
/// #     }
/// # }
/// #
/// # struct Shown;
/// #
/// # impl Shader for Shown {
/// #     type Vertex = ();
/// #     type Varying = Perspective<Own>;
/// #     type Prepared = ();
/// #     fn prepare(&self, _: &DrawContext) {}
/// #     fn vertex(&self, _: &(), _: VertexInput<'_, ()>) -> PerspectiveCorner<u16> {
/// #         PerspectiveCorner::from(0)
/// #     }
/// #     fn fragment(&self, _: &(), _: &Self::Varying) -> Option<Color> {
/// #         None
/// #     }
/// # }
/// let mut pixels = [0; 4];
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(2, 2)).unwrap();
/// ScreenPass::new().triangles(&mut frame, &Shown, &[]);
/// ```
#[cfg(doctest)]
struct MustJump;

/// A few words on which the same is done: an array, or a tuple of them.
pub trait Words: Copy + Debug {
    /// A function of each word.
    #[must_use]
    fn map(self, function: impl FnMut(u32) -> u32) -> Self;

    /// A function of each word and the other's.
    #[must_use]
    fn zip(self, other: Self, function: impl FnMut(u32, u32) -> u32) -> Self;

    /// The plane of each word through its values at three corners: origins, and slopes by column
    /// and by row.
    fn planes(corners: [Self; 3], plane: impl FnMut([u32; 3]) -> Plane) -> [Self; 3];
}

impl<const N: usize> Words for [u32; N] {
    #[inline(always)]
    fn map(self, function: impl FnMut(u32) -> u32) -> Self {
        <[u32; N]>::map(self, function)
    }

    #[inline(always)]
    fn zip(self, other: Self, mut function: impl FnMut(u32, u32) -> u32) -> Self {
        let mut words = self;
        for (word, other) in words.iter_mut().zip(other) {
            *word = function(*word, other);
        }
        words
    }

    #[inline(always)]
    fn planes([a, b, c]: [Self; 3], mut plane: impl FnMut([u32; 3]) -> Plane) -> [Self; 3] {
        let (mut origins, mut rights, mut downs) = ([0; N], [0; N], [0; N]);
        let corners = a.into_iter().zip(b).zip(c);
        let places = origins.iter_mut().zip(&mut rights).zip(&mut downs);
        for (((a, b), c), ((origin, right), down)) in corners.zip(places) {
            let plane = plane([a, b, c]);
            (*origin, *right, *down) = (plane.origin, plane.dx, plane.dy);
        }
        [origins, rights, downs]
    }
}

/// The lesser of two numbers, in a constant.
const fn lesser(a: u32, b: u32) -> u32 {
    if a < b {
        a
    } else {
        b
    }
}

/// Groups side by side that share their perspective.
macro_rules! groups {
    ($($group:ident $number:tt),+) => {
        impl<$($group: Words),+> Words for ($($group,)+) {
            #[inline(always)]
            fn map(self, mut function: impl FnMut(u32) -> u32) -> Self {
                ($(self.$number.map(&mut function),)+)
            }

            #[inline(always)]
            fn zip(self, other: Self, mut function: impl FnMut(u32, u32) -> u32) -> Self {
                ($(self.$number.zip(other.$number, &mut function),)+)
            }

            #[inline(always)]
            fn planes(corners: [Self; 3], mut plane: impl FnMut([u32; 3]) -> Plane) -> [Self; 3] {
                let planes =
                    ($($group::planes(corners.map(|corner| corner.$number), &mut plane),)+);
                let [first, second, third] = [0, 1, 2].map(|part: usize| {
                    ($(planes.$number[part % 3],)+)
                });
                [first, second, third]
            }
        }

        impl<$($group: Interpolated),+> Interpolated for ($($group,)+) {
            type Words = ($($group::Words,)+);
            type Base = ($($group::Base,)+);

            const LONGEST: u32 = {
                let longest = 9;
                $(let longest = lesser(longest, $group::LONGEST);)+
                longest
            };

            #[inline(always)]
            fn words(corners: &[Self::Corner; 3]) -> ([Self::Words; 3], Self::Base) {
                let groups = ($($group::words(&corners.map(|corner| corner.$number)),)+);
                let words = [0, 1, 2].map(|part: usize| ($(groups.$number.0[part % 3],)+));
                (words, ($(groups.$number.1,)+))
            }

            #[inline(always)]
            fn value(base: &Self::Base, words: Self::Words) -> Self {
                ($($group::value(&base.$number, words.$number),)+)
            }

            #[inline(always)]
            fn step_of(base: &Self::Base, right: Self::Words, down: Self::Words) -> Self::Step {
                ($($group::step_of(&base.$number, right.$number, down.$number),)+)
            }
        }
    };
}

groups!(A 0, B 1);
groups!(A 0, B 1, C 2);
groups!(A 0, B 1, C 2, D 3);
groups!(A 0, B 1, C 2, D 3, E 4);
groups!(A 0, B 1, C 2, D 3, E 4, F 5);
groups!(A 0, B 1, C 2, D 3, E 4, F 5, G 6);
groups!(A 0, B 1, C 2, D 3, E 4, F 5, G 6, H 7);
