//! Light, textures and pictures' differences by closed forms.

use microraster::host::reference::compare::{
    covered_differently, rgb565, rgba8888, seen_differently, Difference, RGB565_STEPS,
    RGBA8888_STEPS,
};
use microraster::host::reference::lighting::{arriving, blinn_phong, lambert, Material, Surface};
use microraster::host::reference::{blended, Fog, MipTexture, TexelGrid, Texture};
use microraster::math::{AngleUnits, Vec3};
use microraster::texture::AnyWrap;
use microraster::{AnyBlend, Attenuation, Format, Light, Rgb, Rgb565, Rgba8888};

fn is_near(got: [f64; 3], exact: [f64; 3]) -> bool {
    got.iter().zip(exact).all(|(got, exact)| (got - exact).abs() < 1e-9)
}

#[test]
fn a_sphere_under_the_sun_is_as_bright_as_the_cosine() {
    let sun = Light::directional(-Vec3::Z * 3.0, Rgb::new(255, 102, 0)).any();
    let material = Material { ambient: [51.0; 3], color: [100.0, 200.0, 50.0], ..Material::WHITE };
    for step in 0..=36 {
        for around in 0..8 {
            let angle = f64::from(step * 5).to_radians();
            let turn = f64::from(around * 45).to_radians();
            let normal = [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()];
            let surface = Surface { point: normal, normal };
            let cosine = angle.cos().max(0.0);
            let exact = [20.0 + 100.0 * cosine, 40.0 + 80.0 * cosine, 10.0];
            let got = lambert(&[sun], &material, &surface);
            assert!(is_near(got, exact), "{got:?} for {exact:?} at {step}");
        }
    }
}

#[test]
fn a_highlight_is_the_power_of_the_cosine_to_the_direction_halfway() {
    // Light and eye at 60 degrees to each other: seen from halfway the normal gives the whole
    // highlight, 30 degrees from the light.
    let light = Light::directional(-Vec3::Z, Rgb::WHITE).any();
    let to_eye = [60.0_f64.to_radians().sin(), 0.0, 60.0_f64.to_radians().cos()];
    let material = Material {
        ambient: [0.0; 3],
        color: [100.0; 3],
        specular: [80.0; 3],
        emissive: [1.0, 2.0, 3.0],
        shininess: 10.0,
        two_sided: false,
    };
    for degrees in [0.0_f64, 20.0, 30.0, 45.0, 80.0] {
        let angle = degrees.to_radians();
        let surface = Surface { point: [0.0; 3], normal: [angle.sin(), 0.0, angle.cos()] };
        let shine = (degrees - 30.0).to_radians().cos().powi(10);
        let sum = 100.0 * angle.cos() + 80.0 * shine;
        let exact = [1.0, 2.0, 3.0].map(|own| own + sum);
        let got = blinn_phong(&[light], &material, &surface, to_eye);
        assert!(is_near(got, exact), "{got:?} for {exact:?} at {degrees}");
    }
    // From behind there is nothing but its own, unless both sides are seen.
    let behind = Surface { point: [0.0; 3], normal: [0.0, 0.0, -1.0] };
    let got = blinn_phong(&[light], &material, &behind, to_eye);
    assert!(is_near(got, material.emissive), "{got:?}");
    let both = Material { two_sided: true, ..material };
    let front = Surface { normal: [0.0, 0.0, 1.0], ..behind };
    let turned = blinn_phong(&[light], &both, &behind, to_eye);
    assert!(is_near(turned, blinn_phong(&[light], &material, &front, to_eye)), "{turned:?}");
}

#[test]
fn lamps_fade_with_distance_and_spots_with_the_angle() {
    let attenuation = Attenuation::new(1.0, 0.5, 0.25);
    let lamp = Light::point(Vec3::new(0.0, 0.0, 2.0), Rgb::WHITE).attenuation(attenuation).any();
    let (towards, strength) = arriving(&lamp, [0.0, 0.0, 0.0]);
    assert_eq!((towards, strength), ([0.0, 0.0, 1.0], 1.0 / 3.0), "1 + 1 + 1");
    let bright = Light::point(Vec3::Z, Rgb::WHITE).attenuation(Attenuation::new(0.5, 0.0, 0.0));
    assert_eq!(arriving(&bright.any(), [0.0; 3]).1, 1.0, "never more than all");
    let (inner, outer) = (30.0.degrees(), 60.0.degrees());
    let spot = Light::spot(Vec3::Z, -Vec3::Z * 5.0, inner, outer, Rgb::WHITE).any();
    for degrees in [0.0_f64, 29.0, 40.0, 50.0, 61.0, 89.0] {
        let angle = degrees.to_radians();
        let (_, strength) = arriving(&spot, [angle.sin(), 0.0, 1.0 - angle.cos()]);
        let [inner, outer] = [30.0_f64, 60.0].map(|degrees| degrees.to_radians().cos());
        let exact = ((angle.cos() - outer) / (inner - outer)).clamp(0.0, 1.0);
        // The light's cosines are `f32`.
        assert!((strength - exact).abs() < 1e-6, "{strength} for {exact} at {degrees}");
    }
}

#[test]
fn fog_is_what_its_formula_says() {
    let exponential = Fog::Exponential { density: 0.5 };
    let squared = Fog::ExponentialSquared { density: 0.5 };
    for (fog, distance, exact) in [
        (Fog::Linear { start: 2.0, end: 6.0 }, 1.0, 1.0),
        (Fog::Linear { start: 2.0, end: 6.0 }, 3.0, 0.75),
        (Fog::Linear { start: 2.0, end: 6.0 }, 7.0, 0.0),
        (exponential, 2.0, (-1.0_f64).exp()),
        (exponential, 4.0, (-2.0_f64).exp()),
        (squared, 4.0, (-4.0_f64).exp()),
    ] {
        assert!((fog.seen(distance) - exact).abs() < 1e-12, "{fog:?} at {distance}");
    }
}

#[test]
fn layers_of_glass_are_a_geometric_series() {
    for (alpha, layers) in [(51.0, 7), (127.5, 20), (200.0, 3)] {
        let part: f64 = alpha / 255.0;
        let mut color = [10.0, 200.0, 90.0];
        for _ in 0..layers {
            color = blended(AnyBlend::Alpha, [240.0, 100.0, 90.0, alpha], color);
        }
        let left = (1.0 - part).powi(layers);
        let exact = [240.0 - 230.0 * left, 100.0 + 100.0 * left, 90.0];
        assert!(is_near(color, exact), "{color:?} for {exact:?}");
    }
    let glow = blended(AnyBlend::Premultiplied, [50.0, 0.0, 250.0, 51.0], [100.0; 3]);
    assert!(is_near(glow, [130.0, 80.0, 255.0]), "{glow:?}");
    let mean = blended(AnyBlend::Average, [50.0, 0.0, 255.0, 0.0], [100.0; 3]);
    assert!(is_near(mean, [75.0, 50.0, 177.5]), "{mean:?}");
    let constant = blended(AnyBlend::ConstantAlpha(51), [200.0, 0.0, 100.0, 9.0], [100.0; 3]);
    assert!(is_near(constant, [120.0, 80.0, 100.0]), "{constant:?}");
    let product = blended(AnyBlend::Multiply, [255.0, 0.0, 51.0, 9.0], [100.0; 3]);
    assert!(is_near(product, [100.0, 0.0, 20.0]), "{product:?}");
    let sum = blended(AnyBlend::Add, [255.0, 0.0, 51.0, 9.0], [100.0; 3]);
    assert!(is_near(sum, [255.0, 100.0, 151.0]), "{sum:?}");
    let rest = blended(AnyBlend::Subtract, [255.0, 0.0, 51.0, 9.0], [100.0; 3]);
    assert!(is_near(rest, [0.0, 100.0, 49.0]), "{rest:?}");
}

fn texture(width: usize, height: usize, wrap: AnyWrap, value: impl Fn(f64, f64) -> f64) -> Texture {
    let texel = |i: usize| [value((i % width) as f64, (i / width) as f64); 4];
    let texels: Vec<[f64; 4]> = (0..width * height).map(texel).collect();
    let grid = TexelGrid { width, height, wraps: [wrap; 2] };
    Texture::new(grid, &texels).expect("as many texels")
}

#[test]
fn bilinear_is_exact_for_what_is_linear_by_either_axis() {
    let f = |x: f64, y: f64| 1.0 + 2.0 * x + 3.0 * y + 4.0 * x * y;
    let texture = texture(5, 4, AnyWrap::Clamp, f);
    for i in 0..=40 {
        for j in 0..=30 {
            // Between the middles of the outermost texels.
            let (x, y) = (f64::from(i) / 10.0, f64::from(j) / 10.0);
            let got = texture.bilinear([(x + 0.5) / 5.0, (y + 0.5) / 4.0])[1];
            assert!((got - f(x, y)).abs() < 1e-9, "{got} at {x}, {y}");
            let got = texture.nearest([(x + 0.51) / 5.0, (y + 0.51) / 4.0])[2];
            assert!((got - f((x + 0.51).floor(), (y + 0.51).floor())).abs() < 1e-9, "{got}");
        }
    }
}

#[test]
fn wraps_show_what_their_names_say() {
    // Five texels of 0 to 4 in a row, from -7 to 7.
    let rows = [
        (AnyWrap::Repeat, [3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2]),
        (AnyWrap::Clamp, [0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4]),
        (AnyWrap::Mirror, [3, 4, 4, 3, 2, 1, 0, 0, 1, 2, 3, 4, 4, 3, 2]),
    ];
    for (wrap, row) in rows {
        let texture = texture(5, 1, wrap, |x, _| x);
        for (at, expected) in (-7..).zip(row) {
            let u = (f64::from(at) + 0.5) / 5.0;
            let got = texture.nearest([u, 0.5])[0];
            assert_eq!(got, f64::from(expected), "{wrap:?} at {at}");
            assert!((texture.bilinear([u, 0.5])[0] - got).abs() < 1e-9, "its middle");
        }
    }
    let edge = texture(2, 1, AnyWrap::Repeat, |x, _| 100.0 * x).bilinear([0.0, 0.5])[0];
    assert_eq!(edge, 50.0, "half of the last and half of the first");
}

#[test]
fn smaller_copies_are_means_and_trilinear_goes_between_them() {
    let mips = MipTexture::new(texture(8, 4, AnyWrap::Repeat, |x, y| x + 10.0 * y));
    let sizes: Vec<_> = mips.levels().iter().map(|t| (t.grid().width, t.grid().height)).collect();
    assert_eq!(sizes, [(8, 4), (4, 2), (2, 1), (1, 1)], "halves");
    let last = mips.levels()[3].texels()[0][0];
    assert!((last - 18.5).abs() < 1e-9, "the mean of all is {last}");
    let grid = mips.levels()[0].grid();
    assert_eq!(grid.detail([1.0 / 8.0, 0.0], [0.0, 1.0 / 4.0]), 0.0, "a texel a pixel");
    assert_eq!(grid.detail([3.0 / 8.0, 1.0], [0.0, 0.0]), 5.0_f64.log2(), "by hypotenuse");
    for (detail, level) in [(-3.0, 0), (0.4, 0), (0.5, 0), (0.6, 1), (1.5, 1), (1.6, 2), (9.0, 3)] {
        assert_eq!(grid.nearest_level(detail), level, "{detail}");
    }
    let uv = [0.3, 0.6];
    let [a, b] = [1, 2].map(|level| mips.levels()[level].bilinear(uv)[0]);
    let got = mips.trilinear(uv, 1.25)[0];
    assert!((got - (0.75 * a + 0.25 * b)).abs() < 1e-9, "{got}");
    assert_eq!(mips.trilinear(uv, -1.0), mips.levels()[0].bilinear(uv), "larger than life");
    assert_eq!(mips.trilinear(uv, 8.0), mips.levels()[3].bilinear(uv), "the last one");
}

#[test]
fn differences_of_pictures_are_what_they_are() {
    let exact = [[100.0, 0.0, 255.0], [10.0, 20.0, 30.0]];
    let same = Difference::between(&exact, &exact, RGBA8888_STEPS);
    assert_eq!((same.mean, same.max, same.beyond_a_step), (0.0, 0.0, 0.0), "the same");
    assert!(same.psnr.is_infinite() && same.psnr > 0.0, "{same:?}");
    let drawn = [[106.0, 0.0, 255.0], [10.0, 21.0, 30.0]];
    let fine = Difference::between(&drawn, &exact, RGBA8888_STEPS);
    assert_eq!((fine.mean, fine.max, fine.beyond_a_step), (7.0 / 6.0, 6.0, 0.5), "{fine:?}");
    let psnr = 10.0 * (255.0_f64.powi(2) / (37.0 / 6.0)).log10();
    assert!((fine.psnr - psnr).abs() < 1e-9, "{fine:?}");
    assert_eq!(Difference::between(&drawn, &exact, RGB565_STEPS).beyond_a_step, 0.0, "coarser");
    let seen = [(None, Some(1)), (Some(2), Some(3)), (None, None)];
    let (a, b): (Vec<_>, Vec<_>) = seen.into_iter().unzip();
    assert_eq!((seen_differently(&a, &b), covered_differently(&a, &b)), (2, 1), "pixels");
    for word in [0, 0xF800, 0x07E0, 0x001F, 0x8410, 0xFFFF] {
        let color = Rgb565::unpack(word);
        let seen = [color.red(), color.green(), color.blue()].map(f64::from);
        let off = Difference::between(&[seen], &[rgb565(word)], RGBA8888_STEPS);
        assert!(off.max < 1.0, "{word:04x} is {seen:?}");
    }
    let word = Rgba8888::pack(microraster::Color::new(1, 2, 3));
    assert_eq!(rgba8888(word), [1.0, 2.0, 3.0], "as bytes lie in memory");
}
