//! The name of a picture: one 64-bit number that differs when a byte differs.

/// FNV-1a, 64 bits, over `bytes` in memory order (Fowler, Noll and Vo; RFC 9923).
///
/// Of a picture, the bytes are those of the colour buffer. Print it as 16 hex digits.
///
/// # Range
///
/// Any length. It names pictures in tests; it is no protection against forgery.
///
/// ```
/// use microraster::host::fnv1a64;
///
/// assert_eq!(format!("{:016x}", fnv1a64(b"")), "cbf29ce484222325");
/// assert_eq!(format!("{:016x}", fnv1a64(b"foobar")), "85944171f73967e8");
/// ```
#[must_use]
pub fn fnv1a64(bytes: &[u8]) -> u64 {
    fnv1a64_after(FNV1A64_START, bytes)
}

/// The hash of no bytes at all: where [`fnv1a64_after`] begins.
pub const FNV1A64_START: u64 = 0xcbf2_9ce4_8422_2325;

/// The hash of all bytes so far, whose hash is `hash`, and of `bytes` after them: for a sequence of
/// pictures, or bands of one.
///
/// ```
/// use microraster::host::{fnv1a64, fnv1a64_after};
///
/// assert_eq!(fnv1a64_after(fnv1a64(b"foo"), b"bar"), fnv1a64(b"foobar"));
/// ```
#[must_use]
pub fn fnv1a64_after(hash: u64, bytes: &[u8]) -> u64 {
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    bytes.iter().fold(hash, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}
