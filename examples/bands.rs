//! A 320x240 picture through a band of 16 rows: what a display needs that has no room for a frame.

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Bands, Camera, Cull, FrameError, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};

const PICTURE: Size = Size::new(320, 240);

/// Draws the picture in bands of `rows`, sends each to a display, here a list of pixels, and says
/// how many bytes of buffers that took.
fn draw(rows: u16, display: &mut Vec<u16>) -> Result<usize, FrameError> {
    let pixels = usize::from(PICTURE.width) * usize::from(rows);
    let (mut color, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut bands = Bands::<Rgb565>::new(&mut color, PICTURE)?.with_depth(&mut depth)?;
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.4, 5.4),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let (turned, shader) = (Mat4::rotation_y(25.0.degrees()), Gouraud::lit(&[sun]));
    bands.draw(
        |frame| {
            frame.clear(Rgb::new(16, 24, 48));
            Pass::new(&camera).cull(Cull::Back).depth(Less).draw(frame, &turned, &TEAPOT, &shader);
        },
        |band| {
            display.extend_from_slice(band.pixels());
            Ok::<(), FrameError>(())
        },
    )?;
    Ok(pixels * 4)
}

fn main() -> Result<(), FrameError> {
    let (mut whole, mut sent) = (Vec::new(), Vec::new());
    let frame_bytes = draw(PICTURE.height, &mut whole)?;
    let band_bytes = draw(16, &mut sent)?;
    assert_eq!(whole, sent, "the bands make the same picture");
    println!("the same picture from {frame_bytes} bytes at once and from {band_bytes} in bands");
    Ok(())
}
