//! Lights against the same formulas in `f64`.
#![cfg(feature = "std")]
#![allow(clippy::cast_possible_truncation, reason = "normals and positions of 8 and 16 bits")]

mod support;

use microraster::host::reference::lighting::{self, arriving, blinn_phong, lambert, Material};
use microraster::host::reference::{self, Fragment, Interpolation, Kind, Reference, Space, State};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::texture::{Sampler, Texture};
use microraster::{
    AnyLightKind, Attenuation, BlinnPhong, Coloring, DrawContext, Exact, Frame, Lambert, Light,
    LightKind, Lighting, Matcap, Normal, Phong, Rgb, Rgb16, Rgb565, Rgba8888, ScreenPass, Shader,
    Size, Surface, VertexInput,
};
use support::Random;

type V = [f64; 3];

fn wide(v: Vec3) -> V {
    [v.x, v.y, v.z].map(f64::from)
}

fn sub(a: V, b: V) -> V {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(v: V) -> V {
    let length = dot(v, v).sqrt();
    v.map(|v| v / length)
}

/// A mesh somewhere in the world, an eye, and a vertex of it.
struct Scene {
    draw: DrawContext,
    eye: V,
    normal: Normal,
    position: [i16; 3],
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        let mut number = |limit: f32| (random.unit() as f32 * 2.0 - 1.0) * limit;
        let axis = Vec3::new(number(1.0), number(1.0), number(1.0) + 1.5);
        let size = 0.5 + number(0.4);
        let model = Mat4::translation(Vec3::new(number(3.0), number(3.0), number(3.0)))
            * Mat4::rotation(axis, (number(180.0)).degrees())
            * Mat4::scale(Vec3::splat(size));
        let eye = Vec3::new(number(6.0), number(6.0), number(6.0) + 12.0);
        let draw = DrawContext {
            model,
            view: Mat4::look_at(eye, Vec3::ZERO, Vec3::Y),
            projection: Mat4::perspective(45.0.degrees(), 1.0, 0.5, None),
            scale: Vec3::new(1.0, 0.5, 0.8) * (1.0 / 16_384.0),
            offset: Vec3::new(number(1.0), number(1.0), number(1.0)),
            viewport: Size::new(64, 64),
        };
        let normal = microraster::normal(Vec3::new(number(1.0), number(1.0), number(1.0)));
        let position = [0; 3].map(|_: i16| number(32_767.0) as i16);
        Self { draw, eye: wide(eye), normal, position }
    }

    /// The vertex in the world, and its normal there.
    fn world(&self) -> (V, V) {
        let local = |axis: usize| {
            let scale = [self.draw.scale.x, self.draw.scale.y, self.draw.scale.z];
            let offset = [self.draw.offset.x, self.draw.offset.y, self.draw.offset.z];
            f64::from(self.position[axis]) * f64::from(scale[axis]) + f64::from(offset[axis])
        };
        let m = self.draw.model.to_columns().map(|column| column.map(f64::from));
        let turn = |v: V, w: f64| {
            [0, 1, 2].map(|i| m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2] + m[3][i] * w)
        };
        let normal = turn(self.normal.map(f64::from), 0.0);
        (turn([local(0), local(1), local(2)], 1.0), unit(normal))
    }

    fn input(&self) -> VertexInput<'_, Normal> {
        VertexInput { attributes: &self.normal, position: self.position }
    }
}

/// The colours of the surface of both tests, 0 to 255.
const MATERIAL: Material = Material {
    ambient: [20.0; 3],
    color: [200.0, 150.0, 100.0],
    specular: [90.0, 60.0, 30.0],
    emissive: [3.0, 2.0, 1.0],
    ..Material::WHITE
};

/// The largest difference of a channel, in 8-bit steps.
fn furthest(color: Rgb16, exact: [f64; 3]) -> f64 {
    let channels = color.channels().into_iter().zip(exact);
    channels.map(|(seen, exact)| (f64::from(seen) / 256.0 - exact).abs()).fold(0.0, f64::max)
}

/// The largest difference in 8-bit steps of a channel, of diffuse light and with highlights; of
/// highlights by light from nearly behind a quarter of it.
fn check<K: LightKind>(
    scene: &Scene,
    lights: &[Light<K>; 2],
    any: [Light<AnyLightKind>; 2],
    shininess: u8,
    two_sided: bool,
) -> (f64, f64) {
    let material = Rgb::new(200, 150, 100);
    let (highlight, own) = (Rgb::new(90, 60, 30), Rgb::new(3, 2, 1));
    let diffuse = Lambert::new(lights).ambient(Rgb::new(20, 20, 20)).material(material);
    let seen = diffuse.color(&diffuse.prepare(&scene.draw), scene.input());
    let mut shiny = BlinnPhong::new(lights)
        .ambient(Rgb::new(20, 20, 20))
        .material(material)
        .specular(highlight, shininess)
        .emissive(own);
    if two_sided {
        shiny = shiny.two_sided();
    }
    let lit = shiny.shine(&shiny.lights(&scene.draw), &Surface::of(scene.input()));
    let (point, normal) = scene.world();
    let surface = lighting::Surface { point, normal };
    let to_eye = unit(sub(scene.eye, point));
    let exact = Material { shininess: shininess.into(), two_sided, ..MATERIAL };
    let errors = [
        furthest(seen, lambert(&any, &exact, &surface)),
        furthest(lit, blinn_phong(&any, &exact, &surface, to_eye)),
    ];
    let turned = two_sided && dot(normal, to_eye) < 0.0;
    let facing = if turned { normal.map(|v| -v) } else { normal };
    let (mut room, mut is_steady) = (1.0_f64, true);
    for light in &any {
        let (way, _) = arriving(light, point);
        let cosine = dot(facing, way);
        // A highlight begins at once where light begins to graze the surface.
        is_steady &= cosine.abs() > 1e-3;
        if cosine > 0.0 {
            let between = [0, 1, 2].map(|i| way[i] + to_eye[i]);
            // Light from nearly behind leaves little of which to make a direction.
            room = room.min(dot(between, between).sqrt());
        }
    }
    let weight = if room < 0.1 { 0.25 } else { 1.0 };
    (errors[0], if is_steady { errors[1] * weight } else { 0.0 })
}

#[test]
fn light_of_every_kind_is_what_the_formulas_say() {
    let mut random = Random(81);
    let mut worst = [(0.0_f64, 0.0_f64); 4];
    for _ in 0..20_000 {
        let scene = Scene::random(&mut random);
        let mut number = |limit: f32| (random.unit() as f32 * 2.0 - 1.0) * limit;
        let colors = [Rgb::new(120, 90, 60), Rgb::new(70, 90, 110)];
        let at = [0, 1].map(|_| Vec3::new(number(8.0), number(8.0), number(8.0)));
        let along = [0, 1].map(|_| Vec3::new(number(1.0), number(1.0), number(1.0) + 0.2));
        let fade = [0, 1].map(|_| [0.2 + number(0.1), 0.3 + number(0.2), 0.1 + number(0.1)]);
        let attenuation = fade.map(|[c, l, q]| Attenuation::new(c, l, q));
        let shininess = 1 + (number(1.0).abs() * 120.0) as u8;
        let suns = [0, 1].map(|i| Light::directional(along[i], colors[i]));
        let points = [0, 1].map(|i| Light::point(at[i], colors[i]).attenuation(attenuation[i]));
        let (inner, outer) = (20.0.degrees(), 50.0.degrees());
        let spots = [0, 1].map(|i| {
            Light::spot(at[i], along[i], inner, outer, colors[i]).attenuation(attenuation[i])
        });
        let any_suns = suns.map(|light| light.any());
        let any_points = points.map(|light| light.any());
        let any_spots = spots.map(|light| light.any());
        let mixed = [any_suns[0], any_spots[1]];
        let errors = [
            check(&scene, &suns, any_suns, shininess, false),
            check(&scene, &points, any_points, shininess, true),
            check(&scene, &spots, any_spots, shininess, false),
            check(&scene, &mixed, mixed, shininess, true),
        ];
        for (worst, error) in worst.iter_mut().zip(errors) {
            worst.0 = worst.0.max(error.0);
            worst.1 = worst.1.max(error.1);
        }
    }
    println!("diffuse, and with highlights, in 8-bit steps: {worst:.2?}");
    for (diffuse, shiny) in worst {
        assert!(diffuse <= 2.0 && shiny <= 2.0, "{worst:?}");
    }
}

#[test]
fn light_at_fragments_is_that_of_the_interpolated_normal() {
    let mut random = Random(83);
    let size = Size::new(40, 40);
    let mut worst = 0.0_f64;
    for _ in 0..60 {
        let mut number = |limit: f32| (random.unit() as f32 * 2.0 - 1.0) * limit;
        // No matrices: the eye is along z, and so are the normals about.
        let along = Vec3::new(number(1.0), number(1.0), -1.5);
        let sun = Light::directional(along, Rgb::new(200, 180, 160));
        let shininess = 1 + (number(1.0).abs() * 60.0) as u8;
        let lighting = BlinnPhong::new(&[sun])
            .ambient(Rgb::new(20, 20, 20))
            .material(Rgb::new(150, 160, 170))
            .specular(Rgb::new(60, 50, 40), shininess);
        let normals =
            [0; 3].map(|_: i32| microraster::normal(Vec3::new(number(0.8), number(0.8), 1.0)));
        let places = [[0, 0], [40 * 16, 10], [30, 40 * 16]];
        let corner = |i: usize| {
            let [x, y] = places[i];
            let word = |v: i32| (v + (1 << 15)) as u16;
            let normal = normals[i].map(|component| word(i32::from(component) << 8));
            (ScreenVertex::from_bits(x, y, 0), (normal, [1 << 15; 3]).into())
        };
        let mut pixels = vec![0_u32; 1600];
        let mut frame = Frame::<Rgba8888>::new(&mut pixels, size).expect("a buffer that fits");
        let shader = Phong::new(lighting).perspective(Exact);
        ScreenPass::new().triangle(&mut frame, &shader, &[0, 1, 2].map(corner));
        let exact = Material {
            ambient: [20.0; 3],
            color: [150.0, 160.0, 170.0],
            specular: [60.0, 50.0, 40.0],
            shininess: shininess.into(),
            ..Material::WHITE
        };
        let vertex = |i: usize| {
            let [x, y] = places[i].map(|subpixels| f64::from(subpixels) / 16.0);
            let varyings = normals[i].map(f64::from).to_vec();
            reference::Vertex { position: [x, y, 0.0, 1.0], varyings }
        };
        let shade = |fragment: &Fragment<'_>| {
            let normal = unit(fragment.varyings.try_into().ok()?);
            let surface = lighting::Surface { point: [0.0; 3], normal };
            let [r, g, b] = blinn_phong(&[sun.any()], &exact, &surface, [0.0, 0.0, 1.0]);
            Some([r, g, b, 255.0])
        };
        let mut truth = Reference::new(size, [0.0; 3]);
        truth.draw(&reference::Draw {
            space: Space::Window,
            kind: Kind::Triangles,
            vertices: &[0, 1, 2].map(vertex),
            corners: &[0, 1, 2],
            interpolation: Interpolation::Perspective,
            state: State::PLAIN,
            shade: &shade,
        });
        for ((pixel, truth), seen) in pixels.iter().zip(truth.colors()).zip(truth.seen()) {
            assert_eq!(*pixel != 0, seen.is_some(), "what is covered");
            let [r, g, b, _] = pixel.to_le_bytes().map(f64::from);
            for (seen, truth) in [r, g, b].into_iter().zip(truth) {
                worst = worst.max((seen - truth).abs());
            }
        }
    }
    println!("at fragments, in 8-bit steps: {worst:.2}");
    assert!(worst <= 2.0, "{worst}");
}

#[test]
fn a_sphere_is_looked_up_where_its_normal_points_in_the_eye() {
    let mut random = Random(84);
    static WHITE: [u16; 1] = [0xFFFF];
    let texture = Texture::<Rgb565>::new(&WHITE, 1, 1).expect("one texel");
    let shader = Matcap::new(Sampler::nearest(texture).expect("a power of two"));
    for _ in 0..10_000 {
        let scene = Scene::random(&mut random);
        let [u, v] = shader.vertex(&shader.prepare(&scene.draw), scene.input());
        let (_, n) = scene.world();
        let view = scene.draw.view.to_columns().map(|column| column.map(f64::from));
        let eye = [0, 1].map(|i| view[0][i] * n[0] + view[1][i] * n[1] + view[2][i] * n[2]);
        // Normals of three bytes are up to half a step of 127 longer or shorter than a unit.
        let expected = [2048.0 + 2048.0 * 0.98 * eye[0], 2048.0 - 2048.0 * 0.98 * eye[1]];
        for (seen, expected) in [u, v].into_iter().zip(expected) {
            let error = (f64::from(seen) - expected).abs();
            assert!(error <= 2048.0 / 127.0, "{seen} is not {expected}");
        }
    }
}
