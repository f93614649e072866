//! Matrices of the camera: where it stands, what its lens does, where the picture lies.

use super::{Angle, Mat4, Vec3, Vec4};

impl Mat4 {
    /// From world to view space: the eye in the origin, looking along -z, x to the right, y up.
    ///
    /// # Range
    ///
    /// If `target` is where the eye is, the view is along the world's -z. If `up` has no direction
    /// or is parallel to the view, some other vector takes its place.
    #[must_use]
    pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Self {
        let backward = match (eye - target).normalize() {
            Vec3::ZERO => Vec3::Z,
            unit => unit,
        };
        let right = match up.normalize().cross(backward).normalize() {
            Vec3::ZERO => backward.any_perpendicular(),
            unit => unit,
        };
        let up = backward.cross(right);
        Self::from_rows(
            right.extend(-right.dot(eye)),
            up.extend(-up.dot(eye)),
            backward.extend(-backward.dot(eye)),
            Vec4::W,
        )
    }

    /// From view to clip space through a lens: `field_of_view` from the lower to the upper edge of
    /// the picture, `aspect` its width over its height, `near` and `far` distances.
    ///
    /// Clip w is the distance along the view, and depth z / w is **reversed**: 1 on the near plane
    /// and 0 on the far plane or, without one, at infinity. Then clip z is simply `near`.
    ///
    /// # Range
    ///
    /// 0 < `near` < `far`, 0 < `aspect`, and less than half a turn; what else comes in makes a
    /// matrix that projects nothing sensible, perhaps of infinities or NaN.
    ///
    /// ```
    /// use microraster::math::{AngleUnits, Mat4, Vec4};
    ///
    /// let lens = Mat4::perspective(90.0.degrees(), 2.0, 0.5, None);
    /// assert_eq!((lens * Vec4::new(0.0, 0.0, -0.5, 1.0)).project().z, 1.0);
    /// assert_eq!((lens * Vec4::new(0.0, 0.0, -8.0, 1.0)).w, 8.0);
    /// ```
    #[must_use]
    pub fn perspective(field_of_view: Angle, aspect: f32, near: f32, far: Option<f32>) -> Self {
        let height = (field_of_view * 0.5).tan();
        Self::lens(
            Vec4::new(1.0 / (height * aspect), 0.0, 0.0, 0.0),
            Vec4::new(0.0, 1.0 / height, 0.0, 0.0),
            near,
            far,
        )
    }

    /// From view to clip space through the window from (`left`, `bottom`) to (`right`, `top`) in
    /// the near plane, which may be off the axis. Depth is that of [`perspective`](Self::perspective).
    ///
    /// # Range
    ///
    /// 0 < `near` < `far`, and a window that is not empty.
    #[must_use]
    pub fn frustum(
        left: f32,
        right: f32,
        bottom: f32,
        top: f32,
        near: f32,
        far: Option<f32>,
    ) -> Self {
        let (width, height) = (right - left, top - bottom);
        Self::lens(
            Vec4::new(2.0 * near / width, 0.0, (right + left) / width, 0.0),
            Vec4::new(0.0, 2.0 * near / height, (top + bottom) / height, 0.0),
            near,
            far,
        )
    }

    /// From view to clip space without perspective: the box from (`left`, `bottom`) to
    /// (`right`, `top`), between the distances `near` and `far`.
    ///
    /// Clip w is 1. Depth falls linearly from 1 at `near` to 0 at `far`.
    ///
    /// # Range
    ///
    /// A box that is not empty; `near` may be 0 or behind the eye.
    #[must_use]
    pub fn orthographic(left: f32, right: f32, bottom: f32, top: f32, near: f32, far: f32) -> Self {
        let (width, height, length) = (right - left, top - bottom, far - near);
        Self::from_rows(
            Vec4::new(2.0 / width, 0.0, 0.0, -(right + left) / width),
            Vec4::new(0.0, 2.0 / height, 0.0, -(top + bottom) / height),
            Vec4::new(0.0, 0.0, 1.0 / length, far / length),
            Vec4::W,
        )
    }

    /// From the square [-1, 1] of projected coordinates to pixels: (-1, 1) goes to the upper left
    /// corner (`x`, `y`), y runs down, and the middle of the first pixel is half a pixel from the
    /// corner. Depth stays.
    #[must_use]
    pub fn viewport(x: f32, y: f32, width: f32, height: f32) -> Self {
        let (half_width, half_height) = (width * 0.5, height * 0.5);
        Self::from_rows(
            Vec4::new(half_width, 0.0, 0.0, x + half_width),
            Vec4::new(0.0, -half_height, 0.0, y + half_height),
            Vec4::Z,
            Vec4::W,
        )
    }

    /// A perspective matrix of its first two rows and its depths.
    fn lens(x: Vec4, y: Vec4, near: f32, far: Option<f32>) -> Self {
        // Depth z' = a z + b with z'/w = 1 at z = -near and 0 at z = -far; a vanishes with far.
        let z = match far {
            Some(far) => Vec4::new(0.0, 0.0, near / (far - near), far * (near / (far - near))),
            None => Vec4::new(0.0, 0.0, 0.0, near),
        };
        Self::from_rows(x, y, z, Vec4::new(0.0, 0.0, -1.0, 0.0))
    }
}
