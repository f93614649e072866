use super::fade::fade_pairs;
use super::packed::HALF;
use super::{fill_halves, ChannelLanes, Color, Format, Rgb16, EIGHTS, LANES};

/// What leads from 8.8 to 5.11 (of red and blue) and 6.10 (of green) where full is 31 and 63, in
/// 256ths.
const RED_BLUE: u32 = 249;
const GREEN: u32 = 253;

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

    /// The middle of the colours that are stored as `raw`.
    #[inline(always)]
    pub(super) const fn middle_of(raw: u16) -> Color {
        let raw = raw as u32;
        Color {
            blue_red: raw << 27 | raw & 0xF800 | 0x0400_0400,
            green: (raw & 0x07E0) << 21 | 0x0200_0000 | Color::OPAQUE,
        }
    }

    /// The stored value under dither.
    ///
    /// # Rounding
    /// 249 / 2048 and 253 / 1024 lead from eight bits to 31 and 63 steps (a 300th of a step too
    /// far at the end), and what the thresholds add stays below one step: black and white are met
    /// exactly, and no channel runs over.
    #[inline(always)]
    pub(super) const fn dithered(color: Color, thresholds: u32) -> u16 {
        let blue_red = (color.blue_red >> 8 & EIGHTS).wrapping_mul(RED_BLUE);
        let green = (color.green >> 24).wrapping_mul(GREEN << 16);
        let raise = Self::threshold(thresholds);
        Self::encode(Color {
            blue_red: blue_red.wrapping_add(raise.blue_red),
            green: green.wrapping_add(raise.green),
        })
    }

    /// Thresholds in steps of each channel.
    #[inline(always)]
    pub(super) const fn threshold(thresholds: u32) -> Color {
        let thresholds = thresholds & EIGHTS;
        Color { blue_red: thresholds << 3, green: thresholds << 18 }
    }

    /// What [`dithered`](Self::dithered) does with a colour of eight bits, done with its fraction
    /// and without the half step that was added to it: blue and red may then stray by 1/30 of a
    /// step before they run over.
    #[inline]
    pub(super) const fn dimmed(color: Color) -> Color {
        const fn dim(channel: u32, by: u32) -> u32 {
            let channel = channel.saturating_sub(HALF as u32);
            let full = Rgb16::FULL as u32;
            (if channel < full { channel } else { full }).wrapping_mul(by) >> 8
        }
        let red = dim(color.blue_red & 0xFFFF, RED_BLUE);
        let blue = dim(color.blue_red >> 16, RED_BLUE);
        Color {
            blue_red: blue << 16 | red,
            green: dim(color.green >> 16, GREEN) << 16 | color.green & Color::OPAQUE,
        }
    }
}

impl Format for Rgb565 {
    type Raw = u16;

    #[inline(always)]
    fn pack(color: Color) -> u16 {
        Self::encode(color)
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "16 bits are set")]
    fn pack_products([red, green, blue]: [u32; 3], _alpha: u32) -> u16 {
        (red >> 9 & 0xF800 | green >> 14 & 0x07E0 | blue >> 20) as u16
    }

    #[inline(always)]
    fn pack_lanes(channels: &ChannelLanes) -> [u16; LANES] {
        let ChannelLanes { red, green, blue, .. } = channels;
        core::array::from_fn(|i| red[i] & 0xF800 | green[i] >> 5 & 0x07E0 | blue[i] >> 11)
    }

    #[inline(always)]
    fn unpack(raw: u16) -> Color {
        Self::decode(raw)
    }

    #[inline(always)]
    fn fill(pixels: &mut [u16], raw: u16) {
        let word = u32::from(raw) * 0x0001_0001;
        fill_halves(pixels, word, word);
    }

    #[inline(always)]
    fn middle(raw: u16) -> Color {
        Self::middle_of(raw)
    }

    /// In 32nds.
    #[inline(always)]
    fn weight(weight: u32) -> u32 {
        weight.wrapping_add(4) & !7
    }

    #[inline(always)]
    fn fade(pixels: &mut [u16], keep: u32, add: Color) {
        fade_pairs::<false>(pixels, keep, add);
    }

    #[inline(always)]
    fn as_rgb565(pixels: &mut [u16]) -> Option<(&mut [u16], bool)> {
        Some((pixels, false))
    }

    #[inline(always)]
    fn pack_dithered(color: Color, thresholds: u32) -> u16 {
        Self::dithered(color, thresholds)
    }

    #[inline(always)]
    fn dim(color: Color) -> Color {
        Self::dimmed(color)
    }

    #[inline(always)]
    fn raise(thresholds: u32) -> Color {
        Self::threshold(thresholds)
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
