use crate::color::{Color, Rgb};
use crate::math::{whole, Vec3};
use crate::shade::DrawContext;

/// How a colour fades into the distance: [`linear`](Self::linear),
/// [`exponential`](Self::exponential), or [`exponential_squared`](Self::exponential_squared).
///
/// Distance is that from the eye along the view, in units of the world. Source: OpenGL 1.5, section
/// 3.10.
///
/// # Rounding
/// What is seen through the fog is a table of 64 intervals, lines between them: within 1/400 of the
/// formula; what the exponential ones leave below 1/512 counts as nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fog {
    color: Color,
    /// The distances where the table begins and ends.
    start: f32,
    end: f32,
    /// How much is seen, 65535 being all.
    seen: [u16; INTERVALS + 1],
}

const INTERVALS: usize = 64;

impl Fog {
    /// All is seen up to the distance `start`, nothing from `end` on.
    pub fn linear(color: Rgb, start: f32, end: f32) -> Self {
        Self::new(color, start, end, |part| 1.0 - part)
    }

    /// `e^(-density d)` is seen at distance d.
    pub fn exponential(color: Rgb, density: f32) -> Self {
        Self::new(color, 0.0, REACH / density, |part| exponential(part * REACH))
    }

    /// `e^(-(density d)^2)` is seen at distance d.
    pub fn exponential_squared(color: Rgb, density: f32) -> Self {
        /// The root of the other's reach.
        const ROOT: f32 = 2.497_999_2;
        Self::new(color, 0.0, ROOT / density, |part| exponential(part * part * REACH))
    }

    #[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
    fn new(color: Rgb, start: f32, end: f32, seen: impl Fn(f32) -> f32) -> Self {
        let mut table = [0; INTERVALS + 1];
        for (place, step) in table.iter_mut().zip(0_u16..) {
            *place = (seen(f32::from(step) / INTERVALS as f32) * 65_535.0 + 0.5) as u16;
        }
        Self { color: color.into(), start, end, seen: table }
    }

    /// How much is seen where the table is at `place`, 65535 being its end; 65535 is all.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "no more than an entry")]
    pub(super) fn seen(&self, place: u16) -> u16 {
        let (interval, part) = (usize::from(place >> 10), u32::from(place & 1023));
        let seen = |at: usize| u32::from(self.seen.get(at).copied().unwrap_or(0));
        let (near, far) = (seen(interval), seen(interval.wrapping_add(1)));
        // What is seen never grows with distance.
        near.wrapping_sub(near.saturating_sub(far).wrapping_mul(part) >> 10) as u16
    }

    /// A colour of which so much is seen.
    ///
    /// # Rounding
    /// Within one 8-bit step: channels are cut off to 8 bits, and the share is rounded to 8.
    #[inline(always)]
    pub(super) fn over(&self, color: Color, seen: u16) -> Color {
        /// A half step of each of two channels.
        const HALF: u32 = 0x0080_0080;
        let share = (u32::from(seen).wrapping_add(128)) >> 8;
        let rest = 256_u32.wrapping_sub(share);
        // Two channels in a word: 255 x 256 and a half step fit 16 bits.
        let mix = |a: u32, b: u32| a.wrapping_mul(share).wrapping_add(b.wrapping_mul(rest));
        let pair = |color: Color| (color.blue_red >> 8) & 0x00FF_00FF;
        let green = |color: Color| color.green >> 24;
        Color {
            blue_red: mix(pair(color), pair(self.color)).wrapping_add(HALF),
            green: mix(green(color), green(self.color)).wrapping_add(HALF & 0xFF) << 16
                | color.green & 0xFFFF,
        }
    }

    /// Where the table is at a mesh's positions.
    pub(super) fn prepare(&self, draw: &DrawContext) -> FogDepth {
        FogDepth::new(draw, self.start, self.end)
    }
}

/// The exponent below which nothing is seen: e^-6.24 is 1/512.
const REACH: f32 = 6.24;

/// e^-x for x of up to 8, from the series of a 64th of it.
fn exponential(x: f32) -> f32 {
    let t = -x * (1.0 / 64.0);
    let mut power = 1.0 + t * (1.0 + t * (0.5 + t * (1.0 / 6.0 + t * (1.0 / 24.0))));
    for _ in 0..6 {
        power *= power;
    }
    power
}

/// The distance of a mesh's positions along the view, as places of a [`Fog`]'s table.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FogDepth {
    row: [i32; 3],
    offset: i32,
    /// Fraction bits.
    fraction: u32,
}

impl FogDepth {
    fn new(draw: &DrawContext, start: f32, end: f32) -> Self {
        let to_eye = (draw.view * draw.model).transpose();
        // The row that makes -z, the distance.
        let row = -to_eye.z;
        let Vec3 { x, y, z } = draw.offset;
        let distance = row.x * x + row.y * y + row.z * z + row.w - start;
        let places = 65_535.0 / (end - start);
        let scale = draw.scale;
        let row = [row.x * scale.x, row.y * scale.y, row.z * scale.z].map(|v| v * places);
        let distance = distance * places;
        let [a, b, c] = row.map(f32::abs);
        let largest = (a + b + c) * 32_768.0 + distance.abs();
        // As many fraction bits as leave room below 2^30; what is no number has none.
        let (mut fraction, mut unit) = (14_u32, 16_384.0_f32);
        // By its bits, so that what is no number is large.
        let limit = 1_073_741_824.0_f32.to_bits();
        while fraction > 0 && (largest * unit).to_bits() >= limit {
            fraction -= 1;
            unit *= 0.5;
        }
        let number = |v: f32| if v.is_nan() { 0 } else { whole(v * unit) };
        Self { row: row.map(number), offset: number(distance), fraction }
    }

    /// The place of a position: 0 where the table begins, 65535 where it ends, and beyond both.
    #[inline]
    pub(super) fn of(&self, position: [i16; 3]) -> i32 {
        let mut sum = self.offset;
        for (factor, position) in self.row.iter().zip(position) {
            sum = sum.saturating_add(factor.saturating_mul(position.into()));
        }
        sum >> (self.fraction & 31)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    #[test]
    fn tables_are_within_a_400th_of_their_formulas() {
        let density = 0.37;
        type Formula = fn(f64) -> f64;
        let fogs: [(Fog, Formula); 3] = [
            (Fog::linear(Rgb::WHITE, 2.0, 12.0), |d| 1.0 - (d - 2.0) / 10.0),
            (Fog::exponential(Rgb::WHITE, density), |d| (-0.37 * d).exp()),
            (Fog::exponential_squared(Rgb::WHITE, density), |d| (-(0.37 * d).powi(2)).exp()),
        ];
        for (fog, formula) in fogs {
            for place in 0..=u16::MAX {
                let part = f64::from(place) / 65_535.0;
                let distance =
                    f64::from(fog.start) + part * (f64::from(fog.end) - f64::from(fog.start));
                let error = f64::from(fog.seen(place)) / 65_535.0 - formula(distance);
                assert!(error.abs() <= 1.0 / 400.0, "off by {error} at {distance}");
            }
        }
    }

    #[test]
    fn what_is_seen_lies_between_the_colour_and_the_fog() {
        let fog = Fog::linear(Rgb::new(10, 200, 255), 0.0, 1.0);
        for seen in (0..=u16::MAX).step_by(17) {
            let part = f64::from(seen) / 65_535.0;
            for (color, channels) in [
                (Color::new(255, 255, 255), [255.0; 3]),
                (Color::new(0, 0, 0), [0.0; 3]),
                (Color::new(77, 130, 201), [77.0, 130.0, 201.0]),
            ] {
                let mixed = fog.over(color.with_alpha(99), seen);
                assert_eq!(mixed.alpha(), 99, "alpha stays");
                let mixed = [mixed.red(), mixed.green(), mixed.blue()];
                for ((mixed, own), fog) in mixed.into_iter().zip(channels).zip([10.0, 200.0, 255.0])
                {
                    let exact = own * part + fog * (1.0 - part);
                    assert!((f64::from(mixed) - exact).abs() <= 1.0, "{mixed} is not {exact}");
                }
            }
        }
        assert_eq!(fog.over(Color::new(1, 2, 3), 65_535), Color::new(1, 2, 3), "nothing of it");
    }
}
