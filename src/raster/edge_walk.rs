use super::Point;

/// Whether the core divides in hardware. ARMv6-M does not; it is the one Arm profile without
/// compare-and-swap, by which it is told here.
const HAS_DIVIDE: bool = cfg!(not(all(target_arch = "arm", not(target_has_atomic = "32"))));

/// An edge walked row by row: the first pixel whose centre is not left of it, by exact integers.
///
/// At a row's centre the edge is crossed at x; `x` here is ceil(crossing - 1/2), and
/// `remainder / dy` is how far that is beyond the crossing, so that no error builds up.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct EdgeWalk {
    pub(crate) x: i32,
    remainder: i32,
    dy: i32,
    whole: i32,
    rest: i32,
}

/// Quotient and remainder of a division that rounds down; `b` must be above zero.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "the same bits, read as signed: see the range")]
fn divide_floor(a: i32, b: i32) -> (i32, i32) {
    // An unsigned division of the magnitude: cheaper than a signed one where it is a call. `b` is
    // never 0, which the compiler is shown by the `max` that costs less than a panic path.
    let b = (b as u32).max(1);
    let quotient = if a >= 0 { (a as u32 / b) as i32 } else { !((!a) as u32 / b) as i32 };
    (quotient, a.wrapping_sub(quotient.wrapping_mul(b as i32)))
}

impl EdgeWalk {
    /// The walk down from `a` to `b` (`b` strictly below), beginning at row `y` (at or below
    /// `a`'s first row).
    ///
    /// # Range
    /// All coordinates in the square of [`GUARD`](super::GUARD): the numerator stays below
    /// 2^30 + 2^22 in magnitude.
    #[inline(never)]
    pub(crate) fn new(a: Point, b: Point, y: i32) -> Self {
        let dx = b.x.wrapping_sub(a.x);
        let dy = b.y.wrapping_sub(a.y);
        debug_assert!(dy > 0, "an edge is walked downwards");
        // ceil((a.x + dx (y' - a.y) / dy - 8) / 16) with y' = 16 y + 8, split so that it fits.
        let down = y.wrapping_mul(16).wrapping_add(8).wrapping_sub(a.y);
        let from = a.x.wrapping_sub(8);
        let part = (from & 15)
            .wrapping_mul(dy)
            .wrapping_add(dx.wrapping_mul(down & 15))
            .wrapping_add(dy.wrapping_mul(16))
            .wrapping_sub(1)
            >> 4;
        let numerator = part.wrapping_add(dx.wrapping_mul(down >> 4));
        if HAS_DIVIDE {
            let (x, remainder) = divide_floor(numerator, dy);
            let (whole, rest) = divide_floor(dx, dy);
            return Self { x: x.wrapping_add(from >> 4), remainder, dy, whole, rest };
        }
        // Without a divider: count up or down where that is short, which it nearly always is.
        let flat = dx.unsigned_abs() > (dy as u32).wrapping_mul(4);
        let mut walk = Self { x: from >> 4, remainder: numerator, dy, whole: 0, rest: dx };
        if flat || down >> 4 != 0 {
            let (x, remainder) = divide_floor(numerator, dy);
            walk.x = walk.x.wrapping_add(x);
            walk.remainder = remainder;
        }
        if flat {
            (walk.whole, walk.rest) = divide_floor(dx, dy);
        }
        walk.settle();
        walk
    }

    /// Goes one row down.
    #[inline(always)]
    pub(crate) fn step(&mut self) {
        self.x = self.x.wrapping_add(self.whole);
        self.remainder = self.remainder.wrapping_add(self.rest);
        if HAS_DIVIDE {
            if self.remainder >= self.dy {
                self.remainder = self.remainder.wrapping_sub(self.dy);
                self.x = self.x.wrapping_add(1);
            }
        } else {
            self.settle();
        }
    }

    /// Brings the remainder back into 0..dy.
    #[inline(always)]
    fn settle(&mut self) {
        while self.remainder < 0 {
            self.remainder = self.remainder.wrapping_add(self.dy);
            self.x = self.x.wrapping_sub(1);
        }
        while self.remainder >= self.dy {
            self.remainder = self.remainder.wrapping_sub(self.dy);
            self.x = self.x.wrapping_add(1);
        }
    }
}
