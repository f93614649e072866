//! Colours: what a user writes, what the loops carry, what the display holds.
//!
//! | type | what it is |
//! | --- | --- |
//! | [`Rgb`] | 8 bits a channel: what users write |
//! | [`Rgb16`] | 8.8 bits a channel: what lighting gives to a vertex |
//! | [`Color`] | 16 bits a channel packed in two words: what fragments are made of |
//! | [`Format`] | how a display stores a pixel: [`Rgb565`], [`Rgb565Be`], [`Rgba8888`], or your own |
//!
//! One map leads from 8 bits to every format: a channel `v` is carried as `v + 1/2` and cut off,
//! so that flat and interpolated colours of the same value give the same bits.

mod fade;
mod fill;
mod format;
mod lanes;
mod packed;
mod pairs;
mod rgb;
mod rgb16;
mod rgb565;
mod rgb565_be;
mod rgba8888;

pub(crate) use fill::{fill_halves, fill_words};
pub use format::Format;
pub(crate) use lanes::{Channel, HAS_VECTORS, LANES};
pub use lanes::{ChannelLanes, ColorLanes};
pub use packed::Color;
pub(crate) use packed::{rounded, EIGHTS, HALF};
pub(crate) use pairs::{add_to_pairs, multiply_pairs, subtract_from_pairs};
pub use rgb::Rgb;
pub use rgb16::Rgb16;
pub use rgb565::Rgb565;
pub use rgb565_be::Rgb565Be;
pub use rgba8888::Rgba8888;
