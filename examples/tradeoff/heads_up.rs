//! A head-up display: a panel over a gradient, and lines on it.

#![allow(clippy::cast_possible_truncation, reason = "places in the picture")]

use microraster::math::Angle;
use microraster::raster::ScreenVertex;
use microraster::{
    Add, Alpha, Average, Blend, Color, ConstantAlpha, Flat, Gouraud, LineStyle, Midpoint, Multiply,
    Rectangle, Replace, Rgb, ScreenPass, Smooth, Stats, Thin,
};

use super::knob;
use crate::scenes::standard::{facts, frame, measured};
use crate::scenes::{Facts, Probe, Scene, Stage};

pub(crate) type Corner = (ScreenVertex, Color);

const fn corner(x: i32, y: i32, color: Color) -> Corner {
    (ScreenVertex::from_bits(x * 16, y * 16, 0), color)
}

/// Two triangles of four corners around.
const fn quad(corners: [Corner; 4]) -> [[Corner; 3]; 2] {
    let [a, b, c, d] = corners;
    [[a, b, c], [a, c, d]]
}

/// What is behind everything.
pub(crate) const BEHIND: [[Corner; 3]; 2] = quad([
    corner(0, 0, Color::new(20, 40, 90)),
    corner(320, 0, Color::new(90, 150, 220)),
    corner(320, 240, Color::new(230, 200, 150)),
    corner(0, 240, Color::new(120, 90, 40)),
]);

/// Alpha of the panel.
pub(crate) const ALPHA: u8 = 150;
const PANEL_COLOR: Color = Color::new(30, 180, 110).with_alpha(ALPHA);

/// The panel.
pub(crate) const PANEL: [[Corner; 3]; 2] = quad([
    corner(24, 24, PANEL_COLOR),
    corner(296, 24, PANEL_COLOR),
    corner(296, 216, PANEL_COLOR),
    corner(24, 216, PANEL_COLOR),
]);

/// Lines of a dial.
pub(crate) const LINES: usize = 48;
pub(crate) const INK: Color = Color::new(250, 255, 240);

/// From a circle to a larger one, at odd places.
pub(crate) fn dial() -> [[Corner; 2]; LINES] {
    let mut number = 0.0;
    [(); LINES].map(|()| {
        let (sine, cosine) = Angle::from_degrees(2.0 + 7.5 * number).sin_cos();
        number += 1.0;
        [30.0, 95.0].map(|radius: f32| {
            let (x, y) = (160.3 + radius * cosine, 120.7 + radius * sine);
            (ScreenVertex::from_bits((x * 16.0) as i32, (y * 16.0) as i32, 0), INK)
        })
    })
}

fn panel<P: Probe, B: Blend>(stage: &mut Stage<'_>, probe: &mut P, blend: B) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        ScreenPass::new().triangles(&mut frame, &Gouraud::colored(), &BEHIND);
        measured!(probe, ScreenPass::new().blend(blend), |pass| pass.triangles(
            &mut frame,
            &Flat::colored(),
            &PANEL
        ));
    }
    facts(2)
}

fn lines<P: Probe, L: LineStyle>(stage: &mut Stage<'_>, probe: &mut P, style: L) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear(Rgb::new(16, 24, 48));
        let dial = dial();
        measured!(probe, ScreenPass::new(), |pass| pass.lines(
            &mut frame,
            &Flat::colored(),
            style,
            &dial
        ));
    }
    facts(0)
}

fn smooth_lines<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    if let Ok(mut frame) = frame(stage.color, stage.depth) {
        frame.clear(Rgb::new(16, 24, 48));
        let dial = dial();
        measured!(probe, ScreenPass::new().blend(Alpha), |pass| pass.lines(
            &mut frame,
            &Flat::colored(),
            Smooth(1),
            &dial
        ));
    }
    facts(0)
}

/// Ways of blending the panel, and of drawing the lines.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let blends = knob!("heads-up", "blend",
        "replace" => |stage, _, probe| panel(stage, probe, Replace),
        "constant-alpha" => |stage, _, probe| panel(stage, probe, ConstantAlpha(ALPHA)),
        "alpha" => |stage, _, probe| panel(stage, probe, Alpha),
        "average" => |stage, _, probe| panel(stage, probe, Average),
        "add" => |stage, _, probe| panel(stage, probe, Add),
        "multiply" => |stage, _, probe| panel(stage, probe, Multiply),
    );
    let lines = knob!("heads-up", "line",
        "thin" => |stage, _, probe| lines(stage, probe, Thin),
        "midpoint" => |stage, _, probe| lines(stage, probe, Midpoint),
        "rectangle" => |stage, _, probe| lines(stage, probe, Rectangle(1)),
        "smooth" => smooth_lines::<P>,
    );
    blends.into_iter().chain(lines)
}
