use core::fmt;

/// Why buffers do not make a frame: what was needed and what came.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FrameError {
    /// A picture without pixels.
    Empty,
    /// Width or height above [`MAX_SIDE`](super::MAX_SIDE).
    TooLarge {
        /// The side that came.
        got: u32,
    },
    /// Rows would overlap: the stride is shorter than the width.
    Stride {
        /// The width.
        needed: u32,
        /// The stride that came.
        got: u32,
    },
    /// The colour buffer is too short.
    Color {
        /// Pixels needed.
        needed: u32,
        /// Pixels that came.
        got: u32,
    },
    /// The depth buffer is too short.
    Depth {
        /// Codes needed.
        needed: u32,
        /// Codes that came.
        got: u32,
    },
    /// The stencil buffer is too short.
    Stencil {
        /// Values needed.
        needed: u32,
        /// Values that came.
        got: u32,
    },
    /// The band does not lie inside the picture.
    Band {
        /// Rows that the picture would need.
        needed: u32,
        /// Rows that the picture has.
        got: u32,
    },
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Empty => f.write_str("a frame needs at least one pixel"),
            Self::TooLarge { got } => {
                write!(f, "a side of {got} pixels exceeds {}", super::MAX_SIDE)
            }
            Self::Stride { needed, got } => {
                write!(f, "rows of {needed} pixels do not fit a stride of {got}")
            }
            Self::Color { needed, got } => {
                write!(f, "the colour buffer needs {needed} pixels and has {got}")
            }
            Self::Depth { needed, got } => {
                write!(f, "the depth buffer needs {needed} codes and has {got}")
            }
            Self::Stencil { needed, got } => {
                write!(f, "the stencil buffer needs {needed} values and has {got}")
            }
            Self::Band { needed, got } => {
                write!(f, "the band needs a picture of {needed} rows, it has {got}")
            }
        }
    }
}

impl core::error::Error for FrameError {}
