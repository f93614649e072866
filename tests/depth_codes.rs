//! Depth that a row of the matrix makes: codes to the last one, their stated bound, the near plane.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small pictures and random numbers"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::{
    Always, Camera, Flat, Frame, Mesh, Pass, Rgb, Rgb565, Shader, Size, Stats, Topology,
};
use support::{InClipSpace, Random};

const SIZE: Size = Size::new(32, 32);

/// The depth codes after a drawing, 0 where nothing was drawn.
fn codes<H: Shader>(
    camera: &Camera,
    model: &Mat4,
    mesh: &Mesh<'_, H::Vertex, impl Topology<Primitive = [u32; 3]>>,
    shader: &H,
) -> Vec<u16> {
    let (mut pixels, mut depth) = (vec![0; 32 * 32], vec![0; 32 * 32]);
    let mut stats = Stats::default();
    let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
    Pass::new(camera).depth(Always).count(&mut stats).draw(&mut frame, model, mesh, shader);
    assert_eq!(stats.skipped, 0, "what is drawn is in range");
    depth
}

/// Rounded to nearest, and a thousandth that the division may be off.
const NEAREST: f64 = 0.5 + 1.0 / 1024.0;

#[test]
fn codes_of_clip_space_are_the_nearest_to_z_over_w() {
    let mut random = Random(61);
    let camera = Camera::custom(Mat4::identity());
    let code = |z: i32, w: i32| {
        let sheet = [[-3 * w, -3 * w, z, w], [3 * w, -3 * w, z, w], [0, 3 * w, z, w]];
        let codes = codes(&camera, &Mat4::identity(), &Mesh::new(&[], &sheet), &InClipSpace);
        assert!(codes.iter().all(|code| *code == codes[0]), "a sheet has one code");
        codes[0]
    };
    let (mut lowest, mut highest) = (0.0, 0.0_f64);
    for _ in 0..4_000 {
        let w = (random.range(1 << 27, (1 << 28) - 1) >> random.range(0, 20)).max(1);
        let z = random.range(0, w);
        let exact = 2.0 + 65_531.0 * f64::from(z) / f64::from(w);
        let off = f64::from(code(z, w)) - exact;
        assert!(off.abs() <= NEAREST, "{off} off {exact}: {z} / {w}");
        (lowest, highest) = (off.min(lowest), off.max(highest));
        assert_eq!((code(0, w), code(w, w)), (2, 65_533), "the ends: {w}");
    }
    assert!(lowest < -0.49 && highest > 0.49, "both ways: {lowest} to {highest}");
}

/// A sheet across the view at each distance that steps of 1/32768 make.
fn sheet(level: i16) -> [[i16; 3]; 3] {
    [[-32_000, -32_000, level], [32_000, -32_000, level], [0, 32_000, level]]
}

#[test]
fn codes_of_cameras_whose_matrix_is_exact_are_the_nearest() {
    const STEP: f32 = 1.0 / 32_768.0;
    // Between distances 1 and 2: z' = 2 - d. Then 1 - d, which is linear.
    let far = Camera::perspective(90.0.degrees(), 1.0).far(2.0);
    let orthographic = Camera::orthographic(2.0, 1.0, 2.0);
    let custom = Camera::custom(Mat4::from_rows(
        Vec4::new(1.0, 0.0, 0.0, 0.0),
        Vec4::new(0.0, 1.0, 0.0, 0.0),
        Vec4::new(0.0, 0.0, 0.5, 1.0),
        Vec4::new(0.0, 0.0, 0.0, 1.0),
    ));
    for level in (-32_768..=32_767).step_by(97) {
        let (corners, colors) = (sheet(level), [Rgb::WHITE; 3]);
        let mesh = Mesh::new(&corners, &colors)
            .placed(Vec3::new(4.0 * STEP, 4.0 * STEP, 0.5 * STEP), Vec3::new(0.0, 0.0, -1.5));
        let distance = 1.5 - f64::from(level) / 65_536.0;
        let depths = [
            ("far plane", far, (2.0 - distance) / distance),
            ("orthographic", orthographic, 2.0 - distance),
            ("custom", custom, 1.0 - distance / 2.0),
        ];
        for (name, camera, depth) in depths {
            let codes = codes(&camera, &Mat4::identity(), &mesh, &Flat::colored());
            let (code, exact) = (f64::from(codes[16 * 32 + 16]), 2.0 + 65_531.0 * depth);
            assert!((code - exact).abs() <= NEAREST, "{name}: {code} for {exact}");
        }
    }
}

/// A rotation by thirds, and a mesh of two triangles that it turns into a sheet across the view:
/// all sixteen numbers of the matrix count, and every corner lies in one plane exactly.
fn turned(level: i32) -> (Mat4, [[i16; 3]; 4]) {
    let third = 1.0 / 3.0;
    let rotation = Mat4::from_rows(
        Vec4::new(2.0, -1.0, 2.0, 0.0) * third,
        Vec4::new(2.0, 2.0, -1.0, 0.0) * third,
        Vec4::new(-1.0, 2.0, 2.0, 0.0) * third,
        Vec4::W,
    );
    // Three times as far in each direction as the numbers here say.
    let corner = |k: i32, j: i32| {
        [2 * k + 2 * j - level, 2 * j - k + 2 * level, 2 * k - j + 2 * level].map(|v| v as i16)
    };
    (
        rotation,
        [
            corner(-6_000, -6_000),
            corner(6_000, -6_000),
            corner(6_000, 6_000),
            corner(-6_000, 6_000),
        ],
    )
}

static SQUARE: [u8; 6] = [0, 1, 2, 0, 2, 3];

#[test]
fn a_surface_exactly_on_the_near_plane_is_drawn() {
    let mut random = Random(62);
    let (rotation, corners) = turned(0);
    for _ in 0..300 {
        let near = (0.05 + 3.0 * random.unit()) as f32;
        let far = near * (1.5 + 100.0 * random.unit()) as f32;
        let cameras = [
            ("far plane", Camera::perspective(90.0.degrees(), near).far(far)),
            ("orthographic", Camera::orthographic(2.0 * near, near, far)),
            ("custom", Camera::custom(Mat4::perspective(80.0.degrees(), 1.0, near, Some(far)))),
            ("no far plane", Camera::perspective(90.0.degrees(), near)),
        ];
        // As wide as the view, or a little more.
        let scale = near * (1.05 + 2.0 * random.unit() as f32) / 18_000.0;
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -near)) * rotation;
        let mesh = Mesh::new(&corners, &[Rgb::WHITE; 4])
            .indexed(&SQUARE)
            .placed(Vec3::splat(scale), Vec3::ZERO);
        for (name, camera) in cameras {
            let codes = codes(&camera, &model, &mesh, &Flat::colored());
            let missing = codes.iter().filter(|code| **code == 0).count();
            assert_eq!(missing, 0, "{name}: near {near}, far {far}, scale {scale}");
        }
    }
}

/// The largest clip coordinate that a position of +-32768 by axis may reach.
fn reach(matrix: &Mat4, scale: f64) -> f64 {
    let columns = matrix.to_columns().map(|column| column.map(|v| f64::from(v).abs()));
    let [a, b, c, d] = columns;
    let rows = [0, 1, 2, 3].map(|row| (a[row] + b[row] + c[row]) * 32_768.0 * scale + d[row]);
    rows.into_iter().fold(0.0, f64::max)
}

#[test]
fn codes_of_turned_meshes_keep_the_stated_bound() {
    let mut random = Random(63);
    let (mut compared, mut worst) = (0, [0.0_f64; 2]);
    for i in 0..2_000 {
        let orthographic = i % 2 == 1;
        let level = random.range(-3_000, 3_000);
        let (rotation, corners) = turned(level);
        let near = 0.01 * 300.0_f64.powf(random.unit());
        let far = near * 2.0 * 1000.0_f64.powf(random.unit());
        // A mesh of any size in front of the camera; its sheet is between near and far.
        let size = far * random.unit().powi(2);
        let scale = size / 18_000.0;
        let middle = near + (far - near) * random.unit();
        let distance = middle - 3.0 * f64::from(level) * scale;
        if !(near * 1.05..far * 0.95).contains(&distance) {
            continue;
        }
        let camera = if orthographic {
            Camera::orthographic((size * (0.1 + random.unit())) as f32, near as f32, far as f32)
        } else {
            Camera::perspective(45.0.degrees(), near as f32).far(far as f32)
        };
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -middle as f32)) * rotation;
        let mesh = Mesh::new(&corners, &[Rgb::WHITE; 4])
            .indexed(&SQUARE)
            .placed(Vec3::splat(scale as f32), Vec3::ZERO);
        let codes = codes(&camera, &model, &mesh, &Flat::colored());
        let w = if orthographic { 1.0 } else { distance };
        let depth = if orthographic {
            (far - distance) / (far - near)
        } else {
            near * (far - distance) / ((far - near) * distance)
        };
        let reach = reach(&(camera.projection(1.0) * model), scale);
        // Half a code of rounding; numbers of the matrix are floats of 24 bits before all else.
        let bound = 0.51 + 6.01 * (1.0 + depth) * reach / w;
        for code in codes.into_iter().filter(|code| *code != 0) {
            let off = (f64::from(code) - (2.0 + 65_531.0 * depth)).abs();
            assert!(off <= bound, "{off} above {bound}: near {near}, far {far}, at {distance}");
            worst[i % 2] = worst[i % 2].max((off - 0.5) / (bound - 0.5));
            compared += 1;
        }
    }
    println!("of the bound at most {worst:?}");
    assert!(compared > 100_000, "hardly tested: {compared}");
    assert!(worst.iter().all(|part| *part > 0.1), "a bound far from what happens: {worst:?}");
}
