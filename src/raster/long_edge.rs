use super::Point;

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
    x: i64,
    step: i64,
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
// Slope times subpixels down is at most the longest side.
const _: () = assert!(LONGEST <= (i64::MAX >> FRACTION) / 2, "products fit");

/// Bits of the fraction that one division gives.
const DIGIT: u32 = 12;
const _: () = assert!(LONGEST << DIGIT < 1 << 32 && FRACTION % DIGIT == 0, "digits fit");

/// dx / dy with 36 fraction bits, rounded down; `dy` above zero.
#[allow(clippy::cast_possible_wrap, reason = "below 2^17 in magnitude")]
fn slope(dx: i32, dy: i32) -> i64 {
    let divisor = (dy as u32).max(1);
    // Magnitudes are divided: the rest of a negative one is taken from the whole below.
    let whole =
        if dx < 0 { !(!(dx) as u32 / divisor) as i32 } else { (dx as u32 / divisor) as i32 };
    let mut rest = dx.wrapping_sub(whole.wrapping_mul(dy)) as u32;
    let mut quotient = i64::from(whole);
    for _ in 0..FRACTION / DIGIT {
        let dividend = rest.wrapping_shl(DIGIT);
        let digit = dividend / divisor;
        rest = dividend.wrapping_sub(digit.wrapping_mul(divisor));
        quotient = quotient.wrapping_shl(DIGIT) | i64::from(digit);
    }
    quotient
}

impl LongEdge {
    /// The walk down from `a` to `b` (`b` strictly below), beginning at row `y`, whose centre is
    /// between them.
    #[inline(never)]
    pub(crate) fn new(a: Point, b: Point, y: i32) -> Self {
        let step = slope(b.x.wrapping_sub(a.x), b.y.wrapping_sub(a.y));
        let down = y.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
        // No more than dx in all, since `down` is no more than dy.
        let along = step.wrapping_mul(down.into()) >> 4;
        let from = i64::from(a.x.wrapping_sub(8)).wrapping_shl(FRACTION - 4);
        Self { x: from.wrapping_add(along).wrapping_add(ROUND_UP), step }
    }

    /// The first column whose centre is not left of the edge.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "columns are in the square of corners")]
    pub(crate) const fn column(&self) -> i32 {
        (self.x >> FRACTION) as i32
    }

    /// Goes one row down.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }
}
