//! Numbers for tests: the hard ones, and endless reproducible ones.

/// Words at and around every place where integer arithmetic may break.
pub(crate) const WORDS: [u32; 17] = [
    0,
    1,
    2,
    3,
    0x7FFF,
    0x8000,
    0xFFFF,
    0x1_0000,
    0x1_0001,
    0x5555_5555,
    0x7FFF_FFFF,
    0x8000_0000,
    0x8000_0001,
    0xAAAA_AAAA,
    0xFFFF_0000,
    0xFFFF_FFFE,
    0xFFFF_FFFF,
];

/// Floats at and around every place where arithmetic may break.
pub(crate) const FLOATS: [f32; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    1.000_000_1,
    0.999_999_94,
    1.0e-3,
    -1.0e3,
    1.0e10,
    -1.0e20,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    f32::from_bits(1),
    f32::from_bits(0x007F_FFFF),
    f32::EPSILON,
    f32::MAX,
    f32::MIN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::NAN,
];

/// Marsaglia's xorshift (*Journal of Statistical Software* 8, 2003): period 2^64 - 1.
pub(crate) struct Random(u64);

impl Random {
    /// Starts a sequence; equal seeds give equal sequences.
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Any 32 bits.
    pub(crate) fn word(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32
    }

    /// A float in [-limit, limit).
    pub(crate) fn float(&mut self, limit: f32) -> f32 {
        self.word().cast_signed() as f32 / 2_147_483_648.0 * limit
    }
}
