//! Where the first row of a TGA picture lies.

/// The corner in which the first pixel of the file lies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TgaOrigin {
    /// The first row of the file is the top row. Every current reader takes it.
    #[default]
    TopLeft,
    /// The first row of the file is the bottom row, as in the oldest TGA files.
    BottomLeft,
}

impl TgaOrigin {
    /// The bits of the descriptor, byte 17.
    pub(super) const fn descriptor(self) -> u8 {
        match self {
            Self::TopLeft => 0x20,
            Self::BottomLeft => 0x00,
        }
    }
}
