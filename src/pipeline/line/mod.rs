//! What lines look like.

mod midpoint;
mod quad;
mod rectangle;
mod smooth;
mod stippled;
mod stroke;
mod style;
mod thin;
mod wide;

pub use midpoint::Midpoint;
pub use rectangle::Rectangle;
pub use smooth::Smooth;
pub use stippled::Stippled;
pub(super) use stroke::{LineDraw, Outcome};
pub use style::LineStyle;
pub use thin::Thin;
pub use wide::Wide;
