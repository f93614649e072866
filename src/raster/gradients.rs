use super::{Plane, Triangle};
use crate::math::{
    inlined_reciprocal_of_some, leading_zeros, mul_high_signed, reciprocal, weight, weighted_sum,
    BY_HALVES,
};

/// What the attribute planes of one triangle share: its sides and the reciprocal of its area.
///
/// # Rounding
/// On triangles that are neither large nor thin (sides below 1024 pixels, and twice the area at
/// least 1/32 of the longest side's square) a slope is the sum of two differences, each times its
/// weight of up to 27 bits: over the whole triangle an attribute is off by less than 1/8 of a
/// step. On all others slopes come from the exact determinant, rounded to 2^-16 of a step, in 64
/// bits that are cut off, never clamped: see [`Plane`]. The reciprocal's error (2^-29.4) is common
/// to both slopes, so that it only scales the difference to the first corner.
///
/// # Cost
/// About 105 instructions to make and 35 a plane on Cortex-M4, 300 a plane of large or thin
/// triangles.
#[derive(Clone, Copy, Debug)]
pub struct Gradients {
    /// What a difference of 2^16 to the second and to the third corner makes in a column, in a row,
    /// and from the first corner to the centre of its pixel, all up to a shift.
    column: [i32; 2],
    row: [i32; 2],
    center: [i32; 2],
    up: u32,
    /// The first corner's pixel.
    pixel_x: i32,
    pixel_y: i32,
    /// As many bits as has the way to the other corners along either axis, in subpixels.
    reach: u32,
    /// Of a triangle that is too large or too thin for weights.
    exact: Option<Exact>,
}

/// The sides, and 1 / (2 area) = mantissa 2^-(shift + 20), the 20 for 16 fraction bits and 16
/// subpixels.
#[derive(Clone, Copy, Debug)]
struct Exact {
    x1: i32,
    y1: i32,
    x2: i32,
    y2: i32,
    mantissa: u32,
    shift: u32,
    /// Whether the sides are below [`SHORT_SIDE`].
    is_short: bool,
    /// From the first corner to the centre of its pixel, in subpixels.
    to_center_x: i32,
    to_center_y: i32,
}

/// Sides up to here (1024 pixels, in subpixels) may have weights.
const SHORT_SIDE: u32 = 1 << 14;
/// The least twice area that weights are made for, as a power of two of the longest side's square.
pub(super) const THICK: u32 = 5;

/// The sides from the first corner, in subpixels.
pub(super) struct Sides {
    pub(super) x1: i32,
    pub(super) y1: i32,
    pub(super) x2: i32,
    pub(super) y2: i32,
    /// As many bits as the longest has.
    pub(super) longest: u32,
}

impl Sides {
    #[inline(always)]
    pub(super) fn of(triangle: &Triangle) -> Self {
        let [a, b, c] = &triangle.v;
        let (x1, y1) = (b.x_bits().wrapping_sub(a.x_bits()), b.y_bits().wrapping_sub(a.y_bits()));
        let (x2, y2) = (c.x_bits().wrapping_sub(a.x_bits()), c.y_bits().wrapping_sub(a.y_bits()));
        // The complement of one that is negative.
        let bits = |side: i32| side ^ (side >> 31);
        let longest = (bits(x1) | bits(y1) | bits(x2) | bits(y2)).cast_unsigned();
        Self { x1, y1, x2, y2, longest }
    }
}

/// The upper word of (side 2^room) mantissa, rounded down, by two products of 32 bits.
///
/// `side` must have no more than 14 bits, `zeros` is the number of zeros above those of the longest
/// side, and `room` is below that.
#[inline(always)]
const fn high_of_short(side: i32, zeros: u32, room: u32, mantissa: u32) -> i32 {
    // 15 bits and the sign, times halves of 15 and 16.
    let side = side.wrapping_shl(zeros.wrapping_sub(17));
    let (high, low) = ((mantissa >> 16).cast_signed(), (mantissa & 0xFFFF).cast_signed());
    let product = side.wrapping_mul(high).wrapping_add(side.wrapping_mul(low) >> 16);
    product >> (zeros.wrapping_sub(1).wrapping_sub(room) & 31)
}

impl Gradients {
    /// Of no triangle: where nothing is interpolated.
    pub(crate) const NONE: Self = Self {
        column: [0; 2],
        row: [0; 2],
        center: [0; 2],
        up: 0,
        pixel_x: 0,
        pixel_y: 0,
        reach: 0,
        exact: None,
    };

    /// Prepares the planes of a triangle.
    #[inline(never)]
    pub fn new(triangle: &Triangle) -> Self {
        Self::inlined(triangle)
    }

    /// The same in place: for planes of one kind, which weights then reach without memory.
    #[inline(always)]
    pub(crate) fn inlined(triangle: &Triangle) -> Self {
        Self::weighted(triangle).unwrap_or_else(|| Self::exact(triangle))
    }

    /// The same of a triangle that is too large or too thin for weights: rare.
    #[cold]
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation, reason = "areas above 32 bits are shifted")]
    fn exact(triangle: &Triangle) -> Self {
        let Sides { x1, y1, x2, y2, longest } = Sides::of(triangle);
        let [a, ..] = &triangle.v;
        // Areas above 32 bits lose low bits that are far below the reciprocal's own error.
        let excess = 32_u32.saturating_sub(triangle.area.leading_zeros());
        let reciprocal = reciprocal((triangle.area >> excess) as u32);
        let shift = reciprocal.shift.wrapping_add(excess).wrapping_sub(20);
        let mantissa = reciprocal.mantissa;
        let to_center_x = 8_i32.wrapping_sub(a.x_bits() & 15);
        let to_center_y = 8_i32.wrapping_sub(a.y_bits() & 15);
        let is_short = longest < SHORT_SIDE;
        let exact = Exact { x1, y1, x2, y2, mantissa, shift, is_short, to_center_x, to_center_y };
        let (pixel_x, pixel_y) = (a.x_bits() >> 4, a.y_bits() >> 4);
        Self { pixel_x, pixel_y, reach: longest, exact: Some(exact), ..Self::NONE }
    }

    /// The same of any other triangle.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "areas of short sides fit")]
    fn weighted(triangle: &Triangle) -> Option<Self> {
        let Sides { x1, y1, x2, y2, longest } = Sides::of(triangle);
        let [a, ..] = &triangle.v;
        let to_center_x = 8_i32.wrapping_sub(a.x_bits() & 15);
        let to_center_y = 8_i32.wrapping_sub(a.y_bits() & 15);
        let (pixel_x, pixel_y) = (a.x_bits() >> 4, a.y_bits() >> 4);
        let area = triangle.area as u32;
        if longest < SHORT_SIDE && area >= longest.wrapping_mul(longest) >> THICK {
            // Never zero: a triangle is made with an area.
            let reciprocal = inlined_reciprocal_of_some(area);
            // Sides at most 2^28, so that weights are at most 2^27; side / area is
            // weight 2^(32 - room - shift). Sums lose 16 bits, slopes have 16 more and count
            // pixels of 16 subpixels, which leaves a shift that is never to the right.
            let scale = 68_u32.wrapping_sub(reciprocal.shift);
            let zeros = leading_zeros(longest);
            let room = zeros.wrapping_sub(4).min(scale);
            let of = |side: i32| {
                if BY_HALVES {
                    high_of_short(side, zeros, room, reciprocal.mantissa)
                } else {
                    mul_high_signed(side.wrapping_shl(room), reciprocal.mantissa)
                }
            };
            let column = [of(y2), of(y1.wrapping_neg())];
            let row = [of(x2.wrapping_neg()), of(x1)];
            // At most 8 subpixels each way: 2^27 x 8 + 2^27 x 8 is just in range.
            let center = |c: i32, r: i32| {
                c.wrapping_mul(to_center_x).wrapping_add(r.wrapping_mul(to_center_y)) >> 4
            };
            let center = [center(column[0], row[0]), center(column[1], row[1])];
            Some(Self {
                column: column.map(weight),
                row: row.map(weight),
                center: center.map(weight),
                up: scale.wrapping_sub(room) & 31,
                pixel_x,
                pixel_y,
                reach: longest,
                exact: None,
            })
        } else {
            None
        }
    }

    /// Whether a corner may be as far as so many pixels from the first one, along either axis.
    #[inline(always)]
    pub(crate) const fn reach_beyond(&self, pixels: i32) -> bool {
        self.reach >= pixels.unsigned_abs().wrapping_mul(16)
    }

    /// The plane through an attribute's values at the triangle's corners, as 16.16.
    ///
    /// # Range
    /// Any three 16-bit values, whatever they count: depth codes, 8.8 channels.
    #[inline(always)]
    pub fn plane(&self, a: u16, b: u16, c: u16) -> Plane {
        let from = i32::from(a);
        self.plane_from(
            u32::from(a) << 16,
            i32::from(b).wrapping_sub(from),
            i32::from(c).wrapping_sub(from),
        )
    }

    /// The plane that has the value `first` (16.16) at the first corner, and so much more at the
    /// second and at the third (below 2^16 in magnitude).
    #[inline(never)]
    pub(crate) fn plane_from(&self, first: u32, d1: i32, d2: i32) -> Plane {
        self.inlined_plane(first, d1, d2)
    }

    /// The same in place.
    #[inline(always)]
    pub(crate) fn inlined_plane(&self, first: u32, d1: i32, d2: i32) -> Plane {
        let Slopes { dx, dy, to_center } = self.slopes(d1, d2);
        self.plane_at(first.wrapping_add(to_center as u32), dx as u32, dy as u32)
    }

    /// The plane with a value at the centre of the first corner's pixel, and slopes, of any format.
    #[inline(always)]
    pub(crate) fn plane_at(&self, value: u32, dx: u32, dy: u32) -> Plane {
        let origin = value
            .wrapping_sub(dx.wrapping_mul(self.pixel_x as u32))
            .wrapping_sub(dy.wrapping_mul(self.pixel_y as u32));
        Plane { origin, dx, dy }
    }

    /// The slopes (16.16) of an attribute that has so much more at the second and at the third
    /// corner than at the first (below 2^16 in magnitude).
    #[inline(always)]
    pub(crate) fn slopes(&self, d1: i32, d2: i32) -> Slopes {
        if let Some(exact) = &self.exact {
            exact.slopes(d1, d2)
        } else {
            self.weighted_slopes(d1, d2)
        }
    }

    /// The same where they are [not exact](Self::are_exact).
    #[inline(always)]
    pub(crate) fn weighted_slopes(&self, d1: i32, d2: i32) -> Slopes {
        let sum = |[p, q]: [i32; 2]| weighted_sum(d1, p, d2, q).wrapping_shl(self.up);
        Slopes { dx: sum(self.column), dy: sum(self.row), to_center: sum(self.center) }
    }

    /// Whether the triangle is too large or too thin for weights.
    #[inline(always)]
    pub(crate) const fn are_exact(&self) -> bool {
        self.exact.is_some()
    }
}

/// The slopes of an attribute, 16.16, modulo 2^32.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Slopes {
    /// The step to the next column.
    pub(crate) dx: i32,
    /// The step to the next row.
    pub(crate) dy: i32,
    /// From the first corner to the centre of its pixel.
    pub(crate) to_center: i32,
}

impl Exact {
    /// From the exact determinant. Apart, because it is rare and long.
    #[cold]
    #[inline(never)]
    fn slopes(&self, d1: i32, d2: i32) -> Slopes {
        let slopes = |p: i32, q: i32, r: i32, s: i32| {
            let numerator = if BY_HALVES && self.is_short {
                // Products below 2^30.
                p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s)).into()
            } else {
                let (p, q, r, s) = (i64::from(p), i64::from(q), i64::from(r), i64::from(s));
                p.wrapping_mul(q).wrapping_sub(r.wrapping_mul(s))
            };
            scaled_twice(numerator, self.mantissa, self.shift)
        };
        let (dx, sub_x) = slopes(d1, self.y2, d2, self.y1);
        let (dy, sub_y) = slopes(d2, self.x1, d1, self.x2);
        let to_center =
            sub_x.wrapping_mul(self.to_center_x).wrapping_add(sub_y.wrapping_mul(self.to_center_y));
        Slopes { dx, dy, to_center }
    }
}

/// The same as [`scaled_wide`] with this shift, which must not be zero, and with four more, by one
/// product where both are below 32.
#[inline(never)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "planes are modulo 2^32: the upper bits are cut off on purpose"
)]
fn scaled_twice(numerator: i64, mantissa: u32, shift: u32) -> (i32, i32) {
    if shift < 28 {
        let product = numerator.wrapping_mul(mantissa.into()) as u64;
        let rounded = |shift: u32| {
            let half = 1_u32.wrapping_shl(shift.wrapping_sub(1));
            let sum = product.wrapping_add(half.into());
            // By words: some cores call a function for a shift of 64 bits.
            let (low, high) = (sum as u32, (sum >> 32) as u32);
            let above = high.wrapping_shl(32_u32.wrapping_sub(shift));
            (above | low.wrapping_shr(shift)).cast_signed()
        };
        (rounded(shift), rounded(shift.wrapping_add(4)))
    } else {
        let scaled = |shift| scaled_wide(numerator, mantissa, shift);
        (scaled(shift), scaled(shift.wrapping_add(4)))
    }
}

/// The low 32 bits of numerator x mantissa / 2^shift, rounded, for numerators of up to 36 bits.
///
/// The whole product has up to 67 bits: its low 64 are enough while the shift is at most 32, its
/// high part from there on.
#[inline(never)]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "planes are modulo 2^32: the upper bits are cut off on purpose"
)]
fn scaled_wide(numerator: i64, mantissa: u32, shift: u32) -> i32 {
    if shift <= 32 {
        let product = numerator.wrapping_mul(mantissa.into());
        (product.wrapping_add(1 << (shift.wrapping_sub(1) & 63)) >> (shift & 63)) as i32
    } else {
        let low = (numerator & 0xFFFF_FFFF).wrapping_mul(mantissa.into());
        // Logical: the low product is unsigned.
        let carry = ((low as u64) >> 32) as i64;
        let high = (numerator >> 32).wrapping_mul(mantissa.into()).wrapping_add(carry);
        let shift = shift.wrapping_sub(32);
        (high.wrapping_add(1 << (shift.wrapping_sub(1) & 63)) >> (shift & 63)) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;

    #[test]
    fn numerators_are_scaled_twice_as_they_are_once() {
        let mut random = Random::new(22);
        for round in 0..200_000 {
            let wide = i64::from(random.word().cast_signed()) << 4 | i64::from(random.word() & 15);
            let numerator = wide >> (random.word() % 36);
            let mantissa = 1 << 30 | random.word() >> 2;
            let shift = 11 + round % 48;
            let once = |shift| scaled_wide(numerator, mantissa, shift);
            let twice = scaled_twice(numerator, mantissa, shift);
            assert_eq!(twice, (once(shift), once(shift + 4)), "{numerator} {mantissa} {shift}");
        }
    }

    #[test]
    fn sides_of_a_subpixel_have_no_bits_and_their_products_are_right() {
        // The complement of -1 has none, and a side may be its opposite.
        let zeros = 0_u32.leading_zeros();
        for (side, room) in (-1..=1).flat_map(|side| (0..=zeros - 4).map(move |room| (side, room)))
        {
            for mantissa in [1 << 30, (1 << 30) + 1, 0x5A5A_5A5A, (1 << 31) - 1] {
                let exact = ((i64::from(side) << room) * i64::from(mantissa)) >> 32;
                let short = high_of_short(side, zeros, room, mantissa);
                assert_eq!(i64::from(short), exact, "{side}, {room}, {mantissa}");
            }
        }
    }

    #[test]
    fn short_products_are_those_of_64_bits() {
        let mut random = Random::new(21);
        for _ in 0..2_000_000 {
            let bits = 1 + random.word() % 14;
            let longest = 1_u32 << (bits - 1) | random.word() >> (32 - bits);
            let zeros = longest.leading_zeros();
            // The longest may be less than zero, and a side may be its opposite.
            let end = 1_i32 << (32 - zeros);
            let side = match random.word() % 8 {
                0 => end,
                1 => -end,
                2 => end - 1,
                _ => {
                    (random.word() >> zeros).cast_signed() - (random.word() & 1).cast_signed() * end
                }
            };
            let room = (zeros - 4).min(random.word() & 31);
            let mantissa = match random.word() % 4 {
                0 => (1 << 31) - 1,
                1 => 1 << 30,
                _ => 1 << 30 | random.word() >> 2,
            };
            let exact = ((i64::from(side) << room) * i64::from(mantissa)) >> 32;
            let short = high_of_short(side, zeros, room, mantissa);
            assert_eq!(i64::from(short), exact, "{side} of {longest}, {room}, {mantissa}");
        }
    }
}
