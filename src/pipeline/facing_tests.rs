//! What planes leave out has, corner by corner, the side that is left out.

#![allow(clippy::cast_possible_truncation, reason = "numbers are cut to what is wanted")]

extern crate std;
use super::eye;
use crate::frame::Size;
use crate::math::hard_numbers::Random;
use crate::math::{Angle, Mat4, Vec3};
use crate::models::{TEAPOT_INDICES, TEAPOT_POSITIONS, TEAPOT_SCALE};
use crate::pipeline::assembly::area_of;
use crate::pipeline::mapping::Mapping;
use crate::pipeline::projected::flag;
use crate::pipeline::transform::Transform;
use crate::pipeline::{Cull, CulledWindings, Winding};
use crate::scene::{Facing, PlaneScale};

/// A mesh that is seen somehow: the transform, the mapping, what is left out.
struct View {
    transform: Transform,
    mapping: Mapping,
    culled: CulledWindings,
}

impl View {
    fn of(
        matrix: &Mat4,
        scale: Vec3,
        near: Option<f32>,
        size: Size,
        culled: CulledWindings,
    ) -> Option<Self> {
        let mut transform = Transform::NONE;
        let depth = transform.set(matrix, &(scale, Vec3::ZERO.extend(1.0)), near)?;
        Some(Self { transform, mapping: Mapping::new(3, -7, size, depth), culled })
    }

    fn facing(&self, scale: &PlaneScale) -> Facing {
        self.transform.facing(&self.mapping, self.culled, scale)
    }

    /// The area of a triangle as it is drawn; `None` where it would be cut.
    fn area(&self, corners: &[[i16; 3]; 3]) -> Option<i64> {
        let project = |position| {
            let (sides, z) =
                (self.transform.sides::<true>(position), || self.transform.z(position));
            self.mapping.project(sides, z)
        };
        let corners = corners.each_ref().map(project);
        let cut = corners.iter().any(|corner| corner.flags() & flag::CLIP != 0);
        (!cut).then(|| area_of(&corners))
    }

    /// The eye in steps of positions, or the direction towards it.
    fn eye(&self) -> [f64; 4] {
        let [x, y, _, w] = &self.transform.rows();
        let [a, b, c, d] = eye(x, y, w).map(|v| v as f64);
        [a, b, c, d / 65536.0]
    }
}

/// A lens, a place and a turn, or what else a matrix can do.
fn any_view(random: &mut Random) -> Option<View> {
    let mut side = || (random.word() % 600 + 1) as u16;
    let size = Size::new(side(), side());
    let mut unit = || random.float(1.0);
    let angle = |v: f32| Angle::from_degrees(v * 180.0);
    let turn = Mat4::rotation_x(angle(unit()))
        * Mat4::rotation_y(angle(unit()))
        * Mat4::rotation_z(angle(unit()));
    let lengths = Vec3::new(unit(), unit(), unit());
    let distance = 1.0 + (unit() + 1.0) * 4.0;
    let place = Mat4::translation(Vec3::new(unit(), unit(), -distance));
    let aspect = f32::from(size.width) / f32::from(size.height);
    let (lens, near) = match random.word() % 4 {
        0 => (Mat4::orthographic(-2.0, 2.0, -2.0, 2.0, 0.1, 20.0), None),
        1 => (Mat4::perspective(Angle::from_degrees(60.0), aspect, 0.1, Some(30.0)), None),
        _ => (Mat4::perspective(Angle::from_degrees(45.0), aspect, 0.1, None), Some(0.1)),
    };
    let winding = if random.word().is_multiple_of(2) {
        Winding::Clockwise
    } else {
        Winding::CounterClockwise
    };
    let culled = CulledWindings::new(Cull::Back, winding);
    let scale = match random.word() % 3 {
        0 => lengths,
        _ => Vec3::splat(lengths.x),
    };
    View::of(&(lens * place * turn), scale * (1.0 / 32768.0), near, size, culled)
}

/// A triangle of any size; every second one with the eye nearly in its plane.
fn any_triangle(random: &mut Random, eye: [f64; 4]) -> [[i16; 3]; 3] {
    let bits = random.word() % 17;
    let limited = |v: f64| v.clamp(-32768.0, 32767.0).round() as i16;
    let mut near = |at: [i16; 3], bits: u32| {
        at.map(|v| {
            limited(f64::from(v) + f64::from(random.word().cast_signed() >> (31 - bits.min(16))))
        })
    };
    let first = near([0; 3], 15);
    let (second, mut third) = (near(first, bits), near(first, bits));
    if bits.is_multiple_of(2) {
        let towards: [f64; 3] = core::array::from_fn(|at| eye[at] - f64::from(first[at]) * eye[3]);
        let length = towards.iter().map(|v| v * v).sum::<f64>().sqrt().max(1e-300);
        let way = f64::from(1u32 << bits) / length;
        let foot = core::array::from_fn(|at| limited(f64::from(first[at]) + towards[at] * way));
        third = near(foot, bits / 3);
    }
    [first, second, third]
}

#[test]
fn what_planes_leave_out_shows_the_other_side() {
    let mut random = Random::new(77);
    let (mut asked, mut left_out, mut turned_away) = (0, 0, 0);
    for _ in 0..4000 {
        let Some(view) = any_view(&mut random) else { continue };
        let eye = view.eye();
        for radius in [1, 40, 700, 9000] {
            let scale = PlaneScale { radius, reach: [32768; 3] };
            let facing = view.facing(&scale);
            if facing == Facing::NONE {
                continue;
            }
            for _ in 0..100 {
                let corners = any_triangle(&mut random, eye);
                let area = view.area(&corners).expect("all of the box is in the view's depth");
                let is_left_out = facing.leaves_out(&scale.plane(corners));
                asked += 1;
                let side = area.signum() as i32;
                let is_culled = side != 0 && view.culled.contain(side);
                assert!(is_culled || !is_left_out, "{corners:?} of area {area} at radius {radius}");
                left_out += u32::from(is_left_out);
                turned_away += u32::from(is_culled);
            }
        }
    }
    std::println!("asked {asked}, turned away {turned_away}, left out {left_out}");
    assert!(
        asked > 200_000 && left_out * 5 > turned_away,
        "{left_out} of {turned_away} in {asked}"
    );
}

#[test]
fn most_of_a_teapot_that_faces_away_is_left_out() {
    let scale = PlaneScale::of(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
    let planes: [_; 992] = scale.bake(&TEAPOT_POSITIONS, &TEAPOT_INDICES);
    let (mut left_out, mut culled) = (0, 0);
    for turn in 0..16u8 {
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -4.75))
            * Mat4::rotation_y(Angle::from_degrees(f32::from(turn) * 22.5));
        let lens = Mat4::perspective(Angle::from_degrees(45.0), 4.0 / 3.0, 0.5, None);
        let culls = CulledWindings::new(Cull::Back, Winding::CounterClockwise);
        let size = Size::new(320, 240);
        let view = View::of(&(lens * model), Vec3::splat(TEAPOT_SCALE), Some(0.5), size, culls)
            .expect("a matrix");
        let facing = view.facing(&scale);
        for (triangle, plane) in TEAPOT_INDICES.as_chunks::<3>().0.iter().zip(&planes) {
            let corners = triangle.map(|index| TEAPOT_POSITIONS[usize::from(index)]);
            let area = view.area(&corners).expect("it lies in the view");
            let (is_culled, is_left_out) = (area > 0, facing.leaves_out(plane));
            assert!(is_culled || !is_left_out, "{corners:?} of area {area}");
            culled += u32::from(is_culled);
            left_out += u32::from(is_left_out);
        }
    }
    std::println!("left out {left_out} of {culled}");
    assert!(left_out * 10 > culled * 8, "{left_out} of {culled}");
}
