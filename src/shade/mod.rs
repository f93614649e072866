//! Shaders: what a triangle's pixels are made of.
//!
//! A [`Shader`] is two short methods: [`vertex`](Shader::vertex) makes varyings of what the mesh
//! holds, [`fragment`](Shader::fragment) makes a colour of interpolated varyings. [`Flat`] and
//! [`Gouraud`] are users of the same trait; both take their colours from a [`Coloring`].

mod coloring;
mod constant;
mod cutout;
mod flat;
mod flat_color;
mod fog;
mod fogged;
mod gouraud;
mod interpolated;
mod lighting;
mod matcap;
mod perspective;
mod phong;
mod point_coordinates;
mod row;
mod row_blocks;
mod row_fill;
mod row_lanes;
mod scalar;
mod scalars;
mod shader;
mod smooth_color;
mod solid;
mod sprite;
mod state;
mod textured;
mod unlit;
mod uv;
mod varying;
mod vertex_colors;

pub use coloring::Coloring;
pub use constant::Constant;
pub use cutout::Cutout;
pub use flat::Flat;
pub use flat_color::FlatColor;
pub use fog::{Fog, FogDepth};
pub use fogged::{AtFragments, AtVertices, FogPlace, Fogged};
pub use gouraud::Gouraud;
pub use interpolated::{Interpolated, Words};
pub use lighting::{
    Beam, BlinnPhong, Lambert, LightKind, Lighting, PreparedAnyLight, PreparedBlinnPhong,
    PreparedLambert, PreparedPoint, PreparedSpot, Surface, Tinted,
};
pub use matcap::Matcap;
pub use perspective::{
    Adaptive, Affine, AffineValue, Every, Exact, ExactStep, ExactValue, Interval, Perspective,
    PerspectiveCorner, PerspectiveMode, PerspectivePlanes, PerspectiveVarying, Subspan,
    SubspanValue,
};
pub use phong::Phong;
pub use point_coordinates::PointCoordinates;
pub use row::Row;
pub use scalar::Scalar;
pub use scalars::{Scalars, ScalarsPlanes};
pub(crate) use shader::Bound;
pub use shader::{DrawContext, Fragments, Shader, VertexInput};
pub use smooth_color::{SmoothColor, SmoothColorPlanes};
pub use solid::Solid;
pub use sprite::Sprite;
pub use state::{
    Add, AllChannels, Alpha, Always, AnyBlend, AnyCompare, AnyDepth, AnyDepthState, AnyDither,
    AnyMask, AnyOperation, AnyStencil, Average, Blend, Channels, ColorMask, ColorOutput,
    ConstantAlpha, ConstantDepth, Counter, Counting, DecrementClamp, DecrementWrap, DepthRange,
    DepthTest, Dither, Dither4, Dither8, Equal, Event, Greater, GreaterEqual, IncrementClamp,
    IncrementWrap, Invert, Keep, Less, LessEqual, Multiply, Never, NotEqual, Off, Output,
    PolygonOffset, Premultiplied, ReadOnly, Replace, State, States, Stats, Stencil, StencilCompare,
    StencilOperation, Stenciled, Subtract, TestCell, Tracking, Uncounted, Undithered, Verdict,
    Zero,
};
pub use textured::Textured;
pub use unlit::Unlit;
pub use uv::{Uv, UvBase, UvPlanes, UvStep};
#[doc(hidden)]
pub use varying::Ready;
pub use varying::{Corner, Stepped, Varying};
pub use vertex_colors::VertexColors;
