//! A mesh from outside the repository: written on the host, read on the board.
//!
//! # The file `bunny.mesh`
//! All numbers are little-endian. The header has 32 bytes, so that every array that follows is
//! aligned for its element wherever the file itself is.
//!
//! | offset | what |
//! | --- | --- |
//! | 0 | the eight bytes of [`MAGIC`] |
//! | 8 | `u32`: number of vertices, V |
//! | 12 | `u32`: number of indices, N, three a triangle |
//! | 16 | `f32`: scale |
//! | 20 | 3 x `f32`: offset; a vertex lies at offset + scale x position |
//! | 32 | V x 3 x `i16`: positions |
//! | 32 + 6 V | N x `u16`: indices |
//! | 32 + 6 V + 2 N | 4 x `u16`: radius and reach of the planes; a radius of 0 where there are none |
//! | 40 + 6 V + 2 N | N / 3 x 4 x `u8`: planes, if any |
//! | the rest | V x 3 x `i8`: normals, length 127 |

use microraster::{FacePlane, PlaneScale};

/// The first bytes of the file; the last one is the version of the format.
pub(crate) const MAGIC: [u8; 8] = *b"MRMESH\r\x02";
/// Bytes before the positions.
pub(crate) const HEADER: usize = 32;

/// Mesh data that somebody else holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Model<'a> {
    /// Vertex positions in steps of `scale`.
    pub(crate) positions: &'a [[i16; 3]],
    /// One normal a vertex, length 127.
    pub(crate) normals: &'a [[i8; 3]],
    /// One plane a triangle, or none.
    pub(crate) planes: &'a [FacePlane],
    /// What the planes are made for.
    pub(crate) plane_scale: PlaneScale,
    /// Three indices a triangle, counter-clockwise as seen from outside.
    pub(crate) indices: &'a [u16],
    /// Model units of one step of a position.
    pub(crate) scale: f32,
    /// Where position zero lies, in model units.
    pub(crate) offset: [f32; 3],
}

impl<'a> Model<'a> {
    /// A view of the file's bytes, which must start at a multiple of four. `None` when they are
    /// not such a file, or on a big-endian machine.
    pub(crate) fn view(file: &'a [u8]) -> Option<Self> {
        if cfg!(target_endian = "big") || file.get(..8)? != MAGIC {
            return None;
        }
        let word = |at: usize| Some(*file.get(at..at + 4)?.first_chunk::<4>()?);
        let vertices = usize::try_from(u32::from_le_bytes(word(8)?)).ok()?;
        let count = usize::try_from(u32::from_le_bytes(word(12)?)).ok()?;
        let indices_at = vertices.checked_mul(6)?.checked_add(HEADER)?;
        let scale_at = count.checked_mul(2)?.checked_add(indices_at)?;
        let planes_at = scale_at.checked_add(8)?;
        let half = |at: usize| {
            Some(u16::from_le_bytes(*file.get(scale_at + 2 * at..)?.first_chunk::<2>()?))
        };
        let plane_scale = PlaneScale { radius: half(0)?, reach: [half(1)?, half(2)?, half(3)?] };
        let planes = if plane_scale.radius == 0 { 0 } else { count / 3 };
        let normals_at = planes.checked_mul(4)?.checked_add(planes_at)?;
        let end = vertices.checked_mul(3)?.checked_add(normals_at)?;
        Some(Self {
            planes: file.get(planes_at..normals_at)?.as_chunks().0,
            plane_scale,
            positions: bytemuck::try_cast_slice(file.get(HEADER..indices_at)?).ok()?,
            normals: bytemuck::try_cast_slice(file.get(normals_at..end)?).ok()?,
            indices: bytemuck::try_cast_slice(file.get(indices_at..scale_at)?).ok()?,
            scale: f32::from_le_bytes(word(16)?),
            offset: [
                f32::from_le_bytes(word(20)?),
                f32::from_le_bytes(word(24)?),
                f32::from_le_bytes(word(28)?),
            ],
        })
    }
}
