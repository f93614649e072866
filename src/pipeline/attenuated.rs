use super::PointSize;
use crate::math::{inverse_sqrt, whole, InverseSqrt};
use crate::shade::VertexInput;

/// Points that grow smaller with distance d from the eye, along the view:
/// `size / sqrt(constant + linear d + quadratic d^2)` pixels, between a least and 256 pixels.
///
/// Source: OpenGL 1.5, section 3.3. With q = near / d, which is what depth codes count, that is
/// `size q / sqrt(constant q^2 + linear near q + quadratic near^2)`: no distance is needed.
///
/// # Range
/// For perspective cameras without a far plane, whose near distance is `near`.
///
/// # Rounding
/// Within 1/1000 and one sixteenth of a pixel, of the distance that the depth code stands for.
///
/// # Cost
/// An integer inverse square root and a product of 64 bits a point.
///
/// ```
/// use microraster::Attenuated;
///
/// // Eight pixels at distance 1, two at distance 4.
/// let size = Attenuated::new(8.0, 0.5, [0.0, 0.0, 1.0]);
/// # let _ = size;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Attenuated {
    /// The sum's coefficients of q^2, q and 1, scaled to 31 bits.
    coefficients: [u32; 3],
    /// The size's factor: mantissa 2^-down.
    mantissa: u32,
    down: u32,
    /// The smallest size, in sixteenths of a pixel.
    least: u32,
}

/// The largest size, in sixteenths of a pixel.
const MOST: u64 = 256 * 16;

impl Attenuated {
    /// `size` pixels, attenuated by the constant, linear and quadratic coefficient; none of these
    /// may be negative, or it counts as 0. The smallest point has one pixel.
    #[allow(clippy::cast_possible_truncation, reason = "scaled to 24 and 31 bits")]
    pub fn new(size: f32, near: f32, [constant, linear, quadratic]: [f32; 3]) -> Self {
        // What is no number is not above 0 either.
        let positive = |v: f32| if v > 0.0 { v } else { 0.0 };
        let terms = [constant, linear * near, quadratic * near * near].map(positive);
        let [a, b, c] = terms;
        // To just below 2^31: by powers of four, whose roots are powers of two.
        let (mut sum, mut scale, mut root) = (a + b + c, 1.0_f32, 1.0_f32);
        let limit = 1_073_741_824.0;
        let mut steps = 0;
        while sum > 0.0 && sum * 4.0 < limit && steps < 40 {
            (sum, scale, root, steps) = (sum * 4.0, scale * 4.0, root * 2.0, steps + 1);
        }
        while sum >= limit && steps < 80 {
            (sum, scale, root, steps) = (sum * 0.25, scale * 0.25, root * 0.5, steps + 1);
        }
        let mut mantissa = positive(size) * 16.0 * root;
        let mut down = 0;
        while mantissa > 0.0 && mantissa < 8_388_608.0 && down < 60 {
            (mantissa, down) = (mantissa * 2.0, down + 1);
        }
        Self {
            coefficients: terms.map(|term| whole(term * scale).cast_unsigned()),
            mantissa: mantissa as u32,
            down,
            least: 16,
        }
    }

    /// No point is smaller than so many pixels.
    #[must_use]
    pub const fn at_least(self, pixels: u8) -> Self {
        Self { least: pixels as u32 * 16, ..self }
    }
}

impl<A> PointSize<A> for Attenuated {
    fn size(&self, _vertex: VertexInput<'_, A>, z: u16) -> u32 {
        let q = u64::from(z.saturating_sub(2));
        let [a, b, c] = self.coefficients.map(u64::from);
        // 65531 codes are 1. With 32 fraction bits the sum is below 2^63.
        let sum = (c << 32).wrapping_add(b.wrapping_mul(q) << 16);
        let sum = sum.wrapping_add(a.wrapping_mul(q).wrapping_mul(q));
        // Its first 31 or 32 bits, by powers of four.
        let down = (33_u32.saturating_sub(sum.leading_zeros())) & !1;
        #[allow(clippy::cast_possible_truncation, reason = "32 bits are left")]
        let InverseSqrt { mantissa, shift } = inverse_sqrt((sum >> (down & 63)) as u32);
        // 16, 17 and 24 bits.
        let size = q.wrapping_mul(mantissa.into()).wrapping_mul(self.mantissa.into());
        let down = shift.wrapping_add(down / 2);
        let size = size.wrapping_shr(down).wrapping_shr(self.down).min(MOST);
        (size as u32).max(self.least)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    #[test]
    fn sizes_are_those_of_the_formula_at_every_code() {
        let cases = [
            (8.0, 0.5, [0.0, 0.0, 1.0]),
            (300.0, 0.1, [1.0, 0.2, 0.03]),
            (20.0, 1.0, [1.0, 0.0, 0.0]),
            (5.0, 0.01, [0.0, 3.0, 0.0]),
            (4000.0, 2.0, [0.5, 0.0, 7.0]),
            (60.0, 0.5, [1000.0, 0.0, 0.0]),
        ];
        for (size, near, [a, b, c]) in cases {
            let points = Attenuated::new(size, near, [a, b, c]).at_least(0);
            let [size, near, a, b, c] = [size, near, a, b, c].map(f64::from);
            for z in (3..=u16::MAX).step_by(7) {
                let d = near * 65_531.0 / (f64::from(z) - 2.0);
                let exact = (size / (a + b * d + c * d * d).sqrt()).min(256.0);
                let input = VertexInput { attributes: &(), position: [0; 3] };
                let seen = f64::from(points.size(input, z)) / 16.0;
                let error = (seen - exact).abs();
                assert!(error <= exact / 1000.0 + 1.0 / 16.0, "{seen} is not {exact} at {d}");
            }
        }
    }

    #[test]
    fn nothing_overflows_for_any_coefficient() {
        let input = || VertexInput { attributes: &(), position: [0; 3] };
        for v in crate::math::hard_numbers::FLOATS {
            for z in [0, 1, 2, 3, 40_000, u16::MAX] {
                for points in [
                    Attenuated::new(v, 0.5, [1.0, 0.5, 0.1]),
                    Attenuated::new(8.0, v, [1.0, 0.5, 0.1]),
                    Attenuated::new(8.0, 0.5, [v, 0.5, v]),
                ] {
                    assert!(points.size(input(), z) <= 256 * 16, "{v}");
                }
            }
        }
    }
}
