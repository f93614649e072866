use fixed::types::I28F4;

use crate::frame::Size;

/// Steps of a pixel that coordinates resolve: 28.4 fixed point.
pub const SUBPIXELS: i32 = 16;

/// Half the side of the square in which corners must lie, in pixels, measured from the centre of
/// the picture (from the centre of the viewport when a pass draws).
pub const GUARD: i32 = 4096;

// An edge value is at most the product of the square's two sides in subpixels, over 16, and must
// leave the sign bit of an i32 alone.
const _: () = assert!(SUBPIXELS as i64 * (2 * GUARD as i64).pow(2) <= 1 << 30, "edge values");

/// A corner on the screen: what the rasterizer takes.
///
/// # Range
/// `x` and `y` within 4096 pixels of the picture's centre; what lies outside is skipped at this
/// level (a [`Pass`](crate::Pass) clips instead). `z` is a depth code: larger is nearer.
///
/// ```
/// use microraster::raster::ScreenVertex;
///
/// // The centre of pixel (3, 2), half as far as depth reaches.
/// let vertex = ScreenVertex::from_bits(3 * 16 + 8, 2 * 16 + 8, 0x8000);
/// assert_eq!(vertex.x.to_num::<f32>(), 3.5);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ScreenVertex {
    /// Columns from the left side of the picture.
    pub x: I28F4,
    /// Rows from the top of the picture.
    pub y: I28F4,
    /// Depth code: 0 is farthest, 65535 nearest.
    pub z: u16,
}

impl ScreenVertex {
    /// A corner from fixed-point coordinates in pixels.
    pub const fn new(x: I28F4, y: I28F4, z: u16) -> Self {
        Self { x, y, z }
    }

    /// A corner from coordinates counted in sixteenths of a pixel.
    pub const fn from_bits(x: i32, y: i32, z: u16) -> Self {
        Self { x: I28F4::from_bits(x), y: I28F4::from_bits(y), z }
    }

    /// x in sixteenths of a pixel.
    #[inline(always)]
    pub const fn x_bits(&self) -> i32 {
        self.x.to_bits()
    }

    /// y in sixteenths of a pixel.
    #[inline(always)]
    pub const fn y_bits(&self) -> i32 {
        self.y.to_bits()
    }

    /// Whether the corner lies in the square of [`GUARD`] about the centre of `picture`.
    #[allow(clippy::cast_possible_wrap, reason = "a constant below 2^18")]
    pub fn in_range(&self, picture: Size) -> bool {
        let side = (GUARD * SUBPIXELS) as u32;
        let near = |bits: i32, length: u16| {
            let center = i32::from(length) * SUBPIXELS / 2;
            bits.wrapping_sub(center).wrapping_add(side as i32) as u32 <= 2 * side
        };
        near(self.x_bits(), picture.width) && near(self.y_bits(), picture.height)
    }
}

/// Where a corner is, in subpixels.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Point {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl Point {
    /// The place of a corner.
    #[inline(always)]
    pub(crate) const fn of(vertex: &ScreenVertex) -> Self {
        Self { x: vertex.x_bits(), y: vertex.y_bits() }
    }
}
