use std::vec;
use std::vec::Vec;

use crate::texture::AnyWrap;

/// Where texels lie, and what is seen beyond them.
///
/// Coordinates count repeats: u and v of 0 to 1 run over all texels, to the right and down. Sides
/// may have any length; `Clamp` then does what the crate's `ClampAny` does. One of 0 counts as 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TexelGrid {
    /// Texels in a row.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Beyond the sides, across and down.
    pub wraps: [AnyWrap; 2],
}

/// The number of a texel, which may lie outside, as one of `0..length`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited to the side")]
fn wrapped(wrap: AnyWrap, number: f64, length: usize) -> usize {
    let side = length.max(1) as f64;
    let inside = match wrap {
        AnyWrap::Repeat => number.rem_euclid(side),
        AnyWrap::Mirror => {
            let number = number.rem_euclid(2.0 * side);
            number.min(2.0 * side - 1.0 - number)
        }
        AnyWrap::Clamp => number,
    };
    inside.clamp(0.0, side - 1.0) as usize
}

impl TexelGrid {
    /// The number of the texel in a column and a row that may lie outside; texels are counted by
    /// rows.
    fn number(&self, column: f64, row: f64) -> usize {
        let column = wrapped(self.wraps[0], column, self.width);
        wrapped(self.wraps[1], row, self.height) * self.width + column
    }

    /// The texel in which a point lies: column `floor(u width)` of row `floor(v height)`.
    #[must_use]
    pub fn nearest(&self, [u, v]: [f64; 2]) -> usize {
        self.number((u * self.width as f64).floor(), (v * self.height as f64).floor())
    }

    /// The four texels whose middles lie around a point, and their shares, which are 1 together.
    #[must_use]
    pub fn bilinear(&self, [u, v]: [f64; 2]) -> [(usize, f64); 4] {
        let (x, y) = (u * self.width as f64 - 0.5, v * self.height as f64 - 0.5);
        let (left, upper) = (x.floor(), y.floor());
        let (right, lower) = (left + 1.0, upper + 1.0);
        let (rightwards, down) = (x - left, y - upper);
        [
            (self.number(left, upper), (1.0 - rightwards) * (1.0 - down)),
            (self.number(right, upper), rightwards * (1.0 - down)),
            (self.number(left, lower), (1.0 - rightwards) * down),
            (self.number(right, lower), rightwards * down),
        ]
    }

    /// The level of detail where coordinates change so by a pixel to the right and down: log2 of
    /// the longer way in texels; below 0 where texels are larger than pixels.
    ///
    /// Source: OpenGL 4.6, section 8.14.1.
    #[must_use]
    pub fn detail(&self, along_x: [f64; 2], along_y: [f64; 2]) -> f64 {
        let way = |[u, v]: [f64; 2]| (u * self.width as f64).hypot(v * self.height as f64);
        way(along_x).max(way(along_y)).log2()
    }

    /// The number of the smaller copy, each of half the sides of the one before, that is nearest to
    /// a level of detail: `ceil(detail + 1/2) - 1`, down to the one of a single texel.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
    pub fn nearest_level(&self, detail: f64) -> usize {
        let last = self.width.max(self.height).max(1).ilog2();
        ((detail + 0.5).ceil() - 1.0).clamp(0.0, last.into()) as usize
    }
}

/// A picture that surfaces show: red, green, blue and alpha of its texels, 0 to 255.
///
/// ```
/// use microraster::host::reference::{TexelGrid, Texture};
/// use microraster::texture::AnyWrap;
///
/// let grid = TexelGrid { width: 2, height: 1, wraps: [AnyWrap::Clamp; 2] };
/// let texture = Texture::new(grid, &[[0.0; 4], [255.0; 4]]).expect("two texels");
/// assert_eq!(texture.nearest([0.5, 0.5]), [255.0; 4]);
/// assert_eq!(texture.bilinear([0.5, 0.5]), [127.5; 4]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    grid: TexelGrid,
    /// By rows.
    texels: Vec<[f64; 4]>,
}

impl Texture {
    /// A picture by rows. `None` if it has no texels, or not as many as the grid.
    #[must_use]
    pub fn new(grid: TexelGrid, texels: &[[f64; 4]]) -> Option<Self> {
        let TexelGrid { width, height, .. } = grid;
        let fits = !texels.is_empty() && width.checked_mul(height) == Some(texels.len());
        fits.then(|| Self { grid, texels: texels.to_vec() })
    }

    /// Where its texels lie.
    #[must_use]
    pub fn grid(&self) -> TexelGrid {
        self.grid
    }

    /// Its texels by rows.
    #[must_use]
    pub fn texels(&self) -> &[[f64; 4]] {
        &self.texels
    }

    /// The texel in which a point lies.
    #[must_use]
    pub fn nearest(&self, uv: [f64; 2]) -> [f64; 4] {
        self.texels[self.grid.nearest(uv)]
    }

    /// The mix of the four texels whose middles lie around a point.
    #[must_use]
    pub fn bilinear(&self, uv: [f64; 2]) -> [f64; 4] {
        let four = self.grid.bilinear(uv);
        [0, 1, 2, 3].map(|i| four.iter().map(|(texel, share)| self.texels[*texel][i] * share).sum())
    }

    /// The picture of half the sides, at least 1: each texel the mean of the four (or two) that it
    /// takes the place of. A side that is odd loses its last column or row.
    #[must_use]
    pub fn halved(&self) -> Self {
        let (width, height) = ((self.grid.width / 2).max(1), (self.grid.height / 2).max(1));
        let at = |x: usize, y: usize| {
            self.texels[y.min(self.grid.height - 1) * self.grid.width + x.min(self.grid.width - 1)]
        };
        let mut texels = vec![[0.0; 4]; width * height];
        for (i, texel) in texels.iter_mut().enumerate() {
            let (x, y) = (2 * (i % width), 2 * (i / width));
            let four = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            *texel = [0, 1, 2, 3].map(|k| four.iter().map(|texel| texel[k]).sum::<f64>() / 4.0);
        }
        Self { grid: TexelGrid { width, height, ..self.grid }, texels }
    }
}

/// A [`Texture`] and its smaller copies, down to one texel.
#[derive(Clone, Debug, PartialEq)]
pub struct MipTexture {
    /// The largest first.
    levels: Vec<Texture>,
}

impl MipTexture {
    /// The smaller copies of a picture, each half of the one before.
    #[must_use]
    pub fn new(texture: Texture) -> Self {
        let mut levels = vec![texture];
        while let Some(last) =
            levels.last().filter(|last| last.grid.width.max(last.grid.height) > 1)
        {
            let next = last.halved();
            levels.push(next);
        }
        Self { levels }
    }

    /// The copies, the largest first.
    #[must_use]
    pub fn levels(&self) -> &[Texture] {
        &self.levels
    }

    /// The copy that is nearest to a [level of detail](TexelGrid::detail).
    #[must_use]
    pub fn nearest_level(&self, detail: f64) -> &Texture {
        &self.levels[self.levels[0].grid.nearest_level(detail)]
    }

    /// The mix of the two copies between which a level of detail lies, each bilinear.
    #[must_use]
    pub fn trilinear(&self, uv: [f64; 2], detail: f64) -> [f64; 4] {
        let last = (self.levels.len() - 1) as f64;
        let detail = detail.clamp(0.0, last);
        let (finer, t) = (detail.floor(), detail.fract());
        let [a, b] = [finer, finer + 1.0].map(|level| self.nearest_level(level).bilinear(uv));
        [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t)
    }
}
