//! A renderer in `f64` that is obviously correct: every pixel against every primitive.
//!
//! It shares no arithmetic with the crate, only plain data such as [`Size`](crate::Size) or
//! [`AnyBlend`](crate::AnyBlend), and takes no shortcut: tests and tools hold the crate's pictures
//! against it. It is slow.

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
