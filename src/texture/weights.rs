/// Where a point lies between four texels: its distance from the upper left one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Weights {
    /// To the right, in units of 2^-8: 0 to 255.
    x: u32,
    /// Down, in units of 2^-8: 0 to 255.
    y: u32,
}

impl Weights {
    /// `x` to the right and `y` down, in units of 2^-8; only the low 8 bits count.
    #[inline(always)]
    pub const fn new(x: u32, y: u32) -> Self {
        Self { x: x & 255, y: y & 255 }
    }

    /// The distances to the right and down in units of 2^-5, cut off: 0 to 31.
    #[inline(always)]
    pub const fn coarse(self) -> [u32; 2] {
        [self.x >> 3, self.y >> 3]
    }

    /// The shares of the four texels (upper left, upper right, lower left, lower right) in units of
    /// 2^-8; their sum is 256.
    ///
    /// # Rounding
    /// Half a unit at most: the sum is exact, and with it the mean of equal texels.
    #[inline(always)]
    pub const fn bytes(self) -> [u32; 4] {
        let both = (self.x.wrapping_mul(self.y).wrapping_add(128)) >> 8;
        let below = self.y.wrapping_sub(both);
        [256u32.wrapping_sub(self.x).wrapping_sub(below), self.x.wrapping_sub(both), below, both]
    }

    /// The same shares in units of 2^-11, for channels of 5 and 6 bits; their sum is 2048.
    #[inline(always)]
    pub const fn fine(self) -> [u32; 4] {
        let both = (self.x.wrapping_mul(self.y).wrapping_add(16)) >> 5;
        let below = (self.y << 3).wrapping_sub(both);
        let right = (self.x << 3).wrapping_sub(both);
        [2048u32.wrapping_sub(self.x << 3).wrapping_sub(below), right, below, both]
    }

    /// The same shares in units of 2^-16, exact, for a single channel; their sum is 65536.
    #[inline(always)]
    pub const fn exact(self) -> [u32; 4] {
        let both = self.x.wrapping_mul(self.y);
        let below = (self.y << 8).wrapping_sub(both);
        let right = (self.x << 8).wrapping_sub(both);
        [65536u32.wrapping_sub(self.x << 8).wrapping_sub(below), right, below, both]
    }
}

#[cfg(test)]
mod tests {
    use super::Weights;

    #[test]
    fn shares_are_within_half_a_unit_and_sum_up() {
        for x in 0..256u32 {
            for y in 0..256u32 {
                let weights = Weights::new(x, y);
                let real = [(256 - x) * (256 - y), x * (256 - y), (256 - x) * y, x * y];
                let sets = [(weights.bytes(), 8), (weights.fine(), 5), (weights.exact(), 0)];
                for (shares, cut) in sets {
                    assert_eq!(shares.iter().sum::<u32>(), 65536 >> cut, "{x}, {y}: the sum");
                    for (share, real) in shares.into_iter().zip(real) {
                        let off = (share << cut).abs_diff(real);
                        assert!(off * 2 <= 1 << cut, "{x}, {y}: {share} for {real}");
                    }
                }
            }
        }
    }
}
