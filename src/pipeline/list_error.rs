use core::fmt;

use crate::frame::Size;

/// Why a [`DisplayList`](super::DisplayList) does not serve: nothing was drawn, and drawing the
/// mesh again is always possible.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ListError {
    /// More was to be recorded than it holds.
    Full {
        /// Vertices that it would take.
        vertices: u32,
        /// Triangles that it would take.
        triangles: u32,
    },
    /// It has fewer numbers for bands than there are bands.
    Bands {
        /// Bands from this one to the end of the picture.
        needed: u32,
        /// Numbers that came.
        got: u32,
    },
    /// The frame is of a picture of another size.
    Picture {
        /// The size that was recorded for.
        needed: Size,
        /// The frame's.
        got: Size,
    },
}

impl fmt::Display for ListError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Full { vertices, triangles } => {
                write!(f, "the list needs {vertices} vertices and {triangles} triangles")
            }
            Self::Bands { needed, got } => {
                write!(f, "the list needs numbers for {needed} bands and has {got}")
            }
            Self::Picture { needed, got } => write!(
                f,
                "the list is of a picture of {}x{} pixels, not of {}x{}",
                needed.width, needed.height, got.width, got.height
            ),
        }
    }
}

impl core::error::Error for ListError {}
