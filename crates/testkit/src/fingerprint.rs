//! Has something changed? A number that is the same for the same bytes, on every machine.

/// FNV-1a of 64 bits. Against accidents, not against malice.
pub fn fingerprint(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes
        .into_iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}
