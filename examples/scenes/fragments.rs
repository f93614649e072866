//! Measured scenes of what becomes of a fragment's colour: the quad of the standard scenes.

use microraster::math::Mat4;
use microraster::{
    Alpha, Color, ConstantAlpha, Dither4, Dither8, DrawContext, Flat, FlatColor, Format, Gouraud,
    Less, Pass, Rgb, Row, Shader, State, Stats, VertexInput,
};

use super::standard::{camera, facts, frame, measured, quad};
use super::{Facts, Group, Probe, Scene, Stage};

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 5] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("blend", blend::<P>),
        scene("blend-depth", blend_depth::<P>),
        scene("blend-gouraud", blend_gouraud::<P>),
        scene("dither", dither::<P>),
        scene("dither-8x8", dither_8x8::<P>),
    ]
}

/// A clear colour that is seen through what is blended.
const BENEATH: Rgb = Rgb::new(32, 64, 96);

/// One colour with an alpha of its own.
struct Glass(Color);

impl Shader for Glass {
    type Vertex = Rgb;
    type Varying = FlatColor;
    type Prepared = ();

    fn prepare(&self, _draw: &DrawContext) {}

    fn vertex(&self, (): &(), _vertex: VertexInput<'_, Rgb>) -> Color {
        self.0
    }

    fn fragment(&self, _: &Self::Prepared, varying: &FlatColor) -> Option<Color> {
        Some(varying.color())
    }

    #[inline(always)]
    fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, FlatColor>) {
        let color = row.varying().color();
        row.fill(color);
    }
}

/// A flat quad by its own alpha, without depth.
fn blend<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear_color(BENEATH);
        let (camera, quad) = (camera(), quad());
        let shader = Glass(Color::new(255, 128, 0).with_alpha(120));
        measured!(probe, Pass::new(&camera).blend(Alpha), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// The same with depth.
fn blend_depth<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear_color(BENEATH);
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        measured!(probe, Pass::new(&camera).depth(Less).blend(ConstantAlpha(120)), |pass| pass
            .draw(&mut frame, &Mat4::identity(), &quad, &shader));
    }
    facts(2)
}

/// Interpolated colours with depth, blended.
fn blend_gouraud<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear_color(BENEATH);
        let (camera, quad) = (camera(), quad());
        let shader = Gouraud::colored();
        measured!(probe, Pass::new(&camera).depth(Less).blend(ConstantAlpha(120)), |pass| pass
            .draw(&mut frame, &Mat4::identity(), &quad, &shader));
    }
    facts(2)
}

/// Gouraud with depth, dithered by a matrix of 4x4.
fn dither<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Gouraud::colored();
        measured!(probe, Pass::new(&camera).depth(Less).dither(Dither4), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// The same by a matrix of 8x8.
fn dither_8x8<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        let (camera, quad) = (camera(), quad());
        let shader = Gouraud::colored();
        measured!(probe, Pass::new(&camera).depth(Less).dither(Dither8), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}
