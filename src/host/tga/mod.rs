//! TGA pictures out: uncompressed true colour, as every viewer reads them.

mod depth;
mod error;
mod origin;

pub use depth::TgaDepth;
pub use error::TgaError;
pub use origin::TgaOrigin;

use std::io::Write;
use std::vec::Vec;

/// A TGA picture to be written: its size and form, without its pixels.
///
/// The file is an 18-byte header and the pixels: no palette, no compression, no footer
/// (Truevision TGA File Format Specification 2.0, image type 2).
///
/// ```
/// use microraster::host::Tga;
///
/// # fn main() -> Result<(), microraster::host::TgaError> {
/// let picture = [[255, 0, 0, 255], [0, 0, 255, 255]]; // a red and a blue pixel
/// let mut file = Vec::new();
/// Tga::new(2, 1)?.write(&mut file, &picture)?;
/// assert_eq!(file.len(), 18 + 2 * 4);
/// assert_eq!(file[18..22], [0, 0, 255, 255]); // blue, green, red, alpha
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tga {
    width: u16,
    height: u16,
    origin: TgaOrigin,
    depth: TgaDepth,
}

impl Tga {
    /// A picture of `width` x `height` pixels, 32 bits each, top row first.
    ///
    /// # Errors
    ///
    /// [`TgaError::TooLarge`] beyond 65 535 pixels in either direction. Zero is allowed: the
    /// file then has no pixels.
    pub fn new(width: usize, height: usize) -> Result<Self, TgaError> {
        match (u16::try_from(width), u16::try_from(height)) {
            (Ok(width), Ok(height)) => {
                Ok(Self { width, height, origin: TgaOrigin::default(), depth: TgaDepth::default() })
            }
            _ => Err(TgaError::TooLarge { width, height }),
        }
    }

    /// The same picture with its first row at `origin`. Pixels are given top row first all the
    /// same.
    #[must_use]
    pub const fn origin(self, origin: TgaOrigin) -> Self {
        Self { origin, ..self }
    }

    /// The same picture with pixels of `depth`.
    #[must_use]
    pub const fn depth(self, depth: TgaDepth) -> Self {
        Self { depth, ..self }
    }

    /// Writes the picture whose pixels are `pixels`: red, green, blue, alpha; row by row from
    /// the top, each from the left.
    ///
    /// # Errors
    ///
    /// [`TgaError::WrongLength`] unless there are `width * height` pixels (nothing is written
    /// then), [`TgaError::Write`] if `output` fails.
    pub fn write(self, output: impl Write, pixels: &[[u8; 4]]) -> Result<(), TgaError> {
        let width = usize::from(self.width);
        let needed = width * usize::from(self.height);
        if pixels.len() != needed {
            return Err(TgaError::WrongLength { needed, got: pixels.len() });
        }
        self.write_with(output, |x, y| {
            let index = usize::from(y) * width + usize::from(x);
            pixels.get(index).copied().unwrap_or_default()
        })
    }

    /// Writes the picture whose pixel in column `x` and row `y` (0 is the top) is `pixel(x, y)`,
    /// called once for each: red, green, blue, alpha.
    ///
    /// # Errors
    ///
    /// [`TgaError::Write`] if `output` fails.
    pub fn write_with(
        self,
        mut output: impl Write,
        mut pixel: impl FnMut(u16, u16) -> [u8; 4],
    ) -> Result<(), TgaError> {
        output.write_all(&self.header())?;
        let bytes = usize::from(self.depth.bits() / 8);
        let mut row = Vec::with_capacity(usize::from(self.width) * bytes);
        for line in 0..self.height {
            let y = match self.origin {
                TgaOrigin::TopLeft => line,
                TgaOrigin::BottomLeft => self.height - 1 - line,
            };
            row.clear();
            for x in 0..self.width {
                row.extend(self.depth.encode(pixel(x, y)).into_iter().take(bytes));
            }
            output.write_all(&row)?;
        }
        Ok(())
    }

    /// The 18 bytes before the pixels.
    fn header(self) -> [u8; 18] {
        const TRUE_COLOUR: u8 = 2;
        let mut header = [0; 18];
        header[2] = TRUE_COLOUR;
        [header[12], header[13]] = self.width.to_le_bytes();
        [header[14], header[15]] = self.height.to_le_bytes();
        header[16] = self.depth.bits();
        header[17] = self.origin.descriptor() | self.depth.alpha_bits();
        header
    }
}
