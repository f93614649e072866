/// A corner of a varying in perspective: its value, and the w of its position.
///
/// A shader makes one of its value (by `into()`), and the pass fills in the w; for a
/// [`ScreenPass`](crate::ScreenPass) both are the caller's.
///
/// # Range
/// w from 1 to 2^30; all corners of a triangle in one unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PerspectiveCorner<C> {
    pub(super) w: i32,
    pub(super) value: C,
}

impl<C> PerspectiveCorner<C> {
    /// A corner from its value and w, which counts as 1 if it is less.
    pub const fn new(value: C, w: i32) -> Self {
        Self { w, value }
    }

    /// The value.
    pub const fn value(&self) -> &C {
        &self.value
    }
}

impl<C> From<C> for PerspectiveCorner<C> {
    #[inline(always)]
    fn from(value: C) -> Self {
        Self { w: 1, value }
    }
}
