use super::mapping::{near_slack, Mapping};
use super::transform::Depth;
use super::Clip;
use crate::math::{reciprocal, Reciprocal};
use crate::raster::{twice_area, ScreenVertex, GUARD};

/// A clipped triangle has at most its three corners and one more for each of seven planes.
const MAX_CORNERS: usize = 3 + 7;

/// How far from the viewport's centre triangles are cut, in pixels: a little inside of the guard
/// box, so that rounding does not leave it.
const CUT: i64 = GUARD as i64 - 2;

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
    fn distance(self, clip: &Clip, mapping: &Mapping, depth: &Depth) -> i64 {
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
#[allow(
    clippy::cast_possible_truncation,
    reason = "shifted into range, or a point between two others"
)]
fn between(a: i32, b: i32, t: i64) -> i32 {
    let difference = i64::from(b).wrapping_sub(a.into());
    a.wrapping_add((difference.wrapping_mul(t).wrapping_add(1 << 29) >> 30) as i32)
}

impl Polygon {
    /// Cuts a triangle at all planes that limit the view, except the sides of the viewport: those
    /// are the scissor's.
    #[inline(never)]
    pub(super) fn clip(&mut self, triangle: &[Clip; 3], mapping: &Mapping, depth: &Depth) {
        const ONE: i32 = 1 << 30;
        let weights = [(0, 0), (ONE, 0), (0, ONE)];
        self.length = 0;
        for (clip, (u, v)) in triangle.iter().zip(weights) {
            self.push(PolygonCorner { clip: *clip, u, v });
        }
        for plane in ClipPlane::ALL {
            // Seven planes, one copy: this is about flash.
            let plane = core::hint::black_box(plane);
            let distance = |corner: &PolygonCorner| plane.distance(&corner.clip, mapping, depth);
            let whole = *self;
            let outside = whole.corners().iter().any(|corner| distance(corner) < 0);
            if !outside {
                continue;
            }
            self.length = 0;
            let Some(mut last) = whole.corners().last() else { return };
            for corner in whole.corners() {
                let (before, after) = (distance(last), distance(corner));
                if (before < 0) != (after < 0) {
                    let cut = if before < 0 {
                        Self::cut(corner, after, last, before)
                    } else {
                        Self::cut(last, before, corner, after)
                    };
                    self.push(cut);
                    if let (ClipPlane::Near, Depth::Near { w_min, .. }) = (plane, depth) {
                        // By definition, and free of the ratio's rounding.
                        if let Some(cut) = self.length.checked_sub(1) {
                            if let Some(cut) = self.corners.get_mut(cut) {
                                cut.clip.w = *w_min;
                            }
                        }
                    }
                }
                if after >= 0 {
                    self.push(*corner);
                }
                last = corner;
            }
        }
    }

    /// The point where an edge leaves: `inside` has a distance of zero or more, `outside` less.
    #[inline(never)]
    fn cut(
        inside: &PolygonCorner,
        near: i64,
        outside: &PolygonCorner,
        beyond: i64,
    ) -> PolygonCorner {
        let t = ratio(near, near.wrapping_sub(beyond));
        let (a, b) = (&inside.clip, &outside.clip);
        PolygonCorner {
            clip: Clip {
                x: between(a.x, b.x, t),
                y: between(a.y, b.y, t),
                z: between(a.z, b.z, t),
                w: between(a.w, b.w, t),
            },
            u: between(inside.u, outside.u, t),
            v: between(inside.v, outside.v, t),
        }
    }

    fn push(&mut self, corner: PolygonCorner) {
        if let Some(place) = self.corners.get_mut(self.length) {
            *place = corner;
            self.length = self.length.wrapping_add(1);
        }
    }

    fn corners(&self) -> &[PolygonCorner] {
        self.corners.get(..self.length).unwrap_or(&[])
    }

    /// The polygon on the screen as triangles about one corner.
    #[inline(never)]
    pub(super) fn fan(&self, mapping: &Mapping) -> Fan {
        let mut fan = Fan::default();
        for corner in self.corners() {
            if let (Some(point), Some(weight)) =
                (fan.points.get_mut(fan.length), fan.weights.get_mut(fan.length))
            {
                *point = mapping.corner(&corner.clip);
                *weight = (corner.u, corner.v);
                fan.length = fan.length.wrapping_add(1);
            }
        }
        fan.choose_apex();
        fan
    }
}

/// Three corners on the screen, and their weights.
type FanTriangle = ([ScreenVertex; 3], [(i32, i32); 3]);

/// A polygon on the screen, cut into triangles about its apex.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Fan {
    points: [ScreenVertex; MAX_CORNERS],
    weights: [(i32, i32); MAX_CORNERS],
    length: usize,
    apex: usize,
    /// Twice the polygon's area, signed.
    pub(super) area: i64,
}

impl Fan {
    /// How many triangles there are.
    pub(super) fn triangles(&self) -> usize {
        self.length.saturating_sub(2)
    }

    /// Triangle `i`: its corners in the polygon's order, and their weights.
    pub(super) fn triangle(&self, i: usize) -> Option<FanTriangle> {
        self.about(self.apex, i)
    }

    #[inline(never)]
    fn about(&self, apex: usize, i: usize) -> Option<FanTriangle> {
        let corner = |step: usize| {
            let at = apex.wrapping_add(step);
            let at = if at >= self.length { at.wrapping_sub(self.length) } else { at };
            Some((*self.points.get(at)?, *self.weights.get(at)?))
        };
        let [a, b, c] = [corner(0)?, corner(i.wrapping_add(1))?, corner(i.wrapping_add(2))?];
        Some(([a.0, b.0, c.0], [a.1, b.1, c.1]))
    }

    /// Rounding to the subpixel grid may make a convex polygon a little concave. About some corner
    /// its triangles still all turn the same way, and then they cover each pixel once.
    fn choose_apex(&mut self) {
        self.area = self.areas(0).0;
        self.apex = (0..self.length).find(|&apex| self.areas(apex).1).unwrap_or(0);
    }

    /// The sum of the triangles' areas about a corner, and whether all turn the same way.
    #[inline(never)]
    fn areas(&self, apex: usize) -> (i64, bool) {
        let (mut sum, mut same) = (0_i64, true);
        for i in 0..self.triangles() {
            let area = self.about(apex, i).map_or(0, |(v, _)| twice_area(&v));
            same &= area == 0 || sum == 0 || (area < 0) == (sum < 0);
            sum = sum.wrapping_add(area);
        }
        (sum, same)
    }
}
