//! The gallery: small pictures to look at and to copy from, one a file.
//!
//! Each is one function that needs neither `std` nor a heap. The host program `gallery`, the
//! firmware and the tests include this folder, so that all of them draw from the same source.

pub(crate) mod attitude;
pub(crate) mod cloud;
pub(crate) mod deferred;
pub(crate) mod font;
pub(crate) mod gears;
pub(crate) mod glass;
pub(crate) mod logo;
pub(crate) mod shadow;
pub(crate) mod shapes;
pub(crate) mod smooth;
pub(crate) mod terrain;
pub(crate) mod wireframe;

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
/// Rows of the largest picture, of a word a pixel, that fit there.
const ROWS: u16 = 120;

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
    #[allow(dead_code, reason = "only the host program lists them")]
    pub(crate) about: &'static str,
    pub(crate) size: Size,
    /// The turn in degrees at which it is kept.
    pub(crate) turn: f32,
    /// Draws it at a turn, and counts.
    pub(crate) draw: fn(&mut Canvas<'_>, turn: f32, &mut Stats) -> Result<(), FrameError>,
}

const FULL: Size = Size::new(320, 240);
const SMALL: Size = Size::new(128, 64);

/// A picture that wants a frame with depth, and no more.
macro_rules! picture {
    ($name:literal, $about:literal, $size:expr, $turn:literal, $draw:expr) => {
        Picture {
            name: $name,
            about: $about,
            size: $size,
            turn: $turn,
            draw: |canvas, turn, stats| {
                $draw(&mut canvas.frame()?, turn, stats);
                Ok(())
            },
        }
    };
}

/// All of them.
pub(crate) const PICTURES: [Picture; 11] = [
    picture!("gears", "three turning gears, in strips", FULL, 0.0, gears::draw),
    picture!("logo", "a spinning box with a textured logo and text", FULL, 32.0, logo::draw),
    picture!("attitude", "a board at roll, pitch and yaw, with its axes", FULL, 0.0, tumbling),
    picture!("attitude-small", "the same on 128x64 pixels", SMALL, 0.0, tumbling),
    picture!("cloud", "a point cloud of 20 000 points, by distance", FULL, 0.0, cloud::draw),
    picture!("terrain", "hills from a height map, under fog", FULL, 310.0, terrain::draw),
    picture!("shadow", "a teapot's shadow on a floor", FULL, 20.0, shadow::draw),
    picture!("wireframe", "edges without those that are hidden", FULL, 25.0, wireframe::draw),
    picture!("glass", "balls of glass around a teapot, sorted", FULL, 15.0, glass::draw),
    Picture {
        name: "deferred",
        about: "what is visible first, its colour later",
        size: FULL,
        turn: 0.0,
        draw: |canvas, turn, stats| {
            let Canvas { picture, pixels, depth, words, .. } = canvas;
            let width = usize::from(picture.width);
            let attributes = bytemuck::cast_slice_mut(words);
            // As many rows at a time as there is memory for.
            let bands = (canvas.first_row..canvas.first_row + canvas.rows).step_by(ROWS.into());
            for (first, pixels) in bands.zip(pixels.chunks_mut(width * usize::from(ROWS))) {
                let rows = ROWS.min(canvas.first_row + canvas.rows - first);
                let band = (*picture, first, rows);
                deferred::draw(pixels, attributes, depth, band, turn, stats)?;
            }
            Ok(())
        },
    },
    Picture {
        name: "smooth",
        about: "1, 4 and 16 samples a pixel, and smooth lines",
        size: FULL,
        turn: 4.0,
        draw: |canvas, turn, stats| {
            let Canvas { picture, first_row, rows, pixels, depth, words } = canvas;
            let size = Size::new(picture.width, *rows);
            let frame = Frame::new(pixels, size)?.with_depth(depth)?;
            let mut frame = frame.band(*first_row, picture.height)?;
            let (samples, codes) = words.split_at_mut(WORDS / 3 * 2);
            smooth::draw(&mut frame, samples, bytemuck::cast_slice_mut(codes), turn, stats)
        },
    },
];

/// The board, tumbling.
fn tumbling(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    let (sin, cos) = microraster::math::Angle::from_degrees(turn).sin_cos();
    let attitude = attitude::Attitude {
        roll: 18.0 * cos - 30.0 * sin,
        pitch: -16.0 * cos,
        yaw: -8.0 * cos + 24.0 * sin,
    };
    attitude::draw(frame, attitude, stats);
}
