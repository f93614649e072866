//! Draws the teapot with a shader of one's own, into `toon.tga`.

mod toon;

use microraster::host::{AtomicFile, Tga};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Camera, Frame, Less, Pass, Rgb, Rgba8888, Size};
use toon::{PackedToon, Toon};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = Size::new(320, 240);
    let (mut pixels, mut depth) = (vec![0_u32; 320 * 240], vec![0; 320 * 240]);
    let mut frame = Frame::<Rgba8888>::new(&mut pixels, size)?.with_depth(&mut depth)?;
    frame.clear(Rgb::new(250, 240, 220));
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.6, 6.0),
        Vec3::new(0.1, -0.1, 0.0),
        Vec3::Y,
    );
    let toon = Toon {
        tones: [(60, 20, 80), (150, 40, 90), (235, 95, 85), (255, 190, 120)]
            .map(|(r, g, b)| Rgb::new(r, g, b).into()),
        to_light: Vec3::new(0.9, 1.0, 0.5),
    };
    Pass::new(&camera).depth(Less).draw(
        &mut frame,
        &Mat4::rotation_y(20.0.degrees()),
        &TEAPOT,
        &PackedToon(toon),
    );
    let mut file = AtomicFile::create("toon.tga")?;
    let rgba: Vec<_> = pixels.into_iter().map(u32::to_ne_bytes).collect();
    Tga::new(320, 240)?.write(&mut file, &rgba)?;
    file.commit()?;
    println!("toon.tga");
    Ok(())
}
