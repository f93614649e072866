//! The only place that calls `micromath`: fast functions with named, measured errors.
//!
//! Calls go by path, `F32Ext::sin(x)`, never as methods: where the standard library is linked, its
//! methods of the same names would win, and host and firmware would differ.

use micromath::F32Ext;

/// Sine and cosine of `radians` in [-pi, pi]. Error at most 1.1e-3.
pub(super) fn sin_cos(radians: f32) -> (f32, f32) {
    (F32Ext::sin(radians), F32Ext::cos(radians))
}

/// 1 / sqrt(`x`), relative error at most 3.5 %; `None` unless `x` is positive, normal and finite.
///
/// `micromath` subtracts bit patterns, which overflows for negative numbers and is worthless for
/// subnormal ones.
pub(super) fn inverse_sqrt(x: f32) -> Option<f32> {
    (f32::MIN_POSITIVE..=f32::MAX).contains(&x).then(|| F32Ext::invsqrt(x))
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::inverse_sqrt;
    use crate::math::hard_numbers::FLOATS;

    #[test]
    fn inverse_sqrt_keeps_its_promise_over_all_exponents() {
        let mut worst = 0.0;
        for bits in (f32::MIN_POSITIVE.to_bits()..=f32::MAX.to_bits()).step_by(1009) {
            let x = f32::from_bits(bits);
            let y = inverse_sqrt(x).map_or(0.0, f64::from);
            worst = f64::max(worst, (y * f64::from(x).sqrt() - 1.0).abs());
        }
        std::println!("fast inverse_sqrt: worst {worst:e}");
        assert!(worst <= 3.5e-2, "{worst:e}");
    }

    #[test]
    fn inverse_sqrt_takes_every_float() {
        for x in FLOATS {
            assert_eq!(inverse_sqrt(x).is_some(), x.is_normal() && x > 0.0, "{x}");
        }
    }
}
