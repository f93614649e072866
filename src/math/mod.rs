//! Vectors, matrices and angles, and the integer functions that stand for division and roots.
//!
//! Everything here gives the same bits on every target: floats are only added, subtracted,
//! multiplied and divided, each operation rounding once in the order written, and all else is done
//! in integers. Nothing panics, whatever the numbers, NaN and infinities included.
//!
//! Spaces are right-handed with y up; a camera looks along -z; pixels run down. Depth is reversed,
//! 1 on the near plane. The functions named `..._fast` are less accurate on purpose and say by how
//! much.
//!
//! ```
//! use microraster::math::{AngleUnits, Mat4, Vec3};
//!
//! let view = Mat4::look_at(Vec3::new(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y);
//! let lens = Mat4::perspective(90.0.degrees(), 1.0, 0.5, None);
//! let screen = Mat4::viewport(0.0, 0.0, 240.0, 240.0);
//!
//! let clip = lens * view * Vec3::new(1.0, 2.0, 0.0).extend(1.0);
//! let pixel = screen.transform_point(clip.project());
//! assert_eq!(pixel, Vec3::new(150.0, 60.0, 0.125));
//! ```

mod angle;
mod angle_units;
mod approximate;
#[cfg(test)]
pub(crate) mod hard_numbers;
mod inverse_sqrt;
mod leading_zeros;
mod mat4;
#[cfg(test)]
mod mat4_tests;
mod projection;
mod reciprocal;
mod sqrt;
mod trigonometry;
mod vec2;
mod vec3;
mod vec4;
mod vector;
mod whole;
mod wide;

/// Counts to `n` in a loop that stays one: the compiler learns neither how often it runs nor where
/// it is, so that it makes no copies of the body. This is about flash.
#[inline(always)]
pub(crate) fn rolled(n: usize) -> impl Iterator<Item = usize> {
    (0..core::hint::black_box(n)).map(core::hint::black_box)
}

/// Tells the compiler that what leads here is rare, so that it lays out the other way without a jump.
#[cold]
#[inline]
pub(crate) const fn rare() {}

/// Lets the compiler forget what it has read: what a turn of a loop needs is then loaded in it, in
/// pairs, instead of being kept on the stack in words one by one.
#[inline(always)]
pub(crate) fn forget() {
    core::sync::atomic::compiler_fence(core::sync::atomic::Ordering::SeqCst);
}

pub use angle::Angle;
pub use angle_units::AngleUnits;
pub use inverse_sqrt::{inverse_sqrt, InverseSqrt};
pub(crate) use leading_zeros::{leading_zeros, zeros_of_byte};
pub(crate) use mat4::sum_of_products;
pub use mat4::Mat4;
pub(crate) use reciprocal::{inlined_reciprocal_of_some, mantissa_of, reciprocal_of_some};
pub use reciprocal::{reciprocal, Reciprocal};
pub use sqrt::sqrt;
pub use vec2::Vec2;
pub use vec3::Vec3;
pub use vec4::Vec4;
pub(crate) use whole::whole;
pub(crate) use wide::{
    half_factor, in_parts, mul_high_30, mul_high_31, mul_high_both_31, mul_high_positive,
    mul_high_signed, weight, weighted_sum, weighted_sum_of_parts, BY_HALVES, HALVES_MULTIPLY,
};
