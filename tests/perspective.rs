//! Varyings in perspective against quotients of `f64` planes.
#![allow(clippy::needless_range_loop, reason = "an axis is used of several pairs of coordinates")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "corners, columns and rows of small pictures"
)]

mod support;

use std::ops::RangeInclusive;

use microraster::raster::ScreenVertex;
use microraster::{
    Adaptive, Affine, Color, Constant, DrawContext, Every, Exact, Format, Frame, Perspective,
    PerspectiveCorner, PerspectiveMode, Rect, Scalars, ScreenPass, Shader, Size, Uv, VertexInput,
};
use support::Random;

/// Both words of a colour as they are.
#[derive(Clone, Copy, Debug)]
struct Words;

/// A pixel that was not drawn.
const BLANK: u64 = 0x7654_3210_0123_4567;

impl Format for Words {
    type Raw = u64;

    fn pack(color: Color) -> u64 {
        u64::from(color.blue_red) << 32 | u64::from(color.green)
    }

    fn unpack(raw: u64) -> Color {
        Color { blue_red: (raw >> 32) as u32, green: raw as u32 }
    }
}

/// Shows texture coordinates themselves.
struct Coordinates<M>(M);

impl<M: PerspectiveMode> Shader for Coordinates<M> {
    type Vertex = ();
    type Varying = Perspective<Uv, M>;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> PerspectiveCorner<[i16; 2]> {
        [0, 0].into()
    }

    fn fragment(&self, _: &Self::Prepared, uv: &Perspective<Uv, M>) -> Option<Color> {
        Some(Color { blue_red: uv.u as u32, green: uv.v as u32 })
    }
}

const SIDE: u16 = 96;

/// x, y in subpixels, w, u, v.
#[derive(Clone, Copy, Debug)]
struct Corner {
    x: i32,
    y: i32,
    w: i32,
    uv: [i16; 2],
}

fn draw<M: PerspectiveMode>(mode: M, corners: &[Corner; 3], scissor: Rect) -> Vec<u64> {
    let mut pixels = vec![BLANK; usize::from(SIDE) * usize::from(SIDE)];
    let mut frame =
        Frame::<Words>::new(&mut pixels, Size::new(SIDE, SIDE)).expect("a buffer that fits");
    frame.set_scissor(scissor);
    let corners = corners.map(|Corner { x, y, w, uv }| {
        (ScreenVertex::from_bits(x, y, 0), PerspectiveCorner::new(uv, w))
    });
    ScreenPass::new().triangle(&mut frame, &Coordinates(mode), &corners);
    pixels
}

/// A triangle that reaches up to `reach` pixels beyond the picture, with w over 18 powers of two.
fn triangle(random: &mut Random, reach: i32, w: RangeInclusive<i32>) -> [Corner; 3] {
    let corner = |_| Corner {
        x: random.range(-reach * 16, (i32::from(SIDE) + reach) * 16),
        y: random.range(-reach * 16, (i32::from(SIDE) + reach) * 16),
        w: 1 << random.range(*w.start(), *w.end()) | random.range(0, (1 << *w.start()) - 1),
        uv: [random.range(-32768, 32767) as i16, random.range(-32768, 32767) as i16],
    };
    [0, 1, 2].map(corner)
}

/// The triangle's planes in `f64`: q, u q and v q at a point in pixels.
struct Exactly {
    corners: [Corner; 3],
    area: f64,
}

impl Exactly {
    fn of(corners: [Corner; 3]) -> Self {
        let [a, b, c] = corners.map(|corner| [f64::from(corner.x), f64::from(corner.y)]);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        Self { corners, area }
    }

    /// 1 / w over that of the nearest corner, then u and v, at a pixel's centre.
    fn at(&self, x: i32, y: i32) -> (f64, [f64; 2]) {
        let p = [f64::from(16 * x + 8), f64::from(16 * y + 8)];
        let [a, b, c] = self.corners.map(|corner| [f64::from(corner.x), f64::from(corner.y)]);
        let part = |a: [f64; 2], b: [f64; 2]| {
            ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / self.area
        };
        let parts = [part(b, c), part(c, a), part(a, b)];
        let least = self.corners.iter().map(|corner| corner.w).min().map_or(1.0, f64::from);
        let over_w = self.corners.map(|corner| least / f64::from(corner.w));
        let q: f64 = (0..3).map(|k| parts[k] * over_w[k]).sum();
        let of = |axis: usize| {
            let sum: f64 =
                (0..3).map(|k| parts[k] * over_w[k] * f64::from(self.corners[k].uv[axis])).sum();
            sum / q
        };
        (q, [of(0), of(1)])
    }

    /// Any value of the corners at a pixel's centre.
    fn mixed(&self, x: i32, y: i32, values: [f64; 3]) -> f64 {
        let one = |k: usize| {
            let mut corners = self.corners;
            for (i, corner) in corners.iter_mut().enumerate() {
                corner.uv = [i16::from(i == k), 0];
            }
            Self { corners, area: self.area }.at(x, y).1[0]
        };
        (0..3).map(|k| one(k) * values[k]).sum()
    }

    /// How much the coordinates of the corners differ at most, in steps that 16-bit words resolve.
    fn reach(&self, axis: usize) -> f64 {
        let values = self.corners.map(|corner| i32::from(corner.uv[axis]));
        let least = values.into_iter().min().unwrap_or(0);
        let most = values.into_iter().max().unwrap_or(0);
        65536.0 / f64::from(((most - least) as u32 | 1).leading_zeros() - 16).exp2()
    }

    /// What rounding makes of a coordinate where 1 / w is q: both numbers of a quotient are off by
    /// up to 5/8, one is raised by a quarter, and 2^-30 of the largest word for the division.
    fn rounding(&self, axis: usize, q: f64) -> f64 {
        let unit = 1.0 / 65535.0;
        self.reach(axis) * (1.5 * unit / q + 4.0 * (-30.0_f64).exp2())
    }
}

/// The rows' pixels that were drawn, as (y, first, last).
fn rows(pixels: &[u64]) -> Vec<(i32, i32, i32)> {
    let side = usize::from(SIDE);
    let rows = pixels.chunks_exact(side).enumerate().filter_map(|(y, row)| {
        let first = row.iter().position(|pixel| *pixel != BLANK)?;
        let last = row.iter().rposition(|pixel| *pixel != BLANK)?;
        Some((y as i32, first as i32, last as i32))
    });
    rows.collect()
}

fn seen(pixels: &[u64], x: i32, y: i32) -> [f64; 2] {
    let raw = pixels[y as usize * usize::from(SIDE) + x as usize];
    [(raw >> 32) as u32 as i32, raw as u32 as i32].map(|word| f64::from(word) / 65536.0)
}

/// The difference of two coordinates that are the same modulo 2^16.
fn difference(a: f64, b: f64) -> f64 {
    let d = (a - b).rem_euclid(65536.0);
    d.min(65536.0 - d)
}

const ALL: Rect = Rect::new(0, 0, SIDE as i32, SIDE as i32);

#[test]
fn exact_is_the_quotient_at_each_pixel() {
    let mut random = Random(71);
    let mut compared = 0;
    for round in 0..3_000 {
        let (reach, w) = if round % 2 == 0 { (8, 12..=18) } else { (400, 4..=22) };
        let corners = triangle(&mut random, reach, w);
        let exactly = Exactly::of(corners);
        let pixels = draw(Exact, &corners, ALL);
        for (y, first, last) in rows(&pixels) {
            for x in first..=last {
                let (q, expected) = exactly.at(x, y);
                let seen = seen(&pixels, x, y);
                for axis in 0..2 {
                    let error = difference(seen[axis], expected[axis]);
                    let bound = exactly.rounding(axis, q);
                    assert!(error <= bound, "{error} > {bound} at {x}, {y} of {corners:?}");
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 500_000, "{compared} pixels");
}

/// Lines between the quotients at knots, in `f64`.
fn check_every<const N: i32>(random: &mut Random) {
    for _ in 0..600 {
        let corners = triangle(random, 8, 10..=18);
        let exactly = Exactly::of(corners);
        let pixels = draw(Every::<N>, &corners, ALL);
        for (y, first, last) in rows(&pixels) {
            // Rows that the picture's sides cut have knots that cannot be seen.
            if first == 0 || last == i32::from(SIDE) - 1 {
                continue;
            }
            for x in first..=last {
                let column = x.div_euclid(N) * N;
                let (from, to) = (column.max(first), (column + N).min(last));
                let ((q, a), (r, b)) = (exactly.at(from, y), exactly.at(to, y));
                let t = if to > from { f64::from(x - from) / f64::from(to - from) } else { 0.0 };
                for axis in 0..2 {
                    let expected = a[axis] + (b[axis] - a[axis]) * t;
                    let error = difference(seen(&pixels, x, y)[axis], expected);
                    // The step is cut off too.
                    let bound = exactly.rounding(axis, q.min(r)) + f64::from(N) / 8192.0;
                    assert!(error <= bound, "{error} > {bound} at {x}, {y} of {corners:?}");
                }
            }
        }
    }
}

#[test]
fn every_n_pixels_is_linear_between_knots() {
    let mut random = Random(72);
    check_every::<4>(&mut random);
    check_every::<8>(&mut random);
    check_every::<16>(&mut random);
    check_every::<32>(&mut random);
}

#[test]
fn adaptive_is_within_a_quarter_of_what_a_pixel_covers() {
    let mut random = Random(73);
    let mut worst = 0.0_f64;
    for round in 0..3_000 {
        let (reach, w) = if round % 2 == 0 { (8, 12..=18) } else { (400, 8..=20) };
        let corners = triangle(&mut random, reach, w);
        let exactly = Exactly::of(corners);
        let pixels = draw(Adaptive, &corners, ALL);
        for (y, first, last) in rows(&pixels) {
            for x in first..=last {
                let (q, expected) = exactly.at(x, y);
                for axis in 0..2 {
                    let error = difference(seen(&pixels, x, y)[axis], expected[axis]);
                    let nearby =
                        [x - 1, x + 1].map(|x| (exactly.at(x, y).1[axis] - expected[axis]).abs());
                    let step = nearby[0].max(nearby[1]);
                    // The knots around are up to 16 pixels away, where q may be half.
                    let bound = 0.25 * step + 2.0 * exactly.rounding(axis, q) + 16.0 / 8192.0;
                    worst = worst.max((error - 2.0 * exactly.rounding(axis, q)) / step.max(1.0));
                    assert!(error <= bound, "{error} > {bound} at {x}, {y} of {corners:?}");
                }
            }
        }
    }
    println!("adaptive: {worst:.3} of a step");
}

/// Where w hardly differs, runs are up to 512 pixels long.
#[test]
fn long_runs_are_within_a_quarter_too_and_no_scissor_changes_a_bit() {
    const SIZE: Size = Size::new(1024, 4);
    let draw = |corners: &[Corner; 3], scissor: Rect| {
        let mut pixels = vec![BLANK; 1024 * 4];
        let mut frame = Frame::<Words>::new(&mut pixels, SIZE).expect("a buffer that fits");
        frame.set_scissor(scissor);
        let corners = corners.map(|Corner { x, y, w, uv }| {
            (ScreenVertex::from_bits(x, y, 0), PerspectiveCorner::new(uv, w))
        });
        ScreenPass::new().triangle(&mut frame, &Coordinates(Adaptive), &corners);
        pixels
    };
    let mut random = Random(76);
    let mut compared = 0;
    for round in 0..300 {
        // From no difference at all to a fifth.
        let differs = [0, 200, 2_000, 20_000][round % 4];
        let mut corner = |x: i32, y: i32| Corner {
            x: x * 16 + random.range(-300, 300),
            y: y * 16,
            w: 100_000 + random.range(0, differs),
            uv: [random.range(-32768, 32767) as i16, random.range(-32768, 32767) as i16],
        };
        let corners = [corner(20, -9), corner(1000, -5), corner(500, 30)];
        let exactly = Exactly::of(corners);
        let whole = draw(&corners, Rect::new(0, 0, 1024, 4));
        let left = random.range(0, 900);
        let part = Rect::new(left, 1, left + random.range(1, 600), 3);
        let cut = draw(&corners, part);
        for (i, (raw, cut)) in whole.iter().zip(&cut).enumerate() {
            let (x, y) = ((i % 1024) as i32, (i / 1024) as i32);
            let expected = if part.contains(x, y) { *raw } else { BLANK };
            assert_eq!(*cut, expected, "at {x}, {y} of {corners:?} in {part:?}");
            if *raw == BLANK {
                continue;
            }
            let seen =
                [(*raw >> 32) as u32, *raw as u32].map(|word| f64::from(word as i32) / 65536.0);
            let (q, expected) = exactly.at(x, y);
            for axis in 0..2 {
                let error = difference(seen[axis], expected[axis]);
                let step = (exactly.at(x + 1, y).1[axis] - expected[axis]).abs();
                // The step is cut off too.
                let bound = 0.25 * step + 2.0 * exactly.rounding(axis, q) + 512.0 / 8192.0;
                assert!(error <= bound, "{error} > {bound} at {x}, {y} of {corners:?}");
            }
            compared += 1;
        }
    }
    assert!(compared > 500_000, "{compared} pixels");
}

#[test]
fn affine_is_linear_on_the_screen() {
    let mut random = Random(74);
    for _ in 0..500 {
        let corners = triangle(&mut random, 20, 10..=18);
        let flat = Exactly::of(corners.map(|corner| Corner { w: 1, ..corner }));
        let pixels = draw(Affine, &corners, ALL);
        for (y, first, last) in rows(&pixels) {
            for x in first..=last {
                let (_, expected) = flat.at(x, y);
                for (seen, expected) in seen(&pixels, x, y).into_iter().zip(expected) {
                    let error = difference(seen, expected);
                    assert!(error <= 0.126, "{error} at {x}, {y} of {corners:?}");
                }
            }
        }
    }
}

fn check_scissors<M: PerspectiveMode>(mode: M, random: &mut Random) {
    for _ in 0..150 {
        let corners = triangle(random, 60, 8..=18);
        let whole = draw(mode, &corners, ALL);
        let (left, top) = (random.range(0, 90), random.range(0, 90));
        let part = Rect::new(left, top, left + random.range(1, 60), top + random.range(1, 60));
        let cut = draw(mode, &corners, part);
        for (i, (a, b)) in whole.iter().zip(&cut).enumerate() {
            let (x, y) = ((i % usize::from(SIDE)) as i32, (i / usize::from(SIDE)) as i32);
            let expected = if part.contains(x, y) { *a } else { BLANK };
            assert_eq!(*b, expected, "at {x}, {y} of {corners:?} in {part:?}");
        }
    }
}

#[test]
fn no_scissor_changes_a_bit() {
    let mut random = Random(75);
    check_scissors(Affine, &mut random);
    check_scissors(Every::<4>, &mut random);
    check_scissors(Every::<32>, &mut random);
    check_scissors(Adaptive, &mut random);
    check_scissors(Exact, &mut random);
}

#[test]
fn corners_at_the_ends_of_w_wrap_nowhere() {
    let corner = |x: i32, y: i32, w, u, v| Corner { x: x * 16, y: y * 16, w, uv: [u, v] };
    let (low, high) = (i16::MIN, i16::MAX);
    for (a, b) in [(1, 1 << 30), (1 << 30, 1), (1 << 29, 1 << 30), (1, 1), (1 << 30, 1 << 30)] {
        let corners = [
            corner(-2, -2, a, low, low),
            corner(400, 3, b, high, low),
            corner(3, 400, b, low, high),
        ];
        let modes = [
            draw(Exact, &corners, ALL),
            draw(Adaptive, &corners, ALL),
            draw(Every::<16>, &corners, ALL),
        ];
        for pixels in modes {
            for (y, first, last) in rows(&pixels) {
                let row: Vec<f64> = (first..=last).map(|x| seen(&pixels, x, y)[0]).collect();
                let falls = row.windows(2).map(|pair| pair[0] - pair[1]).fold(0.0, f64::max);
                // u rises along each row; a wrap would be a fall of 65536.
                assert!(falls < 3.0, "falls by {falls} in row {y}, w {a} and {b}");
            }
        }
    }
}

/// Eight groups of four numbers, of every kind; which of them is shown is a number.
struct Groups(usize);

/// Numbers in perspective, linear on the screen, and the first corner's.
type Smooth = Perspective<Scalars<4>>;
type Linear = Scalars<4>;
type Flat = Constant<[u16; 4]>;

impl Shader for Groups {
    type Vertex = ();
    type Varying = (Smooth, Linear, Flat, Smooth, Linear, Flat, Smooth, Linear);
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> microraster::Corner<Self::Varying> {
        Default::default()
    }

    fn fragment(&self, (): &(), varying: &Self::Varying) -> Option<Color> {
        let (a, b, c, d, e, f, g, h) = varying;
        let groups = [a.get(), b.get(), c.0, d.get(), e.get(), f.0, g.get(), h.get()];
        let [p, q, r, s] = groups[self.0].map(u32::from);
        Some(Color { blue_red: p << 16 | q, green: r << 16 | s })
    }
}

#[test]
fn eight_groups_of_four_are_interpolated_each_in_its_way() {
    let mut random = Random(76);
    for _ in 0..40 {
        let corners = triangle(&mut random, 8, 12..=18);
        let values =
            corners.map(|_| [0; 8].map(|_: i32| [0; 4].map(|_: i32| random.next() as u16)));
        let exactly = Exactly::of(corners);
        let even = Exactly::of(corners.map(|corner| Corner { w: 1, ..corner }));
        for group in 0..8 {
            let mut pixels = vec![BLANK; usize::from(SIDE) * usize::from(SIDE)];
            let mut frame = Frame::<Words>::new(&mut pixels, Size::new(SIDE, SIDE)).expect("fits");
            let shaded = [0, 1, 2].map(|k| {
                let (Corner { x, y, w, .. }, v) = (corners[k], values[k]);
                let smooth = |v| PerspectiveCorner::new(v, w);
                let varying =
                    (smooth(v[0]), v[1], v[2], smooth(v[3]), v[4], v[5], smooth(v[6]), v[7]);
                (ScreenVertex::from_bits(x, y, 0), varying)
            });
            ScreenPass::new().triangle(&mut frame, &Groups(group), &shaded);
            for (y, first, last) in rows(&pixels) {
                for x in first..=last {
                    let raw = pixels[y as usize * usize::from(SIDE) + x as usize];
                    for axis in 0..4 {
                        let seen = f64::from((raw >> (48 - 16 * axis)) as u16);
                        let corner = values.map(|v| f64::from(v[group][axis]));
                        let (expected, bound) = match group {
                            // Adaptive: a quarter of a pixel's way, of which there is no bound here
                            // but that between the neighbours.
                            0 | 3 | 6 => {
                                let near = [x - 1, x, x + 1].map(|x| exactly.mixed(x, y, corner));
                                let step = (near[2] - near[1]).abs().max((near[1] - near[0]).abs());
                                let (q, _) = exactly.at(x, y);
                                (near[1], 0.25 * step + 4.0 / q + 2.0)
                            }
                            2 | 5 => (corner[0], 0.0),
                            _ => (even.mixed(x, y, corner), 0.7),
                        };
                        let error = (seen - expected).abs();
                        assert!(error <= bound, "group {group}: {error} > {bound} at {x}, {y}");
                    }
                }
            }
        }
    }
}
