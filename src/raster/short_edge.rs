use super::Point;
use crate::math::{wide_product, BY_HALVES};

/// An edge of a short triangle, walked by one addition a row: exact all the same.
///
/// At the centre of a row the edge is crossed at a multiple of 1 / (16 dy) of a pixel, which is
/// 2^-12 or more while the triangle is at most 16 pixels high. With 19 fraction bits the slope is
/// off by less than 2^-19 a row, so that after 16 rows x is off by less than 2^-14.9: less than
/// half of what lies between two possible crossings. Adding a little less than one
/// ([`ROUND_UP`]) and cutting off is then the exact ceil(crossing - 1/2).
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortEdge {
    /// Columns from the walk's origin with 19 fraction bits, with [`ROUND_UP`] in it.
    x: i32,
    step: i32,
}

/// Fraction bits of a column.
const FRACTION: u32 = 19;
/// Tallest triangle, in subpixels: 16 pixels hold 16 row centres.
pub(super) const TALLEST: i32 = 256;
/// Widest triangle, in subpixels, so that slopes fit: 128 pixels.
pub(super) const WIDEST: i32 = 1 << 11;
/// One less half of the least distance between crossings.
const ROUND_UP: i32 = (1 << FRACTION) - (1 << (FRACTION - 13));

// A row's slope is off by less than a unit, 16 times, and the start by one more.
const _: () = assert!(17 < 1 << (FRACTION - 13), "less than half the distance of crossings");
const _: () = assert!((WIDEST as i64) << FRACTION <= 1 << 30, "slopes fit");

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

/// dx / dy with 19 fraction bits, off by less than one unit.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "in range as the assertions say")]
fn slope(dx: i32, dy: i32) -> i32 {
    if BY_HALVES {
        let inverse = INVERSES.get(dy as usize).copied().unwrap_or(0);
        (wide_product(dx, inverse) >> (31 - FRACTION)) as i32
    } else {
        dx.wrapping_shl(FRACTION).wrapping_div(dy.max(1))
    }
}

impl ShortEdge {
    /// The walk down from `a` to `b` (`b` strictly below), beginning at row `y`, whose centre is
    /// between them; columns count from `origin`.
    #[inline(always)]
    pub(super) fn new(a: Point, b: Point, y: i32, origin: i32) -> Self {
        let dx = b.x.wrapping_sub(a.x);
        let dy = b.y.wrapping_sub(a.y);
        let down = y.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
        let step = slope(dx, dy);
        let from = a.x.wrapping_sub(8).wrapping_sub(origin.wrapping_mul(16));
        // No more than dx in all, since `down` is no more than dy.
        let along = step.wrapping_mul(down) >> 4;
        Self { x: from.wrapping_mul(1 << 15).wrapping_add(along).wrapping_add(ROUND_UP), step }
    }

    /// The first column from the origin whose centre is not left of the edge.
    #[inline(always)]
    pub(super) fn column(&self) -> i32 {
        self.x >> FRACTION
    }

    /// Goes one row down.
    #[inline(always)]
    pub(super) fn step(&mut self) {
        self.x = self.x.wrapping_add(self.step);
    }
}
