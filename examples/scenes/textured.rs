//! The measured scenes with a texture: a quad that leans back, w from 2 to 4, under 128x128 texels.

#![allow(clippy::cast_possible_truncation, reason = "texels of 16 bits")]

use microraster::math::{Angle, Mat4, Vec3};
use microraster::texture::{Sampler, Texture};
use microraster::{
    Camera, Frame, Gouraud, IndexedList, Less, Mesh, Pass, Rgb, Rgb565, Shader, Size, Stats,
    Textured,
};

use super::{Facts, Group, Probe, Scene, Stage, ROOM};

const SIZE: Size = Size::new(320, 240);
/// Texels along each side.
const SIDE: u16 = 128;
const TEXELS: usize = SIDE as usize * SIDE as usize;

/// Checks of 16 texels, with a ramp across and one down.
static DATA: [u16; TEXELS] = {
    let (mut data, mut i) = ([0; TEXELS], 0);
    while i < TEXELS {
        let (x, y) = (i % SIDE as usize, i / SIDE as usize);
        let check = (x / 16 + y / 16) % 2;
        data[i] = ((x / 4) << 11 | (y / 2) << 5 | (check * 31)) as u16;
        i += 1;
    }
    data
};

const TEXTURE: Texture<'static, Rgb565> = match Texture::new(&DATA, SIDE, SIDE) {
    Ok(texture) => texture,
    Err(_) => panic!("the size fits the data"),
};

static POSITIONS: [[i16; 3]; 4] = [[-1, -1, 1], [1, -1, 1], [1, 1, -1], [-1, 1, -1]];
/// One repeat: texel (0, 0) is at the upper left.
static PLACES: [[i16; 2]; 4] = [[0, 4096], [4096, 4096], [4096, 0], [0, 0]];
static COLORS: [Rgb; 4] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE, Rgb::WHITE];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 5] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("F4", f4::<P>),
        scene("F5", f5::<P>),
        scene("F5m", f5m::<P>),
        scene("F5-rolled", f5_rolled::<P>),
        scene("F5m-rolled", f5m_rolled::<P>),
    ]
}

/// The quad from (-1.6, -0.81, -2) to (1.6, 1.6, -4).
fn quad<A>(attributes: &[A]) -> Mesh<'_, A, IndexedList<'_, u16>> {
    Mesh::new(&POSITIONS, attributes)
        .indexed(&INDICES)
        .placed(Vec3::new(1.6, 1.205, 1.0), Vec3::new(0.0, 0.395, -3.0))
}

/// Draws a shader's quad, measured.
fn draw<P: Probe, A, S: Shader<Vertex = A>>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    shader: &S,
    attributes: &[A],
    model: &Mat4,
) -> Facts {
    let Stage { color, depth, .. } = stage;
    if let Ok(frame) = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(color), SIZE) {
        if let Ok(mut frame) = frame.with_depth(depth) {
            frame.clear(Rgb::BLACK);
            let camera = Camera::perspective(Angle::from_degrees(45.0), 0.5);
            let (pass, mesh) = (Pass::new(&camera).depth(Less), quad(attributes));
            if P::COUNTING {
                let mut stats = Stats::default();
                pass.count(&mut stats).draw(&mut frame, model, &mesh, shader);
                probe.pixels(stats.pixels.into());
                probe.skipped(stats.skipped);
            } else {
                let mut pass = pass;
                probe.measure(|| pass.draw(&mut frame, model, &mesh, shader));
            }
        }
    }
    Facts { bytes: 2 * ROOM, triangles: 2 }
}

/// The nearest texel.
fn f4<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    match Sampler::nearest(TEXTURE) {
        Ok(sampler) => {
            let attributes = PLACES.map(|place| ((), place));
            draw(stage, probe, &Textured::new(sampler), &attributes, &Mat4::identity())
        }
        Err(_) => Facts { bytes: 0, triangles: 0 },
    }
}

/// Between texels.
fn bilinear<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, model: &Mat4) -> Facts {
    match Sampler::bilinear(TEXTURE) {
        Ok(sampler) => {
            let attributes = PLACES.map(|place| ((), place));
            draw(stage, probe, &Textured::new(sampler), &attributes, model)
        }
        Err(_) => Facts { bytes: 0, triangles: 0 },
    }
}

/// Between texels, multiplied with an interpolated colour.
fn multiplied<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, model: &Mat4) -> Facts {
    match Sampler::bilinear(TEXTURE) {
        Ok(sampler) => {
            let shader = Textured::on(Gouraud::colored(), sampler);
            let [a, b, c, d] = COLORS;
            let [e, f, g, h] = PLACES;
            draw(stage, probe, &shader, &[(a, e), (b, f), (c, g), (d, h)], model)
        }
        Err(_) => Facts { bytes: 0, triangles: 0 },
    }
}

fn f5<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    bilinear(stage, probe, &Mat4::identity())
}

fn f5m<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    multiplied(stage, probe, &Mat4::identity())
}

/// About the line of sight: no row of pixels is one of texels.
fn rolled() -> Mat4 {
    Mat4::rotation_z(Angle::from_degrees(10.0))
}

fn f5_rolled<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    bilinear(stage, probe, &rolled())
}

fn f5m_rolled<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    multiplied(stage, probe, &rolled())
}
