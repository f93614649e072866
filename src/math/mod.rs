//! Vectors, matrices and angles.

mod angle;
mod angle_units;
mod approximate;
#[cfg(test)]
pub(crate) mod hard_numbers;
mod inverse_sqrt;
mod reciprocal;
mod sqrt;
mod trigonometry;
pub(crate) mod wide;

pub use angle::Angle;
pub use angle_units::AngleUnits;
pub use inverse_sqrt::{inverse_sqrt, InverseSqrt};
pub use reciprocal::{reciprocal, Reciprocal};
pub use sqrt::sqrt;
