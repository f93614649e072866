//! A spinning box with a logo on its sides: a texture in perspective, and text in it.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::texture::{Bilinear, Clamp, Sampler, Texture};
use microraster::{
    Camera, Cull, DepthBuffer, Flat, Frame, Lambert, Less, Light, Mesh, Normal, Pass, Rgb, Rgb565,
    Stats, Textured,
};

use super::font;

/// Draws the box; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(Rgb::new(226, 232, 240));
    let camera = Camera::perspective(40.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.0, 5.2),
        Vec3::new(0.0, -0.05, 0.0),
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.4, -0.5, -1.0), Rgb::new(170, 170, 165));
    let light = Lambert::new(&[sun]).ambient(Rgb::new(104, 104, 116));
    let shader = Textured::on(Flat::new(light), LOGO);
    let sides = Mesh::new(&POSITIONS, &ATTRIBUTES)
        .indexed(&INDICES)
        .placed(Vec3::splat(1.0 / REACH as f32), Vec3::ZERO);
    let model = Mat4::rotation_x(12.0.degrees()) * Mat4::rotation_y(turn.degrees());
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).count(stats);
    pass.draw(frame, &model, &sides, &shader);
}

const REACH: i16 = i16::MAX;

/// Six sides of four corners, counter-clockwise from the lower left.
static POSITIONS: [[i16; 3]; 24] = {
    let (mut positions, mut i) = ([[0; 3]; 24], 0);
    while i < 24 {
        let ([right, up], side) = (CORNERS[i % 4], &SIDES[i / 4]);
        let mut axis = 0;
        while axis < 3 {
            positions[i][axis] = REACH
                * (side.out[axis] as i16
                    + side.right[axis] as i16 * right
                    + side.up[axis] as i16 * up);
            axis += 1;
        }
        i += 1;
    }
    positions
};

/// The normal of each vertex, and its place in the texture: 4096 units a side.
static ATTRIBUTES: [(Normal, [i16; 2]); 24] = {
    let (mut attributes, mut i) = ([([0; 3], [0; 2]); 24], 0);
    while i < 24 {
        let ([right, up], out) = (CORNERS[i % 4], SIDES[i / 4].out);
        attributes[i] =
            ([127 * out[0], 127 * out[1], 127 * out[2]], [2048 * (1 + right), 2048 * (1 - up)]);
        i += 1;
    }
    attributes
};

static INDICES: [u16; 36] = {
    let (mut indices, mut i) = ([0; 36], 0);
    while i < 36 {
        indices[i] = [0, 1, 2, 0, 2, 3][i % 6] + i as u16 / 6 * 4;
        i += 1;
    }
    indices
};

const CORNERS: [[i16; 2]; 4] = [[-1, -1], [1, -1], [1, 1], [-1, 1]];

/// Where a side of the box looks to, and how the picture lies on it.
struct Side {
    out: [i8; 3],
    right: [i8; 3],
    up: [i8; 3],
}

const SIDES: [Side; 6] = [
    Side { out: [0, 0, 1], right: [1, 0, 0], up: [0, 1, 0] },
    Side { out: [1, 0, 0], right: [0, 0, -1], up: [0, 1, 0] },
    Side { out: [0, 0, -1], right: [-1, 0, 0], up: [0, 1, 0] },
    Side { out: [-1, 0, 0], right: [0, 0, 1], up: [0, 1, 0] },
    Side { out: [0, 1, 0], right: [1, 0, 0], up: [0, 0, -1] },
    Side { out: [0, -1, 0], right: [1, 0, 0], up: [0, 0, 1] },
];

/// Texels along each side of the picture.
const SIDE: usize = 128;

static TEXELS: [u16; SIDE * SIDE] = {
    let (mut texels, mut i) = ([0; SIDE * SIDE], 0);
    while i < texels.len() {
        texels[i] = texel((i % SIDE) as i32, (i / SIDE) as i32);
        i += 1;
    }
    texels
};

const LOGO: Sampler<'static, Rgb565, Bilinear, Clamp> = {
    let texture = match Texture::new(&TEXELS, SIDE as u16, SIDE as u16) {
        Ok(texture) => texture,
        Err(_) => panic!("as many texels as the sides say"),
    };
    match Sampler::new(texture, Bilinear, Clamp, Clamp) {
        Ok(sampler) => sampler,
        Err(_) => panic!("the sides are powers of two"),
    }
};

/// The logo: the triangle that everyone draws first, and a name under it.
const fn texel(x: i32, y: i32) -> u16 {
    let edge = SIDE as i32 - 1;
    let frame = min(min(x, edge - x), min(y, edge - y));
    if frame < 3 {
        return rgb565(255, 255, 255);
    }
    if is_text(x, y, 20, 72, b"MICRO") || is_text(x, y, 11, 99, b"RASTER") {
        return rgb565(255, 255, 255);
    }
    // Twice the areas that a point makes with the sides of the triangle.
    let [a, b, c] = [[64, 12], [30, 62], [98, 62]];
    let areas = [area(b, c, [x, y]), area(c, a, [x, y]), area(a, b, [x, y])];
    let all = area(a, b, c);
    if areas[0] <= 0 && areas[1] <= 0 && areas[2] <= 0 {
        let [r, g, b] = [areas[0] * 255 / all, areas[1] * 255 / all, areas[2] * 255 / all];
        return rgb565(r, g, b);
    }
    rgb565(22 + y / 6, 34 + y / 4, 78 + y / 2)
}

/// Whether a texel belongs to a text of dots of 3x3 texels.
const fn is_text(x: i32, y: i32, left: i32, top: i32, text: &[u8]) -> bool {
    let (column, row) = ((x - left) / 3, (y - top) / 3);
    let letter = column / font::ADVANCE;
    if x < left || y < top || letter as usize >= text.len() {
        return false;
    }
    font::is_set(text[letter as usize], (column % font::ADVANCE) as usize, row as usize)
}

const fn area(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i32 {
    (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
}

const fn rgb565(r: i32, g: i32, b: i32) -> u16 {
    (r / 8 * 2048 + g / 4 * 32 + b / 8) as u16
}

const fn min(a: i32, b: i32) -> i32 {
    if a < b {
        a
    } else {
        b
    }
}
