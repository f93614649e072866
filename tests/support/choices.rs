//! Where a scene's numbers come from: a generator, or bytes that a fuzzer made.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "numbers are cut to what is wanted"
)]
#![allow(dead_code, reason = "each program takes what it needs")]

use crate::support::Random;

/// An endless sequence of numbers; a copy repeats them.
pub(crate) trait Choices: Clone {
    /// Any 64 bits.
    fn next(&mut self) -> u64;

    /// A number in `from..=to`.
    fn range(&mut self, from: i32, to: i32) -> i32;

    /// A number in 0..1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// One time in so many.
    fn is_one_in(&mut self, times: i32) -> bool {
        self.range(1, times) == 1
    }

    /// One of some values.
    fn one_of<T: Copy>(&mut self, values: &[T]) -> T {
        values[self.range(0, values.len() as i32 - 1) as usize]
    }
}

impl Choices for Random {
    fn next(&mut self) -> u64 {
        Self::next(self)
    }

    fn range(&mut self, from: i32, to: i32) -> i32 {
        Self::range(self, from, to)
    }
}

/// The bytes of a file, no more of them for a number than it needs; zeros when they have run out.
#[derive(Clone, Debug)]
pub(crate) struct Bytes<'a>(pub(crate) &'a [u8]);

impl Bytes<'_> {
    /// The next so many bytes, the first one lowest.
    fn take(&mut self, count: usize) -> u64 {
        let (bytes, rest) = self.0.split_at(count.min(self.0.len()));
        self.0 = rest;
        bytes.iter().rev().fold(0, |number, byte| number << 8 | u64::from(*byte))
    }
}

impl Choices for Bytes<'_> {
    fn next(&mut self) -> u64 {
        self.take(8)
    }

    fn range(&mut self, from: i32, to: i32) -> i32 {
        let span = (i64::from(to) - i64::from(from) + 1) as u64;
        let bytes = (64 - (span - 1).leading_zeros()).div_ceil(8);
        (i64::from(from) + (self.take(bytes as usize) % span) as i64) as i32
    }
}
