use super::projected::{flag, Projected};
use crate::color::fill_halves;

/// Every word of an empty slot: as an index what no mesh has, since its vertices would fill 24 GB, as
/// flags a vertex that is not there and not shaded.
const NONE: u32 = 0xFEFE_FEFE;

const _: () = assert!(
    NONE & flag::INVALID != 0 && NONE & flag::ANY != 0 && NONE & flag::SHADED == 0,
    "an empty slot"
);

/// Vertices that were transformed and shaded already, for up to `N` of them (a power of two).
///
/// A vertex has the slot of its index modulo `N`: with `N` at least the number of vertices each
/// is transformed once; a small cache serves meshes whose triangles share recent vertices.
/// [`Pass::draw`](super::Pass::draw) brings one of 32 on the stack,
/// [`Pass::draw_cached`](super::Pass::draw_cached) takes yours, which may be a `static`.
///
/// ```
/// use microraster::{Corner, SmoothColor, VertexCache};
///
/// let cache = VertexCache::<Corner<SmoothColor>, 64>::new();
/// assert_eq!(core::mem::size_of_val(&cache), 64 * (4 + 8 + 8));
/// ```
///
/// # Measured
/// <!-- tradeoff: bunny/cache=32 -->
/// `32` in the scene `bunny`: 3.49 M (M4F), 6.52 M (M0+), 4.34 M (RV32) instructions a frame; PSNR 42.6 dB.
///
/// <!-- tradeoff: bunny/cache=2048 -->
/// `2048` in the scene `bunny`: 2.52 M (M4F), 4.34 M (M0+), 2.92 M (RV32) instructions a frame; PSNR 42.6 dB.
#[derive(Clone, Debug)]
pub struct VertexCache<C, const N: usize> {
    entries: [Entry; N],
    corners: [C; N],
}

/// A vertex that was transformed: its index, and the words of a [`Projected`], marked as
/// [`SHADED`](flag::SHADED) when its attributes are made too. An empty slot holds [`NONE`] thrice,
/// which is no valid vertex.
///
/// Words, so that slots are emptied as memory is filled.
pub(super) type Entry = [u32; 3];

impl<C: Copy + Default, const N: usize> Default for VertexCache<C, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<C: Copy + Default, const N: usize> VertexCache<C, N> {
    /// An empty cache. A capacity that is no power of two does not compile.
    #[inline]
    pub fn new() -> Self {
        Self::with_blank(C::default())
    }
}

impl<C: Copy, const N: usize> VertexCache<C, N> {
    const POWER_OF_TWO: () = assert!(N.is_power_of_two(), "the capacity must be a power of two");

    /// An empty cache for a `static`: `blank` is any value, to fill the memory with.
    ///
    /// Not inlined: of two in one function, the compiler would copy one from the other.
    #[inline(never)]
    pub const fn with_blank(blank: C) -> Self {
        let () = Self::POWER_OF_TWO;
        // All zeros, so that a `static` takes no flash: `start` is what empties a slot.
        Self { entries: [[0; 3]; N], corners: [blank; N] }
    }

    /// Forgets all vertices and lends the arrays out, without their length in the type.
    #[inline]
    pub(super) fn start(&mut self) -> CacheView<'_, C> {
        // As 16-bit words, for which the function is there already where depth or RGB565 is cleared.
        let words = bytemuck::cast_slice_mut::<Entry, u16>(&mut self.entries);
        fill_halves(words, NONE, NONE);
        CacheView { entries: &mut self.entries, corners: &mut self.corners }
    }
}

/// A cache whose capacity is no type.
#[derive(Debug)]
pub(super) struct CacheView<'a, C> {
    /// The part that knows nothing of shaders.
    pub(super) entries: &'a mut [Entry],
    corners: &'a mut [C],
}

/// The slot of a vertex in a cache of `length`, a power of two.
#[inline(always)]
pub(super) fn slot(index: u32, length: usize) -> usize {
    index as usize & length.wrapping_sub(1)
}

/// Whether a slot holds this vertex.
#[inline(always)]
pub(super) fn holds([kept, ..]: &Entry, index: u32) -> bool {
    *kept == index
}

/// The vertex of a slot.
#[inline(always)]
pub(super) fn kept([_, xy, z_flags]: &Entry) -> Projected {
    Projected { xy: *xy, z_flags: *z_flags }
}

/// Whether a slot holds this vertex with its attributes.
#[inline(always)]
pub(super) fn is_shaded(entry: &Entry, index: u32) -> bool {
    holds(entry, index) && kept(entry).flags() & flag::SHADED != 0
}

/// Notes whose attributes a slot has now: if those of another vertex of the same triangle than the
/// one that took the slot, that one's have to be made again.
#[inline(always)]
pub(super) fn note_shaded(entry: &mut Entry, index: u32) {
    let is_own = holds(entry, index);
    let [_, _, z_flags] = entry;
    *z_flags = if is_own { *z_flags | flag::SHADED } else { *z_flags & !flag::SHADED };
}

impl<C: Copy> CacheView<'_, C> {
    /// The slot of a vertex.
    #[inline(always)]
    pub(super) fn slot(&mut self, index: u32) -> Option<(&mut Entry, &mut C)> {
        let slot = slot(index, self.entries.len());
        Some((self.entries.get_mut(slot)?, self.corners.get_mut(slot)?))
    }

    /// A vertex's attributes, where they are kept.
    #[inline(always)]
    pub(super) fn corner(&self, index: u32) -> Option<C> {
        let slot = slot(index, self.entries.len());
        let (entry, corner) = (self.entries.get(slot)?, self.corners.get(slot)?);
        is_shaded(entry, index).then_some(*corner)
    }

    /// The attributes of three vertices that are known to be kept.
    #[inline(always)]
    pub(super) fn known(&self, vertices: [u32; 3]) -> Option<[C; 3]> {
        let corner = |index| self.corners.get(slot(index, self.entries.len())).copied();
        let [a, b, c] = vertices.map(corner);
        Some([a?, b?, c?])
    }

    /// Keeps a vertex's attributes, unless another vertex of the same triangle took its slot.
    #[inline(always)]
    pub(super) fn keep_corner(&mut self, index: u32, corner: C) {
        if let Some((entry, place)) = self.slot(index) {
            if holds(entry, index) {
                note_shaded(entry, index);
                *place = corner;
            }
        }
    }
}
