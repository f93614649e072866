//! What firmware and host agree on when `cargo budget` measures a model.

/// The mesh's file, in the emulator's working directory: meshes of [`Model`](crate::Model)'s form,
/// each padded to a multiple of four bytes, with offset zero and a scale that fits the view.
pub(crate) const FILE: &str = "budget.mesh";

/// The largest file, in bytes.
pub(crate) const MESH_ROOM: usize = 2 << 20;

/// Pixels of the largest band that is measured.
pub(crate) const BAND_ROOM: usize = 384_000;

/// Pixels of the band in the variants that are weighed.
pub(crate) const WEIGHED: usize = 64;

/// How far from the camera the model's middle is.
pub(crate) const DISTANCE: f32 = 3.0178;

/// The tangent of half the field of view of 45 degrees.
pub(crate) const HALF_VIEW: f32 = 0.414_213_56;

/// Views of which a figure is the mean: so many turns of a full circle.
pub(crate) const VIEWS: u16 = 4;

/// Vertices that the caller's cache may hold; 0 for that of 32 which a draw has on the stack.
pub(crate) const CACHES: [u16; 4] = [0, 64, 256, 1024];

/// Bytes of the caller's cache.
pub(crate) const fn cache_bytes(vertices: u16) -> usize {
    match vertices {
        0 => 0,
        // A key, a position and a colour.
        vertices => vertices as usize * (4 + 8 + 8),
    }
}
