//! FNV-1a, 64 bits: the hash by which pictures are compared between machines.

/// What the hash of nothing is, and where every hash begins.
pub(crate) const START: u64 = 0xcbf2_9ce4_8422_2325;

/// Continues the hash `state` over `bytes`.
pub(crate) fn fnv1a(state: u64, bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(state, |hash, &byte| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

/// The hash of the first `bytes` bytes of a colour buffer, in the order in which they lie in
/// memory; a count past the end stands for all of them.
pub(crate) fn picture(color: &[u32], bytes: usize) -> u64 {
    let memory: &[u8] = bytemuck::cast_slice(color);
    fnv1a(START, memory.get(..bytes).unwrap_or(memory))
}
