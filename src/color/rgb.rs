/// A colour as users write it: 8 bits a channel, 255 is full.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Rgb {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
}

impl Rgb {
    /// No light at all.
    pub const BLACK: Self = Self::new(0, 0, 0);
    /// All channels full.
    pub const WHITE: Self = Self::new(255, 255, 255);
    /// Full red.
    pub const RED: Self = Self::new(255, 0, 0);
    /// Full green.
    pub const GREEN: Self = Self::new(0, 255, 0);
    /// Full blue.
    pub const BLUE: Self = Self::new(0, 0, 255);

    /// A colour from its three channels.
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b }
    }
}
