//! Amounts of memory on the command line.

use std::str::FromStr;

/// Bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Bytes(pub(crate) u64);

impl FromStr for Bytes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let lower = text.to_ascii_lowercase();
        let number = lower.strip_suffix('b').unwrap_or(&lower);
        let number = number.strip_suffix('i').unwrap_or(number);
        let (number, unit) = match number.strip_suffix(['k', 'm']) {
            Some(rest) if number.ends_with('k') => (rest, 1 << 10),
            Some(rest) => (rest, 1 << 20),
            None => (number, 1),
        };
        number
            .parse::<u64>()
            .ok()
            .and_then(|number| number.checked_mul(unit))
            .filter(|bytes| (1..1 << 32).contains(bytes))
            .map(Self)
            .ok_or_else(|| "write it like 64K, 1M or 65536; 1 to 4095M are known".into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_two() {
        for (text, bytes) in
            [("64K", 65_536), ("64k", 65_536), ("64KB", 65_536), ("2MiB", 2 << 20), ("1000", 1000)]
        {
            assert_eq!(text.parse(), Ok(Bytes(bytes)), "{text}");
        }
        for text in ["", "K", "64G", "-1", "0", "1.5K", "99999999999999999999", "4096M"] {
            assert!(text.parse::<Bytes>().is_err(), "{text}");
        }
    }
}
