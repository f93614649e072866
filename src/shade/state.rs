//! State that changes the pixel loop, as types.

mod counter;
mod depth_test;
mod states;

pub use counter::{Counter, Counting, Event, Stats, Uncounted};
pub use depth_test::{
    Always, AnyDepth, DepthTest, Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual, Off,
};
pub use states::{State, States};
