//! `embedded-graphics` on a frame: every operation against single pixels, and text over 3D.
#![cfg(feature = "embedded-graphics")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "pixels of a small picture, random numbers"
)]

mod support;

use embedded_graphics::mono_font::{ascii::FONT_6X10, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, PixelColor, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, PrimitiveStyle, Rectangle};
use embedded_graphics::text::Text;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Cull, DrawFormat, Frame, Gouraud, Less, Light, Pass, Rect, Rgb, Rgb565, Rgb565Be,
    Rgba8888,
};
use support::Random;

const WIDTH: usize = 24;
const HEIGHT: usize = 18;
/// Words of a row, more than are drawn to.
const STRIDE: usize = 29;

/// Something drawn by `embedded-graphics`.
#[derive(Clone, Copy, Debug)]
enum Operation {
    Solid(Rectangle),
    Contiguous(Rectangle, usize),
    Clear,
    Pixels(Rectangle),
}

/// Colour number `i` of an operation.
trait Numbered: PixelColor {
    fn numbered(i: usize) -> Self;
}

impl Numbered for pixelcolor::Rgb565 {
    fn numbered(i: usize) -> Self {
        Self::new(i as u8 & 31, (i >> 5) as u8 & 63, 7)
    }
}

impl Numbered for pixelcolor::Rgb888 {
    fn numbered(i: usize) -> Self {
        Self::new(i as u8, (i >> 8) as u8, 99)
    }
}

/// What an operation must do, one pixel after the other.
fn expect<F: DrawFormat>(operation: Operation, scissor: Rect, mut set: impl FnMut(i32, i32, F::Raw))
where
    F::DrawColor: Numbered,
{
    let color = |i| F::pack_draw_color(F::DrawColor::numbered(i));
    let (area, limit, solid) = match operation {
        Operation::Solid(area) => (area, usize::MAX, true),
        Operation::Contiguous(area, limit) => (area, limit, false),
        Operation::Pixels(area) => (area, usize::MAX, false),
        Operation::Clear => (
            Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32)),
            usize::MAX,
            true,
        ),
    };
    for (i, point) in area.points().enumerate().take(limit) {
        if scissor.contains(point.x, point.y) {
            set(point.x, point.y, color(if solid { 5 } else { i }));
        }
    }
}

fn perform<F: DrawFormat>(frame: &mut Frame<'_, F>, operation: Operation)
where
    F::DrawColor: Numbered,
{
    let colors = (0..).map(F::DrawColor::numbered);
    let color = F::DrawColor::numbered(5);
    let Ok(()) = match operation {
        Operation::Solid(area) => frame.fill_solid(&area, color),
        Operation::Contiguous(area, limit) => frame.fill_contiguous(&area, colors.take(limit)),
        Operation::Clear => DrawTarget::clear(frame, color),
        Operation::Pixels(area) => {
            frame.draw_iter(area.points().zip(colors).map(|(at, color)| Pixel(at, color)))
        }
    };
}

fn check<F: DrawFormat>(seed: u64)
where
    F::DrawColor: Numbered,
    F::Raw: PartialEq + core::fmt::Debug,
{
    let mut random = Random(seed);
    for i in 0..3_000 {
        let area = Rectangle::new(
            Point::new(random.range(-30, 40), random.range(-30, 40)),
            Size::new(random.range(0, 50) as u32, random.range(0, 40) as u32),
        );
        let operation = match i % 4 {
            0 => Operation::Solid(area),
            1 => Operation::Contiguous(area, random.range(0, 1_500) as usize),
            2 => Operation::Pixels(area),
            _ => Operation::Clear,
        };
        let scissor = if i % 3 == 0 {
            let (x, y) = (random.range(-3, 20), random.range(-3, 15));
            Rect::new(x, y, x + random.range(0, 20), y + random.range(0, 15))
        } else {
            Rect::new(0, 0, WIDTH as i32, HEIGHT as i32)
        };
        let band = random.range(1, HEIGHT as i32) as u16;
        let zero: F::Raw = bytemuck::Zeroable::zeroed();
        let mut expected = vec![zero; STRIDE * HEIGHT];
        let inside = scissor.intersection(Rect::new(0, 0, WIDTH as i32, HEIGHT as i32));
        expect::<F>(operation, inside, |x, y, raw| {
            expected[y as usize * STRIDE + x as usize] = raw
        });
        // The whole picture, and the same in bands.
        let mut found = vec![zero; STRIDE * HEIGHT];
        let mut top = 0;
        while top < HEIGHT as u16 {
            let rows = band.min(HEIGHT as u16 - top);
            let part = &mut found[usize::from(top) * STRIDE..];
            let size = microraster::Size::new(WIDTH as u16, rows);
            let frame =
                Frame::<F>::with_stride(part, size, STRIDE as u32).expect("the buffer fits");
            let mut frame = frame.band(top, HEIGHT as u16).expect("within the picture");
            frame.set_scissor(scissor);
            perform(&mut frame, operation);
            top += rows;
        }
        assert_eq!(found, expected, "{operation:?} in bands of {band}, scissor {scissor:?}");
    }
}

#[test]
fn operations_set_the_pixels_that_they_should_in_all_formats() {
    check::<Rgb565>(1);
    check::<Rgb565Be>(2);
    check::<Rgba8888>(3);
}

#[test]
fn rectangles_at_the_ends_of_the_numbers_are_cut() {
    let mut pixels = [0u16; 64];
    let mut frame =
        Frame::<Rgb565>::new(&mut pixels, microraster::Size::new(8, 8)).expect("the buffer fits");
    let white = pixelcolor::Rgb565::WHITE;
    for (x, y) in [(i32::MAX, 0), (0, i32::MAX), (i32::MIN, i32::MIN), (-1, -1)] {
        let area = Rectangle::new(Point::new(x, y), Size::new(u32::MAX, u32::MAX));
        let Ok(()) = frame.fill_solid(&area, white);
        let Ok(()) = frame.fill_contiguous(&area, core::iter::repeat_n(white, 100));
        let Ok(()) = frame.draw_iter([Pixel(Point::new(x, y), white)]);
    }
    // Only the last one reaches the picture.
    assert!(pixels.iter().all(|pixel| *pixel == 0xFFFF), "filled");
}

#[test]
fn text_lies_over_the_3d_picture_and_leaves_depth_alone() {
    let size = microraster::Size::new(128, 64);
    let picture = |labelled: bool| {
        let (mut pixels, mut depth) = (vec![0u16; 128 * 64], vec![0u16; 128 * 64]);
        let frame = Frame::<Rgb565>::new(&mut pixels, size).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
        frame.clear(Rgb::new(16, 24, 48));
        let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
            Vec3::new(0.0, 2.0, 5.0),
            Vec3::ZERO,
            Vec3::Y,
        );
        let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
        Pass::new(&camera).cull(Cull::Back).depth(Less).draw(
            &mut frame,
            &Mat4::identity(),
            &TEAPOT,
            &Gouraud::lit(&[sun]),
        );
        if labelled {
            let style = MonoTextStyle::new(&FONT_6X10, pixelcolor::Rgb565::YELLOW);
            let Ok(_) = Text::new("Utah 992", Point::new(36, 34), style).draw(&mut frame);
            let ring = PrimitiveStyle::with_stroke(pixelcolor::Rgb565::GREEN, 2);
            let Ok(()) = Circle::new(Point::new(100, -8), 24).into_styled(ring).draw(&mut frame);
        }
        (pixels, depth)
    };
    let (plain, plain_depth) = picture(false);
    let (labelled, depth) = picture(true);
    assert!(depth == plain_depth, "2D changed the depth");
    let changed = plain.iter().zip(&labelled).filter(|(a, b)| a != b);
    let drawn: Vec<u16> = changed.map(|(_, after)| *after).collect();
    assert!(drawn.len() > 150, "text and ring cover {} pixels", drawn.len());
    assert!(drawn.iter().all(|pixel| [0xFFE0, 0x07E0].contains(pixel)), "in their colours only");
    if let Some(file) = std::env::var_os("MICRORASTER_PICTURE") {
        let rgb = |raw: &u16| {
            let color = <Rgb565 as microraster::Format>::unpack(*raw);
            [color.red(), color.green(), color.blue()]
        };
        let bytes: Vec<u8> = labelled.iter().flat_map(rgb).collect();
        image::save_buffer(file, &bytes, 128, 64, image::ColorType::Rgb8).expect("written");
    }
}
