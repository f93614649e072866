use super::Color;

/// What is added to the fields of a pair of RGB565 pixels, with eight fraction bits.
#[derive(Clone, Copy)]
struct Fields {
    red: u32,
    green: u32,
    blue: u32,
}

impl Fields {
    /// From what is added to 8.8 channels, and from the half step that [`Format::middle`] has on
    /// top of the fields and of which `keep / 256` stay.
    ///
    /// [`Format::middle`]: super::Format::middle
    fn new(keep: u32, add: Color) -> Self {
        let field = |channel: u32, bits: u32| {
            let half = keep << (bits - 1);
            (channel.wrapping_add(half) >> bits).wrapping_mul(0x0001_0001)
        };
        Self {
            red: field(add.blue_red & 0xFFFF, 3),
            green: field(add.green >> 16, 2),
            blue: field(add.blue_red >> 16, 3),
        }
    }

    /// Two pixels at once. Sixteen bits a field leave room for eight of fraction.
    #[inline(always)]
    fn fade(&self, pair: u32, keep: u32) -> u32 {
        let fade = |field: u32, add: u32| field.wrapping_mul(keep).wrapping_add(add);
        let red = fade(pair >> 11 & 0x001F_001F, self.red);
        let green = fade(pair >> 5 & 0x003F_003F, self.green);
        let blue = fade(pair & 0x001F_001F, self.blue);
        red << 3 & 0xF800_F800 | green >> 3 & 0x07E0_07E0 | blue >> 8 & 0x001F_001F
    }
}

/// Both pixels with their bytes swapped.
#[inline(always)]
const fn swapped<const SWAP: bool>(pair: u32) -> u32 {
    if SWAP {
        pair.swap_bytes().rotate_left(16)
    } else {
        pair
    }
}

/// [`Format::fade`](super::Format::fade) of RGB565, two pixels in a word; `SWAP` where bytes are
/// stored the other way round than the machine's.
///
/// # Cost
/// COST
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "half of a pair")]
pub(super) fn fade_pairs<const SWAP: bool>(pixels: &mut [u16], keep: u32, add: Color) {
    let fields = Fields::new(keep, add);
    let fade = |pair: u32| swapped::<SWAP>(fields.fade(swapped::<SWAP>(pair), keep));
    let (head, pairs, tail) = bytemuck::pod_align_to_mut::<u16, u32>(pixels);
    for pixel in head.iter_mut().chain(tail) {
        *pixel = fade(u32::from(*pixel)) as u16;
    }
    for pair in pairs {
        *pair = fade(*pair);
    }
}
