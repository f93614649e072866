use super::facing::facing;
use super::mapping::Mapping;
use super::{Clip, CulledWindings};
use crate::math::{forget, rolled, sum_of_products, whole, Mat4, Vec3, Vec4, HALVES_MULTIPLY};
use crate::scene::{Facing, PlaneScale};

/// What limits the view in depth, and what depth is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Depth {
    /// The smallest w in view: the near distance less the rounding of the matrix where z' is that
    /// constant, else 1.
    pub(super) w_min: i32,
    /// The smallest z in view: 0 where a far plane is, else the least of all.
    pub(super) z_min: i32,
    /// 65531 x near = numerator 2^(29 - shift), normalised to 2^30..2^31, where z' is the near
    /// distance everywhere and depth comes from w alone; 0 where z' is a row of the matrix.
    pub(super) numerator: u32,
    pub(super) shift: u32,
    /// From this w on a code needs no limit, if z is at most w.
    pub(super) easy_w: i32,
}

/// The least near distance in clip space of which depths up to the largest w take no more than a
/// shift by 31.
const LEAST_EASY_NEAR: f32 = 2048.0;

impl Depth {
    /// Depth from a row of the matrix; `far` says whether z' < 0 is beyond a far plane.
    pub(super) const fn of_row(far: bool) -> Self {
        let z_min = if far { 0 } else { i32::MIN };
        Self { w_min: 1, z_min, numerator: 0, shift: 0, easy_w: 1 }
    }

    /// Depth from w, for a near distance in units of clip space; `None` if it is not above zero.
    pub(super) fn of_w(near: f32) -> Option<Self> {
        // Sign and exponent: what is negative, no number or infinite lies above the range, and zero
        // below it.
        let bits = (near * 65531.0).to_bits();
        let exponent = bits >> 23;
        if !(30..=254).contains(&exponent) {
            return None;
        }
        // Mantissas may be half a unit off, at positions of up to 32768.
        let rounding = least(near * (1.0 / 64.0), 3.0 * 16384.0 + 1.0);
        Some(Self {
            w_min: whole(near - rounding).max(1),
            z_min: 0,
            numerator: (bits | 1 << 23) << 8 >> 1,
            shift: 186_u32.wrapping_sub(exponent),
            easy_w: if near < LEAST_EASY_NEAR { i32::MAX } else { whole(near).saturating_add(1) },
        })
    }

    /// Whether z' is a row of the matrix.
    #[inline(always)]
    pub(super) const fn is_row(&self) -> bool {
        self.numerator == 0
    }
}

/// The matrix from 16-bit positions to clip space, in block-float: sixteen-bit mantissas and
/// 32-bit translations of one common exponent.
///
/// # Rounding
/// Mantissas are rounded to 2^-15 of the largest clip coordinate that the mesh's box can reach: at
/// most 1/64 pixel on a 320-pixel screen for what is as far away as that.
///
/// # Cost
/// 35 instructions a vertex on Cortex-M4.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transform {
    /// Three mantissas and the translation, of x, y, w and z; z's are 0 where depth comes from w.
    /// In words, which load in pairs; where halves are factors, those of x, y and w as [`packed`] has
    /// them.
    rows: [[i32; 4]; 4],
    /// Whether depth comes from z.
    has_z: bool,
}

const _: () = assert!(Clip::LIMIT == 1 << (29 + 1), "matrices are scaled to reach below 2^30");

/// The lesser of two floats that are not negative, by their bits.
fn least(a: f32, b: f32) -> f32 {
    f32::from_bits(a.to_bits().min(b.to_bits()))
}

/// Where a mesh lies: its scale and its offset (whose fourth component is 1).
pub(super) type Place = (Vec3, Vec4);

/// A row of a matrix in front of which comes the place of a mesh.
///
/// Returns what the row can reach, by its bits: what is no number is larger than all.
#[inline(never)]
fn place_row(row: &mut [f32; 4], place: &Place, a: f32, b: f32, c: f32, d: f32) -> u32 {
    let (scale, offset) = place;
    let d = sum_of_products(a, b, c, d, offset);
    let (a, b, c) = (a * scale.x, b * scale.y, c * scale.z);
    *row = [a, b, c, d];
    ((a.abs() + b.abs() + c.abs()) * 32768.0 + d.abs()).abs().to_bits()
}

impl Transform {
    /// None yet: all zero, which takes no flash.
    pub(super) const NONE: Self = Self { rows: [[0; 4]; 4], has_z: false };

    /// Makes this the transform of positions (-32768..=32767 by axis) of a mesh that lies at `place`
    /// to clip space by `matrix`.
    ///
    /// `near` is given where clip z is that constant; otherwise z' < 0 is cut off. `None` for a
    /// matrix that is not finite, or all zero.
    pub(super) fn set(&mut self, matrix: &Mat4, place: &Place, near: Option<f32>) -> Option<Depth> {
        let Mat4 { x, y, z, w } = matrix;
        let mut rows = [[0.0; 4]; 4];
        let [to_x, to_y, to_w, to_z] = &mut rows;
        // The largest coordinate that any position can reach.
        let largest = place_row(to_x, place, x.x, y.x, z.x, w.x)
            .max(place_row(to_y, place, x.y, y.y, z.y, w.y))
            .max(place_row(to_w, place, x.w, y.w, z.w, w.w));
        let largest = match near {
            Some(_) => largest,
            None => largest.max(place_row(to_z, place, x.z, y.z, z.z, w.z)),
        };
        // With room for rounding below 2^30.
        let exponent = (f32::from_bits(largest) * 1.0002).to_bits() >> 23;
        if !(29..=254).contains(&exponent) {
            return None;
        }
        let unit = f32::from_bits(283_u32.wrapping_sub(exponent) << 23);
        self.has_z = near.is_none();
        let (numbers, values) = (self.rows.as_flattened_mut(), rows.as_flattened());
        for at in rolled(16) {
            if let (Some(number), Some(value)) = (numbers.get_mut(at), values.get(at)) {
                // The nearest.
                let scaled = value * unit;
                *number = whole(scaled + 0.5_f32.copysign(scaled));
            }
        }
        if HALVES_MULTIPLY {
            self.rows = packed(&self.rows);
        }
        match near {
            None => Some(Depth::of_row(true)),
            Some(near) => Depth::of_w(near * unit),
        }
    }

    /// The clip coordinates of a position; z is 0 where depth comes from w.
    ///
    /// Not inlined: the caller keeps its registers, and there is one copy of this.
    #[inline(never)]
    pub(crate) fn apply(&self, position: &[i16; 3]) -> Clip {
        let [x, y, w] = self.sides::<true>(position);
        Clip { x, y, z: self.z(position), w }
    }

    /// x, y and w of the same, in place; `APART` reads what makes w before all else.
    #[inline(always)]
    pub(super) fn sides<const APART: bool>(&self, position: &[i16; 3]) -> [i32; 3] {
        if HALVES_MULTIPLY {
            return transformed_by_halves::<APART>(&self.rows, position);
        }
        let [x, y, w, _] = &self.rows;
        [x, y, w].map(|row| transformed(row, position))
    }

    /// Rows of x, y, z and w, not packed.
    pub(super) fn rows(&self) -> [[i32; 4]; 4] {
        let [x, y, w, z] = if HALVES_MULTIPLY { unpacked(&self.rows) } else { self.rows };
        [x, y, z, w]
    }

    /// From where planes of triangles are seen through this.
    pub(super) fn facing(
        &self,
        mapping: &Mapping,
        culled: CulledWindings,
        scale: &PlaneScale,
    ) -> Facing {
        let [x, y, z, w] = &self.rows();
        facing([x, y, w], self.has_z.then_some(z), mapping, culled, scale)
    }

    /// z of the same.
    #[inline(never)]
    pub(super) fn z(&self, position: &[i16; 3]) -> i32 {
        let [_, _, _, z] = &self.rows;
        if self.has_z {
            transformed(z, position)
        } else {
            0
        }
    }
}

/// Rows of x, y and w with two mantissas a word, as [`transformed_by_halves`] takes them; the fourth
/// as it is.
///
/// ```text
/// | x: first, second | x: translation | y: first, second | y: translation |
/// | w: first, second | w: translation | third of x, of y | third of w     |
/// ```
fn packed([x, y, w, z]: &[[i32; 4]; 4]) -> [[i32; 4]; 4] {
    let pair = |low: i32, high: i32| low & 0xFFFF | high << 16;
    let firsts = |row: &[i32; 4]| pair(row[0], row[1]);
    [[firsts(x), x[3], firsts(y), y[3]], [firsts(w), w[3], pair(x[2], y[2]), w[2]], [0; 4], *z]
}

/// The rows that [`packed`] was given.
fn unpacked(
    [[x, x_offset, y, y_offset], [w, w_offset, thirds, third], _, z]: &[[i32; 4]; 4],
) -> [[i32; 4]; 4] {
    let halves = |pair: i32| (pair << 16 >> 16, pair >> 16);
    let (x_third, y_third) = halves(*thirds);
    let row = |pair: i32, third: i32, offset: i32| {
        let (first, second) = halves(pair);
        [first, second, third, offset]
    };
    [row(*x, x_third, *x_offset), row(*y, y_third, *y_offset), row(*w, *third, *w_offset), *z]
}

/// x, y and w in clip space by packed rows: the same as [`transformed`] gives, mantissas having 16
/// bits.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the lower half")]
fn transformed_by_halves<const APART: bool>(
    [xy, wc, ..]: &[[i32; 4]; 4],
    position: &[i16; 3],
) -> [i32; 3] {
    let [p, q, r] = position.map(i32::from);
    let (low, high) = (|pair: i32| i32::from(pair as i16), |pair: i32| pair >> 16);
    let sum = |pair: i32, offset: i32, third: i32| {
        offset
            .wrapping_add(low(pair).wrapping_mul(p))
            .wrapping_add(high(pair).wrapping_mul(q))
            .wrapping_add(third.wrapping_mul(r))
    };
    if APART {
        let [w, w_offset, thirds, third] = *wc;
        let w = sum(w, w_offset, third);
        // Or all is read at once, into registers that are not there.
        forget();
        let [x, x_offset, y, y_offset] = *xy;
        return [sum(x, x_offset, low(thirds)), sum(y, y_offset, high(thirds)), w];
    }
    let [x, x_offset, y, y_offset] = *xy;
    let [w, w_offset, thirds, third] = *wc;
    [sum(x, x_offset, low(thirds)), sum(y, y_offset, high(thirds)), sum(w, w_offset, third)]
}

/// A coordinate in clip space. The translation comes first: where products accumulate, it is what
/// they are added to.
#[inline(always)]
fn transformed([a, b, c, offset]: &[i32; 4], position: &[i16; 3]) -> i32 {
    let [p, q, r] = position.map(i32::from);
    offset
        .wrapping_add(a.wrapping_mul(p))
        .wrapping_add(b.wrapping_mul(q))
        .wrapping_add(c.wrapping_mul(r))
}

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, reason = "halves of words")]
mod tests {
    use super::{packed, transformed, transformed_by_halves, unpacked};
    use crate::math::hard_numbers::Random;

    #[test]
    fn packed_rows_give_what_the_rows_give() {
        let mut random = Random::new(35);
        for round in 0..100_000_u32 {
            // A mantissa has 16 bits, a position too; ends among them.
            let mut half = || match random.word() % 8 {
                0 => i16::MIN,
                1 => i16::MAX,
                _ => (random.word() as i16) >> (round % 15),
            };
            let position = [half(), half(), half()];
            let mut row = || {
                let [a, b, c] = [half(), half(), half()].map(i32::from);
                [a, b, c, i32::from(half()) << 14]
            };
            let rows = [row(), row(), row(), row()];
            let [x, y, w, _] = rows;
            let expected = [x, y, w].map(|row| transformed(&row, &position));
            let packed = packed(&rows);
            assert_eq!(transformed_by_halves::<true>(&packed, &position), expected, "{rows:?}");
            assert_eq!(transformed_by_halves::<false>(&packed, &position), expected, "{rows:?}");
            assert_eq!(unpacked(&packed), rows, "they are what they were");
        }
    }
}
