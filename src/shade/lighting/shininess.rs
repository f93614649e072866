/// Powers of a cosine, by a table.
///
/// The 64 intervals lie where the power is more than 1/256: they are narrow where it is steep, so
/// that lines between them are within 1/500.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Shininess {
    /// The cosine at which the table begins, 2^15 being 1.
    from: u32,
    /// Intervals for each step of the cosine, 25 fraction bits.
    slope: u32,
    powers: [u16; 65],
}

/// Up to here a cosine is 1.
const ONE: u32 = 1 << 15;

impl Shininess {
    /// The powers by `exponent`, 0 counting as 1.
    #[allow(clippy::cast_possible_truncation, reason = "between 0 and 2^15")]
    pub(super) fn new(exponent: u8) -> Self {
        let exponent = exponent.max(1);
        // (1 - d)^n < e^(-n d): below 1/256 where n d > 5.55.
        let reach = (182_000 / u32::from(exponent)).min(ONE).div_ceil(64) * 64;
        let from = ONE.saturating_sub(reach);
        let reach = ONE - from;
        let mut powers = [0; 65];
        for (place, step) in powers.iter_mut().zip(0_u32..) {
            let cosine = (from as f32 + (reach * step) as f32 * (1.0 / 64.0)) * (1.0 / ONE as f32);
            *place = (power(cosine, exponent) * ONE as f32 + 0.5) as u16;
        }
        Self { from, slope: (64 << 25) / reach.max(1), powers }
    }

    /// The power of a cosine; 2^15 is 1 in both.
    #[inline(always)]
    pub(super) fn of(&self, cosine: u32) -> u32 {
        let Some(inside) = cosine.checked_sub(self.from) else { return 0 };
        // At most 64 x 2^25; 16 fraction bits are left.
        let place = inside.wrapping_mul(self.slope) >> 9;
        let (interval, part) = ((place >> 16) as usize, place & 0xFFFF);
        let power = |at: usize| u32::from(self.powers.get(at).copied().unwrap_or(1 << 15));
        let (low, high) = (power(interval), power(interval.wrapping_add(1)));
        low.wrapping_add(high.saturating_sub(low).wrapping_mul(part) >> 16)
    }
}

/// By squares.
fn power(mut base: f32, mut exponent: u8) -> f32 {
    let mut power = 1.0;
    while exponent > 0 {
        if exponent & 1 == 1 {
            power *= base;
        }
        base *= base;
        exponent >>= 1;
    }
    power
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    #[test]
    fn powers_are_within_half_a_percent_of_one_for_every_exponent() {
        let mut worst = 0.0_f64;
        for exponent in 1..=255_u8 {
            let table = Shininess::new(exponent);
            for cosine in 0..=ONE {
                let exact = (f64::from(cosine) / f64::from(ONE)).powi(exponent.into());
                let error = (f64::from(table.of(cosine)) / f64::from(ONE) - exact).abs();
                worst = worst.max(error);
                assert!(error <= 1.0 / 200.0, "{cosine} to the {exponent}: off by {error}");
            }
        }
        std::println!("shininess: worst {worst:.5}");
    }
}
