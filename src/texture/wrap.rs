use super::axis::{half_texel, Axis};

/// What a texture shows beyond its sides, along one axis.
///
/// [`Repeat`], [`Mirror`] and [`Clamp`] are for sides of a power of two, [`ClampAny`] for any.
pub trait Wrap: Copy {
    /// Whether sides may be other than powers of two.
    const ANY_SIZE: bool;

    /// The texel at `at`: its part of the texel's index, that is, its number times the stride.
    fn nearest(self, axis: &Axis, at: i32) -> u32;

    /// The two texels whose middles lie around `at`, as parts of indices, and the distance from the
    /// first one in units of 2^-8 texel, rounded to nearest.
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32);
}

/// The picture again and again.
///
/// # Cost
/// The cheapest: one shift and one mask.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repeat;

impl Wrap for Repeat {
    const ANY_SIZE: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.repeated(at)
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32) {
        let before = axis.before(at);
        (axis.repeated_pair(before), axis.fraction(before))
    }
}

/// The picture again and again, every second time mirrored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mirror;

impl Wrap for Mirror {
    const ANY_SIZE: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.mirrored(at)
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32) {
        let before = axis.before(at);
        (axis.mirrored_pair(before), axis.fraction(before))
    }
}

/// The picture once; beyond its sides the texels of its edge go on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clamp;

impl Wrap for Clamp {
    const ANY_SIZE: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.clamped(axis.number(at))
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32) {
        let before = axis.before_saturating(at);
        let number = axis.number(before);
        let pair = [axis.clamped(number), axis.clamped(number.wrapping_add(1))];
        (pair, axis.fraction(before))
    }
}

/// As [`Clamp`], for sides of any length.
///
/// # Rounding
/// The nearest texel is exact. Between two texels the place is cut off to 2^-(k+4) of a texel, k
/// being the sampler's unit bits.
///
/// # Cost
/// Two multiplications more.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ClampAny;

impl Wrap for ClampAny {
    const ANY_SIZE: bool = true;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.clamped((axis.scaled(at) >> axis.scaled_bits()).cast_signed())
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32) {
        let bits = axis.scaled_bits();
        let before = axis.scaled(at).cast_signed().wrapping_sub(half_texel(bits));
        let number = before >> bits;
        let fraction = (before.cast_unsigned() << 32u32.wrapping_sub(bits)) >> 24;
        ([axis.clamped(number), axis.clamped(number.wrapping_add(1))], fraction)
    }
}

/// Any wrap of sides of a power of two, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyWrap {
    /// As [`Repeat`](struct@Repeat).
    Repeat,
    /// As [`Mirror`](struct@Mirror).
    Mirror,
    /// As [`Clamp`](struct@Clamp).
    Clamp,
}

impl Wrap for AnyWrap {
    const ANY_SIZE: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        match self {
            Self::Repeat => Repeat.nearest(axis, at),
            Self::Mirror => Mirror.nearest(axis, at),
            Self::Clamp => Clamp.nearest(axis, at),
        }
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32) -> ([u32; 2], u32) {
        match self {
            Self::Repeat => Repeat.pair(axis, at),
            Self::Mirror => Mirror.pair(axis, at),
            Self::Clamp => Clamp.pair(axis, at),
        }
    }
}
