use super::{approximate, trigonometry, whole};
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

/// An angle, modulo a whole turn: 2^32 steps to the turn, in one word.
///
/// Binary angles wrap around by themselves, so adding them is exact and an angle that turns for
/// years does not lose precision. 90 degrees is a whole number of steps, and its cosine is 0.
///
/// ```
/// use microraster::math::{Angle, AngleUnits};
///
/// let field_of_view = 45.0.degrees();
/// assert_eq!(field_of_view, Angle::from_turns(0.125));
/// assert_eq!(90.0.degrees().sin_cos(), (1.0, 0.0));
/// assert_eq!(350.0.degrees() + 20.0.degrees(), 10.0.degrees());
/// ```
///
/// # Range
///
/// Constructors take every float and subtract whole turns exactly, however many there are. NaN
/// and infinity give [`Angle::ZERO`]. What comes out is at least -1/2 turn and less than 1/2.
///
/// # Rounding
///
/// A step is 8.4e-8 degrees or 1.5e-9 radians. Constructors round to the nearest step, within
/// 0.51 of it; what comes out is rounded once more, to the nearest float.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Angle {
    /// In units of 2^-32 turn.
    steps: u32,
}

/// 1/360, by long division.
const TURNS_PER_DEGREE: [u32; 8] = {
    let mut words = [0; 8];
    let mut remainder = 1u64;
    let mut i = 0;
    while i < 6 {
        remainder <<= 32;
        words[i] = ((remainder / 360) & 0xFFFF_FFFF) as u32;
        remainder %= 360;
        i += 1;
    }
    words
};

/// 1 / (2 pi).
const TURNS_PER_RADIAN: [u32; 8] =
    [0x28BE_60DB, 0x9391_054A, 0x7F09_D5F4, 0x7D4D_3770, 0x36D8_A566, 0x4F10_E410, 0, 0];

/// 1/2, because 1 is no fraction.
const TURNS_PER_HALF_TURN: [u32; 8] = [0x8000_0000, 0, 0, 0, 0, 0, 0, 0];

/// A step, 2^-32 turn.
const STEP: f32 = 1.0 / 4_294_967_296.0;

impl Angle {
    /// No turn at all.
    pub const ZERO: Self = Self { steps: 0 };

    /// The angle of so many degrees.
    #[must_use]
    pub const fn from_degrees(degrees: f32) -> Self {
        Self { steps: trigonometry::times_fraction(degrees, &TURNS_PER_DEGREE) }
    }

    /// The angle of so many radians.
    #[must_use]
    pub const fn from_radians(radians: f32) -> Self {
        Self { steps: trigonometry::times_fraction(radians, &TURNS_PER_RADIAN) }
    }

    /// The angle of so many whole turns.
    #[must_use]
    pub const fn from_turns(turns: f32) -> Self {
        // Doubling is exact; where it overflows, the number of turns is whole.
        Self { steps: trigonometry::times_fraction(turns * 2.0, &TURNS_PER_HALF_TURN) }
    }

    /// Half of the value in [-1/2, 1/2) turn: the same as `self * 0.5`, in integers.
    pub(crate) const fn half(self) -> Self {
        let value = self.steps.cast_signed();
        // To the precision of a float, and from there to the nearest step, away from zero.
        let size = whole(value.unsigned_abs() as f32).cast_unsigned().wrapping_add(1) >> 1;
        Self { steps: if value < 0 { size.wrapping_neg() } else { size } }
    }

    /// In degrees, in [-180, 180).
    #[must_use]
    pub const fn degrees(self) -> f32 {
        (self.steps.cast_signed() as i64 * 360) as f32 * STEP
    }

    /// In radians, in [-pi, pi).
    #[must_use]
    pub const fn radians(self) -> f32 {
        /// 2 pi * 2^29.
        const TURN: i64 = 3_373_259_426;
        (self.steps.cast_signed() as i64 * TURN) as f32 * (STEP / 536_870_912.0)
    }

    /// In turns, in [-1/2, 1/2).
    #[must_use]
    pub const fn turns(self) -> f32 {
        self.steps.cast_signed() as f32 * STEP
    }

    /// The sine. See [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub const fn sin(self) -> f32 {
        self.sin_cos().0
    }

    /// The cosine. See [`sin_cos`](Self::sin_cos).
    #[must_use]
    pub const fn cos(self) -> f32 {
        self.sin_cos().1
    }

    /// Sine and cosine, for the price of both.
    ///
    /// # Rounding
    ///
    /// At most 3.3e-8 from the true value of the angle, which is itself within 0.8e-9 radians of
    /// what its constructor was given: 3.4e-8 in all, for an argument of any size. Exact at
    /// multiples of 90 degrees.
    ///
    /// # Cost
    ///
    /// Eleven 32 x 32 bit products and two conversions to float; no tables, no float arithmetic
    /// but scaling by a power of two.
    ///
    /// # Measured
    /// <!-- tradeoff: teapot/trigonometry=exact -->
    /// `exact` in the scene `teapot`: 1.61 M (M4F), 2.69 M (M0+), 1.75 M (RV32) instructions a frame; PSNR 40.7 dB.
    #[must_use]
    pub const fn sin_cos(self) -> (f32, f32) {
        trigonometry::sin_cos(self.steps)
    }

    /// The tangent: sine divided by cosine.
    ///
    /// # Range
    ///
    /// Infinite at 90 degrees, minus infinity at -90.
    ///
    /// # Rounding
    ///
    /// At most 1.7e-7 of the value within 60 degrees of zero, but for an absolute error of 1e-9.
    #[must_use]
    pub const fn tan(self) -> f32 {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    /// Sine and cosine from a parabola: a named sacrifice of accuracy for speed where the core has
    /// a floating-point unit. Without one, [`sin_cos`](Self::sin_cos) is the faster as well.
    ///
    /// # Rounding
    ///
    /// At most 1.1e-3 from the true value. Sine and cosine of one angle do not quite square to 1.
    ///
    /// # Measured
    /// <!-- tradeoff: teapot/trigonometry=fast -->
    /// `fast` in the scene `teapot`: 1.61 M (M4F), 2.69 M (M0+), 1.75 M (RV32) instructions a frame; PSNR 40.1 dB.
    #[must_use]
    pub fn sin_cos_fast(self) -> (f32, f32) {
        approximate::sin_cos(self.radians())
    }
}

impl Add for Angle {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { steps: self.steps.wrapping_add(other.steps) }
    }
}

impl AddAssign for Angle {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Angle {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self { steps: self.steps.wrapping_sub(other.steps) }
    }
}

impl SubAssign for Angle {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl Neg for Angle {
    type Output = Self;
    fn neg(self) -> Self {
        Self { steps: self.steps.wrapping_neg() }
    }
}

/// Exact, and modulo a turn like everything here.
impl Mul<i32> for Angle {
    type Output = Self;
    fn mul(self, factor: i32) -> Self {
        Self { steps: self.steps.wrapping_mul(factor.cast_unsigned()) }
    }
}

/// The angle's value in [-1/2, 1/2) turn, multiplied: half of 270 degrees is -45.
impl Mul<f32> for Angle {
    type Output = Self;
    fn mul(self, factor: f32) -> Self {
        Self::from_turns(self.turns() * factor)
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::Angle;
    use crate::math::hard_numbers::{Random, FLOATS};
    use crate::math::AngleUnits;
    use core::f64::consts::TAU;

    fn distance(ours: f32, theirs: f64) -> f64 {
        (f64::from(ours) - theirs).abs()
    }

    #[test]
    fn constants_are_what_they_say() {
        use super::{TURNS_PER_DEGREE, TURNS_PER_RADIAN};
        let value = |words: &[u32; 8]| {
            f64::from(words[0]) / 4_294_967_296.0
                + f64::from(words[1]) / 18_446_744_073_709_551_616.0
        };
        assert!((value(&TURNS_PER_DEGREE) * 360.0 - 1.0).abs() < 1e-15);
        assert!((value(&TURNS_PER_RADIAN) * TAU - 1.0).abs() < 1e-15);
    }

    #[test]
    fn half_is_half() {
        let mut random = Random::new(12);
        let randoms = (0..200_000).map(|_| {
            let word = random.word();
            (word >> (word & 31)).wrapping_mul(if word & 32 == 0 { 1 } else { u32::MAX })
        });
        for steps in
            [0, 1, 2, 3, u32::MAX, 1 << 31, (1 << 31) - 1, (1 << 31) + 1].into_iter().chain(randoms)
        {
            let angle = Angle { steps };
            assert_eq!(angle.half(), angle * 0.5, "{steps:x}");
        }
    }

    #[test]
    fn sine_and_cosine_are_close_everywhere_on_the_circle() {
        let mut worst = 0.0;
        for i in 0..1_000_000u32 {
            let steps = i.wrapping_mul(4294).wrapping_add(i & 7);
            let radians = f64::from(steps) / 4_294_967_296.0 * TAU;
            let (sine, cosine) = Angle { steps }.sin_cos();
            worst = f64::max(worst, distance(sine, radians.sin()));
            worst = f64::max(worst, distance(cosine, radians.cos()));
        }
        std::println!("sin_cos: worst {worst:e}");
        assert!(worst <= 3.3e-8, "{worst:e}");
    }

    #[test]
    fn sine_of_radians_is_close_for_arguments_of_any_size() {
        let mut random = Random::new(7);
        let mut worst = 0.0;
        for limit in [1e-3, 1.0, 4.0, 20.0, 1e3, 1e6, 1e12, 1e20, 1e38] {
            for _ in 0..50_000 {
                let x = random.float(limit);
                let (sine, cosine) = Angle::from_radians(x).sin_cos();
                worst = f64::max(worst, distance(sine, f64::from(x).sin()));
                worst = f64::max(worst, distance(cosine, f64::from(x).cos()));
            }
        }
        std::println!("sin_cos of radians: worst {worst:e}");
        assert!(worst <= 3.4e-8, "{worst:e}");
    }

    #[test]
    fn sine_of_degrees_is_close_within_many_turns() {
        let mut random = Random::new(8);
        for limit in [1.0, 360.0, 1e4, 1e6] {
            for _ in 0..50_000 {
                let x = random.float(limit);
                let radians = (f64::from(x) % 360.0).to_radians();
                assert!(distance(x.degrees().sin(), radians.sin()) <= 3.4e-8, "{x}");
            }
        }
    }

    #[test]
    fn tangent_is_close_within_60_degrees() {
        let mut worst = 0.0;
        for i in -30_000..=30_000i16 {
            let degrees = f32::from(i) / 500.0;
            let truth = f64::from(degrees).to_radians().tan();
            let error = distance(degrees.degrees().tan(), truth);
            worst = f64::max(worst, (error - 1e-9) / truth.abs().max(1e-30));
        }
        std::println!("tan: worst {worst:e}");
        assert!(worst <= 1.7e-7, "{worst:e}");
    }

    #[test]
    fn fast_sine_keeps_its_promise() {
        let mut worst = 0.0;
        for i in 0..1_000_000u32 {
            let angle = Angle { steps: i.wrapping_mul(4294) };
            let (fast, exact) = (angle.sin_cos_fast(), angle.sin_cos());
            worst = f64::max(worst, distance(fast.0, f64::from(exact.0)));
            worst = f64::max(worst, distance(fast.1, f64::from(exact.1)));
        }
        std::println!("sin_cos_fast: worst {worst:e}");
        assert!(worst <= 1.1e-3, "{worst:e}");
    }

    #[test]
    fn quarters_of_a_turn_are_exact_and_have_no_negative_zero() {
        for (degrees, sine, cosine) in
            [(0.0, 0.0, 1.0), (90.0, 1.0, 0.0), (180.0, 0.0, -1.0), (-90.0, -1.0, 0.0f32)]
        {
            let (s, c) = Angle::from_degrees(degrees).sin_cos();
            assert_eq!([s.to_bits(), c.to_bits()], [f32::to_bits(sine), cosine.to_bits()]);
        }
        assert_eq!(90.0.degrees().tan().to_bits(), f32::INFINITY.to_bits());
        assert_eq!((-90.0).degrees().tan().to_bits(), f32::NEG_INFINITY.to_bits());
    }

    #[test]
    fn units_come_back_as_they_went_in() {
        for degrees in -179..180i16 {
            let degrees = f32::from(degrees);
            assert_eq!(degrees.degrees().degrees().to_bits(), (degrees + 0.0).to_bits());
        }
        let third = core::f32::consts::FRAC_PI_3;
        assert_eq!(third.radians().radians().to_bits(), third.to_bits());
        assert_eq!(0.375.turns(), 135.0.degrees());
        assert_eq!(540.0.degrees().turns().to_bits(), (-0.5f32).to_bits());
        assert_eq!(3_600_090.0.degrees(), 90.0.degrees());
    }

    #[test]
    fn arithmetic_is_modulo_a_turn() {
        assert_eq!(170.0.degrees() + 20.0.degrees(), (-170.0).degrees());
        assert_eq!(90.0.degrees() * 5, 90.0.degrees());
        assert_eq!(90.0.degrees() * 0.5, 45.0.degrees());
        assert_eq!(-(180.0.degrees()), 180.0.degrees());
    }

    #[test]
    fn every_float_gives_an_angle() {
        for x in FLOATS {
            for angle in [x.degrees(), x.radians(), x.turns(), 90.0.degrees() * x] {
                let (sine, cosine) = angle.sin_cos();
                assert!(sine.abs() <= 1.0 && cosine.abs() <= 1.0, "{x}");
                assert!(angle.degrees().abs() <= 180.0, "{x}");
                assert!(!angle.tan().is_nan(), "{x}");
                let (sine, cosine) = angle.sin_cos_fast();
                assert!(sine.abs() <= 1.01 && cosine.abs() <= 1.01, "{x}");
            }
        }
        assert_eq!(f32::NAN.degrees(), Angle::ZERO);
        assert_eq!(f32::INFINITY.turns(), Angle::ZERO);
        assert_eq!(f32::MAX.turns(), Angle::ZERO);
    }
}
