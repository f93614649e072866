//! Exact, lean 3D rendering for microcontroller displays.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

pub mod color;
#[cfg(feature = "embedded-graphics")]
mod eg;
pub mod frame;
pub mod math;
pub mod models;
pub mod pipeline;
pub mod raster;
pub mod scene;
pub mod shade;

#[cfg(feature = "std")]
pub mod host;

pub use color::{Color, Format, Rgb, Rgb16, Rgb565, Rgb565Be, Rgba8888};
#[cfg(feature = "embedded-graphics")]
pub use eg::DrawFormat;
pub use frame::{DepthBuffer, Frame, FrameError, NoDepth, Rect, Size, MAX_SIDE};
pub use pipeline::{Clip, Cull, Pass, ScreenPass, ShadedVertex, VertexCache, Winding};
pub use scene::{normal, Camera, Indices, Light, Mesh, Normal};
pub use shade::{
    Always, AnyDepth, Coloring, Corner, Counter, Counting, DepthTest, DrawContext, Equal, Flat,
    FlatColor, Gouraud, Greater, GreaterEqual, Lambert, Less, LessEqual, NotEqual, Off, Row,
    Scalar, Shader, SmoothColor, Solid, State, States, Stats, Uncounted, Varying, VertexColors,
};
