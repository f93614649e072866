//! The same drawing twice: left as it comes, right anti-aliased, by samples and by coverage.

use super::Canvas;
use microraster::math::{Angle, AngleUnits, Mat4, Vec2, Vec3};
use microraster::models::TEAPOT;
use microraster::raster::ScreenVertex;
use microraster::{
    Alpha, Camera, Cull, DepthBuffer, Flat, Format, Frame, FrameError, Gouraud, Lambert, Less,
    Light, Pass, Rect, Rgb, Rgb565, ScreenPass, ShadedVertex, Size, Smooth, Stats, Supersampling,
    Thin, Undithered, VertexColors,
};

const NIGHT: Rgb = Rgb::new(14, 18, 30);

/// Draws both halves.
///
/// # Errors
/// Too little memory: twice the pixels' rows and columns, a few rows at a time, are drawn in
/// `words`.
pub(crate) fn draw(
    canvas: &mut Canvas<'_>,
    turn: f32,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    let Canvas { picture, first_row, rows, pixels, depth, words } = canvas;
    let size = Size::new(picture.width, *rows);
    let mut frame = Frame::<Rgb565>::new(pixels, size)?.with_depth(depth)?;
    frame = frame.band(*first_row, picture.height)?;
    frame.clear(NIGHT);
    let (width, height) = (i32::from(picture.width), i32::from(picture.height));
    let (left, right) =
        (Rect::new(0, 0, width / 2, height), Rect::new(width / 2, 0, width, height));
    teapot(&mut frame, left, turn, stats);
    // Twice as large, in bands of a few rows, whose depth codes lie beside them.
    let fine_size = |rows: u16| Size::new(picture.width * 2, rows * 2);
    let rows_at_once = (ROWS * 2).min(*rows);
    let samples = 4 * usize::from(picture.width) * usize::from(rows_at_once);
    let halves: &mut [u16] = bytemuck::cast_slice_mut(words);
    let (fine, codes) = halves.split_at_mut(samples.min(halves.len()));
    let mut first = *first_row;
    while first < *first_row + *rows {
        let held = rows_at_once.min(*first_row + *rows - first);
        let mut fine = Frame::<Rgb565>::new(fine, fine_size(held))?.with_depth(codes)?;
        fine = fine.band(first * 2, picture.height * 2)?;
        fine.clear(NIGHT);
        let twice =
            |rect: Rect| Rect::new(rect.left * 2, rect.top * 2, rect.right * 2, rect.bottom * 2);
        teapot(&mut fine, twice(right), turn, stats);
        frame.set_scissor(right);
        Supersampling::Two.resolve(&fine, &mut frame, &Undithered);
        frame.reset_scissor();
        first += held;
    }
    rays(&mut frame, left, turn, |frame, lines| {
        ScreenPass::new().lines(frame, &Flat::colored(), Thin, lines);
    });
    rays(&mut frame, right, turn, |frame, lines| {
        ScreenPass::new().blend(Alpha).lines(frame, &Flat::colored(), Smooth(1), lines);
    });
    Ok(())
}

/// Rows that are drawn twice as large at a time.
const ROWS: u16 = 8;

fn teapot<F: Format>(
    frame: &mut Frame<'_, F, DepthBuffer<'_>>,
    viewport: Rect,
    turn: f32,
    stats: &mut Stats,
) {
    let camera = Camera::perspective(44.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 4.0, 11.0),
        Vec3::new(0.15, 1.0, 0.0),
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(0.4, -0.7, -0.8), Rgb::WHITE);
    let shader = Gouraud::new(Lambert::new(&[sun]).material(Rgb::new(236, 174, 88)));
    let model = Mat4::rotation_y(turn.degrees());
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less).viewport(viewport).count(stats);
    pass.draw(frame, &model, &TEAPOT, &shader);
}

/// A fan of rays above the teapot.
fn rays<'a>(
    frame: &mut Frame<'a, Rgb565, DepthBuffer<'a>>,
    half: Rect,
    turn: f32,
    draw: impl Fn(&mut Frame<'a, Rgb565, DepthBuffer<'a>>, &[[ShadedVertex<Flat<VertexColors>>; 2]]),
) {
    const RAYS: usize = 24;
    let middle = Vec2::new((half.left + half.right) as f32 * 0.5, half.bottom as f32 * 0.26);
    let lines: [[ShadedVertex<Flat<VertexColors>>; 2]; RAYS] = core::array::from_fn(|i| {
        let (sin, cos) = Angle::from_degrees(turn + i as f32 * 360.0 / RAYS as f32 + 3.0).sin_cos();
        let end = |radius: f32| {
            let at = (middle + Vec2::new(cos, sin) * radius) * 16.0;
            let color = Rgb::new(120 + 5 * i as u8, 240 - 4 * i as u8, 230);
            (ScreenVertex::from_bits(at.x as i32, at.y as i32, 0), color.into())
        };
        [end(12.0), end(52.0)]
    });
    draw(frame, &lines);
}
