/// One axis of a texture as a sampler sees it: what [`Wrap`](super::Wrap) needs, made once.
///
/// `at` is a coordinate in the vertex's units with 16 fraction bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axis {
    /// Number of the last texel.
    last: u32,
    /// Texels from one to the next along this axis: 1, or the width.
    stride: u32,
    /// Units of one repeat: log2.
    unit_bits: u32,
    /// Bits of a coordinate below the texel's number, where the side is a power of two.
    shift: u32,
    /// Turns the texel's number to its place in an index.
    rotate: u32,
    /// What of an index belongs to this axis.
    mask: u32,
    /// Half a texel, less half a step of the 8-bit fraction.
    bias: i32,
}

// A coordinate's bits: up to 15 of a repeat's units, 16 of fractions, and a texel's number takes
// at most 12 of them.
const _: () = assert!(super::Texture::<crate::Rgb565>::MAX_SIDE == 1 << 12, "a shift above 0");

impl Axis {
    /// An axis of `side` texels (1 to 4096), `stride` apart, that repeats each 2^`unit_bits` units.
    pub(super) const fn new(side: u16, stride: u16, unit_bits: u32) -> Self {
        let unit_bits = if unit_bits > 15 { 15 } else { unit_bits };
        let last = (side as u32).saturating_sub(1);
        // Of a side that is no power of two, what follows is never asked for.
        let shift = (unit_bits + 16).saturating_sub((side as u32).trailing_zeros());
        Self {
            last,
            stride: stride as u32,
            unit_bits,
            shift,
            rotate: shift.wrapping_sub((stride as u32).trailing_zeros()) & 31,
            mask: last.wrapping_mul(stride as u32),
            bias: half_texel(shift),
        }
    }

    /// The texel at `at`, endlessly repeated, as its part of an index.
    #[inline(always)]
    pub(super) const fn repeated(&self, at: i32) -> u32 {
        self.turned(at) & self.mask
    }

    /// The same and the next one.
    #[inline(always)]
    pub(super) const fn repeated_pair(&self, at: i32) -> [u32; 2] {
        let turned = self.turned(at);
        [turned & self.mask, turned.wrapping_add(self.stride) & self.mask]
    }

    /// The texel at `at`, every second repeat mirrored, as its part of an index.
    #[inline(always)]
    pub(super) const fn mirrored(&self, at: i32) -> u32 {
        // All ones in an odd repeat.
        let flip = (at << (15 - self.unit_bits)) >> 31;
        (self.turned(at) ^ flip.cast_unsigned()) & self.mask
    }

    /// The same and the next one.
    #[inline(always)]
    pub(super) const fn mirrored_pair(&self, at: i32) -> [u32; 2] {
        let next = at.wrapping_add(1i32 << (self.shift & 31));
        [self.mirrored(at), self.mirrored(next)]
    }

    /// Texel `number`, or the nearest there is, as its part of an index.
    #[inline(always)]
    pub(super) const fn clamped(&self, number: i32) -> u32 {
        let number = if number < 0 { 0 } else { number.cast_unsigned() };
        let number = if number > self.last { self.last } else { number };
        number.wrapping_mul(self.stride)
    }

    /// The number of the texel at `at`, which may lie outside.
    #[inline(always)]
    pub(super) const fn number(&self, at: i32) -> i32 {
        at >> (self.shift & 31)
    }

    /// Half a texel before `at`: where the left one of two texels begins.
    #[inline(always)]
    pub(super) const fn before(&self, at: i32) -> i32 {
        at.wrapping_sub(self.bias)
    }

    /// The same, but never around the end of the numbers.
    #[inline(always)]
    pub(super) const fn before_saturating(&self, at: i32) -> i32 {
        at.saturating_sub(self.bias)
    }

    /// How far behind the middle of the left one of two texels `at` lies, in units of 2^-8 of a
    /// texel.
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

    /// The coordinate turned so that the texel's number begins at the stride.
    #[inline(always)]
    const fn turned(&self, at: i32) -> u32 {
        at.cast_unsigned().rotate_right(self.rotate)
    }
}

/// Half a texel of `bits` fraction bits, less half of 2^-8 of it, so that a fraction may be cut
/// off to 8 bits.
pub(super) const fn half_texel(bits: u32) -> i32 {
    let half = (1u32 << (bits & 31)) >> 1;
    half.wrapping_sub(half >> 8).cast_signed()
}
