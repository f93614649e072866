use crate::math::BY_HALVES;

/// One axis of a texture as a sampler sees it: what [`Wrap`](super::Wrap) needs, made once.
///
/// `at` is a coordinate in the vertex's units with 16 fraction bits; `turned` is one that a wrap has
/// turned to the left, so that whole repeats (or pairs of them) are cut off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Number of the last texel.
    last: u32,
    /// Units of one repeat: log2.
    unit_bits: u32,
    /// Bits of a coordinate below the texel's number, where the side is a power of two.
    shift: u32,
    /// Bits below the texel's number and 8 of its fraction, where a repeat fills a word.
    below: u32,
    /// Turns a coordinate so that a repeat fills a word; 0 for a side of one texel, which is left at
    /// its beginning: its number would be shifted by 32.
    scale: u32,
}

// A coordinate's bits: up to 15 of a repeat's units, 16 of fractions, and a texel's number takes
// at most 12 of them.
const _: () = assert!(super::Texture::<crate::Rgb565>::MAX_SIDE == 1 << 12, "a shift above 0");

impl Axis {
    /// An axis of `side` texels (1 to 4096) that repeats each 2^`unit_bits` units.
    pub(super) const fn new(side: u16, unit_bits: u32) -> Self {
        let unit_bits = if unit_bits > 15 { 15 } else { unit_bits };
        // Of a side that is no power of two, what follows from the bits is never asked for.
        let bits = (side as u32).trailing_zeros();
        Self {
            last: (side as u32).saturating_sub(1),
            unit_bits,
            shift: (unit_bits + 16).saturating_sub(bits),
            below: 24u32.saturating_sub(bits),
            scale: if side == 1 { 0 } else { 1 << (16 - unit_bits) },
        }
    }

    /// Texels: at most 4096, which the mask tells the compiler, so that no place in a picture may
    /// overflow.
    #[inline(always)]
    pub(super) const fn side(&self) -> u32 {
        (self.last & 0xFFF).wrapping_add(1)
    }

    /// Texels in so many rows, where this is the axis across.
    #[inline(always)]
    pub(super) const fn row(&self, number: u32) -> usize {
        number.wrapping_mul(self.side()) as usize
    }

    /// Number of the last texel.
    #[inline(always)]
    pub(super) const fn last(&self) -> u32 {
        self.last
    }

    /// Turned so that a repeat fills a word: coordinates and ways alike, modulo 2^32.
    #[inline(always)]
    pub(super) const fn turned(&self, at: i32) -> i32 {
        at.cast_unsigned().wrapping_mul(self.scale).cast_signed()
    }

    /// Turned so that two repeats fill a word.
    #[inline(always)]
    pub(super) const fn turned_twice(&self, at: i32) -> i32 {
        at.wrapping_shl(15 - self.unit_bits)
    }

    /// The texel at a turned coordinate.
    #[inline(always)]
    pub(super) const fn repeated(&self, turned: i32) -> u32 {
        turned.cast_unsigned().wrapping_shr(self.below.wrapping_add(8))
    }

    /// The same, and 8 bits of what lies behind its beginning.
    #[inline(always)]
    pub(super) const fn repeated_place(&self, turned: i32) -> (u32, u32) {
        if BY_HALVES {
            self.place_by_shifts(turned)
        } else {
            self.place_by_a_product(turned)
        }
    }

    /// One multiplication gives both, and spares the register that a shift would need.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "halves of a product")]
    const fn place_by_a_product(&self, turned: i32) -> (u32, u32) {
        let product = (turned.cast_unsigned() as u64).wrapping_mul(self.side() as u64);
        ((product >> 32) as u32, product as u32 >> 24)
    }

    /// The same where long products are dear.
    /// The texel before one; before the first one is the last.
    #[inline(always)]
    pub(in crate::texture) const fn previous(&self, number: u32) -> u32 {
        number.wrapping_sub(1) & self.last
    }

    /// The texel's number, and how far behind it the place lies in 2^-32 of a texel, of a turned coordinate.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "halves of a product")]
    pub(in crate::texture) const fn fine_place(&self, turned: i32) -> (u32, u32) {
        if BY_HALVES {
            let (number, _) = self.place_by_shifts(turned);
            (number, turned.cast_unsigned().wrapping_mul(self.side()))
        } else {
            let product = (turned.cast_unsigned() as u64).wrapping_mul(self.side() as u64);
            ((product >> 32) as u32, product as u32)
        }
    }

    #[inline(always)]
    const fn place_by_shifts(&self, turned: i32) -> (u32, u32) {
        let place = turned.cast_unsigned().wrapping_shr(self.below);
        (place >> 8, place & 255)
    }

    /// The texel behind another one, after the last one the first.
    #[inline(always)]
    pub(super) const fn next(&self, number: u32) -> u32 {
        number.wrapping_add(1) & self.last
    }

    /// All ones in the second of two repeats.
    #[inline(always)]
    pub(super) const fn flip(&self, twice: i32) -> u32 {
        (twice >> 31).cast_unsigned()
    }

    /// The texel at a coordinate that was turned twice, every second repeat mirrored.
    #[inline(always)]
    pub(super) const fn mirrored(&self, twice: i32) -> u32 {
        // One texel has no bits: whatever is shifted, it is cut off.
        let number = (twice.cast_unsigned() << 1).wrapping_shr(self.below.wrapping_add(8));
        (number ^ self.flip(twice)) & self.last
    }

    /// 8 bits of what lies behind its beginning.
    #[inline(always)]
    pub(super) const fn mirrored_fraction(&self, twice: i32) -> u32 {
        (twice.cast_unsigned() << 1).wrapping_shr(self.below) & 255
    }

    /// The coordinate one texel on.
    #[inline(always)]
    pub(super) const fn mirrored_next(&self, twice: i32) -> i32 {
        twice.wrapping_add(1i32.wrapping_shl(self.below.wrapping_add(7)))
    }

    /// Texel `number`, or the nearest there is.
    #[inline(always)]
    pub(super) const fn clamped(&self, number: i32) -> u32 {
        let number = if number < 0 { 0 } else { number.cast_unsigned() };
        if number > self.last {
            self.last
        } else {
            number
        }
    }

    /// The number of the texel at `at`, which may lie outside.
    #[inline(always)]
    pub(super) const fn number(&self, at: i32) -> i32 {
        at >> (self.shift & 31)
    }

    /// Half a texel before `at`, less half of 2^-`places` texel, so that a fraction may be cut off:
    /// where the left one of two texels begins.
    #[inline(always)]
    pub(super) const fn before(&self, at: i32, places: u32) -> i32 {
        at.wrapping_sub(half_texel(self.shift, places))
    }

    /// The same, but never around the end of the numbers.
    #[inline(always)]
    pub(super) const fn before_saturating(&self, at: i32, places: u32) -> i32 {
        at.saturating_sub(half_texel(self.shift, places))
    }

    /// How far behind the beginning of its texel a coordinate lies, in units of 2^-8 of a texel.
    #[inline(always)]
    pub(super) const fn fraction(&self, before: i32) -> u32 {
        (before.cast_unsigned() << (32u32.wrapping_sub(self.shift) & 31)) >> 24
    }

    /// The coordinate in texels of a side of any length, clamped to the picture, with 4 more
    /// fraction bits than there are unit bits.
    ///
    /// # Rounding
    /// Down.
    #[inline(always)]
    pub(super) const fn scaled(&self, at: i32) -> u32 {
        let end = (1u32 << (16 + self.unit_bits)).wrapping_sub(1);
        let at = if at < 0 { 0 } else { at.cast_unsigned() };
        let at = if at > end { end } else { at };
        // (2^15 - 1) x 2^12 x 2^4 + 2^16 x 2^12 / 2^12 < 2^31, and without a loss in 32 bits.
        let side = self.last.wrapping_add(1);
        let whole = (at >> 16).wrapping_mul(side) << 4;
        whole.wrapping_add((at & 0xFFFF).wrapping_mul(side) >> 12)
    }

    /// Fraction bits of [`scaled`](Self::scaled).
    #[inline(always)]
    pub(super) const fn scaled_bits(&self) -> u32 {
        self.unit_bits + 4
    }
}

/// Half a texel of `bits` fraction bits, less half of 2^-`places` of it.
#[inline(always)]
pub(super) const fn half_texel(bits: u32, places: u32) -> i32 {
    let half = (1u32 << (bits & 31)) >> 1;
    half.wrapping_sub(half >> (places & 31)).cast_signed()
}

#[cfg(test)]
mod tests {
    use super::Axis;

    #[test]
    fn products_and_shifts_find_the_same_places() {
        for side in (0..=12).map(|bits| 1u16 << bits) {
            for unit_bits in [0, 1, 7, 12, 15] {
                let axis = Axis::new(side, unit_bits);
                for i in 0..5000i32 {
                    let turned = axis.turned(i.wrapping_mul(0x9E37_79B9_u32.cast_signed()));
                    let place = (u64::from(turned.cast_unsigned()) * u64::from(side)) >> 24;
                    let expected = ((place >> 8) as u32, (place & 255) as u32);
                    let ways = [
                        axis.repeated_place(turned),
                        axis.place_by_a_product(turned),
                        axis.place_by_shifts(turned),
                    ];
                    assert_eq!(ways, [expected; 3], "{side}: place {turned:x}");
                    assert_eq!(axis.repeated(turned), expected.0, "{side}: texel {turned:x}");
                }
            }
        }
    }
}
