//! The diamond-exit rule as it is written, in exact fractions.

use microraster::raster::ScreenVertex;

/// One subpixel in units that hold e = 2^-16 and e^2 = 2^-32 subpixels exactly.
const UNIT: i128 = 1 << 32;
const E: i128 = 1 << 16;

/// A point moved by (-e, -e^2), seen from the centre of a pixel.
fn seen_from(v: &ScreenVertex, x: i32, y: i32) -> (i128, i128) {
    let (dx, dy) = (v.x.to_bits() - (16 * x + 8), v.y.to_bits() - (16 * y + 8));
    (i128::from(dx) * UNIT - E, i128::from(dy) * UNIT - 1)
}

/// The four sides of the diamond: inside where each is below half a pixel.
fn sides((x, y): (i128, i128)) -> [i128; 4] {
    [x + y, x - y, y - x, -x - y]
}

/// Whether the line from `a` to `b` intersects the open diamond about the centre of pixel (x, y)
/// and `b` does not lie in it.
pub(crate) fn leaves_diamond(a: &ScreenVertex, b: &ScreenVertex, x: i32, y: i32) -> bool {
    let half = 8 * UNIT;
    let (from, to) = (sides(seen_from(a, x, y)), sides(seen_from(b, x, y)));
    if to.iter().all(|&side| side < half) {
        return false;
    }
    // Each side is inside for the t of an open half line: from + t (to - from) < half.
    // Bounds are fractions with a denominator above zero; 0 <= t <= 1 belong to the line.
    let (mut low, mut low_is_in) = ((0, 1), true);
    let (mut high, mut high_is_in) = ((1, 1), true);
    for (from, to) in from.into_iter().zip(to) {
        let (slope, room) = (to - from, half - from);
        match slope {
            0 if room <= 0 => return false,
            0 => {}
            1.. if room * high.1 <= high.0 * slope => (high, high_is_in) = ((room, slope), false),
            1.. => {}
            _ if -room * low.1 >= low.0 * -slope => (low, low_is_in) = ((-room, -slope), false),
            _ => {}
        }
    }
    let (l, h) = (low.0 * high.1, high.0 * low.1);
    l < h || (l == h && low_is_in && high_is_in)
}
