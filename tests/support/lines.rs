//! Lines on the screen as the reference draws them.

use microraster::host::reference::{
    Draw, Fragment, Interpolation, Kind, Progress, Reference, Space, State, Vertex,
};
use microraster::raster::ScreenVertex;
use microraster::Size;

/// Draws lines from corners with varyings; fragments become red by their first varying, of those
/// pixels of the lines, counted through all of them, which are kept.
pub(crate) fn draw_lines(
    picture: &mut Reference,
    state: State,
    width: u16,
    lines: &[[(ScreenVertex, f64); 2]],
    keeps: impl Fn(u32) -> bool,
) {
    let vertex = |&(v, red): &(ScreenVertex, f64)| {
        let [x, y] = [v.x, v.y].map(f64::from);
        Vertex { position: [x, y, v.z.into(), 1.0], varyings: vec![red] }
    };
    let vertices: Vec<Vertex> = lines.iter().flatten().map(vertex).collect();
    let corners: Vec<u32> = (0..).take(vertices.len()).collect();
    let shade = |f: &Fragment<'_>| keeps(f.step).then(|| [f.varyings[0], 0.0, 0.0, 255.0]);
    picture.draw(&Draw {
        space: Space::Window,
        kind: Kind::Lines { width, progress: Progress::Longer },
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Linear,
        state,
        shade: &shade,
    });
}

/// The pixels of a line of so many copies, by rows.
pub(crate) fn line_pixels(size: Size, width: u16, line: [ScreenVertex; 2]) -> Vec<(i32, i32)> {
    let mut picture = Reference::new(size, [0.0; 3]);
    draw_lines(&mut picture, State::PLAIN, width, &[line.map(|v| (v, 0.0))], |_| true);
    seen(&picture)
}

/// The pixels that show something, by rows.
pub(crate) fn seen(picture: &Reference) -> Vec<(i32, i32)> {
    let width = i32::from(picture.size().width);
    let places = (0..).map(|i| (i % width, i / width));
    let pixels = picture.seen().iter().zip(places).filter(|(seen, _)| seen.is_some());
    pixels.map(|(_, place)| place).collect()
}
