use super::{fill_words, Color, Format};

/// Sixteen bits a pixel, `rrrrrggg gggbbbbb`, in the order of the machine's own u16.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rgb565;

impl Rgb565 {
    /// The stored value of a colour, also for constants.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the masks leave no more bits than that")]
    pub const fn encode(color: Color) -> u16 {
        let red = color.blue_red & 0xF800;
        let green = (color.green >> 21) & 0x07E0;
        let blue = color.blue_red >> 27;
        (red | green | blue) as u16
    }

    /// The colour of a stored value: 5 and 6 bits are repeated into 8, so full stays full.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "the masks leave no more bits than that")]
    pub const fn decode(raw: u16) -> Color {
        let (r, g, b) = (raw >> 11, (raw >> 5) & 63, raw & 31);
        Color::new((r << 3 | r >> 2) as u8, (g << 2 | g >> 4) as u8, (b << 3 | b >> 2) as u8)
    }
}

impl Format for Rgb565 {
    type Raw = u16;

    #[inline(always)]
    fn pack(color: Color) -> u16 {
        Self::encode(color)
    }

    #[inline(always)]
    fn unpack(raw: u16) -> Color {
        Self::decode(raw)
    }

    #[inline(always)]
    fn fill(pixels: &mut [u16], raw: u16) {
        fill_words(pixels, raw, u32::from(raw) * 0x0001_0001);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn red_is_f800_green_07e0_blue_001f() {
        assert_eq!(Rgb565::pack(Color::new(255, 0, 0)), 0xF800, "red");
        assert_eq!(Rgb565::pack(Color::new(0, 255, 0)), 0x07E0, "green");
        assert_eq!(Rgb565::pack(Color::new(0, 0, 255)), 0x001F, "blue");
    }

    #[test]
    fn every_stored_value_survives_the_trip() {
        for raw in 0..=u16::MAX {
            assert_eq!(Rgb565::pack(Rgb565::unpack(raw)), raw, "{raw:04x}");
        }
    }
}
