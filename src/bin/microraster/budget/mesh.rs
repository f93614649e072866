//! The user's model as the firmware draws it, and what it takes of flash.

use super::settings::{DISTANCE, HALF_VIEW, MESH_ROOM};
use crate::firmware::mesh_file;
use crate::firmware::scenes::Model as MeshFile;
use microraster::host::{MeshData, Model};
use microraster::PlaneScale;
use microraster::Size;
use std::path::Path;

/// A model that is ready to be measured.
#[derive(Debug)]
pub(crate) struct Prepared {
    /// The words of the firmware's file.
    pub(crate) words: Vec<u32>,
    pub(crate) triangles: usize,
    pub(crate) vertices: usize,
    /// Parts, one a material or 65 536 vertices.
    pub(crate) parts: usize,
    /// How often a cache of 32 slots has a vertex made, and what another order of triangles would make
    /// of it.
    pub(crate) made: [usize; 2],
}

impl Prepared {
    /// Loads a model, in an order for a small cache where asked; its warnings are printed.
    ///
    /// # Errors
    /// The file is no model, or too large to be measured.
    pub(crate) fn load(file: &Path, display: Size, reorder: bool) -> Result<Self, String> {
        let model = Model::load(file).map_err(|error| error.to_string())?;
        for warning in &model.warnings {
            eprintln!("microraster: warning: {warning}");
        }
        let parts = MeshData::of_model(&model, false);
        let parts = if reorder { ordered(parts) } else { parts };
        let prepared = Self::of(&parts, display);
        let bytes = size_of_val(prepared.words.as_slice());
        if bytes > MESH_ROOM {
            return Err(format!(
                "{}: {bytes} bytes as a mesh; at most {MESH_ROOM} can be measured",
                file.display()
            ));
        }
        Ok(prepared)
    }

    fn of(parts: &[MeshData], display: Size) -> Self {
        let scale = fitting(parts, display);
        let mut words = Vec::new();
        for part in parts {
            words.extend(mesh_file::words(&MeshFile {
                positions: &part.positions,
                normals: &part.normals,
                planes: &[],
                plane_scale: PlaneScale { radius: 0, reach: [0; 3] },
                indices: &part.indices,
                scale,
                offset: [0.0; 3],
            }));
        }
        Self {
            words,
            triangles: parts.iter().map(|part| part.indices.len() / 3).sum(),
            vertices: parts.iter().map(|part| part.positions.len()).sum(),
            parts: parts.len(),
            made: [made(parts), made(&ordered(parts.to_vec()))],
        }
    }

    /// Bytes of positions, normals and indices.
    pub(crate) fn flash(&self) -> [u64; 3] {
        let (vertices, triangles) = (self.vertices as u64, self.triangles as u64);
        [6 * vertices, 3 * vertices, 6 * triangles]
    }
}

/// Slots of the cache that a draw has on the stack.
const SLOTS: usize = 32;

/// Parts in an order that suits a small cache.
fn ordered(mut parts: Vec<MeshData>) -> Vec<MeshData> {
    parts.iter_mut().for_each(|part| part.order_for_cache(SLOTS));
    parts
}

/// How often a small cache has a vertex made.
fn made(parts: &[MeshData]) -> usize {
    parts.iter().map(|part| part.vertices_made(SLOTS)).sum()
}

/// What a step of a position is in the world, so that the model fills the view as `simulate` has
/// it, however it is turned about its upright axis: 80 % of the height, or 95 % of the width.
fn fitting(parts: &[MeshData], display: Size) -> f32 {
    let across = 0.95 * HALF_VIEW * f32::from(display.width) / f32::from(display.height);
    let up = 0.8 * HALF_VIEW;
    let largest = |[x, y, z]: &[i16; 3]| {
        let [x, y, z] = [x, y, z].map(|&value| f32::from(value));
        // A vertex is highest where it is nearest, and goes round on a circle that touches the
        // sides of the view.
        let (tall, round) = (y.abs(), x.hypot(z));
        let by_height = up * DISTANCE / (tall + up * round).max(1.0);
        let by_width = DISTANCE * across / across.hypot(1.0) / round.max(1.0);
        by_height.min(by_width)
    };
    parts.iter().flat_map(|part| &part.positions).map(largest).fold(1.0, f32::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_teapot_is_written_and_read_back() {
        let parts = MeshData::of_model(&Model::teapot(4), false);
        let prepared = Prepared::of(&parts, Size::new(240, 240));
        let view = MeshFile::view(bytemuck::cast_slice(&prepared.words)).expect("its own form");
        assert_eq!(view.indices.len(), 3 * prepared.triangles, "all triangles");
        let [positions, normals, indices] = prepared.flash();
        assert_eq!(positions, size_of_val(view.positions) as u64, "bytes of positions");
        assert_eq!(normals, size_of_val(view.normals) as u64, "bytes of normals");
        assert_eq!(indices, size_of_val(view.indices) as u64, "bytes of indices");
    }

    #[test]
    fn whatever_the_display_the_model_is_in_view_from_all_sides() {
        let parts = MeshData::of_model(&Model::teapot(4), false);
        for (width, height) in [(240, 240), (320, 240), (100, 400), (8192, 8), (1, 1)] {
            let display = Size::new(width, height);
            let scale = fitting(&parts, display);
            let aspect = f32::from(width) / f32::from(height);
            let mut fills = 0.0_f32;
            for [x, y, z] in parts.iter().flat_map(|part| &part.positions) {
                let [x, y, z] = [x, y, z].map(|&value| f32::from(value) * scale);
                for turn in 0..32_u8 {
                    let (sine, cosine) = (f32::from(turn) * std::f32::consts::TAU / 32.0).sin_cos();
                    let (x, z) = (x * cosine + z * sine, z * cosine - x * sine);
                    let reach = HALF_VIEW * (DISTANCE - z);
                    fills = fills.max(y.abs() / reach).max(x.abs() / (reach * aspect));
                }
            }
            assert!((0.78..=0.951).contains(&fills), "{display:?}: {fills}");
        }
    }
}
