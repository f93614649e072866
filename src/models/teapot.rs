use super::bezier::{Patch, Vector, POINT_DENOMINATOR, STEPS};
use super::newell::{PATCHES, POINTS, UNITS};
use crate::math::Vec3;

/// Grid nodes of all patches, before welding.
const NODES: usize = PATCHES.len() * (STEPS + 1) * (STEPS + 1);

/// Corners of all triangles, 32 of which are none: one row of eight patches is a point.
const CORNERS: usize = 3 * (2 * PATCHES.len() * STEPS * STEPS - 8 * STEPS);

/// The most that an `i16` holds on both sides of zero.
const REACH: i64 = i16::MAX as i64;

/// A mesh as it grows.
struct Builder {
    /// In 1 / (`POINT_DENOMINATOR` * `UNITS`), exact; y up.
    positions: [Vector; NODES],
    normals: [[i8; 3]; NODES],
    vertices: usize,
    indices: [u16; CORNERS],
    corners: usize,
    /// Hash table of vertices, open addressing; `u16::MAX` is a free place.
    places: [u16; PLACES],
}

/// Places of the hash table: under half of them are taken.
const PLACES: usize = 2048;

/// An integer that is in the range of `i8` or `i16`, which conversions at compile time cannot check.
#[allow(clippy::cast_possible_truncation, reason = "TryFrom is not const; both are checked")]
const fn narrow(value: i64) -> (i8, i16) {
    assert!(value.abs() <= REACH, "out of the range of i16");
    (value as i8, value as i16)
}

/// A vertex number, of which there are at most `NODES`.
#[allow(clippy::cast_possible_truncation, reason = "TryFrom is not const; NODES fits")]
const fn number(vertex: usize) -> u16 {
    assert!(vertex < NODES, "out of the range of vertices");
    vertex as u16
}

/// a / b to the nearest integer, halves away from zero, which keeps mirror images equal.
const fn divide_rounded(a: i64, b: i64) -> i64 {
    let half = if a < 0 { -(b / 2) } else { b / 2 };
    (a + half) / b
}

/// From z up to y up: a quarter turn about x, the spout stays at the right.
const fn upright([x, y, z]: Vector) -> Vector {
    [x, z, -y]
}

/// The vector in units of 1/127, each component rounded to nearest.
const fn unit_normal(mut vector: Vector) -> [i8; 3] {
    // Bring the components under 2^30, for squares in 64 bits.
    while vector[0].abs() | vector[1].abs() | vector[2].abs() >= 1 << 30 {
        vector = [vector[0] / 2, vector[1] / 2, vector[2] / 2];
    }
    let [x, y, z] = vector;
    let length = (x * x + y * y + z * z).isqrt();
    [
        narrow(divide_rounded(127 * x, length)).0,
        narrow(divide_rounded(127 * y, length)).0,
        narrow(divide_rounded(127 * z, length)).0,
    ]
}

/// Whether two unit normals belong to one smooth surface: at most 26 degrees apart.
const fn smooth(a: [i8; 3], b: [i8; 3]) -> bool {
    let dot = a[0] as i32 * b[0] as i32 + a[1] as i32 * b[1] as i32 + a[2] as i32 * b[2] as i32;
    dot >= 127 * 127 * 9 / 10
}

impl Builder {
    const fn new() -> Self {
        Self {
            positions: [[0; 3]; NODES],
            normals: [[0; 3]; NODES],
            vertices: 0,
            indices: [0; CORNERS],
            corners: 0,
            places: [u16::MAX; PLACES],
        }
    }

    /// The number of the vertex with this position and a compatible normal, a new one if need be.
    const fn vertex(&mut self, position: Vector, normal: [i8; 3]) -> u16 {
        let [x, y, z] = position;
        let hash =
            x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
        let mut place = ((hash ^ (hash >> 17)).unsigned_abs() & 0x7FF) as usize;
        while self.places[place] != u16::MAX {
            let vertex = self.places[place];
            let [a, b, c] = self.positions[vertex as usize];
            if a == x && b == y && c == z && smooth(self.normals[vertex as usize], normal) {
                return vertex;
            }
            place = (place + 1) % PLACES;
        }
        let vertex = number(self.vertices);
        self.places[place] = vertex;
        self.positions[self.vertices] = position;
        self.normals[self.vertices] = normal;
        self.vertices += 1;
        vertex
    }

    /// Adds a triangle unless an edge of it is a point.
    const fn triangle(&mut self, corners: [u16; 3]) {
        let [a, b, c] = corners;
        if a != b && b != c && c != a {
            self.indices[self.corners] = a;
            self.indices[self.corners + 1] = b;
            self.indices[self.corners + 2] = c;
            self.corners += 3;
        }
    }

    /// Adds the nodes and cells of a patch.
    const fn patch(&mut self, patch: &Patch) {
        let mut grid = [[0; STEPS + 1]; STEPS + 1];
        let mut i = 0;
        while i <= STEPS {
            let mut j = 0;
            while j <= STEPS {
                grid[i][j] = self.vertex(patch.point(i, j), unit_normal(patch.normal(i, j)));
                j += 1;
            }
            i += 1;
        }
        // v before u is counter-clockwise, as the normal is dv x du.
        let mut cell = 0;
        while cell < STEPS * STEPS {
            let (i, j) = (cell / STEPS, cell % STEPS);
            self.triangle([grid[i][j], grid[i][j + 1], grid[i + 1][j + 1]]);
            self.triangle([grid[i][j], grid[i + 1][j + 1], grid[i + 1][j]]);
            cell += 1;
        }
    }

    /// Lower and upper corner of the bounding box.
    const fn bounds(&self) -> [Vector; 2] {
        let (mut low, mut high) = (self.positions[0], self.positions[0]);
        let mut i = 0;
        while i < 3 * self.vertices {
            let (axis, value) = (i % 3, self.positions[i / 3][i % 3]);
            if value < low[axis] {
                low[axis] = value;
            }
            if value > high[axis] {
                high[axis] = value;
            }
            i += 1;
        }
        [low, high]
    }
}

/// The whole teapot, with room to spare in its arrays.
#[allow(long_running_const_eval, reason = "800 exact patch points take a fraction of a second")]
const TEAPOT: Builder = {
    let mut builder = Builder::new();
    let mut i = 0;
    while i < PATCHES.len() {
        let mut points = [[0; 3]; 16];
        let mut k = 0;
        while k < 16 {
            // Published indices count from one.
            let [x, y, z] = POINTS[PATCHES[i][k] as usize - 1];
            points[k] = upright([x as i64, y as i64, z as i64]);
            k += 1;
        }
        builder.patch(&Patch(points));
        i += 1;
    }
    assert!(builder.corners == CORNERS, "exactly 32 triangles are points");
    builder
};

const VERTICES: usize = TEAPOT.vertices;

/// The bounding box, y up.
const BOUNDS: [Vector; 2] = TEAPOT.bounds();

/// The length of the box along x, its longest side.
const LENGTH: i64 = BOUNDS[1][0] - BOUNDS[0][0];

/// The size of one in the integers of the bounding box.
const ONE: f32 = (POINT_DENOMINATOR * UNITS) as f32;

/// The size of a step of [`TEAPOT_POSITIONS`], the same along every axis: model position =
/// [`TEAPOT_OFFSET`] + `TEAPOT_SCALE` * stored position.
///
/// About 9.8e-5: 6.43 units, from handle to spout, in 65534 steps.
pub const TEAPOT_SCALE: f32 = LENGTH as f32 / (2.0 * REACH as f32 * ONE);

/// The middle of the teapot's box, where stored positions are zero. The teapot's axis is at x = 0
/// and z = 0; it stands on y = 0.
pub const TEAPOT_OFFSET: Vec3 = Vec3::new(
    (BOUNDS[0][0] + BOUNDS[1][0]) as f32 / (2.0 * ONE),
    (BOUNDS[0][1] + BOUNDS[1][1]) as f32 / (2.0 * ONE),
    (BOUNDS[0][2] + BOUNDS[1][2]) as f32 / (2.0 * ONE),
);

/// The corners of the teapot: (x to the spout, y up, z to the viewer), in steps of
/// [`TEAPOT_SCALE`] from [`TEAPOT_OFFSET`].
///
/// # Range
///
/// x fills [-32767, 32767]; the other axes use less of it, in proportion.
///
/// # Rounding
///
/// Exact points of the patches, rounded to the nearest step.
pub static TEAPOT_POSITIONS: [[i16; 3]; VERTICES] = {
    let mut positions = [[0; 3]; VERTICES];
    let mut i = 0;
    while i < 3 * VERTICES {
        let axis = i % 3;
        let from_middle = 2 * TEAPOT.positions[i / 3][axis] - BOUNDS[0][axis] - BOUNDS[1][axis];
        positions[i / 3][axis] = narrow(divide_rounded(from_middle * REACH, LENGTH)).1;
        i += 1;
    }
    positions
};

/// The directions out of the surface at [`TEAPOT_POSITIONS`], 127 long.
///
/// # Rounding
///
/// The patches' own normals, not averages of triangles, each component rounded to nearest: within
/// 0.4 degrees.
pub static TEAPOT_NORMALS: [[i8; 3]; VERTICES] = {
    let mut normals = [[0; 3]; VERTICES];
    let mut i = 0;
    while i < VERTICES {
        normals[i] = TEAPOT.normals[i];
        i += 1;
    }
    normals
};

/// The 992 triangles, three indices into [`TEAPOT_POSITIONS`] each, counter-clockwise seen from
/// outside.
pub static TEAPOT_INDICES: [u16; CORNERS] = TEAPOT.indices;
