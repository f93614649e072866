use super::Rgb;

/// A colour with fractions: 8.8 bits a channel, [`Rgb16::FULL`] (255.0) is full.
///
/// # Range
/// 0 to 65280 a channel. What lies above is brought down to full where triangles are set up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb16 {
    /// Red, 8.8.
    pub r: u16,
    /// Green, 8.8.
    pub g: u16,
    /// Blue, 8.8.
    pub b: u16,
}

impl Rgb16 {
    /// A full channel: 255.0.
    pub const FULL: u16 = 255 << 8;

    /// A colour from three 8.8 channels.
    pub const fn new(r: u16, g: u16, b: u16) -> Self {
        Self { r, g, b }
    }

    /// The same colour with fractions of zero.
    pub const fn from_rgb(rgb: Rgb) -> Self {
        Self { r: (rgb.r as u16) << 8, g: (rgb.g as u16) << 8, b: (rgb.b as u16) << 8 }
    }
}

impl From<Rgb> for Rgb16 {
    fn from(rgb: Rgb) -> Self {
        Self::from_rgb(rgb)
    }
}
