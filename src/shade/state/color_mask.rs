use crate::color::{Color, Format};

/// Which channels are written.
pub trait ColorMask {
    /// Whether some are not.
    const MASKS: bool;

    /// Whether red, green and blue are.
    fn channels(&self) -> [bool; 3];
}

/// All channels: the default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct AllChannels;

/// Red, green and blue, where true; the others stay as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels<const R: bool, const G: bool, const B: bool>;

/// Channels chosen when the program runs: for host tools.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnyMask {
    /// Whether red is written.
    pub red: bool,
    /// Whether green is.
    pub green: bool,
    /// Whether blue is.
    pub blue: bool,
}

impl ColorMask for AllChannels {
    const MASKS: bool = false;

    #[inline(always)]
    fn channels(&self) -> [bool; 3] {
        [true; 3]
    }
}

impl<const R: bool, const G: bool, const B: bool> ColorMask for Channels<R, G, B> {
    const MASKS: bool = !(R && G && B);

    #[inline(always)]
    fn channels(&self) -> [bool; 3] {
        [R, G, B]
    }
}

impl ColorMask for AnyMask {
    const MASKS: bool = true;

    #[inline(always)]
    fn channels(&self) -> [bool; 3] {
        [self.red, self.green, self.blue]
    }
}

/// The channels of `new` that a mask lets through, and the others of `stored`.
#[inline(always)]
pub(super) fn masked<F: Format>(mask: &impl ColorMask, new: F::Raw, stored: F::Raw) -> F::Raw {
    let [red, green, blue] = mask.channels();
    let bits = |written: bool, bits: u32| if written { bits } else { 0 };
    let (new, stored) = (F::unpack(new), F::unpack(stored));
    let blue_red = bits(red, 0x0000_FFFF) | bits(blue, 0xFFFF_0000);
    F::pack(Color {
        blue_red: new.blue_red & blue_red | stored.blue_red & !blue_red,
        green: if green { new.green } else { stored.green },
    })
}
