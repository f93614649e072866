use super::pairs::{change_pairs, FIELDS};
use super::Color;

/// What is added to the fields of a pair of RGB565 pixels, with five fraction bits.
#[derive(Clone, Copy)]
struct Fields {
    keep: u32,
    /// To those of [`FIELDS`], with five bits of fraction.
    these: u32,
    /// To the others, shifted down by five bits.
    others: u32,
}

impl Fields {
    /// From the share that is kept, in 256ths but a multiple of 8, and what is added to 8.8
    /// channels. The half step that [`Format::middle`] has on top of the fields is added as well.
    ///
    /// [`Format::middle`]: super::Format::middle
    #[inline(always)]
    fn new(keep: u32, add: Color) -> Self {
        let red = (add.blue_red & 0xFFFF).wrapping_add(keep << 2) >> 6;
        let blue = (add.blue_red >> 16).wrapping_add(keep << 2) >> 6;
        let green = (add.green >> 16).wrapping_add(keep << 1) >> 5;
        Self {
            keep: keep >> 3,
            these: green << 21 | red << 11 | blue,
            others: red << 22 | blue << 11 | green,
        }
    }

    /// Two pixels at once.
    #[inline(always)]
    fn fade(&self, pair: u32) -> u32 {
        let fade = |fields: u32, add: u32| fields.wrapping_mul(self.keep).wrapping_add(add);
        let these = fade(pair & FIELDS, self.these) >> 5 & FIELDS;
        let others = fade((pair & !FIELDS) >> 5, self.others) & !FIELDS;
        these | others
    }
}

/// [`Format::fade`](super::Format::fade) of RGB565, two pixels in a word; `SWAP` where bytes are
/// stored the other way round than the machine's.
#[inline(never)]
pub(super) fn fade_pairs<const SWAP: bool>(pixels: &mut [u16], keep: u32, add: Color) {
    let fields = Fields::new(keep, add);
    change_pairs::<SWAP, 4>(pixels, |pair| fields.fade(pair));
}
