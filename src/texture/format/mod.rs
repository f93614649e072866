//! How texels are stored, beside the formats that frames have too.

mod alpha8;
mod bytes;
mod indexed4;
mod indexed8;
mod luminance8;
mod rgb565;
mod rgba4444;
mod rgba5551;
mod rgba8888;

pub use alpha8::Alpha8;
pub use bytes::{Bgr888, Bgra8888, BigEndian, LittleEndian, Rgb888};
pub use indexed4::Indexed4;
pub use indexed8::Indexed8;
pub use luminance8::Luminance8;
pub use rgba4444::Rgba4444;
pub use rgba5551::Rgba5551;

use crate::color::Color;

/// The colour of four 8-bit channels.
#[inline(always)]
const fn with_alpha(r: u32, g: u32, b: u32, a: u32) -> Color {
    Color {
        blue_red: (b << 24) | (r << 8) | 0x0080_0080,
        green: (g << 24) | 0x0080_0000 | (a << 8) | a,
    }
}
