//! OBJ files: checked line by line, read by `tobj`, triangulated.

use super::builder::{Builder, RawCorner};
use super::lines::quoted;
use super::obj_text::ObjText;
use super::triangulate::Triangulator;
use super::{mtl, Material, Model, ModelError};
use std::format;
use std::io::BufRead;
use std::path::Path;
use std::prelude::rust_2021::*;
use std::vec;

pub(super) fn read(reader: impl BufRead, path: &Path) -> Result<Model, ModelError> {
    let mut text = ObjText::new(reader, path);
    // The checked text names no library: `tobj` has nothing to open.
    let nothing = |_: &Path| Err(tobj::LoadError::OpenFileFailed);
    let read = tobj::load_obj_buf(&mut text, &tobj::LoadOptions::default(), nothing);
    let last = text.line();
    let meshes = match (read, text.failure.take()) {
        (Ok((meshes, _)), None) => meshes,
        (_, Some(failure)) => return Err(failure),
        (Err(error), None) => {
            let reason = format!("the OBJ reader stopped ({error})");
            return Err(ModelError::new(path, last, reason, "check the file"));
        }
    };

    // Look up the materials; those that no library describes are grey.
    let mut checked = text.into_checker();
    let known = mtl::read_all(path, &checked.libraries, &mut checked.warnings);
    let mut builder = Builder::default();
    for name in &checked.materials {
        let material = known.get(name).cloned().unwrap_or_else(|| {
            if !name.is_empty() {
                let reason = format!("no library describes {}; it is grey", quoted(name));
                checked.warnings.push(path, None, reason);
            }
            Material::named(name)
        });
        builder.group(material);
    }

    let mut triangulator = Triangulator::new();
    for mesh in meshes {
        let group = mesh.name.parse().unwrap_or_default();
        add(&mut builder, &mut triangulator, group, &mesh.mesh);
    }
    if triangulator.is_exhausted() {
        let reason = "faces are too intricate; some may have a wrong outline";
        checked.warnings.push(path, None, reason);
    }
    let mut model = builder.finish();
    if model.groups.is_empty() {
        return Err(ModelError::new(
            path,
            last,
            "the file ends without a face that can be drawn",
            "check that this is the file you meant, and that it holds faces (f)",
        ));
    }
    model.warnings = checked.warnings.into_vec(path);
    Ok(model)
}

/// Adds the faces of one mesh to a group.
fn add(builder: &mut Builder, triangulator: &mut Triangulator, group: usize, mesh: &tobj::Mesh) {
    // The numbers in the model of the mesh's attributes, found when first used.
    let mut positions = vec![None; mesh.positions.len() / 3];
    let normals = triples(&mesh.normals).map(|normal| builder.normal(normal));
    let normals: Vec<Option<u32>> = normals.collect();
    let textures = pairs(&mesh.texcoords).map(|uv| finite(uv).map(|uv| builder.texture(uv)));
    let textures: Vec<Option<u32>> = textures.collect();

    let triangles_only = core::iter::repeat_n(3, mesh.indices.len() / 3);
    let arities = mesh.face_arities.iter().map(|&arity| arity as usize);
    let all_triangles = mesh.face_arities.is_empty();
    let arities = arities.chain(triangles_only.take(if all_triangles { usize::MAX } else { 0 }));

    let mut start = 0;
    let mut corners = Vec::new();
    let mut outline = Vec::new();
    for arity in arities {
        let face = start..start + arity;
        start += arity;

        // A face with a position that is infinite or no number is left out.
        let index = |list: &[u32], corner| list.get(corner).map_or(usize::MAX, |&at| at as usize);
        outline.clear();
        outline.extend(face.clone().map_while(|corner| {
            triple(&mesh.positions, index(&mesh.indices, corner)).and_then(finite)
        }));
        if outline.len() < arity {
            continue;
        }

        corners.clear();
        for (corner, &position) in face.zip(&outline) {
            let Some(known) = positions.get_mut(index(&mesh.indices, corner)) else {
                continue;
            };
            let normal = index(&mesh.normal_indices, corner);
            let texture = index(&mesh.texcoord_indices, corner);
            corners.push(RawCorner {
                position: *known.get_or_insert_with(|| builder.position(position)),
                normal: normals.get(normal).copied().flatten(),
                texture: textures.get(texture).copied().flatten(),
            });
        }
        for triangle in triangulator.triangles(&outline) {
            if let [Some(&a), Some(&b), Some(&c)] = triangle.map(|index| corners.get(index)) {
                builder.triangle(group, [a, b, c]);
            }
        }
    }
}

fn finite<const N: usize>(vector: [f32; N]) -> Option<[f32; N]> {
    vector.iter().all(|c| c.is_finite()).then_some(vector)
}

fn triples(list: &[f32]) -> impl Iterator<Item = [f32; 3]> + '_ {
    list.chunks_exact(3).filter_map(|chunk| chunk.try_into().ok())
}

fn pairs(list: &[f32]) -> impl Iterator<Item = [f32; 2]> + '_ {
    list.chunks_exact(2).filter_map(|chunk| chunk.try_into().ok())
}

fn triple(list: &[f32], index: usize) -> Option<[f32; 3]> {
    let start = index.checked_mul(3)?;
    list.get(start..start.checked_add(3)?)?.try_into().ok()
}
