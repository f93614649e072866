use super::ScreenVertex;
use crate::frame::Rect;

/// The square of a point: its pixels are those whose centres lie in the half-open square
/// `[x - size/2, x + size/2) x [y - size/2, y + size/2)` about the corner as it is, unrounded.
///
/// So a point of `size` whole pixels has as many columns and rows. Those of an odd size lie about
/// the pixel that holds the corner, those of an even one about the pixel corner that is nearest to
/// it; this is also what OpenGL's older rule says, which rounds the corner.
///
/// Source: OpenGL 4.6, section 14.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PointSquare {
    x: i32,
    y: i32,
    /// Sixteenths of a pixel.
    size: u32,
}

impl PointSquare {
    /// No point: of what a line has at its end.
    pub(crate) const NONE: Self = Self { x: 0, y: 0, size: 16 };

    /// The square of `size` sixteenths of a pixel about `corner`.
    #[inline(always)]
    pub(crate) const fn new(corner: &ScreenVertex, size: u32) -> Self {
        Self { x: corner.x_bits(), y: corner.y_bits(), size }
    }

    /// Its pixels, limited to `area`.
    #[inline(always)]
    pub(crate) fn pixels(&self, area: &Rect) -> Rect {
        // Twice a column's centre is not before twice v, less the size.
        let size = self.size.cast_signed();
        let from = |v: i32| v.wrapping_mul(2).wrapping_sub(size).wrapping_add(15) >> 5;
        let to = |v: i32| v.wrapping_mul(2).wrapping_add(size).wrapping_add(15) >> 5;
        Rect {
            left: from(self.x).max(area.left),
            top: from(self.y).max(area.top),
            right: to(self.x).min(area.right),
            bottom: to(self.y).min(area.bottom),
        }
    }

    /// The size in pixels, 28.4.
    #[inline(always)]
    pub const fn size_bits(&self) -> u32 {
        self.size
    }

    /// From the square's upper left corner to the centre of a pixel, in pixels, with 5 fraction
    /// bits.
    #[inline(always)]
    pub const fn offset(&self, x: i32, y: i32) -> (i32, i32) {
        let size = self.size.cast_signed();
        (
            x.wrapping_mul(32)
                .wrapping_add(16)
                .wrapping_sub(self.x.wrapping_mul(2))
                .wrapping_add(size),
            y.wrapping_mul(32)
                .wrapping_add(16)
                .wrapping_sub(self.y.wrapping_mul(2))
                .wrapping_add(size),
        )
    }
}
