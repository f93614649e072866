//! Measured scenes of the remaining ways to store a fragment, one each: the quad of the standard
//! scenes in one colour. Those that are named after blending have no depth, the others do.

use fixed::types::I8F8;
use microraster::math::Mat4;
use microraster::{
    Add, AtFragments, Average, Channels, DepthRange, Flat, Fog, Fogged, Less, Multiply, Pass,
    PolygonOffset, Premultiplied, ReadOnly, Rgb, Subtract,
};

use super::standard::{camera, facts, frame, measured, quad};
use super::{Facts, Group, Probe, Scene, Stage};

/// Draws the quad with `$pass` made more of by `$with`.
macro_rules! operation {
    (|$pass:ident| $with:expr, $shader:expr) => {
        |stage: &mut Stage<'_>, _, probe: &mut P| -> Facts {
            if let Ok(mut frame) = frame(stage.color, stage.depth) {
                frame.clear_color(BENEATH);
                let (camera, quad, shader) = (camera(), quad(), $shader);
                let $pass = Pass::new(&camera);
                let model = Mat4::identity();
                measured!(probe, $with, |pass| pass.draw(&mut frame, &model, &quad, &shader));
            }
            facts(2)
        }
    };
}

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 11] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("blend-add", operation!(|pass| pass.blend(Add), Flat::solid(ORANGE))),
        scene("blend-subtract", operation!(|pass| pass.blend(Subtract), Flat::solid(ORANGE))),
        scene("blend-multiply", operation!(|pass| pass.blend(Multiply), Flat::solid(ORANGE))),
        scene("blend-average", operation!(|pass| pass.blend(Average), Flat::solid(ORANGE))),
        scene(
            "blend-premultiplied",
            operation!(|pass| pass.blend(Premultiplied), Flat::solid(ORANGE)),
        ),
        scene(
            "color-mask",
            operation!(
                |pass| pass.depth(Less).color_mask(Channels::<true, false, true>),
                Flat::solid(ORANGE)
            ),
        ),
        scene(
            "depth-read-only",
            operation!(|pass| pass.depth(ReadOnly::new(Less)), Flat::solid(ORANGE)),
        ),
        scene(
            "depth-offset",
            operation!(
                |pass| pass.depth(PolygonOffset::new(Less, I8F8::ONE, 1)),
                Flat::solid(ORANGE)
            ),
        ),
        scene(
            "depth-range",
            operation!(|pass| pass.depth(DepthRange::new(Less, 100, 30_000)), Flat::solid(ORANGE)),
        ),
        scene(
            "fog-at-vertices",
            operation!(|pass| pass.depth(Less), Fogged::new(Flat::solid(ORANGE), fog())),
        ),
        scene(
            "fog-at-fragments",
            operation!(
                |pass| pass.depth(Less),
                Fogged::new(Flat::solid(ORANGE), fog()).at(AtFragments)
            ),
        ),
    ]
}

const ORANGE: Rgb = Rgb::new(255, 128, 0);
/// A clear colour that is seen through what is blended.
const BENEATH: Rgb = Rgb::new(32, 64, 96);

fn fog() -> Fog {
    Fog::exponential(Rgb::WHITE, 0.3)
}
