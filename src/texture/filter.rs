use super::{Axis, TexelFormat, Texture, Weights, Wrap};
use crate::color::Color;

/// What a texture shows between the middles of its texels.
pub trait Filter: Copy {
    /// The colour at (`u`, `v`) of `texture`; `None` beyond its data, which checked sizes rule out.
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        u: i32,
        v: i32,
    ) -> Option<Color>;
}

/// The texel in which the point lies.
///
/// # Rounding
/// Exact: texel floor(u x width) of row floor(v x height).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nearest;

impl Filter for Nearest {
    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        (across, down): (U, V),
        [u_axis, v_axis]: &[Axis; 2],
        u: i32,
        v: i32,
    ) -> Option<Color> {
        let index = down.nearest(v_axis, v).wrapping_add(across.nearest(u_axis, u));
        texture.texel(index).map(T::decode)
    }
}

/// Mixed from the four texels whose middles lie around the point.
///
/// # Rounding
/// Places are rounded to 2^-8 of a texel; the formats say how they mix.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bilinear;

impl Filter for Bilinear {
    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        (across, down): (U, V),
        [u_axis, v_axis]: &[Axis; 2],
        u: i32,
        v: i32,
    ) -> Option<Color> {
        let ([left, right], x) = across.pair(u_axis, u);
        let ([upper, lower], y) = down.pair(v_axis, v);
        let texel = |row: u32, column: u32| texture.texel(row.wrapping_add(column));
        let (a, b) = (texel(upper, left)?, texel(upper, right)?);
        let (c, d) = (texel(lower, left)?, texel(lower, right)?);
        Some(T::mix([a, b, c, d], Weights::new(x, y)))
    }
}

/// Any filter, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyFilter {
    /// As [`Nearest`](struct@Nearest).
    Nearest,
    /// As [`Bilinear`](struct@Bilinear).
    Bilinear,
}

impl Filter for AnyFilter {
    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        u: i32,
        v: i32,
    ) -> Option<Color> {
        match self {
            Self::Nearest => Nearest.sample(texture, wraps, axes, u, v),
            Self::Bilinear => Bilinear.sample(texture, wraps, axes, u, v),
        }
    }
}
