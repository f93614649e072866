/// An attribute over the screen: a plane in wrapping 32-bit arithmetic.
///
/// `value(x, y) = origin + dx x + dy y` modulo 2^32, at pixel centres. A covered centre lies inside
/// the triangle, so that its true value is in range; the wrapped sum is that value even where a
/// sliver's slopes overflow, and does not depend on where a span, a scissor or a band begins.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Plane {
    /// The value at the centre of pixel (0, 0).
    pub origin: u32,
    /// The step to the next column.
    pub dx: u32,
    /// The step to the next row.
    pub dy: u32,
}

impl Plane {
    /// The value at the centre of pixel (x, y).
    #[inline(always)]
    pub fn at(&self, x: i32, y: i32) -> u32 {
        self.origin
            .wrapping_add(self.dx.wrapping_mul(x as u32))
            .wrapping_add(self.dy.wrapping_mul(y as u32))
    }
}
