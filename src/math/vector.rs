//! What the vectors of every dimension share.

/// The factor 2^k that brings a number of magnitude `largest` near 1; `None` for zero, infinity
/// and NaN.
///
/// Multiplying by it is exact, and the squares that follow can neither overflow nor vanish.
pub(super) fn scale_to_one(largest: f32) -> Option<f32> {
    (f32::from_bits(1)..=f32::MAX).contains(&largest).then(|| {
        // The exponent of 1/x is 254 minus that of x; at least that of the smallest normal number.
        let exponent = 254u32.wrapping_sub(largest.to_bits() >> 23).clamp(1, 254);
        f32::from_bits(exponent << 23)
    })
}

/// The smaller number; the second if they are equal or either is NaN.
///
/// `f32::min` leaves open which of two zeros it returns, so its bits may differ by target.
pub(super) fn lesser(a: f32, b: f32) -> f32 {
    if a < b {
        a
    } else {
        b
    }
}

/// The larger number; the second if they are equal or either is NaN.
pub(super) fn greater(a: f32, b: f32) -> f32 {
    if a > b {
        a
    } else {
        b
    }
}

/// Writes the operations that are the same component by component.
macro_rules! vector_operations {
    ($Vector:ident, $size:literal, $first:ident $(, $rest:ident)*) => {
        impl $Vector {
            /// All components zero.
            pub const ZERO: Self = Self::splat(0.0);

            /// All components one.
            pub const ONE: Self = Self::splat(1.0);

            /// The same value in every component.
            #[must_use]
            pub const fn splat(value: f32) -> Self {
                Self { $first: value $(, $rest: value)* }
            }

            /// The components in order.
            #[must_use]
            pub const fn to_array(self) -> [f32; $size] {
                [self.$first $(, self.$rest)*]
            }

            /// The inner product: the sum, from the first component on, of products.
            #[must_use]
            pub fn dot(self, other: Self) -> f32 {
                self.$first * other.$first $(+ self.$rest * other.$rest)*
            }

            /// The square of the length.
            ///
            /// # Range
            ///
            /// Infinite for lengths above 1.8e19, and zero below 2.6e-23.
            #[must_use]
            pub fn length_squared(self) -> f32 {
                self.dot(self)
            }

            /// The Euclidean length.
            ///
            /// # Range
            ///
            /// Every length that fits a float: intermediate squares are scaled.
            ///
            /// # Cost
            ///
            /// A [`sqrt`](crate::math::sqrt()).
            #[must_use]
            pub fn length(self) -> f32 {
                let largest = self.largest_magnitude();
                match scale_to_one(largest) {
                    Some(scale) => crate::math::sqrt((self * scale).length_squared()) / scale,
                    // Zero, infinity or NaN.
                    None => largest,
                }
            }

            /// The vector of length 1 in the same direction.
            ///
            /// # Range
            ///
            /// Every finite vector but zero, however long or short. Zero, and vectors with an
            /// infinite or NaN component, have no direction and give [`Self::ZERO`].
            ///
            /// # Rounding
            ///
            /// The components are within 2.4e-7 of the true ones.
            #[must_use]
            pub fn normalize(self) -> Self {
                let Some(scale) = scale_to_one(self.largest_magnitude()) else {
                    return Self::ZERO;
                };
                let scaled = self * scale;
                scaled / crate::math::sqrt(scaled.length_squared())
            }

            /// A vector of a length near 1 in the same direction: a named sacrifice of accuracy
            /// for speed, without a square root or a division.
            ///
            /// # Range
            ///
            /// Lengths from 1.1e-19 to 1.8e19; others, and vectors that are not finite, give
            /// [`Self::ZERO`].
            ///
            /// # Rounding
            ///
            /// The length is within 3.5 % of 1; the direction is as good as that of
            /// [`normalize`](Self::normalize).
            #[must_use]
            pub fn normalize_fast(self) -> Self {
                match crate::math::approximate::inverse_sqrt(self.length_squared()) {
                    Some(inverse) => self * inverse,
                    None => Self::ZERO,
                }
            }

            /// The mirror image in a plane through the origin with this normal, which must be of
            /// length 1: what a ray becomes when it bounces off.
            #[must_use]
            pub fn reflect(self, normal: Self) -> Self {
                self - normal * (2.0 * self.dot(normal))
            }

            /// The way from `self` (t = 0) to `other` (t = 1), as self (1 - t) + other t: exact at
            /// both ends.
            #[must_use]
            pub fn lerp(self, other: Self, t: f32) -> Self {
                self * (1.0 - t) + other * t
            }

            /// The product component by component: scales each axis on its own.
            #[must_use]
            pub fn component_mul(self, other: Self) -> Self {
                Self { $first: self.$first * other.$first $(, $rest: self.$rest * other.$rest)* }
            }

            /// The smaller of each two components; of equal or unordered ones `other`'s.
            #[must_use]
            pub fn min(self, other: Self) -> Self {
                Self { $first: lesser(self.$first, other.$first) $(, $rest: lesser(self.$rest, other.$rest))* }
            }

            /// The larger of each two components; of equal or unordered ones `other`'s.
            #[must_use]
            pub fn max(self, other: Self) -> Self {
                Self { $first: greater(self.$first, other.$first) $(, $rest: greater(self.$rest, other.$rest))* }
            }

            /// The magnitude of each component.
            #[must_use]
            pub const fn abs(self) -> Self {
                Self { $first: self.$first.abs() $(, $rest: self.$rest.abs())* }
            }

            /// Whether no component is infinite or NaN.
            #[must_use]
            pub const fn is_finite(self) -> bool {
                self.$first.is_finite() $(&& self.$rest.is_finite())*
            }

            /// The largest magnitude of a component, NaN if any is NaN, infinite if only infinite.
            fn largest_magnitude(self) -> f32 {
                // A sum of magnitudes is NaN when one is; what it overflows to is not used.
                let sum = self.$first.abs() $(+ self.$rest.abs())*;
                if sum.is_nan() {
                    return sum;
                }
                let largest = self.$first.abs();
                $(let largest = greater(largest, self.$rest.abs());)*
                largest
            }
        }

        impl From<[f32; $size]> for $Vector {
            fn from([$first $(, $rest)*]: [f32; $size]) -> Self {
                Self { $first $(, $rest)* }
            }
        }

        impl From<$Vector> for [f32; $size] {
            fn from(vector: $Vector) -> Self {
                vector.to_array()
            }
        }

        impl core::ops::Add for $Vector {
            type Output = Self;
            fn add(self, other: Self) -> Self {
                Self { $first: self.$first + other.$first $(, $rest: self.$rest + other.$rest)* }
            }
        }

        impl core::ops::Sub for $Vector {
            type Output = Self;
            fn sub(self, other: Self) -> Self {
                Self { $first: self.$first - other.$first $(, $rest: self.$rest - other.$rest)* }
            }
        }

        impl core::ops::Neg for $Vector {
            type Output = Self;
            fn neg(self) -> Self {
                Self { $first: -self.$first $(, $rest: -self.$rest)* }
            }
        }

        /// Scales all axes alike.
        impl core::ops::Mul<f32> for $Vector {
            type Output = Self;
            fn mul(self, factor: f32) -> Self {
                Self { $first: self.$first * factor $(, $rest: self.$rest * factor)* }
            }
        }

        /// Scales all axes alike.
        impl core::ops::Mul<$Vector> for f32 {
            type Output = $Vector;
            fn mul(self, vector: $Vector) -> $Vector {
                vector * self
            }
        }

        /// The product component by component.
        impl core::ops::Mul for $Vector {
            type Output = Self;
            fn mul(self, other: Self) -> Self {
                self.component_mul(other)
            }
        }

        /// Divides each component, rounding each once. Division by zero follows IEEE 754.
        impl core::ops::Div<f32> for $Vector {
            type Output = Self;
            fn div(self, divisor: f32) -> Self {
                Self { $first: self.$first / divisor $(, $rest: self.$rest / divisor)* }
            }
        }

        impl core::ops::AddAssign for $Vector {
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl core::ops::SubAssign for $Vector {
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl core::ops::MulAssign<f32> for $Vector {
            fn mul_assign(&mut self, factor: f32) {
                *self = *self * factor;
            }
        }
    };
}

pub(super) use vector_operations;
