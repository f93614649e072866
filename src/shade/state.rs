//! State that changes the pixel loop, as types.

mod blend;
mod color_mask;
mod counter;
mod depth_state;
mod depth_test;
mod dither;
mod output;
mod states;
mod stencil;
mod stencil_compare;
mod stencil_operation;

pub use blend::{
    Add, Alpha, AnyBlend, Average, Blend, ConstantAlpha, Multiply, Premultiplied, Replace, Subtract,
};
pub use color_mask::{AllChannels, AnyMask, Channels, ColorMask};
pub use counter::{Counter, Counting, Event, Stats, Tracking, Uncounted};
pub use depth_state::{AnyDepthState, ConstantDepth, DepthRange, PolygonOffset, ReadOnly};
pub use depth_test::{
    Always, AnyDepth, DepthTest, Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual, Off,
    TestCell, Verdict,
};
pub use dither::{AnyDither, Dither, Dither4, Dither8, Undithered};
pub use output::{ColorOutput, Output};
pub use states::{State, States};
pub use stencil::{AnyStencil, Stencil, Stenciled};
pub use stencil_compare::{AnyCompare, Never, StencilCompare};
pub use stencil_operation::{
    AnyOperation, DecrementClamp, DecrementWrap, IncrementClamp, IncrementWrap, Invert, Keep,
    StencilOperation, Zero,
};
