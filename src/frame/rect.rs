use super::Size;

/// A rectangle of pixels, half-open: `left <= x < right`, `top <= y < bottom`.
///
/// Coordinates are the picture's: y points down, row 0 is on top. A rectangle whose right is not
/// beyond its left is empty.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rect {
    /// First column.
    pub left: i32,
    /// First row.
    pub top: i32,
    /// First column behind.
    pub right: i32,
    /// First row behind.
    pub bottom: i32,
}

impl Rect {
    /// A rectangle from its four sides.
    pub const fn new(left: i32, top: i32, right: i32, bottom: i32) -> Self {
        Self { left, top, right, bottom }
    }

    /// The rectangle of this size whose corner is at (0, 0).
    pub const fn from_size(size: Size) -> Self {
        Self::new(0, 0, size.width as i32, size.height as i32)
    }

    /// What both rectangles cover; empty where they do not meet.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        Self {
            left: self.left.max(other.left),
            top: self.top.max(other.top),
            right: self.right.min(other.right),
            bottom: self.bottom.min(other.bottom),
        }
    }

    /// The smallest rectangle that holds both; an empty one adds nothing.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        if other.is_empty() {
            return self;
        }
        if self.is_empty() {
            return other;
        }
        Self {
            left: self.left.min(other.left),
            top: self.top.min(other.top),
            right: self.right.max(other.right),
            bottom: self.bottom.max(other.bottom),
        }
    }

    /// Whether no pixel lies inside.
    pub const fn is_empty(self) -> bool {
        self.left >= self.right || self.top >= self.bottom
    }

    /// Whether the pixel lies inside.
    pub const fn contains(self, x: i32, y: i32) -> bool {
        x >= self.left && x < self.right && y >= self.top && y < self.bottom
    }

    /// Columns, 0 when empty.
    pub const fn width(self) -> u32 {
        if self.is_empty() {
            0
        } else {
            self.right.abs_diff(self.left)
        }
    }

    /// Rows, 0 when empty.
    pub const fn height(self) -> u32 {
        if self.is_empty() {
            0
        } else {
            self.bottom.abs_diff(self.top)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_that_do_not_meet_share_nothing() {
        let shared = Rect::new(0, 0, 4, 4).intersection(Rect::new(6, 6, 9, 9));
        assert!(shared.is_empty(), "{shared:?}");
        assert_eq!((shared.width(), shared.height()), (0, 0), "no pixels");
    }

    #[test]
    fn sides_as_long_as_numbers_reach_are_counted() {
        let all = Rect::new(i32::MIN, -1, i32::MAX, i32::MAX);
        assert_eq!((all.width(), all.height()), (u32::MAX, 1 << 31), "{all:?}");
        let turned = Rect::new(i32::MAX, 0, i32::MIN, 1);
        assert_eq!((turned.width(), turned.height()), (0, 0), "{turned:?}");
    }

    #[test]
    fn right_and_bottom_are_outside() {
        let rect = Rect::new(1, 1, 3, 3);
        assert!(rect.contains(1, 1) && rect.contains(2, 2), "inside");
        assert!(!rect.contains(3, 2) && !rect.contains(2, 3), "outside");
    }
}
