//! The triangles of one material.

use super::{Corner, Material};
use std::prelude::rust_2021::*;

/// The triangles of one material, in the order of the file.
///
/// Front faces are counter-clockwise as seen, as in the file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Group {
    /// The surface.
    pub material: Material,
    /// Three corners each.
    pub triangles: Vec<[Corner; 3]>,
}
