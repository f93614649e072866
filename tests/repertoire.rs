//! Everything together, at random and at the extremes: nothing panics, no band and no scissor
//! changes a bit, and every primitive is accounted for.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "random bits are cut to what is wanted"
)]

mod support;

use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::texture::{AnyFilter, AnySampler, AnyTexture, AnyWrap, Texture};
use microraster::{
    Adaptive, Affine, AnyBlend, AnyDepth, AnyDepthState, AnyDither, AnyMask, AtFragments,
    Attenuated, BlinnPhong, Camera, Consecutive, Cull, Every, Exact, Flat, Fog, Fogged, Format,
    Frame, Gouraud, Light, LineStrip, Mesh, Midpoint, Normal, Pass, PerspectiveMode, Phong,
    PointCoordinates, Points, Rect, Rectangle, Rgb, Rgb565, Rgba8888, Shader, Size, Smooth, Stats,
    Stippled, Textured, Thin, TriangleStrip, VertexInput, Wide,
};
use support::Random;

/// One random scene: all that is drawn follows from the seed.
#[derive(Clone, Copy, Debug)]
struct Scene {
    seed: u64,
    /// Whether numbers are ordinary.
    tame: bool,
    size: Size,
}

/// A float: ordinary, or any bits at all.
fn float(random: &mut Random, tame: bool) -> f32 {
    const HARD: [f32; 12] = [
        0.0,
        -0.0,
        1.0,
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN_POSITIVE,
        1e-45,
        1e30,
        -1e-30,
        65_536.0,
    ];
    match (tame, random.range(0, 2)) {
        (true, _) => (random.unit() * 4.0 - 2.0) as f32,
        (_, 0) => f32::from_bits(random.next() as u32),
        (_, 1) => HARD[random.range(0, 11) as usize],
        _ => ((random.unit() * 2.0 - 1.0) * f64::from(random.range(-40, 40)).exp2()) as f32,
    }
}

fn vector(random: &mut Random, tame: bool) -> Vec3 {
    Vec3::new(float(random, tame), float(random, tame), float(random, tame))
}

fn matrix(random: &mut Random, tame: bool) -> Mat4 {
    if tame {
        return Mat4::translation(vector(random, true) - Vec3::Z)
            * Mat4::rotation_y(((random.unit() * 360.0) as f32).degrees())
            * Mat4::scale(Vec3::splat((random.unit() * 6.0 - 3.0).exp2() as f32));
    }
    let mut row = || vector(random, false).extend(float(random, false));
    Mat4::from_rows(row(), row(), row(), Vec4::W)
}

/// Sums up what shaders need: a normal, a colour, a place in the texture.
type Attributes = (Normal, [i16; 2]);

impl Scene {
    /// Draws it into a frame that may be a band, or have a scissor.
    fn draw<F: Format>(&self, frame: &mut Frame<'_, F, microraster::DepthBuffer<'_>>) -> Stats {
        let random = &mut Random(self.seed);
        let tame = self.tame;
        let mut stats = Stats::default();
        let vertices = random.range(3, 14) as usize;
        let reach = if tame { 20_000 } else { 32_767 };
        let position =
            |random: &mut Random| [0; 3].map(|_: i16| random.range(-reach, reach) as i16);
        let positions: Vec<_> = (0..vertices).map(|_| position(random)).collect();
        let attributes: Vec<Attributes> = (0..vertices)
            .map(|_| {
                let normal = [0; 3].map(|_: i8| random.next() as i8);
                (normal, [random.next() as i16, random.next() as i16])
            })
            .collect();
        let normals: Vec<Normal> = attributes.iter().map(|(normal, _)| *normal).collect();
        let places: Vec<((), [i16; 2])> = attributes.iter().map(|(_, uv)| ((), *uv)).collect();
        let colors: Vec<Rgb> =
            normals.iter().map(|n| Rgb::new(n[0] as u8, n[1] as u8, 9)).collect();
        let scale = if tame { Vec3::splat(1.0 / 16_384.0) } else { vector(random, false) };
        let offset = if tame { Vec3::ZERO } else { vector(random, false) };
        let camera = match random.range(0, 2) {
            0 => Camera::perspective(60.0.degrees(), 0.1 + random.unit() as f32),
            1 => Camera::perspective(60.0.degrees(), 0.5).far(float(random, tame)),
            _ => Camera::orthographic(3.0, -5.0, 5.0),
        };
        let camera = camera.look_at(vector(random, tame), Vec3::new(0.0, 0.0, -3.0), Vec3::Y);
        let model = matrix(random, tame);
        let blends = [
            AnyBlend::Replace,
            AnyBlend::Alpha,
            AnyBlend::ConstantAlpha(random.next() as u8),
            AnyBlend::Premultiplied,
            AnyBlend::Add,
            AnyBlend::Multiply,
            AnyBlend::Subtract,
            AnyBlend::Average,
        ];
        let tests = [
            AnyDepth::Off,
            AnyDepth::Less,
            AnyDepth::LessEqual,
            AnyDepth::Equal,
            AnyDepth::Greater,
            AnyDepth::NotEqual,
            AnyDepth::Always,
        ];
        let dithers = [AnyDither::Undithered, AnyDither::Four, AnyDither::Eight];
        for step in 0..5 {
            let mut depth = AnyDepthState::new(tests[random.range(0, 6) as usize]);
            depth.read_only = random.next().is_multiple_of(4);
            depth.constant = random.next().is_multiple_of(4);
            if random.next().is_multiple_of(3) {
                depth.offset = (I8F8::from_bits(random.next() as i16), random.next() as i16);
                depth.range = (random.next() as u16, random.next() as u16);
            }
            let mask = AnyMask {
                red: !random.next().is_multiple_of(4),
                green: !random.next().is_multiple_of(4),
                blue: !random.next().is_multiple_of(4),
            };
            let cull = [Cull::None, Cull::Back, Cull::Front][random.range(0, 2) as usize];
            let pass = Pass::new(&camera)
                .cull(cull)
                .depth(depth)
                .blend(blends[random.range(0, 7) as usize])
                .dither(dithers[random.range(0, 2) as usize])
                .color_mask(mask)
                .count(&mut stats);
            let choice = if step == 0 { random.range(0, 5) } else { random.range(0, 15) };
            let consecutive = Consecutive::new(vertices);
            let bare = Mesh::new(&positions, &colors).placed(scale, offset);
            let lit = Mesh::new(&positions, &normals).placed(scale, offset);
            let textured = Mesh::new(&positions, &places).placed(scale, offset);
            let strip = TriangleStrip::new(consecutive);
            let lines = bare.with_topology(LineStrip::new(consecutive));
            let points = bare.with_topology(Points::new(consecutive));
            let lamp = Light::point(vector(random, tame), Rgb::WHITE).any();
            let spot = Light::spot(
                vector(random, tame),
                vector(random, tame),
                20.0.degrees(),
                40.0.degrees(),
                Rgb::RED,
            );
            let shiny =
                BlinnPhong::new(&[lamp, spot.any()]).specular(Rgb::WHITE, random.next() as u8);
            let (gouraud, width) = (Gouraud::colored(), random.next() as u8);
            let mut pass = pass;
            match choice {
                0 => pass.draw(frame, &model, &bare.with_topology(strip), &gouraud),
                1 => Self::textured(
                    random,
                    &textured.with_topology(strip),
                    Adaptive,
                    |mesh, shader| {
                        pass.draw(frame, &model, mesh, shader);
                    },
                ),
                2 => {
                    Self::textured(random, &textured.with_topology(strip), Exact, |mesh, shader| {
                        pass.draw(frame, &model, mesh, shader);
                    })
                }
                3 => {
                    let every = Every::<8>;
                    Self::textured(
                        random,
                        &textured.with_topology(strip),
                        every,
                        |mesh, shader| {
                            pass.draw(frame, &model, mesh, shader);
                        },
                    );
                }
                4 => Self::textured(
                    random,
                    &textured.with_topology(strip),
                    Affine,
                    |mesh, shader| {
                        pass.draw(frame, &model, mesh, shader);
                    },
                ),
                5 => {
                    let fog = Fog::linear(Rgb::BLUE, float(random, tame), float(random, tame));
                    let shader = Fogged::new(gouraud, fog).at(AtFragments);
                    pass.draw(frame, &model, &bare.with_topology(strip), &shader);
                }
                6 => pass.draw(frame, &model, &lit.with_topology(strip), &Phong::new(shiny)),
                7 => pass.draw(frame, &model, &lit.with_topology(strip), &Flat::new(shiny)),
                8 => pass.draw_lines(frame, &model, &lines, &gouraud, Thin),
                9 => pass.draw_lines(frame, &model, &lines, &gouraud, Midpoint),
                10 => pass.draw_lines(frame, &model, &lines, &gouraud, Wide(width)),
                11 => pass.draw_lines(frame, &model, &lines, &gouraud, Rectangle(width)),
                12 => pass.draw_lines(frame, &model, &lines, &gouraud, Smooth(width)),
                13 => {
                    let style = Stippled::new(random.next() as u16, width, Thin);
                    pass.draw_lines(frame, &model, &lines, &gouraud, style);
                }
                14 => {
                    let size = Attenuated::new(float(random, tame) * 20.0, 0.5, [1.0, 0.3, 0.1]);
                    pass.draw_points(frame, &model, &points, &gouraud, &size);
                }
                _ => {
                    let size = random.next() as u16;
                    pass.draw_points(frame, &model, &points, &Discs, &size);
                }
            }
        }
        let came = u64::from(stats.triangles) + u64::from(stats.lines) + u64::from(stats.points);
        let went = [stats.culled, stats.degenerate, stats.outside, stats.skipped, stats.drawn];
        let went: u64 = went.into_iter().map(u64::from).sum();
        assert_eq!(came, went, "{self:?}: {stats:?}");
        stats
    }

    /// Draws with a random texture in a mode.
    fn textured<M, T>(
        random: &mut Random,
        mesh: &Mesh<'_, ((), [i16; 2]), T>,
        mode: M,
        draw: impl FnOnce(
            &Mesh<'_, ((), [i16; 2]), T>,
            &Textured<AnySampler<'_>, microraster::Unlit, microraster::texture::Replace, M>,
        ),
    ) where
        M: PerspectiveMode,
    {
        let (across, down) = (random.range(0, 5), random.range(0, 5));
        let words: Vec<u16> = (0..1 << (across + down)).map(|_| random.next() as u16).collect();
        let texture = Texture::new(&words, 1 << across, 1 << down).expect("texels for its size");
        let wraps = [AnyWrap::Repeat, AnyWrap::Clamp, AnyWrap::Mirror];
        let mut wrap = || wraps[random.range(0, 2) as usize];
        let (u, v) = (wrap(), wrap());
        let filters = [AnyFilter::Nearest, AnyFilter::Bilinear, AnyFilter::FineBilinear];
        let filter = filters[random.range(0, 2) as usize];
        let sampler = AnySampler::new(AnyTexture::Rgb565(texture), filter, u, v);
        let sampler = sampler.expect("powers of two").unit_bits(random.range(0, 16) as u32);
        draw(mesh, &Textured::new(sampler).perspective(mode));
    }
}

/// Round points in the colour of their vertex' green.
struct Discs;

impl Shader for Discs {
    type Vertex = Rgb;
    type Varying = PointCoordinates;
    type Prepared = ();

    fn prepare(&self, _: &microraster::DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, Rgb>) {}

    fn fragment(&self, (): &(), at: &PointCoordinates) -> Option<microraster::Color> {
        (at.radius_squared() < 1 << 26).then(|| Rgb::GREEN.into())
    }
}

/// The whole picture, and the same in bands and under a scissor.
fn check<F: Format<Raw: PartialEq + std::fmt::Debug>>(scene: &Scene) -> Stats {
    let (width, height) = (usize::from(scene.size.width), usize::from(scene.size.height));
    let blank = F::pack(Rgb::new(90, 60, 30).into());
    let drawn = |scissor: Option<Rect>, rows: usize| {
        let mut pixels = vec![blank; width * height];
        let mut codes = vec![20_000_u16; width * height];
        let mut stats = Stats::default();
        let bands = pixels.chunks_mut(width * rows).zip(codes.chunks_mut(width * rows));
        for (number, (pixels, codes)) in bands.enumerate() {
            let held = Size::new(scene.size.width, (pixels.len() / width) as u16);
            let frame = Frame::<F>::new(pixels, held).and_then(|frame| {
                frame.with_depth(codes)?.band((number * rows) as u16, scene.size.height)
            });
            let mut frame = frame.expect("a band of the picture");
            if let Some(scissor) = scissor {
                frame.set_scissor(scissor);
            }
            stats = scene.draw(&mut frame);
        }
        (pixels, codes, stats)
    };
    let (pixels, codes, stats) = drawn(None, height);
    let random = &mut Random(scene.seed ^ 77);
    let rows = random.range(1, i32::from(scene.size.height)) as usize;
    let (banded, banded_codes, _) = drawn(None, rows);
    assert!(pixels == banded && codes == banded_codes, "bands of {rows} rows: {scene:?}");
    let (left, top) = (random.range(-4, 30), random.range(-4, 20));
    let scissor = Rect::new(left, top, left + random.range(0, 40), top + random.range(0, 30));
    let (cut, cut_codes, _) = drawn(Some(scissor), height);
    for (i, (pixel, code)) in cut.iter().zip(&cut_codes).enumerate() {
        let inside = scissor.contains((i % width) as i32, (i / width) as i32);
        let expected = if inside { (pixels[i], codes[i]) } else { (blank, 20_000) };
        assert_eq!((*pixel, *code), expected, "pixel {i} in {scissor:?}: {scene:?}");
    }
    stats
}

#[test]
fn nothing_panics_and_no_band_or_scissor_changes_a_bit() {
    let mut pixels = 0_u64;
    for seed in 0..6_000_u64 {
        let random = &mut Random(seed * 7919 + 5);
        let size = match random.range(0, 9) {
            0 => Size::new(1, 1),
            1 => Size::new(1, random.range(1, 90) as u16),
            2 => Size::new(random.range(1, 300) as u16, 1),
            _ => Size::new(random.range(2, 70) as u16, random.range(2, 50) as u16),
        };
        let scene = Scene { seed: random.next(), tame: seed % 3 != 0, size };
        let stats = if seed % 2 == 0 { check::<Rgb565>(&scene) } else { check::<Rgba8888>(&scene) };
        pixels += u64::from(stats.pixels);
    }
    assert!(pixels > 1_000_000, "{pixels} pixels are too few to mean much");
}

#[test]
fn the_longest_pictures_are_drawn_like_any_other() {
    for (seed, size) in [(1, Size::new(4096, 3)), (2, Size::new(2, 4096)), (3, Size::new(8192, 1))]
    {
        for seed in seed * 100..seed * 100 + 12 {
            check::<Rgb565>(&Scene { seed, tame: true, size });
        }
    }
}
