//! A teapot and its shadow on a chequered floor that reaches behind the camera.
//!
//! The shadow is the teapot again, flattened onto the floor by a matrix. Where parts of it overlap
//! it must not darken twice, and depth alone sees to that: the flat teapot only marks its pixels as
//! nearer than the floor; the floor is then drawn once more, dark, wherever it is *farther* than
//! what is stored, which also puts its own depth back.

use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::models::TEAPOT;
use microraster::texture::{Bilinear, MipMap, MipSampler, Repeat};
use microraster::{
    BlinnPhong, Camera, Channels, ConstantAlpha, Cull, DepthBuffer, Flat, Fog, Fogged, Frame,
    Greater, IndexedList, Less, Light, Mesh, Pass, Phong, PolygonOffset, Rgb, Rgb565, Stats,
    Textured,
};

const HAZE: Rgb = Rgb::new(168, 188, 214);

/// Draws the teapot; `turn` in degrees.
pub(crate) fn draw(frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>, turn: f32, stats: &mut Stats) {
    frame.clear(HAZE);
    let camera = Camera::perspective(50.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 3.0, 6.2),
        Vec3::new(0.3, 1.0, 0.0),
        Vec3::Y,
    );
    let light = Vec3::new(0.75, -1.0, -0.5);
    let still = Mat4::identity();
    // On the floor, which has height 0.
    let model = Mat4::translation(Vec3::new(-0.3, 1.575, 0.0)) * Mat4::rotation_y(turn.degrees());

    let fog = Fog::linear(HAZE, 7.0, 24.0);
    let floor = Fogged::new(Textured::new(CHECKS), fog);
    Pass::new(&camera).depth(Less).count(stats).draw(frame, &still, &FLOOR, &floor);

    // Marks, by depth only: nearer than the floor by more than both may be off.
    let nearer = PolygonOffset::new(Less, I8F8::NEG_ONE, -8);
    Pass::new(&camera)
        .depth(nearer)
        .color_mask(Channels::<false, false, false>)
        .count(stats)
        .draw(frame, &(onto_floor(light) * model), &TEAPOT, &Flat::solid(Rgb::BLACK));
    // The shade of what is marked: the floor once more, black, half of it.
    let shade = Fogged::new(Flat::solid(Rgb::new(8, 12, 40)), fog);
    Pass::new(&camera)
        .depth(Greater)
        .blend(ConstantAlpha(140))
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
const FAR: i16 = 12 << UNIT_BITS;
const EDGE: i16 = i16::MAX;

static CORNERS: [[i16; 3]; 4] =
    [[-EDGE, 0, EDGE], [EDGE, 0, EDGE], [EDGE, 0, -EDGE], [-EDGE, 0, -EDGE]];
static PLACES: [((), [i16; 2]); 4] =
    [((), [-FAR, FAR]), ((), [FAR, FAR]), ((), [FAR, -FAR]), ((), [-FAR, -FAR])];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];
static FLOOR: Mesh<'static, ((), [i16; 2]), IndexedList<'static, u16>> =
    Mesh::new(&CORNERS, &PLACES)
        .indexed(&INDICES)
        .placed(Vec3::new(REACH / 32_767.0, 0.0, REACH / 32_767.0), Vec3::ZERO);

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
