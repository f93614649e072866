//! A 320x240 picture through a band of 16 rows: what a display needs that has no room for a frame.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Camera, Cull, Frame, FrameError, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};

const WIDTH: usize = 320;
const HEIGHT: u16 = 240;

/// Draws the picture in bands of `rows` and hands each to `send` when it is complete.
fn draw(rows: u16, mut send: impl FnMut(&[u16])) -> Result<usize, FrameError> {
    let pixels = WIDTH * usize::from(rows);
    let (mut color, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.4, 5.4),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    for first_row in (0..HEIGHT).step_by(rows.into()) {
        let size = Size::new(320, rows.min(HEIGHT - first_row));
        let mut frame = Frame::<Rgb565>::new(&mut color, size)?
            .with_depth(&mut depth)?
            .band(first_row, HEIGHT)?;
        frame.clear(Rgb::new(16, 24, 48));
        Pass::new(&camera).cull(Cull::Back).depth(Less).draw(
            &mut frame,
            &Mat4::rotation_y(25.0.degrees()),
            &TEAPOT,
            &Gouraud::lit(&[sun]),
        );
        send(&color[..WIDTH * usize::from(size.height)]);
    }
    Ok(pixels * 4)
}

fn main() -> Result<(), FrameError> {
    let (mut whole, mut sent) = (Vec::new(), Vec::new());
    let frame_bytes = draw(HEIGHT, |rows| whole.extend_from_slice(rows))?;
    let band_bytes = draw(16, |rows| sent.extend_from_slice(rows))?;
    assert_eq!(whole, sent, "the bands make the same picture");
    println!("the same picture from {frame_bytes} bytes at once and from {band_bytes} in bands");
    Ok(())
}
