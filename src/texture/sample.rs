use super::{Environment, Footprint, Modulate, Squares};
use crate::color::{Color, Format};
use crate::shade::Uv;

/// What gives a colour at a place of a texture: a sampler of any kind.
pub trait Sample {
    /// What is sampled for a run of pixels.
    type Level: Sample;

    /// Whether several pixels are worth fetching at a time: then it [gathers](Self::gather).
    #[doc(hidden)]
    const IN_LANES: bool = false;

    /// Whether there are [rows](Self::mixes) worth mixing before they are drawn.
    #[doc(hidden)]
    const IN_ROWS: bool = false;

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

    /// Whether a row in which coordinates that have [begun](Self::begin) go on by `way` is worth mixing: v stays the
    /// same, and u goes right by less than a texel a pixel.
    #[doc(hidden)]
    #[inline(always)]
    fn mixes(&self, _way: Uv) -> bool {
        false
    }

    /// Mixes what [`show_mixed`](Self::show_mixed) shows, of pixels side by side from `uv` on, which has
    /// [begun](Self::begin) and whose u goes on by `way`.
    #[doc(hidden)]
    #[inline(always)]
    fn mix_row(&self, _uv: Uv, _way: i32, _mixed: &mut [u32]) -> Option<()> {
        None
    }

    /// A pixel that was mixed, [multiplied](Modulate) with that of a `surface`.
    #[doc(hidden)]
    #[inline(always)]
    fn show_mixed<F: Format>(_mixed: u32, surface: Option<Color>) -> F::Raw {
        F::pack(surface.unwrap_or_default())
    }
}
