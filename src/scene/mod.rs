//! What is drawn and how it is seen: meshes, lights, the camera.

mod camera;
mod light;
mod mesh;
mod normal;
mod topology;

pub use camera::Camera;
pub use light::{AnyLightKind, Attenuation, DirectionalLight, Light, PointLight, SpotLight};
pub use mesh::Mesh;
pub(crate) use mesh::Vertices;
pub use normal::{normal, Normal};
pub use topology::{
    AnyCursor, AnyTopology, Consecutive, FacePlane, FacePlanes, Facing, FanCursor, Index,
    IndexedList, Indices, LastProvoking, LineList, LineLoop, LineStrip, LineStripCursor, List,
    LoopCursor, NumberCursor, PlaneCursor, PlaneScale, Points, RestartIndices, Sequence, Step,
    StripCursor, Topology, TriangleFan, TriangleStrip, WithPlanes,
};
