use core::fmt;

/// Why words do not make a texture, or a texture no sampler.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum TextureError {
    /// A width or height of 0.
    Empty,
    /// A side above [`Texture::MAX_SIDE`](super::Texture::MAX_SIDE).
    TooLarge {
        /// The side that came.
        got: u16,
    },
    /// Fewer words than the size needs.
    Length {
        /// Words needed.
        needed: usize,
        /// Words that came.
        got: usize,
    },
    /// Only [`ClampAny`](super::ClampAny) along both axes takes sides that are no powers of two,
    /// and mip-maps never have them.
    NotPowerOfTwo {
        /// The width that came.
        width: u16,
        /// The height that came.
        height: u16,
    },
}

impl fmt::Display for TextureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("a texture needs at least one texel"),
            Self::TooLarge { got } => write!(f, "a texture's side is at most 4096, not {got}"),
            Self::Length { needed, got } => {
                write!(f, "a texture of this size needs {needed} words, not {got}")
            }
            Self::NotPowerOfTwo { width, height } => write!(
                f,
                "{width}x{height}: sides must be powers of two unless both axes are `ClampAny`"
            ),
        }
    }
}

impl core::error::Error for TextureError {}
