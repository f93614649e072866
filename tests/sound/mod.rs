//! What every loaded model promises.

use microraster::host::Model;

/// Panics unless `model` keeps the promises of its documentation.
#[track_caller]
pub(crate) fn assert_sound(model: &Model) {
    assert!(model.triangle_count() > 0, "a triangle");
    assert!(model.positions.iter().flatten().all(|c| c.is_finite()), "finite");
    assert!(model.texture_coordinates.iter().flatten().all(|c| c.is_finite()), "finite");
    for normal in &model.normals {
        let length = normal.iter().map(|c| c * c).sum::<f32>();
        assert!((length - 1.0).abs() < 1e-5, "{normal:?} has length 1");
    }
    for corner in model.groups.iter().flat_map(|group| group.triangles.iter().flatten()) {
        assert!((corner.position as usize) < model.positions.len(), "{corner:?}");
        assert!((corner.normal as usize) < model.normals.len(), "{corner:?}");
        let uv = corner.texture.map_or(0, |uv| uv as usize + 1);
        assert!(uv <= model.texture_coordinates.len(), "{corner:?}");
    }
}
