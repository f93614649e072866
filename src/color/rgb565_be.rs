use super::fade::fade_pairs;
use super::{fill_halves, Color, Format, Rgb565};

/// Sixteen bits a pixel in the byte order of SPI panels: red's byte comes first in memory.
///
/// A buffer of it goes to an ILI9341 or ST7789 as it stands. Costs one instruction a pixel more
/// than [`Rgb565`] on Cortex-M.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgb565Be;

impl Format for Rgb565Be {
    type Raw = u16;

    #[inline(always)]
    fn pack(color: Color) -> u16 {
        Rgb565::encode(color).to_be()
    }

    #[inline(always)]
    fn unpack(raw: u16) -> Color {
        Rgb565::decode(u16::from_be(raw))
    }

    #[inline(always)]
    fn fill(pixels: &mut [u16], raw: u16) {
        let word = u32::from(raw) * 0x0001_0001;
        fill_halves(pixels, word, word);
    }

    #[inline(always)]
    fn middle(raw: u16) -> Color {
        Rgb565::middle_of(u16::from_be(raw))
    }

    /// In 32nds.
    #[inline(always)]
    fn weight(weight: u32) -> u32 {
        weight.wrapping_add(4) & !7
    }

    #[inline(always)]
    fn fade(pixels: &mut [u16], keep: u32, add: Color) {
        fade_pairs::<{ cfg!(target_endian = "little") }>(pixels, keep, add);
    }

    #[inline(always)]
    fn as_rgb565(pixels: &mut [u16]) -> Option<(&mut [u16], bool)> {
        Some((pixels, cfg!(target_endian = "little")))
    }

    #[inline(always)]
    fn pack_dithered(color: Color, thresholds: u32) -> u16 {
        Rgb565::dithered(color, thresholds).to_be()
    }

    #[inline(always)]
    fn dim(color: Color) -> Color {
        Rgb565::dimmed(color)
    }

    #[inline(always)]
    fn raise(thresholds: u32) -> Color {
        Rgb565::threshold(thresholds)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn red_is_f8_00_on_the_wire() {
        let raw = Rgb565Be::pack(Color::new(255, 0, 0));
        assert_eq!(raw.to_ne_bytes(), [0xF8, 0x00], "red's byte first");
    }
}
