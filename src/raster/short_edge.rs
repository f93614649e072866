use super::Point;
use crate::math::BY_HALVES;

/// An edge of a short triangle, walked by one addition a row: exact all the same.
///
/// At the centre of a row the edge is crossed at a multiple of 1 / (16 dy) of a pixel, which is 36
/// units of 2^-17 or more while the triangle is at most 14 pixels high. The slope is off by at most
/// 9/8 of a unit a row, so that after 14 rows and a cut x is off by less than 17: less than half of
/// what lies between two possible crossings. Adding a little less than one ([`ROUND_UP`]) and
/// cutting off is then the exact ceil(crossing - 1/2).
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortEdge {
    /// Columns with 17 fraction bits, with [`ROUND_UP`] in it.
    pub(super) x: i32,
    pub(super) step: i32,
}

/// Fraction bits of a column.
pub(super) const FRACTION: u32 = 17;
/// Tallest triangle, in subpixels: 14 pixels hold 14 row centres.
pub(super) const TALLEST: i32 = 14 * 16;
/// Widest triangle, in subpixels: 128 pixels. Its sides from the highest corner are half as wide.
pub(super) const WIDEST: i32 = 1 << 11;
/// Half of the least distance between crossings.
const HALF: i32 = (1 << FRACTION) / (16 * TALLEST) / 2;
/// One less half of the least distance between crossings.
const ROUND_UP: i32 = (1 << FRACTION) - HALF;

// Eighths of a unit: a division that rounds to zero is off by less than 8 of them a row, a product
// with an inverse by less than 8 and a part of what the inverse is off; the cut by less than 8.
const _: () = assert!(WIDEST <= 1 << (31 - FRACTION - 3), "an inverse costs an eighth at most");
const _: () = assert!(TALLEST / 16 * 9 + 8 < HALF * 8, "less than half the distance of crossings");
const _: () = assert!((WIDEST as i64) << FRACTION <= 1 << 30, "slopes fit");
const _: () = assert!(2 * super::GUARD < 1 << (31 - FRACTION), "columns of the square fit");

/// 2^31 / dy, for cores that do not divide.
#[allow(clippy::cast_possible_truncation, reason = "in range as the assertions say")]
static INVERSES: [u32; TALLEST as usize + 1] = {
    let mut inverses = [0; TALLEST as usize + 1];
    let mut dy = 2;
    while dy <= TALLEST as usize {
        inverses[dy] = (1 << 31) / dy as u32;
        dy += 1;
    }
    // Just below 2^31, so that it is in range of the signed product.
    inverses[1] = (1 << 31) - 1;
    inverses
};

/// The product with an inverse, rounded down to 17 fraction bits: of two parts, both of which fit 32
/// bits, since a short triangle's sides have 12.
#[inline(always)]
const fn by_inverse(dx: i32, inverse: u32) -> i32 {
    const CUT: u32 = 31 - FRACTION;
    let (high, low) = ((inverse >> CUT).cast_signed(), (inverse & ((1 << CUT) - 1)).cast_signed());
    dx.wrapping_mul(high).wrapping_add(dx.wrapping_mul(low) >> CUT)
}

const _: () = assert!((WIDEST as i64) << FRACTION < 1 << 31, "the high part's product fits");

/// dx / dy with 17 fraction bits, off by at most 9/8 of a unit.
#[inline(always)]
fn slope(dx: i32, dy: i32) -> i32 {
    if BY_HALVES {
        by_inverse(dx, INVERSES.get(dy as usize).copied().unwrap_or(0))
    } else if dy > 0 {
        dx.wrapping_shl(FRACTION).wrapping_div(dy)
    } else {
        0
    }
}

impl ShortEdge {
    /// The walk down from `a` to `b`, which is so much below, beginning at row `y`, whose centre is between them.
    #[inline(always)]
    pub(super) fn of_height(a: Point, b: Point, dy: i32, y: i32) -> Self {
        let dx = b.x.wrapping_sub(a.x);
        let down = y.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
        let step = slope(dx, dy);
        // No more than dx in all, since `down` is no more than dy.
        let along = step.wrapping_mul(down) >> 4;
        let from = a.x.wrapping_sub(8).wrapping_mul(1 << (FRACTION - 4));
        Self { x: from.wrapping_add(ROUND_UP).wrapping_add(along), step }
    }

    /// The same walk so many rows further down.
    #[inline(always)]
    pub(super) const fn after(&self, rows: i32) -> Self {
        Self { x: self.x.wrapping_add(self.step.wrapping_mul(rows)), step: self.step }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_two_parts_are_those_of_64_bits() {
        for dy in 1..=TALLEST {
            let inverse = INVERSES[dy as usize];
            for dx in 1 - WIDEST..WIDEST {
                let exact = (i64::from(dx) * i64::from(inverse)) >> (31 - FRACTION);
                assert_eq!(i64::from(by_inverse(dx, inverse)), exact, "{dx} / {dy}");
            }
        }
    }
}
