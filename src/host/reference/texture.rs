use std::vec;
use std::vec::Vec;

use crate::texture::AnyWrap;

/// A picture that surfaces show: red, green, blue and alpha of its texels, 0 to 255.
///
/// Coordinates count repeats: u and v of 0 to 1 run over the whole picture, to the right and down.
/// Sides may have any length; `Clamp` then does what the crate's `ClampAny` does.
#[derive(Clone, Debug, PartialEq)]
pub struct Texture {
    width: usize,
    height: usize,
    /// By rows.
    texels: Vec<[f64; 4]>,
    /// Across and down.
    wraps: [AnyWrap; 2],
}

/// The number of a texel, which may lie outside, as one of `0..length`.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited to the side")]
fn wrapped(wrap: AnyWrap, number: f64, length: usize) -> usize {
    let side = length as f64;
    let inside = match wrap {
        AnyWrap::Repeat => number.rem_euclid(side),
        AnyWrap::Mirror => {
            let twice = number.rem_euclid(2.0 * side);
            if twice < side {
                twice
            } else {
                2.0 * side - 1.0 - twice
            }
        }
        AnyWrap::Clamp => number,
    };
    inside.clamp(0.0, side - 1.0) as usize
}

impl Texture {
    /// A picture by rows, and what it shows beyond its sides. `None` if it has no texels, or not
    /// `width` times `height` of them.
    #[must_use]
    pub fn new(
        width: usize,
        height: usize,
        texels: &[[f64; 4]],
        wraps: [AnyWrap; 2],
    ) -> Option<Self> {
        let fits = !texels.is_empty() && width.checked_mul(height) == Some(texels.len());
        fits.then(|| Self { width, height, texels: texels.to_vec(), wraps })
    }

    /// Texels in a row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// The texel of whole numbers, which may lie outside.
    fn texel(&self, column: f64, row: f64) -> [f64; 4] {
        let column = wrapped(self.wraps[0], column, self.width);
        let row = wrapped(self.wraps[1], row, self.height);
        self.texels[row * self.width + column]
    }

    /// The texel in which a point lies: column `floor(u width)` of row `floor(v height)`.
    #[must_use]
    pub fn nearest(&self, [u, v]: [f64; 2]) -> [f64; 4] {
        self.texel((u * self.width as f64).floor(), (v * self.height as f64).floor())
    }

    /// The mix of the four texels whose middles lie around a point.
    #[must_use]
    pub fn bilinear(&self, [u, v]: [f64; 2]) -> [f64; 4] {
        let (x, y) = (u * self.width as f64 - 0.5, v * self.height as f64 - 0.5);
        let (left, upper) = (x.floor(), y.floor());
        let mix = |a: [f64; 4], b: [f64; 4], t: f64| [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t);
        let row = |row: f64| mix(self.texel(left, row), self.texel(left + 1.0, row), x - left);
        mix(row(upper), row(upper + 1.0), y - upper)
    }

    /// The picture of half the sides, at least 1: each texel the mean of the four (or two) that it
    /// takes the place of. A side that is odd loses its last column or row.
    #[must_use]
    pub fn halved(&self) -> Self {
        let (width, height) = ((self.width / 2).max(1), (self.height / 2).max(1));
        let at = |x: usize, y: usize| {
            self.texels[y.min(self.height - 1) * self.width + x.min(self.width - 1)]
        };
        let mut texels = vec![[0.0; 4]; width * height];
        for (i, texel) in texels.iter_mut().enumerate() {
            let (x, y) = (2 * (i % width), 2 * (i / width));
            let four = [at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)];
            *texel = [0, 1, 2, 3].map(|k| four.iter().map(|texel| texel[k]).sum::<f64>() / 4.0);
        }
        Self { width, height, texels, wraps: self.wraps }
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
        while let Some(last) = levels.last().filter(|last| last.width.max(last.height) > 1) {
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

    /// The level of detail where coordinates change so by a pixel to the right and down: log2 of
    /// the longer way in texels; below 0 where texels are larger than pixels.
    ///
    /// Source: OpenGL 4.6, section 8.14.1.
    #[must_use]
    pub fn detail(&self, along_x: [f64; 2], along_y: [f64; 2]) -> f64 {
        let [width, height] = self
            .levels
            .first()
            .map_or([1.0; 2], |largest| [largest.width as f64, largest.height as f64]);
        let way = |[u, v]: [f64; 2]| (u * width).hypot(v * height);
        way(along_x).max(way(along_y)).log2()
    }

    /// The copy for a level of detail: `ceil(detail + 1/2) - 1`, the one that is nearest.
    #[must_use]
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
    pub fn level(&self, detail: f64) -> &Texture {
        let last = self.levels.len() - 1;
        // What is no number is 0.
        let number = ((detail + 0.5).ceil() - 1.0).clamp(0.0, last as f64) as usize;
        &self.levels[number]
    }

    /// The mix of the two copies between which a level of detail lies, each bilinear.
    #[must_use]
    pub fn trilinear(&self, uv: [f64; 2], detail: f64) -> [f64; 4] {
        let last = (self.levels.len() - 1) as f64;
        let detail = detail.clamp(0.0, last);
        let (finer, t) = (detail.floor(), detail.fract());
        let [a, b] = [finer, (finer + 1.0).min(last)].map(|level| self.level(level).bilinear(uv));
        [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t)
    }
}
