//! The README's example: a lit teapot on a small display.
#![no_std]

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Camera, Cull, Frame, FrameError, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};

/// Draws a lit teapot into a display's buffer of 128x64 pixels; `depth` is as many numbers.
pub fn draw(pixels: &mut [u16], depth: &mut [u16], turn: f32) -> Result<(), FrameError> {
    let mut frame = Frame::<Rgb565>::new(pixels, Size::new(128, 64))?.with_depth(depth)?;
    frame.clear(Rgb::new(16, 24, 48));
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.0, 5.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let model = Mat4::rotation_y(turn.degrees());
    Pass::new(&camera).cull(Cull::Back).depth(Less).draw(
        &mut frame,
        &model,
        &TEAPOT,
        &Gouraud::lit(&[sun]),
    );
    Ok(())
}
