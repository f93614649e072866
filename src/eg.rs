//! The door to `embedded-graphics`: a [`Frame`] is a [`DrawTarget`], so that text and 2D land on
//! the same pixels as the 3D picture, and a [`Band`] is a [`Drawable`], so that every display driver
//! takes it.

use core::convert::Infallible;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics_core::pixelcolor::{self, IntoStorage, PixelColor, RgbColor};
use embedded_graphics_core::primitives::Rectangle;
use embedded_graphics_core::{Drawable, Pixel};

use crate::color::{Format, Rgb565, Rgb565Be, Rgba8888};
use crate::frame::{Band, Frame, Rect};

/// A pixel format that `embedded-graphics` has a colour for.
///
/// ```
/// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
/// use microraster::{DrawFormat, Rgb565Be};
///
/// // Red comes first on the wire.
/// assert_eq!(Rgb565Be::pack_draw_color(Rgb565::RED).to_ne_bytes(), [0xF8, 0x00]);
/// ```
pub trait DrawFormat: Format {
    /// The colour of `embedded-graphics` that loses nothing.
    type DrawColor: PixelColor;

    /// The stored value of a colour.
    fn pack_draw_color(color: Self::DrawColor) -> Self::Raw;

    /// The colour of a stored value; `pack_draw_color(unpack_draw_color(raw)) == raw`, but that the
    /// alpha of [`Rgba8888`] becomes 255.
    fn unpack_draw_color(raw: Self::Raw) -> Self::DrawColor;
}

impl DrawFormat for Rgb565 {
    type DrawColor = pixelcolor::Rgb565;

    #[inline]
    fn pack_draw_color(color: pixelcolor::Rgb565) -> u16 {
        RawU16::from(color).into_inner()
    }

    #[inline]
    fn unpack_draw_color(raw: u16) -> pixelcolor::Rgb565 {
        RawU16::new(raw).into()
    }
}

impl DrawFormat for Rgb565Be {
    type DrawColor = pixelcolor::Rgb565;

    #[inline]
    fn pack_draw_color(color: pixelcolor::Rgb565) -> u16 {
        color.into_storage().to_be()
    }

    #[inline]
    fn unpack_draw_color(raw: u16) -> pixelcolor::Rgb565 {
        RawU16::new(u16::from_be(raw)).into()
    }
}

impl DrawFormat for Rgba8888 {
    type DrawColor = pixelcolor::Rgb888;

    #[inline]
    fn pack_draw_color(color: pixelcolor::Rgb888) -> u32 {
        u32::from_ne_bytes([color.r(), color.g(), color.b(), 255])
    }

    #[inline]
    fn unpack_draw_color(raw: u32) -> pixelcolor::Rgb888 {
        let [red, green, blue, _] = raw.to_ne_bytes();
        pixelcolor::Rgb888::new(red, green, blue)
    }
}

/// A rectangle of `embedded-graphics` in 64 bits, where no corner can overflow, cut to `limit`.
#[allow(clippy::cast_possible_truncation, reason = "between the sides of a rectangle of i32")]
fn cut(area: &Rectangle, limit: Rect) -> Rect {
    let (left, top) = (i64::from(area.top_left.x), i64::from(area.top_left.y));
    let (right, bottom) = (left + i64::from(area.size.width), top + i64::from(area.size.height));
    Rect {
        left: left.max(limit.left.into()) as i32,
        top: top.max(limit.top.into()) as i32,
        right: right.min(limit.right.into()) as i32,
        bottom: bottom.min(limit.bottom.into()) as i32,
    }
}

/// Takes so many colours off; `None` if there are no more.
fn skip<C>(colors: &mut impl Iterator<Item = C>, count: u32) -> Option<()> {
    match count.checked_sub(1) {
        Some(last) => colors.nth(last as usize).map(|_| ()),
        None => Some(()),
    }
}

/// The whole picture, also where the frame is a band of it.
impl<F: Format, D> OriginDimensions for Frame<'_, F, D> {
    fn size(&self) -> Size {
        let picture = self.picture();
        Size::new(picture.width.into(), picture.height.into())
    }
}

/// Draws in the coordinates of the whole picture. What lies outside of the scissor or of the band
/// is left out; depth is not touched.
///
/// # Cost
/// Solid areas are filled by whole words where they are aligned, rows of an image are copied as
/// slices; only single pixels are looked up one by one.
///
/// ```
/// use embedded_graphics_core::draw_target::DrawTarget;
/// use embedded_graphics_core::geometry::{Point, Size};
/// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
/// use embedded_graphics_core::primitives::Rectangle;
/// use microraster::Frame;
///
/// let mut pixels = [0; 16 * 8];
/// let mut frame = Frame::<microraster::Rgb565>::new(&mut pixels, microraster::Size::new(16, 8))?;
/// let bar = Rectangle::new(Point::new(-4, 6), Size::new(12, 9));
/// let Ok(()) = frame.fill_solid(&bar, Rgb565::WHITE);
/// assert_eq!(pixels.iter().filter(|pixel| **pixel == 0xFFFF).count(), 8 * 2);
/// # Ok::<(), microraster::FrameError>(())
/// ```
impl<F: DrawFormat, D> DrawTarget for Frame<'_, F, D> {
    type Color = F::DrawColor;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<F::DrawColor>>,
    {
        let scissor = self.scissor();
        for Pixel(at, color) in pixels {
            if scissor.contains(at.x, at.y) {
                // Inside of the scissor the next column is no overflow.
                if let Some([pixel]) = self.row(at.y, at.x, at.x.wrapping_add(1)) {
                    *pixel = F::pack_draw_color(color);
                }
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = F::DrawColor>,
    {
        let visible = cut(area, self.scissor());
        if visible.is_empty() {
            return Ok(());
        }
        let mut colors = colors.into_iter();
        // Visible, so that the differences lie within the area's own size.
        let before = visible.left.abs_diff(area.top_left.x);
        let behind = area.size.width.wrapping_sub(before).wrapping_sub(visible.width());
        for _ in 0..visible.top.abs_diff(area.top_left.y) {
            if skip(&mut colors, area.size.width).is_none() {
                return Ok(());
            }
        }
        for y in visible.top..visible.bottom {
            if skip(&mut colors, before).is_none() {
                return Ok(());
            }
            for pixel in self.row(y, visible.left, visible.right).unwrap_or_default() {
                let Some(color) = colors.next() else { return Ok(()) };
                *pixel = F::pack_draw_color(color);
            }
            if skip(&mut colors, behind).is_none() {
                return Ok(());
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: F::DrawColor) -> Result<(), Infallible> {
        let visible = cut(area, self.scissor());
        if !visible.is_empty() {
            self.fill_rect(visible, F::pack_draw_color(color));
        }
        Ok(())
    }

    fn clear(&mut self, color: F::DrawColor) -> Result<(), Infallible> {
        self.fill_rect(self.scissor(), F::pack_draw_color(color));
        Ok(())
    }
}

/// The rectangle of an area, which is not empty.
fn rectangle(area: Rect) -> Rectangle {
    Rectangle::new(Point::new(area.left, area.top), Size::new(area.width(), area.height()))
}

/// The pixels of the picture that these are.
impl<F: Format> Dimensions for Band<'_, F> {
    fn bounding_box(&self) -> Rectangle {
        rectangle(self.area())
    }
}

/// Sends the pixels to a display, or wherever else pixels go, by one
/// [`fill_contiguous`](DrawTarget::fill_contiguous): the path that drivers make fast.
///
/// ```
/// use embedded_graphics_core::prelude::*;
/// use microraster::{Bands, Rgb, Rgb565, Size};
/// # use embedded_graphics_core::pixelcolor;
/// # use embedded_graphics_core::primitives::Rectangle;
/// # struct Display(usize);
/// # impl OriginDimensions for Display {
/// #     fn size(&self) -> embedded_graphics_core::geometry::Size {
/// #         embedded_graphics_core::geometry::Size::new(16, 10)
/// #     }
/// # }
/// # impl DrawTarget for Display {
/// #     type Color = pixelcolor::Rgb565;
/// #     type Error = core::convert::Infallible;
/// #     fn draw_iter<I: IntoIterator<Item = Pixel<Self::Color>>>(
/// #         &mut self,
/// #         pixels: I,
/// #     ) -> Result<(), Self::Error> {
/// #         self.0 += pixels.into_iter().filter(|pixel| pixel.1 == Self::Color::RED).count();
/// #         Ok(())
/// #     }
/// # }
/// # let mut display = Display(0);
///
/// let mut pixels = [0u16; 16 * 3];
/// let mut bands = Bands::<Rgb565>::new(&mut pixels, Size::new(16, 10))?;
/// let drawn = bands.draw(|frame| frame.clear(Rgb::RED), |band| band.draw(&mut display));
/// assert!(drawn.is_ok());
/// # assert_eq!(display.0, 160);
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// # Cost
/// Each pixel is unpacked and packed again by the driver, some ten instructions; where the driver
/// takes bytes, [`as_bytes`](Band::as_bytes) costs none.
impl<F: DrawFormat> Drawable for Band<'_, F> {
    type Color = F::DrawColor;
    type Output = ();

    /// Nothing is sent of an empty area.
    fn draw<T: DrawTarget<Color = F::DrawColor>>(&self, target: &mut T) -> Result<(), T::Error> {
        if self.area().is_empty() {
            return Ok(());
        }
        let colors = self.pixels().iter().map(|raw| F::unpack_draw_color(*raw));
        target.fill_contiguous(&self.bounding_box(), colors)
    }
}

/// Sends the rows that the frame holds to a display, to their place in the picture; the scissor
/// limits what is sent.
impl<F: DrawFormat, D> Drawable for Frame<'_, F, D> {
    type Color = F::DrawColor;
    type Output = ();

    /// Nothing is sent of an empty area.
    fn draw<T: DrawTarget<Color = F::DrawColor>>(&self, target: &mut T) -> Result<(), T::Error> {
        let area = self.scissor();
        if area.is_empty() {
            return Ok(());
        }
        let rows = (area.top..area.bottom).filter_map(|y| self.samples(y, area.left, area.right));
        let colors = rows.flatten().map(|raw| F::unpack_draw_color(*raw));
        target.fill_contiguous(&rectangle(area), colors)
    }
}
