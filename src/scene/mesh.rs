use crate::math::Vec3;

/// How vertices make triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Indices<'a> {
    /// Three vertices after the other: no vertex is shared.
    Sequential,
    /// Three indices a triangle, for up to 256 vertices.
    U8(&'a [u8]),
    /// Three indices a triangle, for up to 65 536 vertices.
    U16(&'a [u16]),
}

/// A mesh in the caller's memory, usually flash: positions, what a shader wants beside them, and
/// triangles.
///
/// A position in model space is `offset + scale x position`, by component; the three 16-bit
/// numbers span the mesh's own box.
///
/// ```
/// use microraster::{Mesh, Rgb};
///
/// static CORNERS: [[i16; 3]; 3] = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]];
/// static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];
/// static TRIANGLE: Mesh<Rgb> = Mesh::new(&CORNERS, &COLORS);
/// assert_eq!(TRIANGLE.triangles(), 1);
/// ```
///
/// # Range
/// Any lengths: triangles whose vertices do not exist are skipped when they are drawn, and
/// counted where counting is asked for.
#[derive(Debug)]
pub struct Mesh<'a, A> {
    pub(crate) positions: &'a [[i16; 3]],
    pub(crate) attributes: &'a [A],
    pub(crate) by_face: bool,
    pub(crate) indices: Indices<'a>,
    scale: Vec3,
    offset: Vec3,
}

impl<A> Clone for Mesh<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for Mesh<'_, A> {}

impl<'a, A> Mesh<'a, A> {
    /// A mesh whose attributes belong to its vertices, drawn in sequence, at scale 1.
    pub const fn new(positions: &'a [[i16; 3]], attributes: &'a [A]) -> Self {
        Self {
            positions,
            attributes,
            by_face: false,
            indices: Indices::Sequential,
            scale: Vec3::new(1.0, 1.0, 1.0),
            offset: Vec3::ZERO,
        }
    }

    /// Attributes belong to triangles instead, one each.
    #[must_use]
    pub const fn by_face(mut self) -> Self {
        self.by_face = true;
        self
    }

    /// Triangles by indices.
    #[must_use]
    pub const fn indexed(mut self, indices: Indices<'a>) -> Self {
        self.indices = indices;
        self
    }

    /// The box: what one step of a position is in model space, by axis, and where position 0 lies.
    ///
    /// # Rounding
    /// Matrices are rounded to 2^-15 of what positions of +-32768 could reach, whether they do or
    /// not. So positions should use that range, with a scale to match, and an axis that is not
    /// used, all of whose positions are 0, should have a scale of 0: any other takes precision
    /// away from the rest.
    #[must_use]
    pub const fn placed(mut self, scale: Vec3, offset: Vec3) -> Self {
        self.scale = scale;
        self.offset = offset;
        self
    }

    /// How many triangles there are.
    pub const fn triangles(&self) -> usize {
        let corners = match self.indices {
            Indices::Sequential => {
                if self.positions.is_empty() {
                    self.attributes.len()
                } else {
                    self.positions.len()
                }
            }
            Indices::U8(indices) => indices.len(),
            Indices::U16(indices) => indices.len(),
        };
        corners / 3
    }

    /// A step of a position and where position 0 lies, in model space.
    pub(crate) const fn place(&self) -> (Vec3, Vec3) {
        (self.scale, self.offset)
    }
}
