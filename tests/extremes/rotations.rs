//! A million composed rotations.

use microraster::math::{AngleUnits, Mat4, Vec3};

/// The largest element of `m` transposed times `m` less the identity: how far axes are from being
/// of length 1 and perpendicular.
fn drift(m: Mat4) -> f32 {
    let (gram, one) = ((m.transpose() * m).to_columns(), Mat4::IDENTITY.to_columns());
    let pairs = gram.iter().flatten().zip(one.iter().flatten());
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// Axes and angles whose rotations round in different ways.
fn steps() -> [Mat4; 6] {
    let axis = Vec3::new(1.0, 2.0, 3.0);
    [
        Mat4::rotation(axis, 0.7.degrees()),
        Mat4::rotation(-axis, 0.001.degrees()),
        Mat4::rotation(Vec3::new(-5.0, 0.1, 0.3), 137.5.degrees()),
        Mat4::rotation_x(1.0.degrees()),
        Mat4::rotation_y(33.0.degrees()),
        Mat4::rotation_z(179.9.degrees()),
    ]
}

/// A rotation is off by as much as [`CLEAN`], and so is a product; a million times that is
/// (1 + 5e-7)^1000000 - 1. A step whose own rounding always goes one way comes to half of it.
const DRIFT: f32 = 0.65;
/// The stated drift of what is re-orthonormalised every 64 products.
const KEPT: f32 = 1e-5;
/// The stated drift just after it.
const CLEAN: f32 = 5e-7;

#[test]
fn a_million_composed_rotations_drift_as_stated_and_are_cured_by_orthonormalizing() {
    for step in steps() {
        let (mut kept, mut drifted) = (Mat4::IDENTITY, Mat4::IDENTITY);
        for i in 0..1_000_000_u32 {
            drifted = step * drifted;
            kept = step * kept;
            if i % 64 == 63 {
                kept = kept.orthonormalize();
            }
        }
        let (left, cured) = (drift(drifted), drift(drifted.orthonormalize()));
        println!("drift {left:e}, kept {:e}, cured {cured:e}", drift(kept));
        assert!(left <= DRIFT, "{left:e} of {step:?}");
        assert!(drift(kept) <= KEPT, "{:e} of {step:?}", drift(kept));
        assert!(cured <= CLEAN, "{cured:e} of {step:?}");
    }
}
