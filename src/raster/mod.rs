//! The rasterizer: from screen-space primitives to covered pixels and interpolated attributes.
//!
//! Coordinates are 28.4 fixed point with y down; pixel (i, j) has its centre at
//! (16 i + 8, 16 j + 8). A pixel belongs to a triangle if its centre lies inside, or on a top or
//! a left edge: triangles that share an edge cover each pixel exactly once.
//!
//! ```text
//!   E(P) = dx (Py - ay) - dy (Px - ax)    positive inside, for corners clockwise on the screen
//!   covered  <=>  E >= 0 on top and left edges, E >= 1 on others, for all three edges
//! ```
//! Nothing here knows a shader, a format or a state: the code is compiled once. [`Spans`] solves
//! the rule per row with exact integers; [`Gradients`] makes attribute planes.

mod coverage;
mod edge;
mod few;
mod gradients;
mod line;
mod long_edge;
mod medium_edge;
mod midpoint;
mod path;
mod plane;
mod point;
mod screen_vertex;
mod short_edge;
mod small_gradients;
mod spans;
mod trapezoid;
#[cfg(feature = "std")]
mod traversal;
mod triangle;

pub use coverage::{Scanline, Span, SpanBatch, SpanWalk, Traversal};
pub(crate) use edge::Edge;
pub(crate) use few::{Few, Limits, Nothing};
pub use gradients::Gradients;
pub(crate) use gradients::Slopes;
pub(crate) use line::{depth_along, plane_triangle, Line};
pub(crate) use long_edge::{Divisor, LongEdge};
pub(crate) use midpoint::MidpointPath;
pub(crate) use path::{limited, Path, Pixel, Steps};
pub use plane::Plane;
pub use point::PointSquare;
pub(crate) use screen_vertex::Point;
pub use screen_vertex::{ScreenVertex, GUARD, SUBPIXELS};
pub(crate) use small_gradients::{SmallGradients, SMALL_SIDE};
pub(crate) use spans::first_center;
pub use spans::Spans;
pub(crate) use trapezoid::Trapezoid;
#[cfg(feature = "std")]
pub use traversal::{AnyTraversal, AnyWalk, BlockWalk, Blocks, BoundingBox, Rows};
pub(crate) use triangle::{area_of_sides, Fitted, Guard};
pub use triangle::{twice_area, Triangle};
