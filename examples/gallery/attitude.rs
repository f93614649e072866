//! The attitude of an inertial sensor: a board that rolls, pitches and yaws, with its axes.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::{
    Camera, Consecutive, Cull, DepthBuffer, Flat, Frame, Gouraud, Lambert, Less, LessEqual, Light,
    LineList, Mesh, Normal, Pass, Rgb, Rgb565, Stats, Tinted, Wide,
};

use super::font;

/// Roll, pitch and yaw in degrees: about the board's x axis, which points forward, its y axis, to
/// the left, and its z axis, up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Attitude {
    pub(crate) roll: f32,
    pub(crate) pitch: f32,
    pub(crate) yaw: f32,
}

impl Attitude {
    /// From the board to the world: yaw, then pitch, then roll, as sensors give them.
    fn matrix(self) -> Mat4 {
        Mat4::rotation_z(self.yaw.degrees())
            * Mat4::rotation_y(self.pitch.degrees())
            * Mat4::rotation_x(self.roll.degrees())
    }
}

/// Draws the board; from 128x64 pixels on.
pub(crate) fn draw(
    frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
    attitude: Attitude,
    stats: &mut Stats,
) {
    frame.clear(Rgb::new(10, 14, 24));
    let camera = Camera::perspective(36.0.degrees(), 0.5).look_at(
        Vec3::new(-2.6, -3.2, 2.3),
        Vec3::new(0.25, 0.1, 0.05),
        Vec3::Z,
    );
    let is_large = frame.picture().height >= 160;
    let width = if is_large { 3 } else { 1 };

    // The level plane, which stays.
    let plane = Mesh::new(&GRID, &[(); GRID.len()])
        .with_topology(LineList::new(Consecutive::new(GRID.len())))
        .placed(Vec3::splat(0.5), Vec3::new(0.0, 0.0, -0.9));
    let mut pass = Pass::new(&camera).depth(Less).count(stats);
    pass.draw_lines(frame, &Mat4::identity(), &plane, &Flat::solid(Rgb::new(44, 60, 84)), Wide(1));

    let model = attitude.matrix();
    let sun = Light::directional(Vec3::new(0.5, 0.9, -1.0), Rgb::new(130, 130, 130));
    let light = Lambert::new(&[sun]).ambient(Rgb::new(150, 150, 150));
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).count(stats);
    let board = Mesh::new(&BOARD, &SIDES).by_face().indexed(&INDICES).placed(BOX, Vec3::ZERO);
    pass.draw(frame, &model, &board, &Flat::new(Tinted(light)));

    let axes = Mesh::new(&AXES, &AXIS_COLORS)
        .with_topology(LineList::new(Consecutive::new(AXES.len())))
        .placed(Vec3::splat(0.1), Vec3::ZERO);
    let mut pass = Pass::new(&camera).depth(LessEqual).count(stats);
    pass.draw_lines(frame, &model, &axes, &Gouraud::colored(), Wide(width));

    // Letters at the tips, turned to the viewer: by the rows of the camera's own rotation.
    let rows = camera.view().transpose();
    let [right, up, back] = [rows.x, rows.y, rows.z].map(|row| row.truncate().extend(0.0));
    let to_viewer = Mat4::from_columns(right, up, back, Vec4::W);
    let tips = [
        (Vec3::X * 1.85, &X[..], RED),
        (Vec3::Y * 1.6, &Y[..], GREEN),
        (Vec3::Z * 1.5, &Z[..], BLUE),
    ];
    for (tip, letter, color) in tips {
        let letter = Mesh::new(letter, &[(); 6])
            .with_topology(LineList::new(Consecutive::new(letter.len())))
            .placed(Vec3::splat(0.045), Vec3::ZERO);
        let place = Mat4::translation(model.transform_point(tip)) * to_viewer;
        pass.draw_lines(frame, &place, &letter, &Flat::solid(color), Wide(width));
    }

    let dot = if is_large { 2 } else { 1 };
    let Attitude { roll, pitch, yaw } = attitude;
    let rows = [(b'R', roll, RED), (b'P', pitch, GREEN), (b'Y', yaw, BLUE)];
    for ((name, degrees, color), row) in rows.into_iter().zip(0..) {
        let at = (2 * i32::from(dot), (2 + 9 * row) * i32::from(dot));
        font::write(frame, at, dot, color, &label(name, degrees), stats);
    }
}

const RED: Rgb = Rgb::new(255, 70, 60);
const GREEN: Rgb = Rgb::new(80, 230, 90);
const BLUE: Rgb = Rgb::new(90, 150, 255);
const GOLD: Rgb = Rgb::new(250, 200, 70);
/// The sides that look backwards along their axes.
const DARK_RED: Rgb = Rgb::new(150, 52, 52);
const DARK_GREEN: Rgb = Rgb::new(44, 130, 66);
const DARK_BLUE: Rgb = Rgb::new(44, 70, 150);

/// A letter, a sign and three digits.
fn label(name: u8, degrees: f32) -> [u8; 5] {
    let sign = if degrees < 0.0 { b'-' } else { b'+' };
    let whole = (degrees.abs() + 0.5) as u32;
    let digit = |of: u32| b'0' + (whole / of % 10) as u8;
    [name, sign, digit(100), digit(10), digit(1)]
}

/// Half the board's sides, 32767 being a step's most.
const BOX: Vec3 = Vec3::new(0.85 / 32_767.0, 0.6 / 32_767.0, 0.2 / 32_767.0);

const A: i16 = i16::MAX;
static BOARD: [[i16; 3]; 8] = [
    [-A, -A, -A],
    [A, -A, -A],
    [A, A, -A],
    [-A, A, -A],
    [-A, -A, A],
    [A, -A, A],
    [A, A, A],
    [-A, A, A],
];

/// Up, down, front, back, left, right: two triangles each.
static INDICES: [u16; 36] = [
    4, 5, 6, 4, 6, 7, 0, 3, 2, 0, 2, 1, 1, 2, 6, 1, 6, 5, 3, 0, 4, 3, 4, 7, 2, 3, 7, 2, 7, 6, 0, 1,
    5, 0, 5, 4,
];

static SIDES: [(Normal, Rgb); 12] = [
    ([0, 0, 127], GOLD),
    ([0, 0, 127], GOLD),
    ([0, 0, -127], DARK_BLUE),
    ([0, 0, -127], DARK_BLUE),
    ([127, 0, 0], RED),
    ([127, 0, 0], RED),
    ([-127, 0, 0], DARK_RED),
    ([-127, 0, 0], DARK_RED),
    ([0, 127, 0], GREEN),
    ([0, 127, 0], GREEN),
    ([0, -127, 0], DARK_GREEN),
    ([0, -127, 0], DARK_GREEN),
];

/// Axes with arrows, in tenths.
static AXES: [[i16; 3]; 18] = [
    [0, 0, 0],
    [16, 0, 0],
    [16, 0, 0],
    [13, 1, 0],
    [16, 0, 0],
    [13, -1, 0],
    [0, 0, 0],
    [0, 13, 0],
    [0, 13, 0],
    [1, 10, 0],
    [0, 13, 0],
    [-1, 10, 0],
    [0, 0, 0],
    [0, 0, 12],
    [0, 0, 12],
    [1, 0, 9],
    [0, 0, 12],
    [-1, 0, 9],
];

static AXIS_COLORS: [Rgb; 18] = {
    let (mut colors, mut i) = ([RED; 18], 0);
    while i < 18 {
        colors[i] = [RED, GREEN, BLUE][i / 6];
        i += 1;
    }
    colors
};

/// Letters of two or three lines.
static X: [[i16; 3]; 4] = [[-2, -3, 0], [2, 3, 0], [-2, 3, 0], [2, -3, 0]];
static Y: [[i16; 3]; 6] = [[-2, 3, 0], [0, 0, 0], [2, 3, 0], [0, 0, 0], [0, 0, 0], [0, -3, 0]];
static Z: [[i16; 3]; 6] = [[-2, 3, 0], [2, 3, 0], [2, 3, 0], [-2, -3, 0], [-2, -3, 0], [2, -3, 0]];

/// Nine lines each way.
static GRID: [[i16; 3]; 36] = {
    let (mut ends, mut i) = ([[0; 3]; 36], 0);
    while i < 9 {
        let at = i as i16 - 4;
        ends[4 * i] = [at, -4, 0];
        ends[4 * i + 1] = [at, 4, 0];
        ends[4 * i + 2] = [-4, at, 0];
        ends[4 * i + 3] = [4, at, 0];
        i += 1;
    }
    ends
};
