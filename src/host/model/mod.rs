//! Models in: triangles with materials, from `.asc` and `.obj` files.

mod asc;
mod bounds;
mod builder;
mod corner;
#[cfg(feature = "tools")]
mod corner_grid;
mod error;
mod group;
mod lines;
mod material;
#[cfg(feature = "tools")]
mod mtl;
#[cfg(feature = "tools")]
mod obj;
#[cfg(feature = "tools")]
mod obj_checker;
#[cfg(feature = "tools")]
mod obj_text;
mod teapot;
#[cfg(feature = "tools")]
mod triangulate;
mod vector;
mod warning;

pub use bounds::Bounds;
pub use corner::Corner;
pub use error::ModelError;
pub use group::Group;
pub use material::Material;
pub use warning::ModelWarning;

use lines::Lines;
use std::format;
use std::io::BufRead;
use std::path::Path;
use std::prelude::rust_2021::*;
use vector::{cross, sub, unit, wide};

/// A model: lists of attributes, and triangles by material whose corners index them.
///
/// Whatever the file, these hold: there is at least one triangle; every index is in range;
/// positions and texture coordinates are finite; normals have length 1.
///
/// # Normals
///
/// Where the file gives none, or one without direction, a corner gets the mean of the triangles
/// around its position, weighted by their area.
///
/// # Range
///
/// Hostile input costs bounded time and memory: a file has at most 256 MiB, a line 4 MiB, a
/// model 2^20 positions, normals, texture coordinates and triangles; beyond, it is refused.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Model {
    /// The distinct positions that triangles use, in the units of the file.
    pub positions: Vec<[f32; 3]>,
    /// Distinct normals of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Distinct texture coordinates, u to the right and v up, as in the file.
    pub texture_coordinates: Vec<[f32; 2]>,
    /// The triangles by material, in the order of their first use; none is empty.
    pub groups: Vec<Group>,
    /// What was left out or made up; at most 65.
    pub warnings: Vec<ModelWarning>,
}

impl Model {
    /// How many values of a kind, and how many triangles, a model may have.
    pub const LIMIT: usize = 1 << 20;

    /// Loads the file at `path`: a triangle soup if its name ends in `.asc`, otherwise an OBJ
    /// file, which takes feature `tools`.
    ///
    /// # OBJ
    ///
    /// Faces of any number of corners, concave ones too, become triangles. Of the materials,
    /// name, `Kd` and `map_Kd` count; a library that is missing is a warning. Names of libraries
    /// and textures are relative, and only regular files of the model's folder are opened.
    /// Lines, points, curves and unknown keywords are left out with a warning, so are faces of
    /// fewer than three corners, and faces with a position that is infinite or no number. An
    /// index that is 0 or refers to what has not been read yet is an error.
    ///
    /// # The soup
    ///
    /// The word `triangle`, then three times `x y z nx ny nz u v`; and so on. White space
    /// separates, `#` starts a comment.
    ///
    /// # Errors
    ///
    /// The file cannot be read, is no model, or holds no triangle; the error says where and what
    /// to do.
    pub fn load(path: impl AsRef<Path>) -> Result<Self, ModelError> {
        let path = path.as_ref();
        let file = lines::open(path, Lines::LARGEST_FILE).map_err(|reason| {
            ModelError::new(path, None, reason, "name a readable OBJ or ASC file")
        })?;
        if is_soup(path) {
            Self::read_asc(file, path)
        } else {
            read_obj(file, path)
        }
    }

    /// Reads a triangle soup from `reader`; `path` stands in errors.
    ///
    /// ```
    /// use microraster::host::Model;
    ///
    /// # fn main() -> Result<(), microraster::host::ModelError> {
    /// let text = "triangle
    ///     0 0 0  0 0 1  0 0
    ///     1 0 0  0 0 1  1 0
    ///     0 1 0  0 0 1  0 1";
    /// let model = Model::read_asc(text.as_bytes(), "one.asc")?;
    /// assert_eq!(model.triangle_count(), 1);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    ///
    /// As of [`load`](Self::load).
    pub fn read_asc(reader: impl BufRead, path: impl AsRef<Path>) -> Result<Self, ModelError> {
        asc::read(reader, path.as_ref())
    }

    /// Reads an OBJ file from `reader`; `path` stands in errors, and its folder is that of the
    /// material libraries.
    ///
    /// # Errors
    ///
    /// As of [`load`](Self::load).
    #[cfg(feature = "tools")]
    pub fn read_obj(reader: impl BufRead, path: impl AsRef<Path>) -> Result<Self, ModelError> {
        obj::read(reader, path.as_ref())
    }

    /// How many triangles there are in all groups, those without area included.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.groups.iter().map(|group| group.triangles.len()).sum()
    }

    /// The box around all positions.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        // A loaded model has positions; one that a caller emptied has a box of no size.
        Bounds::of(&self.positions).unwrap_or(Bounds { min: [0.0; 3], max: [0.0; 3] })
    }

    /// The normal of the plane of `triangle`, towards the side from which its corners are
    /// counter-clockwise; `None` if it has no area or refers to positions that do not exist.
    #[must_use]
    pub fn face_normal(&self, triangle: &[Corner; 3]) -> Option<[f32; 3]> {
        let [a, b, c] = triangle.map(|corner| self.positions.get(corner.position as usize));
        let (a, b, c) = (wide(*a?), wide(*b?), wide(*c?));
        unit(cross(sub(b, a), sub(c, a)))
    }
}

fn is_soup(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("asc"))
}

#[cfg(feature = "tools")]
fn read_obj(reader: impl BufRead, path: &Path) -> Result<Model, ModelError> {
    obj::read(reader, path)
}

#[cfg(not(feature = "tools"))]
fn read_obj(_reader: impl BufRead, path: &Path) -> Result<Model, ModelError> {
    Err(ModelError::new(path, None, "this build reads no OBJ files", "build with feature `tools`"))
}

/// The error of a list that grows beyond [`Model::LIMIT`].
fn too_many(path: &Path, line: usize, what: &str) -> ModelError {
    ModelError::new(path, line, format!("more than {} {what}", Model::LIMIT), "simplify the model")
}
