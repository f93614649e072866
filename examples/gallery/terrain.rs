//! Hills from a height map, in strips, under fog.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::{
    Camera, Color, Cull, DepthBuffer, Dither4, Fog, Fogged, Frame, Gouraud, Lambert, Less, Light,
    Mesh, Normal, Pass, RestartIndices, Rgb, Rgb565, ScreenPass, Stats, Tinted, TriangleStrip,
};

pub(crate) const HAZE: Rgb = Rgb::new(214, 206, 200);
const ZENITH: Rgb = Rgb::new(70, 120, 190);

/// Draws the hills from a camera that turns; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(HAZE);
    sky(frame, stats);
    let camera = camera(turn);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).dither(Dither4).count(stats);
    let shader = Fogged::new(Gouraud::new(Tinted(light())), fog());
    pass.draw(frame, &Mat4::identity(), &hills(), &shader);
}

pub(crate) fn camera(turn: f32) -> Camera {
    let (sin, cos) = turn.degrees().sin_cos();
    let eye = Vec3::new(9.0 * sin, 3.4, 9.0 * cos);
    Camera::perspective(50.0.degrees(), 0.5).look_at(
        eye,
        Vec3::new(-1.5 * sin, 0.4, -1.5 * cos),
        Vec3::Y,
    )
}

/// The light, and what is light everywhere.
pub(crate) const SUN: Vec3 = Vec3::new(0.8, -0.55, 0.3);
pub(crate) const SUN_COLOR: Rgb = Rgb::new(235, 220, 190);
pub(crate) const AMBIENT: Rgb = Rgb::new(62, 70, 90);

pub(crate) fn light() -> Lambert<1> {
    Lambert::new(&[Light::directional(SUN, SUN_COLOR)]).ambient(AMBIENT)
}

/// How soon fog hides what is behind it, by unit of distance.
pub(crate) const DENSITY: f32 = 0.066;

pub(crate) fn fog() -> Fog {
    Fog::exponential_squared(HAZE, DENSITY)
}

/// A strip a row.
type Strips = TriangleStrip<RestartIndices<'static, u16>>;

pub(crate) const fn strips() -> Strips {
    TriangleStrip::new(RestartIndices::new(&INDICES))
}

/// The hills, each vertex with a normal and a colour.
type Hills = Mesh<'static, (Normal, Rgb), Strips>;

pub(crate) fn hills() -> Hills {
    Mesh::new(&GROUND.positions, &GROUND.attributes)
        .with_topology(strips())
        .placed(SCALE, Vec3::ZERO)
}

/// What a step of the hills' positions is.
pub(crate) const SCALE: Vec3 = Vec3::new(WIDE / 32_767.0, HIGH / 32_767.0, WIDE / 32_767.0);

/// A gradient over the upper half of the picture.
fn sky(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, stats: &mut Stats) {
    let size = frame.picture();
    let (right, bottom) = (i32::from(size.width) * 16, i32::from(size.height) * 16 / 2);
    let corner = |x, y, color| (ScreenVertex::from_bits(x, y, 0), Color::from(color));
    let [a, b] = [corner(0, 0, ZENITH), corner(right, 0, ZENITH)];
    let [c, d] = [corner(right, bottom, HAZE), corner(0, bottom, HAZE)];
    let mut pass = ScreenPass::new().dither(Dither4).count(stats);
    pass.triangles(frame, &Gouraud::colored(), &[[a, b, c], [a, c, d]]);
}

/// Half the side of the ground, and its greatest height.
const WIDE: f32 = 12.0;
const HIGH: f32 = 2.6;

/// Vertices along a side.
const SIDE: usize = 73;

pub(crate) struct Ground {
    pub(crate) positions: [[i16; 3]; SIDE * SIDE],
    pub(crate) attributes: [(Normal, Rgb); SIDE * SIDE],
}

pub(crate) static GROUND: Ground = {
    let (mut positions, mut attributes) =
        ([[0; 3]; SIDE * SIDE], [([0; 3], Rgb::BLACK); SIDE * SIDE]);
    let mut i = 0;
    while i < SIDE * SIDE {
        let (column, row) = ((i % SIDE) as i32, (i / SIDE) as i32);
        let at = (i / SIDE + 1) * WIDTH + i % SIDE + 1;
        let here = HEIGHTS[at];
        positions[i] = [place(column), here as i16, place(row)];
        // The slope from neighbour to neighbour, in units of the world.
        let (run, rise) = (2.0 * 2.0 * WIDE / (SIDE - 1) as f32, HIGH / 32_767.0);
        let dx = (HEIGHTS[at + 1] - HEIGHTS[at - 1]) as f32 * rise;
        let dz = (HEIGHTS[at + WIDTH] - HEIGHTS[at - WIDTH]) as f32 * rise;
        let unit = 127.0 / microraster::math::sqrt(dx * dx + dz * dz + run * run);
        let up = run * unit;
        attributes[i] =
            ([(-dx * unit) as i8, up as i8, (-dz * unit) as i8], color(here, up as i32));
        i += 1;
    }
    Ground { positions, attributes }
};

/// Heights of all vertices, and of one more around them.
static HEIGHTS: [i32; WIDTH * WIDTH] = {
    let (mut heights, mut i) = ([0; WIDTH * WIDTH], 0);
    while i < heights.len() {
        heights[i] = height((i % WIDTH) as i32 - 1, (i / WIDTH) as i32 - 1);
        i += 1;
    }
    heights
};
const WIDTH: usize = SIDE + 2;

/// A strip from row to row, each with a restart behind it.
static INDICES: [u16; (SIDE - 1) * (2 * SIDE + 1)] = {
    let (mut indices, mut i) = ([u16::MAX; (SIDE - 1) * (2 * SIDE + 1)], 0);
    while i < indices.len() {
        let (row, place) = (i / (2 * SIDE + 1), i % (2 * SIDE + 1));
        if place < 2 * SIDE {
            indices[i] = ((row + place % 2) * SIDE + place / 2) as u16;
        }
        i += 1;
    }
    indices
};

/// What grows where: by height, and by how level the ground is.
const fn color(height: i32, up: i32) -> Rgb {
    if height <= WATER {
        Rgb::new(70, 130, 170)
    } else if height < WATER + 900 {
        Rgb::new(214, 196, 140)
    } else if up < 88 {
        Rgb::new(128, 116, 104)
    } else if height > 20_000 {
        Rgb::new(250, 250, 255)
    } else if height > 14_000 {
        Rgb::new(140, 140, 110)
    } else {
        Rgb::new(96, 140, 62)
    }
}

const WATER: i32 = 3_000;

/// A vertex' coordinate by its column or row.
const fn place(at: i32) -> i16 {
    (at * 65_534 / (SIDE as i32 - 1) - 32_767) as i16
}

/// Five octaves of noise; valleys are filled with water.
const fn height(column: i32, row: i32) -> i32 {
    let (mut sum, mut octave) = (0, 0);
    while octave < 5 {
        // Cells of 24, 12, 6, 3, 1.5 vertices; heights in halves with each.
        sum += noise(column << octave, row << octave, octave) >> (octave + 1);
        octave += 1;
    }
    // About the middle of 65536, steeper above.
    let above = sum - 26_000;
    let height = if above > 0 { above + above / 64 * above / 420 } else { above };
    if height < WATER {
        WATER
    } else if height > 32_767 {
        32_767
    } else {
        height
    }
}

/// Numbers of 0 to 65535 on a grid of 24, smooth between.
const fn noise(x: i32, y: i32, seed: i32) -> i32 {
    let (cell_x, cell_y) = (x.div_euclid(24), y.div_euclid(24));
    let (u, v) = (ease(x.rem_euclid(24)), ease(y.rem_euclid(24)));
    let top = mix(hash(cell_x, cell_y, seed), hash(cell_x + 1, cell_y, seed), u);
    let bottom = mix(hash(cell_x, cell_y + 1, seed), hash(cell_x + 1, cell_y + 1, seed), u);
    mix(top, bottom, v)
}

/// From 0 to 256 over a cell, level at its ends.
const fn ease(part: i32) -> i32 {
    256 * part * part * (72 - 2 * part) / (24 * 24 * 24)
}

const fn mix(a: i32, b: i32, part: i32) -> i32 {
    a + (((b - a) * part) >> 8)
}

/// A number of 0 to 65535 that looks like any other.
const fn hash(x: i32, y: i32, seed: i32) -> i32 {
    let mut n = (x as u32)
        .wrapping_mul(0x9E37_79B1)
        .wrapping_add((y as u32).wrapping_mul(0x85EB_CA77))
        .wrapping_add((seed as u32).wrapping_mul(0xC2B2_AE3D));
    n = (n ^ (n >> 15)).wrapping_mul(0x2C1B_3C6D);
    n = (n ^ (n >> 12)).wrapping_mul(0x297A_2D39);
    ((n ^ (n >> 15)) >> 16) as i32
}
