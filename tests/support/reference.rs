//! A renderer in `f64` that is obviously correct: every pixel against every triangle, corners
//! where they are, nothing snapped, nothing shared with the crate but matrices and numbers.

use microraster::math::{Mat4, Vec3};
use microraster::{
    AnyBlend, AnyCompare, AnyDepth, AnyOperation, Cull, Rgb, Size, Topology, Winding,
};

use crate::scenes::golden::render::{AMBIENT, MATERIAL, SUN, SUN_COLOR, TONES, TOWARDS_LIGHT};
use crate::scenes::golden::shapes::Attributes;
use crate::scenes::golden::{
    Draw, FragmentState, Kind, MeshDraw, Picture, ScreenCorner, ScreenDraw, Shade,
};

type Color = [f64; 3];

/// A picture in colours of 0 to 255 and codes of 0 to 65535.
#[derive(Clone, Debug)]
pub(crate) struct Canvas {
    size: Size,
    /// Where a pixel is looked at, from its centre, in pixels.
    look: [f64; 2],
    pub(crate) colors: Vec<Color>,
    codes: Vec<f64>,
    stencil: Vec<u8>,
}

fn channels(color: Rgb) -> Color {
    [color.r, color.g, color.b].map(f64::from)
}

fn vector(v: Vec3) -> [f64; 3] {
    [v.x, v.y, v.z].map(f64::from)
}

fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|v| v * v).sum::<f64>().sqrt();
    v.map(|v| v / length)
}

fn dot<const N: usize>(a: [f64; N], b: [f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Columns of a matrix.
fn columns(m: &Mat4) -> [[f64; 4]; 4] {
    m.to_columns().map(|column| column.map(f64::from))
}

fn transform(m: &Mat4, [x, y, z, w]: [f64; 4]) -> [f64; 4] {
    let [a, b, c, d] = columns(m);
    [0, 1, 2, 3].map(|i| a[i] * x + b[i] * y + c[i] * z + d[i] * w)
}

/// One channel of an opaque colour over a stored one, 0 to 255.
fn mixed(blend: AnyBlend, source: f64, stored: f64) -> f64 {
    match blend {
        AnyBlend::Replace => source,
        AnyBlend::ConstantAlpha(alpha) => {
            let alpha = f64::from(alpha) / 255.0;
            source * alpha + stored * (1.0 - alpha)
        }
        AnyBlend::Add => source + stored,
        AnyBlend::Multiply => source * stored / 255.0,
        AnyBlend::Subtract => stored - source,
        AnyBlend::Average => (source + stored) / 2.0,
        other => panic!("no picture uses {other:?}"),
    }
}

/// What a triangle's pixels are coloured by.
enum Paint {
    Constant(Color),
    Corners([Color; 3]),
    /// Brightness at the corners, 0 to 4, and a tone for each.
    Tones([f64; 3]),
}

impl Paint {
    fn at(&self, weights: [f64; 3]) -> Color {
        match self {
            Self::Constant(color) => *color,
            Self::Corners(corners) => {
                [0, 1, 2].map(|channel| dot(corners.map(|c| c[channel]), weights))
            }
            Self::Tones(corners) => {
                let tone = dot(*corners, weights).clamp(0.0, 3.999);
                channels(TONES[tone as usize])
            }
        }
    }
}

/// A mesh draw made ready.
struct Stage<'a> {
    draw: &'a MeshDraw,
    /// Left, top, width, height of the viewport.
    viewport: [f64; 4],
    /// Whether what is behind z = 0 is cut off.
    has_far: bool,
}

impl Canvas {
    /// The picture as it is seen `look` pixels beside each pixel's centre.
    pub(crate) fn of(picture: &Picture, look: [f64; 2]) -> Self {
        let pixels = usize::from(picture.size.width) * usize::from(picture.size.height);
        let background = channels(picture.background);
        let mut canvas = Self {
            size: picture.size,
            look,
            colors: vec![background; pixels],
            codes: vec![0.0; pixels],
            stencil: vec![0; pixels],
        };
        for draw in picture.draws {
            match draw {
                Draw::Mesh(draw) => canvas.mesh(draw),
                Draw::Screen(draw) => canvas.screen(draw),
            }
        }
        canvas
    }

    /// Tests a pixel's stencil value and depth, and sets it.
    fn set(
        &mut self,
        i: usize,
        test: AnyDepth,
        state: Option<FragmentState>,
        code: f64,
        color: Color,
    ) {
        let FragmentState { blend, range, stencil, .. } = state.unwrap_or(FragmentState::PLAIN);
        let (compare, reference, on_pass) = stencil;
        let (farthest, nearest) = (f64::from(range.0), f64::from(range.1));
        let new = (farthest + (nearest - farthest) * code / 65_535.0).round();
        let old = self.codes[i];
        let is_let_through = match compare {
            AnyCompare::Always => true,
            AnyCompare::Equal => reference == self.stencil[i],
            other => panic!("no picture uses {other:?}"),
        };
        let passes = match test {
            AnyDepth::Off | AnyDepth::Always => true,
            AnyDepth::Less => new > old,
            AnyDepth::LessEqual => new >= old,
            AnyDepth::Greater => new < old,
            other => panic!("no picture uses {other:?}"),
        };
        if !(is_let_through && passes) {
            return;
        }
        let stored = self.colors[i];
        self.colors[i] = [0, 1, 2].map(|k| mixed(blend, color[k], stored[k]).clamp(0.0, 255.0));
        if test != AnyDepth::Off {
            self.codes[i] = new;
        }
        self.stencil[i] = match on_pass {
            AnyOperation::Keep => self.stencil[i],
            AnyOperation::Replace => reference,
            AnyOperation::IncrementWrap => self.stencil[i].wrapping_add(1),
            other => panic!("no picture uses {other:?}"),
        };
    }

    fn mesh(&mut self, draw: &MeshDraw) {
        let arrays = draw.shape.arrays();
        let camera = (draw.camera)();
        let model = (draw.model)();
        let whole = [0.0, 0.0, f64::from(self.size.width), f64::from(self.size.height)];
        let viewport = draw
            .viewport
            .map_or(whole, |v| [v.left, v.top, v.right - v.left, v.bottom - v.top].map(f64::from));
        let projection = camera.projection((viewport[2] / viewport[3]) as f32);
        let place = |position: &[i16; 3]| {
            let (scale, offset) = (vector(arrays.scale), vector(arrays.offset));
            let [x, y, z] = [0, 1, 2].map(|i| f64::from(position[i]) * scale[i] + offset[i]);
            let world = transform(&model, [x, y, z, 1.0]);
            transform(&projection, transform(&camera.view(), world))
        };
        let clip: Vec<[f64; 4]> = arrays.positions.iter().map(place).collect();
        // Without a far plane, clip z is the same everywhere.
        let has_far = columns(&projection).iter().take(3).any(|column| column[2] != 0.0);
        let stage = Stage { draw, viewport, has_far };
        for (number, corners) in arrays.topology.iter().enumerate() {
            let corners = corners.map(|index| index as usize);
            let paint = paint(draw, &model, number, corners);
            self.triangle(&stage, corners.map(|i| clip[i]), &paint);
        }
    }

    /// Pixels whose centres see the triangle: their rays, as combinations of the corners, have no
    /// negative weight (Olano and Greer, *Triangle Scan Conversion using 2D Homogeneous
    /// Coordinates*, 1997).
    fn triangle(&mut self, stage: &Stage<'_>, v: [[f64; 4]; 3], paint: &Paint) {
        let [a, b, c] = v.map(|[x, y, _, w]| [x, y, w]);
        let cross = |p: [f64; 3], q: [f64; 3]| {
            [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
        };
        let determinant = dot(a, cross(b, c));
        if determinant == 0.0 {
            return;
        }
        let counter_clockwise = determinant > 0.0;
        let front = counter_clockwise == (stage.draw.front == Winding::CounterClockwise);
        match stage.draw.cull {
            Cull::Back if !front => return,
            Cull::Front if front => return,
            _ => {}
        }
        let edges = [cross(b, c), cross(c, a), cross(a, b)];
        let [left, top, width, height] = stage.viewport;
        // The code's change from pixel to pixel, and by how much the triangle is moved away.
        let slope = |axis: usize, side: f64| {
            let change = [0, 1, 2].map(|k| edges[k][axis] / determinant * v[k][2]);
            (change.iter().sum::<f64>() * 2.0 / side * 65_531.0).abs()
        };
        let (steepness, units) = stage.draw.fragments.unwrap_or(FragmentState::PLAIN).offset;
        let steepest = slope(0, width).max(slope(1, height));
        let away = steepest * steepness.to_num::<f64>() + f64::from(units);
        // In front of the eye a triangle lies between its corners; most are small.
        let is_before = v.iter().all(|corner| corner[3] > 0.0);
        let reach = |axis: usize| {
            let at = v.map(|corner| corner[axis] / corner[3]);
            let (low, high) =
                (at.iter().copied().fold(1.0, f64::min), at.iter().copied().fold(-1.0, f64::max));
            if is_before {
                (low - 1e-6, high + 1e-6)
            } else {
                (-1.0, 1.0)
            }
        };
        let ((left_most, right_most), (lowest, highest)) = (reach(0), reach(1));
        for (i, (x, y)) in pixels(self.size) {
            if stage.draw.scissor.is_some_and(|s| !s.contains(x, y)) {
                continue;
            }
            let ndc_x = (f64::from(x) + 0.5 + self.look[0] - left) / width * 2.0 - 1.0;
            let ndc_y = 1.0 - (f64::from(y) + 0.5 + self.look[1] - top) / height * 2.0;
            let is_beside = ndc_x < left_most || ndc_x > right_most;
            if ndc_x.abs() > 1.0 || ndc_y.abs() > 1.0 {
                continue;
            }
            if is_beside || ndc_y < lowest || ndc_y > highest {
                continue;
            }
            // Weights of the point with w = 1 on the ray.
            let weights = edges.map(|edge| dot(edge, [ndc_x, ndc_y, 1.0]) / determinant);
            let z = dot(weights, v.map(|v| v[2]));
            let hidden = z > 1.0 || (stage.has_far && z < 0.0);
            if weights.iter().any(|weight| *weight < 0.0) || hidden {
                continue;
            }
            let linear = match paint {
                Paint::Constant(_) => weights,
                _ => linear(v, weights),
            };
            let code = 2.0 + 65_531.0 * z - away;
            self.set(i, stage.draw.depth, stage.draw.fragments, code, paint.at(linear));
        }
    }

    fn screen(&mut self, draw: &ScreenDraw) {
        let corners: Vec<ScreenCorner> = (0..).map_while(draw.corner).collect();
        let size = self.size;
        match draw.kind {
            Kind::Triangles => {
                for triangle in corners.chunks_exact(3) {
                    let v = [0, 1, 2].map(|k| [f64::from(triangle[k].0), f64::from(triangle[k].1)]);
                    let area = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
                        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
                    };
                    let whole = area(v[0], v[1], v[2]);
                    for (i, at) in centers(size) {
                        let parts =
                            [area(v[1], v[2], at), area(v[2], v[0], at), area(v[0], v[1], at)];
                        let weights = parts.map(|part| part / whole);
                        if weights.iter().all(|weight| *weight >= 0.0) {
                            self.mix(i, (draw.depth, draw.fragments), triangle, weights);
                        }
                    }
                }
            }
            Kind::Lines => {
                for line in corners.chunks_exact(2) {
                    self.line((draw.depth, draw.fragments), line, 1, |_| true);
                }
            }
            Kind::Wide(width) => {
                for line in corners.chunks_exact(2) {
                    self.line((draw.depth, draw.fragments), line, width.into(), |_| true);
                }
            }
            Kind::Stippled(pattern, factor) => {
                let mut before = 0;
                for line in corners.windows(2) {
                    let is_on = |pixel: usize| {
                        pattern >> ((before + pixel) / usize::from(factor) % 16) & 1 != 0
                    };
                    before += self.line((draw.depth, draw.fragments), line, 1, is_on);
                }
            }
            Kind::Round(side) => {
                for point in &corners {
                    for (i, [x, y]) in centers(size) {
                        let (dx, dy) = (x - f64::from(point.0), y - f64::from(point.1));
                        if dx.hypot(dy) < f64::from(side) * 8.0 {
                            self.mix(i, (draw.depth, draw.fragments), &[*point], [1.0, 0.0, 0.0]);
                        }
                    }
                }
            }
            Kind::Points(side) => {
                for point in &corners {
                    let half = f64::from(side) * 8.0;
                    let within = |at: f64, v: i32| {
                        let v = f64::from(v);
                        v - half <= at && at < v + half
                    };
                    for (i, [x, y]) in centers(size) {
                        if within(x, point.0) && within(y, point.1) {
                            self.mix(i, (draw.depth, draw.fragments), &[*point], [1.0, 0.0, 0.0]);
                        }
                    }
                }
            }
        }
    }

    /// A line, copied across its longer side; how many pixels it has along that.
    fn line(
        &mut self,
        state: (AnyDepth, Option<FragmentState>),
        line: &[ScreenCorner],
        width: i32,
        is_on: impl Fn(usize) -> bool,
    ) -> usize {
        let (dx, dy) = (line[1].0 - line[0].0, line[1].1 - line[0].1);
        let by_columns = dx.abs() >= dy.abs();
        let back = 8 * (width - 1);
        let (left, up) = if by_columns { (0, back) } else { (back, 0) };
        let ends = [0, 1].map(|k| {
            let (x, y) = (line[k].0 - left, line[k].1 - up);
            microraster::raster::ScreenVertex::from_bits(x, y, 0)
        });
        let within = |x: i32, y: i32| crate::diamond::leaves_diamond(&ends[0], &ends[1], x, y);
        // Of what begins or goes on beside the picture, too.
        let (rows, columns) = (i32::from(self.size.height), i32::from(self.size.width));
        let around = (-64..rows + 64).flat_map(|y| (-64..columns + 64).map(move |x| (x, y)));
        let mut seen: Vec<(i32, i32)> = around.filter(|&(x, y)| within(x, y)).collect();
        let along = |x: i32, y: i32| if by_columns { x * dx.signum() } else { y * dy.signum() };
        seen.sort_by_key(|&(x, y)| along(x, y));
        for (number, &(x, y)) in seen.iter().enumerate() {
            let t = if by_columns {
                f64::from(16 * x + 8 - line[0].0) / f64::from(dx)
            } else {
                f64::from(16 * y + 8 - line[0].1) / f64::from(dy)
            };
            let t = t.clamp(0.0, 1.0);
            for copy in 0..width {
                let (x, y) = if by_columns { (x, y + copy) } else { (x + copy, y) };
                let (w, h) = (i32::from(self.size.width), i32::from(self.size.height));
                if is_on(number) && (0..w).contains(&x) && (0..h).contains(&y) {
                    self.mix((y * w + x) as usize, state, line, [1.0 - t, t, 0.0]);
                }
            }
        }
        seen.len()
    }

    fn mix(
        &mut self,
        i: usize,
        (depth, fragments): (AnyDepth, Option<FragmentState>),
        corners: &[ScreenCorner],
        weights: [f64; 3],
    ) {
        let (mut code, mut color) = (0.0, [0.0; 3]);
        for (corner, weight) in corners.iter().zip(weights) {
            code += f64::from(corner.2) * weight;
            for (sum, channel) in color.iter_mut().zip(channels(corner.3)) {
                *sum += channel * weight;
            }
        }
        self.set(i, depth, fragments, code, color);
    }
}

/// How much of each corner's colour is seen where `weights` of the corners make a point with
/// w = 1: linear on the screen, between the corners or, of a triangle that the near plane cuts,
/// between its one corner in view and the two cuts.
fn linear(v: [[f64; 4]; 3], weights: [f64; 3]) -> [f64; 3] {
    // Signed distances from the near plane, positive in view; without perspective, what is linear
    // on the screen is so on the triangle.
    let distances = v.map(|[_, _, z, w]| w - z);
    let even = v.iter().all(|corner| corner[3] == v[0][3]);
    let Some(seen) = distances.iter().position(|distance| *distance >= 0.0) else {
        return weights;
    };
    if even || distances.iter().all(|distance| *distance >= 0.0) {
        return [0, 1, 2].map(|k| weights[k] * v[k][3]);
    }
    let hidden = [(seen + 1) % 3, (seen + 2) % 3];
    assert!(
        hidden.iter().all(|k| distances[*k] < 0.0),
        "how a polygon of four corners is coloured depends on its triangles"
    );
    // A cut is corner `seen`, and t of the way to a hidden one.
    let t = hidden.map(|k| distances[seen] / (distances[seen] - distances[k]));
    let mut linear = [0.0; 3];
    for (k, t) in hidden.into_iter().zip(t) {
        // The point's weight of this cut, times the cut's w.
        let part = weights[k] / t * ((1.0 - t) * v[seen][3] + t * v[k][3]);
        linear[seen] += part * (1.0 - t);
        linear[k] += part * t;
    }
    let rest =
        weights[seen] - (0..2).map(|i| weights[hidden[i]] * (1.0 - t[i]) / t[i]).sum::<f64>();
    linear[seen] += rest * v[seen][3];
    linear
}

/// Every pixel: its number and place.
fn pixels(size: Size) -> impl Iterator<Item = (usize, (i32, i32))> {
    let places = (0..i32::from(size.height))
        .flat_map(move |y| (0..i32::from(size.width)).map(move |x| (x, y)));
    places.enumerate()
}

/// Every pixel: its number and its centre in subpixels.
fn centers(size: Size) -> impl Iterator<Item = (usize, [f64; 2])> {
    pixels(size).map(|(i, (x, y))| (i, [16 * x + 8, 16 * y + 8].map(f64::from)))
}

/// How a triangle of a mesh is coloured.
fn paint(draw: &MeshDraw, model: &Mat4, number: usize, corners: [usize; 3]) -> Paint {
    if let Shade::Solid(color) = draw.shade {
        return Paint::Constant(channels(color));
    }
    match draw.shape.arrays().attributes {
        Attributes::FaceColors(colors) => Paint::Constant(channels(colors[number])),
        Attributes::Colors(colors) if draw.shade == Shade::Flat => {
            Paint::Constant(channels(colors[corners[0]]))
        }
        Attributes::Colors(colors) => Paint::Corners(corners.map(|i| channels(colors[i]))),
        Attributes::Normals(normals) => {
            let lengths = |v: [f64; 4]| normalized([v[0], v[1], v[2]]);
            let world = |i: usize| {
                let [x, y, z] = normals[i].map(|v| f64::from(v) / 127.0);
                (lengths(transform(model, [x, y, z, 0.0])), (x * x + y * y + z * z).sqrt())
            };
            let lit = |i: usize| {
                let (normal, length) = world(i);
                let to_light = normalized(vector(SUN).map(|v| -v));
                let cosine = (dot(normal, to_light) * length).clamp(0.0, 1.0);
                let (sun, ambient) = (channels(SUN_COLOR), channels(AMBIENT));
                let material = channels(MATERIAL);
                [0, 1, 2].map(|k| (ambient[k] + sun[k] * cosine) * material[k] / 255.0)
            };
            let tone = |i: usize| {
                let (normal, length) = world(i);
                let cosine = dot(normal, normalized(vector(TOWARDS_LIGHT))) * length;
                (cosine + 1.0) * 127.0 * 4096.0 / 16.0 / 16_384.0
            };
            match draw.shade {
                Shade::Flat | Shade::Solid(_) => Paint::Constant(lit(corners[0])),
                Shade::Gouraud => Paint::Corners(corners.map(lit)),
                Shade::Toon => Paint::Tones(corners.map(tone)),
            }
        }
    }
}
