use super::projected::Projected;

/// Set in a key when the vertex's attributes are made too.
pub(super) const SHADED: u32 = 1 << 31;

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
/// assert_eq!(core::mem::size_of_val(&cache), 64 * (4 + 8 + 6));
/// ```
#[derive(Clone, Debug)]
pub struct VertexCache<C, const N: usize> {
    keys: [u32; N],
    projected: [Projected; N],
    corners: [C; N],
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
        Self {
            keys: [0; N],
            projected: [Projected { x: 0, y: 0, z: 0, flags: 0 }; N],
            corners: [blank; N],
        }
    }

    /// Forgets all vertices and lends the arrays out, without their length in the type.
    #[inline]
    pub(super) fn start(&mut self) -> CacheView<'_, C> {
        self.keys.fill(0);
        CacheView {
            positions: PositionCache { keys: &mut self.keys, projected: &mut self.projected },
            corners: &mut self.corners,
        }
    }
}

/// A cache whose capacity is no type.
#[derive(Debug)]
pub(super) struct CacheView<'a, C> {
    pub(super) positions: PositionCache<'a>,
    pub(super) corners: &'a mut [C],
}

/// The part of a cache that knows nothing of shaders.
#[derive(Debug)]
pub(super) struct PositionCache<'a> {
    pub(super) keys: &'a mut [u32],
    projected: &'a mut [Projected],
}

impl PositionCache<'_> {
    /// The slot of a vertex.
    #[inline(always)]
    pub(super) fn slot(&self, index: u32) -> usize {
        index as usize & self.keys.len().wrapping_sub(1)
    }

    /// The projected vertex, from the cache or else made and kept.
    #[inline(always)]
    pub(super) fn get(&mut self, index: u32, project: impl FnOnce() -> Projected) -> Projected {
        let slot = self.slot(index);
        let (Some(key), Some(kept)) = (self.keys.get_mut(slot), self.projected.get_mut(slot))
        else {
            return Projected::INVALID;
        };
        if *key & !SHADED != index.wrapping_add(1) {
            *key = index.wrapping_add(1);
            *kept = project();
        }
        *kept
    }
}

impl<C: Copy> CacheView<'_, C> {
    /// A vertex's attributes, from the cache or else made and kept.
    #[inline(always)]
    pub(super) fn corner(&mut self, index: u32, shade: impl FnOnce() -> C) -> C {
        let slot = self.positions.slot(index);
        let (Some(key), Some(kept)) =
            (self.positions.keys.get_mut(slot), self.corners.get_mut(slot))
        else {
            return shade();
        };
        if *key == index.wrapping_add(1) | SHADED {
            return *kept;
        }
        let corner = shade();
        // Another vertex of the same triangle may have taken the slot.
        if *key == index.wrapping_add(1) {
            *key |= SHADED;
            *kept = corner;
        }
        corner
    }
}
