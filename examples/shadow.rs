//! A teapot's shadow on a floor, into `shadow.tga`: the mesh once more, flattened along the light
//! and blended. The stencil sees to it that no pixel darkens twice.

use microraster::host::{AtomicFile, Tga};
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::models::TEAPOT;
use microraster::{
    Camera, ConstantAlpha, Cull, Equal, Flat, Frame, Gouraud, IncrementWrap, Less, LessEqual,
    Light, Mesh, Pass, PolygonOffset, ReadOnly, Rgb, Rgba8888, Size, Stencil, Stenciled,
};

/// Where light goes to.
const SUN: Vec3 = Vec3::new(0.9, -1.0, 0.1);
/// The height of the floor, under the teapot.
const FLOOR: f32 = -0.8;

static CORNERS: [[i16; 3]; 4] = [[-1, 0, -1], [1, 0, -1], [1, 0, 1], [-1, 0, 1]];
static COLORS: [Rgb; 4] = [
    Rgb::new(90, 130, 160),
    Rgb::new(110, 140, 150),
    Rgb::new(230, 215, 190),
    Rgb::new(230, 205, 180),
];
static INDICES: [u8; 6] = [0, 3, 2, 0, 2, 1];

/// The way along the light to the floor.
fn flattened() -> Mat4 {
    let (x, z) = (SUN.x / SUN.y, SUN.z / SUN.y);
    Mat4::from_rows(
        Vec4::new(1.0, -x, 0.0, x * FLOOR),
        Vec4::new(0.0, 0.0, 0.0, FLOOR),
        Vec4::new(0.0, -z, 1.0, z * FLOOR),
        Vec4::W,
    )
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let size = Size::new(320, 240);
    let (mut pixels, mut depth) = (vec![0_u32; 320 * 240], vec![0; 320 * 240]);
    let mut stencil = vec![0; 320 * 240];
    let mut frame = Frame::<Rgba8888>::new(&mut pixels, size)?
        .with_depth(&mut depth)?
        .with_stencil(&mut stencil)?;
    frame.clear(Rgb::new(150, 180, 200));
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 4.4, 8.0),
        Vec3::new(0.3, -0.4, 0.0),
        Vec3::Y,
    );

    // The floor, then the teapot on it.
    let floor = Mesh::new(&CORNERS, &COLORS)
        .indexed(&INDICES)
        .placed(Vec3::new(4.2, 1.0, 3.4), Vec3::new(0.0, FLOOR, 0.0));
    let pass = Pass::new(&camera).cull(Cull::Back);
    pass.depth(Less).draw(&mut frame, &Mat4::identity(), &floor, &Gouraud::colored());
    let turned = Mat4::rotation_y(25.0.degrees());
    let sun = Light::directional(SUN, Rgb::WHITE);
    pass.depth(Less).draw(&mut frame, &turned, &TEAPOT, &Gouraud::lit(&[sun]));

    // The shadow lies on the floor, so it is moved a little towards the eye. What is drawn is
    // counted in the stencil, and only what has not been is drawn.
    let near = PolygonOffset::new(ReadOnly::new(LessEqual), fixed::types::I8F8::NEG_ONE, -2);
    let once = Stencil::new(Equal, 0).on_pass(IncrementWrap);
    Pass::new(&camera).depth(Stenciled::new(near, once)).blend(ConstantAlpha(120)).draw(
        &mut frame,
        &(flattened() * turned),
        &TEAPOT,
        &Flat::solid(Rgb::BLACK),
    );

    let mut file = AtomicFile::create("shadow.tga")?;
    let rgba: Vec<_> = pixels.into_iter().map(u32::to_ne_bytes).collect();
    Tga::new(320, 240)?.write(&mut file, &rgba)?;
    file.commit()?;
    println!("shadow.tga");
    Ok(())
}
