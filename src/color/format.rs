use super::Color;

/// How one pixel lies in the caller's buffer.
///
/// The built-in formats are [`Rgb565`](super::Rgb565), [`Rgb565Be`](super::Rgb565Be) and
/// [`Rgba8888`](super::Rgba8888); a format of your own needs [`pack`](Self::pack) and
/// [`unpack`](Self::unpack).
///
/// ```
/// use microraster::{Color, Format};
///
/// /// Eight bits of green: a monochrome display's grey.
/// #[derive(Clone, Copy, Debug)]
/// struct Grey8;
///
/// impl Format for Grey8 {
///     type Raw = u8;
///     fn pack(color: Color) -> u8 {
///         color.green()
///     }
///     fn unpack(raw: u8) -> Color {
///         Color::new(raw, raw, raw)
///     }
/// }
/// assert_eq!(Grey8::pack(Color::new(1, 200, 3)), 200);
/// ```
pub trait Format {
    /// The stored value of one pixel.
    type Raw: bytemuck::Pod;

    /// The stored value of a colour; fractions are cut off.
    fn pack(color: Color) -> Self::Raw;

    /// The colour of a stored value; `pack(unpack(raw)) == raw`.
    fn unpack(raw: Self::Raw) -> Color;

    /// Sets all of `pixels` to `raw`.
    ///
    /// # Cost
    /// As written here, one store a pixel; the built-in formats store eight words at a time:
    /// half an instruction a 16-bit pixel on Cortex-M4.
    #[inline(always)]
    fn fill(pixels: &mut [Self::Raw], raw: Self::Raw) {
        for pixel in pixels {
            *pixel = raw;
        }
    }
}
