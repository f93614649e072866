//! What can go wrong when a TGA picture is written.

use std::{fmt, io};

/// Why a TGA picture was not written.
#[derive(Debug)]
#[non_exhaustive]
pub enum TgaError {
    /// Width or height is beyond 65 535, the largest that the header holds.
    TooLarge {
        /// The width that was asked for, in pixels.
        width: usize,
        /// The height that was asked for, in pixels.
        height: usize,
    },
    /// There are not `width * height` pixels.
    WrongLength {
        /// `width * height`.
        needed: usize,
        /// How many pixels were given.
        got: usize,
    },
    /// The output refused the bytes.
    Write(io::Error),
}

impl fmt::Display for TgaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { width, height } => {
                write!(f, "a TGA picture has at most 65535x65535 pixels, not {width}x{height}")
            }
            Self::WrongLength { needed, got } => {
                write!(f, "the picture needs {needed} pixels and got {got}")
            }
            Self::Write(error) => write!(f, "cannot write the picture: {error}"),
        }
    }
}

impl std::error::Error for TgaError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Write(error) => Some(error),
            _ => None,
        }
    }
}

impl From<io::Error> for TgaError {
    fn from(error: io::Error) -> Self {
        Self::Write(error)
    }
}
