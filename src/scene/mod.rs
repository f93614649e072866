//! What is drawn and how it is seen: meshes, lights, the camera.

mod camera;
mod light;
mod mesh;
mod normal;

pub use camera::Camera;
pub use light::Light;
pub use mesh::{Indices, Mesh};
pub use normal::{normal, Normal};
