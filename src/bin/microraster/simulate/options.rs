//! The values of the options of `simulate`.

use clap::ValueEnum;
use std::str::FromStr;

/// Width and height of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PictureSize {
    pub(crate) width: u16,
    pub(crate) height: u16,
}

impl PictureSize {
    /// The largest width and height.
    const LARGEST: u16 = microraster::MAX_SIDE;

    pub(crate) fn pixels(self) -> usize {
        usize::from(self.width) * usize::from(self.height)
    }
}

impl FromStr for PictureSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let side = |text: &str| {
            let side = text.parse::<u16>().ok()?;
            (1..=Self::LARGEST).contains(&side).then_some(side)
        };
        text.split_once(['x', 'X'])
            .and_then(|(width, height)| Some(Self { width: side(width)?, height: side(height)? }))
            .ok_or_else(|| {
                let largest = Self::LARGEST;
                format!("write it like 320x240, each side 1 to {largest}")
            })
    }
}

/// The pixel format of the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// 16 bits: 5 red, 6 green, 5 blue, in the order of the processor
    Rgb565,
    /// The same with bytes swapped, as SPI panels want them
    Rgb565be,
    /// 32 bits: red, green, blue, alpha
    Rgba8888,
}

impl Format {
    pub(crate) fn bytes_per_pixel(self) -> usize {
        match self {
            Self::Rgb565 | Self::Rgb565be => 2,
            Self::Rgba8888 => 4,
        }
    }
}

/// Where light is computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Shade {
    /// Once a face, from its own normal
    Flat,
    /// At each corner, blended over the face
    Gouraud,
}

/// Whether something is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Switch {
    On,
    Off,
}

/// How the pixels of a triangle are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Traversal {
    /// First and last pixel of each row, computed: what firmware does
    Spans,
    /// Every pixel of the bounding box, tested
    Box,
    /// Blocks of 4x4 pixels, accepted or rejected as a whole where possible
    Blocks,
    /// From a corner row by row, both ways
    Walk,
}

/// Which faces are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Cull {
    None,
    Back,
    Front,
}
