use crate::math::Vec3;

/// A unit normal in three bytes, 127 being 1: plain, so that it can lie in flash as it is.
///
/// # Rounding
/// Directions are off by at most 0.38 degrees.
pub type Normal = [i8; 3];

/// The nearest [`Normal`] to a direction of any length; zero for a zero direction.
#[allow(clippy::cast_possible_truncation, reason = "a float cast saturates")]
pub fn normal(direction: Vec3) -> Normal {
    let Vec3 { x, y, z } = direction.normalize() * 127.0;
    // `as` saturates, so that nothing can overflow.
    let round = |v: f32| (v + if v < 0.0 { -0.5 } else { 0.5 }) as i8;
    [round(x), round(y), round(z)]
}
