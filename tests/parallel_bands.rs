//! A picture drawn by several threads is that of one.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]

use microraster::host::ParallelBands;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Cull, DepthBuffer, Dither4, Format, Frame, FrameError, Gouraud, Less, Light, Pass, Rgb,
    Rgb565, Rgba8888, Size,
};

const PICTURE: Size = Size::new(97, 61);

/// The teapot, dithered, over a wall that cuts it.
fn draw<F: Format>(frame: &mut Frame<'_, F, DepthBuffer<'_>>) {
    let camera = Camera::perspective(60.0.degrees(), 0.5).look_at(
        Vec3::new(0.5, 1.5, 2.5),
        Vec3::ZERO,
        Vec3::Y,
    );
    let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    frame.clear_color(Rgb::new(10, 20, 60));
    for angle in [0.0_f32, 40.0] {
        let turned = Mat4::rotation_y(angle.degrees());
        let pass = Pass::new(&camera).depth(Less).cull(Cull::Back).dither(Dither4);
        { pass }.draw(frame, &turned, &TEAPOT, &shader);
    }
}

fn whole<F: Format>() -> (Vec<F::Raw>, Vec<u16>)
where
    F::Raw: Default,
{
    let pixels = usize::from(PICTURE.width) * usize::from(PICTURE.height);
    let (mut color, mut depth) = (vec![F::Raw::default(); pixels], vec![0; pixels]);
    let frame = Frame::<F>::new(&mut color, PICTURE).and_then(|frame| frame.with_depth(&mut depth));
    draw(&mut frame.expect("buffers are as large as the picture"));
    (color, depth)
}

fn in_parallel<F: Format>(rows: Option<u16>, beyond: usize) -> (Vec<F::Raw>, Vec<u16>)
where
    F::Raw: Default + Send,
{
    let pixels = usize::from(PICTURE.width) * usize::from(PICTURE.height);
    let room = pixels + beyond;
    let (mut color, mut depth) = (vec![F::Raw::default(); room], vec![0; room]);
    let bands = ParallelBands::<F>::new(&mut color, &mut depth, PICTURE);
    let bands = bands.expect("buffers are as large as the picture");
    match rows {
        Some(rows) => bands.rows(rows),
        None => bands,
    }
    .draw(draw);
    assert!(depth[pixels..].iter().all(|code| *code == 0), "behind the picture");
    color.truncate(pixels);
    depth.truncate(pixels);
    (color, depth)
}

#[test]
fn threads_draw_the_picture_of_one_in_bands_of_any_height() {
    let (color, depth) = whole::<Rgb565>();
    assert!(depth.iter().filter(|code| **code > 0).count() > 1000, "the scene is seen");
    for rows in [None, Some(0), Some(1), Some(2), Some(7), Some(60), Some(61), Some(u16::MAX)] {
        let (parallel, codes) = in_parallel::<Rgb565>(rows, 13);
        assert!(parallel == color && codes == depth, "{rows:?} rows");
    }
    assert!(in_parallel::<Rgba8888>(Some(5), 0) == whole::<Rgba8888>(), "in 32 bits");
}

#[test]
fn any_number_of_threads_draws_the_same() {
    let expected = whole::<Rgb565>();
    for threads in [1, 2, 5] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        let pool = pool.expect("threads can be started");
        assert!(pool.install(|| in_parallel::<Rgb565>(None, 0)) == expected, "{threads} threads");
    }
}

#[test]
fn buffers_that_are_too_small_are_refused() {
    let pixels = usize::from(PICTURE.width) * usize::from(PICTURE.height);
    let (mut color, mut depth) = (vec![0_u16; pixels], vec![0; pixels - 1]);
    let refused = ParallelBands::<Rgb565>::new(&mut color, &mut depth, PICTURE);
    assert!(matches!(refused, Err(FrameError::Depth { .. })));
    let refused = ParallelBands::<Rgb565>::new(&mut color[1..], &mut depth, PICTURE);
    assert!(matches!(refused, Err(FrameError::Color { .. })));
}
