//! What random scenes are made of: numbers, meshes, states.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "numbers are cut to what is wanted"
)]

use crate::choices::Choices;
use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::texture::{AnyFilter, AnySampler, AnyTexture, AnyWrap, Texture};
use microraster::{
    AnyBlend, AnyCompare, AnyDepth, AnyDepthState, AnyDither, AnyMask, AnyOperation, AnyStencil,
    Color, Cull, DepthTest, DrawContext, Normal, PointCoordinates, Rgb, Shader, Stencil, Stenciled,
    VertexInput, Winding,
};

/// Ways of drawing a mesh.
pub(crate) const KINDS: i32 = 19;

/// A float: ordinary, or any bits at all.
pub(crate) fn float(choices: &mut impl Choices, tame: bool) -> f32 {
    const HARD: [f32; 14] = [
        0.0,
        -0.0,
        1.0,
        -1.0,
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        f32::MAX,
        f32::MIN,
        f32::MIN_POSITIVE,
        1e-45,
        1e30,
        -1e-30,
        65_536.0,
    ];
    if tame {
        return choices.range(-32_768, 32_767) as f32 / 16_384.0;
    }
    match choices.range(0, 2) {
        0 => f32::from_bits(choices.range(i32::MIN, i32::MAX) as u32),
        1 => choices.one_of(&HARD),
        _ => {
            let exponent = f64::from(choices.range(-40, 40)).exp2();
            (f64::from(choices.range(-32_768, 32_767)) / 32_768.0 * exponent) as f32
        }
    }
}

pub(crate) fn vector(choices: &mut impl Choices, tame: bool) -> Vec3 {
    Vec3::new(float(choices, tame), float(choices, tame), float(choices, tame))
}

pub(crate) fn matrix(choices: &mut impl Choices, tame: bool) -> Mat4 {
    if tame {
        return Mat4::translation(vector(choices, true) - Vec3::Z)
            * Mat4::rotation_y((float(choices, true) * 90.0).degrees())
            * Mat4::scale(Vec3::splat((f64::from(float(choices, true)) * 1.5).exp2() as f32));
    }
    let mut row = || vector(choices, false).extend(float(choices, false));
    let (x, y, z) = (row(), row(), row());
    let w = if choices.is_one_in(3) {
        vector(choices, false).extend(float(choices, false))
    } else {
        Vec4::W
    };
    Mat4::from_rows(x, y, z, w)
}

pub(crate) fn cull(choices: &mut impl Choices) -> Cull {
    choices.one_of(&[Cull::None, Cull::Back, Cull::Front])
}

pub(crate) fn front(choices: &mut impl Choices) -> Winding {
    choices.one_of(&[Winding::CounterClockwise, Winding::Clockwise])
}

/// What becomes of colours.
pub(crate) fn output(choices: &mut impl Choices) -> (AnyBlend, AnyDither, AnyMask) {
    let constant = AnyBlend::ConstantAlpha(choices.range(0, 255) as u8);
    let blend = choices.one_of(&[
        AnyBlend::Replace,
        AnyBlend::Alpha,
        constant,
        AnyBlend::Premultiplied,
        AnyBlend::Add,
        AnyBlend::Multiply,
        AnyBlend::Subtract,
        AnyBlend::Average,
    ]);
    let dither = choices.one_of(&[AnyDither::Undithered, AnyDither::Four, AnyDither::Eight]);
    let bits = choices.range(0, 31);
    let is_written = |bit: i32| bits >= 8 || bits >> bit & 1 == 1;
    let mask = AnyMask { red: is_written(0), green: is_written(1), blue: is_written(2) };
    (blend, dither, mask)
}

/// Tests of depth, and of the stencil or not.
pub(crate) trait Tests: DepthTest + Copy {
    fn choose(choices: &mut impl Choices) -> Self;
}

impl Tests for AnyDepthState {
    fn choose(choices: &mut impl Choices) -> Self {
        let mut depth = Self::new(choices.one_of(&[
            AnyDepth::Off,
            AnyDepth::Less,
            AnyDepth::LessEqual,
            AnyDepth::Equal,
            AnyDepth::Greater,
            AnyDepth::GreaterEqual,
            AnyDepth::NotEqual,
            AnyDepth::Always,
        ]));
        depth.read_only = choices.is_one_in(4);
        depth.constant = choices.is_one_in(4);
        if choices.is_one_in(3) {
            let mut word = || choices.range(-32_768, 32_767) as i16;
            depth.offset = (I8F8::from_bits(word()), word());
            depth.range = (word() as u16, word() as u16);
        }
        depth
    }
}

impl Tests for Stenciled<AnyDepthState, AnyStencil> {
    fn choose(choices: &mut impl Choices) -> Self {
        let mut byte = || choices.range(0, 255) as u8;
        let (reference, read, write) = (byte() & 7, byte(), byte());
        let compare = choices.one_of(&[
            AnyCompare::Never,
            AnyCompare::Less,
            AnyCompare::LessEqual,
            AnyCompare::Equal,
            AnyCompare::GreaterEqual,
            AnyCompare::NotEqual,
            AnyCompare::Always,
        ]);
        let mut operation = || {
            choices.one_of(&[
                AnyOperation::Keep,
                AnyOperation::Replace,
                AnyOperation::Zero,
                AnyOperation::Invert,
                AnyOperation::IncrementClamp,
                AnyOperation::IncrementWrap,
                AnyOperation::DecrementClamp,
                AnyOperation::DecrementWrap,
            ])
        };
        let stencil = Stencil::new(compare, reference)
            .on_fail(operation())
            .on_depth_fail(operation())
            .on_pass(operation())
            .read_mask(read)
            .write_mask(write);
        Self::new(AnyDepthState::choose(choices), stencil)
    }
}

/// A mesh with all that shaders ask for, and a texture.
pub(crate) struct Kit {
    pub(crate) positions: Vec<[i16; 3]>,
    pub(crate) normals: Vec<Normal>,
    pub(crate) colors: Vec<Rgb>,
    pub(crate) places: Vec<((), [i16; 2])>,
    /// Some may lead nowhere.
    pub(crate) indices: Vec<u8>,
    /// Scale and offset of the positions.
    pub(crate) place: (Vec3, Vec3),
    texels: Vec<u16>,
    sides: (u16, u16),
    filter: AnyFilter,
    wraps: (AnyWrap, AnyWrap),
    unit_bits: u32,
}

impl Kit {
    pub(crate) fn new(choices: &mut impl Choices, tame: bool) -> Self {
        let vertices = choices.range(3, 14) as usize;
        let reach = if tame { 20_000 } else { 32_767 };
        let mut positions = Vec::new();
        let mut normals: Vec<Normal> = Vec::new();
        let mut places = Vec::new();
        for _ in 0..vertices {
            positions.push([0; 3].map(|_: i16| choices.range(-reach, reach) as i16));
            normals.push([0; 3].map(|_: i8| choices.range(-128, 127) as i8));
            places.push(((), [0; 2].map(|_: i16| choices.range(-32_768, 32_767) as i16)));
        }
        let colors = normals.iter().map(|n| Rgb::new(n[0] as u8, n[1] as u8, n[2] as u8)).collect();
        let beyond = if tame { 0 } else { 2 };
        let indices = (0..choices.range(0, 12))
            .map(|_| choices.range(0, vertices as i32 - 1 + beyond) as u8)
            .collect();
        let place = if tame {
            (Vec3::splat(1.0 / 16_384.0), Vec3::ZERO)
        } else {
            (vector(choices, false), vector(choices, false))
        };
        let (across, down) = (choices.range(0, 5), choices.range(0, 5));
        // Few choices make all texels.
        let (seed, step) = (choices.range(0, 0xFFFF) as u16, choices.range(0, 0xFFFF) as u16);
        let texels = (0..1_u16 << (across + down)).map(|i| seed.wrapping_add(step.wrapping_mul(i)));
        let wraps = [AnyWrap::Repeat, AnyWrap::Clamp, AnyWrap::Mirror];
        let filters = [AnyFilter::Nearest, AnyFilter::Bilinear, AnyFilter::FineBilinear];
        Self {
            positions,
            normals,
            colors,
            places,
            indices,
            place,
            texels: texels.collect(),
            sides: (1 << across, 1 << down),
            filter: choices.one_of(&filters),
            wraps: (choices.one_of(&wraps), choices.one_of(&wraps)),
            unit_bits: choices.range(0, 16) as u32,
        }
    }

    pub(crate) fn sampler(&self) -> AnySampler<'_> {
        let texture = Texture::new(&self.texels, self.sides.0, self.sides.1);
        let texture = AnyTexture::Rgb565(texture.expect("texels for its size"));
        let sampler = AnySampler::new(texture, self.filter, self.wraps.0, self.wraps.1);
        sampler.expect("powers of two").unit_bits(self.unit_bits)
    }
}

/// Round points, green.
pub(crate) struct Discs;

impl Shader for Discs {
    type Vertex = Rgb;
    type Varying = PointCoordinates;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, Rgb>) {}

    fn fragment(&self, (): &(), at: &PointCoordinates) -> Option<Color> {
        (at.radius_squared() < 1 << 26).then(|| Rgb::GREEN.into())
    }
}
