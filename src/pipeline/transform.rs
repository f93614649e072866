use super::facing::facing;
use super::mapping::Mapping;
use super::{Clip, CulledWindings};
use crate::math::{rolled, sum_of_products, whole, Mat4, Vec3, Vec4};
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
    /// Three mantissas and the translation, of x, y, z and w; z's are 0 where depth comes from w.
    /// In words, which load in pairs.
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
        let [to_x, to_y, to_z, to_w] = &mut rows;
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
        let [x, y, w] = self.sides(position);
        Clip { x, y, z: self.z(position), w }
    }

    /// x, y and w of the same, in place.
    #[inline(always)]
    pub(super) fn sides(&self, position: &[i16; 3]) -> [i32; 3] {
        let [x, y, _, w] = &self.rows;
        [x, y, w].map(|row| transformed(row, position))
    }

    #[cfg(test)]
    pub(super) fn rows(&self) -> &[[i32; 4]; 4] {
        &self.rows
    }

    /// From where planes of triangles are seen through this.
    pub(super) fn facing(
        &self,
        mapping: &Mapping,
        culled: CulledWindings,
        scale: &PlaneScale,
    ) -> Facing {
        let [x, y, z, w] = &self.rows;
        facing([x, y, w], self.has_z.then_some(z), mapping, culled, scale)
    }

    /// z of the same.
    #[inline(never)]
    pub(super) fn z(&self, position: &[i16; 3]) -> i32 {
        let [_, _, z, _] = &self.rows;
        if self.has_z {
            transformed(z, position)
        } else {
            0
        }
    }
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
