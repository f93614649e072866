use std::fmt;
use std::vec::Vec;

use super::State;
use crate::frame::Rect;

/// What positions mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// Clip space, y up. What is seen has `|x|, |y| <= w` and `z <= w`, the near plane, and becomes
    /// the depth code `2 + 65531 z / w`.
    Clip {
        /// The pixels that the view fills; nothing is drawn beside them.
        viewport: Rect,
        /// Whether there is a far plane, `z >= 0`.
        far: bool,
    },
    /// x and y in pixels, y down; z is the depth code, 65535 being nearest; w divides what is
    /// interpolated in perspective, and is not 0 there.
    Window,
}

/// What corners make.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Three corners each.
    Triangles,
    /// Two corners each: by the diamond-exit rule (OpenGL 4.6, section 14.5.1), in so many copies
    /// across the longer side.
    Lines {
        /// Copies, each a pixel wide.
        width: u16,
        /// How far along the line a pixel lies.
        progress: Progress,
    },
    /// One corner each: the pixels whose centres lie in the half-open square about it (OpenGL 4.6,
    /// section 14.4).
    Points {
        /// The side of the square in pixels.
        side: f64,
    },
}

/// How far along a line a pixel lies: where its varyings and its depth are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// By the column or row along the longer side, as the crate does.
    Longer,
    /// By the nearest point of the line (OpenGL 4.6, equation 14.4).
    Nearest,
}

/// How varyings change between corners. Depth is always linear on the screen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// As they do on the surface.
    #[default]
    Perspective,
    /// Linear on the screen; where a plane cuts a triangle, between the corners of what is left,
    /// in a fan about its first.
    Linear,
    /// Those of one corner, by its number in the primitive.
    Flat {
        /// 0 for the first.
        provoking: usize,
    },
}

/// A corner: where it is, and what comes with it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vertex {
    /// x, y, z, w as the draw's [`Space`] says.
    pub position: [f64; 4],
    /// As many for each vertex of a draw.
    pub varyings: Vec<f64>,
}

/// A pixel that a primitive covers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment<'a> {
    /// The column.
    pub x: u16,
    /// The row.
    pub y: u16,
    /// The varyings where the pixel is looked at.
    pub varyings: &'a [f64],
    /// How they change by a pixel to the right, as the exact derivative; 0 for lines and points.
    pub along_x: &'a [f64],
    /// How they change by a pixel down.
    pub along_y: &'a [f64],
    /// The number of the primitive in its draw.
    pub primitive: u32,
    /// Whether the front is seen; lines and points have no back.
    pub front: bool,
    /// Pixels of the draw's lines that come before this one, copies not counted, modulo 2^32: what
    /// a pattern of a strip goes by.
    pub step: u32,
}

/// Primitives that are drawn in one state.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// What positions mean.
    pub space: Space,
    /// What corners make.
    pub kind: Kind,
    /// The vertices.
    pub vertices: &'a [Vertex],
    /// Numbers of vertices: 3 a triangle, 2 a line, 1 a point. A primitive whose corner is no
    /// vertex, or one whose position is not finite, is left out, and counts.
    pub corners: &'a [u32],
    /// How varyings change between corners.
    pub interpolation: Interpolation,
    /// Which fragments are drawn, and how.
    pub state: State,
    /// Red, green, blue and alpha of a fragment, 0 to 255; `None` to discard it.
    pub shade: &'a dyn Fn(&Fragment<'_>) -> Option<[f64; 4]>,
}

impl fmt::Debug for Draw<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Draw")
            .field("space", &self.space)
            .field("kind", &self.kind)
            .field("vertices", &self.vertices)
            .field("corners", &self.corners)
            .field("interpolation", &self.interpolation)
            .field("state", &self.state)
            .finish_non_exhaustive()
    }
}
