//! Makes the mesh file of the bunny, whose licence keeps it out of this repository: it is read
//! where it lies.

use super::mesh_file;
use super::scenes::Model;
use microraster::PlaneScale;
use std::path::{Path, PathBuf};

/// Where the bunny lies in the folder of models.
const PLACE: &str = "obj/bunny-npm/bunny.obj";

/// The bunny's OBJ file, or why there is none.
///
/// # Errors
/// Neither the environment nor the default names a folder that has it.
pub(crate) fn find(package: &Path) -> Result<PathBuf, String> {
    let models = std::env::var_os("MICRORASTER_MODELS")
        .map_or_else(|| package.join("../shared/models"), PathBuf::from);
    let file = models.join(PLACE);
    if file.is_file() {
        Ok(file)
    } else {
        Err(format!(
            "{} is not there; MICRORASTER_MODELS names the folder that has {PLACE}",
            file.display()
        ))
    }
}

/// Reads an OBJ file and gives the bytes of the mesh file, aligned for their view.
///
/// # Errors
/// A file that is no mesh of at most 65 536 vertices.
pub(crate) fn convert(file: &Path) -> Result<Vec<u32>, String> {
    let problem = |why: String| format!("{}: {why}", file.display());
    let options = tobj::LoadOptions { single_index: true, triangulate: true, ..Default::default() };
    let (models, _) = tobj::load_obj(file, &options).map_err(|why| problem(why.to_string()))?;
    let mut points: Vec<[f32; 3]> = Vec::new();
    let mut indices = Vec::new();
    for model in models {
        let first = points.len();
        points.extend(model.mesh.positions.as_chunks::<3>().0);
        indices.extend(model.mesh.indices.iter().map(|&index| index as usize + first));
    }
    if indices.is_empty() || indices.iter().any(|&index| index >= points.len()) {
        return Err(problem("no triangles, or indices out of range".into()));
    }
    let (scale, offset) = frame_of(&points);
    let normals = normals(&points, &indices);

    let positions: Vec<_> = points
        .iter()
        .map(|point| [0, 1, 2].map(|axis| step((point[axis] - offset[axis]) / scale)))
        .collect();
    let indices = indices.into_iter().map(u16::try_from).collect::<Result<Vec<_>, _>>();
    let indices = indices.map_err(|_| problem("over 65 536 vertices".into()))?;
    let normals: Vec<_> = normals
        .iter()
        .map(|normal| normal.map(|value| step(value * 127.0).to_le_bytes()[0].cast_signed()))
        .collect();
    let plane_scale = PlaneScale::of(&positions, &indices);
    let corners = |three: &[u16; 3]| three.map(|index| positions[usize::from(index)]);
    let planes: Vec<_> =
        indices.as_chunks().0.iter().map(|three| plane_scale.plane(corners(three))).collect();
    let model = Model {
        planes: &planes,
        plane_scale,
        positions: &positions,
        normals: &normals,
        indices: &indices,
        scale,
        offset,
    };
    Ok(mesh_file::words(&model))
}

/// The nearest whole step.
#[allow(clippy::cast_possible_truncation, reason = "callers divide by the largest extent")]
fn step(value: f32) -> i16 {
    value.round() as i16
}

/// Scale and offset that map the points' box to the range of i16.
fn frame_of(points: &[[f32; 3]]) -> (f32, [f32; 3]) {
    let (mut low, mut high) = ([f32::MAX; 3], [f32::MIN; 3]);
    for point in points {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis]);
            high[axis] = high[axis].max(point[axis]);
        }
    }
    let half = (0..3).map(|axis| (high[axis] - low[axis]) / 2.0).fold(f32::MIN_POSITIVE, f32::max);
    (half / f32::from(i16::MAX), std::array::from_fn(|axis| (low[axis] + high[axis]) / 2.0))
}

/// Smooth normals of length 1, each face weighted by its area.
fn normals(points: &[[f32; 3]], indices: &[usize]) -> Vec<[f32; 3]> {
    let mut sums = vec![[0f32; 3]; points.len()];
    for &[a, b, c] in indices.as_chunks::<3>().0 {
        let edge =
            |to: usize| -> [f32; 3] { std::array::from_fn(|i| points[to][i] - points[a][i]) };
        let (u, v) = (edge(b), edge(c));
        let cross =
            [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for corner in [a, b, c] {
            for (sum, part) in sums[corner].iter_mut().zip(cross) {
                *sum += part;
            }
        }
    }
    for sum in &mut sums {
        let length = sum.iter().map(|part| part * part).sum::<f32>().sqrt();
        *sum = sum.map(|part| part / length.max(f32::MIN_POSITIVE));
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::super::scenes::model::MAGIC;
    use super::*;

    #[test]
    fn what_is_written_is_read_back() {
        let path = std::env::temp_dir().join(format!("microraster-{}.obj", std::process::id()));
        let text = "v -1 0 0\nv 3 0 0\nv -1 2 0\nf 1 2 3\n";
        std::fs::write(&path, text).expect("the temporary folder takes a file");
        let words = convert(&path);
        std::fs::remove_file(&path).expect("the file was just written");
        let words = words.expect("one triangle is a mesh");
        let model = Model::view(bytemuck::cast_slice(&words)).expect("the writer's own format");
        assert_eq!(model.indices, [0, 1, 2]);
        let corners = [0, 1, 2].map(|corner| model.positions[corner]);
        assert_eq!(model.planes, [model.plane_scale.plane(corners)]);
        assert_eq!(model.normals, [[0, 0, 127]; 3]);
        assert_eq!(model.positions[1], [32767, -16384, 0]);
        assert_eq!(model.offset.map(f32::to_bits), [1f32, 1.0, 0.0].map(f32::to_bits));
    }

    #[test]
    fn a_cut_file_is_no_model() {
        // The header, and what planes are made for: none.
        let mut words = vec![0u32; 10];
        bytemuck::cast_slice_mut(&mut words)[..8].copy_from_slice(&MAGIC);
        assert!(Model::view(bytemuck::cast_slice(&words)).is_some(), "an empty mesh is one");
        words[2] = 1;
        assert_eq!(Model::view(bytemuck::cast_slice(&words)), None);
    }
}
