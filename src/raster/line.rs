use super::{Divisor, Edge, LongEdge, Path, Pixel, Plane, Point, ScreenVertex, Steps, Triangle};

/// A line one pixel wide, from a first corner to a last one, by the diamond-exit rule.
///
/// A pixel belongs to the line if the line leaves the diamond `|x - cx| + |y - cy| < 1/2` about its
/// centre: of a chain of lines every joint is drawn once. Both ends count as moved by
/// (-e, -e^2) for a very small e, so that nothing is left to chance where a line runs through the
/// diamonds' corners. Source: OpenGL 4.6, section 14.5.1.
///
/// A line that is wider than high crosses the vertical diagonal of every diamond that it enters,
/// except where it ends; so there is one pixel a column, the one whose row the line is in at the
/// column's centre, and only the diamonds about the two ends are looked at. The same holds for
/// rows of a line that is higher than wide.
///
/// # Rounding
/// None: the pixels are exact for every corner in the square of [`GUARD`](super::GUARD).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    first: ScreenVertex,
    last: ScreenVertex,
    /// Columns are counted, not rows.
    by_columns: bool,
    /// The columns (or rows) between the ends: from the first to behind the last.
    from: i32,
    to: i32,
    /// The pixel whose diamond the first corner lies in when its centre lies before the corner.
    head: Option<i32>,
}

/// The first column (or row) whose centre is not before `v`.
#[inline(always)]
const fn not_before(v: i32) -> i32 {
    v.wrapping_add(7) >> 4
}

/// Whether a corner, moved by (-e, -e^2), lies in the diamond of pixel (i, j).
fn is_in_diamond(corner: &ScreenVertex, i: i32, j: i32) -> bool {
    let x = corner.x_bits().wrapping_sub(i.wrapping_mul(16)).wrapping_sub(8);
    let y = corner.y_bits().wrapping_sub(j.wrapping_mul(16)).wrapping_sub(8);
    let distance = x.saturating_abs().saturating_add(y.saturating_abs());
    distance < 8 || (distance == 8 && x > 0)
}

impl Line {
    /// The line between two corners in range; `None` if it leaves no diamond.
    pub(crate) fn between(first: ScreenVertex, last: ScreenVertex) -> Option<Self> {
        let width = last.x_bits().wrapping_sub(first.x_bits());
        let height = last.y_bits().wrapping_sub(first.y_bits());
        let by_columns = width.unsigned_abs() >= height.unsigned_abs();
        let ascending = if by_columns { width > 0 } else { height > 0 };
        let start = |v: &ScreenVertex| not_before(if by_columns { v.x_bits() } else { v.y_bits() });
        let holds = |v: &ScreenVertex, at: i32| {
            // The column's left border belongs to the column before: corners move to the left.
            let (i, j) = if by_columns {
                (at, v.y_bits() >> 4)
            } else {
                (v.x_bits().wrapping_sub(1) >> 4, at)
            };
            is_in_diamond(v, i, j)
        };
        // The pixel just before each end, in the direction of the line.
        let before = |v: &ScreenVertex| start(v).wrapping_sub(i32::from(ascending));
        let (head, tail) = (before(&first), before(&last));
        let is_headed = holds(&first, head);
        let is_cut = holds(&last, tail);
        let (from, to, is_headed) = if ascending {
            let to = start(&last).wrapping_sub(i32::from(is_cut));
            (start(&first), to, is_headed && head < to)
        } else {
            let from = start(&last).wrapping_add(i32::from(is_cut));
            (from, start(&first), is_headed && head >= from)
        };
        let head = is_headed.then_some(head);
        (from < to || head.is_some()).then_some(Self { first, last, by_columns, from, to, head })
    }

    /// The pixel about the first corner whose centre lies before it, so that attributes have to be
    /// the corner's.
    pub(crate) fn head(&self) -> Option<Pixel> {
        let (x, y) = (self.first.x_bits(), self.first.y_bits());
        self.head.map(|at| {
            if self.by_columns {
                Pixel { x: at, y: y >> 4 }
            } else {
                Pixel { x: x.wrapping_sub(1) >> 4, y: at }
            }
        })
    }

    /// The pixels between the ends; attributes are in range there.
    pub(crate) fn path(&self) -> LinePath {
        let Self { first: a, last: b, by_columns, from, to, .. } = *self;
        // Upright, going down, and less half a pixel: then the walk along an edge finds
        // ceil(crossing) - 1, the pixel that holds the crossing if a tie counts to the smaller side.
        let upright = |v: &ScreenVertex, mirror: bool| {
            let (minor, major) =
                if by_columns { (v.y_bits(), v.x_bits()) } else { (v.x_bits(), v.y_bits()) };
            let minor = if mirror { minor.wrapping_neg() } else { minor };
            Point { x: minor.wrapping_sub(8), y: major }
        };
        // Columns: the line is moved to the left, so that one that falls to the right has its ties
        // on the larger side.
        let rise = (b.y_bits() > a.y_bits()) == (b.x_bits() > a.x_bits());
        let mirrored = by_columns && rise && a.y_bits() != b.y_bits();
        let (a, b) = (upright(&a, mirrored), upright(&b, mirrored));
        let (a, b) = if a.y < b.y { (a, b) } else { (b, a) };
        let divisor = Divisor::new(b.y.wrapping_sub(a.y).cast_unsigned());
        let edge = if from < to {
            LongEdge::with_divisor(a, b, from, &divisor)
        } else {
            LongEdge::default()
        };
        LinePath { edge, divisor, from, to, by_columns, mirrored }
    }
}

/// A triangle whose attribute planes are those of a line, steps along its longer side: the third
/// corner has the attributes of the first. Columns are where the line is counted: of one that is
/// higher than wide they are the rows.
pub(crate) fn plane_triangle([a, b]: &[ScreenVertex; 2], by_columns: bool) -> Triangle {
    let lying = |v: &ScreenVertex| {
        let (x, y) = (v.x_bits(), v.y_bits());
        if by_columns {
            *v
        } else {
            ScreenVertex::from_bits(y, x, v.z)
        }
    };
    let (a, b) = (lying(a), lying(b));
    let side = b.x_bits().wrapping_sub(a.x_bits());
    let c = ScreenVertex::from_bits(a.x_bits(), a.y_bits().wrapping_add(side), a.z);
    let area = i64::from(side).wrapping_mul(side.into()).max(1);
    Triangle::of([a, b, c], area, false)
}

/// The depth codes along a line, in equal steps along its longer side: 16.16, raised by a half so
/// that cutting off rounds. Columns are where the line is counted, rows are all the same.
///
/// # Rounding
/// A step is off by half of 2^-16 of a code, so that depth is off by less than 1/8 of a code over any
/// line in the square of [`GUARD`](super::GUARD); of a line so short that a step overflows, modulo
/// 2^32.
#[inline(never)]
pub(crate) fn depth_along<P: Path>([a, b]: &[ScreenVertex; 2], path: &P) -> Plane {
    if a.z == b.z {
        return Plane { origin: u32::from(a.z) << 16 | 0x8000, dx: 0, dy: 0 };
    }
    let along = |v: &ScreenVertex| if path.by_columns() { v.x_bits() } else { v.y_bits() };
    let start = along(a);
    let side = along(b).wrapping_sub(start);
    let more = i32::from(b.z).wrapping_sub(a.z.into());
    let more = if side < 0 { more.wrapping_neg() } else { more };
    let divisor = path.divisor(side.unsigned_abs());
    // 2^7 times a number below 2^29 in magnitude, divided and rounded.
    let divided = |number: i32| {
        let (whole, rest) = divisor.divide(number.unsigned_abs());
        let (part, _) = divisor.divide((rest << 7).wrapping_add(divisor.number() >> 1));
        let quotient = whole.wrapping_shl(7).wrapping_add(part);
        if number < 0 {
            quotient.wrapping_neg()
        } else {
            quotient
        }
    };
    let to_center = 8_i32.wrapping_sub(start & 15);
    let dx = divided(more.wrapping_shl(13));
    let origin = (u32::from(a.z) << 16 | 0x8000)
        .wrapping_add(divided(more.wrapping_mul(to_center).wrapping_shl(9)))
        .wrapping_sub(dx.wrapping_mul((start >> 4).cast_unsigned()));
    Plane { origin, dx, dy: 0 }
}

/// Steps after which [`LinePath`] looks anew where the line is.
pub(super) const STRIDE: i32 = 256;

/// The pixels of a [`Line`] between its ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinePath {
    /// At `from`.
    edge: LongEdge,
    /// Divides by the longer side.
    divisor: Divisor,
    from: i32,
    to: i32,
    by_columns: bool,
    /// Rows are counted upwards.
    mirrored: bool,
}

impl Path for LinePath {
    type Steps = LineSteps;

    #[inline(always)]
    fn by_columns(&self) -> bool {
        self.by_columns
    }

    #[inline(always)]
    fn ends(&self) -> (i32, i32) {
        (self.from, self.to)
    }

    #[inline(always)]
    fn minor(&self, at: i32) -> i32 {
        let column = self.edge.after(at.wrapping_sub(self.from)).column();
        if self.mirrored {
            !column
        } else {
            column
        }
    }

    #[inline(always)]
    fn steps(&self, at: i32) -> LineSteps {
        let (fraction, _, step) = self.edge.after(at.wrapping_sub(self.from)).parts();
        LineSteps { number: fraction.into(), step: step.into() }
    }

    #[inline(always)]
    fn least_step(&self) -> (i32, i32) {
        let (_, whole, _) = self.edge.parts();
        if self.mirrored {
            (whole.wrapping_neg(), -1)
        } else {
            (whole, 1)
        }
    }

    #[inline(always)]
    fn divisor(&self, _side: u32) -> Divisor {
        self.divisor
    }

    #[inline(always)]
    fn good_until(&self, at: i32) -> i32 {
        at.wrapping_add(STRIDE)
    }
}

/// Steps across a line, by what a fraction carries: one addition of 64 bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineSteps {
    /// With 32 fraction bits.
    number: u64,
    step: u64,
}

impl Steps for LineSteps {
    #[inline(always)]
    fn begin(&mut self, number: u32, least: u32) {
        self.number |= u64::from(number) << 32;
        self.step |= u64::from(least) << 32;
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the upper half")]
    fn number(&self) -> u32 {
        (self.number >> 32) as u32
    }

    #[inline(always)]
    fn step(&mut self) {
        self.number = self.number.wrapping_add(self.step);
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the fraction")]
    fn carries(&mut self) -> bool {
        let (fraction, carries) = (self.number as u32).overflowing_add(self.step as u32);
        self.number = fraction.into();
        carries
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;
    use crate::raster::MidpointPath;

    #[test]
    #[allow(clippy::cast_possible_truncation, reason = "sixteen random bits")]
    fn depth_along_lines_is_that_of_equal_steps() {
        let mut random = Random::new(11);
        let mut side = |bits: u32| (random.word() >> (32 - bits)).cast_signed();
        let check = |from: i32, to: i32, z: [u16; 2]| {
            let ends =
                [ScreenVertex::from_bits(from, 0, z[0]), ScreenVertex::from_bits(to, 1, z[1])];
            let Some(path) = MidpointPath::between(&ends[0], &ends[1]) else { return };
            if !path.by_columns() {
                return;
            }
            let plane = depth_along(&ends, &path);
            let (low, high) = (not_before(from.min(to)), not_before(from.max(to)));
            for x in [low, low + 1, (low + high) / 2, high - 2, high - 1] {
                if x < low || x >= high {
                    continue;
                }
                let part = f64::from(16 * x + 8 - from) / f64::from(to - from);
                let exact = f64::from(z[0]) + part * (f64::from(z[1]) - f64::from(z[0]));
                let got = f64::from(plane.at(x, 7)) / 65_536.0 - 0.5;
                assert!((got - exact).abs() < 0.125, "{from}..{to} {z:?} at {x}: {got} {exact}");
                assert!((plane.at(x, 7) >> 16) as u16 <= z[0].max(z[1]));
                assert!((plane.at(x, 7) >> 16) as u16 >= z[0].min(z[1]));
            }
        };
        for length in 1..=17 {
            for _ in 0..20_000 {
                let from = side(17) - 65_536;
                let to = (from + side(length) - side(length)).clamp(-65_536, 65_535);
                let z = [side(16) as u16, side(16) as u16];
                check(from, to, z);
                check(from, to, [0, 65_535]);
                check(from, to, [65_535, 0]);
            }
        }
        check(-65_536, 65_535, [0, 65_535]);
        check(65_535, -65_536, [0, 65_535]);
    }
}
