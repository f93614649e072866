//! One corner of a triangle.

/// One corner of a triangle: where its attributes lie in the lists of the
/// [`Model`](super::Model).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Corner {
    /// Index into [`Model::positions`](super::Model::positions).
    pub position: u32,
    /// Index into [`Model::normals`](super::Model::normals).
    pub normal: u32,
    /// Index into [`Model::texture_coordinates`](super::Model::texture_coordinates), where the
    /// file gives one.
    pub texture: Option<u32>,
}
