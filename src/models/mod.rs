//! Models to draw: the Utah teapot.
//!
//! Martin Newell's teapot of 1975, the test model of computer graphics, made from his 32 Bezier
//! patches while the crate compiles: each patch becomes 4 x 4 cells, 992 triangles over 530
//! vertices in all, 10.7 KB of flash if it is drawn and nothing if not. Right-handed, y up; seen
//! from +z the spout is at the right. The handle, lid and spout are separate surfaces, open where
//! they meet the body, and the body is open under the lid: as Newell drew them.
//!
//! ```
//! use microraster::math::Vec3;
//! use microraster::models::{TEAPOT_OFFSET, TEAPOT_POSITIONS, TEAPOT_SCALE};
//!
//! let height = |p: &[i16; 3]| TEAPOT_OFFSET.y + TEAPOT_SCALE * f32::from(p[1]);
//! let top = TEAPOT_POSITIONS.iter().map(height).fold(0.0, f32::max);
//! assert!((top - 3.15).abs() < TEAPOT_SCALE);
//! ```

mod bezier;
pub(crate) mod newell;
mod teapot;
#[cfg(test)]
mod teapot_tests;

use crate::math::Vec3;
use crate::scene::{FacePlane, FacePlanes, IndexedList, Mesh, Normal, PlaneScale};
pub use teapot::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_OFFSET, TEAPOT_POSITIONS, TEAPOT_SCALE};

/// The teapot as a mesh: normals by vertex, y up, centred on its box, 3.15 high.
///
/// ```
/// use microraster::models::TEAPOT;
///
/// assert_eq!(TEAPOT.triangles(), 992);
/// ```
pub static TEAPOT: Mesh<Normal, IndexedList<u16>> = Mesh::new(&TEAPOT_POSITIONS, &TEAPOT_NORMALS)
    .indexed(&TEAPOT_INDICES)
    .placed(Vec3::splat(TEAPOT_SCALE), Vec3::ZERO);

/// The planes of the [`TEAPOT`]'s triangles: 4 KB of flash more, for some 2 to 6 % less to do where it is
/// culled.
///
/// ```
/// use microraster::models::{TEAPOT, TEAPOT_PLANES};
///
/// let teapot = TEAPOT.with_planes(TEAPOT_PLANES);
/// # assert_eq!(teapot.triangles(), 992);
/// ```
pub const TEAPOT_PLANES: FacePlanes<'static> = FacePlanes::new(&PLANES, PLANE_SCALE);

const PLANE_SCALE: PlaneScale = PlaneScale::of(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
static PLANES: [FacePlane; 992] = PLANE_SCALE.bake(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
