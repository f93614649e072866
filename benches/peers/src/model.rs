//! Meshes from files.

use anyhow::Context;

use crate::scene::{unit, Mesh};

/// The mesh of an OBJ file without normals: a vertex gets the mean of its triangles' by their areas.
pub(crate) fn read(path: &std::path::Path) -> anyhow::Result<Mesh> {
    let what = || format!("{} could not be read as a mesh", path.display());
    let options = tobj::LoadOptions { single_index: true, triangulate: true, ..Default::default() };
    let (models, _) = tobj::load_obj(path, &options).with_context(what)?;
    let mesh = &models.first().with_context(what)?.mesh;
    let positions: Vec<[f32; 3]> =
        mesh.positions.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    let triangles: Vec<[usize; 3]> =
        mesh.indices.chunks_exact(3).map(|t| core::array::from_fn(|at| t[at] as usize)).collect();
    let mut normals = vec![[0.0; 3]; positions.len()];
    for triangle in &triangles {
        let [a, b, c] = triangle.map(|index| positions[index]);
        let side = |to: [f32; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
        let (p, q) = (side(b), side(c));
        for index in triangle {
            normals[*index][0] += p[1] * q[2] - p[2] * q[1];
            normals[*index][1] += p[2] * q[0] - p[0] * q[2];
            normals[*index][2] += p[0] * q[1] - p[1] * q[0];
        }
    }
    let normals = normals.into_iter().map(unit).collect();
    Ok((positions, normals, triangles))
}
