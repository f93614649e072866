use super::view::length;
use super::{DepthBuffer, Frame, FrameError, NoDepth, Size, StencilBuffer};
use crate::color::Format;

/// A picture drawn a few rows at a time, through buffers that hold no more than those.
///
/// The scene is drawn once for each band, into a [`Frame`] that keeps the picture's coordinates,
/// and each band is handed out as soon as it is complete. What comes out is the picture that a
/// whole frame would hold, bit for bit, whatever the number of rows.
///
/// ```
/// use microraster::{Bands, Color, Flat, Rgb, Rgb565, ScreenPass, Size};
/// use microraster::raster::ScreenVertex;
/// # let mut sent = Vec::new();
/// # let mut write_window = |row: u16, pixels: &[u16]| -> Result<(), &str> {
/// #     sent.push((row, pixels.len()));
/// #     Ok(())
/// # };
///
/// // Three rows fit, so that there are four bands: of 3, 3, 3 and 1 rows.
/// let (mut pixels, mut depth) = ([0u16; 16 * 3], [0u16; 16 * 3]);
/// let mut bands = Bands::<Rgb565>::new(&mut pixels, Size::new(16, 10))?.with_depth(&mut depth)?;
/// assert_eq!((bands.rows(), bands.count()), (3, 4));
/// let corner = |x, y| (ScreenVertex::from_bits(x, y, 0x8000), Color::new(255, 0, 0));
/// let triangle = [corner(0, 0), corner(256, 0), corner(0, 160)];
/// let sent_all = bands.draw(
///     |frame| {
///         frame.clear(Rgb::BLACK);
///         ScreenPass::new().triangle(frame, &Flat::colored(), &triangle);
///     },
///     |band| write_window(band.first_row, band.pixels),
/// );
/// assert_eq!(sent_all, Ok(()));
/// # assert_eq!(sent, [(0, 48), (3, 48), (6, 48), (9, 16)]);
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// # Cost
/// Bands themselves cost nothing to speak of; what costs is drawing the scene again: each band
/// pays for the vertices and for the triangles' set-up. No RAM beside the buffers.
#[derive(Debug)]
pub struct Bands<'a, F: Format, D = NoDepth> {
    /// Of [`rows`](Self::rows) rows or, while the last band is drawn, of what is left.
    frame: Frame<'a, F, D>,
    rows: u16,
    picture_height: u16,
}

/// Rows of a picture that are complete: what goes to a display.
pub struct Band<'a, F: Format> {
    /// Its pixels, row by row without gaps. They may be changed: the next band overwrites them.
    pub pixels: &'a mut [F::Raw],
    /// The picture's row that is the band's first.
    pub first_row: u16,
    /// The picture's width, and how many rows these are.
    pub size: Size,
}

impl<F: Format> core::fmt::Debug for Band<'_, F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Band")
            .field("first_row", &self.first_row)
            .field("size", &self.size)
            .finish_non_exhaustive()
    }
}

/// How many whole rows of a picture a buffer holds: at most all of them.
fn whole_rows<T>(buffer: &[T], picture: Size) -> u16 {
    let rows = length(buffer).checked_div(picture.width.into()).unwrap_or(0);
    u16::try_from(rows).unwrap_or(u16::MAX).min(picture.height)
}

impl<'a, F: Format> Bands<'a, F> {
    /// Bands of as many whole rows of a picture of this size as fit into `pixels`.
    ///
    /// # Errors
    /// A side of the picture of 0 or above [`MAX_SIDE`](super::MAX_SIDE), or not even one row of
    /// pixels.
    pub fn new(pixels: &'a mut [F::Raw], picture: Size) -> Result<Self, FrameError> {
        // Where no row fits, one is asked for: the error says what it would take.
        let rows = whole_rows(pixels, picture).max(1);
        let held = Size::new(picture.width, rows.min(picture.height));
        let frame = Frame::new(pixels, held)?.band(0, picture.height)?;
        Ok(Self { frame, rows, picture_height: picture.height })
    }

    /// The same with a depth buffer; bands become as short as it makes them.
    ///
    /// # Errors
    /// Fewer codes than one row has.
    pub fn with_depth(
        self,
        codes: &'a mut [u16],
    ) -> Result<Bands<'a, F, DepthBuffer<'a>>, FrameError> {
        let rows = whole_rows(codes, self.picture()).max(1);
        let bands = self.rows_at_most(rows);
        let Bands { frame, rows, picture_height } = bands;
        Ok(Bands { frame: frame.with_depth(codes)?, rows, picture_height })
    }
}

impl<'a, F: Format, D> Bands<'a, F, D> {
    /// The same with a stencil buffer; bands become as short as it makes them.
    ///
    /// # Errors
    /// Fewer values than one row has.
    pub fn with_stencil(
        self,
        values: &'a mut [u8],
    ) -> Result<Bands<'a, F, StencilBuffer<'a, D>>, FrameError> {
        let rows = whole_rows(values, self.picture()).max(1);
        let bands = self.rows_at_most(rows);
        let Bands { frame, rows, picture_height } = bands;
        Ok(Bands { frame: frame.with_stencil(values)?, rows, picture_height })
    }

    /// The same in bands of at most so many rows, at least one: where a display wants rows in
    /// eights, or supersampling a multiple of its factor.
    #[must_use]
    pub fn rows_at_most(mut self, rows: u16) -> Self {
        self.rows = self.rows.min(rows.max(1));
        self.place(0);
        self
    }

    /// Rows of each band; the last may have fewer.
    pub fn rows(&self) -> u16 {
        self.rows
    }

    /// How many bands make the picture.
    pub fn count(&self) -> u16 {
        self.picture_height.div_ceil(self.rows.max(1))
    }

    /// The whole picture.
    pub fn picture(&self) -> Size {
        Size::new(self.frame.size().width, self.picture_height)
    }

    /// Draws the picture: `scene` draws all of it into each band, from the top, and `send` takes
    /// the band's pixels.
    ///
    /// What a band held before is what the scene finds there, so it should clear first. A scissor
    /// that it sets is gone in the next band.
    ///
    /// # Errors
    /// The first that `send` gives; no further band is drawn then.
    pub fn draw<E>(
        &mut self,
        mut scene: impl FnMut(&mut Frame<'a, F, D>),
        mut send: impl FnMut(Band<'_, F>) -> Result<(), E>,
    ) -> Result<(), E> {
        for number in 0..self.count() {
            if let Some(band) = self.draw_band(number, &mut scene) {
                send(band)?;
            }
        }
        Ok(())
    }

    /// Draws one band, counted from the top, and lends it out; `None` beyond the last.
    ///
    /// For whoever awaits a transfer, or draws only what changed.
    pub fn draw_band(
        &mut self,
        number: u16,
        scene: impl FnOnce(&mut Frame<'a, F, D>),
    ) -> Option<Band<'_, F>> {
        let first_row = number.checked_mul(self.rows)?;
        if first_row >= self.picture_height {
            return None;
        }
        self.place(first_row);
        scene(&mut self.frame);
        let (first_row, size) = (self.frame.first_row(), self.frame.size());
        let pixels = self.frame.all_rows()?;
        Some(Band { pixels, first_row, size })
    }

    /// Moves the frame to the rows from `first_row` on.
    fn place(&mut self, first_row: u16) {
        let left = self.picture_height.saturating_sub(first_row);
        self.frame.move_to(first_row, self.rows.min(left));
    }
}
