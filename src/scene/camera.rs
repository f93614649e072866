use crate::math::{Angle, Mat4, Vec3, Vec4};

/// Where the picture is seen from, and through what.
///
/// Eye space is right-handed: x to the right, y up, the view along -z. Depth is reversed: clip z is
/// near, at w = near, and falls towards 0 with distance.
///
/// ```
/// use microraster::math::{AngleUnits, Vec3};
/// use microraster::Camera;
///
/// let camera = Camera::perspective(45.0.degrees(), 0.5)
///     .look_at(Vec3::new(0.0, 1.0, 4.0), Vec3::ZERO, Vec3::Y);
/// ```
///
/// # Cost
/// Angles become numbers where the camera is made: at compile time, for one in a `const`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    view: Mat4,
    /// From eye space to clip space, but for the aspect.
    lens: Mat4,
    /// Half the picture's height at distance 1, or at any without perspective. `None` for a matrix
    /// that the aspect does not change.
    half_height: Option<f32>,
    /// The near distance of a perspective camera.
    near: Option<f32>,
    /// Whether clip z is not simply the near distance.
    has_depth_row: bool,
}

impl Camera {
    /// A perspective camera at the origin: vertical field of view and distance of the near plane.
    ///
    /// Nothing is too far to be seen. The depth resolution at distance d is d^2 / (65531 near).
    ///
    /// # Measured
    /// <!-- tradeoff: range/depth+range=infinite+1e3 -->
    /// `infinite + 1e3` in the scene `range`: 2.60 M (M4F), 3.69 M (M0+), 2.74 M (RV32) instructions a frame; PSNR 19.4 dB.
    #[inline]
    pub const fn perspective(field_of_view: Angle, near: f32) -> Self {
        let half_height = field_of_view.half().tan();
        Self {
            near: Some(near),
            has_depth_row: false,
            ..Self::through(
                half_height,
                Vec4::new(0.0, 0.0, 0.0, near),
                Vec4::new(0.0, 0.0, -1.0, 0.0),
            )
        }
    }

    /// A camera without perspective: the height of what it sees, and the distances between which
    /// it sees.
    ///
    /// # Rounding
    /// Depth codes are off by at most 1/2 + 6 (1 + d) r: d is depth from 1 at `near` to 0 at `far`,
    /// r the largest clip coordinate that the mesh's box can reach, which is how many times half
    /// the view's width or height its positions of +-32768 lie away, and no less than 1. An axis
    /// of the mesh that runs across the view, or along it, counts a third of that. Meshes far
    /// larger than the view should be cut into smaller ones where depth matters.
    #[inline]
    pub const fn orthographic(height: f32, near: f32, far: f32) -> Self {
        let length = far - near;
        Self::through(height * 0.5, Vec4::new(0.0, 0.0, 1.0 / length, far / length), Vec4::W)
    }

    /// A camera with a projection matrix of your own: clip z / w must be 1 at the near plane and
    /// 0 at the far one. It is used as it stands, whatever the viewport's aspect.
    #[inline]
    pub const fn custom(projection: Mat4) -> Self {
        Self {
            view: Mat4::IDENTITY,
            lens: projection,
            half_height: None,
            near: None,
            has_depth_row: true,
        }
    }

    /// A camera of half the picture's height and of the matrix' rows for z and w.
    #[inline]
    const fn through(half_height: f32, z: Vec4, w: Vec4) -> Self {
        let y = Vec4::new(0.0, 1.0 / half_height, 0.0, 0.0);
        Self {
            half_height: Some(half_height),
            ..Self::custom(Mat4::from_rows(Vec4::ZERO, y, z, w))
        }
    }

    /// Cuts off what is farther than `far`. Changes a perspective camera only.
    ///
    /// # Rounding
    /// Depth codes are off by at most 1/2 + 6 (1 + d) r / w: d is depth from 1 at the near plane to
    /// 0 at `far`, w the distance, r the largest clip coordinate that positions of +-32768 reach.
    /// For a mesh not much larger than its distance, that is one or two codes as a rule (1.3 were
    /// seen with planes at 0.1 and 100); without a far plane it is half a code and 6 d r / w.
    ///
    /// # Cost
    /// A fourth row of the matrix: 3 multiplications more a vertex, and depth that runs from near
    /// to far instead of to infinity.
    ///
    /// # Measured
    /// <!-- tradeoff: range/depth+range=far-plane+1e3 -->
    /// `far-plane + 1e3` in the scene `range`: 2.59 M (M4F), 3.70 M (M0+), 2.73 M (RV32) instructions a frame; PSNR 15.4 dB.
    #[inline]
    #[must_use]
    pub const fn far(mut self, distance: f32) -> Self {
        if let Some(near) = self.near {
            // z' = a z + b with z'/w = 1 at z = -near and 0 at z = -far.
            let a = near / (distance - near);
            (self.lens.z.z, self.lens.w.z) = (a, distance * a);
            self.has_depth_row = true;
        }
        self
    }

    /// Puts the camera at `eye`, looking at `target`, with `up` upwards in the picture.
    #[must_use]
    pub fn look_at(mut self, eye: Vec3, target: Vec3, up: Vec3) -> Self {
        self.view = Mat4::look_at(eye, target, up);
        self
    }

    /// Sets the matrix from world space to eye space.
    #[must_use]
    pub const fn with_view(mut self, view: Mat4) -> Self {
        self.view = view;
        self
    }

    /// From world space to eye space.
    pub const fn view(&self) -> Mat4 {
        self.view
    }

    /// From eye space to clip space, for a viewport of this width by height.
    #[inline]
    pub const fn projection(&self, aspect: f32) -> Mat4 {
        let mut projection = self.lens;
        if let Some(half_height) = self.half_height {
            projection.x.x = 1.0 / (half_height * aspect);
        }
        projection
    }

    /// The near distance if clip z is that constant: a perspective camera without far plane.
    #[inline]
    pub(crate) const fn constant_near(&self) -> Option<f32> {
        if self.has_depth_row {
            None
        } else {
            self.near
        }
    }
}
