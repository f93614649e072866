//! Ways to the inverse square root, by which normals are made units again.

use micromath::F32Ext;
use microraster::math::{inverse_sqrt, sqrt, InverseSqrt};

/// A way to 1 / sqrt(x) for x of about a quarter to one.
pub(crate) trait InverseRoot {
    fn of(x: f32) -> f32;
}

/// From the bits of the number, as `micromath` has it, and `STEPS` of Newton's iteration.
pub(crate) struct Bits<const STEPS: u32>;

impl<const STEPS: u32> InverseRoot for Bits<STEPS> {
    #[inline(always)]
    fn of(x: f32) -> f32 {
        // By path: where `std` is linked, methods of these names are another's.
        let mut y = F32Ext::invsqrt(x);
        for _ in 0..STEPS {
            y *= 1.5 - 0.5 * x * y * y;
        }
        y
    }
}

/// By the crate's table of integers.
pub(crate) struct Table;

impl InverseRoot for Table {
    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "casts saturate; a mantissa has 17 bits"
    )]
    fn of(x: f32) -> f32 {
        // 2^24 x, whose root is 2^12 larger.
        let InverseSqrt { mantissa, shift } = inverse_sqrt((x * 16_777_216.0) as u32);
        mantissa as f32 * 4096.0 / (1_u32 << (shift & 31)) as f32
    }
}

/// By the crate's exact square root and a division.
pub(crate) struct Exact;

impl InverseRoot for Exact {
    #[inline(always)]
    fn of(x: f32) -> f32 {
        1.0 / sqrt(x)
    }
}
