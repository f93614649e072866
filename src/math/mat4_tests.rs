//! Tests of matrices: algebra, cameras, extremes.

extern crate std;
use super::hard_numbers::{Random, FLOATS};
use super::{AngleUnits, Mat4, Vec3, Vec4};

fn close(a: Mat4, b: Mat4, tolerance: f32) -> bool {
    let (a, b) = (a.to_columns(), b.to_columns());
    let mut pairs = a.iter().flatten().zip(b.iter().flatten());
    pairs.all(|(a, b)| (a - b).abs() <= tolerance)
}

fn near(a: Vec3, b: Vec3, tolerance: f32) -> bool {
    (a - b).length() <= tolerance
}

fn random_matrix(random: &mut Random) -> Mat4 {
    let mut column = || Vec4::from([(); 4].map(|()| random.float(2.0)));
    Mat4::from_columns(column(), column(), column(), column())
}

#[test]
fn product_applies_the_right_factor_first() {
    let mut random = Random::new(10);
    for _ in 0..1000 {
        let (a, b) = (random_matrix(&mut random), random_matrix(&mut random));
        let v = random_matrix(&mut random).x;
        assert!(((a * b) * v - a * (b * v)).length() < 1e-4);
        assert!(close((a * b).transpose(), b.transpose() * a.transpose(), 1e-5));
    }
    assert_eq!(Mat4::identity() * Vec4::new(1.0, 2.0, 3.0, 4.0), Vec4::new(1.0, 2.0, 3.0, 4.0));
}

#[test]
fn what_turns_nothing_is_not_multiplied() {
    let mut random = Random::new(13);
    for round in 0..1000 {
        let (mut a, mut b) = (random_matrix(&mut random), random_matrix(&mut random));
        if round % 2 == 0 {
            a = Mat4::IDENTITY;
        }
        if round % 3 == 0 {
            b = Mat4::IDENTITY;
        }
        // Zeros of both signs among the numbers.
        if round % 5 == 0 {
            (a.x.y, b.w.z) = (-0.0, -0.0);
        }
        assert_eq!(a.after(&b), a * b, "{a:?} after {b:?}");
    }
}

#[test]
fn inverse_undoes() {
    let mut random = Random::new(11);
    for _ in 0..10_000 {
        let m = random_matrix(&mut random);
        let determinant = m.determinant();
        if determinant.abs() < 0.1 {
            continue;
        }
        let inverse = m.inverse().unwrap();
        assert!(close(m * inverse, Mat4::identity(), 2e-4), "{m:?}");
        assert!((determinant * inverse.determinant() - 1.0).abs() < 1e-2, "{m:?}");
    }
    assert_eq!(Mat4::scale(Vec3::new(1.0, 0.0, 1.0)).inverse(), None);
    let scale = Mat4::scale(Vec3::new(2.0, 4.0, 8.0));
    assert_eq!(scale.inverse(), Some(Mat4::scale(Vec3::new(0.5, 0.25, 0.125))));
    assert_eq!(scale.determinant().to_bits(), 64.0f32.to_bits());
    assert!(Mat4::scale(Vec3::new(1.0, -1.0, 1.0)).determinant() < 0.0);
}

#[test]
fn rotations_turn_counter_clockwise() {
    let quarter = 90.0.degrees();
    assert_eq!(Mat4::rotation_x(quarter).transform_vector(Vec3::Y), Vec3::Z);
    assert_eq!(Mat4::rotation_y(quarter).transform_vector(Vec3::Z), Vec3::X);
    assert_eq!(Mat4::rotation_z(quarter).transform_vector(Vec3::X), Vec3::Y);
    for degrees in -36..36i8 {
        let angle = (f32::from(degrees) * 10.0).degrees();
        assert!(close(Mat4::rotation(Vec3::X * 3.0, angle), Mat4::rotation_x(angle), 1e-7));
        assert!(close(Mat4::rotation(Vec3::Y * 0.1, angle), Mat4::rotation_y(angle), 1e-7));
        assert!(close(Mat4::rotation(-Vec3::Z, angle), Mat4::rotation_z(-angle), 1e-7));
    }
    // A third of a turn about the diagonal permutes the axes.
    let permutation = Mat4::rotation(Vec3::ONE, 120.0.degrees());
    assert!(near(permutation.transform_vector(Vec3::X), Vec3::Y, 1e-6));
    assert_eq!(Mat4::rotation(Vec3::ZERO, quarter), Mat4::identity());
}

#[test]
fn look_at_puts_the_target_ahead() {
    let (eye, target) = (Vec3::new(3.0, 4.0, 5.0), Vec3::new(-1.0, 2.0, 0.5));
    let view = Mat4::look_at(eye, target, Vec3::Y);
    let ahead = Vec3::new(0.0, 0.0, -(target - eye).length());
    assert!(near(view.transform_point(eye), Vec3::ZERO, 2e-6));
    assert!(near(view.transform_point(target), ahead, 2e-6));
    assert!(view.transform_vector(Vec3::Y).y > 0.0);
    assert!(view.transform_vector(Vec3::Y).x.abs() < 1e-6);
    assert!((view.determinant() - 1.0).abs() < 1e-6);

    for (target, up) in [(eye, Vec3::Y), (target, target - eye), (target, Vec3::ZERO)] {
        let view = Mat4::look_at(eye, target, up);
        assert!((view.determinant() - 1.0).abs() < 1e-6, "{view:?}");
    }
}

#[test]
fn depth_is_one_at_the_near_plane_and_zero_at_the_far() {
    let depth = |m: Mat4, z: f32| (m * Vec4::new(0.1, 0.2, z, 1.0)).project().z;
    let fov = 60.0.degrees();
    for far in [1.0f32, 10.0, 1e3, 1e6] {
        for m in [
            Mat4::perspective(fov, 1.5, 0.5, Some(far)),
            Mat4::frustum(-0.2, 0.3, -0.1, 0.4, 0.5, Some(far)),
            Mat4::orthographic(-2.0, 3.0, -1.0, 4.0, 0.5, far),
        ] {
            assert!((depth(m, -0.5) - 1.0).abs() < 1e-6, "{far}");
            assert!(depth(m, -far).abs() < 1e-6, "{far}");
        }
    }
    let endless = Mat4::perspective(fov, 1.5, 0.5, None);
    assert_eq!(depth(endless, -0.5).to_bits(), 1.0f32.to_bits());
    assert_eq!(depth(endless, -1e6).to_bits(), 5e-7f32.to_bits());
    // Orthographic depth is linear.
    let flat = Mat4::orthographic(-1.0, 1.0, -1.0, 1.0, 1.0, 5.0);
    assert_eq!(depth(flat, -3.0).to_bits(), 0.5f32.to_bits());
}

#[test]
fn corners_of_the_view_go_to_corners_of_the_picture() {
    let screen = Mat4::viewport(10.0, 20.0, 320.0, 240.0);
    let pixel = |m: Mat4, p: Vec3| screen.transform_point((m * p.extend(1.0)).project());

    let m = Mat4::frustum(-1.0, 3.0, -2.0, 4.0, 1.0, None);
    assert!(near(pixel(m, Vec3::new(-2.0, 8.0, -2.0)), Vec3::new(10.0, 20.0, 0.5), 1e-3));
    assert!(near(pixel(m, Vec3::new(6.0, -4.0, -2.0)), Vec3::new(330.0, 260.0, 0.5), 1e-3));

    let m = Mat4::orthographic(-1.0, 3.0, -2.0, 4.0, 1.0, 5.0);
    assert!(near(pixel(m, Vec3::new(-1.0, 4.0, -1.0)), Vec3::new(10.0, 20.0, 1.0), 1e-3));
    assert!(near(pixel(m, Vec3::new(3.0, -2.0, -5.0)), Vec3::new(330.0, 260.0, 0.0), 1e-3));

    let lens = Mat4::perspective(90.0.degrees(), 320.0 / 240.0, 1.0, None);
    let window = Mat4::frustum(-4.0 / 3.0, 4.0 / 3.0, -1.0, 1.0, 1.0, None);
    assert!(close(lens, window, 1e-6));
}

#[test]
fn orthonormalize_keeps_mirrors_and_translation() {
    let mut random = Random::new(12);
    for _ in 0..10_000 {
        let m = random_matrix(&mut random);
        let m = Mat4::from_columns(
            m.x.truncate().extend(0.0),
            m.y.truncate().extend(0.0),
            m.z.truncate().extend(0.0),
            m.w.truncate().extend(1.0),
        );
        let clean = m.orthonormalize();
        assert_eq!(clean.w, m.w);
        assert!((clean.determinant().abs() - 1.0).abs() < 1e-5, "{m:?}");
        assert_eq!(clean.determinant() < 0.0, m.determinant() < 0.0, "{m:?}");
    }
    for flat in [Vec3::ZERO, Vec3::X, Vec3::splat(f32::NAN), Vec3::splat(f32::INFINITY)] {
        let column = flat.extend(0.0);
        let clean = Mat4::from_columns(column, column, column, Vec4::W).orthonormalize();
        assert!((clean.determinant().abs() - 1.0).abs() < 1e-5, "{flat:?} {clean:?}");
    }
}

#[test]
fn no_number_makes_a_matrix_panic() {
    for a in FLOATS {
        for b in FLOATS {
            let v = Vec3::new(a, b, 1.0);
            for m in [
                Mat4::translation(v),
                Mat4::scale(v),
                Mat4::rotation(v, a.radians()),
                Mat4::look_at(v, Vec3::new(b, a, a), v),
                Mat4::perspective(a.degrees(), b, a, Some(b)),
                Mat4::perspective(a.degrees(), b, b, None),
                Mat4::frustum(a, b, b, a, a, Some(b)),
                Mat4::orthographic(a, b, b, a, a, b),
                Mat4::viewport(a, b, b, a),
            ] {
                if let Some(inverse) = m.inverse() {
                    assert!(inverse.is_finite(), "{m:?}");
                }
                let clean = m.orthonormalize();
                assert!(clean.x.is_finite() && clean.y.is_finite() && clean.z.is_finite());
                let _ = (m * clean).transform_point(v);
            }
        }
    }
}
