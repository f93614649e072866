//! What holds of every model, whatever the file.

use microraster::host::{MeshData, Model};

/// Fails where a model is not what `Model` says it is.
pub(crate) fn check(model: &Model) {
    assert!(model.triangle_count() > 0, "a model has triangles");
    assert!(model.positions.iter().flatten().all(|v| v.is_finite()), "positions");
    assert!(model.texture_coordinates.iter().flatten().all(|v| v.is_finite()), "textures");
    for normal in &model.normals {
        let length = normal.iter().map(|v| f64::from(*v).powi(2)).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 1e-5, "a normal of length {length}");
    }
    for group in &model.groups {
        assert!(!group.triangles.is_empty(), "a group has triangles");
        assert!(group.material.diffuse.iter().all(|v| (0.0..=1.0).contains(v)), "a reflectance");
        for corner in group.triangles.iter().flatten() {
            assert!((corner.position as usize) < model.positions.len(), "a position's index");
            assert!((corner.normal as usize) < model.normals.len(), "a normal's index");
            let texture = corner.texture.unwrap_or(0) as usize;
            let known = corner.texture.is_none() || texture < model.texture_coordinates.len();
            assert!(known, "a texture coordinate's index");
        }
    }
    assert!(model.warnings.len() <= 65, "no more warnings than are read");
    for by_face in [false, true] {
        for part in MeshData::of_model(model, by_face) {
            let vertices = part.positions.len();
            assert!(part.indices.iter().all(|i| usize::from(*i) < vertices), "an index");
            assert!(part.scale.is_finite() && part.offset.is_finite(), "a box");
        }
    }
}
