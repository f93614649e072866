use super::gradients::{Sides, Slopes, THICK};
use super::{Plane, Triangle};
use crate::math::{
    in_parts, mantissa_of, mul_high_signed, weighted_sum_of_parts, zeros_of_byte, BY_HALVES,
    HALVES_MULTIPLY,
};

/// Triangles are small whose sides from the first corner are shorter than this (64 pixels, in
/// subpixels), and whose twice area is below that: their weights have the scale that their sides have
/// room for, with no need to ask what the slopes have room for.
///
/// Sides of 32 - n bits have an area below 2^(65 - 2n), and so 2n - 33 zeros above it at least; with six
/// more that is n - 4 where n is 23 or more. With 22 the area must have 12.
pub(crate) const SMALL_SIDE: u32 = 1 << SIDE_BITS;
const SMALL_AREA: u32 = 1 << (2 * SIDE_BITS);
const SIDE_BITS: u32 = 10;

/// Bits above a weight.
const HIGH: u32 = 4;

/// The [`Gradients`](super::Gradients) of a small triangle, weights as they are before cores ask for another form: the
/// same to the bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct SmallGradients {
    column: [i32; 2],
    row: [i32; 2],
    center: [i32; 2],
    up: u32,
    /// The first corner's pixel.
    pixel_x: i32,
    pixel_y: i32,
}

impl SmallGradients {
    /// Those of a triangle that is small and neither thin nor, by halves, tiny: all others have
    /// [`Gradients`](super::Gradients).
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "areas of short sides fit")]
    pub(crate) fn of<const BY_BYTES: bool>(triangle: &Triangle) -> Option<Self> {
        let Sides { x1, y1, x2, y2, longest } = Sides::of(triangle);
        let area = triangle.area as u32;
        // Before the square, which may wrap of sides that are not small.
        let beyond = if BY_BYTES { 0 } else { area / SMALL_AREA };
        if (longest / SMALL_SIDE) | beyond != 0 || area < longest.wrapping_mul(longest) >> THICK {
            return None;
        }
        let (normal, left, up) = if BY_BYTES {
            normal_by_bytes(longest, area)?
        } else {
            let (zeros, area_zeros) = (longest.leading_zeros(), area.leading_zeros());
            let up = area_zeros.wrapping_add(10).wrapping_sub(zeros);
            (area.wrapping_shl(area_zeros), zeros.wrapping_sub(4), up)
        };
        let mantissa = mantissa_of(normal);
        let of = |side: i32| {
            let side = side.wrapping_shl(left);
            if BY_BYTES {
                eighth_of_high(side, mantissa)
            } else {
                mul_high_signed(side, mantissa)
            }
        };
        let of_negative = |side: i32| {
            if BY_BYTES {
                of(side.wrapping_neg())
            } else {
                high_of_negative(side.wrapping_shl(left), mantissa)
            }
        };
        let column = [of(y2), of_negative(y1)];
        let row = [of_negative(x2), of(x1)];
        let [a, ..] = &triangle.v;
        let to_center_x = 8_i32.wrapping_sub(a.x_bits() & 15);
        let to_center_y = 8_i32.wrapping_sub(a.y_bits() & 15);
        let center = |c: i32, r: i32| {
            c.wrapping_mul(to_center_x).wrapping_add(r.wrapping_mul(to_center_y)) >> 4
        };
        Some(Self {
            column,
            row,
            center: [center(column[0], row[0]), center(column[1], row[1])],
            up,
            pixel_x: a.x_bits() >> 4,
            pixel_y: a.y_bits() >> 4,
        })
    }

    /// The plane of one attribute alone, which has the value `first` at the first corner, and so much more at
    /// the second and at the third (below 2^16 in magnitude).
    #[inline(always)]
    pub(crate) fn plane(&self, first: u32, d1: i32, d2: i32) -> Plane {
        let Slopes { dx, dy, to_center } = if BY_HALVES {
            self.slopes_by_parts(&self.parts(), d1, d2)
        } else {
            self.slopes_by_pairs(&self.pairs(), d1, d2)
        };
        let value = first.wrapping_add(to_center.cast_unsigned());
        self.plane_at(value, dx.cast_unsigned(), dy.cast_unsigned())
    }

    /// The weights as cores without long products multiply by them.
    #[inline(always)]
    pub(crate) const fn parts(&self) -> [[i32; 4]; 3] {
        let [[p, q], [r, s], [t, u]] = [self.column, self.row, self.center];
        [in_parts(p, q), in_parts(r, s), in_parts(t, u)]
    }

    /// The slopes of an attribute by [parts](Self::parts).
    #[inline(always)]
    pub(crate) fn slopes_by_parts(
        &self,
        [column, row, center]: &[[i32; 4]; 3],
        d1: i32,
        d2: i32,
    ) -> Slopes {
        let sum = |parts: &[i32; 4]| weighted_sum_of_parts(d1, d2, *parts).wrapping_shl(self.up);
        Slopes { dx: sum(column), dy: sum(row), to_center: sum(center) }
    }

    /// The weights as all other cores do: as high as their words have room for, since they are below 2^27.
    #[inline(always)]
    pub(crate) const fn pairs(&self) -> [[i32; 2]; 3] {
        let [[p, q], [r, s], [t, u]] = [self.column, self.row, self.center];
        [[p << HIGH, q << HIGH], [r << HIGH, s << HIGH], [t << HIGH, u << HIGH]]
    }

    /// What the differences of an attribute are in all, before it is shifted, by a [pair](Self::pairs).
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "below 2^29")]
    pub(crate) const fn sum([p, q]: &[i32; 2], d1: i32, d2: i32) -> i32 {
        let (d1, d2) = ((d1 << (16 - HIGH)) as i64, (d2 << (16 - HIGH)) as i64);
        (d1.wrapping_mul(*p as i64).wrapping_add(d2.wrapping_mul(*q as i64)) >> 32) as i32
    }

    /// The slopes of an attribute by [pairs](Self::pairs).
    #[inline(always)]
    pub(crate) fn slopes_by_pairs(
        &self,
        [column, row, center]: &[[i32; 2]; 3],
        d1: i32,
        d2: i32,
    ) -> Slopes {
        let slope = |pair| Self::sum(pair, d1, d2).wrapping_mul(self.unit());
        Slopes { dx: slope(column), dy: slope(row), to_center: slope(center) }
    }

    /// What makes slopes of [sums](Self::sum): a power of two, at most 2^12.
    ///
    /// Where a product and a sum are one instruction, the compiler does not know that it is one, which
    /// would make it shift.
    #[inline(always)]
    pub(crate) const fn unit(&self) -> i32 {
        if HALVES_MULTIPLY {
            1_i32.rotate_left(self.up)
        } else {
            1_i32.wrapping_shl(self.up)
        }
    }

    /// The plane with a value at the centre of the first corner's pixel, and slopes, of any format.
    #[inline(always)]
    pub(crate) const fn plane_at(&self, value: u32, dx: u32, dy: u32) -> Plane {
        let origin = value
            .wrapping_sub(dx.wrapping_mul(self.pixel_x.cast_unsigned()))
            .wrapping_sub(dy.wrapping_mul(self.pixel_y.cast_unsigned()));
        Plane { origin, dx, dy }
    }
}

/// The area shifted until its uppermost bit is set, and how far sides and slopes are to be shifted, of a
/// triangle whose sides are small and which is not thin. `None` where its area is not small, or its sides
/// are below four subpixels.
///
/// Sides of n bits have an area below 2^(2n + 1), and one that is not thin has 2^(2n - 7) at least: its
/// uppermost bit is one of eight, as the longest side's is.
#[inline(always)]
fn normal_by_bytes(longest: u32, area: u32) -> Option<(u32, u32, u32)> {
    let byte = longest >> (SIDE_BITS - 8);
    if byte == 0 {
        return None;
    }
    let zeros = zeros_of_byte(byte);
    let area = area.wrapping_shl(zeros.wrapping_mul(2).wrapping_add(31 - 2 * SIDE_BITS));
    let area_zeros = zeros_of_byte(area >> 24);
    let up = zeros.wrapping_add(area_zeros).checked_sub(1)?;
    Some((area.wrapping_shl(area_zeros), zeros.wrapping_add(32 - SIDE_BITS - 17), up))
}

/// An eighth of the upper word of 2^16 times a product, rounded down, by two products of 32 bits; `side` must have
/// no more than 16 bits with its sign, or be 2^15.
#[inline(always)]
const fn eighth_of_high(side: i32, mantissa: u32) -> i32 {
    let (high, low) = ((mantissa >> 16).cast_signed(), (mantissa & 0xFFFF).cast_signed());
    side.wrapping_mul(high).wrapping_add(side.wrapping_mul(low) >> 16) >> 3
}

/// The upper word of a product less than zero, rounded down: one instruction, as it is of one above.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "below 2^31")]
const fn high_of_negative(a: i32, b: u32) -> i32 {
    ((a as i64).wrapping_mul(b as i32 as i64).wrapping_neg() >> 32) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;
    use crate::raster::{Gradients, ScreenVertex};

    /// Checks a triangle of these sides against [`Gradients`], both ways of making it and of using it;
    /// whether it is small.
    fn is_small_and_right([x1, y1, x2, y2]: [i32; 4], random: &mut Random) -> bool {
        let at = random.word();
        let (x, y) = ((at & 0x1FFF).cast_signed() - 4096, (at >> 16 & 0x1FFF).cast_signed() - 4096);
        let corner = |x1, y1| ScreenVertex::from_bits(x + x1, y + y1, 0);
        let v = [corner(0, 0), corner(x1, y1), corner(x2, y2)];
        let Some(triangle) = Triangle::oriented(v) else { return false };
        let Sides { longest, .. } = Sides::of(&triangle);
        let gradients = Gradients::new(&triangle);
        let is_small =
            longest < SMALL_SIDE && triangle.area < i64::from(SMALL_AREA) && !gradients.are_exact();
        let plain = SmallGradients::of::<false>(&triangle);
        let by_bytes = SmallGradients::of::<true>(&triangle);
        assert_eq!(plain.is_some(), is_small, "{triangle:?}");
        assert_eq!(by_bytes, plain.filter(|_| longest >= 4), "{triangle:?}");
        if let Some(small) = &plain {
            assert!((1..=1 << 12).contains(&small.unit()), "{triangle:?}");
            let word = random.word();
            let d = |word: u32| match word & 7 {
                0 => 0xFFFF,
                1 => -0xFFFF,
                2 => 0,
                _ => (word & 0x1FFFF).cast_signed() - 0xFFFF,
            };
            let (d1, d2) = (d(word).clamp(-0xFFFF, 0xFFFF), d(word >> 15).min(0xFFFF));
            let expected = gradients.slopes(d1, d2);
            let slopes = [
                small.slopes_by_pairs(&small.pairs(), d1, d2),
                small.slopes_by_parts(&small.parts(), d1, d2),
            ];
            assert_eq!(slopes, [expected; 2], "{triangle:?}, {d1}, {d2}");
            let plane = gradients.inlined_plane(word, d1, d2);
            assert_eq!(small.plane(word, d1, d2), plane, "{triangle:?}, {d1}, {d2}");
        }
        is_small
    }

    #[test]
    fn small_gradients_are_gradients() {
        let mut random = Random::new(43);
        let mut small = 0;
        // All triangles of a few subpixels.
        let side = || -6..=6;
        for (x1, y1) in side().flat_map(|x| side().map(move |y| (x, y))) {
            for (x2, y2) in side().flat_map(|x| side().map(move |y| (x, y))) {
                small += u32::from(is_small_and_right([x1, y1, x2, y2], &mut random));
            }
        }
        assert!(small > 10_000, "{small}");
        // Sides about powers of two, where zeros and the kind of triangle change.
        small = 0;
        for _ in 0..200_000 {
            let reach = 2 + random.word() % 10;
            let sides = [(); 4].map(|()| {
                let word = random.word();
                let end = 1_i32 << (reach - (word >> 8 & 3).min(reach) * (word >> 10 & 1));
                let near = end + (word >> 4 & 3).cast_signed() - 2;
                let side =
                    if word & 3 == 0 { (word >> 12).cast_signed() % (end + 1) } else { near };
                if word & 4 == 0 {
                    side
                } else {
                    -side
                }
            });
            small += u32::from(is_small_and_right(sides, &mut random));
        }
        assert!((50_000..180_000).contains(&small), "{small}");
    }

    #[test]
    fn small_triangles_have_the_scale_that_their_sides_have_room_for() {
        for bits in 1..=SMALL_SIDE.trailing_zeros() {
            let zeros = 32 - bits;
            let ends = [-(1_i32 << bits), 1 - (1 << bits), (1 << bits) - 1];
            for (x1, y2) in ends.iter().flat_map(|x| ends.map(|y| (*x, y))) {
                for (x2, y1) in ends.iter().flat_map(|x| ends.map(|y| (*x, y))) {
                    let area = x1 * y2 - x2 * y1;
                    if (1..SMALL_AREA.cast_signed()).contains(&area) {
                        let scale = 6 + area.leading_zeros();
                        assert!(scale >= zeros - 4, "{x1}, {y1}, {x2}, {y2}");
                    }
                }
            }
            // The least scale there is.
            let most = (SMALL_AREA - 1).min((2 << (2 * bits)) - 1);
            assert!(6 + most.leading_zeros() >= zeros - 4, "{bits}");
        }
    }
}
