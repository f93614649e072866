//! A model while it is read: lists without duplicates, and normals made at the end.

use super::vector::{add, cross, sub, unit, wide, Vector};
use super::{Corner, Group, Material, Model};
use std::collections::HashMap;
use std::prelude::rust_2021::*;
use std::vec;

/// A corner as read: its normal may be missing.
#[derive(Clone, Copy, Debug)]
pub(super) struct RawCorner {
    pub(super) position: u32,
    pub(super) normal: Option<u32>,
    pub(super) texture: Option<u32>,
}

/// Gathers vertices and triangles; equal positions, normals and texture coordinates become one,
/// so that a vertex on a material seam is transformed once and shaded alike on both sides.
#[derive(Debug, Default)]
pub(super) struct Builder {
    positions: Distinct<3>,
    normals: Distinct<3>,
    texture_coordinates: Distinct<2>,
    groups: Vec<(Material, Vec<[RawCorner; 3]>)>,
}

impl Builder {
    /// The index of a position, which must be finite.
    pub(super) fn position(&mut self, position: [f32; 3]) -> u32 {
        self.positions.index(position)
    }

    /// The index of a normal, normalised; `None` if it has no direction.
    pub(super) fn normal(&mut self, normal: [f32; 3]) -> Option<u32> {
        unit(wide(normal)).map(|normal| self.normals.index(normal))
    }

    /// The index of a texture coordinate.
    pub(super) fn texture(&mut self, uv: [f32; 2]) -> u32 {
        self.texture_coordinates.index(uv)
    }

    /// The number of a new group of triangles of `material`.
    pub(super) fn group(&mut self, material: Material) -> usize {
        self.groups.push((material, Vec::new()));
        self.groups.len() - 1
    }

    pub(super) fn triangle(&mut self, group: usize, corners: [RawCorner; 3]) {
        if let Some((_, triangles)) = self.groups.get_mut(group) {
            triangles.push(corners);
        }
    }

    /// The model, without warnings. Corners without a normal get the area-weighted mean of the
    /// triangles around their position.
    pub(super) fn finish(mut self) -> Model {
        let missing = self
            .groups
            .iter()
            .flat_map(|(_, triangles)| triangles.iter().flatten())
            .any(|corner| corner.normal.is_none());
        let sums = if missing { self.normal_sums() } else { Vec::new() };

        let mut groups = Vec::new();
        for (material, triangles) in core::mem::take(&mut self.groups) {
            if triangles.is_empty() {
                continue;
            }
            let triangles = triangles
                .into_iter()
                .map(|triangle| {
                    triangle.map(|corner| Corner {
                        position: corner.position,
                        normal: corner
                            .normal
                            .unwrap_or_else(|| self.made_normal(&sums, corner, triangle)),
                        texture: corner.texture,
                    })
                })
                .collect();
            groups.push(Group { material, triangles });
        }
        Model {
            positions: self.positions.values,
            normals: self.normals.values,
            texture_coordinates: self.texture_coordinates.values,
            groups,
            warnings: Vec::new(),
        }
    }

    /// For each position the sum of the normals of its triangles, each as long as twice the
    /// triangle's area: that is the weight.
    fn normal_sums(&self) -> Vec<Vector> {
        let mut sums = vec![[0.0; 3]; self.positions.values.len()];
        for triangle in self.groups.iter().flat_map(|(_, triangles)| triangles) {
            let normal = self.area_normal(triangle);
            for corner in triangle {
                if let Some(sum) = sums.get_mut(corner.position as usize) {
                    *sum = add(*sum, normal);
                }
            }
        }
        sums
    }

    fn area_normal(&self, triangle: &[RawCorner; 3]) -> Vector {
        let [a, b, c] = triangle.map(|corner| wide(self.positions.get(corner.position)));
        cross(sub(b, a), sub(c, a))
    }

    /// The smooth normal; where opposite faces cancel the face's own; where that has no area z.
    fn made_normal(&mut self, sums: &[Vector], corner: RawCorner, triangle: [RawCorner; 3]) -> u32 {
        let normal = sums
            .get(corner.position as usize)
            .and_then(|&sum| unit(sum))
            .or_else(|| unit(self.area_normal(&triangle)))
            .unwrap_or([0.0, 0.0, 1.0]);
        self.normals.index(normal)
    }
}

/// A list in which every value occurs once.
#[derive(Debug, Default)]
struct Distinct<const N: usize> {
    values: Vec<[f32; N]>,
    known: HashMap<Bits<N>, u32>,
}

/// The bits of `N` floats: what makes them equal.
type Bits<const N: usize> = [u32; N];

impl<const N: usize> Distinct<N> {
    fn index(&mut self, value: [f32; N]) -> u32 {
        // Adding 0 turns -0 into 0: they are one place.
        let value = value.map(|component| component + 0.0);
        let next = u32::try_from(self.values.len()).unwrap_or(u32::MAX);
        let values = &mut self.values;
        *self.known.entry(value.map(f32::to_bits)).or_insert_with(|| {
            values.push(value);
            next
        })
    }

    fn get(&self, index: u32) -> [f32; N] {
        self.values.get(index as usize).copied().unwrap_or([0.0; N])
    }
}
