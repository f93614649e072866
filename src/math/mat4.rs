use super::{Angle, Vec3, Vec4, BY_HALVES};
use core::ops::Mul;

/// A matrix of 4 x 4 floats, for column vectors: `m * v` transforms `v`, and `a * b` is the
/// transform that does `b` first.
///
/// Stored as four columns: for an affine transform `x`, `y` and `z` are what becomes of the three
/// axes, and `w` is where the origin goes. In memory the sixteen numbers of
/// [`to_columns`](Self::to_columns) lie as in OpenGL and glTF; written on paper, each column stands
/// upright.
///
/// ```
/// use microraster::math::{AngleUnits, Mat4, Vec3};
///
/// let lift = Mat4::translation(Vec3::new(0.0, 2.0, 0.0));
/// let turn = Mat4::rotation_z(90.0.degrees());
/// assert_eq!((lift * turn).transform_point(Vec3::X), Vec3::new(0.0, 3.0, 0.0));
/// assert_eq!((lift * turn).transform_vector(Vec3::X), Vec3::Y);
/// ```
///
/// # Rounding
///
/// Every product and sum rounds once, in the order written: the bits are the same on every target.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat4 {
    /// The first column: what becomes of the x axis.
    pub x: Vec4,
    /// The second column: what becomes of the y axis.
    pub y: Vec4,
    /// The third column: what becomes of the z axis.
    pub z: Vec4,
    /// The fourth column: what becomes of the origin.
    pub w: Vec4,
}

impl Default for Mat4 {
    fn default() -> Self {
        Self::IDENTITY
    }
}

impl Mat4 {
    /// Changes nothing.
    pub const IDENTITY: Self = Self::from_columns(Vec4::X, Vec4::Y, Vec4::Z, Vec4::W);

    /// Changes nothing; the same as [`Self::IDENTITY`].
    #[must_use]
    pub const fn identity() -> Self {
        Self::IDENTITY
    }

    /// Whether this is [`IDENTITY`](Self::IDENTITY) to the bit.
    #[inline(never)]
    fn is_identity(&self) -> bool {
        const ONE: u32 = 1_f32.to_bits();
        let Self { x, y, z, w } = self;
        let zeros = [[x.y, x.z, x.w], [y.x, y.z, y.w], [z.x, z.y, z.w], [w.x, w.y, w.z]];
        let zeros = zeros.as_flattened().iter().fold(0, |any, zero| any | zero.to_bits());
        let ones = [x.x, y.y, z.z, w.w].iter().fold(0, |any, one| any | one.to_bits() ^ ONE);
        zeros | ones == 0
    }

    /// `self * first`, or the other one where one of them is the identity: in a product zeros may
    /// change their sign, and an infinite number makes NaN of others. Many draws turn nothing, and where
    /// floats are software a product costs more than a small mesh.
    #[inline(never)]
    pub(crate) fn after(&self, first: &Self) -> Self {
        if first.is_identity() {
            *self
        } else if self.is_identity() {
            *first
        } else {
            *self * *first
        }
    }

    /// From four columns.
    #[must_use]
    pub const fn from_columns(x: Vec4, y: Vec4, z: Vec4, w: Vec4) -> Self {
        Self { x, y, z, w }
    }

    /// From four rows, the way a matrix is printed.
    #[must_use]
    pub const fn from_rows(x: Vec4, y: Vec4, z: Vec4, w: Vec4) -> Self {
        Self::from_columns(x, y, z, w).transpose()
    }

    /// The four columns.
    #[must_use]
    pub const fn to_columns(self) -> [[f32; 4]; 4] {
        [self.x.to_array(), self.y.to_array(), self.z.to_array(), self.w.to_array()]
    }

    /// Rows and columns exchanged.
    #[must_use]
    pub const fn transpose(self) -> Self {
        let Self { x, y, z, w } = self;
        Self::from_columns(
            Vec4::new(x.x, y.x, z.x, w.x),
            Vec4::new(x.y, y.y, z.y, w.y),
            Vec4::new(x.z, y.z, z.z, w.z),
            Vec4::new(x.w, y.w, z.w, w.w),
        )
    }

    /// Moves points by `offset`.
    #[must_use]
    pub const fn translation(offset: Vec3) -> Self {
        Self { w: offset.extend(1.0), ..Self::IDENTITY }
    }

    /// Scales each axis by its factor.
    #[must_use]
    pub const fn scale(factors: Vec3) -> Self {
        Self::from_columns(
            Vec4::new(factors.x, 0.0, 0.0, 0.0),
            Vec4::new(0.0, factors.y, 0.0, 0.0),
            Vec4::new(0.0, 0.0, factors.z, 0.0),
            Vec4::W,
        )
    }

    /// Turns about the x axis, y towards z: counter-clockwise seen from the axis' positive end.
    #[must_use]
    pub fn rotation_x(angle: Angle) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self {
            y: Vec4::new(0.0, cosine, sine, 0.0),
            z: Vec4::new(0.0, 0.0 - sine, cosine, 0.0),
            ..Self::IDENTITY
        }
    }

    /// Turns about the y axis, z towards x: counter-clockwise seen from the axis' positive end.
    #[must_use]
    pub fn rotation_y(angle: Angle) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self {
            x: Vec4::new(cosine, 0.0, 0.0 - sine, 0.0),
            z: Vec4::new(sine, 0.0, cosine, 0.0),
            ..Self::IDENTITY
        }
    }

    /// Turns about the z axis, x towards y: counter-clockwise seen from the axis' positive end.
    #[must_use]
    pub fn rotation_z(angle: Angle) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self {
            x: Vec4::new(cosine, sine, 0.0, 0.0),
            y: Vec4::new(0.0 - sine, cosine, 0.0, 0.0),
            ..Self::IDENTITY
        }
    }

    /// Turns about an axis through the origin, counter-clockwise seen from its positive end
    /// (Rodrigues' formula).
    ///
    /// # Range
    ///
    /// The axis may be of any length; if it has no direction (see [`Vec3::normalize`]), nothing
    /// turns.
    #[must_use]
    pub fn rotation(axis: Vec3, angle: Angle) -> Self {
        let axis = axis.normalize();
        if axis == Vec3::ZERO {
            return Self::IDENTITY;
        }
        let (sine, cosine) = angle.sin_cos();
        let turned = |v: Vec3| {
            (v * cosine + axis.cross(v) * sine + axis * (axis.dot(v) * (1.0 - cosine))).extend(0.0)
        };
        Self::from_columns(turned(Vec3::X), turned(Vec3::Y), turned(Vec3::Z), Vec4::W)
    }

    /// The product with a point: w is taken as 1 and not computed.
    ///
    /// # Range
    ///
    /// For affine transforms; projections need the whole [`Vec4`] and [`Vec4::project`].
    #[must_use]
    pub fn transform_point(self, point: Vec3) -> Vec3 {
        self.transform_vector(point) + self.w.truncate()
    }

    /// The product with a direction: translation does not move it.
    #[must_use]
    pub fn transform_vector(self, vector: Vec3) -> Vec3 {
        self.x.truncate() * vector.x + self.y.truncate() * vector.y + self.z.truncate() * vector.z
    }

    /// The factor by which the transform enlarges volumes, negative if it mirrors.
    #[must_use]
    pub fn determinant(self) -> f32 {
        let (upper, lower) = self.minors();
        Self::determinant_of(upper, lower)
    }

    /// The transform that undoes this one, from the 2 x 2 minors (Laplace expansion).
    ///
    /// # Errors
    ///
    /// `None` if there is none in floats: the determinant is zero or so small (2.9e-39, a uniform
    /// scale of 1.4e-13) that its reciprocal is infinite, or an element of the result is not finite.
    ///
    /// # Rounding
    ///
    /// Elements are a few 2^-24 off, times the condition of the matrix; no pivoting.
    ///
    /// # Cost
    ///
    /// 94 multiplications, 49 additions, and one division.
    #[must_use]
    pub fn inverse(self) -> Option<Self> {
        let (upper, lower) = self.minors();
        let determinant = Self::determinant_of(upper, lower);
        // NaN is not greater than zero either.
        let invertible = determinant.abs() > 0.0;
        if !invertible {
            return None;
        }
        let reciprocal = 1.0 / determinant;
        let Self { x, y, z, w } = self;
        let ([u0, u1, u2, u3, u4, u5], [l0, l1, l2, l3, l4, l5]) = (upper, lower);

        // The columns of the inverse are the cofactors of the rows.
        let inverse = Self::from_columns(
            Vec4::new(
                y.y * l5 - z.y * l4 + w.y * l3,
                z.y * l2 - x.y * l5 - w.y * l1,
                x.y * l4 - y.y * l2 + w.y * l0,
                y.y * l1 - x.y * l3 - z.y * l0,
            ),
            Vec4::new(
                z.x * l4 - y.x * l5 - w.x * l3,
                x.x * l5 - z.x * l2 + w.x * l1,
                y.x * l2 - x.x * l4 - w.x * l0,
                x.x * l3 - y.x * l1 + z.x * l0,
            ),
            Vec4::new(
                y.w * u5 - z.w * u4 + w.w * u3,
                z.w * u2 - x.w * u5 - w.w * u1,
                x.w * u4 - y.w * u2 + w.w * u0,
                y.w * u1 - x.w * u3 - z.w * u0,
            ),
            Vec4::new(
                z.z * u4 - y.z * u5 - w.z * u3,
                x.z * u5 - z.z * u2 + w.z * u1,
                y.z * u2 - x.z * u4 - w.z * u0,
                x.z * u3 - y.z * u1 + z.z * u0,
            ),
        );
        let inverse = Self::from_columns(
            inverse.x * reciprocal,
            inverse.y * reciprocal,
            inverse.z * reciprocal,
            inverse.w * reciprocal,
        );
        inverse.is_finite().then_some(inverse)
    }

    /// Whether no element is infinite or NaN.
    #[must_use]
    pub const fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite() && self.w.is_finite()
    }

    /// Makes a rotation of what was one: after many composed rotations the rounding errors add up,
    /// and axes are neither of length 1 nor perpendicular any more (Gram and Schmidt's method).
    ///
    /// The first axis keeps its direction, the second its plane with the first, the third its
    /// side, so that a mirroring transform stays one. Translation stays, scaling goes.
    ///
    /// # Range
    ///
    /// Where axes have vanished, coincide or are not finite, perpendicular ones are made up.
    ///
    /// # Rounding
    ///
    /// Axes are of length 1 and perpendicular within 5e-7. As much is what a product of two
    /// rotations may add, mostly less: a million products have drifted by 0.3 at worst, and by no
    /// more than 1e-5 where every 64th was followed by this (the tests compose six rotations a
    /// million times).
    ///
    /// # Cost
    ///
    /// Four [normalisations](Vec3::normalize), 24 multiplications.
    #[must_use]
    pub fn orthonormalize(self) -> Self {
        let (x, y, z) = (self.x.truncate(), self.y.truncate(), self.z.truncate());
        let x = match x.normalize() {
            Vec3::ZERO => y.any_perpendicular(),
            unit => unit,
        };
        let y = y.normalize();
        let y = match (y - x * x.dot(y)).normalize() {
            Vec3::ZERO => x.any_perpendicular(),
            unit => unit,
        };
        // A second subtraction removes what cancellation left of the first, for near-parallel axes.
        let y = (y - x * x.dot(y)).normalize();
        let third = x.cross(y);
        let third = if third.dot(z) < 0.0 { -third } else { third };
        Self::from_columns(x.extend(0.0), y.extend(0.0), third.extend(0.0), self.w)
    }

    /// The determinant, from the minors (Laplace expansion by the upper two rows).
    fn determinant_of(upper: [f32; 6], lower: [f32; 6]) -> f32 {
        let [u0, u1, u2, u3, u4, u5] = upper;
        let [l0, l1, l2, l3, l4, l5] = lower;
        u0 * l5 - u1 * l4 + u2 * l3 + u3 * l2 - u4 * l1 + u5 * l0
    }

    /// The determinants of all pairs of columns, in the order xy, xz, xw, yz, yw, zw: of the upper
    /// two rows, and of the lower two.
    fn minors(self) -> ([f32; 6], [f32; 6]) {
        let Self { x, y, z, w } = self;
        let upper = |a: Vec4, b: Vec4| a.x * b.y - a.y * b.x;
        let lower = |a: Vec4, b: Vec4| a.z * b.w - a.w * b.z;
        (
            [upper(x, y), upper(x, z), upper(x, w), upper(y, z), upper(y, w), upper(z, w)],
            [lower(x, y), lower(x, z), lower(x, w), lower(y, z), lower(y, w), lower(z, w)],
        )
    }
}

/// Does `other` first, then `self`.
impl Mul for Mat4 {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        product(&self, &other)
    }
}

impl Mul<Vec4> for Mat4 {
    type Output = Vec4;
    fn mul(self, v: Vec4) -> Vec4 {
        transform(&self, &v)
    }
}

/// One copy, for flash.
#[inline(never)]
fn product(a: &Mat4, b: &Mat4) -> Mat4 {
    let column = |v: &Vec4| transform(a, v);
    Mat4::from_columns(column(&b.x), column(&b.y), column(&b.z), column(&b.w))
}

#[inline(never)]
fn transform(m: &Mat4, v: &Vec4) -> Vec4 {
    let Mat4 { x, y, z, w } = m;
    Vec4::new(
        sum_of_products(x.x, y.x, z.x, w.x, v),
        sum_of_products(x.y, y.y, z.y, w.y, v),
        sum_of_products(x.z, y.z, z.z, w.z, v),
        sum_of_products(x.w, y.w, z.w, w.w, v),
    )
}

/// A row of a matrix times a vector. One copy, for flash.
#[inline(never)]
pub(crate) fn sum_of_products(a: f32, b: f32, c: f32, d: f32, v: &Vec4) -> f32 {
    if !BY_HALVES {
        return a * v.x + b * v.y + c * v.z + d * v.w;
    }
    let [a, b, c, d] = [a, b, c, d].map(f32::to_bits);
    let [x, y, z, w] = v.to_array().map(f32::to_bits);
    let sum = plus(plus(plus(times(a, x), times(b, y)), times(c, z)), times(d, w));
    f32::from_bits(sum)
}

/// The sign of a float.
const SIGN: u32 = 1 << 31;

/// The product of floats by their bits, where floats are software: most elements of matrices are 0 or
/// 1. Of bits, since the compiler makes comparisons of floats of those that begin with floats.
///
/// # Cost
/// 20 instructions of Cortex-M0+ where a factor is 0 or 1, and 12 more than the product itself where
/// none is.
#[inline(never)]
fn times(a: u32, b: u32) -> u32 {
    known_product(a, b).unwrap_or_else(|| (f32::from_bits(a) * f32::from_bits(b)).to_bits())
}

/// The bits of a product by 0 of what is finite, or by 1 of anything: those that it would be rounded
/// to, if it is a number.
#[inline(always)]
const fn known_product(a: u32, b: u32) -> Option<u32> {
    const ONE: u32 = 1_f32.to_bits() << 1;
    const INFINITE: u32 = f32::INFINITY.to_bits() << 1;
    let (size_a, size_b) = (a << 1, b << 1);
    if (size_a == 0 && size_b < INFINITE) || (size_b == 0 && size_a < INFINITE) {
        Some((a ^ b) & SIGN)
    } else if size_a == ONE {
        Some(b ^ (a & SIGN))
    } else if size_b == ONE {
        Some(a ^ (b & SIGN))
    } else {
        None
    }
}

/// The sum, likewise.
#[inline(never)]
fn plus(a: u32, b: u32) -> u32 {
    known_sum(a, b).unwrap_or_else(|| (f32::from_bits(a) + f32::from_bits(b)).to_bits())
}

/// The bits of a sum with 0, if it is a number.
#[inline(always)]
const fn known_sum(a: u32, b: u32) -> Option<u32> {
    if a << 1 == 0 {
        // Of two zeros only both negative ones make a negative one.
        Some(if b << 1 == 0 { a & b } else { b })
    } else if b << 1 == 0 {
        Some(a)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::hard_numbers::Random;

    #[test]
    fn known_products_and_sums_are_those_of_floats() {
        let mut random = Random::new(10);
        let ends = [0.0, 1.0, f32::MIN_POSITIVE, 1e-45, f32::MAX, f32::INFINITY, 2.0, 0.5];
        let near = [1.0 + f32::EPSILON, 1.0 - f32::EPSILON / 2.0, f32::NAN];
        let any = [(); 500].map(|()| f32::from_bits(random.word()));
        let one_side = ends.into_iter().chain(near).chain(any);
        let numbers = || one_side.clone().flat_map(|x| [x, -x]);
        let (mut products, mut sums) = (0, 0);
        let same = |bits: u32, x: f32| {
            bits == x.to_bits() || (x.is_nan() && f32::from_bits(bits).is_nan())
        };
        for a in numbers() {
            for b in numbers() {
                let bits = (a.to_bits(), b.to_bits());
                products += u32::from(known_product(bits.0, bits.1).is_some());
                sums += u32::from(known_sum(bits.0, bits.1).is_some());
                assert!(same(times(bits.0, bits.1), a * b), "{a} * {b}");
                assert!(same(plus(bits.0, bits.1), a + b), "{a} + {b}");
            }
        }
        assert!(products > 4 * 1000 && sums > 2 * 1000, "{products} products, {sums} sums");
    }
}
