//! How far a picture is from what it should be.
//!
//! ```
//! use microraster::host::reference::compare::{rgb565, Difference, RGB565_STEPS};
//!
//! // A channel of five bits is 255 / 31 of 8-bit steps a step: here green is a whole step low.
//! let exact = [[255.0, 255.0 / 63.0, 0.0], [0.0, 0.0, 255.0]];
//! let difference = Difference::between(&[0xF800, 0x001F].map(rgb565), &exact, RGB565_STEPS);
//! assert_eq!(difference.max, 255.0 / 63.0);
//! assert_eq!(difference.beyond_a_step, 0.0);
//! ```

/// One step of each channel of RGB565, of 255.
pub const RGB565_STEPS: [f64; 3] = [255.0 / 31.0, 255.0 / 63.0, 255.0 / 31.0];

/// One step of each channel of RGBA8888, of 255.
pub const RGBA8888_STEPS: [f64; 3] = [1.0; 3];

/// How far a picture is from what it should be, in steps of 1/255 of full.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The mean of the absolute differences of all channels.
    pub mean: f64,
    /// The largest of them; infinite where one is no number.
    pub max: f64,
    /// The peak signal to noise ratio over all channels, in decibels; infinite for equal pictures.
    pub psnr: f64,
    /// The share of pixels with a channel that is more than a step of its format away, or no
    /// number, 0 to 1.
    pub beyond_a_step: f64,
}

/// What a difference may exceed a step by, for the rounding of `f64`.
const ROUNDING: f64 = 1e-9;

impl Difference {
    /// Compares two pictures of as many pixels; `steps` are those of the format by channel.
    #[must_use]
    pub fn between(drawn: &[[f64; 3]], exact: &[[f64; 3]], steps: [f64; 3]) -> Self {
        let (mut sum, mut squares, mut max, mut beyond) = (0.0, 0.0, 0.0_f64, 0_u32);
        for (drawn, exact) in drawn.iter().zip(exact) {
            let errors = [0, 1, 2].map(|i| (drawn[i] - exact[i]).abs());
            sum += errors.iter().sum::<f64>();
            squares += errors.iter().map(|error| error * error).sum::<f64>();
            let size = |error: f64| if error.is_nan() { f64::INFINITY } else { error };
            max = errors.map(size).into_iter().fold(max, f64::max);
            let is_beyond = |(error, step): (&f64, f64)| error.is_nan() || *error > step + ROUNDING;
            let is_beyond = errors.iter().zip(steps).any(is_beyond);
            beyond += u32::from(is_beyond);
        }
        let pixels = drawn.len().min(exact.len()).max(1) as f64;
        let channels = 3.0 * pixels;
        Self {
            mean: sum / channels,
            max,
            psnr: 10.0 * (255.0 * 255.0 * channels / squares).log10(),
            beyond_a_step: f64::from(beyond) / pixels,
        }
    }
}

/// In how many pixels another primitive, or none, is seen.
#[must_use]
pub fn seen_differently(a: &[Option<u32>], b: &[Option<u32>]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a != b).count()
}

/// In how many pixels only one of two pictures shows anything.
#[must_use]
pub fn covered_differently(a: &[Option<u32>], b: &[Option<u32>]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a.is_some() != b.is_some()).count()
}

/// What a word of RGB565 stands for: each channel its share of full, 0 to 255.
#[must_use]
pub fn rgb565(word: u16) -> [f64; 3] {
    let channel = |bits: u16, full: f64| f64::from(bits) * 255.0 / full;
    [channel(word >> 11, 31.0), channel(word >> 5 & 63, 63.0), channel(word & 31, 31.0)]
}

/// What a word of RGBA8888 stands for.
#[must_use]
pub fn rgba8888(word: u32) -> [f64; 3] {
    let [r, g, b, _] = word.to_ne_bytes();
    [r, g, b].map(f64::from)
}
