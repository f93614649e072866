//! Exact, lean 3D rendering for microcontroller displays.
#![no_std]
#![forbid(unsafe_code)]

#[cfg(feature = "std")]
extern crate std;

pub mod math;
pub mod models;

#[cfg(feature = "std")]
pub mod host;
