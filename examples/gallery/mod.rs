//! The gallery: small pictures to look at and to copy from, one a file.
//!
//! Each is one function that needs neither `std` nor a heap. The host program `gallery`, the
//! firmware and the tests include this folder, so that all of them draw from the same source.

pub(crate) mod gears;

use microraster::{DepthBuffer, Frame, FrameError, Rgb565, Size, Stats};

/// Memory of a picture, or of a band of it.
#[derive(Debug)]
pub(crate) struct Canvas<'a> {
    /// The whole picture.
    pub(crate) picture: Size,
    /// The rows to be drawn.
    pub(crate) first_row: u16,
    pub(crate) rows: u16,
    pub(crate) pixels: &'a mut [u16],
    /// Depth codes: as many as pixels, at least.
    pub(crate) depth: &'a mut [u16],
    /// For pictures that want more than pixels: [`WORDS`] at least.
    pub(crate) words: &'a mut [u32],
}

/// Pixels, and depth codes, of the largest picture.
pub(crate) const PIXELS: usize = 320 * 240;
/// Words of memory that a picture may want besides.
pub(crate) const WORDS: usize = PIXELS / 2;

impl Canvas<'_> {
    /// The band with depth.
    fn frame(&mut self) -> Result<Frame<'_, Rgb565, DepthBuffer<'_>>, FrameError> {
        let Self { picture, first_row, rows, pixels, depth, .. } = self;
        let size = Size::new(picture.width, *rows);
        Frame::new(pixels, size)?.with_depth(depth)?.band(*first_row, picture.height)
    }
}

/// A picture of the gallery.
#[derive(Clone, Copy)]
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    /// What it shows, in a line.
    pub(crate) about: &'static str,
    pub(crate) size: Size,
    /// The turn in degrees at which it is kept.
    pub(crate) turn: f32,
    /// Draws it at a turn, and counts.
    pub(crate) draw: fn(&mut Canvas<'_>, turn: f32, &mut Stats) -> Result<(), FrameError>,
}

const FULL: Size = Size::new(320, 240);

/// All of them.
pub(crate) const PICTURES: [Picture; 1] = [
    Picture {
        name: "gears",
        about: "three turning gears, in strips",
        size: FULL,
        turn: 0.0,
        draw: |canvas, turn, stats| {
            gears::draw(&mut canvas.frame()?, turn, stats);
            Ok(())
        },
    },
];
