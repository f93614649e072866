//! From where a draw sees a mesh: by which planes of triangles are asked what side they show.
//!
//! Twice the area of a triangle on the screen is the determinant of its corners' (x, y, w), over the product
//! of the three w. That determinant is the product of two vectors of four numbers (Cauchy and Binet): the triangle's
//! plane, and the eye, which is the only point that x, y and w of the matrix all take to zero. Matrices of draws
//! hold whole numbers, so that nothing of this is rounded before corners are, to subpixels, by half of one and
//! what their reciprocal is off.
//!
//! Where each of two coordinates of three corners may be off by e, twice the area is off by at most e L + 4 e^2,
//! L being the sum of the six sides of the triangle's edges along x and y: a corner's step is multiplied with the edge
//! that faces it, and products of two steps make twice a triangle in a square of side 2 e. Twice the area of a
//! triangle is at most that of its box, which is at most L^2 / 16. So where twice the area is at least 1.21 e L, L is at least 19.36 e and 4 e^2
//! at most 0.207 e L: the area has its sign.
//!
//! An edge's side along x is what x / w gains on it: at most its length times the largest |grad x - t grad w| for
//! any t = x / w of the view, over the lesser w of its ends. The other two w are at most the largest of the mesh's box.

use super::mapping::Mapping;
use super::CulledWindings;
use crate::math::{sqrt, whole};
use crate::scene::{Facing, PlaneScale};

/// The farthest from the viewport's middle that anything of the mesh's box may lie, in pixels, so that 12.4
/// holds it.
const FARTHEST: f32 = 2000.0;

/// 1.21 times the pixels by which a corner may be off, times the 127 of a plane for its radius; with room for the
/// rounding of what follows.
const SLACK: f32 = 1.22 * (0.502 / 16.0) * 127.0;

/// A row of a matrix to clip space: the sum of its numbers, those of positions times 2^15, is below 2^30.
type Row = [i32; 4];

/// How far positions that reach so far by axis move a coordinate from its translation.
#[inline(never)]
fn moved(row: &Row, reach: &[u16; 3]) -> u32 {
    let products =
        row.iter().zip(reach).map(|(v, reach)| v.unsigned_abs().wrapping_mul((*reach).into()));
    products.fold(0, u32::wrapping_add)
}

/// The product of what rows say of positions: at most 2^30.
#[inline(never)]
fn product(p: &Row, q: &Row) -> f32 {
    let [a, b, c] = [0, 1, 2].map(|at| p[at].wrapping_mul(q[at]));
    a.wrapping_add(b).wrapping_add(c) as f32
}

/// How far across the view a coordinate may lie, by w; and the most that it gains on w by a step of a position, times
/// w: the largest |grad v - t grad w| for t from minus to plus that.
#[inline(never)]
fn across(v: &Row, w: &Row, reach: &[u16; 3], least_w: f32) -> (f32, f32) {
    let farthest = v[3].unsigned_abs().wrapping_add(moved(v, reach)) as f32 / least_w;
    let of_w = product(w, w) * farthest + 2.0 * product(v, w).abs();
    (farthest, sqrt(product(v, v) + farthest * of_w))
}

/// The eye, the fourth coordinate in 65536ths: of each four columns of x, y and w the determinant of the other three,
/// with alternating signs.
///
/// None exceeds the product of three rows' sums, 2^60 where one column is the translation, 2^45 where none is.
#[inline(never)]
fn eye(x: &Row, y: &Row, w: &Row) -> [i64; 4] {
    let product = |a: i64, b: i64| a.wrapping_mul(b);
    let minor = |i: usize, j: usize| {
        product(x[i].into(), y[j].into()).wrapping_sub(product(x[j].into(), y[i].into()))
    };
    let [a, b, c, d] = w.map(i64::from);
    let (bc, ca, ab) = (minor(1, 2), minor(2, 0), minor(0, 1));
    let (ad, bd, cd) = (minor(0, 3), minor(1, 3), minor(2, 3));
    [
        product(b, cd).wrapping_sub(product(c, bd)).wrapping_add(product(d, bc)),
        product(c, ad).wrapping_sub(product(a, cd)).wrapping_add(product(d, ca)),
        product(a, bd).wrapping_sub(product(b, ad)).wrapping_add(product(d, ab)),
        product(a, bc)
            .wrapping_add(product(b, ca))
            .wrapping_add(product(c, ab))
            .wrapping_mul(-1 << 16),
    ]
}

/// From where the planes of a mesh's triangles are seen, which were made with a scale; `z` is the row of
/// clip z, where that is one.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "shifted to 20 bits")]
pub(super) fn facing(
    [x, y, w]: [&Row; 3],
    z: Option<&Row>,
    mapping: &Mapping,
    culled: CulledWindings,
    PlaneScale { radius, reach }: &PlaneScale,
) -> Facing {
    let [clockwise, counter_clockwise] = culled.by_winding();
    let least_w = w[3].wrapping_sub_unsigned(moved(w, reach));
    if clockwise == counter_clockwise || least_w < mapping.least_easy_w() {
        return Facing::NONE;
    }
    if let Some(z) = z {
        // What is below zero of the box is before the near plane.
        let before = [0, 1, 2, 3].map(|at| w[at].wrapping_sub(z[at]));
        let is_cut = before[3] < 0 || before[3].unsigned_abs() < moved(&before, reach);
        if is_cut || z[3].wrapping_sub_unsigned(moved(z, reach)) < mapping.depth.z_min {
            return Facing::NONE;
        }
    }
    let size = mapping.size();
    let [width, height] = [size.width, size.height].map(|side| f32::from(side) * 0.5);
    let least_w = least_w as f32;
    let ((farthest_x, step_x), (farthest_y, step_y)) =
        (across(x, w, reach, least_w), across(y, w, reach, least_w));
    if farthest_x * width > FARTHEST || farthest_y * height > FARTHEST {
        return Facing::NONE;
    }
    let most_w = w[3].wrapping_add_unsigned(moved(w, reach)) as f32;
    let margin =
        SLACK / f32::from((*radius).max(1)) * most_w * most_w * (step_x / height + step_y / width);
    let eye = eye(x, y, w);
    let largest = eye.iter().fold(0, |largest: u64, v| largest | v.unsigned_abs());
    let down = 44_u32.saturating_sub(largest.leading_zeros());
    let sign = if clockwise { -1 } else { 1 };
    let eye = eye.map(|v| ((v >> down) as i32).wrapping_mul(sign));
    // Bytes may be half of one off, and the eye one.
    let halves = eye.iter().fold(0, |sum: u32, v| sum.wrapping_add(v.unsigned_abs())) >> 1;
    let scale = f32::from_bits(127_u32.wrapping_sub(down) << 23);
    let least = margin * scale + (halves.wrapping_add(4 * 128 + 2)) as f32;
    if least < (1 << 29) as f32 {
        Facing::new(eye, whole(least))
    } else {
        Facing::NONE
    }
}

#[cfg(test)]
#[path = "facing_tests.rs"]
mod tests;
