//! The whole screen in interpolated colours: what depth and dithering cost where nothing else does.

use microraster::math::{Mat4, Vec3};
use microraster::{
    ConstantDepth, Dither4, Dither8, Gouraud, Less, Off, Pass, ReadOnly, Rgb, Stats, Undithered,
};

use super::{knob, Shape};
use crate::scenes::standard::{camera, facts, frame, measured};
use crate::scenes::{Probe, Scene, Stage};

const REACH: i16 = 1 << 14;
static POSITIONS: [[i16; 3]; 4] =
    [[-REACH, -REACH, 0], [REACH, -REACH, 0], [REACH, REACH, 0], [-REACH, REACH, 0]];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];
/// Ramps that are slow enough to show the steps of RGB565.
pub(crate) static COLORS: [Rgb; 4] =
    [Rgb::new(20, 30, 60), Rgb::new(90, 60, 40), Rgb::new(200, 170, 120), Rgb::new(60, 120, 200)];

/// A quad 0.2 % larger than the screen.
pub(crate) fn shape() -> Shape<'static> {
    let half = 2.0 * 0.414_213_56 * 1.002 / f32::from(REACH);
    Shape {
        positions: &POSITIONS,
        indices: &INDICES,
        scale: Vec3::new(half * 4.0 / 3.0, half, 0.0),
        offset: Vec3::new(0.0, 0.0, -2.0),
        model: Mat4::identity(),
    }
}

/// Draws by a pass that is made ready.
macro_rules! filled {
    ($depth:expr, $dither:expr) => {
        |stage: &mut Stage<'_>, _: u32, probe: &mut P| {
            if let Ok(mut frame) = frame(stage.color, stage.depth) {
                let (camera, shape) = (camera(), shape());
                let mesh = shape.mesh(&COLORS);
                let shader = Gouraud::colored();
                let pass = Pass::new(&camera).depth($depth).dither($dither);
                measured!(probe, pass, |pass| pass.draw(&mut frame, &shape.model, &mesh, &shader));
            }
            facts(2)
        }
    };
}

/// Each setting of depth, and each of dithering.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let depth = knob!("fill", "depth",
        "off" => filled!(Off, Undithered),
        "constant" => filled!(ConstantDepth::new(Less), Undithered),
        "read-only" => filled!(ReadOnly::new(Less), Undithered),
        "tested" => filled!(Less, Undithered),
    );
    let dither = knob!("fill", "dither",
        "none" => filled!(Less, Undithered),
        "4x4" => filled!(Less, Dither4),
        "8x8" => filled!(Less, Dither8),
    );
    depth.into_iter().chain(dither)
}
