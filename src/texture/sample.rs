use super::{Environment, Footprint, Modulate, Squares};
use crate::color::Color;
use crate::shade::Uv;

/// What gives a colour at a place of a texture: a sampler of any kind.
pub trait Sample {
    /// What is sampled for a run of pixels.
    type Level: Sample;

    /// Whether several pixels are worth fetching at a time: then it [gathers](Self::gather).
    #[doc(hidden)]
    const IN_LANES: bool = false;

    /// What suits pixels of this footprint; `footprint` is made only where it is needed.
    fn level(&self, footprint: impl FnOnce() -> Footprint) -> Self::Level;

    /// The colour at (`u`, `v`): the vertex's units with 16 fraction bits, wrapping. `None` discards
    /// the fragment, which only a sampler of your own does.
    fn fetch(&self, u: i32, v: i32) -> Option<Color>;

    /// Coordinates in a form that is cheaper to fetch from, and that a run of pixels steps by
    /// [`begun_way`](Self::begun_way): the same bits as fetching at each pixel's coordinates.
    #[inline(always)]
    fn begin(&self, uv: Uv) -> Uv {
        uv
    }

    /// The way from one pixel to the next in that form.
    #[inline(always)]
    fn begun_way(&self, way: Uv) -> Uv {
        way
    }

    /// The colour at coordinates that have [begun](Self::begin).
    #[inline(always)]
    fn fetch_begun(&self, Uv { u, v }: Uv) -> Option<Color> {
        self.fetch(u, v)
    }

    /// The same [multiplied](Modulate) with a surface's colour: formats may multiply what is still
    /// packed.
    #[inline(always)]
    fn modulate_begun(&self, uv: Uv, surface: Color) -> Option<Color> {
        Some(Modulate.combine(self.fetch_begun(uv)?, surface))
    }

    /// Looks up the texels of RGB565 around pixels side by side, whose coordinates have
    /// [begun](Self::begin) and go on by `way`.
    #[doc(hidden)]
    #[inline(always)]
    fn gather(&self, _uv: Uv, _way: Uv, _squares: &mut [Squares]) -> Option<()> {
        None
    }
}
