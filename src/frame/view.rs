use super::depth::{DepthAccess, Supplies};
use super::{DepthBuffer, FrameError, NoDepth, Rect, Size};
use crate::color::{fill_halves, Color, Format};

/// The longest side of a picture, in pixels: the square in which edge functions are exact.
pub const MAX_SIDE: u16 = 8192;

/// The caller's buffers as one checked view: colour in format `F`, and depth or none of it, and
/// stencil values or none of them.
///
/// ```
/// use microraster::{Frame, Rgb, Rgb565, Size};
///
/// let (mut pixels, mut depth) = ([0u16; 64 * 32], [0u16; 64 * 32]);
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(64, 32))?.with_depth(&mut depth)?;
/// frame.clear(Rgb::BLUE);
/// assert_eq!(pixels[0], 0x001F);
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// # Cost
/// Checks happen in the constructors; drawing takes slices that cannot be out of bounds and skips
/// what would be, so that no panic path is linked.
pub struct Frame<'a, F: Format, D = NoDepth> {
    pub(super) pixels: &'a mut [F::Raw],
    pub(super) depth: D,
    pub(super) stride: usize,
    pub(super) size: Size,
    pub(super) first_row: u16,
    pub(super) picture_height: u16,
    pub(super) scissor: Rect,
}

impl<F: Format, D: core::fmt::Debug> core::fmt::Debug for Frame<'_, F, D> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Frame")
            .field("size", &self.size)
            .field("stride", &self.stride)
            .field("first_row", &self.first_row)
            .field("picture_height", &self.picture_height)
            .field("scissor", &self.scissor)
            .finish_non_exhaustive()
    }
}

/// Colours, cells, and the number of a pixel in both.
type AllPixels<'a, F, A> = (&'a mut [<F as Format>::Raw], <A as DepthAccess>::Cells<'a>, usize);

/// How many elements rows of this stride span: the last row needs only its width.
pub(super) fn needed(size: Size, stride: u32) -> u32 {
    stride
        .saturating_mul(u32::from(size.height).saturating_sub(1))
        .saturating_add(size.width.into())
}

/// A buffer's length, as far as a message needs it.
pub(super) fn length<T>(slice: &[T]) -> u32 {
    u32::try_from(slice.len()).unwrap_or(u32::MAX)
}

impl<'a, F: Format> Frame<'a, F> {
    /// A frame whose rows follow each other without a gap.
    ///
    /// # Errors
    /// A side of 0 or above [`MAX_SIDE`], or fewer pixels than width x height. A longer buffer is
    /// fine; its end stays untouched.
    pub fn new(pixels: &'a mut [F::Raw], size: Size) -> Result<Self, FrameError> {
        Self::with_stride(pixels, size, size.width.into())
    }

    /// A frame in a larger picture: rows start `stride` pixels apart.
    ///
    /// The slice starts at the frame's own upper left pixel.
    ///
    /// # Errors
    /// As [`new`](Self::new), and a stride shorter than the width.
    pub fn with_stride(
        pixels: &'a mut [F::Raw],
        size: Size,
        stride: u32,
    ) -> Result<Self, FrameError> {
        if size.width == 0 || size.height == 0 {
            return Err(FrameError::Empty);
        }
        if let Some(&got) = [size.width, size.height].iter().find(|&&side| side > MAX_SIDE) {
            return Err(FrameError::TooLarge { got: got.into() });
        }
        check_stride(size, stride)?;
        let needed = needed(size, stride);
        if length(pixels) < needed {
            return Err(FrameError::Color { needed, got: length(pixels) });
        }
        Ok(Self {
            pixels,
            depth: NoDepth,
            stride: stride as usize,
            size,
            first_row: 0,
            picture_height: size.height,
            scissor: Rect::from_size(size),
        })
    }

    /// The same frame with a depth buffer whose rows follow each other without a gap.
    ///
    /// # Errors
    /// Fewer codes than width x height.
    pub fn with_depth(
        self,
        codes: &'a mut [u16],
    ) -> Result<Frame<'a, F, DepthBuffer<'a>>, FrameError> {
        let stride = self.size.width.into();
        self.with_depth_stride(codes, stride)
    }

    /// The same frame with a depth buffer whose rows start `stride` codes apart.
    ///
    /// # Errors
    /// As [`with_depth`](Self::with_depth), and a stride shorter than the width.
    pub fn with_depth_stride(
        self,
        codes: &'a mut [u16],
        stride: u32,
    ) -> Result<Frame<'a, F, DepthBuffer<'a>>, FrameError> {
        check_stride(self.size, stride)?;
        let needed = needed(self.size, stride);
        if length(codes) < needed {
            return Err(FrameError::Depth { needed, got: length(codes) });
        }
        Ok(Frame {
            pixels: self.pixels,
            depth: DepthBuffer { codes, stride: stride as usize },
            stride: self.stride,
            size: self.size,
            first_row: self.first_row,
            picture_height: self.picture_height,
            scissor: self.scissor,
        })
    }
}

pub(super) fn check_stride(size: Size, stride: u32) -> Result<(), FrameError> {
    if stride < u32::from(size.width) {
        return Err(FrameError::Stride { needed: size.width.into(), got: stride });
    }
    Ok(())
}

impl<'a, F: Format, D> Frame<'a, F, D> {
    /// Makes the frame a band: its rows are rows `first_row..` of a picture of `picture_height`.
    ///
    /// Everything drawn keeps the picture's coordinates; only what lies in the band is stored. The
    /// scissor is reset to the whole band.
    ///
    /// # Errors
    /// The band reaches beyond the picture, or the picture is taller than [`MAX_SIDE`].
    ///
    /// # Measured
    /// <!-- tradeoff: teapot/rows=16 -->
    /// `16` in the scene `teapot`: 4.51 M (M4F), 8.30 M (M0+), 5.56 M (RV32) instructions a frame; PSNR 40.7 dB.
    pub fn band(mut self, first_row: u16, picture_height: u16) -> Result<Self, FrameError> {
        if picture_height > MAX_SIDE {
            return Err(FrameError::TooLarge { got: picture_height.into() });
        }
        let needed = u32::from(first_row) + u32::from(self.size.height);
        if needed > u32::from(picture_height) {
            return Err(FrameError::Band { needed, got: picture_height.into() });
        }
        self.first_row = first_row;
        self.picture_height = picture_height;
        self.scissor = self.held();
        Ok(self)
    }

    /// Makes the frame another band of its picture, of no more rows than it was made for.
    pub(super) fn move_to(&mut self, first_row: u16, rows: u16) {
        self.first_row = first_row;
        self.size.height = rows;
        self.scissor = self.held();
    }

    /// Whether there are pixels for so many rows without gaps.
    pub(super) fn check_buffer(&self, rows: u16) -> Result<(), FrameError> {
        let needed = needed(Size::new(self.size.width, rows), self.size.width.into());
        let got = length(self.pixels);
        if got < needed {
            Err(FrameError::Color { needed, got })
        } else {
            Ok(())
        }
    }

    /// Takes the pixels away: nothing is drawn before there are others.
    pub(super) fn take_buffer(&mut self) -> &'a mut [F::Raw] {
        core::mem::take(&mut self.pixels)
    }

    /// Exchanges the pixels, if there are enough for so many rows without gaps.
    pub(super) fn swap_buffer(
        &mut self,
        buffer: &'a mut [F::Raw],
        rows: u16,
    ) -> Result<&'a mut [F::Raw], FrameError> {
        let before = core::mem::replace(&mut self.pixels, buffer);
        if let Err(error) = self.check_buffer(rows) {
            self.pixels = before;
            return Err(error);
        }
        Ok(before)
    }

    /// All pixels that a frame without gaps holds.
    pub(super) fn all_rows(&mut self) -> Option<&mut [F::Raw]> {
        self.rows(self.held())
    }

    /// Limits drawing and clearing to `rect`, in picture coordinates; what lies outside of the
    /// frame is cut off. An empty rectangle lets nothing through.
    pub fn set_scissor(&mut self, rect: Rect) {
        let held = self.held();
        let scissor = held.intersection(rect);
        // One form of nothing, whose sides lie within the frame.
        let nothing = Rect { right: held.left, bottom: held.top, ..held };
        self.scissor = if scissor.is_empty() { nothing } else { scissor };
    }

    /// Lets everything through again.
    pub fn reset_scissor(&mut self) {
        self.scissor = self.held();
    }

    /// The rectangle that drawing reaches: the scissor, cut to the rows that the frame holds.
    pub fn scissor(&self) -> Rect {
        self.scissor
    }

    /// Width of the picture and the rows that this frame holds of it.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The whole picture, of which the frame may be a band.
    pub fn picture(&self) -> Size {
        Size::new(self.size.width, self.picture_height)
    }

    /// The picture's row that is the frame's first.
    pub fn first_row(&self) -> u16 {
        self.first_row
    }

    /// The pixels that the frame holds, in picture coordinates.
    fn held(&self) -> Rect {
        let top = i32::from(self.first_row);
        Rect::new(0, top, self.size.width.into(), top + i32::from(self.size.height))
    }

    /// The scissor in the rows that the frame holds, counted from its first.
    pub(super) fn held_scissor(&self) -> Rect {
        let (area, first) = (self.scissor, i32::from(self.first_row));
        let (top, bottom) = (area.top.wrapping_sub(first), area.bottom.wrapping_sub(first));
        Rect { top, bottom, ..area }
    }

    /// Sets the colour of all pixels in the scissor; depth stays.
    pub fn clear_color(&mut self, color: impl Into<Color>) {
        let raw = F::pack(color.into());
        let area = self.scissor;
        self.fill_rect(area, raw);
    }

    /// Sets the stored value of all pixels in `area`, as far as the scissor reaches.
    pub(crate) fn fill_rect(&mut self, area: Rect, raw: F::Raw) {
        let area = self.scissor.intersection(area);
        if area.left == 0 && area.right == i32::from(self.size.width) && self.is_tight() {
            // Whole rows without gaps: one run of stores.
            if let Some(run) = self.rows(area) {
                F::fill(run, raw);
            }
            return;
        }
        for y in area.top..area.bottom {
            if let Some(row) = self.row(y, area.left, area.right) {
                F::fill(row, raw);
            }
        }
    }

    fn is_tight(&self) -> bool {
        self.stride == usize::from(self.size.width)
    }

    /// All pixels of whole rows in one slice.
    fn rows(&mut self, area: Rect) -> Option<&mut [F::Raw]> {
        let (top, bottom) = (self.held_row(area.top), self.held_row(area.bottom));
        self.pixels.get_mut(top.wrapping_mul(self.stride)..bottom.wrapping_mul(self.stride))
    }

    /// The frame's own number of a picture row.
    #[inline(always)]
    fn held_row(&self, y: i32) -> usize {
        y.wrapping_sub(self.first_row.into()) as usize
    }

    /// Columns `left..right` of picture row `y`; `None` where the frame does not reach.
    #[inline(always)]
    pub(crate) fn row(&mut self, y: i32, left: i32, right: i32) -> Option<&mut [F::Raw]> {
        let start = self.held_row(y).wrapping_mul(self.stride);
        self.pixels.get_mut(start.wrapping_add(left as usize)..start.wrapping_add(right as usize))
    }

    /// The same, to be read.
    pub(crate) fn samples(&self, y: i32, left: i32, right: i32) -> Option<&[F::Raw]> {
        let within = right <= i32::from(self.size.width);
        let start = self.held_row(y).wrapping_mul(self.stride);
        let row = start.wrapping_add(left as usize)..start.wrapping_add(right as usize);
        let held = y >= self.held().top && y < self.held().bottom;
        (within && held).then_some(self.pixels.get(row)?)
    }

    /// From one row to the next, in pixels.
    #[inline(always)]
    pub(crate) fn stride(&self) -> usize {
        self.stride
    }

    /// Whether rows of cells are as far apart as those of colour.
    #[inline(always)]
    pub(crate) fn has_one_stride<A: DepthAccess>(&self) -> bool
    where
        D: Supplies<A>,
    {
        self.depth.has_stride(self.stride)
    }

    /// All colours and cells, as many of both, and the number of a pixel in them. Neighbours in
    /// other rows are a [stride](Self::stride) away. Where rows of cells have
    /// [another](Self::has_one_stride), it is the pixel alone.
    #[inline(always)]
    pub(crate) fn all_from<A: DepthAccess>(&mut self, x: i32, y: i32) -> Option<AllPixels<'_, F, A>>
    where
        D: Supplies<A>,
    {
        let row = self.held_row(y);
        let at = row.wrapping_mul(self.stride).wrapping_add(x as usize);
        if !self.depth.has_stride(self.stride) {
            let cells = self.depth.cells(row, x as usize, 1)?;
            return Some((self.pixels.get_mut(at..)?.get_mut(..1)?, cells, 0));
        }
        let length = self.pixels.len().min(self.depth.length());
        let cells = self.depth.run(length)?;
        Some((self.pixels.get_mut(..length)?, cells, at))
    }

    /// Colours and cells of columns `left..right` of picture row `y`; `None` where the frame does
    /// not reach.
    #[inline(always)]
    pub(crate) fn row_with_depth<A: DepthAccess>(
        &mut self,
        y: i32,
        left: i32,
        right: i32,
    ) -> Option<(&mut [F::Raw], A::Cells<'_>)>
    where
        D: Supplies<A>,
    {
        let row = self.held_row(y);
        let start = row.wrapping_mul(self.stride).wrapping_add(left as usize);
        let length = right.wrapping_sub(left) as usize;
        // Two steps: a range would have its order checked besides its end.
        let pixels = self.pixels.get_mut(start..)?.get_mut(..length)?;
        let cells = self.depth.cells(row, left as usize, length)?;
        Some((pixels, cells))
    }
}

impl<F: Format> Frame<'_, F, NoDepth> {
    /// Sets the colour of all pixels in the scissor.
    pub fn clear(&mut self, color: impl Into<Color>) {
        self.clear_color(color);
    }
}

impl<F: Format> Frame<'_, F, DepthBuffer<'_>> {
    /// Sets the colour of all pixels in the scissor, and their depth to 0, the farthest.
    pub fn clear(&mut self, color: impl Into<Color>) {
        self.clear_color(color);
        self.clear_depth(0);
    }

    /// Sets the depth code of all pixels in the scissor: 0 is farthest, 65535 nearest.
    pub fn clear_depth(&mut self, code: u16) {
        let area = self.held_scissor();
        clear_codes(&mut self.depth, area, code);
    }
}

/// Sets the codes in an area of held rows.
pub(super) fn clear_codes(depth: &mut DepthBuffer<'_>, area: Rect, code: u16) {
    clear_cells(depth.codes, depth.stride, area, |cells| {
        let word = u32::from(code) * 0x0001_0001;
        fill_halves(cells, word, word);
    });
}

/// Fills an area of held rows: whole rows without gaps at once.
#[inline(always)]
pub(super) fn clear_cells<T>(
    cells: &mut [T],
    stride: usize,
    area: Rect,
    mut fill: impl FnMut(&mut [T]),
) {
    let (left, width) = (area.left as usize, area.width() as usize);
    if width == stride {
        let run =
            (area.top as usize).wrapping_mul(stride)..(area.bottom as usize).wrapping_mul(stride);
        if let Some(run) = cells.get_mut(run) {
            fill(run);
        }
        return;
    }
    for row in area.top..area.bottom {
        let start = (row as usize).wrapping_mul(stride).wrapping_add(left);
        if let Some(cells) = cells.get_mut(start..start.wrapping_add(width)) {
            fill(cells);
        }
    }
}
