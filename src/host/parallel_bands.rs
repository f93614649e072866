use std::sync::Mutex;

use crate::color::Format;
use crate::frame::{DepthBuffer, Frame, FrameError, Size};

/// A whole picture in memory, drawn in bands by as many threads as there are cores.
///
/// The scene is drawn once for each band, as by [`Bands`](crate::Bands), and bands share nothing: it
/// is the picture that one thread would draw, bit for bit. The thread that asks for it draws too: the
/// others take bands as they come awake, and it takes all that they leave.
///
/// ```
/// use microraster::host::ParallelBands;
/// use microraster::math::{AngleUnits, Mat4, Vec3};
/// use microraster::models::TEAPOT;
/// use microraster::{Camera, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};
///
/// let size = Size::new(320, 240);
/// let (mut pixels, mut depth) = (vec![0u16; 320 * 240], vec![0u16; 320 * 240]);
/// let camera = Camera::perspective(45.0.degrees(), 0.5)
///     .look_at(Vec3::new(0.0, 2.0, 5.0), Vec3::ZERO, Vec3::Y);
/// let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
/// ParallelBands::<Rgb565>::new(&mut pixels, &mut depth, size)?.draw(|frame| {
///     frame.clear(Rgb::BLACK);
///     Pass::new(&camera).depth(Less).draw(frame, &Mat4::identity(), &TEAPOT, &shader);
/// });
/// assert!(pixels.iter().any(|pixel| *pixel != 0));
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// # Cost
/// Each band pays for the scene's vertices and for its triangles' set-up, so that threads pay where
/// pixels outweigh those. Threads that sleep take some tens of microseconds to come. Where the thread
/// that asks is one of rayon's, as by [`use_current_thread`](rayon::ThreadPoolBuilder::use_current_thread),
/// it does not wait for those that came too late; any other has to. `cargo peers --threads` measures it.
#[derive(Debug)]
pub struct ParallelBands<'a, F: Format> {
    pixels: &'a mut [F::Raw],
    depth: &'a mut [u16],
    picture: Size,
    rows: u16,
}

impl<'a, F: Format> ParallelBands<'a, F>
where
    F::Raw: Send,
{
    /// A picture of this size, whose rows follow each other without gaps, in as many bands as
    /// rayon's pool of threads has threads.
    ///
    /// # Errors
    /// What [`Frame::new`] and [`Frame::with_depth`] say of a frame of the whole picture.
    pub fn new(
        pixels: &'a mut [F::Raw],
        depth: &'a mut [u16],
        picture: Size,
    ) -> Result<Self, FrameError> {
        Frame::<F>::new(pixels, picture)?.with_depth(depth)?;
        let threads = u16::try_from(rayon::current_num_threads()).unwrap_or(u16::MAX).max(1);
        let rows = picture.height.div_ceil(threads);
        Ok(Self { pixels, depth, picture, rows })
    }

    /// The same in bands of so many rows, at least one: more bands than threads share the work out
    /// more evenly, and cost more set-up.
    #[must_use]
    pub fn rows(mut self, rows: u16) -> Self {
        self.rows = rows.max(1);
        self
    }

    /// Draws the picture: `scene` draws all of it into each band, several at a time.
    pub fn draw(self, scene: impl Fn(&mut Frame<'_, F, DepthBuffer<'_>>) + Sync) {
        let Self { pixels, depth, picture, rows } = self;
        let width = usize::from(picture.width);
        // A buffer may be longer than the picture.
        let all = width * usize::from(picture.height);
        let (Some(pixels), Some(depth)) = (pixels.get_mut(..all), depth.get_mut(..all)) else {
            return;
        };
        let length = width * usize::from(rows);
        let count = picture.height.div_ceil(rows);
        let bands = pixels.chunks_mut(length).zip(depth.chunks_mut(length)).zip(0..count);
        let bands = Mutex::new(bands);
        let draw_bands = || {
            while let Some(((pixels, depth), number)) = next(&bands) {
                let first_row = number * rows;
                let size = Size::new(picture.width, rows.min(picture.height - first_row));
                let frame = Frame::new(pixels, size)
                    .and_then(|frame| frame.with_depth(depth)?.band(first_row, picture.height));
                if let Ok(mut frame) = frame {
                    scene(&mut frame);
                }
            }
        };
        let threads = rayon::current_num_threads().min(count.into());
        rayon::in_place_scope(|scope| {
            for _ in 1..threads {
                scope.spawn(|_| draw_bands());
            }
            draw_bands();
        });
    }
}

/// What comes next, for one thread of several.
fn next<I: Iterator>(items: &Mutex<I>) -> Option<I::Item> {
    items.lock().ok()?.next()
}
