use super::Clip;
use crate::math::Mat4;

/// What limits the view in depth, and what depth is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Depth {
    /// z' is the near distance everywhere: depth comes from w alone.
    Near {
        /// The smallest w in view, the near distance less the rounding of the matrix.
        w_min: i32,
        /// 65531 x near = numerator 2^-shift, normalised to 2^30..2^31.
        numerator: u32,
        shift: i32,
    },
    /// z' is a row of the matrix.
    Row {
        /// Whether z' < 0 is beyond a far plane.
        far: bool,
    },
}

/// The matrix from 16-bit positions to clip space, in block-float: sixteen-bit mantissas and
/// 32-bit translations of one common exponent.
///
/// # Rounding
/// Mantissas are rounded to 2^-15 of the largest clip coordinate that the mesh's box can reach: at
/// most 1/64 pixel on a 320-pixel screen for what is as far away as that.
///
/// # Cost
/// 32 instructions a vertex on Cortex-M4, 51 on M0+.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Transform {
    rows: [[i16; 3]; 3],
    offsets: [i32; 3],
    z_row: [i16; 3],
    z_offset: i32,
    pub(crate) depth: Depth,
}

const _: () = assert!(Clip::LIMIT == 1 << (29 + 1), "matrices are scaled to reach below 2^30");

/// 2^exponent, for exponents of normal floats.
fn power_of_two(exponent: i32) -> Option<f32> {
    let biased = u32::try_from(exponent.checked_add(127)?).ok()?;
    (1..=254).contains(&biased).then(|| f32::from_bits(biased << 23))
}

/// The exponent of a float: 1 <= v / 2^exponent < 2. `None` for zero, subnormals and what is not
/// finite.
#[allow(
    clippy::cast_possible_wrap,
    reason = "a float cast saturates; the scale keeps mantissas in 16 bits"
)]
fn exponent(v: f32) -> Option<i32> {
    let biased = (v.to_bits() >> 23) & 0xFF;
    (1..=254).contains(&biased).then(|| biased as i32 - 127)
}

/// The nearest integer; saturates.
#[allow(
    clippy::cast_possible_truncation,
    reason = "a float cast saturates; the scale keeps mantissas in 16 bits"
)]
fn round(v: f32) -> i32 {
    (v + if v < 0.0 { -0.5 } else { 0.5 }) as i32
}

/// The larger of `largest` and of what a row can reach; what is no number is kept, and refused by
/// [`exponent`].
#[inline(never)]
fn reach(row: &[f32; 4], largest: f32) -> f32 {
    let [a, b, c, d] = row.map(|v| f32::from_bits(v.to_bits() & 0x7FFF_FFFF));
    let reach = (a + b + c) * 32768.0 + d;
    if largest >= reach || largest.is_nan() {
        largest
    } else {
        reach
    }
}

/// A row as sixteen-bit mantissas and its translation.
#[inline(never)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "a float cast saturates; the scale keeps mantissas in 16 bits"
)]
fn integers(row: &[f32; 4], scale: f32) -> ([i16; 3], i32) {
    let [a, b, c, d] = row.map(|v| round(v * scale));
    ([a as i16, b as i16, c as i16], d)
}

impl Transform {
    /// The transform of a matrix from positions (-32768..=32767 by axis) to clip space.
    ///
    /// `near` is given where clip z is that constant; `far` says whether z' < 0 is cut off
    /// otherwise. `None` for a matrix that is not finite, or all zero.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "a float cast saturates; the scale keeps mantissas in 16 bits"
    )]
    pub(crate) fn new(matrix: &Mat4, near: Option<f32>, far: bool) -> Option<Self> {
        let [x, y, z, w] = matrix.transpose().to_columns();
        // The largest coordinate that any position can reach, with room for rounding.
        let mut largest = reach(&x, reach(&y, reach(&w, 0.0)));
        if near.is_none() {
            largest = reach(&z, largest);
        }
        let scale = power_of_two(29 - exponent(largest * 1.0002)?)?;
        let depth = match near {
            None => Depth::Row { far },
            Some(near) => {
                let near = near * scale;
                if near.is_nan() || near <= 0.0 {
                    return None;
                }
                let exponent = exponent(near * 65531.0)?;
                let numerator = near * 65531.0 * power_of_two(30 - exponent)?;
                // Mantissas may be half a unit off, at positions of up to 32768.
                let rounding = (near * (1.0 / 64.0)).min(3.0 * 16384.0 + 1.0);
                Depth::Near {
                    w_min: ((near - rounding) as i32).max(1),
                    numerator: numerator as u32,
                    shift: 30 - exponent,
                }
            }
        };
        let mut transform = Self { depth, ..Self::identity(far) };
        for (row, (scaled, offset)) in
            [x, y, w].iter().zip(transform.rows.iter_mut().zip(&mut transform.offsets))
        {
            (*scaled, *offset) = integers(row, scale);
        }
        (transform.z_row, transform.z_offset) = integers(&z, scale);
        Some(transform)
    }

    /// A transform for positions that come in clip space already: depth is made of their z.
    pub(crate) fn identity(far: bool) -> Self {
        Self {
            rows: [[0; 3]; 3],
            offsets: [0; 3],
            z_row: [0; 3],
            z_offset: 0,
            depth: Depth::Row { far },
        }
    }

    /// The clip coordinates of a position; z only where depth is made of it.
    #[inline(always)]
    pub(crate) fn apply(&self, position: &[i16; 3]) -> Clip {
        let [p, q, r] = position.map(i32::from);
        let dot = |[a, b, c]: &[i16; 3], offset: i32| {
            i32::from(*a)
                .wrapping_mul(p)
                .wrapping_add(i32::from(*b).wrapping_mul(q))
                .wrapping_add(i32::from(*c).wrapping_mul(r))
                .wrapping_add(offset)
        };
        let [x, y, w] = &self.rows;
        let [ox, oy, ow] = self.offsets;
        let z = match self.depth {
            Depth::Near { .. } => 0,
            Depth::Row { .. } => dot(&self.z_row, self.z_offset),
        };
        Clip { x: dot(x, ox), y: dot(y, oy), z, w: dot(w, ow) }
    }
}
