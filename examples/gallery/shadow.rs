//! A teapot and its shadow on a chequered floor that reaches behind the camera.
//!
//! The shadow is the teapot again, flattened onto the floor by a matrix. Where parts of it overlap
//! it must not darken twice, and depth alone sees to that: the flat teapot only marks its pixels as
//! nearer than the floor; the floor is then drawn once more, dark, wherever it is *farther* than
//! what is stored, which also puts its own depth back.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "small counts, and floats that saturate"
)]

use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::models::TEAPOT;
use microraster::texture::{Bilinear, MipMap, MipSampler, Repeat};
use microraster::{
    AtFragments, BlinnPhong, Camera, Channels, ConstantAlpha, Cull, DepthBuffer, Flat, Fog, Fogged,
    Frame, Greater, Less, Light, Mesh, Pass, Phong, PolygonOffset, RestartIndices, Rgb, Rgb565,
    Stats, Textured, TriangleStrip,
};

const HAZE: Rgb = Rgb::new(168, 188, 214);

/// Draws the teapot; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(HAZE);
    let camera = Camera::perspective(50.0.degrees(), 0.5).look_at(
        Vec3::new(-0.6, 3.3, 8.2),
        Vec3::new(0.75, 1.05, 0.0),
        Vec3::Y,
    );
    let light = Vec3::new(0.95, -0.85, -0.3);
    let still = Mat4::identity();
    // On the floor, which has height 0.
    let model = Mat4::translation(Vec3::new(-0.3, 1.575, 0.0)) * Mat4::rotation_y(turn.degrees());

    let fog = Fog::linear(HAZE, 9.0, 26.0);
    let floor = Fogged::new(Textured::new(CHECKS), fog).at(AtFragments);
    Pass::new(&camera).depth(Less).count(stats).draw(frame, &still, &FLOOR, &floor);

    // Marks, by depth only: nearer than the floor by more than both may be off.
    let nearer = PolygonOffset::new(Less, I8F8::NEG_ONE, -8);
    Pass::new(&camera).depth(nearer).color_mask(Channels::<false, false, false>).count(stats).draw(
        frame,
        &(onto_floor(light) * model),
        &TEAPOT,
        &Flat::solid(Rgb::BLACK),
    );
    // The shade of what is marked: the floor once more, black, half of it.
    let shade = Fogged::new(Flat::solid(Rgb::new(8, 12, 40)), fog).at(AtFragments);
    Pass::new(&camera)
        .depth(Greater)
        .blend(ConstantAlpha(130))
        .count(stats)
        .draw(frame, &still, &FLOOR, &shade);

    let sun = Light::directional(light, Rgb::new(215, 205, 190));
    let china = BlinnPhong::new(&[sun])
        .ambient(Rgb::new(70, 76, 92))
        .material(Rgb::new(226, 120, 62))
        .specular(Rgb::new(150, 150, 150), 40);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).count(stats);
    pass.draw(frame, &model, &TEAPOT, &Phong::new(china));
}

/// Moves points along the light until they are on the floor.
fn onto_floor(light: Vec3) -> Mat4 {
    Mat4::from_rows(
        Vec4::new(1.0, -light.x / light.y, 0.0, 0.0),
        Vec4::ZERO,
        Vec4::new(0.0, -light.z / light.y, 1.0, 0.0),
        Vec4::W,
    )
}

/// Half the floor's side.
const REACH: f32 = 24.0;
/// Of a repeat of four squares, one side: 24 repeats in all.
const UNIT_BITS: u32 = 10;

/// Cells along a side of the floor: fog begins and ends in one of them, and is linear in each.
const CELLS: usize = 16;
const VERTICES: usize = (CELLS + 1) * (CELLS + 1);

/// A floor with places in a texture, in strips.
type Floor = Mesh<'static, ((), [i16; 2]), TriangleStrip<RestartIndices<'static, u16>>>;

static FLOOR: Floor = Mesh::new(&POSITIONS, &PLACES)
    .with_topology(TriangleStrip::new(RestartIndices::new(&INDICES)))
    .placed(Vec3::new(REACH / 32_767.0, 0.0, REACH / 32_767.0), Vec3::ZERO);

static POSITIONS: [[i16; 3]; VERTICES] = {
    let (mut positions, mut i) = ([[0; 3]; VERTICES], 0);
    while i < VERTICES {
        positions[i] = [along(i % (CELLS + 1), 32_767), 0, along(i / (CELLS + 1), 32_767)];
        i += 1;
    }
    positions
};

static PLACES: [((), [i16; 2]); VERTICES] = {
    let (mut places, mut i) = ([((), [0; 2]); VERTICES], 0);
    while i < VERTICES {
        let most = 12 << UNIT_BITS;
        places[i].1 = [along(i % (CELLS + 1), most), along(i / (CELLS + 1), most)];
        i += 1;
    }
    places
};

static INDICES: [u16; CELLS * (2 * CELLS + 3)] = {
    let (mut indices, mut i) = ([u16::MAX; CELLS * (2 * CELLS + 3)], 0);
    while i < indices.len() {
        let (row, place) = (i / (2 * CELLS + 3), i % (2 * CELLS + 3));
        if place < 2 * CELLS + 2 {
            indices[i] = ((row + place % 2) * (CELLS + 1) + place / 2) as u16;
        }
        i += 1;
    }
    indices
};

/// From -`most` to `most` in as many steps as there are cells.
const fn along(step: usize, most: i32) -> i16 {
    (2 * most * step as i32 / CELLS as i32 - most) as i16
}

/// Texels along each side of the squares' texture.
const SIDE: u16 = 16;
const WORDS: usize = MipMap::<Rgb565>::words_needed(SIDE, SIDE);

/// Two by two squares, and all smaller copies.
static TEXELS: [u16; WORDS] = {
    let (mut texels, mut i) = ([0; WORDS], 0);
    while i < 256 {
        texels[i] = if (i / 8 + i / 128) % 2 == 0 { 0xEF3B } else { 0x6B91 };
        i += 1;
    }
    match MipMap::<Rgb565>::reduce(&mut texels, SIDE, SIDE) {
        Ok(()) => texels,
        Err(_) => panic!("there is room for all copies"),
    }
};

const CHECKS: MipSampler<'static, Rgb565, Bilinear, Repeat> = {
    let mips = match MipMap::new(&TEXELS, SIDE, SIDE) {
        Ok(mips) => mips,
        Err(_) => panic!("all copies are there"),
    };
    MipSampler::new(mips, Bilinear, Repeat, Repeat).unit_bits(UNIT_BITS)
};
