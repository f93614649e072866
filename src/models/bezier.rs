//! Bicubic Bezier patches at the nodes of a grid, in exact integers at compile time.
//!
//! Bernstein's polynomials at t = k/4 have the denominator 4^3, so a point of a patch is a sum of
//! integers over 4^6, and its derivatives over lower powers of four: nothing is rounded until the
//! caller does. (Farin, *Curves and Surfaces for CAGD*, chapters 5 and 14.)

/// Steps along a patch edge.
pub(super) const STEPS: usize = 4;

/// The denominator of the points that [`Patch::point`] returns.
pub(super) const POINT_DENOMINATOR: i64 = 4096;

/// Whole-number vector.
pub(super) type Vector = [i64; 3];

/// A patch of 4 x 4 control points, u along the rows' order and v along a row.
#[derive(Clone, Copy)]
pub(super) struct Patch(pub(super) [Vector; 16]);

/// 64 times the four cubic Bernstein polynomials at k/4.
const CUBIC: [[i64; 4]; STEPS + 1] =
    [[64, 0, 0, 0], [27, 27, 9, 1], [8, 24, 24, 8], [1, 9, 27, 27], [0, 0, 0, 64]];

/// 16 times the three quadratic ones, and a zero: the weights of a derivative's differences.
const QUADRATIC: [[i64; 4]; STEPS + 1] =
    [[16, 0, 0, 0], [9, 6, 1, 0], [4, 8, 4, 0], [1, 6, 9, 0], [0, 0, 16, 0]];

/// a x b.
pub(super) const fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Whether all components are zero.
const fn vanishes(a: Vector) -> bool {
    a[0] == 0 && a[1] == 0 && a[2] == 0
}

impl Patch {
    /// The weighted sum of the control points.
    const fn sum(&self, u: [i64; 4], v: [i64; 4]) -> Vector {
        let mut sum = [0; 3];
        let mut i = 0;
        while i < 16 {
            let weight = u[i / 4] * v[i % 4];
            if weight != 0 {
                let point = self.0[i];
                sum[0] += weight * point[0];
                sum[1] += weight * point[1];
                sum[2] += weight * point[2];
            }
            i += 1;
        }
        sum
    }

    /// The differences of control points one row (`stride` 4) or one column (1) apart. What has no
    /// neighbour there stays zero, and gets the weight zero.
    const fn differences(&self, stride: usize) -> Self {
        let mut differences = [[0; 3]; 16];
        let mut i = 0;
        while i + stride < 16 {
            let mut axis = 0;
            while axis < 3 {
                differences[i][axis] = self.0[i + stride][axis] - self.0[i][axis];
                axis += 1;
            }
            i += 1;
        }
        Self(differences)
    }

    /// The point at (i/4, j/4), times [`POINT_DENOMINATOR`].
    pub(super) const fn point(&self, i: usize, j: usize) -> Vector {
        self.sum(CUBIC[i], CUBIC[j])
    }

    /// The normal d/dv x d/du at (i/4, j/4), of some positive length.
    ///
    /// Where the first or last row is a single point, d/dv vanishes with the distance from it;
    /// the direction in which it vanishes is that of the mixed second derivative, and that makes
    /// the limit of the normal.
    pub(super) const fn normal(&self, i: usize, j: usize) -> Vector {
        let along_u = self.differences(4);
        let du = along_u.sum(QUADRATIC[i], CUBIC[j]);
        let dv = self.differences(1).sum(CUBIC[i], QUADRATIC[j]);
        if !vanishes(dv) {
            return cross(dv, du);
        }
        let mixed = along_u.differences(1).sum(QUADRATIC[i], QUADRATIC[j]);
        // From the last row the patch lies at smaller u.
        if i == 0 {
            cross(mixed, du)
        } else {
            cross(du, mixed)
        }
    }
}
