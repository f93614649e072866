//! Hills in fog: where fog is made, and what dithering makes of its ramps.

use microraster::math::Mat4;
use microraster::{
    AtFragments, AtVertices, Cull, Dither, Dither4, Dither8, Fogged, Gouraud, Lambert, Less,
    Normal, Pass, Rgb, Shader, Stats, Tinted, Undithered,
};

use super::knob;
use crate::scenes::gallery::pictures::terrain::{camera, fog, hills, light, HAZE};
use crate::scenes::standard::{facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

/// Where the camera stands.
pub(crate) const TURN: f32 = 310.0;

fn draw<P, S, W>(stage: &mut Stage<'_>, probe: &mut P, shader: &S, dither: W) -> Facts
where
    P: Probe,
    S: Shader<Vertex = (Normal, Rgb)>,
    W: Dither,
{
    let hills = hills();
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear(HAZE);
        let camera = camera(TURN);
        measured!(probe, Pass::new(&camera).cull(Cull::Back).depth(Less).dither(dither), |pass| {
            pass.draw(&mut frame, &Mat4::IDENTITY, &hills, shader)
        });
    }
    facts(hills.triangles())
}

fn lit() -> Gouraud<Tinted<Lambert<1>>> {
    Gouraud::new(Tinted(light()))
}

/// Where fog is made, and every dither.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let fogs = knob!("terrain", "fog",
        "none" => |stage, _, probe| draw(stage, probe, &lit(), Undithered),
        "vertices" => |stage, _, probe| {
            draw(stage, probe, &Fogged::new(lit(), fog()).at(AtVertices), Undithered)
        },
        "fragments" => |stage, _, probe| {
            draw(stage, probe, &Fogged::new(lit(), fog()).at(AtFragments), Undithered)
        },
    );
    let dithers = knob!("terrain", "dither",
        "none" => |stage, _, probe| draw(stage, probe, &Fogged::new(lit(), fog()), Undithered),
        "4x4" => |stage, _, probe| draw(stage, probe, &Fogged::new(lit(), fog()), Dither4),
        "8x8" => |stage, _, probe| draw(stage, probe, &Fogged::new(lit(), fog()), Dither8),
    );
    fogs.into_iter().chain(dithers)
}
