//! From where a model is seen.

use super::options::{Cull, PictureSize, Shade, Traversal};
use super::{Arguments, Switch};
use microraster::host::Model;

/// A model, how it is drawn and from where.
///
/// The camera lies on the z axis and looks towards its negative end, y is up. A point p of the
/// model lies at `pitch(yaw((p - center) * scale))`, moved by [`shift`](Self::shift) and
/// [`distance`](Self::distance) behind.
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
    /// To the right and up, so that what is seen is in the middle of the picture.
    pub(crate) shift: [f64; 2],
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

    /// Steps in which the fit is made; four are enough for all models seen so far.
    const STEPS: usize = 8;

    /// The views of all pictures, from one place: the nearest from which the model fits in all.
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
            shift: [0.0; 2],
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
        let (shift, distance) = Self::fitting(&views, arguments.size);
        Ok(views.into_iter().map(|view| Self { shift, distance, ..view }).collect())
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

    /// Where the middle goes so that the model, in all views together, is seen in the middle of
    /// the picture and touches [`FILL`](Self::FILL) of the height or
    /// [`FILL_ACROSS`](Self::FILL_ACROSS) of the width: a shift, and the distance.
    fn fitting(views: &[Self], size: PictureSize) -> ([f64; 2], f64) {
        let aspect = f64::from(size.width) / f64::from(size.height);
        let up = Self::FILL * Self::HALF_FIELD.tan();
        let across = Self::FILL_ACROSS * Self::HALF_FIELD.tan() * aspect;
        let points = || views.iter().flat_map(Self::placed);

        let mut slopes = [1.0 / across, 1.0 / up];
        let mut sides = Extent::of(points(), slopes);
        let nearest = points().map(|[_, _, z]| z).fold(0.0, f64::max) + Self::NEAREST;
        let distance = sides.iter().map(Extent::distance).fold(nearest.max(1.0), f64::max);

        // The side that decided fills its part of the picture. The other one fills less: so much
        // that it too fits from this distance and no nearer. That is a root of a convex function
        // that is made of straight pieces, which Newton's method finds in a few steps.
        for _ in 0..Self::STEPS {
            for (slope, side) in slopes.iter_mut().zip(&sides) {
                if side.growth() > 0.0 {
                    *slope += (distance - side.distance()) / side.growth();
                }
            }
            sides = Extent::of(points(), slopes);
        }
        ([0, 1].map(|side| sides[side].shift(slopes[side])), distance)
    }
}

/// A point that limits how near the camera may come.
#[derive(Clone, Copy, Debug)]
struct End {
    /// How far from the axis it lies.
    along: f64,
    /// The camera's distance from which it is seen at the edge.
    distance: f64,
}

/// The ends of what is seen along one side of the picture. The edge is where the distance from the
/// camera is a slope times that from the axis.
#[derive(Clone, Copy, Debug)]
struct Extent {
    low: End,
    high: End,
}

impl Extent {
    /// The ends along both sides.
    fn of(points: impl Iterator<Item = [f64; 3]>, slopes: [f64; 2]) -> [Self; 2] {
        let none = End { along: 0.0, distance: f64::NEG_INFINITY };
        let mut sides = [Self { low: none, high: none }; 2];
        for [x, y, z] in points {
            for ((side, along), slope) in sides.iter_mut().zip([x, y]).zip(slopes) {
                for (end, out) in [(&mut side.low, -along), (&mut side.high, along)] {
                    let distance = z + out * slope;
                    if distance > end.distance {
                        *end = End { along, distance };
                    }
                }
            }
        }
        sides
    }

    /// From where both ends are seen at the edges, after the shift.
    fn distance(&self) -> f64 {
        (self.low.distance + self.high.distance) / 2.0
    }

    /// By how much that distance grows with the slope.
    fn growth(&self) -> f64 {
        (self.high.along - self.low.along) / 2.0
    }

    /// What brings both ends to the edges at the same distance.
    fn shift(&self, slope: f64) -> f64 {
        (self.low.distance - self.high.distance) / (2.0 * slope)
    }
}

fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}
