//! NaN, infinity and every other float in every argument that takes one.

use crate::scene_parts::float;
use crate::support::{InClipSpace, Random};
use crate::tally::{cases, random};
use microraster::math::{Angle, AngleUnits, Mat4, Vec2, Vec3, Vec4};
use microraster::models::TEAPOT;
use microraster::{
    Always, AtFragments, AtVertices, Attenuated, Attenuation, BlinnPhong, Camera, Clip,
    Consecutive, Flat, Fog, Fogged, Frame, Gouraud, Lambert, Less, Light, Mesh, Normal, Pass,
    Phong, Points, Rgb, Rgb565, Size, Stats,
};

const HARD: [f32; 18] = [
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    -f32::MIN_POSITIVE,
    1e-45,
    -1e-45,
    0.0,
    -0.0,
    1.0,
    -1.0,
    16_777_216.0,
    2_147_483_648.0,
    -2_147_483_648.0,
    1e30,
    1e-30,
];

static CORNERS: [[i16; 3]; 3] = [[-9_000, -9_000, 0], [9_000, -9_000, 5_000], [0, 9_000, 99]];
static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];
static NORMALS: [Normal; 3] = [[0, 0, 127], [90, 0, 90], [-128, 127, 3]];

/// What a scene is made of, each number as it ought to be.
struct Scene {
    camera: Camera,
    model: Mat4,
    scale: Vec3,
    offset: Vec3,
}

impl Scene {
    fn ordinary() -> Self {
        Self {
            camera: Camera::perspective(60.0.degrees(), 0.5),
            model: Mat4::translation(Vec3::new(0.0, 0.0, -2.0)),
            scale: Vec3::splat(1e-4),
            offset: Vec3::ZERO,
        }
    }

    /// Draws a triangle with all kinds of shading in turn.
    fn draw(&self, light: &Numbers) -> Stats {
        let size = Size::new(16, 12);
        let (mut pixels, mut depth) = ([0; 192], [0; 192]);
        let frame = Frame::<Rgb565>::new(&mut pixels, size).expect("it fits");
        let mut frame = frame.with_depth(&mut depth).expect("it fits");
        let mut stats = Stats::default();
        let colored = Mesh::new(&CORNERS, &COLORS).placed(self.scale, self.offset);
        let lit = Mesh::new(&CORNERS, &NORMALS).placed(self.scale, self.offset);
        let mut pass = Pass::new(&self.camera).depth(Less).count(&mut stats);
        let Numbers { a, b, c } = light;
        let fog = [Fog::linear(Rgb::WHITE, a.x, a.y), Fog::exponential(Rgb::WHITE, a.x)];
        let foggy = Fogged::new(Gouraud::colored(), fog[0]).at(AtVertices);
        pass.draw(&mut frame, &self.model, &colored, &foggy);
        let foggy = Fogged::new(Gouraud::colored(), fog[1]).at(AtFragments);
        pass.draw(&mut frame, &self.model, &colored, &foggy);
        let fading = Attenuation::new(b.x, b.y, b.z);
        let spot = Light::spot(*a, *b, c.x.degrees(), c.y.radians(), Rgb::WHITE);
        let lights = [
            Light::directional(*a, Rgb::WHITE).any(),
            Light::point(*c, Rgb::WHITE).attenuation(fading).any(),
            spot.attenuation(fading).any(),
        ];
        let shiny = BlinnPhong::new(&lights).specular(Rgb::WHITE, 20).two_sided();
        pass.draw(&mut frame, &self.model, &lit, &Gouraud::new(shiny));
        pass.draw(&mut frame, &self.model, &lit, &Flat::new(Lambert::new(&lights)));
        pass.draw(&mut frame, &self.model, &lit, &Phong::new(shiny));
        let points = colored.with_topology(Points::new(Consecutive::new(3)));
        let size = Attenuated::new(a.x, b.x, [c.x, c.y, c.z]).at_least(2);
        pass.draw_points(&mut frame, &self.model, &points, &Flat::colored(), &size);
        stats
    }
}

/// The numbers of lights, fog and sizes.
struct Numbers {
    a: Vec3,
    b: Vec3,
    c: Vec3,
}

/// Ordinary ones.
const NUMBERS: Numbers =
    Numbers { a: Vec3::new(1.0, 5.0, -3.0), b: Vec3::new(1.0, 0.5, 0.1), c: Vec3::ONE };

fn assert_accounted(stats: &Stats, what: &dyn std::fmt::Debug) {
    let went = stats.culled + stats.degenerate + stats.outside + stats.skipped + stats.drawn;
    assert_eq!(stats.triangles + stats.points, went, "{what:?}: {stats:?}");
}

/// Puts `v` into one argument after the other and draws; how many arguments there are.
fn in_every_argument(v: f32) -> u64 {
    let mut tried = 0;
    let mut check = |scene: &Scene, numbers: &Numbers, what: &str| {
        let stats = scene.draw(numbers);
        assert_eq!((stats.triangles, stats.points), (5, 3), "{what}");
        assert_accounted(&stats, &(what, v));
        tried += 1;
    };
    let at = |place: usize, of: Vec3| {
        let mut array = of.to_array();
        array[place] = v;
        let [x, y, z] = array;
        Vec3::new(x, y, z)
    };
    let far = Vec3::new(0.0, 0.5, 3.0);
    let angles: [fn(f32) -> Angle; 3] =
        [AngleUnits::degrees, AngleUnits::radians, AngleUnits::turns];
    let cameras = angles
        .into_iter()
        .flat_map(|angle| {
            [
                Camera::perspective(angle(v), 0.5),
                Camera::custom(Mat4::rotation_x(angle(v))),
                Camera::custom(Mat4::rotation(Vec3::ONE, angle(v))),
                Camera::custom(Mat4::perspective(angle(v), 1.0, 0.5, None)),
            ]
        })
        .chain([
            Camera::perspective(60.0.degrees(), v),
            Camera::perspective(60.0.degrees(), 0.5).far(v),
            Camera::perspective(60.0.degrees(), v).far(v),
            Camera::orthographic(v, 0.1, 9.0),
            Camera::orthographic(3.0, v, 9.0),
            Camera::orthographic(3.0, 0.1, v),
            Camera::custom(Mat4::frustum(v, 1.0, -1.0, 1.0, 0.5, Some(9.0))),
            Camera::custom(Mat4::frustum(-1.0, 1.0, -1.0, v, v, None)),
            Camera::custom(Mat4::orthographic(-1.0, v, -1.0, 1.0, 0.5, 9.0)),
            Camera::custom(Mat4::orthographic(-1.0, 1.0, -1.0, 1.0, 0.5, v)),
            Camera::custom(Mat4::viewport(v, 0.0, 3.0, v)),
        ])
        .chain((0..3).flat_map(|place| {
            let camera = Camera::perspective(60.0.degrees(), 0.5);
            [
                camera.look_at(at(place, far), Vec3::ZERO, Vec3::Y),
                camera.look_at(far, at(place, Vec3::ZERO), Vec3::Y),
                camera.look_at(far, Vec3::ZERO, at(place, Vec3::Y)),
                camera.with_view(Mat4::scale(at(place, Vec3::ONE))),
            ]
        }));
    for camera in cameras {
        check(&Scene { camera, ..Scene::ordinary() }, &NUMBERS, "camera");
    }
    for place in 0..16 {
        let mut columns = Scene::ordinary().model.to_columns();
        columns[place / 4][place % 4] = v;
        let [x, y, z, w] = columns.map(Vec4::from);
        let model = Mat4::from_columns(x, y, z, w);
        check(&Scene { model, ..Scene::ordinary() }, &NUMBERS, "model");
        let turned = model.inverse().unwrap_or(model.orthonormalize());
        check(&Scene { model: turned, ..Scene::ordinary() }, &NUMBERS, "model turned");
        check(
            &Scene { camera: Camera::custom(model), ..Scene::ordinary() },
            &NUMBERS,
            "projection",
        );
    }
    for place in 0..3 {
        let ordinary = Scene::ordinary();
        check(&Scene { scale: at(place, ordinary.scale), ..ordinary }, &NUMBERS, "scale");
        let ordinary = Scene::ordinary();
        check(&Scene { offset: at(place, Vec3::ZERO), ..ordinary }, &NUMBERS, "offset");
        let Numbers { a, b, c } = NUMBERS;
        let ordinary = Scene::ordinary();
        check(&ordinary, &Numbers { a: at(place, a), b, c }, "first numbers");
        check(&ordinary, &Numbers { a, b: at(place, b), c }, "second numbers");
        check(&ordinary, &Numbers { a, b, c: at(place, c) }, "third numbers");
    }
    tried
}

#[test]
fn every_hard_float_is_taken_by_every_argument() {
    for v in HARD {
        assert!(in_every_argument(v) > 80, "all arguments");
    }
}

#[test]
fn floats_of_any_bits_are_taken_by_every_argument() {
    let property = "floats of any bits, in every argument";
    random(property, cases(20_000, 1_500_000), 91, |random| {
        let v = float(random, false);
        let tried = in_every_argument(v);
        // All of them at once.
        let mut vector = || Vec3::new(float(random, false), float(random, false), v);
        let scene = Scene {
            camera: Camera::perspective(60.0.degrees(), v).look_at(vector(), vector(), vector()),
            model: Mat4::rotation(vector(), v.radians()) * Mat4::scale(vector()),
            scale: vector(),
            offset: vector(),
        };
        let numbers = Numbers { a: vector(), b: vector(), c: vector() };
        assert_accounted(&scene.draw(&numbers), &v);
        tried + 1
    });
}

#[test]
fn what_is_not_finite_draws_nothing_and_is_counted_as_skipped() {
    for v in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let bad = Mat4::translation(Vec3::new(0.0, v, 0.0));
        let ordinary = Scene::ordinary();
        let cases = [
            ("model", Scene { model: bad, ..Scene::ordinary() }),
            ("view", Scene { camera: ordinary.camera.with_view(bad), ..Scene::ordinary() }),
            ("projection", Scene { camera: Camera::custom(bad), ..Scene::ordinary() }),
            ("scale", Scene { scale: Vec3::splat(v), ..Scene::ordinary() }),
            ("offset", Scene { offset: Vec3::splat(v), ..Scene::ordinary() }),
            ("near", Scene { camera: Camera::perspective(60.0.degrees(), v), ..ordinary }),
        ];
        for (what, scene) in cases {
            let stats = scene.draw(&NUMBERS);
            let all = (stats.skipped, stats.drawn, stats.pixels);
            assert_eq!(all, (8, 0, 0), "{what} with {v}");
        }
    }
}

#[test]
fn vectors_and_angles_of_any_floats_are_numbers_again_or_say_so() {
    let mut random = Random(92);
    for i in 0..200_000 {
        let mut number = || if i < 400 { HARD[i % 18] } else { float(&mut random, false) };
        let (a, b) = (number(), number());
        let unit = Vec3::new(a, b, a).normalize();
        let length = unit.length();
        assert!(unit == Vec3::ZERO || (length - 1.0).abs() < 1e-6, "{a}, {b}: {length}");
        let perpendicular = Vec3::new(a, b, b).any_perpendicular();
        assert!(perpendicular.is_finite(), "{a}, {b}: {perpendicular:?}");
        let _ = (Vec2::new(a, b).normalize(), Vec4::new(a, b, b, a).normalize_fast());
        let _ = Vec4::new(a, b, a, b).project();
        for angle in [a.degrees(), a.radians(), a.turns(), Angle::from_turns(b)] {
            let (sine, cosine) = angle.sin_cos();
            assert!(sine.abs() <= 1.0 && cosine.abs() <= 1.0, "{angle:?}: {sine}, {cosine}");
            let (sine, cosine) = angle.sin_cos_fast();
            assert!(sine.abs() <= 1.01 && cosine.abs() <= 1.01, "{angle:?}: {sine}, {cosine}");
            let _ = (angle.tan(), angle.degrees(), angle.radians());
        }
    }
}

#[test]
fn clip_positions_from_floats_are_in_range_or_none() {
    let mut random = Random(93);
    let camera = Camera::custom(Mat4::identity());
    for i in 0..100_000 {
        let mut number = || if i < 400 { HARD[i % 18] } else { float(&mut random, false) };
        let (position, scale) = (Vec4::new(number(), number(), number(), number()), number());
        let exact = position.to_array().map(|v| v * scale);
        let fits = exact.iter().all(|v| v.is_finite() && v.abs() < Clip::LIMIT as f32);
        let clip = Clip::from_f32(position, scale);
        // Rounding to the next whole number may reach the limit itself.
        assert!(clip.is_none() || fits, "{position:?} times {scale}");
        let near = exact.iter().all(|v| v.abs() < 1e9);
        assert!(clip.is_some() || !near, "{position:?} times {scale}");
        // Each coordinate alone is the nearest whole number, or the one beside it.
        for v in exact.iter().zip(position.to_array()).filter(|_| clip.is_some()) {
            let (nearest, place) = (v.0.round() as i32, Vec4::new(0.0, v.1, 0.0, 0.0));
            let found = Clip::from_f32(place, scale);
            let is_near = |by: i32| found.is_some() && found == Clip::new(0, nearest + by, 0, 0);
            assert!([0, -1, 1].into_iter().any(is_near), "{} times {scale}: {found:?}", v.1);
        }
    }
    // Numbers of clip space that a shader makes of them are skipped where there are none.
    let mut pixels = [0; 64];
    let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(8, 8));
    let mut stats = Stats::default();
    let far = [[Clip::LIMIT, 0, 0, 1], [0, 0, 0, 1], [0, 1, 0, 1]];
    let mut depth = [0; 64];
    let mut frame = frame.and_then(|frame| frame.with_depth(&mut depth)).expect("it fits");
    let mut pass = Pass::new(&camera).depth(Always).count(&mut stats);
    pass.draw(&mut frame, &Mat4::identity(), &Mesh::new(&[], &far), &InClipSpace);
    assert_eq!((stats.triangles, stats.skipped), (1, 1), "{stats:?}");
}

#[test]
fn a_model_of_any_size_that_a_float_holds_is_drawn_or_counted() {
    let mut seen = 0;
    for exponent in -126..=127 {
        let scale = (exponent as f32).exp2();
        let size = Size::new(40, 30);
        let mut pixels = vec![0; 1200];
        let mut frame = Frame::<Rgb565>::new(&mut pixels, size).expect("it fits");
        let mut stats = Stats::default();
        // As large on the screen at every size.
        let camera = Camera::perspective(60.0.degrees(), 0.5 * scale)
            .with_view(Mat4::translation(Vec3::new(0.0, 0.0, -5.0 * scale)));
        let model = Mat4::scale(Vec3::splat(scale));
        let mut pass = Pass::new(&camera).count(&mut stats);
        pass.draw(
            &mut frame,
            &model,
            &TEAPOT,
            &Gouraud::lit(&[Light::directional(-Vec3::Z, Rgb::WHITE)]),
        );
        assert_accounted(&stats, &exponent);
        assert_eq!(stats.triangles, 992, "2^{exponent}");
        if (-60..=60).contains(&exponent) {
            assert_eq!(stats.skipped, 0, "2^{exponent}");
            seen += u32::from(stats.pixels > 300);
        }
    }
    assert_eq!(seen, 121, "all sizes from 2^-60 to 2^60 are seen");
}
