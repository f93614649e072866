use std::collections::HashMap;
use std::vec::Vec;

use super::{Corner, Model};
use crate::color::Rgb;
use crate::math::Vec3;
use crate::scene::{normal, FacePlane, FacePlanes, IndexedList, Mesh, Normal, PlaneScale};

/// A part of a model in the form that firmware holds in flash: 16-bit positions, 8-bit normals,
/// 16-bit indices, one material.
///
/// Positions of all parts of a model share one box, so that parts that touch still do.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshData {
    /// The material's diffuse colour.
    pub color: Rgb,
    /// Positions in steps of `scale`.
    pub positions: Vec<[i16; 3]>,
    /// One normal a vertex, or one a triangle where `by_face` says so.
    pub normals: Vec<Normal>,
    /// Three a triangle.
    pub indices: Vec<u16>,
    /// Whether normals belong to triangles.
    pub by_face: bool,
    /// What one step of a position is in model space.
    pub scale: f32,
    /// Where position 0 lies in model space.
    pub offset: Vec3,
}

/// Steps from the middle of the box to its farthest side.
const STEPS: f32 = 32_767.0;

impl MeshData {
    /// The parts of a model, split where materials change and where 65 536 vertices are full.
    ///
    /// With `by_face` each triangle has the normal of its plane, otherwise each vertex its own.
    ///
    /// # Rounding
    /// Positions to the nearest of 65 535 steps of the longest side of the box.
    #[allow(
        clippy::cast_possible_truncation,
        reason = "positions are in the box and vertices are counted"
    )]
    pub fn of_model(model: &Model, by_face: bool) -> Vec<Self> {
        let bounds = model.bounds();
        // Halves first: the difference of two ends of the range would overflow.
        let middle = [0, 1, 2].map(|axis| bounds.min[axis] / 2.0 + bounds.max[axis] / 2.0);
        let halves = [0, 1, 2].map(|axis| bounds.max[axis] / 2.0 - bounds.min[axis] / 2.0);
        let half = halves.into_iter().fold(0.0, f32::max);
        let scale = if half > 0.0 { half / STEPS } else { 1.0 };
        let blank = Self {
            color: Rgb::WHITE,
            positions: Vec::new(),
            normals: Vec::new(),
            indices: Vec::new(),
            by_face,
            scale,
            offset: middle.into(),
        };
        let quantize = |point: [f32; 3]| {
            // `as` saturates, and what is no number becomes the middle.
            [0, 1, 2].map(|axis| ((point[axis] - middle[axis]) / scale).round() as i16)
        };
        let mut parts = Vec::new();
        for group in &model.groups {
            let [r, g, b] = group.material.diffuse_rgb8();
            let blank = Self { color: Rgb::new(r, g, b), ..blank.clone() };
            let mut part = blank.clone();
            let mut known = HashMap::new();
            for triangle in &group.triangles {
                if part.positions.len() + 3 > 1 << 16 {
                    parts.push(core::mem::replace(&mut part, blank.clone()));
                    known.clear();
                }
                for corner in triangle {
                    let position = model.positions.get(corner.position as usize).copied();
                    let shared = if by_face { 0 } else { corner.normal };
                    let index = *known.entry((corner.position, shared)).or_insert_with(|| {
                        part.positions.push(quantize(position.unwrap_or(middle)));
                        if !by_face {
                            part.normals.push(vertex_normal(model, corner));
                        }
                        // At most 65 536 vertices were let in.
                        (part.positions.len() - 1) as u16
                    });
                    part.indices.push(index);
                }
                if by_face {
                    let face = model.face_normal(triangle).unwrap_or_default();
                    part.normals.push(normal(face.into()));
                }
            }
            if !part.indices.is_empty() {
                parts.push(part);
            }
        }
        parts
    }

    /// The planes of the triangles, for firmware to hold beside them, and what they are made for.
    ///
    /// ```
    /// use microraster::host::{MeshData, Model};
    /// use microraster::FacePlanes;
    ///
    /// for part in MeshData::of_model(&Model::teapot(4), false) {
    ///     let (planes, scale) = part.planes();
    ///     let mesh = part.mesh().with_planes(FacePlanes::new(&planes, scale));
    ///     # assert_eq!(planes.len(), mesh.triangles() as usize);
    /// }
    /// ```
    pub fn planes(&self) -> (Vec<FacePlane>, PlaneScale) {
        let scale = PlaneScale::of(&self.positions, &self.indices);
        let position = |index: u16| self.positions.get(usize::from(index)).copied();
        let planes = self.indices.as_chunks().0.iter().map(|&[a, b, c]| {
            match (position(a), position(b), position(c)) {
                (Some(a), Some(b), Some(c)) => scale.plane([a, b, c]),
                _ => FacePlanes::NO_PLANE,
            }
        });
        (planes.collect(), scale)
    }

    /// The part as a mesh.
    pub fn mesh(&self) -> Mesh<'_, Normal, IndexedList<'_, u16>> {
        let mesh = Mesh::new(&self.positions, &self.normals)
            .indexed(&self.indices)
            .placed(Vec3::splat(self.scale), self.offset);
        if self.by_face {
            mesh.by_face()
        } else {
            mesh
        }
    }
}

/// The normal of a corner.
fn vertex_normal(model: &Model, corner: &Corner) -> Normal {
    let direction = model.normals.get(corner.normal as usize).copied().unwrap_or_default();
    normal(direction.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_teapot_keeps_its_triangles_and_its_box() {
        let model = Model::teapot(4);
        for by_face in [false, true] {
            let parts = MeshData::of_model(&model, by_face);
            let triangles: u32 = parts.iter().map(|part| part.mesh().triangles()).sum();
            assert_eq!(triangles as usize, model.triangle_count(), "all triangles");
            let largest = parts.iter().flat_map(|part| part.positions.iter().flatten());
            let largest = largest.map(|v| v.unsigned_abs()).max();
            assert_eq!(largest, Some(32_767), "the longest side uses the whole range");
        }
    }
}
