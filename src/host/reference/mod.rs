//! A renderer in `f64` that is obviously correct: every pixel against every primitive.
//!
//! It shares no arithmetic with the crate, only plain data such as [`Size`](crate::Size) or
//! [`AnyBlend`](crate::AnyBlend), and takes no shortcut: tests and tools hold pictures against it.
//! It is slow.
//!
//! | what | how exact |
//! | --- | --- |
//! | coverage | integers: corners on a grid of your choice ([`Snap`]), the sample anywhere on one of 2^-24 pixel; top-left rule, diamond-exit rule, half-open squares |
//! | near and far plane | cut in clip space, from the inner end |
//! | varyings and their derivatives | quotients of weighted sums, by the exact areas at each pixel |
//! | depth | linear on the screen, as codes that are not rounded, or rounded before they are compared ([`DepthPrecision`]) |
//! | blending | not rounded; [`rounded_colors`](Reference::rounded_colors) rounds at the end |
//! | textures | [`Texture`] and [`MipTexture`], nearest, bilinear, trilinear |
//! | light and fog | [`lighting`], [`Fog`] |
//! | what a pixel shows of all that lies in it | the mean of many [`looks`] |
//! | how far a picture is from it | [`compare`] |
//!
//! Clip space and depth codes are the crate's: y up, `z = w` at the near plane, code
//! `2 + 65531 z / w`, larger is nearer.
//!
//! ```
//! use microraster::host::reference::{
//!     looks, mean_colors, Draw, Interpolation, Kind, Reference, Space, State, Vertex,
//! };
//! use microraster::Size;
//!
//! // A triangle over the left upper half of two by two pixels, red at its right corner.
//! let vertex = |x: f64, y: f64, red: f64| Vertex {
//!     position: [x, y, 0.0, 1.0],
//!     varyings: vec![red],
//! };
//! let draw = Draw {
//!     space: Space::Window,
//!     kind: Kind::Triangles,
//!     vertices: &[vertex(0.0, 0.0, 0.0), vertex(2.0, 0.0, 200.0), vertex(0.0, 2.0, 0.0)],
//!     corners: &[0, 1, 2],
//!     interpolation: Interpolation::Linear,
//!     state: State::PLAIN,
//!     shade: &|fragment| Some([fragment.varyings[0], 0.0, 100.0, 255.0]),
//! };
//! let picture = |look: [f64; 2]| {
//!     let mut picture = Reference::new(Size::new(2, 2), [0.0; 3]).look(look);
//!     picture.draw(&draw);
//!     picture
//! };
//!
//! // The centres of two pixels lie on the long edge, which is a right one.
//! let centers = picture([0.0, 0.0]);
//! assert_eq!(centers.seen(), [Some(0), None, None, None]);
//! assert_eq!(centers.colors()[0], [50.0, 0.0, 100.0]);
//!
//! // Of both about half is covered.
//! let means = mean_colors(looks(16).map(picture));
//! assert!((means[1][2] - 50.0).abs() < 4.0);
//! assert_eq!(means[3], [0.0; 3]);
//! ```

mod blend;
pub mod compare;
mod corner;
mod draw;
mod fog;
mod fragment_tests;
pub mod lighting;
mod line;
mod looks;
#[allow(clippy::module_inception, reason = "the module's main type, in its own file")]
mod reference;
mod snap;
mod state;
mod texture;
mod triangle;
mod varyings;

pub use blend::blended;
pub use draw::{Draw, Fragment, Interpolation, Kind, Progress, Space, Vertex};
pub use fog::Fog;
pub use looks::{looks, mean_colors};
pub use reference::Reference;
pub use snap::Snap;
pub use state::{DepthPrecision, State};
pub use texture::{MipTexture, TexelGrid, Texture};
