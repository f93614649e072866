//! Measured scenes of what becomes of a fragment's colour: the quad of the standard scenes.

use microraster::math::Mat4;
use microraster::{
    Alpha, Color, ConstantAlpha, Dither4, Dither8, DrawContext, Equal, Flat, FlatColor, Format,
    Frame, Gouraud, IncrementWrap, Less, Off, Pass, Rgb, Rgb565, Row, Shader, State, Stencil,
    Stenciled, VertexInput,
};

use super::standard::{camera, facts, frame, measured, quad, SIZE};
use super::{Facts, Group, Probe, Scene, Stage, ROOM};

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 7] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("blend", blend::<P>),
        scene("blend-depth", blend_depth::<P>),
        scene("blend-gouraud", blend_gouraud::<P>),
        scene("dither", dither::<P>),
        scene("dither-8x8", dither_8x8::<P>),
        scene("stencil", stencil::<P>),
        scene("stencil-alone", stencil_alone::<P>),
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

/// Colours in the first half of the stage's words, stencil values in the second.
fn halves(color: &mut [u32]) -> (&mut [u16], &mut [u8]) {
    let (color, stencil) = color.split_at_mut(ROOM / 2);
    (bytemuck::cast_slice_mut(color), bytemuck::cast_slice_mut(stencil))
}

/// Fill with depth where nothing has been drawn, counting what is.
fn stencil<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let (color, stencil) = halves(stage.color);
    let frame = Frame::<Rgb565>::new(color, SIZE)
        .and_then(|frame| frame.with_depth(stage.depth))
        .and_then(|frame| frame.with_stencil(stencil));
    if let Ok(mut frame) = frame {
        frame.clear(Rgb::BLACK);
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        let once = Stencil::new(Equal, 0).on_pass(IncrementWrap);
        measured!(probe, Pass::new(&camera).depth(Stenciled::new(Less, once)), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}

/// The same without depth.
fn stencil_alone<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let (color, stencil) = halves(stage.color);
    let frame = Frame::<Rgb565>::new(color, SIZE).and_then(|frame| frame.with_stencil(stencil));
    if let Ok(mut frame) = frame {
        frame.clear(Rgb::BLACK);
        let (camera, quad) = (camera(), quad());
        let shader = Flat::solid(Rgb::new(255, 128, 0));
        let once = Stencil::new(Equal, 0).on_pass(IncrementWrap);
        measured!(probe, Pass::new(&camera).depth(Stenciled::new(Off, once)), |pass| pass.draw(
            &mut frame,
            &Mat4::identity(),
            &quad,
            &shader
        ));
    }
    facts(2)
}
