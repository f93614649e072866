//! Light on surfaces: kinds of lights, and what surfaces make of it.
//!
//! All is done in the mesh's own space, by integers: lights are brought there once a draw, so that
//! neither a normal nor a position is transformed.

mod beam;
mod blinn_phong;
mod lambert;
mod light_kind;
mod mesh_space;
mod shininess;
mod surface;
mod tinted;

pub use beam::Beam;
pub use blinn_phong::{BlinnPhong, PreparedBlinnPhong};
pub use lambert::{Lambert, PreparedLambert};
pub use light_kind::{LightKind, PreparedAnyLight, PreparedPoint, PreparedSpot};
pub(super) use mesh_space::normalized;
pub use surface::{Lighting, Surface};
pub use tinted::Tinted;
