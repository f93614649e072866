//! Varyings in perspective: one reciprocal for a few pixels, one for each, or none.

mod affine;
mod corner;
mod exact;
mod mode;
mod planes;
mod subspans;

pub use affine::{Affine, AffineValue};
pub use corner::PerspectiveCorner;
pub use exact::{Exact, ExactStep, ExactValue};
pub use mode::{Perspective, PerspectiveMode, PerspectiveVarying};
pub use planes::PerspectivePlanes;
pub use subspans::{Adaptive, Every, Interval, Subspan, SubspanValue};
