//! Lights against the same formulas in `f64`.
#![allow(clippy::cast_possible_truncation, reason = "normals and positions of 8 and 16 bits")]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::texture::{Sampler, Texture};
use microraster::{
    Attenuation, BlinnPhong, Coloring, DrawContext, Exact, Frame, Lambert, Light, LightKind,
    Lighting, Matcap, Normal, Phong, Rgb, Rgb565, Rgba8888, ScreenPass, Shader, Size, Surface,
    VertexInput,
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

/// A light in `f64`: what arrives at a point from where.
#[derive(Clone, Copy)]
enum Lamp {
    Sun(V),
    Point(V, [f64; 3]),
    Spot(V, [f64; 3], V, f64, f64),
}

impl Lamp {
    fn at(self, p: V) -> (V, f64) {
        let fade = |from: V, [c, l, q]: [f64; 3]| {
            let way = sub(from, p);
            let d = dot(way, way).sqrt();
            (unit(way), (1.0 / (c + l * d + q * d * d)).min(1.0))
        };
        match self {
            Self::Sun(direction) => (unit(direction.map(|v| -v)), 1.0),
            Self::Point(from, attenuation) => fade(from, attenuation),
            Self::Spot(from, attenuation, axis, inner, outer) => {
                let (way, strength) = fade(from, attenuation);
                let cosine = -dot(way, unit(axis));
                (way, strength * ((cosine - outer) / (inner - outer)).clamp(0.0, 1.0))
            }
        }
    }
}

/// The largest difference in 8-bit steps of a channel, of diffuse light and with highlights; of
/// highlights by light from nearly behind a quarter of it.
fn check<K: LightKind>(
    scene: &Scene,
    lights: &[Light<K>; 2],
    lamps: [Lamp; 2],
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
    let (p, n) = scene.world();
    let to_eye = unit(sub(scene.eye, p));
    let turned = two_sided && dot(n, to_eye) < 0.0;
    let facing = if turned { n.map(|v| -v) } else { n };
    let mut expected = [0.0; 2];
    let mut errors = [0.0_f64; 2];
    let (mut room, mut is_steady) = (1.0_f64, true);
    let channels = |color: Rgb| [color.r, color.g, color.b].map(f64::from);
    for channel in 0..3 {
        let base = 20.0 * channels(material)[channel] / 255.0;
        expected[0] = base;
        expected[1] = base + channels(own)[channel];
        for (lamp, light) in lamps.iter().zip(lights) {
            let color = channels(light.color())[channel] / 255.0;
            let (way, strength) = lamp.at(p);
            expected[0] += color * channels(material)[channel] * strength * dot(n, way).max(0.0);
            let cosine = dot(facing, way);
            // A highlight begins at once where light begins to graze the surface.
            is_steady &= cosine.abs() > 1e-3;
            if cosine > 0.0 {
                let between = [0, 1, 2].map(|i| way[i] + to_eye[i]);
                // Light from nearly behind leaves little of which to make a direction.
                room = room.min(dot(between, between).sqrt());
                let halfway = unit(between);
                let shine = dot(facing, halfway).max(0.0).powi(shininess.into());
                expected[1] += color
                    * strength
                    * (channels(material)[channel] * cosine + channels(highlight)[channel] * shine);
            }
        }
        let of = |color: microraster::Rgb16| f64::from(color.channels()[channel]) / 256.0;
        errors[0] = errors[0].max((of(seen) - expected[0].min(255.0)).abs());
        errors[1] = errors[1].max((of(lit) - expected[1].min(255.0)).abs());
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
        let fade = fade.map(|fade| fade.map(f64::from));
        let shininess = 1 + (number(1.0).abs() * 120.0) as u8;
        let suns = [0, 1].map(|i| Light::directional(along[i], colors[i]));
        let points = [0, 1].map(|i| Light::point(at[i], colors[i]).attenuation(attenuation[i]));
        let (inner, outer) = (20.0.degrees(), 50.0.degrees());
        let spots = [0, 1].map(|i| {
            Light::spot(at[i], along[i], inner, outer, colors[i]).attenuation(attenuation[i])
        });
        let sun_lamps = along.map(|along| Lamp::Sun(wide(along)));
        let point_lamps = [0, 1].map(|i| Lamp::Point(wide(at[i]), fade[i]));
        let spot_lamps = [0, 1].map(|i| {
            let cosines = (f64::from(inner.cos()), f64::from(outer.cos()));
            Lamp::Spot(wide(at[i]), fade[i], wide(along[i]), cosines.0, cosines.1)
        });
        let errors = [
            check(&scene, &suns, sun_lamps, shininess, false),
            check(&scene, &points, point_lamps, shininess, true),
            check(&scene, &spots, spot_lamps, shininess, false),
            check(
                &scene,
                &[suns[0].any(), spots[1].any()],
                [sun_lamps[0], spot_lamps[1]],
                shininess,
                true,
            ),
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
        let to_light = unit(wide(along).map(|v| -v));
        for (i, pixel) in pixels.iter().enumerate().filter(|(_, pixel)| **pixel != 0) {
            let at = [16 * (i % 40) + 8, 16 * (i / 40) + 8].map(|v| v as f64);
            let p = places.map(|place| place.map(f64::from));
            let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            };
            let whole = area(p[0], p[1], p[2]);
            let weights = [area(p[1], p[2], at), area(p[2], p[0], at), area(p[0], p[1], at)]
                .map(|part| part / whole);
            let n =
                unit([0, 1, 2].map(|axis| {
                    (0..3).map(|k| weights[k] * f64::from(normals[k][axis])).sum::<f64>()
                }));
            let halfway = unit([to_light[0], to_light[1], to_light[2] + 1.0]);
            let shine = dot(n, halfway).max(0.0).powi(shininess.into());
            let [r, g, b, _] = pixel.to_le_bytes();
            for (seen, (material, (highlight, light))) in [r, g, b].into_iter().zip(
                [150.0, 160.0, 170.0]
                    .into_iter()
                    .zip([60.0, 50.0, 40.0].into_iter().zip([200.0, 180.0, 160.0])),
            ) {
                let lit = material * dot(n, to_light).max(0.0) + highlight * shine;
                let expected: f64 = material * 20.0 / 255.0 + light / 255.0 * lit;
                worst = worst.max((f64::from(seen) - expected.min(255.0)).abs());
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
