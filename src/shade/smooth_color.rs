use core::sync::atomic::{compiler_fence, Ordering};

use super::flat_color::mix_color;
use super::{Interpolated, Ready, Stepped, Varying};
use crate::color::{Color, Format};
use crate::math::{BY_HALVES, HALVES_MULTIPLY};
use crate::raster::{
    Gradients, Plane, PointSquare, Slopes, SmallGradients, Span, Triangle, SMALL_SIDE,
};

/// A colour interpolated over the triangle, linear on the screen (Gouraud).
///
/// # Rounding
/// Green is a plane of 8.24, exact to 2^-12 of an 8-bit step. Blue and red share the words of one
/// plane as 8.8: each slope is off by at most half of 1/256, so that over 128 pixels, down and
/// across, they stray by at most a quarter of an 8-bit step and, starting half a step inside of
/// their range, never leave it. Larger triangles have planes of 8.24 too, on which the shared one
/// is settled for each piece of a row.
///
/// # Measured
/// <!-- tradeoff: plane-10/colour=linear -->
/// `linear` in the scene `plane-10`: 19.4 (M4F), 29.6 (M0+), 19.8 (RV32) instructions a pixel; PSNR 14.6 dB.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SmoothColor(Color);

/// The planes of a [`SmoothColor`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SmoothColorPlanes {
    /// Blue and red in 8.8, packed like [`Color::blue_red`].
    blue_red: Plane,
    green: Plane,
    /// Blue and red in 8.24, of large triangles.
    fine: Option<[Plane; 2]>,
}

impl SmoothColor {
    /// Pixels over which blue and red are good in one word.
    const PIXELS: i32 = 128;
    /// Sides from here on, in subpixels, are drawn in pieces: none of a small triangle's.
    const REACH: u32 = (Self::PIXELS / 2).cast_unsigned() * 16;

    /// Of its words, whatever they are.
    #[cfg(test)]
    pub(super) const fn of_bits(blue_red: u32, green: u32) -> Self {
        Self(Color { blue_red, green })
    }

    /// The colour at this pixel, opaque.
    #[inline(always)]
    pub const fn color(self) -> Color {
        Color { green: self.0.green | Color::OPAQUE, ..self.0 }
    }
}

// Half a unit of slope over the steps of a piece, one unit where the start is cut off, one that a
// neighbour may lend, and one for the planes' own error must stay below the half step (128 units)
// that the corners are raised by.
const _: () = assert!((SmoothColor::PIXELS - 1) / 2 + 3 < 128, "packed channels stay in range");

const _: () = assert!(SMALL_SIDE <= SmoothColor::REACH, "small triangles are in one piece");

/// Blue and red of 8.24, modulo 2^32, as 8.8 in one word.
#[inline(always)]
const fn packed(blue: u32, red: u32) -> u32 {
    // Arithmetic: the borrow of a negative red goes into blue and comes back when it is added.
    (blue & 0xFFFF_0000).wrapping_add((red.cast_signed() >> 16).cast_unsigned())
}

/// The same of slopes, rounded to nearest.
#[inline(always)]
const fn packed_slope(blue: i32, red: i32) -> u32 {
    packed(blue.wrapping_add(0x8000).cast_unsigned(), red.wrapping_add(0x8000).cast_unsigned())
}

impl Stepped for SmoothColor {
    type Step = (u32, u32);

    const JUMPS: bool = true;

    #[inline(always)]
    fn step(&mut self, (blue_red, green): &(u32, u32)) {
        self.0.blue_red = self.0.blue_red.wrapping_add(*blue_red);
        self.0.green = self.0.green.wrapping_add(*green);
    }

    #[inline(always)]
    fn jump(&mut self, (blue_red, green): &(u32, u32), pixels: i32) {
        let pixels = pixels.cast_unsigned();
        self.0.blue_red = self.0.blue_red.wrapping_add(blue_red.wrapping_mul(pixels));
        self.0.green = self.0.green.wrapping_add(green.wrapping_mul(pixels));
    }
}

impl Varying for SmoothColor {
    type Corner = Color;
    type Planes = SmoothColorPlanes;
    type Runs = ();

    const INTERPOLATED: bool = true;
    const PIECE: i32 = Self::PIXELS;
    const IN_RUNS: bool = false;

    #[inline(always)]
    fn planes(
        gradients: &Gradients,
        corners: &[Color; 3],
        _: &Color,
        in_pieces: bool,
    ) -> SmoothColorPlanes {
        smooth_planes(gradients, corners, in_pieces)
    }

    const AT_ONCE: bool = true;

    #[inline(always)]
    fn at_once(triangle: &Triangle, corners: &[Color; 3], made: &mut Option<Ready<Self>>) {
        smooth_planes_at_once(triangle, corners, made);
    }

    #[inline(always)]
    fn are_in_pieces(planes: &SmoothColorPlanes) -> bool {
        planes.fine.is_some()
    }

    #[inline(always)]
    fn runs(_: &SmoothColorPlanes, _: &Span) {}

    #[inline(always)]
    fn run(
        planes: &SmoothColorPlanes,
        (): &mut (),
        span: &Span,
        x: i32,
    ) -> (Self, (u32, u32), i32) {
        let y = span.y;
        let blue_red = planes.blue_red.at(x, y);
        // As below.
        core::hint::black_box(());
        let color = Color { blue_red, green: planes.green.at(x, y) };
        (Self(color), (planes.blue_red.dx, planes.green.dx), i32::MAX)
    }

    #[inline(always)]
    fn on_point(corner: &Color, _: &PointSquare, _x: i32, _y: i32) -> (Self, (u32, u32)) {
        (Self(*corner), (0, 0))
    }

    #[inline]
    fn settle(planes: &mut SmoothColorPlanes, x: i32, y: i32) {
        if let Some([blue, red]) = &planes.fine {
            // In range at a covered pixel, so that nothing is lent.
            let blue = blue.at(x, y) & 0xFFFF_0000;
            // Where planes are in memory, one is read after the other: all at once they need more
            // registers than there are.
            core::hint::black_box(());
            let here = blue | red.at(x, y) >> 16;
            core::hint::black_box(());
            let drift = here.wrapping_sub(planes.blue_red.at(x, y));
            planes.blue_red.origin = planes.blue_red.origin.wrapping_add(drift);
        }
    }

    #[inline(always)]
    fn dim<F: Format>(corner: &Color) -> Color {
        F::dim(*corner)
    }

    #[inline(always)]
    fn mix(corners: [&Color; 3], u: i32, v: i32) -> Color {
        mix_color(corners, u, v)
    }
}

impl Interpolated for SmoothColor {
    /// Blue, green and red.
    type Words = [u32; 3];
    type Base = ();

    #[inline(always)]
    fn words(corners: &[Color; 3]) -> ([[u32; 3]; 3], ()) {
        (
            corners
                .map(|Color { blue_red, green }| [blue_red >> 16, green >> 16, blue_red & 0xFFFF]),
            (),
        )
    }

    #[inline(always)]
    fn value((): &(), words: [u32; 3]) -> Self {
        let [blue, green, red] = words.map(|word| word << 1);
        Self(Color { blue_red: (blue & 0xFFFF_0000) | red >> 16, green })
    }

    #[inline(always)]
    fn step_of((): &(), right: [u32; 3], _down: [u32; 3]) -> (u32, u32) {
        let [blue, green, red] = right.map(|word| word << 1);
        (packed_slope(blue.cast_signed(), red.cast_signed()), green)
    }
}

/// Colour and depth of a triangle, in one copy for every shader that interpolates nothing else.
///
/// # Cost
/// Some 210 instructions on Cortex-M4, where set-up, depth and colour apart take 280; more for
/// a triangle that is too thin for weights or drawn in pieces.
#[inline(never)]
fn smooth_planes_at_once(
    triangle: &Triangle,
    corners: &[Color; 3],
    made: &mut Option<Ready<SmoothColor>>,
) {
    // In one piece.
    let Some(gradients) = SmallGradients::of::<BY_HALVES>(triangle) else {
        *made = Some(Ready { set: any_planes_at_once(triangle, corners) });
        return;
    };
    if BY_HALVES {
        make_by_parts(&gradients, triangle, corners, made);
    } else {
        make_by_pairs::<HALVES_MULTIPLY>(&gradients, triangle, corners, made);
    }
}

/// The planes of a triangle, all to be made.
#[inline(always)]
fn unmade(made: &mut Option<Ready<SmoothColor>>) -> &mut (SmoothColorPlanes, Plane) {
    let plane = Plane { origin: 0, dx: 0, dy: 0 };
    let planes = SmoothColorPlanes { blue_red: plane, green: plane, fine: None };
    &mut made.insert(Ready { set: (planes, plane) }).set
}

/// The compiler finishes what is above, stores it, and reads anew what is in memory, before it begins what is
/// below: all at once has more values than there are registers.
#[inline(always)]
fn between() {
    core::hint::black_box(());
}

/// The difference of a channel in the lower 16 bits.
#[inline(always)]
const fn low(to: u32, from: u32) -> i32 {
    (to & 0xFFFF).wrapping_sub(from & 0xFFFF).cast_signed()
}

/// The same in the upper 16 bits.
#[inline(always)]
const fn high(to: u32, from: u32) -> i32 {
    (to >> 16).wrapping_sub(from >> 16).cast_signed()
}

/// The planes of a small triangle where products are long; where their upper words are rounded by the same
/// instruction, `ROUNDS`.
#[inline(always)]
fn make_by_pairs<const ROUNDS: bool>(
    gradients: &SmallGradients,
    triangle: &Triangle,
    [a, b, c]: &[Color; 3],
    made: &mut Option<Ready<SmoothColor>>,
) {
    let (planes, depth) = unmade(made);
    // In memory, where a pair is loaded at once.
    let pairs = core::hint::black_box(gradients.pairs());
    let plane = |first: u32, d1: i32, d2: i32| {
        let Slopes { dx, dy, to_center } = gradients.slopes_by_pairs(&pairs, d1, d2);
        let value = first.wrapping_add(to_center.cast_unsigned());
        gradients.plane_at(value, dx.cast_unsigned(), dy.cast_unsigned())
    };
    let (first, to_second, to_third) = triangle.depth_codes();
    *depth = plane(first, to_second, to_third);
    between();
    let first = a.green & !Color::OPAQUE;
    planes.green = plane(first, high(b.green, a.green), high(c.green, a.green));
    between();
    let [column, row, center] = &pairs;
    let (first, second, third) = (a.blue_red, b.blue_red, c.blue_red);
    let (b1, b2) = (high(second, first), high(third, first));
    let (r1, r2) = (low(second, first), low(third, first));
    let sums = |pair| (SmallGradients::sum(pair, b1, b2), SmallGradients::sum(pair, r1, r2));
    let unit = gradients.unit();
    let slope = |pair| {
        let (blue, red) = sums(pair);
        if ROUNDS {
            packed_slope_of_sums(blue, red, unit)
        } else {
            packed_slope(blue.wrapping_mul(unit), red.wrapping_mul(unit))
        }
    };
    let (dx, dy) = (slope(column), slope(row));
    let (blue, red) = sums(center);
    let value = if ROUNDS {
        packed_value_of_sums(first, blue, red, unit)
    } else {
        packed(
            (first & 0xFFFF_0000).wrapping_add(blue.wrapping_mul(unit).cast_unsigned()),
            (first << 16).wrapping_add(red.wrapping_mul(unit).cast_unsigned()),
        )
    };
    planes.blue_red = gradients.plane_at(value, dx, dy);
}

/// [`packed_slope`] of two sums, each times a unit of at most 2^12.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "channels are modulo 2^16")]
fn packed_slope_of_sums(blue: i32, red: i32, unit: i32) -> u32 {
    let unit = i64::from(unit << 16);
    let rounded = |sum| (i64::from(sum).wrapping_mul(unit).wrapping_add(1 << 31) >> 32) as i32;
    let red = i32::from(rounded(red) as i16);
    (rounded(blue) << 16).wrapping_add(red).cast_unsigned()
}

/// [`packed`] of what is at the first corner and of two such sums.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "channels are modulo 2^16")]
fn packed_value_of_sums(first: u32, blue: i32, red: i32, unit: i32) -> u32 {
    let unit = i64::from(unit << 16);
    let upper = |sum| (i64::from(sum).wrapping_mul(unit) >> 32) as i32;
    let red = i32::from(first.cast_signed().wrapping_add(upper(red)) as i16);
    let blue = (upper(blue) << 16).cast_unsigned();
    (first & 0xFFFF_0000).wrapping_add(blue).wrapping_add(red.cast_unsigned())
}

/// The same where they are made of parts.
#[inline(always)]
fn make_by_parts(
    gradients: &SmallGradients,
    triangle: &Triangle,
    [a, b, c]: &[Color; 3],
    made: &mut Option<Ready<SmoothColor>>,
) {
    let (planes, depth) = unmade(made);
    // In memory, where a factor is loaded for each product, which takes its place: a weight that
    // stays in a register is copied there first.
    let parts = core::hint::black_box(gradients.parts());
    let plane = |first: u32, d1: i32, d2: i32| {
        let Slopes { dx, dy, to_center } = gradients.slopes_by_parts(&parts, d1, d2);
        let value = first.wrapping_add(to_center.cast_unsigned());
        gradients.plane_at(value, dx.cast_unsigned(), dy.cast_unsigned())
    };
    let (first, to_second, to_third) = triangle.depth_codes();
    *depth = plane(first, to_second, to_third);
    between();
    let first = a.green & !Color::OPAQUE;
    planes.green = plane(first, high(b.green, a.green), high(c.green, a.green));
    between();
    let (first, second, third) = (a.blue_red, b.blue_red, c.blue_red);
    let slopes = |d1, d2| gradients.slopes_by_parts(&parts, d1, d2);
    let Slopes { dx, dy, to_center } = slopes(high(second, first), high(third, first));
    let upper = |word: u32| word & 0xFFFF_0000;
    let rounded = |slope: i32| slope.wrapping_add(0x8000).cast_unsigned();
    planes.blue_red = Plane {
        origin: upper(upper(first).wrapping_add(to_center.cast_unsigned())),
        dx: upper(rounded(dx)),
        dy: upper(rounded(dy)),
    };
    // What was stored is loaded again.
    compiler_fence(Ordering::SeqCst);
    let Slopes { dx, dy, to_center } = slopes(low(second, first), low(third, first));
    let with = |blue: u32, red: u32| blue.wrapping_add((red.cast_signed() >> 16).cast_unsigned());
    let Plane { origin, dx: blue_dx, dy: blue_dy } = planes.blue_red;
    planes.blue_red = gradients.plane_at(
        with(origin, (first << 16).wrapping_add(to_center.cast_unsigned())),
        with(blue_dx, rounded(dx)),
        with(blue_dy, rounded(dy)),
    );
}

/// The same of triangles that are too thin for weights, or drawn in pieces.
#[cold]
#[inline(never)]
fn any_planes_at_once(triangle: &Triangle, corners: &[Color; 3]) -> (SmoothColorPlanes, Plane) {
    let gradients = &Gradients::new(triangle);
    let (first, to_second, to_third) = triangle.depth_codes();
    let in_pieces = gradients.reach_beyond(SmoothColor::PIECE / 2);
    let planes = exact_planes(gradients, corners, in_pieces);
    (planes, gradients.plane_from(first, to_second, to_third))
}

/// One copy for every shader that interpolates a colour beside something else, or without depth.
#[inline(never)]
fn smooth_planes(
    gradients: &Gradients,
    corners: &[Color; 3],
    in_pieces: bool,
) -> SmoothColorPlanes {
    if gradients.are_exact() {
        exact_planes(gradients, corners, in_pieces)
    } else {
        planes_by(gradients, corners, in_pieces, |d1, d2| gradients.weighted_slopes(d1, d2))
    }
}

/// The same of triangles that are too large or too thin for weights: rare, and long.
#[cold]
#[inline(never)]
fn exact_planes(gradients: &Gradients, corners: &[Color; 3], in_pieces: bool) -> SmoothColorPlanes {
    planes_by(gradients, corners, in_pieces, |d1, d2| gradients.slopes(d1, d2))
}

/// The same with slopes from a function of the differences to the second and the third corner.
#[inline(always)]
fn planes_by(
    gradients: &Gradients,
    [a, b, c]: &[Color; 3],
    in_pieces: bool,
    slopes: impl Fn(i32, i32) -> Slopes,
) -> SmoothColorPlanes {
    let (first, second, third) = (a.blue_red, b.blue_red, c.blue_red);
    let blue = slopes(high(second, first), high(third, first));
    let red = slopes(low(second, first), low(third, first));
    let value = |first: u32, slopes: &Slopes| first.wrapping_add(slopes.to_center.cast_unsigned());
    let blue_value = value(first & 0xFFFF_0000, &blue);
    let red_value = value(first << 16, &red);
    let green = slopes(high(b.green, a.green), high(c.green, a.green));
    let mut planes = SmoothColorPlanes {
        blue_red: gradients.plane_at(
            packed(blue_value, red_value),
            packed_slope(blue.dx, red.dx),
            packed_slope(blue.dy, red.dy),
        ),
        green: gradients.plane_at(
            value(a.green & !Color::OPAQUE, &green),
            green.dx.cast_unsigned(),
            green.dy.cast_unsigned(),
        ),
        fine: None,
    };
    if in_pieces {
        let plane = |value, slopes: &Slopes| {
            gradients.plane_at(value, slopes.dx.cast_unsigned(), slopes.dy.cast_unsigned())
        };
        planes.fine = Some([plane(blue_value, &blue), plane(red_value, &red)]);
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;
    use crate::raster::ScreenVertex;

    #[test]
    fn planes_at_once_are_those_made_apart() {
        let mut random = Random::new(41);
        let (mut seen, mut both) = ([0; 3], 0);
        for round in 0..20_000 {
            // From a few pixels, with slivers among them, to more than the rounded slopes serve.
            let reach = [6, 9, 11, 15][round % 4];
            let mut corner = |_| {
                let (at, z) = (random.word(), random.word());
                let axis = |word: u32| (word & ((1 << reach) - 1)).cast_signed();
                let place = ScreenVertex::from_bits(axis(at), axis(at >> 16), (z >> 16) as u16);
                let [red, green, blue, ..] = random.word().to_le_bytes();
                (place, Color::new(red, green, blue))
            };
            let [(a, p), (b, q), (c, r)] = [(), (), ()].map(&mut corner);
            let Some(triangle) = &Triangle::oriented([a, b, c]) else { continue };
            let corners = &[p, q, r];
            let gradients = &Gradients::new(triangle);
            let in_pieces = gradients.reach_beyond(SmoothColor::PIECE / 2);
            let (first, to_second, to_third) = triangle.depth_codes();
            let apart = (
                smooth_planes(gradients, corners, in_pieces),
                gradients.plane_from(first, to_second, to_third),
            );
            let made = |make: &dyn Fn(&mut Option<Ready<SmoothColor>>)| {
                let mut made = None;
                make(&mut made);
                made.map(|ready| ready.set)
            };
            let at_once = made(&|made| smooth_planes_at_once(triangle, corners, made));
            assert_eq!(at_once, Some(apart), "{triangle:?} {corners:?}");
            // Both ways, wherever this runs.
            for small in
                [SmallGradients::of::<false>(triangle), SmallGradients::of::<true>(triangle)]
            {
                let Some(small) = &small else { continue };
                let all = [
                    made(&|made| make_by_pairs::<false>(small, triangle, corners, made)),
                    made(&|made| make_by_pairs::<true>(small, triangle, corners, made)),
                    made(&|made| make_by_parts(small, triangle, corners, made)),
                ];
                assert_eq!(all, [at_once; 3], "{triangle:?} {corners:?}");
                both += 1;
            }
            assert_eq!(SmoothColor::are_in_pieces(&apart.0), in_pieces, "{triangle:?}");
            seen[usize::from(in_pieces) + usize::from(gradients.are_exact())] += 1;
        }
        assert!(seen.iter().all(|count| *count > 500) && both > 5000, "{seen:?}, {both} small");
    }
}
