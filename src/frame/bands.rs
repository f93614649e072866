use core::cell::Cell;

use super::view::length;
use super::{DepthBuffer, Frame, FrameError, NoDepth, Rect, Size, StencilBuffer};
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
///     |band| write_window(band.first_row(), band.pixels()),
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
///
/// ```
/// use microraster::{Bands, Rect, Rgb, Rgb565Be, Size};
///
/// let mut pixels = [0u16; 16 * 3];
/// let mut bands = Bands::<Rgb565Be>::new(&mut pixels, Size::new(16, 10))?;
/// let Some(mut band) = bands.draw_band(1, |frame| frame.clear(Rgb::RED)) else { unreachable!() };
/// assert_eq!(band.area(), Rect::new(0, 3, 16, 6));
/// // In the order in which panels take them: high byte first.
/// assert_eq!(band.as_bytes()[..4], [0xF8, 0x00, 0xF8, 0x00]);
/// // Only what changed.
/// band.crop(Rect::new(2, 0, 4, 5));
/// assert_eq!((band.area(), band.as_bytes().len()), (Rect::new(2, 3, 4, 5), 2 * 2 * 2));
/// # Ok::<(), microraster::FrameError>(())
/// ```
pub struct Band<'a, F: Format> {
    /// At least as many pixels as the area has.
    buffer: &'a mut [F::Raw],
    area: Rect,
}

impl<'a, F: Format> Band<'a, F> {
    /// Its pixels, row by row without gaps.
    pub fn pixels(&self) -> &[F::Raw] {
        self.buffer.get(..self.length()).unwrap_or_default()
    }

    /// The same, to be changed: the next band overwrites them.
    pub fn pixels_mut(&mut self) -> &mut [F::Raw] {
        let length = self.length();
        self.buffer.get_mut(..length).unwrap_or_default()
    }

    /// Its pixels as the bytes that they are in memory: what a display's bus takes.
    ///
    /// [`Rgb565Be`](crate::Rgb565Be) has the order of nearly all panels of 16 bits a pixel, on every
    /// machine; the bytes of [`Rgb565`](crate::Rgb565) are in the machine's own order.
    pub fn as_bytes(&self) -> &[u8] {
        bytemuck::cast_slice(self.pixels())
    }

    /// The pixels of the picture that these are.
    pub fn area(&self) -> Rect {
        self.area
    }

    /// The picture's row that is the band's first.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in a picture")]
    pub fn first_row(&self) -> u16 {
        self.area.top as u16
    }

    /// Columns and rows.
    #[allow(clippy::cast_possible_truncation, reason = "no more than a picture has")]
    pub fn size(&self) -> Size {
        Size::new(self.area.width() as u16, self.area.height() as u16)
    }

    /// Leaves only what lies in `area`, moved together so that there are no gaps. Where nothing is
    /// left, the area is empty, and there is nothing to send.
    ///
    /// A scene that finds this buffer again finds pixels that were moved: it has to clear, or to draw
    /// all, as if the buffer were another.
    ///
    /// # Cost
    /// Nothing where whole rows are left from the top; otherwise one copy of what is left.
    pub fn crop(&mut self, area: Rect) {
        let Rect { left, top, .. } = self.area;
        let kept = self.area.intersection(area);
        // One form of nothing, at the band's own corner.
        let kept = if kept.is_empty() { Rect::new(left, top, left, top) } else { kept };
        let (stride, width) = (self.area.width() as usize, kept.width() as usize);
        let column = kept.left.abs_diff(left) as usize;
        let first = (kept.top.abs_diff(top) as usize).wrapping_mul(stride).wrapping_add(column);
        if width != stride || first != 0 {
            let cells = Cell::from_mut(&mut *self.buffer).as_slice_of_cells();
            for row in 0..kept.height() as usize {
                let from = first.wrapping_add(row.wrapping_mul(stride));
                let to = row.wrapping_mul(width);
                // Never to the right of where it comes from, so that nothing is overwritten unread.
                let places = [to, from].map(|at| cells.get(at..at.wrapping_add(width)));
                let [Some(to), Some(from)] = places else { break };
                to.iter().zip(from).for_each(|(to, from)| to.set(from.get()));
            }
        }
        self.area = kept;
    }

    /// The whole buffer, which begins with the pixels and may be longer: back from a transfer, it
    /// takes another band.
    pub fn into_buffer(self) -> &'a mut [F::Raw] {
        self.buffer
    }

    fn length(&self) -> usize {
        (self.area.width() as usize).wrapping_mul(self.area.height() as usize)
    }
}

impl<F: Format> core::fmt::Debug for Band<'_, F> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Band").field("area", &self.area).finish_non_exhaustive()
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

    /// The rows of a band, counted from the top; empty beyond the last.
    pub fn area(&self, number: u16) -> Rect {
        let height = i32::from(self.picture_height);
        let top = i32::from(number).wrapping_mul(self.rows.into()).min(height);
        let bottom = top.wrapping_add(self.rows.into()).min(height);
        Rect::new(0, top, self.frame.size().width.into(), bottom)
    }

    /// Draws the picture: `scene` draws all of it into each band, from the top, and `send` takes
    /// the band's pixels.
    ///
    /// What a band held before is what the scene finds there, so it should clear first. A scissor
    /// that it sets is gone in the next band.
    ///
    /// Where the buffer was [given away](Self::draw_double_buffered) and none came back, nothing is
    /// sent, and that is no error.
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

    /// Draws one band, counted from the top, and lends it out; `None` beyond the last, and where the
    /// buffer was [given away](Self::draw_double_buffered) and none came back.
    ///
    /// For whoever awaits a transfer, or draws only what changed.
    pub fn draw_band(
        &mut self,
        number: u16,
        scene: impl FnOnce(&mut Frame<'a, F, D>),
    ) -> Option<Band<'_, F>> {
        let area = self.draw_area(number, scene)?;
        let buffer = self.frame.all_rows()?;
        Some(Band { buffer, area })
    }

    /// Draws the picture while the band before is still on its way: `send` takes each band with its
    /// buffer, as soon as it is complete, and gives an empty buffer for the next one.
    ///
    /// That is the one that it took before, once its transfer is over: two buffers, of which the
    /// hardware has one and the scene the other. `send` begins with a spare one; three work as well.
    /// What the scene finds in one is whatever it held: it should clear first.
    ///
    /// ```
    /// use microraster::{Band, Bands, FrameError, Rgb, Rgb565Be, Size};
    ///
    /// /// A transfer that goes on by itself, and owns what it sends.
    /// struct Transfer {
    ///     band: Band<'static, Rgb565Be>,
    /// }
    /// # let mut sent = Vec::new();
    /// # let mut finish = |Transfer { band }: Transfer| -> Result<&'static mut [u16], FrameError> {
    /// #     sent.push((band.first_row(), band.as_bytes().len()));
    /// #     Ok(band.into_buffer())
    /// # };
    ///
    /// // In firmware a `StaticCell` gives these.
    /// let [drawn, spare] = [(); 2].map(|()| Box::leak(Box::new([0u16; 16 * 3])));
    /// let mut bands = Bands::<Rgb565Be>::new(drawn, Size::new(16, 10))?;
    /// let (mut transfer, mut spare) = (None, Some(&mut spare[..]));
    /// bands.draw_double_buffered(
    ///     |frame| frame.clear(Rgb::RED),
    ///     |band| -> Result<_, FrameError> {
    ///         // Waits until the band before is sent, and starts sending this one.
    ///         let free = match transfer.take() {
    ///             Some(transfer) => finish(transfer)?,
    ///             None => spare.take().unwrap_or_default(),
    ///         };
    ///         transfer = Some(Transfer { band });
    ///         Ok(free)
    ///     },
    /// )?;
    /// // The last one; its buffer is spare in the next picture.
    /// let spare = transfer.map(finish).transpose()?;
    /// # assert!(spare.is_some_and(|buffer| buffer.len() == 48));
    /// # assert_eq!(sent, [(0, 96), (3, 96), (6, 96), (9, 32)]);
    /// # Ok::<(), FrameError>(())
    /// ```
    ///
    /// # Errors
    /// The first that `send` gives, or [`FrameError::Color`] where a buffer is too short for a band.
    /// No further band is drawn then, and before the next picture
    /// [`swap_buffer`](Self::swap_buffer) has to bring a buffer: nothing is drawn without one.
    pub fn draw_double_buffered<E: From<FrameError>>(
        &mut self,
        mut scene: impl FnMut(&mut Frame<'a, F, D>),
        mut send: impl FnMut(Band<'a, F>) -> Result<&'a mut [F::Raw], E>,
    ) -> Result<(), E> {
        self.frame.check_buffer(self.rows)?;
        for number in 0..self.count() {
            let Some(area) = self.draw_area(number, &mut scene) else { break };
            let buffer = self.frame.take_buffer();
            let empty = send(Band { buffer, area })?;
            self.swap_buffer(empty)?;
        }
        Ok(())
    }

    /// Exchanges the buffer of pixels, and gives the one that was drawn into: what
    /// [`draw_double_buffered`](Self::draw_double_buffered) does, for whoever awaits transfers.
    ///
    /// # Errors
    /// [`FrameError::Color`] if it is too short for a band; then it is not taken.
    pub fn swap_buffer(
        &mut self,
        buffer: &'a mut [F::Raw],
    ) -> Result<&'a mut [F::Raw], FrameError> {
        self.frame.swap_buffer(buffer, self.rows)
    }

    /// Draws one band, and says which pixels it is; `None` beyond the last.
    fn draw_area(&mut self, number: u16, scene: impl FnOnce(&mut Frame<'a, F, D>)) -> Option<Rect> {
        let area = self.area(number);
        if area.is_empty() {
            return None;
        }
        self.place(self.rows.wrapping_mul(number));
        scene(&mut self.frame);
        Some(area)
    }

    /// Moves the frame to the rows from `first_row` on.
    fn place(&mut self, first_row: u16) {
        let left = self.picture_height.saturating_sub(first_row);
        self.frame.move_to(first_row, self.rows.min(left));
    }
}
