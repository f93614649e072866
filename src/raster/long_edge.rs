use core::num::NonZero;

use super::{Edge, Point};
use crate::math::{mul_high_31, reciprocal, Reciprocal, BY_HALVES};

/// An edge of a triangle of any size, walked by one addition of 64 bits a row: exact all the same.
///
/// At the centre of a row the edge is crossed at a multiple of 1 / (16 dy) of a pixel, which is
/// 2^-21 or more in the square of [`GUARD`](super::GUARD). With 36 fraction bits the slope is off
/// by less than 2^-36 a row, so that after 8192 rows x is off by less than 2^-22.9: less than half
/// of what lies between two possible crossings. Adding a little less than one ([`ROUND_UP`]) and
/// cutting off is then the exact ceil(crossing - 1/2).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LongEdge {
    /// Columns with 36 fraction bits, with [`ROUND_UP`] in it.
    pub(super) x: i64,
    pub(super) step: i64,
}

/// Fraction bits of a column.
const FRACTION: u32 = 36;
/// The longest side in the square of corners, in subpixels.
const LONGEST: i64 = 2 * super::GUARD as i64 * super::SUBPIXELS as i64;
/// One less half of the least distance between crossings.
const ROUND_UP: i64 = (1 << FRACTION) - (1 << (FRACTION - 22));

// A row's slope is off by less than a unit, over all rows, and the start by one more.
const _: () = assert!(LONGEST / 16 + 2 < 1 << (FRACTION - 22), "less than half a distance");
const _: () = assert!(16 * LONGEST == 1 << 21, "the distance of crossings");
// Of a line whose fraction is cut to 32 bits: what is left of it after so many steps.
const _: () = assert!(
    LONGEST / 16 + 2 + ((super::line::STRIDE as i64 + 1) << (FRACTION - 32)) < 1 << (FRACTION - 22),
    "still less than half a distance"
);
// Slope times subpixels down is at most the longest side.
const _: () = assert!(LONGEST <= (i64::MAX >> FRACTION) / 2, "products fit");

/// Bits of the fraction that one division gives.
const DIGIT: u32 = 12;
const _: () = assert!(LONGEST << DIGIT < 1 << 32 && FRACTION.is_multiple_of(DIGIT), "digits fit");

/// Whether the core divides in hardware. ARMv6-M does not; there the reciprocal's table serves.
const HAS_DIVIDE: bool = !BY_HALVES;

/// A number above zero, by which others are divided.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Divisor {
    // Of this type, so that the compiler sees that no division is by zero.
    number: NonZero<u32>,
    reciprocal: Reciprocal,
}

impl Divisor {
    /// Of zero that of one.
    #[inline(always)]
    pub(crate) fn new(number: u32) -> Self {
        let reciprocal =
            if HAS_DIVIDE { Reciprocal { mantissa: 0, shift: 0 } } else { reciprocal(number) };
        Self { number: NonZero::new(number).unwrap_or(NonZero::<u32>::MIN), reciprocal }
    }

    /// Quotient and rest of a number below 2^29.
    #[inline(always)]
    pub(super) fn divide(&self, dividend: u32) -> (u32, u32) {
        if HAS_DIVIDE {
            let quotient = dividend / self.number;
            return (quotient, dividend.wrapping_sub(quotient.wrapping_mul(self.number())));
        }
        by_reciprocal(dividend, self.number(), self.reciprocal)
    }
}

impl Divisor {
    /// The number.
    #[inline(always)]
    pub(super) const fn number(&self) -> u32 {
        self.number.get()
    }
}

/// Quotient and rest of a number below 2^29 by one whose reciprocal is known.
#[inline(always)]
fn by_reciprocal(dividend: u32, number: u32, by: Reciprocal) -> (u32, u32) {
    // Three bits more in the dividend, so that a reciprocal that is 2^-29.4 off and a cut are
    // off by less than one together.
    let quotient = mul_high_31(dividend << 3, by.mantissa) >> (by.shift.wrapping_sub(29) & 31);
    let rest = dividend.wrapping_sub(quotient.wrapping_mul(number));
    if rest >= number {
        // One too few leaves too much; one too many leaves less than nothing.
        return if rest.cast_signed() < 0 {
            (quotient.wrapping_sub(1), rest.wrapping_add(number))
        } else {
            (quotient.wrapping_add(1), rest.wrapping_sub(number))
        };
    }
    (quotient, rest)
}

/// dx / dy with 36 fraction bits, rounded down; `dy` above zero.
#[inline(always)]
fn slope(dx: i32, divisor: &Divisor) -> i64 {
    // What is negative is divided as the number of which it is the complement: -n - 1 for n.
    let sign = dx >> 31;
    let (whole, rest) = divisor.divide((dx ^ sign).cast_unsigned());
    let mut quotient = i64::from(whole.cast_signed() ^ sign);
    let mut rest = if sign == 0 { rest } else { !rest.wrapping_sub(divisor.number()) };
    for _ in 0..FRACTION / DIGIT {
        let digit;
        (digit, rest) = divisor.divide(rest.wrapping_shl(DIGIT));
        quotient = quotient.wrapping_shl(DIGIT) | i64::from(digit);
        // A loop: the digits are about flash.
        core::hint::black_box(());
    }
    quotient
}

impl LongEdge {
    /// Fraction bits of columns.
    pub(super) const FRACTION: u32 = FRACTION;
    /// How much less than one is above the crossing's own column, at most.
    pub(super) const SHORT_BY: i64 = (1 << FRACTION) - ROUND_UP + (LONGEST / 16 + 2);

    /// The walk down from `a` to `b` (`b` strictly below), beginning at row `y`, whose centre is
    /// between them.
    #[inline(never)]
    pub(crate) fn new(a: Point, b: Point, y: i32) -> Self {
        Self::inlined(a, b, y, &Divisor::new(b.y.wrapping_sub(a.y).cast_unsigned()))
    }

    /// The same, with what divides by the way down.
    #[inline(never)]
    pub(crate) fn with_divisor(a: Point, b: Point, y: i32, down: &Divisor) -> Self {
        Self::inlined(a, b, y, down)
    }

    #[inline(always)]
    fn inlined(a: Point, b: Point, y: i32, down: &Divisor) -> Self {
        let step = slope(b.x.wrapping_sub(a.x), down);
        let down = y.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
        // No more than dx in all, since `down` is no more than dy.
        let along = step.wrapping_mul(down.into()) >> 4;
        let from = i64::from(a.x.wrapping_sub(8)).wrapping_shl(FRACTION - 4);
        Self { x: from.wrapping_add(along).wrapping_add(ROUND_UP), step }
    }
}

impl LongEdge {
    /// The same walk so many rows further down.
    #[inline(always)]
    pub(crate) const fn after(&self, rows: i32) -> Self {
        Self { x: self.x.wrapping_add(self.step.wrapping_mul(rows as i64)), step: self.step }
    }

    /// The fraction of the column, and the columns of a step: whole ones, rounded down, and 32
    /// bits of fraction.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "slopes of lines are within one column")]
    pub(crate) const fn parts(&self) -> (u32, i32, u32) {
        const DOWN: u32 = FRACTION - 32;
        ((self.x >> DOWN) as u32, (self.step >> FRACTION) as i32, (self.step >> DOWN) as u32)
    }
}

impl Edge for LongEdge {
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "columns are in the square of corners")]
    fn column(&self) -> i32 {
        (self.x >> FRACTION) as i32
    }

    #[inline(always)]
    fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;

    #[test]
    fn quotients_by_reciprocals_are_exact() {
        let mut random = Random::new(7);
        let check = |dividend: u32, number: u32| {
            let got = by_reciprocal(dividend, number, reciprocal(number));
            assert_eq!(got, (dividend / number, dividend % number), "{dividend} / {number}");
        };
        for number in (1..5000).chain([65_535, 65_536, 131_071, 131_072]) {
            for dividend in [0, 1, number - 1, number, number + 1, (1 << 29) - 1] {
                check(dividend, number);
            }
            let multiple = ((1 << 29) - 1) / number * number;
            check(multiple, number);
            check(multiple.saturating_sub(1), number);
        }
        for _ in 0..2_000_000 {
            let number = (random.word() >> 15 >> (random.word() & 15)).max(1);
            check(random.word() >> 3 >> (random.word() & 15), number);
        }
    }

    #[test]
    fn slopes_are_rounded_down_at_both_ends() {
        let mut random = Random::new(8);
        let ends = [(1, 1), (-1, 1), (0, 5), (131_072, 1), (-131_072, 1), (-131_072, 131_072)];
        let any = (0..200_000).map(|_| {
            let side = (random.word() >> 15).cast_signed();
            (if random.word() & 1 == 0 { side } else { -side }, (random.word() >> 15).cast_signed())
        });
        for (dx, dy) in ends.into_iter().chain(any.filter(|(_, dy)| *dy > 0)) {
            let exact = (i128::from(dx) << FRACTION).div_euclid(i128::from(dy));
            assert_eq!(
                i128::from(slope(dx, &Divisor::new(dy.cast_unsigned()))),
                exact,
                "{dx} / {dy}"
            );
        }
    }
}
