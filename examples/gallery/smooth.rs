//! Edges without steps: a gear with 1, 4 and 16 samples a pixel, and lines by coverage.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::raster::ScreenVertex;
use microraster::{
    Alpha, Camera, Color, Cull, DepthBuffer, Flat, Format, Frame, FrameError, Gouraud, Lambert,
    Less, Light, LineStyle, Pass, Rect, Rgb, Rgb565, Rgba8888, ScreenPass, Size, Smooth, Stats,
    Supersampling, Thin, Undithered,
};

use super::{font, gears};

const PAPER: Rgb = Rgb::new(248, 244, 236);
const INK: Rgb = Rgb::new(40, 48, 64);

/// Columns of the picture: where each begins. They are as wide as the gears are high.
const COLUMNS: [i32; 3] = [4, 110, 216];
const SIDE: i32 = 100;
const GEARS_TOP: i32 = 18;
const LINES_TOP: i32 = 136;

/// Draws a picture of 320x240; `turn` in degrees. Samples are drawn a few rows at a time, as many
/// as `samples` and `sample_depth` have room for: 4 rows of 1280 at least.
///
/// # Errors
/// There is less room.
pub(crate) fn draw(
    frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
    samples: &mut [u32],
    sample_depth: &mut [u16],
    turn: f32,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    frame.clear(PAPER);
    let [plain, four, sixteen] =
        COLUMNS.map(|x| Rect::new(x, GEARS_TOP, x + SIDE, GEARS_TOP + SIDE));
    gear(frame, plain, turn, stats);
    for (cell, supersampling) in [(four, Supersampling::Two), (sixteen, Supersampling::Four)] {
        sampled(frame, cell, supersampling, (samples, sample_depth), turn, stats)?;
    }
    let fan = fan(turn);
    lines(frame, COLUMNS[0], &fan, Thin, stats);
    lines(frame, COLUMNS[1], &fan, Smooth(1), stats);
    lines(frame, COLUMNS[2], &fan, Smooth(3), stats);

    let texts: [[&[u8]; 2]; 3] =
        [[b"1 SAMPLE", b"THIN"], [b"4 SAMPLES", b"SMOOTH 1"], [b"16 SAMPLES", b"SMOOTH 3"]];
    for (x, texts) in COLUMNS.into_iter().zip(texts) {
        for (top, text) in [GEARS_TOP - 12, LINES_TOP - 12].into_iter().zip(texts) {
            // In the middle of the column.
            let width = font::ADVANCE * i32::try_from(text.len()).unwrap_or(0);
            font::write(frame, (x + (SIDE - width) / 2, top), 1, INK, text, stats);
        }
    }
    Ok(())
}

/// Draws a gear with several samples a pixel into a cell of the picture.
fn sampled(
    frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
    cell: Rect,
    supersampling: Supersampling,
    (samples, depth): (&mut [u32], &mut [u16]),
    turn: f32,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    let (factor, picture) = (supersampling.factor(), frame.picture());
    let width = picture.width * factor;
    let held = frame.scissor();
    // Rows of the picture that there is room for.
    let room = samples.len().min(depth.len()) / usize::from(width * factor);
    let room = u16::try_from(room).unwrap_or(u16::MAX).max(1);
    let mut first = first_row(cell.top.max(held.top));
    let end = first_row(cell.bottom.min(held.bottom));
    while first < end {
        let rows = room.min(end - first);
        let mut fine = Frame::<Rgba8888>::new(samples, Size::new(width, rows * factor))?
            .with_depth(depth)?
            .band(first * factor, picture.height * factor)?;
        fine.clear(PAPER);
        let large = i32::from(factor);
        let viewport =
            Rect::new(cell.left * large, cell.top * large, cell.right * large, cell.bottom * large);
        gear(&mut fine, viewport, turn, stats);
        frame.set_scissor(Rect::new(cell.left, first.into(), cell.right, (first + rows).into()));
        supersampling.resolve(&fine, frame, &Undithered);
        first += rows;
    }
    frame.reset_scissor();
    Ok(())
}

/// A row of the picture, 0 for one above it.
fn first_row(y: i32) -> u16 {
    u16::try_from(y).unwrap_or(0)
}

/// Draws a gear into a square of the picture.
fn gear<F: Format>(
    frame: &mut Frame<'_, F, DepthBuffer<'_>>,
    viewport: Rect,
    turn: f32,
    stats: &mut Stats,
) {
    let camera = Camera::perspective(30.0.degrees(), 5.0).look_at(
        Vec3::new(4.0, 6.0, 16.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.2, -0.6, -1.0), Rgb::new(200, 200, 200));
    let light = Lambert::new(&[sun]).ambient(Rgb::new(70, 70, 70)).material(Rgb::new(60, 110, 210));
    let mut pass = Pass::new(&camera).viewport(viewport).cull(Cull::Back).depth(Less).count(stats);
    let model = Mat4::rotation_z(turn.degrees());
    pass.draw(frame, &model, &gears::RED.mesh(), &Gouraud::new(light));
}

type Line = [(ScreenVertex, Color); 2];

/// Lines all around, from a circle to a larger one.
#[allow(clippy::cast_possible_truncation, reason = "places in a cell")]
fn fan(turn: f32) -> [Line; 20] {
    let mut number = 0.0;
    [(); 20].map(|()| {
        let (sin, cos) = (0.25 * turn + 18.0 * number).degrees().sin_cos();
        number += 1.0;
        [12.0, 48.0].map(|radius: f32| {
            let at = |along: f32| ((SIDE as f32 * 0.5 + radius * along) * 16.0) as i32;
            (ScreenVertex::from_bits(at(cos), at(sin), 0), INK.into())
        })
    })
}

/// Draws lines into a column.
fn lines(
    frame: &mut Frame<'_, Rgb565, DepthBuffer<'_>>,
    x: i32,
    lines: &[Line; 20],
    style: impl LineStyle,
    stats: &mut Stats,
) {
    let moved = lines.map(|line| {
        line.map(|(at, color)| {
            let (left, top) = (at.x.to_bits() + x * 16, at.y.to_bits() + LINES_TOP * 16);
            (ScreenVertex::from_bits(left, top, 0), color)
        })
    });
    // What lines do not cover of a pixel is left as it is: blended.
    let mut pass = ScreenPass::new().blend(Alpha).count(stats);
    pass.lines(frame, &Flat::colored(), style, &moved);
}
