use super::Angle;

/// Units as a suffix of a number: `45.0.degrees()`.
///
/// Implemented for `f32` only; that is also what makes the type of a plain literal clear.
///
/// ```
/// use microraster::math::{Angle, AngleUnits};
///
/// let slow = 1.5.degrees();
/// assert_eq!(slow, Angle::from_degrees(1.5));
/// assert_eq!(0.5.turns(), 180.0.degrees());
/// ```
///
/// # Range
///
/// As for [`Angle`]: every float, modulo a turn; NaN and infinity give [`Angle::ZERO`].
pub trait AngleUnits {
    /// So many degrees, 360 to the turn.
    fn degrees(self) -> Angle;

    /// So many radians, 2 pi to the turn.
    fn radians(self) -> Angle;

    /// So many whole turns.
    fn turns(self) -> Angle;
}

impl AngleUnits for f32 {
    fn degrees(self) -> Angle {
        Angle::from_degrees(self)
    }

    fn radians(self) -> Angle {
        Angle::from_radians(self)
    }

    fn turns(self) -> Angle {
        Angle::from_turns(self)
    }
}
