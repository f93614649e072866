//! Exact, lean 3D rendering for microcontroller displays.
//!
//! Triangles, lines and points go into a buffer of the caller's, in fixed point, without `alloc`,
//! without `unsafe`, and with the same bits on every target. [`Pass`] has an example; the README's
//! is `examples/hello.rs`.
//!
//! # The way of a triangle
//!
//! | layer | what it does |
//! | --- | --- |
//! | [`scene`] | borrows a mesh from flash; says where it is seen from and what light falls on it |
//! | [`pipeline`] | transforms each vertex once, culls, clips: a [`Pass`] for meshes, a [`ScreenPass`] for what is on the screen already |
//! | [`raster`] | finds the covered pixels by exact integers, and the planes of what is interpolated |
//! | [`texture`] | reads pictures from flash: formats, wraps, filters, mip-maps |
//! | [`shade`] | asks a [`Shader`] for the colour of each pixel that passes the depth test |
//! | [`frame`], [`color`] | store it: formats, stride, bands, scissor |
//! | [`math`] | vectors, matrices, angles: the same bits everywhere |
//!
//! # Measured
//!
//! Whoever trades accuracy for speed should know the price: under this heading, the documentation
//! of each knob says what it costs in one scene and how far that picture is from the reference
//! renderer's. `cargo tradeoff` makes these lines, and docs/TRADEOFF.md, where all settings of all
//! scenes stand beside each other.
//!
//! # Features
//!
//! None is on by default, and none changes a type. `embedded-graphics` makes a [`Frame`] a draw
//! target for text and 2D, and a [`Band`] a drawing that its display drivers take; `defmt` lets
//! errors, sizes, rectangles and statistics be logged; `std` adds `host` (pictures, model files) and
//! more traversals; `tools` is what the host program `microraster` needs.
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
pub mod texture;

#[cfg(feature = "std")]
pub mod host;

pub use color::{Color, Format, Rgb, Rgb16, Rgb565, Rgb565Be, Rgba8888};
#[cfg(feature = "embedded-graphics")]
pub use eg::DrawFormat;
pub use frame::{
    Band, Bands, Damage, DepthBuffer, Frame, FrameError, NoDepth, Rect, Size, StencilBuffer,
    MAX_SIDE,
};
pub use pipeline::{
    Attenuated, Clip, Cull, DisplayList, LineStyle, ListError, ListTriangle, ListVertex, Midpoint,
    Pass, PointSize, Recording, Rectangle, ScreenPass, ShadedVertex, SizeOf, Smooth, Stippled,
    Supersampling, Thin, VertexCache, Wide, Winding,
};
pub use scene::{
    normal, AnyLightKind, AnyTopology, Attenuation, Camera, Consecutive, DirectionalLight,
    FacePlane, FacePlanes, IndexedList, Indices, LastProvoking, Light, LineList, LineLoop,
    LineStrip, List, Mesh, Normal, PlaneScale, PointLight, Points, RestartIndices, SpotLight,
    Topology, TriangleFan, TriangleStrip, WithPlanes,
};
pub use shade::{
    Adaptive, Add, Affine, AllChannels, Alpha, Always, AnyBlend, AnyCompare, AnyDepth,
    AnyDepthState, AnyDither, AnyMask, AnyOperation, AnyStencil, AtFragments, AtVertices, Average,
    Blend, BlinnPhong, Channels, ColorMask, ColorOutput, Coloring, Constant, ConstantAlpha,
    ConstantDepth, Corner, Counter, Counting, Cutout, DecrementClamp, DecrementWrap, DepthRange,
    DepthTest, Dither, Dither4, Dither8, DrawContext, Equal, Every, Exact, Flat, FlatColor, Fog,
    Fogged, Gouraud, Greater, GreaterEqual, IncrementClamp, IncrementWrap, Interpolated, Invert,
    Keep, Lambert, Less, LessEqual, LightKind, Lighting, Matcap, Multiply, Never, NotEqual, Off,
    Output, Perspective, PerspectiveCorner, PerspectiveMode, PerspectiveVarying, Phong,
    PointCoordinates, PolygonOffset, Premultiplied, ReadOnly, Replace, Row, Scalar, Scalars,
    Shader, SmoothColor, Solid, Sprite, State, States, Stats, Stencil, StencilCompare,
    StencilOperation, Stenciled, Stepped, Subtract, Surface, Textured, Tinted, Tracking, Uncounted,
    Undithered, Unlit, Uv, UvStep, Varying, VertexColors, VertexInput, Zero,
};

/// The README's example runs with the tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
