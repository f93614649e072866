//! The host shim: what needs an operating system.
//!
//! | what | type |
//! | --- | --- |
//! | pictures out | [`Tga`], written whole or not at all by [`AtomicFile`] |
//! | models in | [`Model`] from `.asc`, from `.obj` with feature `tools`, and the bundled teapot |
//! | smaller copies of a texture | [`mip_map`] |
//! | the name of a picture | [`fnv1a64`] |
//! | what a picture should be | [`mod@reference`] |
//! | a picture by all cores | [`ParallelBands`] |
//!
//! Nothing here is part of a firmware: every item takes `std`, allocates, and reads or writes
//! files. All input is taken as hostile: it ends in a value or in an error that names the file,
//! the line and what to do.

mod atomic_file;
mod cache_order;
mod hash;
mod mesh_data;
mod mip_map;
mod model;
mod parallel_bands;
pub mod reference;
mod tga;

pub use atomic_file::AtomicFile;
pub use hash::{fnv1a64, fnv1a64_after, FNV1A64_START};
pub use mesh_data::MeshData;
pub use mip_map::mip_map;
pub use model::{Bounds, Corner, Group, Material, Model, ModelError, ModelWarning};
pub use parallel_bands::ParallelBands;
pub use tga::{Tga, TgaDepth, TgaError, TgaOrigin};
