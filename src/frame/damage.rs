use super::{Rect, Size};

/// What changes on a display from one picture to the next, as one rectangle: what was drawn in the
/// one or in the other. The rest is background in both, and need not be sent.
///
/// ```
/// use microraster::{Damage, Rect, Size};
///
/// let mut damage = Damage::new(Size::new(64, 48));
/// damage.add(Rect::new(10, 10, 20, 20));
/// // What the display shows before the first picture is not known.
/// assert_eq!(damage.next_picture(), Rect::new(0, 0, 64, 48));
/// damage.add(Rect::new(12, 8, 22, 18));
/// // Where it was and where it is.
/// assert_eq!(damage.area(), Rect::new(10, 8, 22, 20));
/// assert_eq!(damage.next_picture(), Rect::new(10, 8, 22, 20));
/// // Nothing was drawn: what was there has to go.
/// assert_eq!(damage.next_picture(), Rect::new(12, 8, 22, 18));
/// assert!(damage.next_picture().is_empty());
/// ```
///
/// A [`Pass`](crate::Pass) that [tracks](crate::Pass::track_damage) it adds all that it draws. What
/// is drawn otherwise, and a background that changes, is the program's to [`add`](Self::add). A
/// picture that was not sent to its end is none yet: [`next_picture`](Self::next_picture) waits until
/// one was.
///
/// ```
/// use microraster::raster::ScreenVertex;
/// use microraster::{Bands, Color, Damage, Flat, Rgb, Rgb565, ScreenPass, Size};
///
/// let (mut pixels, mut sent) = ([0; 32 * 8], 0);
/// let mut bands = Bands::<Rgb565>::new(&mut pixels, Size::new(32, 24))?;
/// let mut damage = Damage::new(bands.picture());
/// for step in 0..10 {
///     let end = |x, y| (ScreenVertex::from_bits(16 * (x + step), 16 * y, 0), Color::new(9, 9, 9));
///     let triangle = [end(0, 4), end(6, 4), end(0, 14)];
///     for number in 0..bands.count() {
///         let band = bands.draw_band(number, |frame| {
///             frame.clear(Rgb::BLACK);
///             let mut pass = ScreenPass::new().track_damage(&mut damage);
///             pass.triangle(frame, &Flat::colored(), &triangle);
///         });
///         let Some(mut band) = band else { continue };
///         band.crop(damage.area());
///         sent += band.pixels().len();
///     }
///     damage.next_picture();
/// }
/// // Of ten pictures of 768 pixels: the first, and a window about the triangle.
/// assert!(sent < 768 + 9 * 100, "{sent}");
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// # Units
/// Pixels of the picture that frames are bands of. Where that is one of
/// [samples](crate::Supersampling), so is what a pass tracks: what a display has to be sent is its
/// sides over the factor, left and top rounded down, right and bottom up.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Damage {
    before: Rect,
    now: Rect,
}

/// Holds nothing, and takes the sides of whatever is added.
const NOTHING: Rect = Rect { left: i32::MAX, top: i32::MAX, right: i32::MIN, bottom: i32::MIN };

impl Damage {
    /// Before the first picture of this size: all of it is to be sent.
    pub const fn new(picture: Size) -> Self {
        Self { before: Rect::from_size(picture), now: NOTHING }
    }

    /// Adds what was drawn in this picture; an empty rectangle adds nothing. What lies beside the
    /// picture is not cut off: [`Band::crop`](crate::Band::crop) does that.
    #[inline]
    pub fn add(&mut self, area: Rect) {
        self.now = self.now.union(area);
    }

    /// Adds columns `left..right` of row `y`, at least one.
    #[inline(always)]
    pub(crate) fn add_row(&mut self, y: i32, left: i32, right: i32) {
        let Rect { left: leftmost, top, right: rightmost, bottom } = &mut self.now;
        *leftmost = left.min(*leftmost);
        *rightmost = right.max(*rightmost);
        *top = y.min(*top);
        *bottom = y.wrapping_add(1).max(*bottom);
    }

    /// What changes, as far as this picture was drawn. While it is drawn in bands, this holds all
    /// that changes of the bands so far, and more of them than of the whole picture.
    #[inline]
    pub fn area(&self) -> Rect {
        let area = self.before.union(self.now);
        if area.is_empty() {
            Rect::default()
        } else {
            area
        }
    }

    /// What changed, once a picture is complete; the next one begins.
    pub fn next_picture(&mut self) -> Rect {
        let area = self.area();
        self.before = core::mem::replace(&mut self.now, NOTHING);
        area
    }
}
