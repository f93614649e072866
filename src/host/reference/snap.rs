/// On what grid corners lie when coverage is decided.
///
/// # Rounding
/// To the nearest point of the grid. What lies half way goes right and, from clip space, up, as
/// the crate's own vertices do; what comes in pixels goes right and down.
///
/// # Range
/// The crate also cuts triangles that reach beyond its guard box, 4096 pixels from the viewport's
/// middle, and rounds the corners of the cut; this is not done here. What is farther than 2^34
/// pixels is taken to be as far as that.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Snap {
    /// So many fraction bits of a pixel, at most 24: the crate's grid has 4.
    Bits(u32),
    /// 2^-24 of a pixel: as good as not at all.
    #[default]
    Exact,
}

/// Fraction bits of a [`Place`].
const PLACES: u32 = 24;

/// One pixel.
pub(super) const PIXEL: i128 = 1 << PLACES;

/// How far from the origin a coordinate may lie: 2^34 pixels. A product of two differences has 118
/// bits.
const FARTHEST: f64 = (1_u64 << 58) as f64;

/// A point of the picture in units of 2^-24 pixel, y down.
pub(super) type Place = [i128; 2];

impl Snap {
    /// A number of pixels, rounded to the grid; half a step goes up.
    #[allow(clippy::cast_possible_truncation, reason = "limited just before")]
    pub(super) fn round(self, pixels: f64) -> i128 {
        let bits = match self {
            Self::Bits(bits) => bits.min(PLACES),
            Self::Exact => PLACES,
        };
        let steps = pixels * f64::from(1_u32 << bits);
        let below = steps.floor();
        let nearest = if steps - below >= 0.5 { below + 1.0 } else { below };
        let step = 1_u32 << (PLACES - bits);
        let farthest = FARTHEST / f64::from(step);
        nearest.clamp(-farthest, farthest) as i128 * i128::from(step)
    }
}

/// The place where a pixel is looked at.
pub(super) fn sample(x: u16, y: u16, look: [f64; 2]) -> Place {
    let center = |pixel: u16| i128::from(pixel) * PIXEL + PIXEL / 2;
    [center(x) + Snap::Exact.round(look[0]), center(y) + Snap::Exact.round(look[1])]
}
