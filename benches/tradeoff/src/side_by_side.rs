//! What was drawn, what should be, and the difference, beside each other.

use image::{Rgb, RgbImage};
use std::path::Path;

use crate::scenes::standard::SIZE;

/// How many times a difference is shown.
pub(crate) const GAIN: f64 = 8.0;

/// Writes the three pictures in a row, the difference [`GAIN`] times and on black.
///
/// # Errors
/// The file cannot be written.
pub(crate) fn write(drawn: &[[f64; 3]], exact: &[[f64; 3]], file: &Path) -> Result<(), String> {
    let (width, height) = (u32::from(SIZE.width), u32::from(SIZE.height));
    let byte = |v: f64| v.round().clamp(0.0, 255.0) as u8;
    let gap = 4;
    let mut picture = RgbImage::from_pixel(3 * width + 2 * gap, height, Rgb([255; 3]));
    for (i, (drawn, exact)) in (0..).zip(drawn.iter().zip(exact)) {
        let (x, y) = (i % width, i / width);
        let difference = [0, 1, 2].map(|k| (drawn[k] - exact[k]).abs() * GAIN);
        for (column, color) in [*drawn, *exact, difference].into_iter().enumerate() {
            let left = column as u32 * (width + gap);
            picture.put_pixel(left + x, y, Rgb(color.map(byte)));
        }
    }
    picture.save(file).map_err(|why| format!("{}: {why}", file.display()))
}
