//! From a mesh to triangles on the screen: transform, clip, assemble, draw.
//!
//! A [`Pass`] holds the state and draws meshes; a [`ScreenPass`] draws primitives that are in
//! screen space already. What is generic over shader, state or format is the fetch of a vertex's
//! attributes and the loop over spans; the rest works on integers and is compiled once.

mod assembly;
mod attenuated;
mod cache;
mod clip;
mod clipper;
mod cull;
mod display_list;
mod draw;
mod facing;
mod fill;
mod fill_few;
#[cfg(all(test, feature = "std"))]
mod fill_tests;
mod fill_trapezoids;
mod line;
mod list_error;
mod mapping;
mod pass;
mod pass_lines;
mod pass_points;
mod pass_record;
mod point;
mod point_size;
mod projected;
mod resolve;
mod screen_pass;
mod transform;

pub use attenuated::Attenuated;
pub use cache::VertexCache;
pub use clip::Clip;
use cull::CulledWindings;
pub use cull::{Cull, Winding};
pub use display_list::{DisplayList, ListTriangle, ListVertex};
pub use line::{LineStyle, Midpoint, Rectangle, Smooth, Stippled, Thin, Wide};
pub use list_error::ListError;
pub use pass::Pass;
pub use pass_record::Recording;
pub use point_size::{PointSize, SizeOf};
pub use resolve::Supersampling;
pub use screen_pass::{ScreenPass, ShadedVertex};
