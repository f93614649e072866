use super::Rgb;

/// A colour with fractions: 8.8 bits a channel, [`Rgb16::FULL`] (255.0) is full.
///
/// # Range
/// 0 to 65280 a channel; what lies above is brought down to full.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb16 {
    pub(crate) r: u16,
    pub(crate) g: u16,
    pub(crate) b: u16,
}

impl Rgb16 {
    /// A full channel: 255.0.
    pub const FULL: u16 = 255 << 8;

    /// A colour from three 8.8 channels, each at most [`FULL`](Self::FULL) or taken as that.
    pub const fn new(r: u16, g: u16, b: u16) -> Self {
        const fn limit(channel: u16) -> u16 {
            if channel > Rgb16::FULL {
                Rgb16::FULL
            } else {
                channel
            }
        }
        Self { r: limit(r), g: limit(g), b: limit(b) }
    }

    /// The channels: red, green and blue, 8.8.
    pub const fn channels(self) -> [u16; 3] {
        [self.r, self.g, self.b]
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
