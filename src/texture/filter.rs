use super::texel_format::multiplied;
use super::{Axis, Squares, TexelFormat, Texture, Weights, Wrap};
use crate::color::Color;

/// What a texture shows between the middles of its texels.
pub trait Filter: Copy {
    /// Whether several pixels are worth sampling at a time, if the format says so too.
    #[doc(hidden)]
    const IN_LANES: bool = false;

    /// Whether rows are worth mixing before they are drawn, if the format says so too.
    #[doc(hidden)]
    const IN_ROWS: bool = false;

    /// A coordinate as the filter takes it and a run of pixels steps it, by what
    /// [`Wrap::turned`] makes of the way.
    fn begin<T: TexelFormat, W: Wrap>(self, wrap: W, axis: &Axis, at: i32) -> i32;

    /// The colour of `texture` where both coordinates have [begun](Self::begin); `None` beyond its
    /// data, which checked sizes rule out. `constants` are the format's
    /// [`CONSTANTS`](TexelFormat::CONSTANTS); the colour is [multiplied](super::Modulate) with that of
    /// a `surface`.
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        uv: [i32; 2],
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color>;

    /// Looks up what [`sample`](Self::sample) mixes, for pixels side by side.
    #[doc(hidden)]
    #[inline(always)]
    fn gather<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        _texture: &Texture<'_, T>,
        _wraps: (U, V),
        _axes: &[Axis; 2],
        _uv: [i32; 2],
        _way: [i32; 2],
        _squares: &mut [Squares],
    ) -> Option<()> {
        None
    }

    /// Mixes pixels side by side that have one v.
    #[doc(hidden)]
    #[inline(always)]
    fn mix_row<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        _texture: &Texture<'_, T>,
        _wraps: (U, V),
        _axes: &[Axis; 2],
        _uv: [i32; 2],
        _way: i32,
        _mixed: &mut [u32],
    ) -> Option<()> {
        None
    }
}

/// The texel in which the point lies.
///
/// # Rounding
/// Exact: texel floor(u x width) of row floor(v x height).
///
/// # Measured
/// <!-- tradeoff: plane-4/perspective+filter=adaptive+nearest -->
/// `adaptive + nearest` in the scene `plane-4`: 49.9 (M4F), 90.8 (M0+), 47.4 (RV32) instructions a pixel; 0.084 texels off, 1.11 at most; PSNR 21.2 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Nearest;

impl Filter for Nearest {
    #[inline(always)]
    fn begin<T: TexelFormat, W: Wrap>(self, wrap: W, axis: &Axis, at: i32) -> i32 {
        wrap.turned(axis, at)
    }

    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        (across, down): (U, V),
        [u_axis, v_axis]: &[Axis; 2],
        [u, v]: [i32; 2],
        _constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        let texel = texture.texel(across.nearest(u_axis, u), down.nearest(v_axis, v))?;
        Some(match surface {
            Some(surface) => T::modulate(texel, surface),
            None => T::decode(texel),
        })
    }
}

/// Mixed from the four texels whose middles lie around the point, as finely as is cheap.
///
/// # Rounding
/// The formats say to what fraction of a texel places are rounded
/// ([`PLACES`](TexelFormat::PLACES)) and how texels mix ([`blend`](TexelFormat::blend)): RGB565 has
/// weights of five bits and gives colours of its own, all others are as [`FineBilinear`].
///
/// # Measured
/// <!-- tradeoff: plane-4/perspective+filter=adaptive+bilinear -->
/// `adaptive + bilinear` in the scene `plane-4`: 96.5 (M4F), 167 (M0+), 101 (RV32) instructions a pixel; 0.084 texels off, 1.11 at most; PSNR 27.9 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bilinear;

/// Mixed from the four texels whose middles lie around the point.
///
/// # Rounding
/// Places are rounded to 2^-8 of a texel; the formats say how they [mix](TexelFormat::mix).
///
/// # Measured
/// <!-- tradeoff: plane-4/perspective+filter=adaptive+fine-bilinear -->
/// `adaptive + fine-bilinear` in the scene `plane-4`: 166 (M4F), 256 (M0+), 153 (RV32) instructions a pixel; 0.084 texels off, 1.11 at most; PSNR 27.7 dB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FineBilinear;

/// Bits of a place that are always there.
const FINE: u32 = 8;

/// The four texels around a point.
#[inline(always)]
fn corners<T: TexelFormat, U: Wrap, V: Wrap>(
    texture: &Texture<'_, T>,
    (across, down): (U, V),
    [u_axis, v_axis]: &[Axis; 2],
    [u, v]: [i32; 2],
    places: u32,
) -> Option<[T::Texel; 4]> {
    let ([left, right], [upper, lower]) =
        (across.pair(u_axis, u, places), down.pair(v_axis, v, places));
    let (a, b) = (texture.texel(left, upper)?, texture.texel(right, upper)?);
    let (c, d) = (texture.texel(left, lower)?, texture.texel(right, lower)?);
    Some([a, b, c, d])
}

/// The texels around a point in pairs, where they are no square of the data: few points lie there.
#[cold]
#[inline(never)]
fn edge_pairs<T: TexelFormat, U: Wrap, V: Wrap>(
    texture: &Texture<'_, T>,
    wraps: (U, V),
    axes: &[Axis; 2],
    uv: [i32; 2],
) -> Option<[u32; 2]> {
    let [a, b, c, d] = corners(texture, wraps, axes, uv, T::PLACES)?;
    Some([T::pair(a, b), T::pair(c, d)])
}

impl Filter for Bilinear {
    const IN_LANES: bool = true;
    const IN_ROWS: bool = true;

    #[inline(always)]
    fn begin<T: TexelFormat, W: Wrap>(self, wrap: W, axis: &Axis, at: i32) -> i32 {
        wrap.before(axis, at, T::PLACES)
    }

    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        [u, v]: [i32; 2],
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        let ((across, down), [u_axis, v_axis]) = (wraps, axes);
        let (left, x) = across.place(u_axis, u, T::PLACES);
        let (upper, y) = down.place(v_axis, v, T::PLACES);
        let weights = Weights::new(x, y);
        // Endless rows need no check: behind the last one there are no data.
        let is_square = left < u_axis.last() && (V::ENDLESS || upper < v_axis.last());
        let place = is_square.then(|| u_axis.row(upper).wrapping_add(left as usize));
        // Of copies, so that the originals stay in registers.
        let (whole, axes) = (*texture, *axes);
        let corners = move || corners(&whole, wraps, &axes, [u, v], T::PLACES);
        texture.blend_square(place, u_axis.row(1), corners, weights, constants, surface)
    }

    #[inline(never)]
    fn gather<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        [mut u, mut v]: [i32; 2],
        way: [i32; 2],
        squares: &mut [Squares],
    ) -> Option<()> {
        let ((across, down), [u_axis, v_axis]) = (wraps, axes);
        for squares in squares {
            squares.fill(|| {
                let (left, x) = across.place(u_axis, u, T::PLACES);
                let (upper, y) = down.place(v_axis, v, T::PLACES);
                let is_square = left < u_axis.last() && (V::ENDLESS || upper < v_axis.last());
                let place = u_axis.row(upper).wrapping_add(left as usize);
                let found = if is_square { texture.pairs(place, u_axis.row(1)) } else { None };
                let [upper, lower] = match found {
                    Some(pairs) => pairs,
                    None => edge_pairs(texture, wraps, axes, [u, v])?,
                };
                let [x, y] = Weights::new(x, y).coarse();
                (u, v) = (u.wrapping_add(way[0]), v.wrapping_add(way[1]));
                Some([upper, lower, x | y << 16])
            })?;
        }
        Some(())
    }

    #[inline(never)]
    fn mix_row<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        (_, down): (U, V),
        [u_axis, v_axis]: &[Axis; 2],
        [u, v]: [i32; 2],
        way: i32,
        mixed: &mut [u32],
    ) -> Option<()> {
        let (_, y) = down.place(v_axis, v, T::PLACES);
        let [_, y] = Weights::new(0, y).coarse();
        let rows = down.pair(v_axis, v, T::PLACES);
        let rows = rows.map(|number| texture.words_at(u_axis.row(number), u_axis.row(1)));
        let [Some(upper), Some(lower)] = rows else { return None };
        T::mix_row([upper, lower], y, u_axis, [u, way], mixed)
    }
}

impl Filter for FineBilinear {
    #[inline(always)]
    fn begin<T: TexelFormat, W: Wrap>(self, wrap: W, axis: &Axis, at: i32) -> i32 {
        wrap.before(axis, at, FINE)
    }

    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        [u, v]: [i32; 2],
        _constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        let ((across, down), [u_axis, v_axis]) = (wraps, axes);
        let (_, x) = across.place(u_axis, u, FINE);
        let (_, y) = down.place(v_axis, v, FINE);
        let texels = corners(texture, wraps, axes, [u, v], FINE)?;
        Some(multiplied(T::mix(texels, Weights::new(x, y)), surface))
    }
}

/// Any filter, chosen when the program runs: for host tools.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AnyFilter {
    /// As [`Nearest`](struct@Nearest).
    Nearest,
    /// As [`Bilinear`](struct@Bilinear).
    Bilinear,
    /// As [`FineBilinear`](struct@FineBilinear).
    FineBilinear,
}

impl Filter for AnyFilter {
    #[inline(always)]
    fn begin<T: TexelFormat, W: Wrap>(self, wrap: W, axis: &Axis, at: i32) -> i32 {
        match self {
            Self::Nearest => Nearest.begin::<T, W>(wrap, axis, at),
            Self::Bilinear => Bilinear.begin::<T, W>(wrap, axis, at),
            Self::FineBilinear => FineBilinear.begin::<T, W>(wrap, axis, at),
        }
    }

    #[inline(always)]
    fn sample<T: TexelFormat, U: Wrap, V: Wrap>(
        self,
        texture: &Texture<'_, T>,
        wraps: (U, V),
        axes: &[Axis; 2],
        [u, v]: [i32; 2],
        constants: [u32; 2],
        surface: Option<Color>,
    ) -> Option<Color> {
        match self {
            Self::Nearest => Nearest.sample(texture, wraps, axes, [u, v], constants, surface),
            Self::Bilinear => Bilinear.sample(texture, wraps, axes, [u, v], constants, surface),
            Self::FineBilinear => {
                FineBilinear.sample(texture, wraps, axes, [u, v], constants, surface)
            }
        }
    }
}
