//! A view through a window into another room, into `portal.tga`: the stencil marks where the
//! window is seen, and the other room is drawn there alone.

use microraster::host::{AtomicFile, Tga};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Always, Camera, Cull, DepthRange, Equal, Flat, Frame, Gouraud, IndexedList, Lambert, Less,
    Light, Mesh, Pass, Replace, Rgb, Rgba8888, Size, Stencil, Stenciled,
};

static SQUARE: [[i16; 3]; 4] = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]];
static INDICES: [u8; 6] = [0, 1, 2, 0, 2, 3];
static WALL: [Rgb; 4] = [
    Rgb::new(120, 80, 60),
    Rgb::new(110, 70, 60),
    Rgb::new(200, 160, 120),
    Rgb::new(210, 170, 120),
];
static NIGHT: [Rgb; 4] =
    [Rgb::new(70, 40, 110), Rgb::new(70, 40, 110), Rgb::new(10, 10, 40), Rgb::new(10, 10, 40)];

/// A square of so large a half side.
fn square(colors: &'static [Rgb; 4], half: f32) -> Mesh<'static, Rgb, IndexedList<'static, u8>> {
    Mesh::new(&SQUARE, colors).indexed(&INDICES).placed(Vec3::new(half, half, 1.0), Vec3::ZERO)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = Size::new(320, 240);
    let (mut pixels, mut depth) = (vec![0_u32; 320 * 240], vec![0; 320 * 240]);
    let mut stencil = vec![0; 320 * 240];
    let mut frame = Frame::<Rgba8888>::new(&mut pixels, size)?
        .with_depth(&mut depth)?
        .with_stencil(&mut stencil)?;
    frame.clear(Rgb::BLACK);
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(1.4, 0.9, 5.2),
        Vec3::new(0.2, 0.0, 0.0),
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let pass = Pass::new(&camera).cull(Cull::Back);

    // This room: a wall, and a teapot that hides a part of the window.
    let wall = square(&WALL, 8.0);
    pass.depth(Less).draw(
        &mut frame,
        &Mat4::translation(Vec3::new(0.0, 0.0, -0.01)),
        &wall,
        &Gouraud::colored(),
    );
    let here = Mat4::translation(Vec3::new(1.3, -0.9, 1.4)) * Mat4::scale(Vec3::new(0.5, 0.5, 0.5));
    let copper = Lambert::new(&[sun]).material(Rgb::new(220, 120, 70));
    pass.depth(Less).draw(&mut frame, &here, &TEAPOT, &Gouraud::new(copper));

    // The window where it is seen: a mark in the stencil, and nothing behind it.
    let window = square(&NIGHT, 1.3);
    let mark = Stencil::new(Always, 1).on_pass(Replace);
    let plain = Flat::solid(Rgb::BLACK);
    pass.depth(Stenciled::new(Less, mark)).draw(&mut frame, &Mat4::identity(), &window, &plain);

    // As far away as can be in the window: depth is 0 there again.
    let inside = Stencil::new(Equal, 1);
    let far = DepthRange::new(Always, 0, 0);
    pass.depth(Stenciled::new(far, inside)).draw(&mut frame, &Mat4::identity(), &window, &plain);

    // The other room through it: its far wall, and a larger teapot.
    let back = Mat4::translation(Vec3::new(0.0, 0.0, -6.0));
    let sky = square(&NIGHT, 8.0);
    let mut through = pass.depth(Stenciled::new(Less, inside));
    through.draw(&mut frame, &back, &sky, &Gouraud::colored());
    let there = Mat4::translation(Vec3::new(-0.5, -0.3, -3.4)) * Mat4::rotation_y(150.0.degrees());
    let silver = Lambert::new(&[sun]).material(Rgb::new(170, 200, 230));
    through.draw(&mut frame, &there, &TEAPOT, &Gouraud::new(silver));

    let mut file = AtomicFile::create("portal.tga")?;
    let rgba: Vec<_> = pixels.into_iter().map(u32::to_ne_bytes).collect();
    Tga::new(320, 240)?.write(&mut file, &rgba)?;
    file.commit()?;
    println!("portal.tga");
    Ok(())
}
