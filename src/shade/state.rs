//! State that changes the pixel loop, as types.

mod blend;
mod color_mask;
mod counter;
mod depth_state;
mod depth_test;
mod dither;
mod output;
mod states;

pub use blend::{
    Add, Alpha, AnyBlend, Average, Blend, ConstantAlpha, Multiply, Premultiplied, Replace, Subtract,
};
pub use color_mask::{AllChannels, AnyMask, Channels, ColorMask};
pub use counter::{Counter, Counting, Event, Stats, Uncounted};
pub use depth_state::{AnyDepthState, ConstantDepth, DepthRange, PolygonOffset, ReadOnly};
pub use depth_test::{
    Always, AnyDepth, DepthTest, Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual, Off,
};
pub use dither::{AnyDither, Dither, Dither4, Dither8, Undithered};
pub use output::{ColorOutput, Output};
pub use states::{State, States};
