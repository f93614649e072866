use super::ListError;
use crate::frame::{Rect, Size, MAX_SIDE};
use crate::raster::{area_of_sides, first_center, ScreenVertex, Triangle, GUARD, SUBPIXELS};

/// No triangle: the end of a list.
const NONE: u16 = u16::MAX;

/// Coordinates have 24 bits: any corner of any viewport.
const _: () = assert!(
    (super::pass::FARTHEST as i64 + MAX_SIDE as i64 + GUARD as i64) * (SUBPIXELS as i64) < 1 << 23,
    "coordinates of a recorded corner"
);

/// A vertex in a [`DisplayList`]: 8 bytes of place on the screen, and what a shader gave it.
#[derive(Clone, Copy, Debug, Default)]
pub struct ListVertex<C> {
    /// 24 bits of x above the upper 8 of y.
    x_and_y: u32,
    /// The lower 16 bits of y above z.
    y_and_z: u32,
    corner: C,
}

impl<C> ListVertex<C> {
    /// A vertex to fill a `static` with: `blank` is any value.
    pub const fn with_blank(blank: C) -> Self {
        Self { x_and_y: 0, y_and_z: 0, corner: blank }
    }

    #[inline(always)]
    #[allow(clippy::cast_sign_loss, reason = "bits are taken apart")]
    fn new(vertex: &ScreenVertex, corner: C) -> Self {
        let (x, y) = (vertex.x_bits() as u32, vertex.y_bits() as u32);
        Self { x_and_y: x << 8 | (y >> 16 & 0xFF), y_and_z: y << 16 | u32::from(vertex.z), corner }
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_wrap, reason = "bits are put together, and the sign is theirs")]
    const fn y_bits(&self) -> i32 {
        (self.x_and_y << 24) as i32 >> 8 | (self.y_and_z >> 16) as i32
    }

    #[inline(always)]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        reason = "bits are put together, and the sign is theirs"
    )]
    fn vertex(&self) -> ScreenVertex {
        ScreenVertex::from_bits(self.x_and_y as i32 >> 8, self.y_bits(), self.y_and_z as u16)
    }
}

/// A triangle in a [`DisplayList`]: 8 bytes.
#[derive(Clone, Copy, Debug, Default)]
pub struct ListTriangle {
    /// Numbers of its vertices, clockwise on the screen, the provoking one first. The piece of a
    /// clipped triangle has the same number thrice: its corners are that vertex and the next two,
    /// and the one behind them says what provokes.
    vertices: [u16; 3],
    /// The next one of the same list; the first row that it touches until it is in one.
    next: u16,
}

impl ListTriangle {
    /// A triangle to fill a `static` with.
    pub const BLANK: Self = Self { vertices: [0; 3], next: 0 };
}

/// Memory of the caller's for the triangles that a mesh puts on the screen, recorded once a picture
/// by [`Pass::record`](super::Pass::record) and drawn from in each band.
///
/// The memory is arrays, or whatever else lends slices: a `heapless::Vec` of its full length.
///
/// ```
/// use heapless::Vec;
/// use microraster::{Color, DisplayList, ListTriangle, ListVertex};
///
/// let mut vertices = Vec::<ListVertex<Color>, 600>::new();
/// let mut triangles = Vec::<ListTriangle, 600>::new();
/// vertices.resize_default(600)?;
/// triangles.resize_default(600)?;
/// // One number for each band.
/// let mut bands = [0; 16];
/// let list = DisplayList::new(&mut vertices, &mut triangles, &mut bands);
/// assert_eq!(list.triangles(), 0);
/// # Ok::<(), heapless::CapacityError>(())
/// ```
///
/// # Range
/// At most 65535 vertices and as many triangles; what is longer is not used.
#[derive(Debug)]
pub struct DisplayList<'a, C> {
    vertices: &'a mut [ListVertex<C>],
    triangles: &'a mut [ListTriangle],
    /// For each band the first of the triangles whose first row is in it.
    bands: &'a mut [u16],
    /// What was recorded, and what would have been.
    vertex_count: u32,
    triangle_count: u32,
    picture: Size,
    /// Whether no triangle reaches beyond the area that was recorded for.
    are_inside: bool,
    /// Rows of a band; none before triangles are linked.
    rows: i32,
    /// The band that comes next, and its first row.
    number: usize,
    next_row: i32,
    /// Triangles of earlier bands that reach into the next one.
    carried: Chain,
}

/// Triangles in the order in which they were recorded: the first and the last.
#[derive(Clone, Copy, Debug)]
struct Chain {
    first: u16,
    last: u16,
}

impl Chain {
    const EMPTY: Self = Self { first: NONE, last: NONE };

    #[inline(always)]
    fn push(&mut self, number: u16, triangles: &mut [ListTriangle]) {
        if let Some(triangle) = triangles.get_mut(usize::from(number)) {
            triangle.next = NONE;
        }
        match triangles.get_mut(usize::from(self.last)) {
            Some(last) => last.next = number,
            None => self.first = number,
        }
        self.last = number;
    }

    /// Puts a triangle before all that are there.
    fn push_first(&mut self, number: u16, triangles: &mut [ListTriangle]) {
        if let Some(triangle) = triangles.get_mut(usize::from(number)) {
            triangle.next = core::mem::replace(&mut self.first, number);
        }
        if self.last == NONE {
            self.last = number;
        }
    }
}

/// As many as numbers of 16 bits tell apart.
fn numbered<T>(slice: &mut [T]) -> &mut [T] {
    let length = slice.len().min(NONE.into());
    slice.get_mut(..length).unwrap_or_default()
}

/// Counts what finds no room, so that it can be said how much would.
#[cold]
#[inline(never)]
fn one_too_many(count: &mut u32) {
    *count = count.saturating_add(1);
}

/// Takes what lies behind so many places.
fn rest<'a, T>(slice: &mut &'a mut [T], used: u32) -> &'a mut [T] {
    let all = core::mem::take(slice);
    let used = (used as usize).min(all.len());
    let (kept, rest) = all.split_at_mut_checked(used).unwrap_or_default();
    *slice = kept;
    rest
}

/// A recorded triangle, ready to be drawn.
#[derive(Clone, Copy)]
pub(super) struct Recorded<C> {
    pub(super) triangle: Triangle,
    pub(super) corners: [C; 3],
    pub(super) provoking: C,
}

/// The rows that a triangle's pixels lie in: from the first up to the one behind the last.
#[inline(always)]
fn rows_of([a, b, c]: [i32; 3]) -> (i32, i32) {
    (first_center(a.min(b).min(c)), first_center(a.max(b).max(c)))
}

/// The first row of the area in which the box of a triangle may hold the centre of a pixel; `None` if
/// it holds none of the area's.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "of a picture")]
pub(super) fn first_row(triangle: &Triangle, area: &Rect) -> Option<u16> {
    if triangle.is_inside {
        // A box between the same two centres holds none.
        let x = triangle.v.map(|vertex| first_center(vertex.x_bits()));
        let y = triangle.v.map(|vertex| first_center(vertex.y_bits()));
        let differ = |[a, b, c]: [i32; 3]| (a ^ b) | (a ^ c) != 0;
        let [a, b, c] = y;
        return (differ(x) && differ(y)).then_some(a.min(b).min(c) as u16);
    }
    let (top, bottom) = rows_of(triangle.v.map(|vertex| vertex.y_bits()));
    let (left, right) = rows_of(triangle.v.map(|vertex| vertex.x_bits()));
    let first = top.max(area.top);
    let reaches = first < bottom.min(area.bottom) && left.max(area.left) < right.min(area.right);
    reaches.then_some(first as u16)
}

impl<'a, C: Copy> DisplayList<'a, C> {
    /// An empty list. `bands` has one number for each band of the picture; what the slices hold is
    /// overwritten.
    pub fn new(
        vertices: &'a mut [ListVertex<C>],
        triangles: &'a mut [ListTriangle],
        bands: &'a mut [u16],
    ) -> Self {
        Self {
            vertices: numbered(vertices),
            triangles: numbered(triangles),
            bands,
            vertex_count: 0,
            triangle_count: 0,
            picture: Size::new(0, 0),
            are_inside: false,
            rows: 0,
            number: 0,
            next_row: 0,
            carried: Chain::EMPTY,
        }
    }

    /// Vertices that were recorded, or would have been where there was no room.
    pub fn vertices(&self) -> u32 {
        self.vertex_count
    }

    /// Triangles that were recorded, or would have been.
    pub fn triangles(&self) -> u32 {
        self.triangle_count
    }

    /// Parts with the memory that was not used, and makes a list of it.
    pub(super) fn take_rest(&mut self, bands: &'a mut [u16]) -> Self {
        let vertices = rest(&mut self.vertices, self.vertex_count);
        let triangles = rest(&mut self.triangles, self.triangle_count);
        Self::new(vertices, triangles, bands)
    }

    /// The rectangle in which all triangles lie.
    pub(super) fn bounds(&self) -> Rect {
        let count = self.vertex_count as usize;
        let (mut low, mut high) = ((i32::MAX, i32::MAX), (i32::MIN, i32::MIN));
        for vertex in self.vertices.iter().take(count).map(ListVertex::vertex) {
            let (x, y) = (vertex.x_bits(), vertex.y_bits());
            low = (low.0.min(x), low.1.min(y));
            high = (high.0.max(x), high.1.max(y));
        }
        if count == 0 {
            return Rect::default();
        }
        let [left, top, right, bottom] = [low.0, low.1, high.0, high.1].map(first_center);
        Rect { left, top, right, bottom }
    }

    /// Forgets everything, for a picture of this size.
    pub(super) fn start(&mut self, picture: Size) {
        (self.vertex_count, self.triangle_count) = (0, 0);
        (self.picture, self.rows, self.are_inside) = (picture, 0, false);
    }

    /// Notes whether no triangle reaches beyond the area that was recorded for.
    pub(super) fn end(&mut self, are_inside: bool) {
        self.are_inside = are_inside;
    }

    /// Whether no triangle reaches beyond that.
    pub(super) fn are_inside(&self) -> bool {
        self.are_inside
    }

    /// Whether all that was recorded found room.
    pub(super) fn check_room(&self) -> Result<(), ListError> {
        let (vertices, triangles) = (self.vertex_count, self.triangle_count);
        let fits = |count: u32, room: usize| count as usize <= room;
        if fits(vertices, self.vertices.len()) && fits(triangles, self.triangles.len()) {
            Ok(())
        } else {
            Err(ListError::Full { vertices, triangles })
        }
    }

    /// Takes a vertex, and gives its number; counts it where there is no room.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "no more fit than have a number")]
    pub(super) fn push_vertex(&mut self, vertex: &ScreenVertex, corner: C) -> u16 {
        let number = self.vertex_count;
        match self.vertices.get_mut(number as usize) {
            Some(place) => {
                *place = ListVertex::new(vertex, corner);
                self.vertex_count = number.wrapping_add(1);
            }
            None => one_too_many(&mut self.vertex_count),
        }
        number as u16
    }

    /// Takes a triangle.
    #[inline(always)]
    pub(super) fn push(&mut self, vertices: [u16; 3], first_row: u16) {
        let number = self.triangle_count;
        match self.triangles.get_mut(number as usize) {
            Some(place) => {
                *place = ListTriangle { vertices, next: first_row };
                self.triangle_count = number.wrapping_add(1);
            }
            None => one_too_many(&mut self.triangle_count),
        }
    }

    /// Takes the piece of a clipped triangle.
    pub(super) fn push_piece(
        &mut self,
        triangle: &Triangle,
        corners: &[C; 3],
        provoking: C,
        first_row: u16,
    ) {
        let [a, b, c] = &triangle.v;
        let [p, q, r] = *corners;
        let first = self.push_vertex(a, p);
        for (vertex, corner) in [(b, q), (c, r), (a, provoking)] {
            self.push_vertex(vertex, corner);
        }
        self.push([first; 3], first_row);
    }

    /// The numbers of a triangle's vertices, the provoking one last.
    #[inline(always)]
    fn numbers(triangle: &ListTriangle) -> [u16; 4] {
        let [a, b, c] = triangle.vertices;
        if a == b {
            [a, a.wrapping_add(1), a.wrapping_add(2), a.wrapping_add(3)]
        } else {
            [a, b, c, a]
        }
    }

    #[inline(always)]
    fn vertex(&self, number: u16) -> Option<&ListVertex<C>> {
        self.vertices.get(usize::from(number))
    }

    /// A triangle and the row behind its last; the provoking corner only if it `provokes` anything.
    #[inline(always)]
    pub(super) fn recorded(&self, number: u16, provokes: bool) -> Option<(Recorded<C>, i32)> {
        let triangle = self.triangles.get(usize::from(number))?;
        let [a, b, c, first] = Self::numbers(triangle);
        let (a, b, c) = (self.vertex(a)?, self.vertex(b)?, self.vertex(c)?);
        let v = [a.vertex(), b.vertex(), c.vertex()];
        let side = |to: i32, from: i32| to.wrapping_sub(from);
        let [(ax, ay), (bx, by), (cx, cy)] = v.map(|vertex| (vertex.x_bits(), vertex.y_bits()));
        let area = area_of_sides(side(bx, ax), side(by, ay), side(cx, ax), side(cy, ay));
        let recorded = Recorded {
            triangle: Triangle::of(v, area, false),
            corners: [a.corner, b.corner, c.corner],
            provoking: if provokes { self.vertex(first)?.corner } else { a.corner },
        };
        Some((recorded, rows_of([ay, by, cy]).1))
    }

    /// Where the corners of a triangle lie, from the top.
    #[inline(always)]
    fn y_of(&self, number: u16) -> Option<[i32; 3]> {
        let [a, b, c, _] = Self::numbers(self.triangles.get(usize::from(number))?);
        let y = |number| Some(self.vertex(number)?.y_bits());
        Some([y(a)?, y(b)?, y(c)?])
    }

    /// The rows of a triangle.
    #[inline(never)]
    fn rows_of(&self, number: u16) -> Option<(i32, i32)> {
        self.y_of(number).map(rows_of)
    }

    /// Whether this was recorded for a picture of this size.
    pub(super) fn check(&self, picture: Size) -> Result<(), ListError> {
        if picture == self.picture {
            Ok(())
        } else {
            Err(ListError::Picture { needed: self.picture, got: picture })
        }
    }

    /// The triangles that reach into the rows `top..bottom`, in the order in which they were
    /// recorded.
    pub(super) fn numbers_within(&self, top: i32, bottom: i32) -> impl Iterator<Item = u16> + '_ {
        let count = u16::try_from(self.triangle_count).unwrap_or(NONE);
        (0..count).filter(move |number| {
            self.rows_of(*number).is_some_and(|(first, behind)| first < bottom && behind > top)
        })
    }

    /// Makes ready for the band of these rows of a picture, and gives its triangles.
    pub(super) fn band(
        &mut self,
        picture: Size,
        first_row: u16,
        rows: u16,
    ) -> Result<BandTriangles, ListError> {
        self.check(picture)?;
        let (top, height) = (i32::from(first_row), i32::from(rows));
        let ends = top.wrapping_add(height) == i32::from(picture.height);
        let goes_on = top == self.next_row && (height == self.rows || ends && height < self.rows);
        if !goes_on {
            // What goes on was asked when it began.
            self.check_room()?;
            let needed = picture.height.saturating_sub(first_row).div_ceil(rows.max(1));
            let got = self.bands.len();
            if got < usize::from(needed) {
                let got = u32::try_from(got).unwrap_or(u32::MAX);
                return Err(ListError::Bands { needed: needed.into(), got });
            }
            self.link(top, rows.max(1));
        }
        let first = self.bands.get(self.number).copied().unwrap_or(NONE);
        self.number = self.number.wrapping_add(1);
        let carried = core::mem::replace(&mut self.carried, Chain::EMPTY).first;
        self.next_row = top.wrapping_add(height);
        Ok(BandTriangles { carried, first })
    }

    /// Puts each triangle into the list of the first band that it touches, from `first_row` on: from the
    /// last one to the first, so that each is put before those that are there.
    #[inline(never)]
    fn link(&mut self, first_row: i32, rows: u16) {
        // Until they are in a list, triangles say themselves where they begin.
        let are_known = self.rows == 0;
        (self.number, self.rows, self.carried) = (0, rows.into(), Chain::EMPTY);
        self.bands.fill(NONE);
        // So that the target needs no division a triangle: the quotient or one less.
        let rows = u32::from(rows);
        let reciprocal = 0x1_0000_u32.checked_div(rows).unwrap_or(0);
        let count = u16::try_from(self.triangle_count).unwrap_or(NONE);
        for number in (0..count).rev() {
            let top = if are_known {
                self.triangles.get(usize::from(number)).map(|triangle| i32::from(triangle.next))
            } else {
                self.rows_of(number).map(|(top, _)| top)
            };
            let Some(top) = top else { return };
            if top < first_row {
                // The last row is asked for here alone: few triangles begin further up.
                if self.rows_of(number).is_some_and(|(_, bottom)| bottom > first_row) {
                    self.carried.push_first(number, self.triangles);
                }
                continue;
            }
            let below = top.wrapping_sub(first_row).cast_unsigned();
            let mut band = below.wrapping_mul(reciprocal) >> 16;
            if below.wrapping_sub(band.wrapping_mul(rows)) >= rows {
                band = band.wrapping_add(1);
            }
            let Some(first) = self.bands.get_mut(band as usize) else { continue };
            if let Some(triangle) = self.triangles.get_mut(usize::from(number)) {
                triangle.next = core::mem::replace(first, number);
            }
        }
    }

    /// The next triangle of a band, in the order in which they were recorded, and whether it begins there.
    #[inline(always)]
    pub(super) fn next(&self, band: &mut BandTriangles) -> Option<(u16, bool)> {
        let number = band.carried.min(band.first);
        let next = self.triangles.get(usize::from(number))?.next;
        let begins = number != band.carried;
        if begins {
            band.first = next;
        } else {
            band.carried = next;
        }
        Some((number, begins))
    }

    /// Keeps a triangle that reaches beyond the band for the next one.
    #[inline(always)]
    pub(super) fn carry(&mut self, number: u16) {
        self.carried.push(number, self.triangles);
    }
}

/// What is still to be drawn of a band: triangles of earlier bands, and those that begin in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct BandTriangles {
    carried: u16,
    first: u16,
}
