use super::{Rgb, Rgb16};

/// Half a step of an 8-bit channel in 8.8: what turns cutting off into rounding.
pub(crate) const HALF: u16 = 128;

/// The eight bits of two channels, shifted down.
pub(crate) const EIGHTS: u32 = 0x00FF_00FF;

/// The colour inside the loops: sixteen bits a channel in two words, independent of any format.
///
/// ```text
///            31            16 15             0
/// blue_red   | blue    8.8  | red      8.8  |
/// green      | green   8.8  | alpha    8.8  |
/// ```
/// 8.8 and 5.11 are the same sixteen bits, so packing to RGB565 is two masks and two shifts and
/// packing to RGBA8888 is two masks: the low bits may be anything. Red lies low and blue high
/// because both formats then take red without a shift. Alpha lies where formats cut off green's
/// fraction, so that what does not blend does not know of it.
///
/// # Rounding
/// Made from 8-bit channels the fraction is one half, so that formats may cut off: an RGBA8888
/// picture shows exactly the channel that was given, and interpolation has a quarter of a step
/// of play on either side before it shows another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Color {
    /// Blue as 8.8 in the upper half, red as 8.8 in the lower.
    pub blue_red: u32,
    /// Green as 8.8 in the upper half, alpha in the lower: [`OPAQUE`](Self::OPAQUE) is full.
    pub green: u32,
}

impl Color {
    /// Full alpha, in the lower half of [`green`](Self::green).
    pub const OPAQUE: u32 = 0xFFFF;

    /// Nothing, to be added.
    pub(crate) const NOTHING: Self = Self { blue_red: 0, green: 0 };

    /// The opaque colour of three 8-bit channels.
    pub const fn new(r: u8, g: u8, b: u8) -> Self {
        Self::from_rgb16(Rgb16::from_rgb(Rgb::new(r, g, b)))
    }

    /// The opaque colour of three 8.8 channels.
    pub const fn from_rgb16(rgb: Rgb16) -> Self {
        Self {
            blue_red: (rounded(rgb.b) as u32) << 16 | rounded(rgb.r) as u32,
            green: (rounded(rgb.g) as u32) << 16 | Self::OPAQUE,
        }
    }

    /// The same colour with another alpha: 0 is invisible, 255 opaque.
    #[inline(always)]
    #[must_use]
    pub const fn with_alpha(self, alpha: u8) -> Self {
        Self { green: self.green & !Self::OPAQUE | (alpha as u32 * 257), ..self }
    }

    /// `keep / 256` of this colour's channels, without their fractions, and `add`; opaque.
    ///
    /// # Range
    /// `keep` at most 256, and sums below 2^16 a channel: a neighbour is spoilt otherwise.
    #[inline(always)]
    #[must_use]
    pub(crate) const fn weighted(self, keep: u32, add: Self) -> Self {
        let blue_red = (self.blue_red >> 8 & EIGHTS).wrapping_mul(keep);
        let green = (self.green >> 24).wrapping_mul(keep) << 16;
        Self {
            blue_red: blue_red.wrapping_add(add.blue_red),
            green: green.wrapping_add(add.green) | Self::OPAQUE,
        }
    }

    /// Alpha without its fraction.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the shift leaves eight bits")]
    pub const fn alpha(self) -> u8 {
        (self.green >> 8) as u8
    }

    /// Red without its fraction.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the shift leaves eight bits")]
    pub const fn red(self) -> u8 {
        (self.blue_red >> 8) as u8
    }

    /// Green without its fraction.
    #[inline(always)]
    pub const fn green(self) -> u8 {
        (self.green >> 24) as u8
    }

    /// Blue without its fraction.
    #[inline(always)]
    pub const fn blue(self) -> u8 {
        (self.blue_red >> 24) as u8
    }
}

/// An 8.8 channel with the half step added that makes a cut a rounding; at most 65408.
#[inline(always)]
pub(crate) const fn rounded(channel: u16) -> u16 {
    debug_assert!(channel <= Rgb16::FULL, "an Rgb16 holds no more");
    channel.wrapping_add(HALF)
}

impl Default for Color {
    /// Black.
    fn default() -> Self {
        Self::new(0, 0, 0)
    }
}

impl From<Rgb> for Color {
    #[inline(always)]
    fn from(rgb: Rgb) -> Self {
        Self::new(rgb.r, rgb.g, rgb.b)
    }
}

impl From<Rgb16> for Color {
    #[inline(always)]
    fn from(rgb: Rgb16) -> Self {
        Self::from_rgb16(rgb)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_8_bit_channel_survives_the_trip() {
        for v in 0..=255 {
            let color = Color::new(v, 255 - v, v / 2);
            assert_eq!(
                (color.red(), color.green(), color.blue()),
                (v, 255 - v, v / 2),
                "channel {v} came back as another"
            );
        }
    }

    #[test]
    fn every_alpha_survives_the_trip_and_leaves_green_alone() {
        assert_eq!(Color::new(1, 2, 3).alpha(), 255, "opaque");
        for alpha in 0..=255 {
            let color = Color::new(9, alpha, 7).with_alpha(alpha);
            assert_eq!((color.alpha(), color.green()), (alpha, alpha), "alpha {alpha}");
        }
    }

    #[test]
    fn channels_above_full_are_full() {
        let color = Color::from_rgb16(Rgb16::new(u16::MAX, Rgb16::FULL + 1, Rgb16::FULL));
        assert_eq!(color, Color::new(255, 255, 255), "brought down to full");
    }
}
