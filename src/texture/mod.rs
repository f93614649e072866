//! Textures: pictures borrowed from flash, and the samplers that read them.
//!
//! | what | types |
//! | --- | --- |
//! | a picture | [`Texture`], [`MipMap`] with its smaller copies |
//! | how a texel is stored | [`TexelFormat`]: [`Rgb565`](crate::Rgb565), [`Rgba8888`](crate::Rgba8888), [`Rgba5551`], [`Rgba4444`], [`Luminance8`], [`Alpha8`], [`Indexed8`], [`Indexed4`], and [`Color`](crate::Color) itself; as bytes of files at any address [`LittleEndian`] and [`BigEndian`] of 16 bits, [`Rgb888`], [`Bgr888`], [`Bgra8888`] |
//! | what lies beyond the picture | [`Wrap`]: [`Repeat`], [`Mirror`], [`Clamp`], [`ClampAny`] |
//! | what lies between texels | [`Filter`]: [`Nearest`], [`Bilinear`], [`FineBilinear`] |
//! | how it meets the surface's colour | [`Environment`]: [`Modulate`], [`Replace`], [`Decal`], [`Add`] |
//! | all of it put together | [`Sampler`], [`MipSampler`] |
//!
//! # Coordinates
//! A vertex holds `u` and `v` as `i16`; a fragment has them as `i32` with 16 fraction bits, which
//! wrap. The texture's width (and height) is 2^k units, k being the sampler's
//! [`unit_bits`](Sampler::unit_bits). `u` runs to the right, `v` down: (0, 0) is the corner of the
//! first texel in memory.

mod any_sampler;
mod axis;
mod environment;
mod error;
mod filter;
mod footprint;
mod format;
mod mip_map;
mod mip_sampler;
mod sample;
mod sampler;
mod squares;
mod texel_format;
#[allow(clippy::module_inception, reason = "one public type a file, named after it")]
mod texture;
mod weights;
mod wrap;

pub use any_sampler::{AnySampler, AnyTexture};
pub use axis::Axis;
pub use environment::{Add, AnyEnvironment, Decal, Environment, Modulate, Replace};
pub use error::TextureError;
pub use filter::{AnyFilter, Bilinear, Filter, FineBilinear, Nearest};
pub use footprint::Footprint;
pub use format::{
    Alpha8, Bgr888, Bgra8888, BigEndian, Indexed4, Indexed8, LittleEndian, Luminance8, Rgb888,
    Rgba4444, Rgba5551,
};
pub use mip_map::{MipMap, Reduce};
pub use mip_sampler::MipSampler;
pub use sample::Sample;
pub use sampler::Sampler;
#[doc(hidden)]
pub use squares::Squares;
pub use texel_format::{PaletteEntry, TexelFormat};
pub use texture::Texture;
pub use weights::Weights;
pub use wrap::{AnyWrap, Clamp, ClampAny, Mirror, Repeat, Wrap};
