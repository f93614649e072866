use crate::frame::Damage;

/// What became of the primitives and pixels of the draws that counted here.
///
/// `triangles + lines + points = culled + degenerate + outside + skipped + drawn`, whatever was
/// drawn.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stats {
    /// Triangles that came in.
    pub triangles: u32,
    /// Lines that came in.
    pub lines: u32,
    /// Points that came in.
    pub points: u32,
    /// Triangles that face the culled side.
    pub culled: u32,
    /// Triangles of zero area on the screen, lines that do not leave the diamond they start in,
    /// points of size 0.
    pub degenerate: u32,
    /// Primitives beside the view, the scissor or the band, and triangles too small to hold a
    /// pixel centre between their sides.
    pub outside: u32,
    /// Primitives that cannot be drawn: an index out of range, a matrix that is not finite, a
    /// corner that is no number or out of range.
    pub skipped: u32,
    /// Primitives that went on to the rasterizer.
    pub drawn: u32,
    /// Triangles that were cut at the near or far plane or at the guard box, drawn or not.
    pub clipped: u32,
    /// Pixels written, each time they were.
    pub pixels: u32,
}

/// One thing that can become of a primitive.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    Triangle,
    Line,
    Point,
    Culled,
    Degenerate,
    Outside,
    Skipped,
    Drawn,
    Clipped,
}

/// Whether a pass counts: [`Uncounted`] or [`Counting`]; or [`Tracking`] beside it.
pub trait Counter {
    /// Whether events are.
    #[doc(hidden)]
    const COUNTS: bool = true;
    /// One primitive went this way.
    #[doc(hidden)]
    fn event(&mut self, event: Event);
    /// So many pixels were written.
    #[doc(hidden)]
    fn pixels(&mut self, pixels: u32);
    /// Columns `left..right` of row `y` are about to be drawn, unless they are hidden.
    #[doc(hidden)]
    #[inline(always)]
    fn row(&mut self, _y: i32, _left: i32, _right: i32) {}
}

/// Counts nothing, and is nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Uncounted;

impl Counter for Uncounted {
    const COUNTS: bool = false;

    #[inline(always)]
    fn event(&mut self, _event: Event) {}
    #[inline(always)]
    fn pixels(&mut self, _pixels: u32) {}
}

/// Counts into the caller's [`Stats`].
#[derive(Debug)]
pub struct Counting<'a>(pub &'a mut Stats);

impl Counter for Counting<'_> {
    #[inline]
    fn event(&mut self, event: Event) {
        let count = match event {
            Event::Triangle => &mut self.0.triangles,
            Event::Line => &mut self.0.lines,
            Event::Point => &mut self.0.points,
            Event::Culled => &mut self.0.culled,
            Event::Degenerate => &mut self.0.degenerate,
            Event::Outside => &mut self.0.outside,
            Event::Skipped => &mut self.0.skipped,
            Event::Drawn => &mut self.0.drawn,
            Event::Clipped => &mut self.0.clipped,
        };
        *count = count.saturating_add(1);
    }

    #[inline]
    fn pixels(&mut self, pixels: u32) {
        self.0.pixels = self.0.pixels.saturating_add(pixels);
    }
}

/// Adds what is drawn to the caller's [`Damage`], and counts as `C` does.
#[derive(Debug)]
pub struct Tracking<'a, C>(pub &'a mut Damage, pub C);

impl<C: Counter> Counter for Tracking<'_, C> {
    const COUNTS: bool = C::COUNTS;

    #[inline(always)]
    fn event(&mut self, event: Event) {
        self.1.event(event);
    }

    #[inline(always)]
    fn pixels(&mut self, pixels: u32) {
        self.1.pixels(pixels);
    }

    #[inline(always)]
    fn row(&mut self, y: i32, left: i32, right: i32) {
        self.0.add_row(y, left, right);
        self.1.row(y, left, right);
    }
}
