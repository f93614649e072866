use super::projected::{flag, Projected};

/// The index of an empty slot: the last number there is, which no mesh has.
const NONE: u32 = u32::MAX;

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

/// A vertex that was transformed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The vertex's index. An empty slot holds [`NONE`], and no valid vertex.
    index: u32,
    /// The vertex, marked as [`SHADED`](flag::SHADED) when its attributes are made too.
    pub(super) vertex: Projected,
}

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
    #[inline]
    pub const fn with_blank(blank: C) -> Self {
        let () = Self::POWER_OF_TWO;
        // All zeros, so that a `static` takes no flash: `start` is what empties a slot.
        let vertex = Projected::new(0, 0, 0, 0);
        Self { entries: [Entry { index: 0, vertex }; N], corners: [blank; N] }
    }

    /// Forgets all vertices and lends the arrays out, without their length in the type.
    #[inline]
    pub(super) fn start(&mut self) -> CacheView<'_, C> {
        empty(&mut self.entries);
        CacheView { entries: &mut self.entries, corners: &mut self.corners }
    }
}

/// Empties slots. One copy for all draws: in place it is 300 bytes a draw.
#[inline(never)]
fn empty(entries: &mut [Entry]) {
    for entry in entries {
        (entry.index, entry.vertex.z_flags) = (NONE, flag::INVALID);
        // One at a time: unrolled it is longer and no faster.
        core::hint::black_box(());
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

impl Entry {
    /// Whether this is the vertex.
    #[inline(always)]
    pub(super) fn holds(&self, index: u32) -> bool {
        self.index == index
    }

    /// Keeps a vertex.
    #[inline(always)]
    pub(super) fn keep(&mut self, index: u32, vertex: Projected) {
        *self = Self { index, vertex };
    }
}

impl<C: Copy> CacheView<'_, C> {
    /// A vertex's attributes, where they are kept.
    #[inline(always)]
    pub(super) fn corner(&self, index: u32) -> Option<C> {
        let slot = slot(index, self.entries.len());
        let (entry, corner) = (self.entries.get(slot)?, self.corners.get(slot)?);
        (entry.holds(index) && entry.vertex.flags() & flag::SHADED != 0).then_some(*corner)
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
        let slot = slot(index, self.entries.len());
        if let (Some(entry), Some(place)) = (self.entries.get_mut(slot), self.corners.get_mut(slot))
        {
            if entry.holds(index) {
                entry.vertex.z_flags |= flag::SHADED;
                *place = corner;
            }
        }
    }
}
