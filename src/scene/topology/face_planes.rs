/// The plane of a triangle in a mesh's own steps, in four bytes that can lie in flash as they are: what
/// [`PlaneScale::bake`] and [`PlaneScale::plane`] make.
///
/// The first three are the normal, as long as the triangle's incircle is wide, and the fourth is how far
/// from position 0 the plane lies, in 65536ths of a step; each 128 above its value.
pub type FacePlane = [u8; 4];

/// What is above the value of a plane's bytes, so that they load without a sign.
const RAISED: i64 = 128;

/// The planes of a mesh's triangles, by which those that certainly show the side that is left out are
/// passed over: neither their indices nor their vertices are looked at.
///
/// Where a mesh has them, [`Cull::Back`](crate::Cull::Back) and [`Cull::Front`](crate::Cull::Front)
/// ask the plane of a triangle first. The picture is the same bit for bit: a triangle that is seen from
/// so near its plane that rounding to subpixels could turn it is asked by its corners, as every triangle
/// is without planes. [`Stats`](crate::Stats) count what is passed over as culled, also where it lies
/// beside the view or has no area there.
///
/// ```
/// use microraster::models::{TEAPOT, TEAPOT_INDICES, TEAPOT_POSITIONS};
/// use microraster::{FacePlane, FacePlanes, IndexedList, Mesh, Normal, PlaneScale, WithPlanes};
///
/// const SCALE: PlaneScale = PlaneScale::of(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
/// static PLANES: [FacePlane; 992] = SCALE.bake(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
/// let teapot: Mesh<Normal, WithPlanes<IndexedList<u16>>> =
///     TEAPOT.with_planes(FacePlanes::new(&PLANES, SCALE));
/// assert_eq!(teapot.triangles(), 992);
/// ```
///
/// # Range
/// Planes are asked where clipping cannot matter: where all positions that lie no farther from 0 than
/// the mesh's [reach](PlaneScale::reach) are between the near and the far plane, and by either axis within
/// 2000 pixels of the viewport's middle, and the viewport has no more than 4094 pixels a side and 2^22 in
/// all. Elsewhere, and where the shader has positions of its own, the mesh is drawn as if it had none.
///
/// Planes of other positions than the mesh has leave out triangles that are seen.
///
/// # Cost
/// Four bytes of flash a triangle, and about 2.5 KB of code in a program that has such a mesh. On Cortex-M4 some 14
/// instructions a triangle, and about 20 more for one that is not left out; one that is costs 60 otherwise, and 90 for
/// each of its vertices that no other triangle asks for. A draw finds out where it is seen from in about
/// 1 100 instructions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FacePlanes<'a> {
    pub(super) planes: &'a [FacePlane],
    pub(super) scale: PlaneScale,
}

impl<'a> FacePlanes<'a> {
    /// A plane that leaves out nothing.
    pub const NO_PLANE: FacePlane = [128; 4];

    /// Planes that were made with this scale, one a triangle in the mesh's order. Triangles behind the last
    /// plane have none.
    pub const fn new(planes: &'a [FacePlane], scale: PlaneScale) -> Self {
        Self { planes, scale }
    }
}

/// What the planes of a mesh's triangles are made for: the mesh's size, and its triangles'.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlaneScale {
    /// The radius of incircle whose triangle has a normal of 127, in steps of positions. Bytes of smaller ones
    /// hold less of them, and fewer are passed over; larger ones count as if theirs were this, which costs nothing.
    pub radius: u16,
    /// By axis the farthest position from 0.
    pub reach: [u16; 3],
}

impl PlaneScale {
    /// The scale for a mesh: the mean radius of its triangles' incircles, at least 1, and the farthest of its positions.
    /// Triangles with indices beyond the positions do not count.
    #[must_use]
    pub const fn of(positions: &[[i16; 3]], indices: &[u16]) -> Self {
        let (triangles, _) = indices.as_chunks::<3>();
        let (mut sum, mut count, mut at) = (0, 0, 0);
        while at < triangles.len() {
            if let Some(corners) = corners_of(positions, triangles[at]) {
                let Shape { normal, perimeter, .. } = Shape::of(corners);
                sum += length(normal) / perimeter;
                count += 1;
            }
            at += 1;
        }
        let (mut reach, mut vertex) = ([0; 3], 0);
        while vertex < positions.len() {
            let [x, y, z] = positions[vertex];
            reach = [farther(reach[0], x), farther(reach[1], y), farther(reach[2], z)];
            vertex += 1;
        }
        Self { radius: narrow(if count == 0 { 1 } else { sum / count }), reach }
    }

    /// The planes of the first `N` triangles, whose corners run counter-clockwise at their front, when the program
    /// is compiled or runs. A triangle that is not there, or has no area, has a plane that leaves out nothing.
    ///
    /// # Rounding
    /// Bytes to the nearest, which draws allow for.
    #[must_use]
    pub const fn bake<const N: usize>(
        self,
        positions: &[[i16; 3]],
        indices: &[u16],
    ) -> [FacePlane; N] {
        let (triangles, _) = indices.as_chunks::<3>();
        let mut planes = [FacePlanes::NO_PLANE; N];
        let mut at = 0;
        while at < N && at < triangles.len() {
            if let Some(corners) = corners_of(positions, triangles[at]) {
                planes[at] = self.plane(corners);
            }
            at += 1;
        }
        planes
    }

    /// The plane of one triangle, whose corners run counter-clockwise at its front: the order in which its mesh
    /// has them. One without area has a plane that leaves out nothing.
    #[must_use]
    pub const fn plane(self, corners: [[i16; 3]; 3]) -> FacePlane {
        let Shape { normal, perimeter, offset } = Shape::of(corners);
        let radius = if self.radius == 0 { 1 } else { self.radius as i64 };
        // A normal of at most 127, however wide the triangle is.
        let (most, length) = (perimeter * radius, length(normal) + 1);
        let unit = if most > length { most } else { length };
        let [x, y, z] = normal;
        [
            byte(127 * x, unit),
            byte(127 * y, unit),
            byte(127 * z, unit),
            byte(127 * offset, unit * STEPS),
        ]
    }
}

/// The farther of two positions from 0.
const fn farther(most: u16, v: i16) -> u16 {
    if v.unsigned_abs() > most {
        v.unsigned_abs()
    } else {
        most
    }
}

/// The range of positions, by which a plane's distance is divided.
const STEPS: i64 = 1 << 16;

/// A triangle's normal, twice its area long; its perimeter, rounded up and at least 1; and the normal's product with
/// a point of it, less than zero where that lies behind position 0.
struct Shape {
    normal: [i64; 3],
    perimeter: i64,
    offset: i64,
}

impl Shape {
    const fn of([a, b, c]: [[i16; 3]; 3]) -> Self {
        let (ab, bc, ca) = (side(a, b), side(b, c), side(c, a));
        // Sides have 17 bits, products 34.
        let normal = [
            ca[1] * ab[2] - ca[2] * ab[1],
            ca[2] * ab[0] - ca[0] * ab[2],
            ca[0] * ab[1] - ca[1] * ab[0],
        ];
        let offset = -(normal[0] * a[0] as i64 + normal[1] * a[1] as i64 + normal[2] * a[2] as i64);
        Self { normal, perimeter: length(ab) + length(bc) + length(ca) + 3, offset }
    }
}

/// From one corner to another.
const fn side(from: [i16; 3], to: [i16; 3]) -> [i64; 3] {
    [to[0] as i64 - from[0] as i64, to[1] as i64 - from[1] as i64, to[2] as i64 - from[2] as i64]
}

/// The length, rounded down.
#[allow(clippy::cast_possible_truncation, reason = "components have at most 35 bits")]
const fn length([x, y, z]: [i64; 3]) -> i64 {
    let (x, y, z) = (x.unsigned_abs() as u128, y.unsigned_abs() as u128, z.unsigned_abs() as u128);
    (x * x + y * y + z * z).isqrt() as i64
}

/// The nearest byte to a ratio of at most 127, raised.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 255")]
const fn byte(a: i64, b: i64) -> u8 {
    let half = if a < 0 { -(b / 2) } else { b / 2 };
    ((a + half) / b + RAISED) as u8
}

/// From 1 to what 16 bits hold.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "compared just before")]
const fn narrow(radius: i64) -> u16 {
    if radius < 1 {
        1
    } else if radius > u16::MAX as i64 {
        u16::MAX
    } else {
        radius as u16
    }
}

/// The positions of a triangle's corners; `None` where one is not there.
const fn corners_of(positions: &[[i16; 3]], [a, b, c]: [u16; 3]) -> Option<[[i16; 3]; 3]> {
    let (a, b, c) = (a as usize, b as usize, c as usize);
    if a < positions.len() && b < positions.len() && c < positions.len() {
        Some([positions[a], positions[b], positions[c]])
    } else {
        None
    }
}
