//! The surface of a group of triangles.

use std::path::PathBuf;
use std::prelude::rust_2021::*;

/// What a material file says about a surface, as far as it is used here.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Material {
    /// The name; empty for the triangles of a file that names none.
    pub name: String,
    /// Diffuse reflectance of red, green and blue, each within 0..=1 (`Kd`).
    pub diffuse: [f32; 3],
    /// The diffuse texture (`map_Kd`): a regular file in the folder of the model or below.
    pub texture: Option<PathBuf>,
}

impl Material {
    /// The light grey of triangles whose material is not described anywhere.
    pub const GREY: [f32; 3] = [0.8; 3];

    /// A grey surface called `name`.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self { name: name.to_owned(), diffuse: Self::GREY, texture: None }
    }

    /// [`diffuse`](Self::diffuse) with 8 bits a channel, to the nearest.
    #[must_use]
    pub fn diffuse_rgb8(&self) -> [u8; 3] {
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "0..=1 times 255 fits, and a float cast saturates"
        )]
        self.diffuse.map(|c| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8)
    }
}
