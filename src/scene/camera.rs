use crate::math::{Angle, Mat4, Vec3};

/// What the lens is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Lens {
    Perspective { field_of_view: Angle, near: f32, far: Option<f32> },
    Orthographic { height: f32, near: f32, far: f32 },
    Custom(Mat4),
}

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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    view: Mat4,
    lens: Lens,
}

impl Camera {
    /// A perspective camera at the origin: vertical field of view and distance of the near plane.
    ///
    /// Nothing is too far to be seen. The depth resolution at distance d is d^2 / (65531 near).
    pub const fn perspective(field_of_view: Angle, near: f32) -> Self {
        Self { view: Mat4::identity(), lens: Lens::Perspective { field_of_view, near, far: None } }
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
    pub const fn orthographic(height: f32, near: f32, far: f32) -> Self {
        Self { view: Mat4::identity(), lens: Lens::Orthographic { height, near, far } }
    }

    /// A camera with a projection matrix of your own: clip z / w must be 1 at the near plane and
    /// 0 at the far one. It is used as it stands, whatever the viewport's aspect.
    pub const fn custom(projection: Mat4) -> Self {
        Self { view: Mat4::identity(), lens: Lens::Custom(projection) }
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
    #[must_use]
    pub const fn far(mut self, distance: f32) -> Self {
        if let Lens::Perspective { field_of_view, near, .. } = self.lens {
            self.lens = Lens::Perspective { field_of_view, near, far: Some(distance) };
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
    pub fn projection(&self, aspect: f32) -> Mat4 {
        match self.lens {
            Lens::Perspective { field_of_view, near, far } => {
                Mat4::perspective(field_of_view, aspect, near, far)
            }
            Lens::Orthographic { height, near, far } => {
                let (y, x) = (height * 0.5, height * 0.5 * aspect);
                Mat4::orthographic(-x, x, -y, y, near, far)
            }
            Lens::Custom(projection) => projection,
        }
    }

    /// The near distance if clip z is that constant: a perspective camera without far plane.
    pub(crate) fn constant_near(&self) -> Option<f32> {
        match self.lens {
            Lens::Perspective { near, far: None, .. } => Some(near),
            _ => None,
        }
    }
}
