use fixed::types::I8F8;

use super::{AnyDepth, DepthTest};
use crate::frame::ReadWrite;

/// What wrappers hand on to the test that they hold.
macro_rules! hand_on {
    ($($method:ident($($argument:ident: $type:ty),*) -> $result:ty;)*) => {
        $(
            #[inline(always)]
            fn $method(&self $(, $argument: $type)*) -> $result {
                self.test.$method($($argument),*)
            }
        )*
    };
}

/// A test that leaves depth as it is.
///
/// # Measured
/// <!-- tradeoff: fill/depth=read-only -->
/// `read-only` in the scene `fill`: 15.9 (M4F), 27.8 (M0+), 18.2 (RV32) instructions a pixel; PSNR 40.8 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ReadOnly<D> {
    test: D,
}

impl<D> ReadOnly<D> {
    /// The same test, without writing.
    pub const fn new(test: D) -> Self {
        Self { test }
    }
}

impl<D: DepthTest<Access = ReadWrite>> DepthTest for ReadOnly<D> {
    type Access = ReadWrite;
    const OFFSETS: bool = D::OFFSETS;

    hand_on! {
        passes(new: u16, stored: u16) -> bool;
        is_constant() -> bool;
        maps() -> bool;
        map(code: u16) -> u16;
        offset(dx: i32, dy: i32) -> i64;
    }

    #[inline(always)]
    fn writes(&self) -> bool {
        false
    }
}

/// A test with one depth a triangle or line: the mean of its corners' codes. The cheapest: no
/// planes.
///
/// # Rounding
/// Down to a code.
///
/// # Measured
/// <!-- tradeoff: fill/depth=constant -->
/// `constant` in the scene `fill`: 18.9 (M4F), 28.8 (M0+), 19.2 (RV32) instructions a pixel; PSNR 40.8 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ConstantDepth<D> {
    test: D,
}

impl<D> ConstantDepth<D> {
    /// The same test, by the mean of a triangle's corners.
    pub const fn new(test: D) -> Self {
        Self { test }
    }
}

impl<D: DepthTest<Access = ReadWrite>> DepthTest for ConstantDepth<D> {
    type Access = ReadWrite;
    const OFFSETS: bool = D::OFFSETS;

    hand_on! {
        passes(new: u16, stored: u16) -> bool;
        writes() -> bool;
        maps() -> bool;
        map(code: u16) -> u16;
        offset(dx: i32, dy: i32) -> i64;
    }

    #[inline(always)]
    fn is_constant(&self) -> bool {
        true
    }
}

/// A test of triangles that are moved away by `slope` times their steepest change of depth from
/// one pixel to the next, and `units` depth codes (polygon offset); towards the viewer where that
/// is negative. Lines and points are not moved.
///
/// # Range
/// No corner is moved out of the range of codes: a triangle that would be moves less. Depth may
/// change by up to 32767 codes from pixel to pixel; slivers beyond move by any part of what they
/// should.
///
/// Source: OpenGL 4.6, section 14.6.5, with the larger of both slopes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PolygonOffset<D> {
    test: D,
    slope: I8F8,
    units: i16,
}

impl<D> PolygonOffset<D> {
    /// The same test, of triangles so moved.
    pub const fn new(test: D, slope: I8F8, units: i16) -> Self {
        Self { test, slope, units }
    }
}

/// By how much such an offset moves a triangle away, as 16.16 codes.
#[inline(always)]
fn moved(slope: I8F8, units: i16, dx: i32, dy: i32) -> i64 {
    let steepest = i64::from(dx.unsigned_abs().max(dy.unsigned_abs()));
    (steepest.wrapping_mul(slope.to_bits().into()) >> 8).wrapping_add(i64::from(units) << 16)
}

impl<D: DepthTest<Access = ReadWrite>> DepthTest for PolygonOffset<D> {
    type Access = ReadWrite;
    const OFFSETS: bool = true;

    hand_on! {
        passes(new: u16, stored: u16) -> bool;
        writes() -> bool;
        is_constant() -> bool;
        maps() -> bool;
        map(code: u16) -> u16;
    }

    #[inline(always)]
    fn offset(&self, dx: i32, dy: i32) -> i64 {
        moved(self.slope, self.units, dx, dy).wrapping_add(self.test.offset(dx, dy))
    }
}

/// A test whose codes lie between two ends: what is farthest has the one, what is nearest the
/// other. The second may be the smaller.
///
/// # Rounding
/// Corners' codes to nearest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DepthRange<D> {
    test: D,
    farthest: u16,
    nearest: u16,
}

impl<D> DepthRange<D> {
    /// The same test, with codes from `farthest` (where they would be 0) to `nearest` (65535).
    pub const fn new(test: D, farthest: u16, nearest: u16) -> Self {
        Self { test, farthest, nearest }
    }
}

/// A code of 0 to 65535 as one between two ends.
#[inline]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a value between two codes"
)]
fn between(farthest: u16, nearest: u16, code: u16) -> u16 {
    let range = i64::from(nearest).wrapping_sub(farthest.into());
    // Rounded division by 65535 of what is at most 2^32 in magnitude.
    let product = range.wrapping_mul(code.into());
    let way = product.wrapping_mul(0x1_0001).wrapping_add(1 << 31) >> 32;
    i64::from(farthest).wrapping_add(way) as u16
}

impl<D: DepthTest<Access = ReadWrite>> DepthTest for DepthRange<D> {
    type Access = ReadWrite;
    const OFFSETS: bool = D::OFFSETS;

    hand_on! {
        passes(new: u16, stored: u16) -> bool;
        writes() -> bool;
        is_constant() -> bool;
        offset(dx: i32, dy: i32) -> i64;
    }

    #[inline(always)]
    fn maps(&self) -> bool {
        true
    }

    #[inline(always)]
    fn map(&self, code: u16) -> u16 {
        between(self.farthest, self.nearest, self.test.map(code))
    }
}

/// A depth test with all that the wrappers do, chosen when the program runs: for host tools.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnyDepthState {
    /// The test.
    pub test: AnyDepth,
    /// As [`ReadOnly`].
    pub read_only: bool,
    /// As [`ConstantDepth`].
    pub constant: bool,
    /// As [`PolygonOffset`]: slope and units.
    pub offset: (I8F8, i16),
    /// As [`DepthRange`]: the farthest and the nearest code.
    pub range: (u16, u16),
}

impl AnyDepthState {
    /// The test alone.
    pub const fn new(test: AnyDepth) -> Self {
        let offset = (I8F8::ZERO, 0);
        Self { test, read_only: false, constant: false, offset, range: (0, u16::MAX) }
    }
}

impl DepthTest for AnyDepthState {
    type Access = ReadWrite;
    const OFFSETS: bool = true;

    fn passes(&self, new: u16, stored: u16) -> bool {
        self.test.passes(new, stored)
    }

    fn writes(&self) -> bool {
        self.test.writes() && !self.read_only
    }

    fn is_constant(&self) -> bool {
        self.constant
    }

    fn maps(&self) -> bool {
        true
    }

    fn map(&self, code: u16) -> u16 {
        between(self.range.0, self.range.1, code)
    }

    fn offset(&self, dx: i32, dy: i32) -> i64 {
        moved(self.offset.0, self.offset.1, dx, dy)
    }
}
