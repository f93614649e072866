//! Every input of the functions that stand for division and roots.

use crate::tally::{exhaustive, is_thorough};
use microraster::math::{inverse_sqrt, reciprocal};

/// One, in both tables' products.
const ONE: u64 = 1 << 62;

/// Far from a power of two, so that a stride meets all low bits.
const STRIDE: usize = 1_009;

/// All numbers of a range, or in the plain run some of them and both ends.
fn numbers(from: u32, last: u32) -> impl Iterator<Item = u32> {
    let step = if is_thorough() { 1 } else { STRIDE };
    (from..=last).step_by(step).chain([from, last])
}

#[test]
fn the_reciprocal_of_every_mantissa_keeps_its_bound() {
    exhaustive("reciprocals of all mantissas", || {
        // 2^62 2^-29.4, rounded down.
        const BOUND: u64 = 6_509_758_560;
        let (mut tried, mut worst) = (0, 0);
        for n in numbers(1 << 31, u32::MAX) {
            let found = reciprocal(n);
            assert!(found.shift == 62 && found.mantissa >> 30 == 1, "{found:?} of {n}");
            worst = worst.max((u64::from(found.mantissa) * u64::from(n)).abs_diff(ONE));
            tried += 1;
        }
        println!("reciprocal: 2^{:.2} off", (worst as f64 / ONE as f64).log2());
        assert!(worst <= BOUND, "off by {worst} 2^-62");
        assert!(!is_thorough() || worst > BOUND * 9 / 10, "no bound but a guess: {worst}");
        tried
    });
}

#[test]
fn the_inverse_root_of_every_normalised_number_keeps_its_bound() {
    exhaustive("inverse square roots of all normalised numbers", || {
        // (1 -+ 0.00014)^2 of 2^62: the square of the root times the number.
        let square = |root: f64| (root * root * ONE as f64) as u64;
        let within = square(1.0 - 1.4e-4)..=square(1.0 + 1.4e-4);
        let (mut tried, mut least, mut most) = (0, ONE, ONE);
        // All that have no two leading zeros: the others are these, a power of four apart.
        for n in numbers(1 << 30, u32::MAX) {
            let found = inverse_sqrt(n);
            assert!(found.shift == 31, "{found:?} of {n}");
            let root = u64::from(found.mantissa);
            let product = root * root * u64::from(n);
            (least, most) = (least.min(product), most.max(product));
            tried += 1;
        }
        let off = |product: u64| (product as f64 / ONE as f64).sqrt() - 1.0;
        println!("inverse square root: {:.6} to {:.6} off", off(least), off(most));
        assert!(within.contains(&least) && within.contains(&most), "{least} to {most}");
        tried
    });
}

#[test]
fn numbers_with_leading_zeros_are_the_normalised_ones_shifted() {
    for zeros in 0..32 {
        for top in (1_u32 << 31..=u32::MAX).step_by(104_729_003) {
            let n = top >> zeros;
            let (found, normal) = (reciprocal(n), reciprocal(n << zeros));
            assert_eq!(found.mantissa, normal.mantissa, "1/{n}");
            assert_eq!(found.shift + zeros, normal.shift, "1/{n}");
            let (found, normal) = (inverse_sqrt(n), inverse_sqrt(n << (zeros & !1)));
            assert_eq!(found.mantissa, normal.mantissa, "1/sqrt({n})");
            assert_eq!(found.shift + zeros / 2, normal.shift, "1/sqrt({n})");
        }
    }
}
