use super::Color;

/// Pixels that are shaded at a time where the core has vectors: channels of 16 bits in one of them.
pub(crate) const LANES: usize = 8;

/// Whether the core has vectors: 128 bits wide in every program for these.
pub(crate) const HAS_VECTORS: bool = cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// The colours of [`LANES`] pixels side by side, words of one kind together as vectors take them.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ColorLanes {
    pub(crate) blue_red: [u32; LANES],
    pub(crate) green: [u32; LANES],
}

impl ColorLanes {
    /// Of what a function makes of each lane's number.
    #[inline(always)]
    pub(crate) fn of(mut color: impl FnMut(usize) -> Color) -> Self {
        let mut lanes = Self { blue_red: [0; LANES], green: [0; LANES] };
        for (lane, (blue_red, green)) in lanes.blue_red.iter_mut().zip(&mut lanes.green).enumerate()
        {
            let color = color(lane);
            (*blue_red, *green) = (color.blue_red, color.green);
        }
        lanes
    }
}

/// A channel of [`LANES`] pixels, 8.8.
pub(crate) type Channel = [u16; LANES];

/// The channels of [`LANES`] colours, each in a vector.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ChannelLanes {
    pub(crate) red: Channel,
    pub(crate) green: Channel,
    pub(crate) blue: Channel,
    pub(crate) alpha: Channel,
}

impl ChannelLanes {
    /// One of the colours.
    #[inline(always)]
    pub(crate) fn at(&self, lane: usize) -> Color {
        let words =
            |high: &Channel, low: &Channel| u32::from(high[lane]) << 16 | u32::from(low[lane]);
        Color { blue_red: words(&self.blue, &self.red), green: words(&self.green, &self.alpha) }
    }
}
