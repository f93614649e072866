//! The picture that is drawn: a display's memory.

use super::options::{Format, PictureSize};
use microraster::host::{Tga, TgaError};
use std::io::Write;

/// The memory of a display, and what was counted while it was drawn.
#[derive(Debug)]
pub(crate) struct Picture {
    pub(crate) size: PictureSize,
    pub(crate) format: Format,
    /// The colour bytes in memory order, row by row from the top.
    pub(crate) bytes: Vec<u8>,
    /// Triangles that reached the rasterizer.
    pub(crate) drawn: u64,
    /// Triangles that were cut, drawn or not.
    pub(crate) clipped: u64,
    /// Pixels written, each time.
    pub(crate) pixels: u64,
}

impl Picture {
    /// A picture whose bytes are all zero.
    pub(crate) fn new(size: PictureSize, format: Format) -> Self {
        Self {
            size,
            format,
            bytes: vec![0; size.pixels() * format.bytes_per_pixel()],
            drawn: 0,
            clipped: 0,
            pixels: 0,
        }
    }

    /// Writes what the display shows: opaque, with 8 bits a channel.
    pub(crate) fn write_tga(&self, output: impl Write) -> Result<(), TgaError> {
        let Self { size, format, .. } = *self;
        Tga::new(size.width.into(), size.height.into())?.write_with(output, |x, y| {
            let at = usize::from(y) * usize::from(size.width) + usize::from(x);
            let bytes = format.bytes_per_pixel();
            match self.bytes.get(at * bytes..(at + 1) * bytes) {
                Some(&[a, b]) if format == Format::Rgb565 => expand(u16::from_ne_bytes([a, b])),
                Some(&[a, b]) => expand(u16::from_be_bytes([a, b])),
                Some(&[red, green, blue, _]) => [red, green, blue, 255],
                _ => [0; 4],
            }
        })
    }
}

/// The colour of an RGB565 pixel with 8 bits a channel, the upper bits repeated below.
fn expand(pixel: u16) -> [u8; 4] {
    let channel = |shift: u32, bits: u32| {
        let value = u32::from(pixel >> shift) & ((1 << bits) - 1);
        let wide = (value << (8 - bits)) | (value >> (2 * bits - 8));
        wide.to_le_bytes()[0]
    };
    [channel(11, 5), channel(5, 6), channel(0, 5), 255]
}
