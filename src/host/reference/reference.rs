use std::vec;
use std::vec::Vec;

use super::blend::blended;
use super::corner::Corner;
use super::fragment_tests::{in_range, test};
use super::line::Line;
use super::snap::{sample, PIXEL};
use super::triangle::Triangle;
use super::varyings::Varyings;
use super::{
    DepthPrecision, Draw, Fragment, Interpolation, Kind, Progress, Snap, Space, State, Vertex,
};
use crate::frame::{Rect, Size};
use crate::pipeline::{Cull, Winding};
use crate::shade::AnyDepth;

/// A picture in `f64`, and what is drawn into it.
///
/// Rows follow each other from the top, without gaps.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    size: Size,
    look: [f64; 2],
    snap: Snap,
    precision: DepthPrecision,
    colors: Vec<[f64; 3]>,
    depths: Vec<f64>,
    stencil: Vec<u8>,
    seen: Vec<Option<u32>>,
    counts: Vec<u32>,
    /// Primitives of all draws so far.
    primitives: u32,
}

/// What is the same for all pixels of a primitive.
#[derive(Clone, Copy)]
struct Primitive<'a> {
    draw: &'a Draw<'a>,
    vertices: &'a [Vertex],
    /// The number in the draw.
    number: u32,
    front: bool,
}

impl Reference {
    /// A picture of a background, 0 to 255 by channel, with the farthest depth and stencil 0.
    #[must_use]
    pub fn new(size: Size, background: [f64; 3]) -> Self {
        let pixels = usize::from(size.width) * usize::from(size.height);
        Self {
            size,
            look: [0.0; 2],
            snap: Snap::Exact,
            precision: DepthPrecision::Exact,
            colors: vec![background; pixels],
            depths: vec![0.0; pixels],
            stencil: vec![0; pixels],
            seen: vec![None; pixels],
            counts: vec![0; pixels],
            primitives: 0,
        }
    }

    /// Where pixels are looked at from now on: so many pixels beside their centres.
    #[must_use]
    pub fn look(mut self, offset: [f64; 2]) -> Self {
        self.look = offset;
        self
    }

    /// On what grid corners lie from now on.
    #[must_use]
    pub fn snap(mut self, snap: Snap) -> Self {
        self.snap = snap;
        self
    }

    /// How finely depths are told apart from now on.
    #[must_use]
    pub fn depth_precision(mut self, precision: DepthPrecision) -> Self {
        self.precision = precision;
        self
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> Size {
        self.size
    }

    /// Red, green and blue of each pixel, 0 to 255, not rounded.
    #[must_use]
    pub fn colors(&self) -> &[[f64; 3]] {
        &self.colors
    }

    /// The same, rounded to 8 bits; half a step goes up.
    #[must_use]
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "colours are 0 to 255"
    )]
    pub fn rounded_colors(&self) -> Vec<[u8; 3]> {
        self.colors.iter().map(|color| color.map(|channel| (channel + 0.5).floor() as u8)).collect()
    }

    /// The depth code of each pixel: 0 the farthest, 65535 the nearest.
    #[must_use]
    pub fn depths(&self) -> &[f64] {
        &self.depths
    }

    /// The stencil value of each pixel.
    #[must_use]
    pub fn stencil(&self) -> &[u8] {
        &self.stencil
    }

    /// The primitive that was drawn last in each pixel, by its number in all draws; `None` for the
    /// background.
    #[must_use]
    pub fn seen(&self) -> &[Option<u32>] {
        &self.seen
    }

    /// How many primitives cover each pixel: those that are not culled, before all tests but the
    /// scissor's.
    #[must_use]
    pub fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// Draws primitives in their order.
    pub fn draw(&mut self, draw: &Draw<'_>) {
        let each = match draw.kind {
            Kind::Triangles => 3,
            Kind::Lines { .. } => 2,
            Kind::Points { .. } => 1,
        };
        let mut steps = 0_u32;
        for (corners, number) in draw.corners.chunks_exact(each).zip(0..) {
            let vertex = |corner: &u32| {
                let vertex = draw.vertices.get(*corner as usize)?;
                vertex.position.iter().all(|number| number.is_finite()).then(|| vertex.clone())
            };
            if let Some(vertices) = corners.iter().map(vertex).collect::<Option<Vec<_>>>() {
                let primitive = Primitive { draw, vertices: &vertices, number, front: true };
                let corners = draw.space.corners(&vertices, self.snap);
                match draw.kind {
                    Kind::Triangles => self.triangle(primitive, &corners),
                    Kind::Lines { width, progress } => {
                        if let [a, b] = corners.as_slice() {
                            let more = self.line(primitive, [a, b], width, progress, steps);
                            steps = steps.wrapping_add(more);
                        }
                    }
                    Kind::Points { side } => {
                        if let [corner] = corners.as_slice() {
                            self.point(primitive, corner, side);
                        }
                    }
                }
            }
            self.primitives += 1;
        }
    }

    /// The pixels that a draw may cover.
    fn pixels(&self, draw: &Draw<'_>) -> Rect {
        let mut pixels = Rect::from_size(self.size);
        if let Space::Clip { viewport, .. } = draw.space {
            pixels = pixels.intersection(viewport);
        }
        draw.state.scissor.map_or(pixels, |scissor| pixels.intersection(scissor))
    }

    /// What is left of a triangle, as a fan about its first corner.
    fn triangle(&mut self, primitive: Primitive<'_>, corners: &[Corner]) {
        let Some((first, rest)) = corners.split_first() else { return };
        let parts: Vec<Triangle<'_>> =
            rest.windows(2).map(|pair| Triangle { corners: [first, &pair[0], &pair[1]] }).collect();
        let area: i128 = parts.iter().map(Triangle::area).sum();
        let state = &primitive.draw.state;
        let front = (area > 0) == (state.front == Winding::Clockwise);
        let is_culled = match state.cull {
            Cull::None => false,
            Cull::Back => !front,
            Cull::Front => front,
        };
        if area == 0 || is_culled {
            return;
        }
        let primitive = Primitive { front, ..primitive };
        for (x, y) in places(self.around(corners, 0, primitive.draw)) {
            let place = sample(x, y, self.look);
            let Some(part) = parts.iter().find(|part| part.covers(place)) else { continue };
            let (weights, slopes) = (part.weights(place), part.slopes());
            let code = code(state, self.precision, &part.corners, &weights, Some(&slopes));
            let [across, down] = &slopes;
            let varyings = primitive.varyings(&part.corners, &weights, [across, down]);
            self.fragment(primitive, (x, y), code, &varyings, 0);
        }
    }

    /// The pixels that a draw may cover within `reach` of corners: those beside are not asked.
    #[allow(clippy::cast_possible_truncation, reason = "limited to a picture's sides")]
    fn around(&self, corners: &[Corner], reach: i128, draw: &Draw<'_>) -> Rect {
        let pixels = self.pixels(draw);
        if pixels.is_empty() {
            return pixels;
        }
        let look = sample(0, 0, self.look);
        let ends = |axis: usize, from: i32, to: i32| {
            let at = || corners.iter().map(|corner| corner.place[axis] - look[axis]);
            let limit = |pixel: i128| pixel.clamp(from.into(), to.into()) as i32;
            let (low, high) = (at().min().unwrap_or(0), at().max().unwrap_or(0));
            // Rounded outwards.
            (limit((low - reach).div_euclid(PIXEL)), limit((high + reach).div_euclid(PIXEL) + 1))
        };
        let (left, right) = ends(0, pixels.left, pixels.right);
        let (top, bottom) = ends(1, pixels.top, pixels.bottom);
        Rect { left, top, right, bottom }
    }

    /// Draws a line; how many pixels it has along its longer side, modulo 2^32.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "pixels of the picture"
    )]
    fn line(
        &mut self,
        primitive: Primitive<'_>,
        ends: [&Corner; 2],
        width: u16,
        progress: Progress,
        before: u32,
    ) -> u32 {
        let line = Line { from: ends[0].place, to: ends[1].place, look: sample(0, 0, self.look) };
        let (axis, other) = (line.axis(), 1 - line.axis());
        // Copies lie about the line.
        let first_copy = line.moved(other, -(i128::from(width) - 1) * PIXEL / 2);
        let Some([first, last]) = first_copy.ends() else { return 0 };
        let area = self.pixels(primitive.draw);
        let (from, to) = if axis == 0 { (area.left, area.right) } else { (area.top, area.bottom) };
        let direction = if first <= last { 1 } else { -1 };
        let is_of_line = |along: &i128| (first.min(last)..=first.max(last)).contains(along);
        for along in (i128::from(from)..i128::from(to)).filter(is_of_line) {
            let Some(across) = first_copy.across(along) else { continue };
            for across in (across..).take(width.into()) {
                let (x, y) = if axis == 0 { (along, across) } else { (across, along) };
                if !area.contains(limited(x), limited(y)) {
                    continue;
                }
                let pixel = (x as u16, y as u16);
                let place = sample(pixel.0, pixel.1, self.look);
                let way = [0, 1].map(|axis| (line.to[axis] - line.from[axis]) as f64);
                let here = [0, 1].map(|axis| (place[axis] - line.from[axis]) as f64);
                let t = match progress {
                    Progress::Longer => here[axis] / way[axis],
                    Progress::Nearest => {
                        (here[0] * way[0] + here[1] * way[1]) / (way[0] * way[0] + way[1] * way[1])
                    }
                };
                let t = t.clamp(0.0, 1.0);
                let weights = [1.0 - t, t];
                let code = code(&primitive.draw.state, self.precision, &ends, &weights, None);
                let varyings = primitive.varyings(&ends, &weights, [&[0.0; 2]; 2]);
                let step = before.wrapping_add(((along - first) * direction) as u32);
                self.fragment(primitive, pixel, code, &varyings, step);
            }
        }
        ((last - first) * direction + 1) as u32
    }

    fn point(&mut self, primitive: Primitive<'_>, corner: &Corner, side: f64) {
        let side = Snap::Exact.round(side);
        for (x, y) in places(self.around(std::slice::from_ref(corner), side, primitive.draw)) {
            let place = sample(x, y, self.look);
            let is_within = |axis: usize| {
                let twice = 2 * (place[axis] - corner.place[axis]);
                -side <= twice && twice < side
            };
            if is_within(0) && is_within(1) {
                let code = code(&primitive.draw.state, self.precision, &[corner], &[1.0], None);
                let varyings = Varyings::constant(&corner.varyings);
                self.fragment(primitive, (x, y), code, &varyings, 0);
            }
        }
    }

    /// Shades, tests and stores a fragment.
    fn fragment(
        &mut self,
        primitive: Primitive<'_>,
        (x, y): (u16, u16),
        code: f64,
        varyings: &Varyings,
        step: u32,
    ) {
        let i = usize::from(y) * usize::from(self.size.width) + usize::from(x);
        self.counts[i] += 1;
        let Primitive { draw, number, front, .. } = primitive;
        let [along_x, along_y] = &varyings.along;
        let fragment = Fragment {
            x,
            y,
            varyings: &varyings.here,
            along_x,
            along_y,
            primitive: number,
            front,
            step,
        };
        let Some(color) = (draw.shade)(&fragment) else { return };
        let State { depth, stencil, blend, mask, .. } = &draw.state;
        let code = self.precision.round(code);
        if test(depth, *stencil, code, &mut self.depths[i], &mut self.stencil[i]) {
            let color = blended(*blend, color, self.colors[i]);
            let writes = [mask.red, mask.green, mask.blue];
            for ((stored, new), writes) in self.colors[i].iter_mut().zip(color).zip(writes) {
                if writes {
                    *stored = new;
                }
            }
            self.seen[i] = Some(self.primitives);
        }
    }
}

impl Primitive<'_> {
    /// Varyings between some of its corners.
    fn varyings(&self, corners: &[&Corner], weights: &[f64], slopes: [&[f64]; 2]) -> Varyings {
        match self.draw.interpolation {
            Interpolation::Perspective => Varyings::mixed(corners, weights, slopes, true),
            Interpolation::Linear => Varyings::mixed(corners, weights, slopes, false),
            Interpolation::Flat { provoking } => {
                let vertex = self.vertices.get(provoking).or(self.vertices.last());
                Varyings::constant(vertex.map_or(&[], |vertex| &vertex.varyings))
            }
        }
    }
}

/// The depth code of such weights of corners; a triangle's weights have slopes.
fn code(
    state: &State,
    precision: DepthPrecision,
    corners: &[&Corner],
    weights: &[f64],
    slopes: Option<&[[f64; 3]; 2]>,
) -> f64 {
    let depth = &state.depth;
    if depth.test == AnyDepth::Off {
        return 0.0;
    }
    let codes: Vec<f64> = corners.iter().map(|corner| in_range(depth, corner.code)).collect();
    let Some(first) = codes.first() else { return 0.0 };
    // Of what a corner has more than the first: equal ones give the same everywhere.
    let more = |weights: &[f64]| -> f64 {
        codes.iter().zip(weights).map(|(code, weight)| (code - first) * weight).sum()
    };
    let code = if depth.constant { precision.mean(&codes) } else { first + more(weights) };
    let Some(slopes) = slopes else { return code };
    let steepest = slopes.iter().map(|slopes| more(slopes).abs()).fold(0.0, f64::max);
    let steepest = if depth.constant { 0.0 } else { steepest };
    let away = depth.offset.0.to_num::<f64>() * steepest + f64::from(depth.offset.1);
    // No corner leaves the range of codes.
    let farthest = codes.iter().copied().fold(65_535.0, f64::min);
    let nearest = codes.iter().copied().fold(0.0, f64::max);
    code - away.min(farthest).max(nearest - 65_535.0)
}

/// The pixels of a rectangle that lies within a picture, by rows.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "pixels of a picture")]
fn places(pixels: Rect) -> impl Iterator<Item = (u16, u16)> {
    let Rect { left, top, right, bottom } = pixels;
    (top..bottom).flat_map(move |y| (left..right).map(move |x| (x as u16, y as u16)))
}

/// A pixel as a rectangle takes it.
#[allow(clippy::cast_possible_truncation, reason = "limited")]
fn limited(pixel: i128) -> i32 {
    pixel.clamp(i32::MIN.into(), i32::MAX.into()) as i32
}
