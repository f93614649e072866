/// What became of the triangles and pixels of the draws that counted here.
///
/// `triangles = culled + degenerate + outside + skipped + drawn`, whatever was drawn.
#[non_exhaustive]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    /// Triangles that came in.
    pub triangles: u32,
    /// Triangles that face the culled side.
    pub culled: u32,
    /// Triangles of zero area on the screen.
    pub degenerate: u32,
    /// Triangles beside the view, the scissor or the band, and those too small to hold a pixel
    /// centre between their sides.
    pub outside: u32,
    /// Triangles that cannot be drawn: an index out of range, a matrix that is not finite, a
    /// corner that is no number.
    pub skipped: u32,
    /// Triangles that went on to the rasterizer.
    pub drawn: u32,
    /// Triangles that were cut at the near or far plane or at the guard box, drawn or not.
    pub clipped: u32,
    /// Pixels written, each time they were.
    pub pixels: u32,
}

/// One thing that can become of a triangle.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    Triangle,
    Culled,
    Degenerate,
    Outside,
    Skipped,
    Drawn,
    Clipped,
}

/// Whether a pass counts: [`Uncounted`] or [`Counting`].
pub trait Counter {
    /// One triangle went this way.
    #[doc(hidden)]
    fn event(&mut self, event: Event);
    /// So many pixels were written.
    #[doc(hidden)]
    fn pixels(&mut self, pixels: u32);
}

/// Counts nothing, and is nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Uncounted;

impl Counter for Uncounted {
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
