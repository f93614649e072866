/// How far texture coordinates go from a pixel to its neighbours: the vertex's units with 16
/// fraction bits.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Footprint {
    /// u and v, from one pixel to its right neighbour.
    pub right: [i32; 2],
    /// u and v, from one pixel to the one below.
    pub down: [i32; 2],
}

impl Footprint {
    /// The mip level for a picture of 2^`bits` texels along u and v of which one repeat is
    /// 2^`unit_bits` units: the longer of the two ways is at most sqrt(2) texels of it, and above
    /// half of that; at most `last`.
    ///
    /// That is OpenGL's choice for `NEAREST_MIPMAP_NEAREST`, ceil(log2(way) + 1/2) - 1 (OpenGL 4.6,
    /// 8.14).
    ///
    /// # Rounding
    /// Ways are cut off to 15 bits: where a way is within 2^-13 of the border of two levels, the
    /// finer may be taken.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, reason = "15 bits are left")]
    pub fn level(&self, bits: [u32; 2], unit_bits: u32, last: u32) -> u32 {
        // Texels, with the fraction bits of a coordinate: 31 + 12 bits at most.
        let texels = |[u, v]: [i32; 2]| {
            [
                u64::from(u.unsigned_abs()) << (bits[0] & 15),
                u64::from(v.unsigned_abs()) << (bits[1] & 15),
            ]
        };
        let (right, down) = (texels(self.right), texels(self.down));
        let all = right[0] | right[1] | down[0] | down[1];
        if all == 0 {
            return 0;
        }
        // To 15 bits, so that the squares' sum fits 32.
        let cut = 49u32.saturating_sub(all.leading_zeros());
        let square = |way: [u64; 2]| {
            let [u, v] = way.map(|part| (part >> cut) as u32);
            u.wrapping_mul(u).wrapping_add(v.wrapping_mul(v))
        };
        let square = square(right).max(square(down));
        // The square is at most 2^exponent, and above half of that.
        let exponent = 32u32.wrapping_sub(square.wrapping_sub(1).leading_zeros());
        let whole = exponent.wrapping_add(2u32.wrapping_mul(cut));
        // Level n where the square of texels is in (2^(2n - 1), 2^(2n + 1)].
        (whole.saturating_sub(2u32.wrapping_mul(unit_bits.wrapping_add(16))) >> 1).min(last)
    }
}
