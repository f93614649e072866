use super::mapping::{near_slack, Mapping};
use super::transform::Depth;
use super::Clip;
use crate::frame::MAX_SIDE;
use crate::math::{reciprocal, Reciprocal};
use crate::raster::{twice_area, ScreenVertex, Triangle, GUARD};

/// A clipped triangle has at most its three corners and one more for each of seven planes.
const MAX_CORNERS: usize = 3 + 7;

/// How far from the viewport's centre triangles are cut, in pixels: at the guard box, into which
/// [`Mapping::corner`] brings what rounding puts beside it.
const CUT: i64 = GUARD as i64;

const _: () = assert!(CUT >= MAX_SIDE as i64 / 2, "the longest viewport lies within");

/// A corner of the polygon: where it is, and how much of the triangle's second and third corner is
/// in it, in units of 2^-30.
#[derive(Clone, Copy, Debug, Default)]
struct PolygonCorner {
    clip: Clip,
    u: i32,
    v: i32,
}

/// A triangle cut at the near and far planes and at the guard box.
///
/// Source: I. Sutherland and G. Hodgman, *Reentrant Polygon Clipping*, CACM 17 (1974). Edges are
/// always cut from the inside to the outside, so that two triangles that share an edge get the
/// same point.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Polygon {
    corners: [PolygonCorner; MAX_CORNERS],
    length: usize,
}

/// A plane: signed distance, positive inside.
#[derive(Clone, Copy, Debug)]
enum ClipPlane {
    Near,
    Far,
    Eye,
    Left,
    Right,
    Below,
    Above,
}

impl ClipPlane {
    const ALL: [Self; 7] =
        [Self::Near, Self::Eye, Self::Far, Self::Left, Self::Right, Self::Below, Self::Above];

    #[inline(never)]
    fn distance(self, clip: &Clip, mapping: &Mapping) -> i64 {
        let depth = &mapping.depth;
        let (x, y) = (i64::from(clip.x), i64::from(clip.y));
        let (z, w) = (i64::from(clip.z), i64::from(clip.w));
        // Half a side of the cut box over half a side of the viewport, times w, against x.
        let reach = w.wrapping_mul(2 * CUT);
        let (wide, high) = (i64::from(mapping.width), i64::from(mapping.height));
        match (self, depth) {
            (Self::Near, Depth::Near { w_min, .. }) => w.wrapping_sub(i64::from(*w_min)),
            (Self::Near, Depth::Row { .. }) => {
                w.wrapping_add(near_slack(clip.w.max(0)).into()).wrapping_sub(z)
            }
            (Self::Eye, Depth::Row { .. }) => w.wrapping_sub(1),
            (Self::Far, Depth::Row { far: true }) => z,
            (Self::Eye | Self::Far, _) => 0,
            (Self::Left, _) => reach.wrapping_add(x.wrapping_mul(wide)),
            (Self::Right, _) => reach.wrapping_sub(x.wrapping_mul(wide)),
            (Self::Below, _) => reach.wrapping_add(y.wrapping_mul(high)),
            (Self::Above, _) => reach.wrapping_sub(y.wrapping_mul(high)),
        }
    }
}

/// a / b in units of 2^-30 for 0 <= a <= b, b above zero.
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "shifted into range, or a point between two others"
)]
fn ratio(a: i64, b: i64) -> i64 {
    let (a, b) = (a as u64, b as u64);
    let excess = 32_u32.saturating_sub(b.leading_zeros());
    let Reciprocal { mantissa, shift } = reciprocal((b >> excess) as u32);
    let product = (a >> excess).wrapping_mul(mantissa.into());
    let down = shift.wrapping_sub(30) & 63;
    ((product.wrapping_add(1 << (down.wrapping_sub(1) & 63)) >> down) as i64).clamp(0, 1 << 30)
}

/// The point that divides a..b as t, in units of 2^-30; rounded to nearest.
#[inline(never)]
#[allow(
    clippy::cast_possible_truncation,
    reason = "shifted into range, or a point between two others"
)]
fn between(a: i32, b: i32, t: i64) -> i32 {
    let difference = i64::from(b).wrapping_sub(a.into());
    a.wrapping_add((difference.wrapping_mul(t).wrapping_add(1 << 29) >> 30) as i32)
}

impl Polygon {
    /// A triangle, cut at all planes that limit the view except the sides of the viewport: those
    /// are the scissor's.
    #[inline(never)]
    pub(super) fn of(triangle: &[Clip; 3], mapping: &Mapping) -> Self {
        const ONE: i32 = 1 << 30;
        let weights = [(0, 0), (ONE, 0), (0, ONE)];
        let mut polygon = Self::default();
        for (clip, (u, v)) in triangle.iter().zip(weights) {
            polygon.push(&PolygonCorner { clip: *clip, u, v });
        }
        for plane in ClipPlane::ALL {
            // Seven planes, one copy: this is about flash.
            polygon.cut(core::hint::black_box(plane), mapping);
        }
        polygon
    }

    /// Takes off what lies outside of a plane.
    #[inline(never)]
    fn cut(&mut self, plane: ClipPlane, mapping: &Mapping) {
        let whole = *self;
        let Some(mut last) = whole.corners().last() else { return };
        let mut before = plane.distance(&last.clip, mapping);
        self.length = 0;
        for corner in whole.corners() {
            let after = plane.distance(&corner.clip, mapping);
            if (before < 0) != (after < 0) {
                // Always from the inside to the outside.
                let (inside, near, outside, beyond) = if before < 0 {
                    (corner, after, last, before)
                } else {
                    (last, before, corner, after)
                };
                let t = ratio(near, near.wrapping_sub(beyond));
                let mut cut = inside.toward(outside, t);
                if let (ClipPlane::Near, Depth::Near { w_min, .. }) = (plane, &mapping.depth) {
                    // By definition, and free of the ratio's rounding.
                    cut.clip.w = *w_min;
                }
                self.push(&cut);
            }
            if after >= 0 {
                self.push(corner);
            }
            (last, before) = (corner, after);
        }
    }

    #[inline(never)]
    fn push(&mut self, corner: &PolygonCorner) {
        if let Some(place) = self.corners.get_mut(self.length) {
            *place = *corner;
            self.length = self.length.wrapping_add(1);
        }
    }

    fn corners(&self) -> &[PolygonCorner] {
        self.corners.get(..self.length).unwrap_or(&[])
    }

    /// The polygon on the screen as triangles about one corner.
    #[inline(never)]
    pub(super) fn fan(&self, mapping: &Mapping, fan: &mut Fan) {
        fan.length = self.length;
        let places = fan.points.iter_mut().zip(&mut fan.weights);
        for (corner, (point, weight)) in self.corners().iter().zip(places) {
            *point = mapping.corner(&corner.clip);
            *weight = (corner.u, corner.v);
        }
        fan.choose_apex();
    }
}

impl PolygonCorner {
    /// The point that divides the way to another corner as t, in units of 2^-30.
    #[inline(never)]
    fn toward(&self, to: &Self, t: i64) -> Self {
        let (a, b) = (&self.clip, &to.clip);
        Self {
            clip: Clip {
                x: between(a.x, b.x, t),
                y: between(a.y, b.y, t),
                z: between(a.z, b.z, t),
                w: between(a.w, b.w, t),
            },
            u: between(self.u, to.u, t),
            v: between(self.v, to.v, t),
        }
    }
}

/// How much of a triangle's second and third corner is in a point, in units of 2^-30.
pub(super) type Weights = (i32, i32);

/// A polygon on the screen, cut into triangles about its apex.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fan {
    points: [ScreenVertex; MAX_CORNERS],
    weights: [Weights; MAX_CORNERS],
    length: usize,
    apex: usize,
    /// The piece that comes next.
    next: usize,
    /// Twice the polygon's area, signed.
    pub(super) area: i64,
}

impl Fan {
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
                triangle.flipped = area < 0;
                triangle.area = area.wrapping_abs();
                if triangle.flipped {
                    triangle.v.swap(1, 2);
                }
                return true;
            }
        }
        false
    }

    /// The latest piece's corners, and twice its area.
    #[inline(never)]
    fn piece_area(&self, corners: &mut [ScreenVertex; 3]) -> i64 {
        for (corner, at) in corners.iter_mut().zip(self.piece()) {
            *corner = self.points.get(at).copied().unwrap_or_default();
        }
        twice_area(corners)
    }

    /// The weights of the corners of the piece that [`next`](Self::next) gave, in the polygon's
    /// order.
    #[inline(never)]
    pub(super) fn weights(&self) -> [Weights; 3] {
        self.piece().map(|at| self.weights.get(at).copied().unwrap_or_default())
    }

    /// Where the corners of the latest piece are.
    fn piece(&self) -> [usize; 3] {
        [0, self.next, self.next.wrapping_add(1)].map(|step| {
            let at = self.apex.wrapping_add(step);
            if at >= self.length {
                at.wrapping_sub(self.length)
            } else {
                at
            }
        })
    }

    /// Rounding to the subpixel grid may make a convex polygon a little concave. About some corner
    /// its triangles still all turn the same way, and then they cover each pixel once.
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
    #[inline(never)]
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
