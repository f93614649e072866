//! Triangles that are cut: at the guard box, at the near plane, and what is made of their corners.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small pictures and random numbers"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::{
    Camera, Color, Cull, DrawContext, Flat, FlatColor, Frame, Gouraud, Mesh, Pass, Rgb, Rgba8888,
    Shader, Size, SmoothColor, Stats, VertexInput, MAX_SIDE,
};
use support::{InClipSpace, Random};

/// The colours of a picture, and what was counted.
fn drawn(size: Size, draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats)) -> (Vec<u32>, Stats) {
    let mut pixels = vec![0; usize::from(size.width) * usize::from(size.height)];
    let mut stats = Stats::default();
    draw(&mut Frame::new(&mut pixels, size).expect("the buffer fits"), &mut stats);
    (pixels, stats)
}

/// Two triangles from corner to corner.
static SQUARE: [[i16; 3]; 6] =
    [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, -1, 0], [1, 1, 0], [-1, 1, 0]];

#[test]
fn a_square_over_the_whole_view_covers_every_pixel_of_the_longest_pictures() {
    let sizes = [(8192, 1), (8191, 1), (8190, 3), (1, 8192), (2, 8191), (320, 240)];
    for (width, height) in sizes {
        assert!(width.max(height) <= MAX_SIDE, "a picture that there may be");
        let size = Size::new(width, height);
        // As large as the view, a little larger, and far beyond the guard box.
        for scale in [1.0, 1.01, 3.0, 300.0] {
            let mesh = Mesh::new(&SQUARE, &[Rgb::WHITE; 6])
                .placed(Vec3::splat(scale), Vec3::new(0.0, 0.0, 0.5));
            let camera = Camera::custom(Mat4::identity());
            let (pixels, stats) = drawn(size, |frame, stats| {
                let mut pass = Pass::new(&camera).count(stats);
                pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
            });
            let missing = pixels.iter().filter(|pixel| **pixel == 0).count();
            assert_eq!(missing, 0, "{width}x{height}, {scale} times the view");
            assert_eq!(stats.pixels as usize, pixels.len(), "{width}x{height}: a pixel twice");
        }
    }
}

/// A random triangle far larger than the view of [`wide_lens`], and its corners' colours.
fn wide_triangle(random: &mut Random) -> ([[i16; 3]; 3], [Rgb; 3]) {
    let mut place = || random.range(-32_000, 32_000) as i16;
    let corners = [(); 3].map(|()| [place(), place(), place()]);
    let mut channel = || random.next() as u8;
    (corners, [(); 3].map(|()| Rgb::new(channel(), channel(), channel())))
}

const WIDE: Size = Size::new(64, 48);
/// From the middle to the farthest that a position reaches, in halves of the view's height.
const REACH: f32 = 200.0;

/// Sees the middle of what [`wide_triangle`] makes, all of its depth, without perspective.
fn wide_lens() -> Camera {
    Camera::orthographic(2.0, -1.01 * REACH, 1.01 * REACH)
}

fn wide_mesh<'a>(corners: &'a [[i16; 3]], colors: &'a [Rgb]) -> Mesh<'a, Rgb> {
    Mesh::new(corners, colors).placed(Vec3::splat(REACH / 32_000.0), Vec3::ZERO)
}

/// Where such positions lie in the picture, in pixels.
fn on_screen(corners: [[i16; 3]; 3]) -> [(f64, f64); 3] {
    corners.map(|[x, y, _]| {
        let [x, y] = [x, y].map(|v| f64::from(v) * f64::from(REACH) / 32_000.0);
        (32.0 + 24.0 * x, 24.0 - 24.0 * y)
    })
}

#[test]
fn colours_of_triangles_cut_at_the_guard_box_are_those_of_the_whole_triangle() {
    let mut random = Random(51);
    let (mut clipped, mut compared) = (0, 0);
    for _ in 0..3_000 {
        let (corners, colors) = wide_triangle(&mut random);
        let camera = wide_lens();
        let (pixels, stats) = drawn(WIDE, |frame, stats| {
            let mut pass = Pass::new(&camera).count(stats);
            let mesh = wide_mesh(&corners, &colors);
            pass.draw(frame, &Mat4::identity(), &mesh, &Gouraud::colored());
        });
        let [a, b, c] = on_screen(corners);
        let area_to = |a: (f64, f64), b: (f64, f64), p: (f64, f64)| {
            (b.0 - a.0) * (p.1 - a.1) - (b.1 - a.1) * (p.0 - a.0)
        };
        let area = area_to(a, b, c);
        // Colours of thin ones change too much within the sixteenth by which an edge may move.
        if area.abs() < 4e6 {
            continue;
        }
        clipped += stats.clipped;
        for (i, pixel) in pixels.iter().enumerate().filter(|(_, pixel)| **pixel != 0) {
            let p = ((i % 64) as f64 + 0.5, (i / 64) as f64 + 0.5);
            let weights = [area_to(b, c, p), area_to(c, a, p), area_to(a, b, p)];
            for (channel, got) in pixel.to_le_bytes().into_iter().take(3).enumerate() {
                let of = |color: Rgb| f64::from([color.r, color.g, color.b][channel]);
                let sum: f64 = colors.iter().zip(weights).map(|(c, w)| of(*c) * w / area).sum();
                // Half a step of rounding, a quarter of the planes' own, and corners that are off
                // by 2^-15 of what the mesh reaches, where a colour changes by one step a pixel.
                let off = (sum - f64::from(got)).abs();
                assert!(off <= 1.0, "{got} for {sum}: {corners:?}, {colors:?}");
                compared += 1;
            }
        }
    }
    assert!(clipped > 1_000 && compared > 1_000_000, "{clipped} clipped, {compared} compared");
}

/// A flat colour beside one that is interpolated: all corners are shaded, and the first one counts.
struct FlatBesideSmooth;

impl Shader for FlatBesideSmooth {
    type Vertex = Rgb;
    type Varying = (FlatColor, SmoothColor);
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), vertex: VertexInput<'_, Rgb>) -> (Color, Color) {
        ((*vertex.attributes).into(), Rgb::WHITE.into())
    }

    fn fragment(&self, _: &Self::Prepared, (flat, _): &(FlatColor, SmoothColor)) -> Option<Color> {
        Some(flat.color())
    }
}

#[test]
fn a_flat_triangle_that_is_cut_has_the_colour_of_its_first_corner() {
    let mut random = Random(52);
    let near = Camera::perspective(60.0.degrees(), 0.5);
    let guard = wide_lens();
    let mut covered = [0; 2];
    for _ in 0..2_000 {
        let (corners, colors) = wide_triangle(&mut random);
        let expected = u32::from_le_bytes([colors[0].r, colors[0].g, colors[0].b, 255]);
        for (camera, covered) in [&near, &guard].into_iter().zip(&mut covered) {
            let mesh = wide_mesh(&corners, &colors);
            let (pixels, stats) = drawn(WIDE, |frame, stats| {
                let mut pass = Pass::new(camera).count(stats);
                pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
            });
            let (beside, _) = drawn(WIDE, |frame, stats| {
                let mut pass = Pass::new(camera).count(stats);
                pass.draw(frame, &Mat4::identity(), &mesh, &FlatBesideSmooth);
            });
            assert!(pixels == beside, "{corners:?}, {colors:?}");
            let set = pixels.iter().filter(|pixel| **pixel != 0);
            assert!(set.clone().all(|pixel| *pixel == expected), "{corners:?}, {colors:?}");
            *covered += u32::from(stats.clipped == 1) * stats.pixels;
        }
    }
    assert!(covered.iter().all(|pixels| *pixels > 100_000), "hardly tested: {covered:?}");
}

#[test]
fn both_sides_of_a_triangle_that_is_cut_are_told_apart() {
    let mut random = Random(53);
    let camera = wide_lens();
    let mut clipped = 0;
    for _ in 0..1_000 {
        let (corners, colors) = wide_triangle(&mut random);
        let count = |cull: Cull| {
            let (_, stats) = drawn(WIDE, |frame, stats| {
                let mut pass = Pass::new(&camera).cull(cull).count(stats);
                let mesh = wide_mesh(&corners, &colors);
                pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
            });
            stats
        };
        let (all, front, back) = (count(Cull::None), count(Cull::Back), count(Cull::Front));
        assert_eq!(all.pixels, front.pixels + back.pixels, "{corners:?}");
        let [a, b, c] = on_screen(corners);
        let clockwise = (b.0 - a.0) * (c.1 - a.1) > (b.1 - a.1) * (c.0 - a.0);
        let shown = if clockwise { back } else { front };
        assert_eq!(shown.pixels, all.pixels, "{corners:?}");
        clipped += all.clipped;
    }
    assert!(clipped > 300, "hardly tested: {clipped}");
}

#[test]
fn a_polygon_that_rounding_makes_concave_covers_no_pixel_twice() {
    // Small w and corners far out: cuts are rounded to whole units there, which are up to pixels.
    let mut random = Random(54);
    let (mut clipped, mut filled) = (0, 0);
    for _ in 0..400_000 {
        let mut corner = || {
            let w = 1 << random.range(4, 20);
            let mut side = |half: i32| {
                let reach = 1 << random.range(0, 14);
                let far = (i64::from(w) * reach / i64::from(half)).clamp(1, (1 << 30) - 1) as i32;
                random.range(-far, far)
            };
            let (x, y) = (side(32), side(24));
            // Half of them may be behind the near plane or the eye.
            [x, y, w / 2, w - random.range(0, 1) * random.range(0, 2 * w)]
        };
        let triangle = [corner(), corner(), corner()];
        let camera = Camera::custom(Mat4::identity());
        let (pixels, stats) = drawn(WIDE, |frame, stats| {
            let mut pass = Pass::new(&camera).count(stats);
            pass.draw(frame, &Mat4::identity(), &Mesh::new(&[], &triangle), &InClipSpace);
        });
        let set = pixels.iter().filter(|pixel| **pixel != 0).count();
        // What shows as a line only is so thin that it may be concave at both ends: about all of
        // its corners some triangles overlap.
        if set > 128 {
            assert_eq!(stats.pixels as usize, set, "a pixel twice: {triangle:?}");
        }
        clipped += stats.clipped;
        filled += usize::from(stats.clipped > 0 && set > 128);
    }
    assert!(clipped > 100_000 && filled > 30_000, "{clipped} clipped, {filled} seen");
}
