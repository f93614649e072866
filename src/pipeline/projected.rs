use crate::raster::{GUARD, SUBPIXELS};

/// Where a vertex lies beside the view, as bits; a triangle whose corners share one is not seen.
pub(crate) mod flag {
    pub(crate) const LEFT: u16 = 1 << 0;
    pub(crate) const RIGHT: u16 = 1 << 1;
    pub(crate) const ABOVE: u16 = 1 << 2;
    pub(crate) const BELOW: u16 = 1 << 3;
    /// In front of the near plane, or behind the eye: not projected.
    pub(crate) const NEAR: u16 = 1 << 4;
    /// Beyond the far plane.
    pub(crate) const FAR: u16 = 1 << 5;
    /// Beyond what 12.4 holds: its triangles are clipped at the guard box.
    pub(crate) const RANGE: u16 = 1 << 6;
    /// Not there, or no number.
    pub(crate) const INVALID: u16 = 1 << 7;

    /// Triangles all of whose corners have one of these are not seen.
    pub(crate) const OUTSIDE: u16 = LEFT | RIGHT | ABOVE | BELOW | NEAR | FAR;
    /// Triangles any of whose corners has one of these are clipped.
    pub(crate) const CLIP: u16 = NEAR | FAR | RANGE;
}

const _: () = assert!(i16::MAX as i32 <= GUARD * SUBPIXELS, "what 12.4 holds needs no clipping");

/// A vertex on the screen: the one value from which every path draws.
///
/// Coordinates are 12.4 fixed point from the centre of the viewport, y down.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Projected {
    pub(crate) x: i16,
    pub(crate) y: i16,
    pub(crate) z: u16,
    pub(crate) flags: u16,
}

impl Projected {
    /// A vertex that does not exist.
    pub(crate) const INVALID: Self = Self { x: 0, y: 0, z: 0, flags: flag::INVALID };
}
