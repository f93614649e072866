use super::{
    Axis, Bilinear, Filter, Footprint, Nearest, Repeat, Sample, Squares, TexelFormat, Texture,
    TextureError, Wrap,
};
use crate::color::{Color, Format};
use crate::shade::Uv;

/// A texture and how it is read.
///
/// ```
/// use microraster::texture::{Clamp, FineBilinear, Sampler, Texture, TextureError};
/// use microraster::{Color, Rgb565};
///
/// # fn main() -> Result<(), TextureError> {
/// static CHECKS: [u16; 4] = [0xFFFF, 0xF800, 0xF800, 0xFFFF];
/// let texture = Texture::<Rgb565>::new(&CHECKS, 2, 2)?;
/// // One repeat is 4096 units of the vertex's; here are 16 fraction bits more.
/// let unit = |units: i32| units << 16;
///
/// let blocky = Sampler::nearest(texture)?;
/// assert_eq!(blocky.sample(unit(0), unit(0)), Color::new(255, 255, 255));
/// assert_eq!(blocky.sample(unit(4096 + 2048), unit(0)), Color::new(255, 0, 0));
///
/// let smooth = Sampler::new(texture, FineBilinear, Clamp, Clamp)?;
/// assert_eq!(smooth.sample(unit(2048), unit(0)).green(), 127); // half way
/// # Ok(())
/// # }
/// ```
pub struct Sampler<'a, T: TexelFormat, F = Nearest, U = Repeat, V = U> {
    texture: Texture<'a, T>,
    axes: [Axis; 2],
    filter: F,
    wraps: (U, V),
    /// The format's.
    constants: [u32; 2],
}

impl<T: TexelFormat, F: Copy, U: Copy, V: Copy> Clone for Sampler<'_, T, F, U, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<T: TexelFormat, F: Copy, U: Copy, V: Copy> Copy for Sampler<'_, T, F, U, V> {}

impl<T: TexelFormat, F, U, V> core::fmt::Debug for Sampler<'_, T, F, U, V> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Sampler").field("texture", &self.texture).finish_non_exhaustive()
    }
}

impl<'a, T: TexelFormat> Sampler<'a, T> {
    /// The nearest texel, repeated along both axes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn nearest(texture: Texture<'a, T>) -> Result<Self, TextureError> {
        Self::new(texture, Nearest, Repeat, Repeat)
    }
}

impl<'a, T: TexelFormat> Sampler<'a, T, Bilinear> {
    /// Mixed from four texels, repeated along both axes.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub const fn bilinear(texture: Texture<'a, T>) -> Result<Self, TextureError> {
        Self::new(texture, Bilinear, Repeat, Repeat)
    }
}

impl<'a, T: TexelFormat, F: Filter, U: Wrap, V: Wrap> Sampler<'a, T, F, U, V> {
    /// Log2 of the units that one repeat has unless [`unit_bits`](Self::unit_bits) says other.
    pub const UNIT_BITS: u32 = 12;

    /// Reads `texture` by `filter`, beyond its sides by `across` along u and by `down` along v.
    ///
    /// # Errors
    /// [`TextureError::NotPowerOfTwo`] where the texture has another side and not both wraps are
    /// [`ClampAny`](super::ClampAny).
    pub const fn new(
        texture: Texture<'a, T>,
        filter: F,
        across: U,
        down: V,
    ) -> Result<Self, TextureError> {
        let (width, height) = (texture.width(), texture.height());
        if !(texture.has_power_of_two_sides() || U::ANY_SIZE && V::ANY_SIZE) {
            return Err(TextureError::NotPowerOfTwo { width, height });
        }
        Ok(Self::checked(texture, filter, (across, down), Self::UNIT_BITS))
    }

    /// The same for a texture that is known to fit.
    pub(super) const fn checked(
        texture: Texture<'a, T>,
        filter: F,
        wraps: (U, V),
        unit_bits: u32,
    ) -> Self {
        let (width, height) = (texture.width(), texture.height());
        let axes = [Axis::new(width, unit_bits), Axis::new(height, unit_bits)];
        Self { texture, axes, filter, wraps, constants: T::CONSTANTS }
    }

    /// One repeat is 2^`bits` units of the vertex's along both axes: 0 to 15, above that 15.
    #[must_use]
    pub const fn unit_bits(self, bits: u32) -> Self {
        Self::checked(self.texture, self.filter, self.wraps, bits)
    }

    /// What is read.
    pub const fn texture(&self) -> Texture<'a, T> {
        self.texture
    }

    /// The colour at (`u`, `v`): the vertex's units with 16 fraction bits, wrapping.
    #[inline(always)]
    pub fn sample(&self, u: i32, v: i32) -> Color {
        self.fetch(u, v).unwrap_or_default()
    }

    /// The same for the end of a fragment: `None`, which no checked texture gives, discards it. The
    /// pixel loop has nothing else to draw then, and keeps texels packed where formats agree.
    #[inline(always)]
    pub fn fetch(&self, u: i32, v: i32) -> Option<Color> {
        self.fetch_begun(self.begin(Uv { u, v }), None)
    }

    /// Coordinates in the form that a run of pixels steps: see [`Sample::begin`].
    #[inline(always)]
    fn begin(&self, Uv { u, v }: Uv) -> Uv {
        let ([u_axis, v_axis], (across, down)) = (&self.axes, self.wraps);
        let u = self.filter.begin::<T, U>(across, u_axis, u);
        Uv { u, v: self.filter.begin::<T, V>(down, v_axis, v) }
    }

    /// The colour there, multiplied with that of a surface.
    #[inline(always)]
    fn fetch_begun(&self, Uv { u, v }: Uv, surface: Option<Color>) -> Option<Color> {
        let Self { texture, axes, filter, wraps, constants } = self;
        filter.sample(texture, *wraps, axes, [u, v], *constants, surface)
    }
}

impl<T: TexelFormat, F: Filter, U: Wrap, V: Wrap> Sample for Sampler<'_, T, F, U, V> {
    type Level = Self;

    const IN_LANES: bool = F::IN_LANES && T::IN_LANES;
    const IN_ROWS: bool = F::IN_ROWS && T::IN_ROWS && U::TURNS;

    #[inline(always)]
    fn level(&self, _footprint: impl FnOnce() -> Footprint) -> Self {
        *self
    }

    #[inline(always)]
    fn fetch(&self, u: i32, v: i32) -> Option<Color> {
        self.fetch(u, v)
    }

    #[inline(always)]
    fn begin(&self, uv: Uv) -> Uv {
        self.begin(uv)
    }

    #[inline(always)]
    fn begun_way(&self, Uv { u, v }: Uv) -> Uv {
        let ([u_axis, v_axis], (across, down)) = (&self.axes, self.wraps);
        Uv { u: across.turned(u_axis, u), v: down.turned(v_axis, v) }
    }

    #[inline(always)]
    fn fetch_begun(&self, uv: Uv) -> Option<Color> {
        self.fetch_begun(uv, None)
    }

    #[inline(always)]
    fn modulate_begun(&self, uv: Uv, surface: Color) -> Option<Color> {
        self.fetch_begun(uv, Some(surface))
    }

    #[inline(always)]
    fn gather(&self, uv: Uv, way: Uv, squares: &mut [Squares]) -> Option<()> {
        let Self { texture, axes, filter, wraps, .. } = self;
        filter.gather(texture, *wraps, axes, [uv.u, uv.v], [way.u, way.v], squares)
    }

    #[inline(always)]
    fn mixes(&self, way: Uv) -> bool {
        let [u_axis, _] = &self.axes;
        way.v == 0 && u_axis.fine_place(way.u).0 == 0
    }

    #[inline(always)]
    fn mix_row(&self, uv: Uv, way: i32, mixed: &mut [u32]) -> Option<()> {
        let Self { texture, axes, filter, wraps, .. } = self;
        filter.mix_row(texture, *wraps, axes, [uv.u, uv.v], way, mixed)
    }

    #[inline(always)]
    fn show_mixed<O: Format>(mixed: u32, surface: Option<Color>) -> O::Raw {
        T::show_mixed::<O>(mixed, surface)
    }
}

#[cfg(test)]
#[path = "sampler_tests.rs"]
mod tests;
