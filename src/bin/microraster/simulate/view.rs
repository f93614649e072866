//! From where a model is seen.

use super::options::{Cull, PictureSize, Shade, Traversal};
use super::{Arguments, Switch};
use microraster::host::Model;

/// A model, how it is drawn and from where.
///
/// The camera lies on the z axis and looks towards its negative end, y is up. A point p of the
/// model lies at `pitch(yaw((p - center) * scale))` and [`distance`](Self::distance) behind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View<'a> {
    pub(crate) model: &'a Model,
    pub(crate) shade: Shade,
    pub(crate) depth: bool,
    pub(crate) traversal: Traversal,
    pub(crate) cull: Cull,
    /// The middle of the model's box.
    pub(crate) center: [f64; 3],
    /// Brings the model into the unit sphere.
    pub(crate) scale: f64,
    /// Rotation about y, in radians.
    pub(crate) yaw: f64,
    /// Rotation about x after it, in radians.
    pub(crate) pitch: f64,
    /// From the camera to the middle.
    pub(crate) distance: f64,
}

impl<'a> View<'a> {
    /// Half the angle of view, upright, in radians.
    pub(crate) const HALF_FIELD: f64 = core::f64::consts::PI / 8.0;

    /// How much of the height the model fills.
    const FILL: f64 = 0.8;

    /// How much of the width it may fill; wide models are seen from further away.
    const FILL_ACROSS: f64 = 0.95;

    /// The nearest that a point of the model comes to the camera, in radii of the model.
    const NEAREST: f64 = 0.25;

    /// The views of all pictures, at one distance: the least from which the model fits in all.
    pub(crate) fn all(arguments: &Arguments, model: &'a Model) -> Result<Vec<Self>, String> {
        for (name, angle) in [("yaw", arguments.yaw), ("pitch", arguments.pitch)] {
            if !angle.is_finite() || angle.abs() > 36_000.0 {
                return Err(format!("--{name} {angle}: write degrees, at most 36000"));
            }
        }
        let bounds = model.bounds();
        let halves = [0, 1, 2].map(|axis| {
            let (min, max) = (f64::from(bounds.min[axis]), f64::from(bounds.max[axis]));
            (min + max) / 2.0
        });
        let mut view = Self {
            model,
            shade: arguments.shade,
            depth: arguments.depth == Switch::On,
            traversal: arguments.traversal,
            cull: arguments.cull,
            center: halves,
            scale: 1.0,
            yaw: f64::from(arguments.yaw).to_radians(),
            pitch: f64::from(arguments.pitch).to_radians(),
            distance: 0.0,
        };
        let radius = view.placed().map(length).fold(0.0, f64::max);
        // A model of one point has no size to bring to 1.
        if radius > 0.0 {
            view.scale = 1.0 / radius;
        }

        let frames = arguments.frames.unwrap_or(1);
        let views: Vec<Self> = (0..frames)
            .map(|frame| {
                let turn = core::f64::consts::TAU * f64::from(frame) / f64::from(frames);
                Self { yaw: view.yaw + turn, ..view }
            })
            .collect();
        let fitting = views.iter().map(|view| view.fitting(arguments.size));
        let distance = fitting.fold(1.0, f64::max);
        Ok(views.into_iter().map(|view| Self { distance, ..view }).collect())
    }

    /// Where a point of the model lies, the middle of the model being the origin.
    pub(crate) fn place(&self, point: [f32; 3]) -> [f64; 3] {
        let [x, y, z] = point.map(f64::from);
        let [a, b, c] = self.center;
        self.turn([x - a, y - b, z - c].map(|c| c * self.scale))
    }

    /// A direction of the model, turned as the model is.
    pub(crate) fn turn(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.yaw.sin_cos();
        let (x, z) = (x * cos + z * sin, z * cos - x * sin);
        let (sin, cos) = self.pitch.sin_cos();
        [x, y * cos - z * sin, y * sin + z * cos]
    }

    fn placed(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.model.positions.iter().map(|&point| self.place(point))
    }

    /// The least distance from which every point lies within [`FILL`](Self::FILL) of the height
    /// and [`FILL_ACROSS`](Self::FILL_ACROSS) of the width.
    fn fitting(&self, size: PictureSize) -> f64 {
        let up = Self::FILL * Self::HALF_FIELD.tan();
        let aspect = f64::from(size.width) / f64::from(size.height);
        let across = Self::FILL_ACROSS * Self::HALF_FIELD.tan() * aspect;
        self.placed()
            .map(|[x, y, z]| {
                let room = (y.abs() / up).max(x.abs() / across);
                z + room.max(Self::NEAREST)
            })
            .fold(0.0, f64::max)
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
