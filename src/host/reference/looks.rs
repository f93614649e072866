use std::vec;
use std::vec::Vec;

use super::Reference;

/// The places of `side` times `side` looks at a pixel, evenly spread: their distances from its
/// centre in pixels.
///
/// ```
/// use microraster::host::reference::looks;
///
/// assert!(looks(1).eq([[0.0, 0.0]]));
/// assert!(looks(2).eq([[-0.25, -0.25], [0.25, -0.25], [-0.25, 0.25], [0.25, 0.25]]));
/// ```
pub fn looks(side: u16) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: u16| (f64::from(i) + 0.5) / f64::from(side) - 0.5;
    (0..side).flat_map(move |row| (0..side).map(move |column| [at(column), at(row)]))
}

/// The mean colours of pictures of one size, by pixel: the mean of what is stored, without gamma.
/// Nothing for no picture.
///
/// Pictures that [`looks`] have been given to make the supersampled truth: what a pixel shows of all
/// that lies in it.
pub fn mean_colors(pictures: impl IntoIterator<Item = Reference>) -> Vec<[f64; 3]> {
    let mut sums = Vec::new();
    let mut count = 0.0;
    for picture in pictures {
        if sums.is_empty() {
            sums = vec![[0.0; 3]; picture.colors().len()];
        }
        for (sum, color) in sums.iter_mut().zip(picture.colors()) {
            *sum = [0, 1, 2].map(|i| sum[i] + color[i]);
        }
        count += 1.0;
    }
    sums.iter().map(|sum| sum.map(|channel| channel / count)).collect()
}
