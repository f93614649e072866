//! Points of any size and what is known of their pixels, and lines and points of meshes.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "pixels of a small picture"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::texture::{Rgba5551, Sampler, Texture};
use microraster::{
    Always, Camera, Color, Consecutive, Corner, Cull, Cutout, DrawContext, Flat, Frame, Indices,
    Less, LineList, LineLoop, LineStrip, Mesh, Pass, PointCoordinates, Points, Rect, Rgb, Rgb565,
    Rgba8888, ScreenPass, Shader, Size, SizeOf, Sprite, Stats, Thin, VertexInput, Wide,
};
use support::{any_corner, Random};

const SIZE: Size = Size::new(32, 32);
const PIXELS: usize = 32 * 32;

/// The pixels that are set, and what was counted.
fn drawn(
    draw: impl FnOnce(&mut Frame<'_, Rgba8888>, &mut Stats),
) -> (Vec<(i32, i32)>, Vec<u32>, Stats) {
    let (mut pixels, mut stats) = (vec![0; PIXELS], Stats::default());
    draw(&mut Frame::new(&mut pixels, SIZE).expect("the buffer fits"), &mut stats);
    let came = stats.triangles + stats.lines + stats.points;
    let went = stats.culled + stats.degenerate + stats.outside + stats.skipped + stats.drawn;
    assert_eq!(came, went, "everything became something");
    let set = pixels.iter().enumerate().filter(|(_, word)| **word != 0);
    let set = set.map(|(i, _)| (i as i32 % 32, i as i32 / 32)).collect();
    (set, pixels, stats)
}

/// Shows point coordinates: s in red, t in green, t from below in blue.
struct Coordinates;

impl Shader for Coordinates {
    type Vertex = ();
    type Varying = PointCoordinates;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> Corner<PointCoordinates> {}

    fn fragment(&self, _: &Self::Prepared, at: &PointCoordinates) -> Option<Color> {
        let byte = |v: i32| {
            assert!((0..=PointCoordinates::ONE).contains(&v), "in range: {v}");
            (v >> 20).clamp(0, 255) as u8
        };
        Some(Color::new(byte(at.s()), byte(at.t()), byte(at.t_from_below())))
    }
}

#[test]
fn point_coordinates_are_those_of_the_formula() {
    let mut random = Random(51);
    let mut tested = 0;
    for i in 0..20_000 {
        let v = any_corner(&mut random, [0, 1, 2, 3, 6][i % 5], SIZE);
        let size = [1, 2, 3, 8, random.range(1, 256), 256][i % 6];
        let (set, pixels, _) = drawn(|frame, stats| {
            let mut pass = ScreenPass::new().count(stats);
            pass.points(frame, &Coordinates, size as u16, &[(v, ())]);
        });
        let s =
            |at: i32, v: i32| 0.5 + (f64::from(at) + 0.5 - f64::from(v) / 16.0) / f64::from(size);
        for (x, y) in set {
            let [red, green, blue, _] = pixels[(y * 32 + x) as usize].to_le_bytes();
            let (s, t) = (s(x, v.x.to_bits()), s(y, v.y.to_bits()));
            for (got, exact) in [(red, s), (green, t), (blue, 1.0 - t)] {
                // Cut off to eighths of a bit, and less than 2^-19 off.
                let error = exact * 256.0 - f64::from(got);
                assert!((-0.001..=1.001).contains(&error), "{error} at {x}, {y}: {v:?}, {size}");
            }
            tested += 1;
        }
    }
    assert!(tested > 100_000, "hardly tested: {tested}");
}

#[test]
fn odd_points_are_about_pixels_and_even_ones_about_corners() {
    let mut random = Random(52);
    for _ in 0..5_000 {
        let v = any_corner(&mut random, 0, SIZE);
        let size = random.range(1, 20);
        let (x, y) = (v.x.to_bits(), v.y.to_bits());
        if x % 16 == 0 || y % 16 == 0 || x % 16 == 8 || y % 16 == 8 {
            // OpenGL's older rule does not say on which side what lies in the middle is.
            continue;
        }
        // That rule: the pixel that holds the corner, or the pixel corner that is nearest.
        let first = |v: i32| {
            if size % 2 == 1 {
                v.div_euclid(16) - size / 2
            } else {
                (v + 8).div_euclid(16) - size / 2
            }
        };
        let (left, top) = (first(x), first(y));
        let (set, ..) = drawn(|frame, _| {
            let white = Rgb::WHITE.into();
            ScreenPass::new().points(frame, &Flat::colored(), size as u16, &[(v, white)]);
        });
        let square = Rect::new(left, top, left + size, top + size);
        let all = (0..32).flat_map(|y| (0..32).map(move |x| (x, y)));
        let expected: Vec<_> = all.filter(|&(x, y)| square.contains(x, y)).collect();
        assert_eq!(set, expected, "{v:?}, {size}");
    }
}

#[test]
fn scissors_bands_and_strides_change_no_bit_of_a_point() {
    let mut random = Random(53);
    for i in 0..2_000 {
        let v = any_corner(&mut random, 6, SIZE);
        let (v, size) = (ScreenVertex::new(v.x, v.y, 99), [1, random.range(1, 256)][i % 2] as u16);
        let draw = |scissors: &[Rect], stride: usize| {
            let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; stride * 32]);
            let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
            let mut frame =
                frame.with_depth_stride(&mut depth, stride as u32).expect("the buffer fits");
            for scissor in scissors {
                frame.set_scissor(*scissor);
                let mut pass = ScreenPass::new().depth(Always);
                pass.points(&mut frame, &Coordinates, size, &[(v, ())]);
            }
            let depth: Vec<u16> =
                depth.chunks(stride).flat_map(|row| row[..32].iter().copied()).collect();
            (pixels, depth)
        };
        let (x, y) = (random.range(0, 32), random.range(0, 32));
        let whole = draw(&[Rect::from_size(SIZE)], 32);
        let quarters = [
            Rect::new(0, 0, x, y),
            Rect::new(x, 0, 32, y),
            Rect::new(0, y, x, 32),
            Rect::new(x, y, 32, 32),
        ];
        assert!(whole == draw(&quarters, 32), "cut at {x}, {y}: {v:?}");
        assert!(whole == draw(&[Rect::from_size(SIZE)], 40), "another stride: {v:?}");
    }
}

/// Positions of which 512 are half the picture, so that a subpixel is two of them, and a camera that
/// leaves them where they are.
fn placed(positions: &[[i16; 3]]) -> Mesh<'_, Rgb> {
    static WHITE: [Rgb; 64] = [Rgb::WHITE; 64];
    let colors = &WHITE[..positions.len()];
    Mesh::new(positions, colors).placed(Vec3::splat(1.0 / 512.0), Vec3::new(0.0, 0.0, 0.5))
}

/// Where such a position is on the screen.
fn on_screen([x, y, _]: [i16; 3]) -> ScreenVertex {
    ScreenVertex::from_bits(256 + i32::from(x) / 2, 256 - i32::from(y) / 2, 0)
}

/// Positions with whole subpixels, in the picture or around it.
fn any_positions(random: &mut Random, count: usize) -> Vec<[i16; 3]> {
    let reach = [260, 600][random.range(0, 1) as usize];
    let mut v = || (2 * random.range(-reach, reach)) as i16;
    (0..count).map(|_| [v(), v(), 0]).collect()
}

fn white(v: ScreenVertex) -> (ScreenVertex, Color) {
    (v, Rgb::WHITE.into())
}

#[test]
fn lines_of_meshes_are_those_between_their_corners_on_the_screen() {
    let mut random = Random(54);
    let camera = Camera::custom(Mat4::identity());
    let shader = Flat::colored();
    for i in 0..3_000 {
        let positions = any_positions(&mut random, 6);
        let indices: Vec<u8> = (0..8).map(|_| random.range(0, 5) as u8).collect();
        let mesh = placed(&positions);
        let width = [1, 6][i % 2];
        let (mesh_lines, expected): (_, Vec<[usize; 2]>) = match i % 4 {
            0 => {
                let mesh = mesh.with_topology(LineStrip::new(Consecutive::new(6)));
                let found = drawn(|frame, stats| {
                    let mut pass = Pass::new(&camera).count(stats);
                    pass.draw_lines(frame, &Mat4::identity(), &mesh, &shader, Wide(width));
                });
                (found, (1..6).map(|i| [i - 1, i]).collect())
            }
            1 => {
                let mesh = mesh.with_topology(LineList::new(Indices::new(&indices)));
                let found = drawn(|frame, stats| {
                    let mut pass = Pass::new(&camera).count(stats);
                    pass.draw_lines(frame, &Mat4::identity(), &mesh, &shader, Wide(width));
                });
                let pairs = indices.chunks_exact(2);
                (found, pairs.map(|p| [p[0].into(), p[1].into()]).collect())
            }
            _ => {
                let mesh = mesh.with_topology(LineLoop::new(Indices::new(&indices)));
                let found = drawn(|frame, stats| {
                    let mut pass = Pass::new(&camera).count(stats);
                    pass.draw_lines(frame, &Mat4::identity(), &mesh, &shader, Wide(width));
                });
                let pairs = (0..8).map(|i| [indices[i].into(), indices[(i + 1) % 8].into()]);
                (found, pairs.collect())
            }
        };
        let lines: Vec<_> =
            expected.iter().map(|line| line.map(|i| white(on_screen(positions[i])))).collect();
        let (set, _, stats) = drawn(|frame, stats| {
            ScreenPass::new().count(stats).lines(frame, &shader, Wide(width), &lines);
        });
        assert_eq!(mesh_lines.0, set, "{positions:?}");
        assert_eq!(mesh_lines.2, stats, "{positions:?}");
    }
}

#[test]
fn lines_are_cut_at_the_guard_box_and_at_the_near_plane_where_they_run() {
    let mut random = Random(55);
    let mut cut = [0, 0];
    for i in 0..4_000 {
        let mut number = |reach: f64| (random.unit() * 2.0 - 1.0) * reach;
        // From far beside the view, or from behind the eye, through what is seen.
        let behind = i % 2 == 1;
        let (a, b) = if behind {
            let (from, to) = (-2.1 + number(2.0), 1.2 + number(0.8));
            ([number(4.0), number(4.0), from], [number(0.8) * to, number(0.8) * to, to])
        } else {
            let (a, seen) = ([number(480.0), number(480.0)], [number(0.8), number(0.8)]);
            let further = 1.0 + number(0.9).abs();
            let b = [0, 1].map(|k| a[k] + (seen[k] - a[k]) * further);
            ([a[0], a[1], 1.0], [b[0], b[1], 1.0])
        };
        let scale = f64::from(1 << 20);
        let word = |[x, y, w]: [f64; 3]| [x, y, w / 8.0, w].map(|v| (v * scale) as i32);
        let ends = [word(a), word(b)];
        let mesh = Mesh::new(&[], &ends).with_topology(LineList::new(Consecutive::new(2)));
        let camera = Camera::custom(Mat4::identity());
        let (set, _, stats) = drawn(|frame, stats| {
            let mut pass = Pass::new(&camera).count(stats);
            pass.draw_lines(frame, &Mat4::identity(), &mesh, &support::InClipSpace, Thin);
        });
        assert_eq!(stats.skipped, 0, "in range");
        // What is seen of the line is drawn.
        let [a, b] = ends.map(|v| v.map(f64::from));
        let is_near = |x: f64, y: f64, &(i, j): &(i32, i32)| {
            (f64::from(i) + 0.5 - x).abs().max((f64::from(j) + 0.5 - y).abs()) <= 1.1
        };
        let mut samples = 0;
        for k in 0..20_000 {
            // Dense towards the last corner, and not at the very end, which is half a pixel short.
            let t = 1.0 - (f64::from(k) / 20_000.0).powi(4);
            let [x, y, _, w] = [0, 1, 2, 3].map(|i| a[i] + (b[i] - a[i]) * t);
            let [x, y] = [(x / w + 1.0) * 16.0, (1.0 - y / w) * 16.0];
            let end = [(b[0] / b[3] + 1.0) * 16.0, (1.0 - b[1] / b[3]) * 16.0];
            let is_end = (x - end[0]).abs().max((y - end[1]).abs()) < 1.0;
            if w > 0.0 && (0.5..31.5).contains(&x) && (0.5..31.5).contains(&y) && !is_end {
                samples += 1;
                assert!(set.iter().any(|p| is_near(x, y, p)), "not at {x}, {y}: {ends:?}");
            }
        }
        // And nothing else is: half a pixel on the longer side's columns, and rounding.
        let line =
            [a[1] * b[3] - a[3] * b[1], a[3] * b[0] - a[0] * b[3], a[0] * b[1] - a[1] * b[0]];
        for &(i, j) in &set {
            let (x, y) = ((f64::from(i) + 0.5) / 16.0 - 1.0, 1.0 - (f64::from(j) + 0.5) / 16.0);
            let steeper = line[0].abs().max(line[1].abs());
            let distance = (line[0] * x + line[1] * y + line[2]).abs() / steeper * 16.0;
            assert!(distance <= 0.5 + 0.13, "{distance} at {i}, {j}: {ends:?}");
        }
        cut[usize::from(behind)] += usize::from(samples > 10 && set.len() > 3);
    }
    assert!(cut.iter().all(|cut| *cut > 1_000), "hardly tested: {cut:?}");
}

#[test]
fn wireframes_and_corners_are_those_of_the_triangles_that_are_not_culled() {
    let mut random = Random(56);
    let camera = Camera::custom(Mat4::identity());
    let shader = Flat::colored();
    let (mut shown, mut hidden) = (0, 0);
    for i in 0..3_000 {
        let positions = any_positions(&mut random, 9);
        let mesh = placed(&positions);
        let cull = [Cull::None, Cull::Back, Cull::Front][i % 3];
        let corners: Vec<ScreenVertex> = positions.iter().map(|p| on_screen(*p)).collect();
        let (mut lines, mut points) = (Vec::new(), Vec::new());
        for t in corners.chunks_exact(3) {
            let at = |i: usize| (i64::from(t[i].x.to_bits()), i64::from(t[i].y.to_bits()));
            let ((ax, ay), (bx, by), (cx, cy)) = (at(0), at(1), at(2));
            let area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
            // Positive areas run clockwise on the screen: they show their backs.
            let left_out = match cull {
                Cull::None => area == 0,
                Cull::Back => area >= 0,
                Cull::Front => area <= 0,
            };
            if left_out {
                hidden += 1;
                continue;
            }
            shown += 1;
            lines.extend([[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]].map(|line| line.map(white)));
            points.extend([t[0], t[1], t[2]].map(white));
        }
        let edges = drawn(|frame, stats| {
            let mut pass = Pass::new(&camera).cull(cull).count(stats);
            pass.draw_wireframe(frame, &Mat4::identity(), &mesh, &shader, Thin);
        });
        let expected = drawn(|frame, stats| {
            ScreenPass::new().count(stats).lines(frame, &shader, Thin, &lines);
        });
        assert_eq!((edges.0, edges.2.pixels), (expected.0, expected.2.pixels), "{positions:?}");
        let dots = drawn(|frame, stats| {
            let mut pass = Pass::new(&camera).cull(cull).count(stats);
            pass.draw_corners(frame, &Mat4::identity(), &mesh, &shader, &3);
        });
        let expected = drawn(|frame, stats| {
            ScreenPass::new().count(stats).points(frame, &shader, 3, &points);
        });
        assert_eq!((dots.0, dots.2.pixels), (expected.0, expected.2.pixels), "{positions:?}");
    }
    assert!(shown > 2_000 && hidden > 2_000, "hardly tested: {shown}, {hidden}");
}

#[test]
fn points_of_meshes_reach_into_the_view_from_beside_it() {
    let mut random = Random(57);
    let camera = Camera::custom(Mat4::identity());
    let (mut beside, mut far) = (0, 0);
    for i in 0..6_000 {
        // Up to 64 times the picture beside it.
        let reach = [300, 700, 16_000][i % 3];
        let mut v = || (2 * random.range(-reach, reach)) as i16;
        let position = [v(), v(), 0];
        let size = random.range(0, 4096) as u32 >> random.range(0, 9);
        let positions = [position];
        let mesh = placed(&positions).with_topology(Points::new(Consecutive::new(1)));
        let (set, _, stats) = drawn(|frame, stats| {
            let mut pass = Pass::new(&camera).count(stats);
            let size = SizeOf(|_: VertexInput<'_, Rgb>, _| size);
            pass.draw_points(frame, &Mat4::identity(), &mesh, &Flat::colored(), &size);
        });
        let corner = on_screen(position);
        let within = |at: i32, v: i32| {
            let (at, v, size) = (i64::from(32 * at + 16), i64::from(2 * v), i64::from(size));
            v - size <= at && at < v + size
        };
        let all = (0..32).flat_map(|y| (0..32).map(move |x| (x, y)));
        let expected: Vec<_> = all
            .filter(|&(x, y)| within(x, corner.x.to_bits()) && within(y, corner.y.to_bits()))
            .collect();
        assert_eq!(set, expected, "{position:?}, {size}");
        let is_beside = position.iter().any(|v| v.unsigned_abs() > 512);
        beside += usize::from(is_beside && !set.is_empty());
        far += stats.outside;
    }
    assert!(beside > 300 && far > 1_000, "hardly tested: {beside}, {far}");
}

/// Positions whose unit is half the picture.
fn in_512ths<'a>(positions: &'a [[i16; 3]], colors: &'a [Rgb]) -> Mesh<'a, Rgb> {
    Mesh::new(positions, colors).placed(Vec3::new(1.0 / 512.0, 1.0 / 512.0, 1.0), Vec3::ZERO)
}

#[test]
fn points_take_attributes_by_vertex_or_by_number_and_what_is_missing_is_skipped() {
    let mut random = Random(58);
    let camera = Camera::custom(Mat4::identity());
    let (mut shown, mut skipped) = (0, 0);
    for round in 0..2_000 {
        let mut any = |most| random.range(0, most) as usize;
        let mut v = || (16 * any(64)) as i16 - 512;
        let positions: Vec<[i16; 3]> = (0..8).map(|_| [v(), v(), 0]).collect();
        let colors: Vec<_> = (1..9).map(|i| Rgb::new(i, 2 * i, 3 * i)).collect();
        let (positions, colors) = (&positions[..any(8)], &colors[..any(8)]);
        let indices: Vec<u8> = (0..10).map(|_| any(9) as u8).collect();
        let by_face = round % 2 == 0;
        let (_, pixels, stats) = drawn(|frame, stats| {
            let mesh = in_512ths(positions, colors);
            let mesh = mesh.with_topology(Points::new(Indices::new(&indices)));
            let mesh = if by_face { mesh.by_face() } else { mesh };
            let mut pass = Pass::new(&camera).count(stats);
            pass.draw_points(frame, &Mat4::identity(), &mesh, &Flat::colored(), &2);
        });
        // Each alone, of one position and one colour.
        let mut missing = 0;
        let (_, expected, alone) = drawn(|frame, stats| {
            for (number, index) in indices.iter().enumerate() {
                let at = usize::from(*index);
                let color = colors.get(if by_face { number } else { at });
                let (Some(position), Some(color)) = (positions.get(at), color) else {
                    missing += 1;
                    continue;
                };
                let (position, color) = ([*position], [*color]);
                let mesh = in_512ths(&position, &color);
                let mesh = mesh.with_topology(Points::new(Consecutive::new(1)));
                let mut pass = Pass::new(&camera).count(&mut *stats);
                pass.draw_points(frame, &Mat4::identity(), &mesh, &Flat::colored(), &2);
            }
        });
        assert_eq!(pixels, expected, "{positions:?} {colors:?} {indices:?} {by_face}");
        assert_eq!((stats.skipped, stats.drawn), (missing, alone.drawn), "{indices:?}");
        shown += alone.drawn;
        skipped += missing;
    }
    assert!(shown > 2_000 && skipped > 2_000, "hardly tested: {shown}, {skipped}");
}

#[test]
fn a_sprite_shows_its_texture_whole_and_a_cutout_leaves_its_holes_alone() {
    // Four texels of 5551: red, a hole, blue, green.
    static TEXELS: [u16; 4] = [0xF801, 0x0000, 0x003F, 0x07C1];
    let texture = Texture::<Rgba5551>::new(&TEXELS, 2, 2).expect("four texels");
    let sprite = Cutout::new(Sprite::new(Sampler::nearest(texture).expect("powers of two")), 128);
    let (mut pixels, mut codes) = ([0x1234_u16; 100], [7_u16; 100]);
    let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(10, 10));
    let mut frame = frame.and_then(|frame| frame.with_depth(&mut codes)).expect("buffers fit");
    // Six pixels about (5, 5): columns and rows 2 to 7.
    let point = (ScreenVertex::from_bits(80, 80, 900), ());
    let shader: Cutout<Sprite<_>> = sprite;
    ScreenPass::new().depth(Less).points(&mut frame, &shader, 6, &[point]);
    for (i, (pixel, code)) in pixels.iter().zip(codes).enumerate() {
        let (x, y) = (i % 10, i / 10);
        let inside = (2..8).contains(&x) && (2..8).contains(&y);
        let texel = [0xF800, 0x1234, 0x001F, 0x07E0][usize::from(x >= 5) + 2 * usize::from(y >= 5)];
        let expected =
            if inside { (texel, if texel == 0x1234 { 7 } else { 900 }) } else { (0x1234, 7) };
        assert_eq!((*pixel, code), expected, "pixel {x}, {y}");
    }
}

/// A viewport of which the frame, or the band, holds nothing: every point is beside it.
#[test]
fn points_of_a_viewport_that_the_frame_does_not_hold_are_outside() {
    let positions = [[0; 3]; 5];
    let mesh = Mesh::new(&positions, &[Rgb::WHITE; 5]);
    let mesh = mesh.with_topology(Points::new(Consecutive::new(5)));
    let camera = Camera::perspective(60.0.degrees(), 0.1);
    let model = Mat4::translation(Vec3::new(0.0, 0.0, -2.0));
    for viewport in [(200, 0, 264, 48), (-90, 0, -20, 48), (0, 60, 64, 90), (0, -64, 64, 0)] {
        let (left, top, right, bottom) = viewport;
        for size in [0, 1, 16, 600, 4096] {
            let (mut pixels, mut stats) = ([0_u16; 64 * 24], Stats::default());
            let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(64, 24));
            let mut frame = frame.and_then(|frame| frame.band(24, 48)).expect("the lower half");
            let of = |size: u32| SizeOf(move |_: VertexInput<'_, Rgb>, _: u16| size);
            Pass::new(&camera)
                .viewport(Rect::new(left, top, right, bottom))
                .count(&mut stats)
                .draw_points(&mut frame, &model, &mesh, &Flat::colored(), &of(size));
            assert_eq!((stats.points, stats.outside), (5, 5), "{viewport:?}, {size}: {stats:?}");
            assert!(pixels.iter().all(|pixel| *pixel == 0), "{viewport:?}, {size}");
        }
    }
}
