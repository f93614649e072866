//! Depth and colour over a triangle against exact fractions, and independence of where it is cut.

use crate::support::{any_corner, spans, Random};
use crate::tally::{cases, random};
use microraster::raster::{Gradients, ScreenVertex, Triangle};
use microraster::{
    Always, Color, Flat, Frame, Gouraud, Less, Rect, Rgb, Rgba8888, ScreenPass, Size,
};

const SIZE: Size = Size::new(24, 20);
const PIXELS: usize = 24 * 20;

type Shaded = (ScreenVertex, Color);

fn any_triangle(random: &mut Random, class: i32) -> [Shaded; 3] {
    [(); 3].map(|()| {
        let v = any_corner(random, class, SIZE);
        let bits = random.next();
        // Often at the ends of the range.
        let z = match bits % 4 {
            0 => 0,
            1 => u16::MAX,
            _ => (bits >> 8) as u16,
        };
        let [_, r, g, b, end, ..] = bits.to_le_bytes();
        let channel = |c: u8| if end % 3 == 0 { c >> 7 } else { c };
        let full = |c: u8| if end % 3 == 0 { 255 * channel(c) } else { c };
        (ScreenVertex::new(v.x, v.y, z), Rgb::new(full(r), full(g), full(b)).into())
    })
}

/// A long triangle a fraction of a pixel wide.
fn sliver(random: &mut Random) -> [Shaded; 3] {
    let [(a, p), (b, q), (c, r)] = any_triangle(random, 6);
    let near = |v: &ScreenVertex, by: i32, random: &mut Random| {
        let (x, y) = (v.x.to_bits() + random.range(-by, by), v.y.to_bits() + random.range(-by, by));
        ScreenVertex::from_bits(x, y, c.z)
    };
    let by = random.range(1, 12);
    [(a, p), (b, q), (near(&a, by, random), r)]
}

/// The channels that a corner was made of: whole steps of 8 bits.
fn channels(color: Color) -> [u8; 3] {
    [color.red(), color.green(), color.blue()]
}

fn draw(triangle: &[Shaded; 3], areas: &[Rect]) -> (Vec<u32>, Vec<u16>) {
    let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
    let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
    for area in areas {
        frame.set_scissor(*area);
        ScreenPass::new().depth(Always).triangle(&mut frame, &Gouraud::colored(), triangle);
    }
    (pixels, depth)
}

/// The exact value at a pixel's centre, in fractions of 1 / 2^-40 at worst.
fn exact(triangle: &[Shaded; 3], of: impl Fn(&Shaded) -> f64, x: i32, y: i32) -> f64 {
    let p = triangle.map(|(v, _)| (i64::from(v.x.to_bits()), i64::from(v.y.to_bits())));
    let at = (i64::from(16 * x + 8), i64::from(16 * y + 8));
    let cross = |a: (i64, i64), b: (i64, i64), c: (i64, i64)| {
        (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0)
    };
    let area = cross(p[0], p[1], p[2]) as f64;
    let weights =
        [cross(p[1], p[2], at), cross(p[2], p[0], at), cross(p[0], p[1], at)].map(|w| w as f64);
    triangle.iter().zip(weights).map(|(corner, w)| of(corner) * w).sum::<f64>() / area
}

/// What a plane may be off beside rounding, in steps of a 16-bit attribute: an eighth for
/// triangles that are neither large nor thin (see `Gradients`). On the others slopes are off by
/// 2^-17 a pixel, at most 8192 of which lie between the first corner and a pixel of it, by column
/// and by row.
const PLANE: f64 = 0.125;

#[test]
fn depth_and_colour_are_the_exact_ones_within_the_stated_bounds() {
    let (mut most_depth, mut most_color, mut compared, mut i) = (0.0_f64, 0.0_f64, 0_u64, 0);
    let wanted = cases(100_000, 5_000_000);
    random("depth and colour are within their bound", wanted, 31, |random| {
        i += 1;
        let triangle = if i % 4 == 0 { sliver(random) } else { any_triangle(random, i % 10) };
        let (pixels, depth) = draw(&triangle, &[Rect::from_size(SIZE)]);
        for (i, word) in pixels.iter().enumerate().filter(|(_, word)| **word != 0) {
            compared += 1;
            let (x, y) = (i as i32 % 24, i as i32 / 24);
            let code = exact(&triangle, |corner| corner.0.z.into(), x, y);
            let off = (code - f64::from(depth[i])).abs();
            most_depth = most_depth.max(off);
            assert!(off <= 0.5 + PLANE, "code {} for {code} at {x}, {y}: {triangle:?}", depth[i]);
            let [red, green, blue, _] = word.to_le_bytes();
            for (k, channel) in [red, green, blue].into_iter().enumerate() {
                let value = exact(&triangle, |corner| f64::from(channels(corner.1)[k]), x, y);
                let off = (value - f64::from(channel)).abs();
                most_color = most_color.max(off);
                // Half a step of rounding, a quarter for stepping two channels in one word.
                let bound = 0.75 + PLANE / 256.0 + 1.0 / 256.0;
                assert!(off <= bound, "{channel} for {value} at {x}, {y}: {triangle:?}");
            }
        }
        1
    });
    println!("{compared} pixels: depth off by {most_depth:.4}, colour by {most_color:.4}");
    assert!(compared >= 8 * i as u64, "only {compared} pixels were compared");
}

#[test]
fn scissors_and_bands_change_no_bit() {
    let mut i = 0;
    random("scissors and bands change no pixel", cases(15_000, 1_000_000), 32, |random| {
        i += 1;
        let triangle = if i % 4 == 0 { sliver(random) } else { any_triangle(random, i % 10) };
        let (x, y) = (random.range(0, 24), random.range(0, 20));
        let whole = draw(&triangle, &[Rect::from_size(SIZE)]);
        let parts = [
            Rect::new(0, 0, x, y),
            Rect::new(x, 0, 24, y),
            Rect::new(0, y, x, 20),
            Rect::new(x, y, 24, 20),
        ];
        assert!(draw(&triangle, &parts) == whole, "cut at {x}, {y}: {triangle:?}");
        // Bands of any height, with their own buffers.
        let rows = random.range(1, 20) as u16;
        let (mut pixels, mut depth) = (Vec::new(), Vec::new());
        for first in (0..20).step_by(rows.into()) {
            let height = rows.min(20 - first);
            let (mut band, mut codes) =
                (vec![0; 24 * usize::from(height)], vec![0; 24 * usize::from(height)]);
            let frame = Frame::<Rgba8888>::new(&mut band, Size::new(24, height));
            let frame = frame.and_then(|frame| frame.with_depth(&mut codes));
            let mut frame =
                frame.and_then(|frame| frame.band(first, 20)).expect("a band that fits");
            ScreenPass::new().depth(Always).triangle(&mut frame, &Gouraud::colored(), &triangle);
            pixels.extend(band);
            depth.extend(codes);
        }
        assert!((pixels, depth) == whole, "bands of {rows}: {triangle:?}");
        1
    });
}

#[test]
fn equal_corners_give_the_same_bits_as_flat_shading() {
    let mut random = Random(33);
    for i in 0..20_000 {
        let triangle = any_triangle(&mut random, i % 10);
        let color = triangle[0].1;
        let triangle = triangle.map(|(v, _)| (v, color));
        let (gouraud, gouraud_depth) = draw(&triangle, &[Rect::from_size(SIZE)]);
        let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
        let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
        ScreenPass::new().depth(Always).triangle(&mut frame, &Flat::colored(), &triangle);
        assert!(pixels == gouraud && depth == gouraud_depth, "{triangle:?}");
    }
}

#[test]
fn the_same_triangle_twice_has_the_same_depth() {
    let mut random = Random(34);
    for i in 0..10_000 {
        let triangle = any_triangle(&mut random, i % 10);
        let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
        let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
        ScreenPass::new().depth(Always).triangle(&mut frame, &Gouraud::colored(), &triangle);
        let mut stats = microraster::Stats::default();
        let mut pass = ScreenPass::new().depth(Less).count(&mut stats);
        pass.triangle(&mut frame, &Gouraud::colored(), &triangle);
        assert_eq!(stats.pixels, 0, "{triangle:?}");
    }
}

#[test]
fn planes_are_within_their_bound_at_every_covered_centre_of_any_triangle() {
    let whole = Rect::from_size(SIZE);
    let (mut worst, mut i, mut compared) = (0.0_f64, 0, 0_u64);
    let wanted = cases(250_000, 20_000_000);
    random("planes are within their bound", wanted, 35, |random| {
        i += 1;
        let shaded = if i % 4 == 0 { sliver(random) } else { any_triangle(random, i % 10) };
        let Some(triangle) = Triangle::new(shaded.map(|(v, _)| v), SIZE) else { return 1 };
        let corners = *triangle.vertices();
        let values = corners.map(|v| v.z);
        let plane = Gradients::new(&triangle).plane(values[0], values[1], values[2]);
        let oriented = corners.map(|v| (v, Color::default()));
        for (y, row) in spans(&triangle, whole).into_iter().enumerate() {
            // The first, the last and one between them say what all do: a plane has no others.
            let (first, last) = (row.trailing_zeros(), 31_u32.saturating_sub(row.leading_zeros()));
            for x in [first, (first + last) / 2, last] {
                if row >> (x & 31) & 1 == 0 || row == 0 {
                    continue;
                }
                let (x, y) = (x as i32, y as i32);
                // A 16.16 number modulo 2^32: off by how much, either way round.
                let value = exact(&oriented, |corner| corner.0.z.into(), x, y) * 65_536.0;
                let off = f64::from(plane.at(x, y).wrapping_sub(value as u32) as i32) / 65_536.0;
                worst = worst.max(off.abs());
                compared += 1;
                assert!(off.abs() <= PLANE, "{off} off {value} at {x}, {y}: {triangle:?}");
            }
        }
        1
    });
    println!("planes are off by {worst:.4} at most, of {compared}");
    assert!(compared >= 5 * i as u64, "only {compared} pixels were compared");
}
