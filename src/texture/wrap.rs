use super::axis::{half_texel, Axis};

/// What a texture shows beyond its sides, along one axis.
///
/// [`Repeat`], [`Mirror`] and [`Clamp`] are for sides of a power of two, [`ClampAny`] for any.
pub trait Wrap: Copy {
    /// Whether sides may be other than powers of two.
    const ANY_SIZE: bool;
    /// Whether all that [`place`](Self::place) gives are numbers of texels.
    const ENDLESS: bool;
    /// Whether places are those of turned coordinates, which go on behind the last texel.
    #[doc(hidden)]
    const TURNS: bool = false;

    /// A coordinate (or the way to the next pixel's) turned as this wrap steps it over a run of
    /// pixels: linear modulo 2^32.
    #[inline(always)]
    fn turned(self, _axis: &Axis, at: i32) -> i32 {
        at
    }

    /// The coordinate from which [`place`](Self::place) cuts off, turned: the same way steps it.
    ///
    /// `places` is how many bits of the fraction will be used: 1 to 8.
    #[inline(always)]
    fn before(self, _axis: &Axis, at: i32, _places: u32) -> i32 {
        at
    }

    /// The number of the texel at a turned coordinate.
    fn nearest(self, axis: &Axis, turned: i32) -> u32;

    /// The first of the two texels whose middles lie around a coordinate, which was turned
    /// [before](Self::before) it, and the distance from it in units of 2^-8 texel, rounded to
    /// `places` bits once the others are cut off. Where the second one is not simply the next one
    /// of the picture, the number may be any from the last texel's on.
    fn place(self, axis: &Axis, before: i32, places: u32) -> (u32, u32);

    /// Both of these texels.
    fn pair(self, axis: &Axis, before: i32, places: u32) -> [u32; 2];
}

/// The picture again and again.
///
/// # Cost
/// The cheapest: one shift and one mask.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repeat;

impl Wrap for Repeat {
    const ANY_SIZE: bool = false;
    const ENDLESS: bool = true;
    const TURNS: bool = true;

    #[inline(always)]
    fn turned(self, axis: &Axis, at: i32) -> i32 {
        axis.turned(at)
    }

    #[inline(always)]
    fn before(self, axis: &Axis, at: i32, places: u32) -> i32 {
        axis.turned(axis.before(at, places))
    }

    #[inline(always)]
    fn nearest(self, axis: &Axis, turned: i32) -> u32 {
        axis.repeated(turned)
    }

    #[inline(always)]
    fn place(self, axis: &Axis, before: i32, _places: u32) -> (u32, u32) {
        axis.repeated_place(before)
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, before: i32, _places: u32) -> [u32; 2] {
        let number = axis.repeated(before);
        [number, axis.next(number)]
    }
}

/// The picture again and again, every second time mirrored.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Mirror;

impl Wrap for Mirror {
    const ANY_SIZE: bool = false;
    const ENDLESS: bool = false;

    #[inline(always)]
    fn turned(self, axis: &Axis, at: i32) -> i32 {
        axis.turned_twice(at)
    }

    #[inline(always)]
    fn before(self, axis: &Axis, at: i32, places: u32) -> i32 {
        axis.turned_twice(axis.before(at, places))
    }

    #[inline(always)]
    fn nearest(self, axis: &Axis, turned: i32) -> u32 {
        axis.mirrored(turned)
    }

    #[inline(always)]
    fn place(self, axis: &Axis, before: i32, _places: u32) -> (u32, u32) {
        (axis.mirrored(before) | axis.flip(before), axis.mirrored_fraction(before))
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, before: i32, _places: u32) -> [u32; 2] {
        [axis.mirrored(before), axis.mirrored(axis.mirrored_next(before))]
    }
}

/// The picture once; beyond its sides the texels of its edge go on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Clamp;

impl Wrap for Clamp {
    const ANY_SIZE: bool = false;
    const ENDLESS: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.clamped(axis.number(at))
    }

    #[inline(always)]
    fn place(self, axis: &Axis, at: i32, places: u32) -> (u32, u32) {
        let before = axis.before_saturating(at, places);
        (axis.number(before).cast_unsigned(), axis.fraction(before))
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32, places: u32) -> [u32; 2] {
        let number = axis.number(axis.before_saturating(at, places));
        [axis.clamped(number), axis.clamped(number.wrapping_add(1))]
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

impl ClampAny {
    /// The left one of two texels, which may lie outside, and 8 bits of the way to the other.
    #[inline(always)]
    fn left(axis: &Axis, at: i32, places: u32) -> (i32, u32) {
        let bits = axis.scaled_bits();
        let before = axis.scaled(at).cast_signed().wrapping_sub(half_texel(bits, places));
        (before >> bits, (before.cast_unsigned() << 32u32.wrapping_sub(bits)) >> 24)
    }
}

impl Wrap for ClampAny {
    const ANY_SIZE: bool = true;
    const ENDLESS: bool = false;

    #[inline(always)]
    fn nearest(self, axis: &Axis, at: i32) -> u32 {
        axis.clamped((axis.scaled(at) >> axis.scaled_bits()).cast_signed())
    }

    #[inline(always)]
    fn place(self, axis: &Axis, at: i32, places: u32) -> (u32, u32) {
        let (number, fraction) = Self::left(axis, at, places);
        (number.cast_unsigned(), fraction)
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, at: i32, places: u32) -> [u32; 2] {
        let (number, _) = Self::left(axis, at, places);
        [axis.clamped(number), axis.clamped(number.wrapping_add(1))]
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

/// What the wrap of this name does.
macro_rules! typed {
    ($any:expr, $wrap:ident => $result:expr) => {
        match $any {
            AnyWrap::Repeat => {
                let $wrap = Repeat;
                $result
            }
            AnyWrap::Mirror => {
                let $wrap = Mirror;
                $result
            }
            AnyWrap::Clamp => {
                let $wrap = Clamp;
                $result
            }
        }
    };
}

impl Wrap for AnyWrap {
    const ANY_SIZE: bool = false;
    const ENDLESS: bool = false;

    #[inline(always)]
    fn turned(self, axis: &Axis, at: i32) -> i32 {
        typed!(self, wrap => wrap.turned(axis, at))
    }

    #[inline(always)]
    fn before(self, axis: &Axis, at: i32, places: u32) -> i32 {
        typed!(self, wrap => wrap.before(axis, at, places))
    }

    #[inline(always)]
    fn nearest(self, axis: &Axis, turned: i32) -> u32 {
        typed!(self, wrap => wrap.nearest(axis, turned))
    }

    #[inline(always)]
    fn place(self, axis: &Axis, before: i32, places: u32) -> (u32, u32) {
        typed!(self, wrap => wrap.place(axis, before, places))
    }

    #[inline(always)]
    fn pair(self, axis: &Axis, before: i32, places: u32) -> [u32; 2] {
        typed!(self, wrap => wrap.pair(axis, before, places))
    }
}
