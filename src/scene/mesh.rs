use super::{FacePlanes, IndexedList, List, Topology, WithPlanes};
use crate::math::Vec3;

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
///
/// # Measured
/// <!-- tradeoff: sphere-close/vertices=i16 -->
/// `i16` in the scene `sphere-close`: 1.91 M (M4F), 3.19 M (M0+), 2.18 M (RV32) instructions a frame; PSNR 45.2 dB.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a, A, T = List> {
    pub(crate) topology: T,
    vertices: Vertices<'a, A>,
}

/// What a mesh holds beside its topology.
#[derive(Debug)]
pub(crate) struct Vertices<'a, A> {
    pub(crate) positions: &'a [[i16; 3]],
    pub(crate) attributes: &'a [A],
    pub(crate) by_face: bool,
    scale: Vec3,
    offset: Vec3,
}

impl<A> Clone for Vertices<'_, A> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<A> Copy for Vertices<'_, A> {}

impl<'a, A> Mesh<'a, A> {
    /// A mesh whose attributes belong to its vertices, drawn in sequence, at scale 1.
    pub const fn new(positions: &'a [[i16; 3]], attributes: &'a [A]) -> Self {
        let vertices = if positions.is_empty() { attributes.len() } else { positions.len() };
        Self {
            topology: List::new(vertices),
            vertices: Vertices {
                positions,
                attributes,
                by_face: false,
                scale: Vec3::new(1.0, 1.0, 1.0),
                offset: Vec3::ZERO,
            },
        }
    }
}

impl<'a, A, T: Topology> Mesh<'a, A, T> {
    /// Attributes belong to triangles instead, one each.
    #[must_use]
    pub const fn by_face(mut self) -> Self {
        self.vertices.by_face = true;
        self
    }

    /// Triangles by indices: three of 8, 16 or 32 bits each.
    #[must_use]
    pub const fn indexed<I>(self, indices: &'a [I]) -> Mesh<'a, A, IndexedList<'a, I>> {
        Mesh { topology: IndexedList::new(indices), vertices: self.vertices }
    }

    /// Triangles, lines or points in any way.
    #[must_use]
    pub const fn with_topology<N: Topology>(self, topology: N) -> Mesh<'a, A, N> {
        Mesh { topology, vertices: self.vertices }
    }

    /// Triangles whose planes are known: culling then looks at few that are not seen.
    #[must_use]
    pub const fn with_planes<'p>(self, planes: FacePlanes<'p>) -> Mesh<'a, A, WithPlanes<'p, T>> {
        Mesh { topology: WithPlanes::new(self.topology, planes), vertices: self.vertices }
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
        self.vertices.scale = scale;
        self.vertices.offset = offset;
        self
    }

    /// How many triangles there are; how many lines or points of a mesh of such.
    pub fn triangles(&self) -> u32 {
        self.topology.count()
    }

    /// The mesh without its topology.
    pub(crate) const fn vertices(&self) -> &Vertices<'a, A> {
        &self.vertices
    }
}

impl<A> Vertices<'_, A> {
    /// A step of a position and where position 0 lies, in model space.
    pub(crate) const fn place(&self) -> (Vec3, Vec3) {
        (self.scale, self.offset)
    }
}
