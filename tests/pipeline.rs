//! From meshes to the screen: positions, depth, what is left out, and input that makes no sense.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::models::TEAPOT;
#[cfg(feature = "std")]
use microraster::raster::AnyTraversal;
use microraster::raster::ScreenVertex;
use microraster::{
    AnyDepth, Camera, Clip, Color, Corner, Cull, DrawContext, Flat, FlatColor, Frame, FrameError,
    Gouraud, Less, LessEqual, Light, Mesh, Off, Pass, Rect, Rgb, Rgb565, Rgba8888, Scalar,
    ScreenPass, Shader, Size, SmoothColor, Stats, Topology, VertexCache, VertexInput,
};
use support::{InClipSpace, Random};

const SIZE: Size = Size::new(64, 48);
const PIXELS: usize = 64 * 48;

fn camera() -> Camera {
    Camera::perspective(45.0.degrees(), 0.5).look_at(Vec3::new(0.0, 2.4, 5.4), Vec3::ZERO, Vec3::Y)
}

fn sun() -> Light {
    Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)
}

/// The teapot as one draws it, and what was counted.
fn teapot(cache: impl FnOnce(&mut Frame<'_, Rgba8888, microraster::DepthBuffer<'_>>)) -> Vec<u32> {
    let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
    let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
    frame.clear(Rgb::BLACK);
    cache(&mut frame);
    pixels
}

#[test]
fn small_caches_give_the_same_picture_of_vertices_that_take_each_others_slots() {
    fn with<const N: usize>(
        mesh: &Mesh<'_, Rgb, impl Topology<Primitive = [u32; 3]>>,
    ) -> [(Vec<u16>, Stats); 2] {
        let camera = Camera::perspective(45.0.degrees(), 0.5);
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -1.5));
        [true, false].map(|is_flat| {
            let (mut pixels, mut stats) = (vec![0; PIXELS], Stats::default());
            let mut frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("the buffer fits");
            let mut pass = Pass::new(&camera).count(&mut stats);
            if is_flat {
                let mut cache = VertexCache::<Corner<FlatColor>, N>::new();
                pass.draw_cached(&mut frame, &model, mesh, &Flat::colored(), &mut cache);
            } else {
                let mut cache = VertexCache::<Corner<SmoothColor>, N>::new();
                pass.draw_cached(&mut frame, &model, mesh, &Gouraud::colored(), &mut cache);
            }
            (pixels, stats)
        })
    }
    let (mut random, mut drawn, mut skipped) = (Random(61), 0, 0);
    for _ in 0..500 {
        // Some lie behind the eye, some have no attributes, and some indices no vertex.
        let positions: Vec<[i16; 3]> =
            (0..9).map(|_| [(); 3].map(|()| (random.next() as i16) >> 14)).collect();
        let colors: Vec<Rgb> = (0..random.range(6, 9))
            .map(|_| Rgb::new(random.next() as u8, random.next() as u8, random.next() as u8))
            .collect();
        let indices: Vec<u16> = (0..60).map(|_| random.range(0, 9) as u16).collect();
        let mesh = Mesh::new(&positions, &colors).indexed(&indices);
        let expected = with::<64>(&mesh);
        assert!(with::<1>(&mesh) == expected, "one slot: {mesh:?}");
        assert!(with::<2>(&mesh) == expected, "two slots: {mesh:?}");
        assert!(with::<4>(&mesh) == expected, "four slots: {mesh:?}");
        let [(_, flat), (_, smooth)] = &expected;
        drawn += flat.drawn + smooth.drawn;
        skipped += flat.skipped + smooth.skipped;
    }
    assert!(drawn > 2000 && skipped > 2000, "{drawn} drawn, {skipped} skipped");
}

#[test]
fn caches_of_all_sizes_give_the_same_picture() {
    fn with<const N: usize>() -> Vec<u32> {
        teapot(|frame| {
            let mut cache = VertexCache::<Corner<SmoothColor>, N>::new();
            let (camera, shader) = (camera(), Gouraud::lit(&[sun()]));
            let mut pass = Pass::new(&camera).depth(Less);
            pass.draw_cached(frame, &Mat4::identity(), &TEAPOT, &shader, &mut cache);
            // Again, with what the last draw left in the cache.
            frame.clear(Rgb::BLACK);
            pass.draw_cached(frame, &Mat4::identity(), &TEAPOT, &shader, &mut cache);
        })
    }
    let one = with::<1>();
    assert!(one.iter().any(|word| *word & 0xFF_FFFF != 0), "a teapot");
    assert!(one == with::<2>() && one == with::<4>() && one == with::<32>(), "small caches");
    assert!(one == with::<256>() && one == with::<2048>(), "large caches");
}

#[test]
fn depth_tests_of_types_and_of_runtime_agree() {
    let draw = |any: Option<AnyDepth>| {
        teapot(|frame| {
            let (camera, shader) = (camera(), Gouraud::lit(&[sun()]));
            let pass = Pass::new(&camera);
            let model = Mat4::identity();
            match any {
                Some(any) => pass.depth(any).draw(frame, &model, &TEAPOT, &shader),
                None => pass.depth(LessEqual).draw(frame, &model, &TEAPOT, &shader),
            }
        })
    };
    assert!(draw(None) == draw(Some(AnyDepth::LessEqual)), "less or equal");
    let off = teapot(|frame| {
        let (camera, shader) = (camera(), Gouraud::lit(&[sun()]));
        Pass::new(&camera).depth(Off).draw(frame, &Mat4::identity(), &TEAPOT, &shader);
    });
    assert!(off == draw(Some(AnyDepth::Off)), "off");
    assert!(off != draw(None), "depth makes a difference");
}

#[cfg(feature = "std")]
#[test]
fn traversals_give_the_same_picture_through_a_pass() {
    let draw = |traversal: AnyTraversal| {
        teapot(|frame| {
            let (camera, shader) = (camera(), Gouraud::lit(&[sun()]));
            let mut pass = Pass::new(&camera).depth(Less).traversal(traversal);
            pass.draw(frame, &Mat4::identity(), &TEAPOT, &shader);
        })
    };
    let spans = draw(AnyTraversal::Spans);
    assert!(spans == draw(AnyTraversal::Box), "bounding box");
    assert!(spans == draw(AnyTraversal::Blocks), "blocks");
    assert!(spans == draw(AnyTraversal::Walk), "block walk");
}

#[test]
fn statistics_sum_up_and_ordinary_scenes_skip_nothing() {
    for cull in [Cull::None, Cull::Back, Cull::Front] {
        let mut stats = Stats::default();
        let pixels = teapot(|frame| {
            let camera = camera();
            let mut pass = Pass::new(&camera).cull(cull).count(&mut stats);
            pass.draw(frame, &Mat4::identity(), &TEAPOT, &Flat::lit(&[sun()]));
        });
        let Stats { triangles, culled, degenerate, outside, skipped, drawn, clipped, .. } = stats;
        assert_eq!((triangles, skipped, clipped), (992, 0, 0), "{cull:?}");
        assert_eq!(culled + degenerate + outside + drawn, 992, "{cull:?}");
        assert_eq!(culled > 0, cull != Cull::None, "{cull:?}");
        let set = pixels.iter().filter(|word| **word & 0xFF_FFFF != 0).count();
        assert!(stats.pixels as usize >= set && set > 300, "{cull:?}: {set} pixels");
    }
}

/// Draws a triangle with a mesh matrix; what was counted.
fn count(
    model: &Mat4,
    mesh: &Mesh<'_, Rgb, impl Topology<Primitive = [u32; 3]>>,
    camera: &Camera,
    viewport: Option<Rect>,
) -> Stats {
    let mut stats = Stats::default();
    teapot(|frame| {
        let mut pass = Pass::new(camera).depth(Less).count(&mut stats);
        if let Some(viewport) = viewport {
            pass = pass.viewport(viewport);
        }
        pass.draw(frame, model, mesh, &Gouraud::colored());
    });
    stats
}

static CORNERS: [[i16; 3]; 3] = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]];
static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];

#[test]
fn what_makes_no_sense_is_skipped_and_counted() {
    let camera = camera();
    let triangle = Mesh::new(&CORNERS, &COLORS);
    let good = count(&Mat4::identity(), &triangle, &camera, None);
    assert_eq!((good.triangles, good.drawn, good.skipped), (1, 1, 0), "a triangle");
    // Indices and attributes that are not there.
    let beyond: &[u16] = &[0, 1, 3, 0, 1, 2, 65_535, 0, 0, 1];
    let stats = count(&Mat4::identity(), &triangle.indexed(beyond), &camera, None);
    assert_eq!((stats.triangles, stats.drawn, stats.skipped), (3, 1, 2), "indices");
    let stats = count(&Mat4::identity(), &Mesh::new(&CORNERS, &COLORS[..2]), &camera, None);
    assert_eq!((stats.triangles, stats.skipped), (1, 1), "a colour is missing");
    let stats = count(&Mat4::identity(), &Mesh::new(&[], &[]), &camera, None);
    assert_eq!(stats, Stats::default(), "an empty mesh");
    // Matrices.
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX] {
        let stats = count(&Mat4::scale(Vec3::splat(bad)), &triangle, &camera, None);
        assert_eq!((stats.triangles, stats.skipped), (1, 1), "scaled by {bad}");
    }
    let flat = count(&Mat4::scale(Vec3::ZERO), &triangle, &camera, None);
    assert_eq!((flat.triangles, flat.drawn), (1, 0), "scaled by nothing");
    let nothing = Camera::custom(Mat4::from_rows(Vec4::ZERO, Vec4::ZERO, Vec4::ZERO, Vec4::ZERO));
    let stats = count(&Mat4::identity(), &triangle, &nothing, None);
    assert_eq!((stats.triangles, stats.drawn), (1, 0), "a projection of zeros");
    for near in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let camera = Camera::perspective(45.0.degrees(), near);
        let stats = count(&Mat4::identity(), &triangle, &camera, None);
        assert_eq!((stats.triangles, stats.drawn), (1, 0), "near {near}");
    }
    // Viewports.
    let viewports = [
        Rect::new(0, 0, 0, 10),
        Rect::new(5, 5, 1, 1),
        Rect::new(0, 0, 8193, 10),
        Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX),
        Rect::new(i32::MAX - 10, 0, i32::MAX, 10),
    ];
    for viewport in viewports {
        let stats = count(&Mat4::identity(), &triangle, &camera, Some(viewport));
        assert_eq!((stats.triangles, stats.drawn), (1, 0), "{viewport:?}");
    }
}

/// Cameras of every kind, each of which draws the triangle at the origin.
#[test]
fn the_last_index_of_32_bits_names_no_vertex() {
    // It is the number that an empty slot of the vertex cache holds.
    let (corners, colors) = ([[-9, -9, -5], [9, -9, -5], [0, 9, -5]], [Rgb::WHITE; 3]);
    for place in 0..3 {
        let mut indices = [0, 1, 2];
        indices[place] = u32::MAX;
        let mesh = Mesh::new(&corners, &colors).indexed(&indices);
        let mut stats = Stats::default();
        let camera = Camera::perspective(90.0.degrees(), 0.5);
        // A shader that asks for nothing of the corners but the first.
        teapot(|frame| {
            let mut pass = Pass::new(&camera).depth(Less).count(&mut stats);
            pass.draw(frame, &Mat4::identity(), &mesh, &Flat::colored());
        });
        assert_eq!((stats.triangles, stats.skipped, stats.pixels), (1, 1, 0), "{indices:?}");
    }
}

fn cameras() -> [(&'static str, Camera); 4] {
    let (eye, lens) = (Vec3::new(0.3, 0.4, 4.0), Camera::perspective(45.0.degrees(), 0.5));
    let projection = Mat4::perspective(50.0.degrees(), 1.25, 0.25, Some(20.0));
    [
        ("perspective", lens),
        ("far plane", lens.far(50.0)),
        ("orthographic", Camera::orthographic(4.0, 0.5, 20.0)),
        ("custom", Camera::custom(projection)),
    ]
    .map(|(name, camera)| (name, camera.look_at(eye, Vec3::ZERO, Vec3::Y)))
}

#[test]
fn a_matrix_that_is_not_finite_skips_all_triangles_whichever_element_it_is() {
    let corners: Vec<[i16; 3]> = CORNERS.iter().cycle().take(9).copied().collect();
    let colors: Vec<Rgb> = COLORS.iter().cycle().take(9).copied().collect();
    let mesh = Mesh::new(&corners, &colors);
    let model = Mat4::rotation_y(30.0.degrees());
    let spoilt = |matrix: Mat4, element: usize, bad: f32| {
        let mut columns = matrix.to_columns();
        columns[element / 4][element % 4] = bad;
        let [x, y, z, w] = columns.map(|[x, y, z, w]| Vec4::new(x, y, z, w));
        Mat4 { x, y, z, w }
    };
    for (name, camera) in cameras() {
        let good = count(&model, &mesh, &camera, None);
        assert_eq!((good.triangles, good.drawn), (3, 3), "{name}");
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            for element in 0..16 {
                let view = camera.with_view(spoilt(camera.view(), element, bad));
                let projection = Camera::custom(spoilt(camera.projection(1.25), element, bad))
                    .with_view(camera.view());
                let counts = [
                    ("model", count(&spoilt(model, element, bad), &mesh, &camera, None)),
                    ("view", count(&model, &mesh, &view, None)),
                    ("projection", count(&model, &mesh, &projection, None)),
                ];
                for (matrix, stats) in counts {
                    let what = format!("{name}: {bad} in element {element} of {matrix}");
                    assert_eq!((stats.triangles, stats.skipped), (3, 3), "{what}");
                    assert_eq!((stats.drawn, stats.clipped, stats.pixels), (0, 0, 0), "{what}");
                }
            }
        }
    }
}

#[test]
fn any_numbers_are_drawn_or_counted_and_never_panic() {
    let mut random = Random(41);
    let any = |random: &mut Random| {
        let v = random.next() as i32 >> random.range(2, 31);
        // Now and then one of the ends.
        let ends = [0, 1, -1, Clip::LIMIT - 1, 1 - Clip::LIMIT, i32::MIN];
        ends.get((random.next() % 60) as usize).copied().unwrap_or(v)
    };
    let (mut total, mut drawn) = (0, 0);
    for _ in 0..30_000 {
        let vertices = [(); 6].map(|()| [(); 4].map(|()| any(&mut random)));
        let mut stats = Stats::default();
        teapot(|frame| {
            let camera = Camera::custom(Mat4::identity());
            let mut pass = Pass::new(&camera).depth(LessEqual).count(&mut stats);
            pass.draw(frame, &Mat4::identity(), &Mesh::new(&[], &vertices), &InClipSpace);
        });
        let Stats { triangles, culled, degenerate, outside, skipped, .. } = stats;
        assert_eq!(triangles, 2, "two came in");
        assert_eq!(culled + degenerate + outside + skipped + stats.drawn, 2, "{vertices:?}");
        total += triangles;
        drawn += stats.drawn;
    }
    assert!(drawn * 50 > total, "hardly anything was drawn: {drawn} of {total}");
}

#[test]
fn matrices_of_any_bits_never_panic() {
    let mut random = Random(42);
    for i in 0..20_000 {
        let mut number = || {
            let bits = random.next() as u32;
            if i % 2 == 0 {
                f32::from_bits(bits)
            } else {
                (bits >> 8) as f32 * 1e-6 - 8.0
            }
        };
        let mut matrix = || {
            let mut row = || Vec4::new(number(), number(), number(), number());
            Mat4::from_rows(row(), row(), row(), row())
        };
        let camera = Camera::custom(matrix()).with_view(matrix());
        let stats = count(&matrix(), &Mesh::new(&CORNERS, &COLORS), &camera, None);
        assert_eq!(stats.triangles, 1, "one came in");
    }
}

#[test]
fn depth_codes_are_those_of_the_stated_mapping() {
    // A sheet across the view at some distance: one code all over, 2 + 65531 near / distance.
    static SHEET: [[i16; 3]; 3] = [[-30_000, -30_000, 0], [30_000, -30_000, 0], [0, 30_000, 0]];
    let mut random = Random(43);
    for _ in 0..2_000 {
        let near = 0.01 + random.unit() * 2.0;
        let distance = near * (1.02 + random.unit().powi(3) * 400.0);
        let scale = distance / 5_000.0;
        let camera = Camera::perspective(45.0.degrees(), near as f32);
        let mesh = Mesh::new(&SHEET, &COLORS)
            .placed(Vec3::splat(scale as f32), Vec3::new(0.0, 0.0, -distance as f32));
        let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
        let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
        frame.clear(Rgb::BLACK);
        let mut pass = Pass::new(&camera).depth(Less);
        pass.draw(&mut frame, &Mat4::identity(), &mesh, &Gouraud::colored());
        let code = f64::from(depth[24 * 64 + 32]);
        let exact = 2.0 + 65_531.0 * near / distance;
        // Mantissas of w are off by 2^-15 of what the mesh reaches at most, which is w here.
        let bound = 0.6 + exact * (3.0 / 32_768.0);
        assert!((code - exact).abs() <= bound, "{code} for {exact}: near {near}, {distance}");
    }
}

#[test]
fn a_scissor_that_lets_nothing_through_lies_within_the_frame() {
    let mut pixels = vec![7_u16; PIXELS];
    let frame = Frame::<Rgb565>::new(&mut pixels[..64 * 10], Size::new(64, 10));
    let mut frame = frame.and_then(|frame| frame.band(20, 48)).expect("the buffer fits");
    let nothing = [
        Rect::default(),
        Rect::new(30, 25, 10, 28),
        Rect::new(0, 29, 64, 21),
        Rect::new(0, 0, 64, 20),
        Rect::new(i32::MAX, i32::MAX, i32::MIN, i32::MIN),
        Rect::new(i32::MIN, i32::MIN, i32::MIN, i32::MAX),
    ];
    for rect in nothing {
        frame.set_scissor(rect);
        let Rect { left, top, right, bottom } = frame.scissor();
        assert!(frame.scissor().is_empty(), "{rect:?}");
        assert!((0..=64).contains(&left) && left == right, "columns of {rect:?}");
        assert!((20..=30).contains(&top) && top == bottom, "rows of {rect:?}");
        frame.clear(Rgb::WHITE);
    }
    frame.set_scissor(Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX));
    assert_eq!(frame.scissor(), Rect::new(0, 20, 64, 30), "everything");
    assert!(pixels.iter().all(|pixel| *pixel == 7), "nothing was cleared");
}

/// Draws every other pixel: where whole parts of column and row add up to an even number.
struct Chequered;

impl Shader for Chequered {
    type Vertex = (u16, u16);
    type Varying = (Scalar, Scalar);
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), vertex: VertexInput<'_, (u16, u16)>) -> (u16, u16) {
        *vertex.attributes
    }

    fn fragment(&self, _: &Self::Prepared, (x, y): &(Scalar, Scalar)) -> Option<Color> {
        (x.get() / 16 + y.get() / 16).is_multiple_of(2).then(|| Rgb::WHITE.into())
    }
}

#[test]
fn a_discarded_pixel_keeps_its_colour_and_its_depth_and_is_not_counted() {
    // Column and row in sixteenths at the corners of a triangle over the whole picture.
    let corner = |x: u16, y: u16| {
        let vertex = ScreenVertex::from_bits(16 * i32::from(x), 16 * i32::from(y), 30_000);
        (vertex, (16 * x, 16 * y))
    };
    let triangle = [corner(0, 0), corner(200, 0), corner(0, 200)];
    let (mut pixels, mut depth) = (vec![0_u32; PIXELS], vec![0_u16; PIXELS]);
    let mut stats = Stats::default();
    let frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
    frame.clear(Rgb::BLUE);
    // Nearer on the left.
    frame.set_scissor(Rect::new(0, 0, 20, 48));
    let nearer = triangle.map(|(v, _)| (ScreenVertex { z: 40_000, ..v }, Rgb::RED.into()));
    ScreenPass::new().depth(Less).triangle(&mut frame, &Gouraud::colored(), &nearer);
    frame.reset_scissor();
    ScreenPass::new().depth(Less).count(&mut stats).triangle(&mut frame, &Chequered, &triangle);
    let [red, blue] = [0xFF00_00FF_u32, 0xFFFF_0000];
    for (i, (pixel, code)) in pixels.iter().zip(&depth).enumerate() {
        let (x, y) = (i % 64, i / 64);
        let expected = match (x < 20, (x + y).is_multiple_of(2)) {
            (true, _) => (red, 40_000),
            (false, true) => (u32::MAX, 30_000),
            (false, false) => (blue, 0),
        };
        assert_eq!((*pixel, *code), expected, "pixel {x}, {y}");
    }
    assert_eq!(stats.pixels, 44 * 48 / 2, "what was kept");
    // Without depth, too.
    let mut pixels = vec![0_u32; PIXELS];
    let mut frame = Frame::<Rgba8888>::new(&mut pixels, SIZE).expect("the buffer fits");
    let mut stats = Stats::default();
    ScreenPass::new().count(&mut stats).triangle(&mut frame, &Chequered, &triangle);
    let kept = |i: usize| (i % 64 + i / 64).is_multiple_of(2);
    assert!(
        pixels.iter().enumerate().all(|(i, p)| *p == if kept(i) { u32::MAX } else { 0 }),
        "every other pixel"
    );
    assert_eq!(stats.pixels as usize, PIXELS / 2, "what was kept");
}

#[test]
fn buffers_that_do_not_fit_are_refused_with_what_was_needed() {
    let mut pixels = [0u16; 100];
    let mut frame = |width, height, stride| {
        Frame::<Rgb565>::with_stride(&mut pixels, Size::new(width, height), stride)
            .map(|frame| frame.size())
    };
    assert_eq!(frame(10, 10, 10), Ok(Size::new(10, 10)), "fits");
    assert_eq!(frame(8, 10, 10), Ok(Size::new(8, 10)), "fits with a gap");
    assert_eq!(frame(0, 10, 10), Err(FrameError::Empty), "no columns");
    assert_eq!(frame(10, 0, 10), Err(FrameError::Empty), "no rows");
    assert_eq!(frame(10, 10, 9), Err(FrameError::Stride { needed: 10, got: 9 }), "stride");
    assert_eq!(frame(10, 11, 10), Err(FrameError::Color { needed: 110, got: 100 }), "short");
    assert_eq!(frame(8193, 1, 8193), Err(FrameError::TooLarge { got: 8193 }), "large");
    assert!(frame(8192, 8192, u32::MAX).is_err(), "a product beyond 32 bits");
    let mut depth = [0u16; 99];
    let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(10, 10)).expect("the buffer fits");
    let refused = frame.with_depth(&mut depth).err();
    assert_eq!(refused, Some(FrameError::Depth { needed: 100, got: 99 }), "depth");
    let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(10, 10)).expect("the buffer fits");
    let refused = frame.band(1, 10).err();
    assert_eq!(refused, Some(FrameError::Band { needed: 11, got: 10 }), "band");
}

#[test]
fn gaps_between_rows_are_never_touched() {
    let camera = Camera::perspective(45.0.degrees(), 0.5);
    let near = Mat4::translation(Vec3::new(0.0, 0.0, -2.0));
    let draw = |strides: [usize; 2]| {
        let (mut pixels, mut depth) =
            (vec![0xABCD_u16; strides[0] * 48], vec![0x1234_u16; strides[1] * 48]);
        let [color, codes] = strides.map(|stride| stride as u32);
        let frame = Frame::<Rgb565>::with_stride(&mut pixels, SIZE, color).expect("it fits");
        let mut frame = frame.with_depth_stride(&mut depth, codes).expect("it fits");
        frame.clear(Rgb::BLACK);
        Pass::new(&camera).depth(Less).draw(&mut frame, &near, &TEAPOT, &Gouraud::lit(&[sun()]));
        (pixels, depth)
    };
    let (tight_pixels, tight_depth) = draw([64, 64]);
    assert!(tight_pixels.iter().filter(|p| **p != 0).count() > 1_000, "a teapot");
    for strides in [[80, 70], [64, 70], [80, 64], [80, 80]] {
        let (pixels, depth) = draw(strides);
        for y in 0..48 {
            let row = |all: &[u16], stride: usize| all[y * stride..][..stride].to_vec();
            let (colors, codes) = (row(&pixels, strides[0]), row(&depth, strides[1]));
            assert_eq!(colors[..64], row(&tight_pixels, 64), "colour of row {y}, {strides:?}");
            assert_eq!(codes[..64], row(&tight_depth, 64), "depth of row {y}, {strides:?}");
            assert!(colors[64..].iter().all(|p| *p == 0xABCD), "gap of colour, {strides:?}");
            assert!(codes[64..].iter().all(|d| *d == 0x1234), "gap of depth, {strides:?}");
        }
    }
}
