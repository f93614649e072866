//! How many bits a pixel of a TGA file has.

/// The pixel format of a TGA file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TgaDepth {
    /// 32 bits: blue, green, red, alpha, a byte each. Lossless.
    #[default]
    Bgra32,
    /// 16 bits: A1 R5 G5 B5, little-endian.
    ///
    /// # Rounding
    ///
    /// Channels keep their upper five bits, so of an RGB565 picture **green loses its sixth
    /// bit**; alpha is opaque from 128 on.
    A1r5g5b5,
}

impl TgaDepth {
    /// Byte 16 of the header.
    pub(super) const fn bits(self) -> u8 {
        match self {
            Self::Bgra32 => 32,
            Self::A1r5g5b5 => 16,
        }
    }

    /// How many of the bits are alpha: the low half of byte 17.
    pub(super) const fn alpha_bits(self) -> u8 {
        match self {
            Self::Bgra32 => 8,
            Self::A1r5g5b5 => 1,
        }
    }

    /// The bytes of one pixel, of which the first [`bits`](Self::bits)` / 8` count.
    pub(super) fn encode(self, [red, green, blue, alpha]: [u8; 4]) -> [u8; 4] {
        match self {
            Self::Bgra32 => [blue, green, red, alpha],
            Self::A1r5g5b5 => {
                let five = |channel: u8| u16::from(channel >> 3);
                let word = (u16::from(alpha >> 7) << 15)
                    | (five(red) << 10)
                    | (five(green) << 5)
                    | five(blue);
                let [low, high] = word.to_le_bytes();
                [low, high, 0, 0]
            }
        }
    }
}
