//! Scenes of everything that the crate can draw, from numbers of any origin: all states, shaders,
//! styles, textures, cameras, ordinary or hostile; and what must hold of each.
//!
//! The tests make them from a generator, the fuzzer from bytes.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "numbers are cut to what is wanted; buffers are made to fit"
)]

use crate::choices::Choices;
use crate::scene_parts::{float, matrix, vector, Discs, Kit, Tests, KINDS};
use microraster::frame::Supplies;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::texture::Sample;
use microraster::{
    Adaptive, Affine, AtFragments, AtVertices, Attenuated, Bands, BlinnPhong, Camera, Color,
    Consecutive, Damage, DepthBuffer, Every, Exact, Flat, Fog, Fogged, Format, Frame, Gouraud,
    Light, LineStrip, Matcap, Mesh, Midpoint, Pass, PerspectiveMode, Phong, Points, Rect,
    Rectangle, Rgb, ScreenPass, Shader, Size, Smooth, Stats, StencilBuffer, Stippled, Textured,
    Thin, Topology, TriangleStrip, Wide,
};

/// One scene: all that is drawn follows from the choices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene<C> {
    pub(crate) choices: C,
    /// Whether numbers are ordinary.
    pub(crate) tame: bool,
    pub(crate) size: Size,
}

/// What a draw says of itself.
type Facts<'a> = (&'a mut Stats, &'a mut Damage);

impl<C: Choices + std::fmt::Debug> Scene<C> {
    /// A scene from choices alone.
    pub(crate) fn new(mut choices: C) -> Self {
        let size = match choices.range(0, 9) {
            0 => Size::new(1, 1),
            1 => Size::new(1, choices.range(1, 90) as u16),
            2 => Size::new(choices.range(1, 300) as u16, 1),
            _ => Size::new(choices.range(2, 70) as u16, choices.range(2, 50) as u16),
        };
        let tame = !choices.is_one_in(3);
        Self { choices, tame, size }
    }

    /// Draws it into a frame that may be a band, or have a scissor.
    fn draw<F: Format, T: Tests, D: Supplies<T::Access>>(
        &self,
        frame: &mut Frame<'_, F, D>,
        damage: &mut Damage,
    ) -> Stats {
        let choices = &mut self.choices.clone();
        let mut stats = Stats::default();
        let facts = &mut (&mut stats, damage);
        let kit = Kit::new(choices, self.tame);
        let camera = self.camera(choices);
        let model = matrix(choices, self.tame);
        for _ in 0..choices.range(1, 6) {
            if choices.is_one_in(5) {
                self.on_screen::<F, T, D>(choices, frame, facts);
            } else {
                self.mesh::<F, T, D>(choices, frame, (&kit, &camera, &model), facts);
            }
        }
        let came = u64::from(stats.triangles) + u64::from(stats.lines) + u64::from(stats.points);
        let went = [stats.culled, stats.degenerate, stats.outside, stats.skipped, stats.drawn];
        let went: u64 = went.into_iter().map(u64::from).sum();
        assert_eq!(came, went, "{self:?}: {stats:?}");
        stats
    }

    fn camera(&self, choices: &mut C) -> Camera {
        let tame = self.tame;
        let camera = match choices.range(0, 4) {
            0 => Camera::perspective(60.0.degrees(), 0.1 + choices.unit() as f32),
            1 => Camera::perspective(60.0.degrees(), 0.5).far(float(choices, tame)),
            2 => Camera::orthographic(3.0, -5.0, 5.0),
            3 => Camera::custom(matrix(choices, tame)),
            _ => {
                let angle = float(choices, tame).radians();
                Camera::perspective(angle, float(choices, tame))
            }
        };
        let up = if choices.is_one_in(4) { vector(choices, tame) } else { Vec3::Y };
        camera.look_at(vector(choices, tame), Vec3::new(0.0, 0.0, -3.0), up)
    }

    /// A draw of a mesh: triangles in many shadings, lines in all styles, points.
    fn mesh<F: Format, T: Tests, D: Supplies<T::Access>>(
        &self,
        choices: &mut C,
        frame: &mut Frame<'_, F, D>,
        (kit, camera, model): (&Kit, &Camera, &Mat4),
        (stats, damage): &mut Facts<'_>,
    ) {
        let tame = self.tame;
        let (blend, dither, mask) = crate::scene_parts::output(choices);
        let mut pass = Pass::new(camera)
            .cull(crate::scene_parts::cull(choices))
            .front_face(crate::scene_parts::front(choices))
            .depth(T::choose(choices))
            .blend(blend)
            .dither(dither)
            .color_mask(mask)
            .count(stats)
            .track_damage(damage);
        if choices.is_one_in(5) {
            let mut corner = || choices.range(-90, 90);
            pass = pass.viewport(Rect::new(corner(), corner(), corner(), corner()));
        }
        let consecutive = Consecutive::new(kit.positions.len());
        let (scale, offset) = kit.place;
        let bare = Mesh::new(&kit.positions, &kit.colors).placed(scale, offset);
        let lit = Mesh::new(&kit.positions, &kit.normals).placed(scale, offset);
        let textured = Mesh::new(&kit.positions, &kit.places).placed(scale, offset);
        let strip = TriangleStrip::new(consecutive);
        let lines = bare.with_topology(LineStrip::new(consecutive));
        let points = bare.with_topology(Points::new(consecutive));
        let (gouraud, width) = (Gouraud::colored(), choices.range(0, 255) as u8);
        let sampler = kit.sampler();
        let mut draw = Draw { pass: &mut pass, frame, model };
        match choices.range(0, KINDS - 1) {
            0 => draw.filled(&bare.with_topology(strip), &gouraud),
            1 => draw.filled(&textured.with_topology(strip), &by(sampler, Adaptive)),
            2 => draw.filled(&textured.with_topology(strip), &by(sampler, Exact)),
            3 => draw.filled(&textured.with_topology(strip), &by(sampler, Every::<8>)),
            4 => draw.filled(&textured.with_topology(strip), &by(sampler, Affine)),
            5 => draw.filled(&bare.indexed(&kit.indices), &Flat::colored()),
            6 => {
                let fog = self.fog(choices);
                let shader = Fogged::new(gouraud, fog).at(AtFragments);
                draw.filled(&bare.with_topology(strip), &shader);
            }
            7 => {
                let shader = Fogged::new(gouraud, self.fog(choices)).at(AtVertices);
                draw.filled(&bare.indexed(&kit.indices), &shader);
            }
            8 => draw.filled(&lit.with_topology(strip), &Phong::new(self.light(choices))),
            9 => draw.filled(&lit.indexed(&kit.indices), &Flat::new(self.light(choices))),
            10 => draw.filled(&lit.with_topology(strip), &Matcap::new(sampler)),
            11 => draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, Thin),
            12 => draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, Midpoint),
            13 => draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, Wide(width)),
            14 => draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, Rectangle(width)),
            15 => draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, Smooth(width)),
            16 => {
                let style = Stippled::new(choices.range(0, 0xFFFF) as u16, width, Thin);
                draw.pass.draw_lines(draw.frame, model, &lines, &gouraud, style);
            }
            17 => {
                let fading = [1.0, 0.3, 0.1].map(|part: f32| part * float(choices, tame));
                let near = float(choices, tame);
                let size = Attenuated::new(float(choices, tame) * 20.0, near, fading);
                draw.pass.draw_points(draw.frame, model, &points, &gouraud, &size);
            }
            _ => {
                let size = choices.range(0, 0xFFFF) as u16;
                draw.pass.draw_points(draw.frame, model, &points, &Discs, &size);
            }
        }
    }

    fn fog(&self, choices: &mut C) -> Fog {
        match choices.range(0, 2) {
            0 => Fog::linear(Rgb::BLUE, float(choices, self.tame), float(choices, self.tame)),
            1 => Fog::exponential(Rgb::BLUE, float(choices, self.tame)),
            _ => Fog::exponential_squared(Rgb::BLUE, float(choices, self.tame)),
        }
    }

    fn light(&self, choices: &mut C) -> BlinnPhong<3, microraster::AnyLightKind> {
        let tame = self.tame;
        let mut vector = || vector(choices, tame);
        let (sun, lamp) = (vector(), vector());
        let (at, along) = (vector(), vector());
        let fading = vector();
        let spot = Light::spot(at, along, fading.x.degrees(), 40.0.degrees(), Rgb::RED);
        let fading = microraster::Attenuation::new(fading.x, fading.y, fading.z);
        let lights = [
            Light::directional(sun, Rgb::WHITE).any(),
            Light::point(lamp, Rgb::WHITE).attenuation(fading).any(),
            spot.any(),
        ];
        BlinnPhong::new(&lights).specular(Rgb::WHITE, choices.range(0, 255) as u8)
    }

    /// A draw of what is on the screen already, in range or a little beyond.
    fn on_screen<F: Format, T: Tests, D: Supplies<T::Access>>(
        &self,
        choices: &mut C,
        frame: &mut Frame<'_, F, D>,
        (stats, damage): &mut Facts<'_>,
    ) {
        let reach = choices.one_of(&[1_000, 30_000, 70_000]);
        let mut corner = || {
            let (x, y) = (choices.range(-reach, reach), choices.range(-reach, reach));
            let z = choices.range(0, 0xFFFF) as u16;
            let [r, g, b, a] = (choices.range(i32::MIN, i32::MAX) as u32).to_le_bytes();
            (ScreenVertex::from_bits(x, y, z), Color::new(r, g, b).with_alpha(a))
        };
        let [a, b, c]: [(ScreenVertex, Color); 3] = [corner(), corner(), corner()];
        let (blend, dither, mask) = crate::scene_parts::output(choices);
        let mut pass = ScreenPass::new()
            .cull(crate::scene_parts::cull(choices))
            .depth(T::choose(choices))
            .blend(blend)
            .dither(dither)
            .color_mask(mask)
            .count(stats)
            .track_damage(damage);
        let (gouraud, width) = (Gouraud::colored(), choices.range(0, 255) as u8);
        match choices.range(0, 6) {
            0 | 1 => pass.triangle(frame, &gouraud, &[a, b, c]),
            2 => pass.triangle(frame, &Flat::colored(), &[a, b, c]),
            3 => pass.lines(frame, &gouraud, Wide(width), &[[a, b], [b, c]]),
            4 => {
                let style = Stippled::new(choices.range(0, 0xFFFF) as u16, width, Thin);
                pass.line_strip(frame, &gouraud, style, &[a, b, c]);
            }
            5 => pass.lines(frame, &gouraud, Smooth(width), &[[a, b], [b, c]]),
            _ => pass.points(frame, &gouraud, choices.range(0, 0xFFFF) as u16, &[a, b, c]),
        }
    }
}

/// A sampler in a perspective mode.
fn by<S: Sample + Copy, M: PerspectiveMode>(
    sampler: S,
    mode: M,
) -> Textured<S, microraster::Unlit, microraster::texture::Replace, M> {
    Textured::new(sampler).perspective(mode)
}

/// A pass and what it draws into.
struct Draw<'d, 'f, 'c, S, F: Format, D> {
    pass: &'d mut Pass<'c, S>,
    frame: &'d mut Frame<'f, F, D>,
    model: &'d Mat4,
}

impl<S: microraster::State, F: Format, D> Draw<'_, '_, '_, S, F, D> {
    /// Filled triangles.
    fn filled<H: Shader, T: Topology<Primitive = [u32; 3]>>(
        &mut self,
        mesh: &Mesh<'_, H::Vertex, T>,
        shader: &H,
    ) where
        D: Supplies<<S::Depth as microraster::DepthTest>::Access>,
    {
        self.pass.draw(self.frame, self.model, mesh, shader);
    }
}

/// The depth and stencil that a frame of [`check`] has.
type Buffers<'a> = StencilBuffer<'a, DepthBuffer<'a>>;

/// What is there before a scene is drawn.
const CODE: u16 = 20_000;
const VALUE: u8 = 3;

/// The whole picture, and the same in bands and under a scissor: fails where a bit differs.
pub(crate) fn check<F, T, C>(scene: &Scene<C>) -> Stats
where
    F: Format<Raw: PartialEq + std::fmt::Debug>,
    T: Tests,
    C: Choices + std::fmt::Debug,
    for<'a> Buffers<'a>: Supplies<T::Access>,
{
    let (width, height) = (usize::from(scene.size.width), usize::from(scene.size.height));
    let blank = F::pack(Rgb::new(90, 60, 30).into());
    let drawn = |scissor: Option<Rect>, rows: usize| {
        let mut pixels = vec![blank; width * height];
        let mut codes = vec![CODE; width * height];
        let mut values = vec![VALUE; width * height];
        let (mut stats, mut damage) = (Stats::default(), Damage::new(Size::new(0, 0)));
        let bands = pixels.chunks_mut(width * rows).zip(codes.chunks_mut(width * rows));
        let bands = bands.zip(values.chunks_mut(width * rows));
        for (number, ((pixels, codes), values)) in bands.enumerate() {
            let held = Size::new(scene.size.width, (pixels.len() / width) as u16);
            let frame = Frame::<F>::new(pixels, held).and_then(|frame| {
                let frame = frame.with_depth(codes)?.with_stencil(values)?;
                frame.band((number * rows) as u16, scene.size.height)
            });
            let mut frame = frame.expect("a band of the picture");
            if let Some(scissor) = scissor {
                frame.set_scissor(scissor);
            }
            stats = scene.draw::<F, T, _>(&mut frame, &mut damage);
        }
        // What was written is a part of what was tracked.
        let tracked = damage.next_picture();
        for (i, after) in pixels.iter().zip(&codes).zip(&values).enumerate() {
            let same = after == ((&blank, &CODE), &VALUE);
            let inside = tracked.contains((i % width) as i32, (i / width) as i32);
            assert!(same || inside, "pixel {i} beside {tracked:?}: {scene:?}");
        }
        let held = scissor.unwrap_or(Rect::from_size(scene.size));
        let within = tracked.is_empty() || tracked.intersection(held) == tracked;
        assert!(within, "{tracked:?} is more than is drawn: {scene:?}");
        (pixels, codes, values, stats)
    };
    let (pixels, codes, values, stats) = drawn(None, height);
    // Not those that the scene begins with.
    let choices = &mut scene.choices.clone();
    let rows = 1 + (choices.next() >> 13) as usize % height;
    let (banded, banded_codes, banded_values, _) = drawn(None, rows);
    let same = pixels == banded && codes == banded_codes && values == banded_values;
    assert!(same, "bands of {rows} rows: {scene:?}");
    let (left, top) = (choices.range(-4, 30), choices.range(-4, 20));
    let scissor = Rect::new(left, top, left + choices.range(0, 40), top + choices.range(0, 30));
    let (cut, cut_codes, cut_values, _) = drawn(Some(scissor), height);
    for (i, ((pixel, code), value)) in cut.iter().zip(&cut_codes).zip(&cut_values).enumerate() {
        let inside = scissor.contains((i % width) as i32, (i / width) as i32);
        let expected = if inside { (pixels[i], codes[i], values[i]) } else { (blank, CODE, VALUE) };
        assert_eq!((*pixel, *code, *value), expected, "pixel {i} in {scissor:?}: {scene:?}");
    }
    stats
}

/// The whole picture against the one that [`Bands`] of so many rows hand out; says how many pixels
/// were written.
#[allow(dead_code, reason = "not every test has bands")]
pub(crate) fn check_bands<F, T, C>(scene: &Scene<C>, rows: u16) -> u64
where
    F: Format<Raw: PartialEq + std::fmt::Debug>,
    T: Tests,
    C: Choices + std::fmt::Debug,
    for<'a> Buffers<'a>: Supplies<T::Access>,
{
    let draw = |rows: u16| {
        let length = usize::from(scene.size.width) * usize::from(rows);
        let mut pixels = vec![F::pack(Rgb::WHITE.into()); length];
        let (mut codes, mut values) = (vec![1; length], vec![1; length]);
        let bands = Bands::<F>::new(&mut pixels, scene.size).and_then(|bands| {
            let bands = bands.with_depth(&mut codes)?;
            bands.with_stencil(&mut values)
        });
        let mut bands = bands.expect("at least one row");
        assert_eq!(bands.rows(), rows.min(scene.size.height), "what was asked for");
        let (mut sent, mut written) = (Vec::new(), 0);
        let all = bands.draw::<()>(
            |frame| {
                frame.clear_color(Rgb::new(90, 60, 30));
                frame.clear_depth(CODE);
                frame.clear_stencil(VALUE);
                let mut damage = Damage::new(scene.size);
                written += u64::from(scene.draw::<F, T, _>(frame, &mut damage).pixels);
            },
            |band| {
                let before = usize::from(band.first_row()) * usize::from(scene.size.width);
                assert_eq!(before, sent.len(), "in order, without a gap");
                sent.extend_from_slice(band.pixels());
                Ok(())
            },
        );
        assert_eq!(all, Ok(()), "nothing fails");
        (sent, written)
    };
    let (whole, written) = draw(scene.size.height);
    let (banded, banded_written) = draw(rows);
    assert!(whole == banded, "bands of {rows} rows: {scene:?}");
    assert_eq!(written, banded_written, "each pixel as often: {scene:?}");
    written
}
