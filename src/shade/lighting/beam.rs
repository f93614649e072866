/// Light that arrives at a point.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beam {
    /// Towards where it comes from, in mesh space: [`LENGTH`](Self::LENGTH) long, or zero at the
    /// very place of the light.
    pub direction: [i32; 3],
    /// How much of it arrives, of [`FULL`](Self::FULL): no more than that.
    pub strength: u32,
}

impl Beam {
    /// The length of a direction: with a normal of length 127 its product is 2^21.
    pub const LENGTH: i32 = 16_512;
    /// All of the light.
    pub const FULL: u32 = 1 << 15;
}
