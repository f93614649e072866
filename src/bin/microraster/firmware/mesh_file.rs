//! Writes the mesh files that firmware reads.

use super::scenes::model::{HEADER, MAGIC};
use super::scenes::Model;
use microraster::host::AtomicFile;
use std::io::Write;
use std::path::Path;

/// Writes the words of a file. Firmware that reads it just now sees the old file or the new one.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn write(file: &Path, words: &[u32]) -> Result<(), String> {
    let problem = |why: std::io::Error| format!("{}: {why}", file.display());
    let mut whole = AtomicFile::create(file).map_err(problem)?;
    whole.write_all(bytemuck::cast_slice(words)).map_err(problem)?;
    whole.seal().map_err(problem)?;
    whole.commit().map_err(problem)
}

/// A mesh as the words of a file, which are aligned for a view of it.
///
/// Counts beyond 32 bits saturate: the file is then none.
pub(crate) fn words(model: &Model<'_>) -> Vec<u32> {
    let mut bytes = MAGIC.to_vec();
    for count in [model.positions.len(), model.indices.len()] {
        bytes.extend(u32::try_from(count).unwrap_or(u32::MAX).to_le_bytes());
    }
    let [x, y, z] = model.offset;
    for value in [model.scale, x, y, z] {
        bytes.extend(value.to_le_bytes());
    }
    debug_assert_eq!(bytes.len(), HEADER, "the header's size is part of the format");
    for value in model.positions.iter().flatten() {
        bytes.extend(value.to_le_bytes());
    }
    for index in model.indices {
        bytes.extend(index.to_le_bytes());
    }
    let [x, y, z] = model.plane_scale.reach;
    for value in [model.plane_scale.radius, x, y, z] {
        bytes.extend(value.to_le_bytes());
    }
    bytes.extend(model.planes.as_flattened());
    for value in model.normals.iter().flatten() {
        bytes.extend(value.to_le_bytes());
    }
    bytes.resize(bytes.len().next_multiple_of(4), 0);
    bytes.as_chunks::<4>().0.iter().map(|word| u32::from_ne_bytes(*word)).collect()
}
