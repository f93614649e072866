use super::mapping::{near_slack, Mapping};
use super::Clip;
use crate::frame::MAX_SIDE;
use crate::math::{reciprocal_of_some, rolled, Reciprocal};
use crate::raster::{twice_area, ScreenVertex, Triangle, GUARD};
use crate::shade::{Corner as VaryingCorner, Varying};

/// A clipped triangle has at most its three corners and one more for each of seven planes.
const MAX_CORNERS: usize = 3 + 7;

/// Places in the ring of corners: room for a polygon, and for a second that is being made of it.
const RING: usize = 16;

/// How far from the viewport's centre triangles are cut, in pixels: at the guard box, into which
/// [`Mapping::corner`] brings what rounding puts beside it.
#[allow(clippy::cast_possible_truncation, reason = "4096")]
const CUT: i16 = GUARD as i16;

const _: () = assert!(CUT as u16 >= MAX_SIDE / 2, "the longest viewport lies within");

/// A corner of a polygon: where it is in clip space (x, y, z, w), and how much of the triangle's
/// second and third corner is in it (u, v), in units of 2^-30.
///
/// Numbers in a row: what is done to a corner is done to each of them. Two more make a power of two
/// of their number.
type Corner = [i32; 8];

/// How many of a corner's numbers are in use.
const NUMBERS: usize = 6;

/// Where a corner's numbers are.
const Z: u8 = 2;
const W: usize = 3;

/// How much of a triangle's second and third corner is in a point, in units of 2^-30.
pub(super) type Weights = (i32, i32);

/// A plane: signed distance, positive inside, as a linear form of one coordinate and w.
#[derive(Clone, Copy, Debug)]
struct ClipPlane {
    /// Which coordinate.
    axis: usize,
    factor: i32,
    w_factor: i32,
    offset: i32,
    /// Whether the rounding of the matrix is granted.
    slack: bool,
}

/// The plane of the near distance where depth comes from w, else of the eye: w at its least.
const LEAST_W: usize = 1;

/// What the planes are made of: an axis, the sign of its coordinate, and the factor of w. The near
/// plane of a matrix with a row for z, [`LEAST_W`], far, left, right, below, above.
///
/// For the last four the side of the cut box over that of the viewport, times w, is compared with
/// x or y: w is multiplied with the one, and the sign is that of the other.
static PLANES: [(u8, i8, i16); 7] = [
    (Z, -1, 1),
    (Z, 0, 1),
    (Z, 1, 0),
    (0, 1, 2 * CUT),
    (0, -1, 2 * CUT),
    (1, 1, 2 * CUT),
    (1, -1, 2 * CUT),
];

impl ClipPlane {
    fn new(number: usize, mapping: &Mapping) -> Self {
        let (axis, sign, w_factor) = PLANES.get(number).copied().unwrap_or_default();
        let scale = match axis {
            0 => mapping.size().width.into(),
            1 => mapping.size().height.into(),
            _ => 1,
        };
        let least = [0, mapping.depth.w_min, mapping.depth.z_min];
        let offset = least.get(number).copied().unwrap_or(0);
        Self {
            axis: axis.into(),
            factor: i32::wrapping_mul(scale, sign.into()),
            w_factor: w_factor.into(),
            offset,
            slack: number == 0,
        }
    }

    #[inline(never)]
    fn distance(&self, corner: &Corner) -> i64 {
        let product = |a: i32, b: i32| i64::from(a).wrapping_mul(b.into());
        let distance = product(corner[self.axis % 8], self.factor)
            .wrapping_add(product(corner[W], self.w_factor))
            .wrapping_sub(self.offset.into());
        if self.slack {
            distance.wrapping_add(near_slack(corner[W].max(0)).into())
        } else {
            distance
        }
    }
}

/// a / b in units of 2^-30 for 0 <= a <= b, b above zero.
#[allow(clippy::cast_possible_wrap, reason = "at most 2^30")]
fn ratio(a: i64, b: i64) -> i32 {
    // The 32 bits of both from the first of b.
    let room = b.leading_zeros();
    let high = |v: i64| (v.wrapping_shl(room) as u64 >> 32) as u32;
    let Reciprocal { mantissa, .. } = reciprocal_of_some(high(b));
    let product = u64::from(high(a)).wrapping_mul(mantissa.into());
    (product.wrapping_add(1 << 31) >> 32).min(1 << 30) as i32
}

/// The point that divides a..b as t, in units of 2^-30; rounded to nearest.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "a point between two others")]
fn between(a: i32, b: i32, t: i32) -> i32 {
    // Numbers are at most 2^30 in magnitude.
    let way = i64::from(b.wrapping_sub(a)).wrapping_mul(t.into());
    a.wrapping_add((way.wrapping_add(1 << 29) >> 30) as i32)
}

/// Twice the area of a triangle. One copy for all that is rare.
#[inline(never)]
pub(super) fn signed_area(corners: &[ScreenVertex; 3]) -> i64 {
    twice_area(corners)
}

/// A triangle cut at the near and far planes and at the guard box, then cut into triangles about
/// one corner of what is left of it, its apex.
///
/// Source: I. Sutherland and G. Hodgman, *Reentrant Polygon Clipping*, CACM 17 (1974). Edges are
/// always cut from the inside to the outside, so that two triangles that share an edge get the
/// same point.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fan {
    /// A ring: corners are taken off its one end while those of the next polygon come to the other.
    /// After [`project`](Self::project), x, y and z are those of the screen.
    corners: [Corner; RING],
    first: usize,
    length: usize,
    /// Which corner all pieces share.
    apex: usize,
    /// The piece that comes next.
    next: usize,
    /// Twice the polygon's area, signed.
    pub(super) area: i64,
}

impl Fan {
    /// Takes the triangle of these corners, cut at all planes that limit the view except the sides
    /// of the viewport: those are the scissor's. `None` if a corner is not there.
    #[inline(always)]
    pub(super) fn cut(
        &mut self,
        mapping: &Mapping,
        clip: impl Fn(u32) -> Option<Clip>,
        vertices: &[u32; 3],
    ) -> Option<()> {
        for at in rolled(3) {
            let Clip { x, y, z, w } = clip(*vertices.get(at)?)?;
            let at = at % RING;
            let all = |corner| i32::from(at == corner) << 30;
            self.corners[at] = [x, y, z, w, all(1), all(2), 0, 0];
        }
        self.cut_at_planes(mapping);
        Some(())
    }

    /// Cuts the triangle that the first three corners are.
    #[inline(never)]
    fn cut_at_planes(&mut self, mapping: &Mapping) {
        (self.first, self.length) = (0, 3);
        for number in rolled(PLANES.len()) {
            self.cut_at(number, mapping);
        }
        self.project(mapping);
        self.choose_apex();
    }

    /// Takes off what lies outside of a plane.
    #[inline(never)]
    fn cut_at(&mut self, number: usize, mapping: &Mapping) {
        let has_row = mapping.depth.is_row();
        if number == 0 && !has_row {
            return;
        }
        let plane = ClipPlane::new(number, mapping);
        let (first, end) = (self.first, self.first.wrapping_add(self.length));
        (self.first, self.length) = (end, 0);
        let mut last = end.wrapping_sub(1);
        let mut before = plane.distance(self.corner(last));
        for at in first..end {
            let after = plane.distance(self.corner(at));
            if (before < 0) != (after < 0) {
                // Always from the inside to the outside.
                let (inside, near, outside, beyond) =
                    if before < 0 { (at, after, last, before) } else { (last, before, at, after) };
                let cut = self.push(inside, outside, ratio(near, near.wrapping_sub(beyond)));
                if number == LEAST_W && !has_row {
                    // The near distance by definition, and free of the ratio's rounding.
                    cut[W] = plane.offset;
                }
            }
            if after >= 0 {
                self.push(at, at, 0);
            }
            (last, before) = (at, after);
        }
    }

    /// Appends the point that divides the way from one corner to another as t, in units of 2^-30.
    #[inline(never)]
    fn push(&mut self, from: usize, to: usize, t: i32) -> &mut Corner {
        let place = self.first.wrapping_add(self.length);
        // There are never more; if there were, the last would make place.
        self.length = self.length.wrapping_add(1).min(MAX_CORNERS);
        for at in rolled(NUMBERS) {
            let at = at % 8;
            let (a, b) = (self.corner(from)[at], self.corner(to)[at]);
            self.corners[place % RING][at] = between(a, b, t);
        }
        &mut self.corners[place % RING]
    }

    fn corner(&self, at: usize) -> &Corner {
        &self.corners[at % RING]
    }

    /// Puts the polygon on the screen.
    fn project(&mut self, mapping: &Mapping) {
        for step in 0..self.length {
            let corner = &mut self.corners[self.first.wrapping_add(step) % RING];
            let [x, y, z, w, ..] = *corner;
            let on_screen = mapping.corner(&Clip { x, y, z, w });
            [corner[0], corner[1], corner[2]] =
                [on_screen.x_bits(), on_screen.y_bits(), on_screen.z.into()];
        }
    }

    /// Whether there is no piece at all.
    pub(super) const fn is_empty(&self) -> bool {
        self.length < 3
    }

    /// The next piece that has an area.
    #[inline(never)]
    pub(super) fn next(&mut self, triangle: &mut Triangle) -> bool {
        while self.next.wrapping_add(2) < self.length {
            self.next = self.next.wrapping_add(1);
            let area = self.piece_area(&mut triangle.v);
            if area != 0 && (area < 0) == (self.area < 0) {
                triangle.turn(area);
                return true;
            }
        }
        false
    }

    /// The latest piece's corners, and twice its area.
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation, reason = "a depth code")]
    fn piece_area(&self, corners: &mut [ScreenVertex; 3]) -> i64 {
        *corners = self.piece().map(|[x, y, z, ..]| ScreenVertex::from_bits(*x, *y, *z as u16));
        signed_area(corners)
    }

    /// The weights of the corners of the piece that [`next`](Self::next) gave, in the polygon's
    /// order.
    #[inline(never)]
    pub(super) fn weights(&self) -> [Weights; 3] {
        self.piece().map(|[_, _, _, _, u, v, ..]| (*u, *v))
    }

    /// What a triangle's corners make of the corners of that piece, in its own order: for recording.
    /// A draw has it written out, which is 600 bytes shorter where corners are nothing but a colour.
    #[inline(always)]
    pub(super) fn mixed<V: Varying>(
        &self,
        [a, b, c]: &[VaryingCorner<V>; 3],
        flipped: bool,
    ) -> [VaryingCorner<V>; 3] {
        let mut corners = self.weights().map(|(u, v)| V::mix([a, b, c], u, v));
        if flipped {
            corners.swap(1, 2);
        }
        corners
    }

    /// The corners of the latest piece.
    fn piece(&self) -> [&Corner; 3] {
        [0, self.next, self.next.wrapping_add(1)].map(|step| {
            let at = self.apex.wrapping_add(step);
            let at = if at >= self.length { at.wrapping_sub(self.length) } else { at };
            self.corner(self.first.wrapping_add(at))
        })
    }

    /// Rounding to the subpixel grid may make a convex polygon a little concave. About some corner
    /// its triangles nearly always still all turn the same way, and then they cover each pixel once;
    /// where rounding bends both ends of a very thin one, some pixels are drawn twice.
    fn choose_apex(&mut self) {
        for apex in (0..self.length).rev() {
            self.apex = apex;
            if self.turns_one_way() {
                break;
            }
        }
        self.next = 0;
    }

    /// Whether the triangles about the apex all turn the same way; sums their areas.
    fn turns_one_way(&mut self) -> bool {
        let mut same = true;
        self.area = 0;
        self.next = 1;
        while self.next.wrapping_add(1) < self.length {
            let area = self.piece_area(&mut [ScreenVertex::default(); 3]);
            same &= area == 0 || self.area == 0 || (area < 0) == (self.area < 0);
            self.area = self.area.wrapping_add(area);
            self.next = self.next.wrapping_add(1);
        }
        same
    }
}

/// An end of a line on the screen, and how far from the line's first corner to its last it lies, in
/// units of 2^-30.
pub(super) type LineEnd = (ScreenVertex, i32);

/// A line cut at all planes that limit the view except the sides of the viewport, always from the
/// inside to the outside; `None` if nothing is left of it.
#[inline(never)]
pub(super) fn cut_line(mapping: &Mapping, ends: [Clip; 2]) -> Option<[LineEnd; 2]> {
    let [a, b] = ends;
    let mut ends: [Corner; 2] =
        [[a.x, a.y, a.z, a.w, 0, 0, 0, 0], [b.x, b.y, b.z, b.w, 1 << 30, 0, 0, 0]];
    let has_row = mapping.depth.is_row();
    for number in rolled(PLANES.len()) {
        if number == 0 && !has_row {
            continue;
        }
        let plane = ClipPlane::new(number, mapping);
        let [first, last] = ends.each_ref().map(|end| plane.distance(end));
        if first < 0 && last < 0 {
            return None;
        }
        if (first < 0) != (last < 0) {
            let (inside, outside, near, beyond) =
                if first < 0 { (1, 0, last, first) } else { (0, 1, first, last) };
            let t = ratio(near, near.wrapping_sub(beyond));
            for at in rolled(NUMBERS) {
                let at = at % 8;
                ends[outside][at] = between(ends[inside][at], ends[outside][at], t);
            }
            if number == LEAST_W && !has_row {
                ends[outside][W] = plane.offset;
            }
        }
    }
    Some(ends.map(|[x, y, z, w, along, ..]| (mapping.corner(&Clip { x, y, z, w }), along)))
}

#[cfg(test)]
#[path = "clipper_tests.rs"]
mod tests;
