use crate::raster::{GUARD, SUBPIXELS};

/// What is known of a vertex, as bits of [`Projected::flags`]; a triangle whose corners share one of
/// [`OUTSIDE`](flag::OUTSIDE) is not seen.
pub(crate) mod flag {
    /// No flag but a mark of the cache: its attributes are made too.
    pub(crate) const SHADED: u32 = 1 << 16;
    pub(crate) const LEFT: u32 = 1 << 17;
    pub(crate) const RIGHT: u32 = 1 << 18;
    pub(crate) const ABOVE: u32 = 1 << 19;
    pub(crate) const BELOW: u32 = 1 << 20;
    /// In front of the near plane, or behind the eye: not projected.
    pub(crate) const NEAR: u32 = 1 << 21;
    /// Beyond the far plane.
    pub(crate) const FAR: u32 = 1 << 22;
    /// Beyond what 12.4 holds: its triangles are clipped at the guard box.
    pub(crate) const RANGE: u32 = 1 << 23;
    /// Of a viewport so large that areas in it may need more than 32 bits.
    pub(crate) const LARGE: u32 = 1 << 24;
    /// Not there, or no number.
    pub(crate) const INVALID: u32 = 1 << 25;
    /// Set with any of those above but the cache's mark: a sign to ask for. A vertex in a view of
    /// ordinary size does not have it.
    pub(crate) const ANY: u32 = 1 << 31;

    /// Triangles all of whose corners have one of these are not seen.
    pub(crate) const OUTSIDE: u32 = LEFT | RIGHT | ABOVE | BELOW | NEAR | FAR;
    /// Triangles any of whose corners has one of these are clipped.
    pub(crate) const CLIP: u32 = NEAR | FAR | RANGE;
}

const _: () = assert!(i16::MAX as i32 <= GUARD * SUBPIXELS, "what 12.4 holds needs no clipping");

/// By how much raised coordinates are above those that they stand for, so that none is below zero.
pub(super) const RAISED: i32 = 1 << 15;

/// A vertex on the screen: the one value from which every path draws.
///
/// Coordinates are 12.4 fixed point from the centre of the viewport, y down. Two words, which load
/// and store as a pair.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Projected {
    /// x below y.
    pub(super) xy: u32,
    /// The depth code, and above it flags.
    pub(super) z_flags: u32,
}

impl Projected {
    /// A vertex that does not exist.
    pub(crate) const INVALID: Self = Self { xy: 0, z_flags: flag::INVALID | flag::ANY };

    /// A vertex at a place that 12.4 holds; what it does not hold is cut off.
    #[inline(always)]
    pub(crate) const fn new(x: i32, y: i32, z: u16, flags: u32) -> Self {
        let any = if flags == 0 { 0 } else { flag::ANY };
        Self { z_flags: z as u32 | flags | any, ..Self::in_view(x, y, 0) }
    }

    /// A vertex in the view, whose depth code has 16 bits.
    #[inline(always)]
    pub(super) const fn in_view(x: i32, y: i32, z: u32) -> Self {
        let xy = x.cast_unsigned() & 0xFFFF | y.cast_unsigned() << 16;
        Self { xy, z_flags: z }
    }

    /// Subpixels from the viewport's centre to the right.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    pub(crate) const fn x(self) -> i32 {
        (self.xy as u16).cast_signed() as i32
    }

    /// Subpixels from the viewport's centre down.
    #[inline(always)]
    pub(crate) const fn y(self) -> i32 {
        self.xy.cast_signed() >> 16
    }

    /// Both coordinates, [`RAISED`] above what they are.
    #[inline(always)]
    pub(crate) const fn raised(self) -> (i32, i32) {
        let x = self.xy.wrapping_add(RAISED.cast_unsigned()) & 0xFFFF;
        let y = (self.xy ^ RAISED.cast_unsigned() << 16) >> 16;
        (x.cast_signed(), y.cast_signed())
    }

    /// The depth code.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the lower half")]
    pub(crate) const fn z(self) -> u16 {
        self.z_flags as u16
    }

    /// Flags, and bits that are none.
    #[inline(always)]
    pub(crate) const fn flags(self) -> u32 {
        self.z_flags
    }
}
