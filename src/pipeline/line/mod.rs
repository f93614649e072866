//! What lines look like.

mod midpoint;
mod stippled;
mod stroke;
mod style;
mod thin;
mod wide;

pub use midpoint::Midpoint;
pub use stippled::Stippled;
pub(super) use stroke::{LineDraw, Outcome};
pub use style::LineStyle;
pub use thin::Thin;
pub use wide::Wide;
