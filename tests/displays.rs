//! `embedded-graphics`' own displays: what it draws on a frame is what it draws on its framebuffer,
//! pixel by pixel, and pictures arrive on its mock display and in its simulator.
#![cfg(feature = "embedded-graphics")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "pixels of a small picture, random numbers"
)]

mod support;

use embedded_graphics::framebuffer::{buffer_size, Framebuffer};
use embedded_graphics::image::{GetPixel, Image, ImageRaw};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::mono_font::ascii::{FONT_4X6, FONT_6X10};
use embedded_graphics::mono_font::{MonoTextStyle, MonoTextStyleBuilder};
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{
    Arc, Circle, Ellipse, Line, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle, RoundedRectangle,
    Sector, StrokeAlignment, Triangle,
};
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics_simulator::SimulatorDisplay;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Bands, Camera, Cull, DrawFormat, Frame, Gouraud, Less, Light, Pass, Rect, Rgb, Rgb565,
    Rgb565Be, Rgba8888,
};
use support::Random;

const WIDTH: usize = 61;
const HEIGHT: usize = 47;
const PICTURE: microraster::Size = microraster::Size::new(WIDTH as u16, HEIGHT as u16);
/// More than any size of its pixels.
const BYTES: usize = buffer_size::<pixelcolor::Rgb565>(WIDTH, HEIGHT);

type Color = pixelcolor::Rgb565;
type Own = Framebuffer<Color, RawU16, LittleEndian, WIDTH, HEIGHT, BYTES>;

/// An image of two bytes a pixel.
static IMAGE: [u8; 2 * 7 * 5] = {
    let mut bytes = [0; 2 * 7 * 5];
    let mut i = 0;
    while i < bytes.len() {
        bytes[i] = (i * 37 % 256) as u8;
        i += 1;
    }
    bytes
};

/// A few of all things that `embedded-graphics` draws, one over the other.
fn draw_something<D: DrawTarget<Color = Color>>(target: &mut D, mut random: Random) {
    for _ in 0..4 {
        draw_one(target, &mut random);
    }
}

/// One of everything that `embedded-graphics` draws, somewhere about the picture.
fn draw_one<D: DrawTarget<Color = Color>>(target: &mut D, random: &mut Random) {
    let mut point = |margin: i32| {
        let (right, bottom) = (WIDTH as i32 + margin, HEIGHT as i32 + margin);
        Point::new(random.range(-margin, right), random.range(-margin, bottom))
    };
    let (a, b, c, d) = (point(20), point(20), point(20), point(90));
    let size = Size::new(random.range(0, 40) as u32, random.range(0, 40) as u32);
    let mut color = || Color::new(random.next() as u8, random.next() as u8, random.next() as u8);
    let (stroke, fill) = (color(), color());
    let alignment = match random.range(0, 2) {
        0 => StrokeAlignment::Inside,
        1 => StrokeAlignment::Center,
        _ => StrokeAlignment::Outside,
    };
    let mut style = PrimitiveStyleBuilder::new()
        .stroke_color(stroke)
        .stroke_width(random.range(0, 5) as u32)
        .stroke_alignment(alignment);
    if random.range(0, 1) == 0 {
        style = style.fill_color(fill);
    }
    let style = style.build();
    let angle = (random.range(0, 360) as f32).deg();
    let sweep = (random.range(-400, 400) as f32).deg();
    let drawn = match random.range(0, 11) {
        0 => Line::new(a, b).into_styled(style).draw(target),
        1 => Rectangle::new(a, size).into_styled(style).draw(target),
        2 => Circle::new(a, size.width).into_styled(style).draw(target),
        3 => Ellipse::new(a, size).into_styled(style).draw(target),
        4 => Triangle::new(a, b, d).into_styled(style).draw(target),
        5 => {
            let rectangle = Rectangle::new(a, size);
            RoundedRectangle::with_equal_corners(rectangle, Size::new(5, 3))
                .into_styled(style)
                .draw(target)
        }
        6 => Arc::new(a, size.width, angle, sweep).into_styled(style).draw(target),
        7 => Sector::new(a, size.width, angle, sweep).into_styled(style).draw(target),
        8 => {
            let points = [a, b, c];
            let line = embedded_graphics::primitives::Polyline::new(&points);
            line.into_styled(PrimitiveStyle::with_stroke(stroke, 1)).draw(target)
        }
        9 => {
            let style = MonoTextStyle::new(&FONT_6X10, stroke);
            Text::new("g|Qj\n3D", a, style).draw(target).map(|_| ())
        }
        10 => {
            let style = MonoTextStyleBuilder::new()
                .font(&FONT_4X6)
                .text_color(stroke)
                .background_color(fill)
                .underline()
                .build();
            let aligned = Text::with_alignment("60 FPS", a, style, Alignment::Center);
            aligned.draw(target).map(|_| ())
        }
        _ => {
            let raw = ImageRaw::<Color, LittleEndian>::new(&IMAGE, 7);
            Image::new(&raw, a).draw(target)
        }
    };
    assert!(drawn.is_ok(), "no target fails");
}

/// Draws the same on a frame in bands of some height; the whole picture.
fn in_bands<F: DrawFormat<DrawColor = Color>>(rows: u16, random: Random) -> Vec<F::Raw> {
    let mut picture = Vec::new();
    let mut pixels = vec![F::pack(Rgb::BLACK.into()); WIDTH * usize::from(rows)];
    let mut bands = Bands::<F>::new(&mut pixels, PICTURE).expect("a row fits");
    bands
        .draw(
            |frame| {
                frame.clear_color(Rgb::BLACK);
                draw_something(frame, random);
            },
            |band| -> Result<(), core::convert::Infallible> {
                picture.extend_from_slice(band.pixels());
                Ok(())
            },
        )
        .expect("nobody refuses");
    picture
}

#[test]
fn everything_drawn_on_a_frame_is_what_its_own_framebuffer_shows_whole_and_in_bands() {
    let mut seeds = Random(0xD15);
    let mut drawn = 0;
    for case in 0..1500 {
        let random = Random(seeds.next());
        let mut own = Own::new();
        draw_something(&mut own, random);
        let pixel = |i: usize| {
            let at = Point::new((i % WIDTH) as i32, (i / WIDTH) as i32);
            own.pixel(at).expect("within the framebuffer").into_storage()
        };
        let expected: Vec<u16> = (0..WIDTH * HEIGHT).map(pixel).collect();
        drawn += usize::from(expected.iter().any(|raw| *raw != 0));
        let rows = [HEIGHT as u16, 1, 5, 16][case % 4];
        assert!(in_bands::<Rgb565>(rows, random) == expected, "{random:?} in {rows} rows");
        if case % 5 == 0 {
            let found: Vec<u16> =
                in_bands::<Rgb565Be>(rows, random).into_iter().map(u16::from_be).collect();
            assert!(found == expected, "{random:?} in {rows} rows, high byte first");
        }
    }
    assert!(drawn > 1400, "{drawn} pictures show something");
}

/// A lit teapot with a label.
fn draw_scene<D>(frame: &mut Frame<'_, Rgb565, D>)
where
    for<'a> Frame<'a, Rgb565, D>: DrawTarget<Color = Color, Error = core::convert::Infallible>,
    D: microraster::frame::Supplies<microraster::frame::ReadWrite>,
{
    frame.clear_color(Rgb::new(16, 24, 48));
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.0, 5.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    Pass::new(&camera).cull(Cull::Back).depth(Less).draw(
        frame,
        &Mat4::identity(),
        &TEAPOT,
        &Gouraud::lit(&[sun]),
    );
    let style = MonoTextStyle::new(&FONT_6X10, Color::YELLOW);
    let Ok(_) = Text::new("teapot", Point::new(4, 44), style).draw(frame);
}

#[test]
fn a_picture_arrives_on_displays_by_bands_each_pixel_once_and_none_outside() {
    let mut whole = vec![0u16; WIDTH * HEIGHT];
    let mut depth = vec![0u16; WIDTH * HEIGHT];
    let frame = Frame::<Rgb565>::new(&mut whole, PICTURE).expect("the buffer fits");
    let mut frame = frame.with_depth(&mut depth).expect("the buffer fits");
    draw_scene(&mut frame);
    // The mock display panics if a pixel comes twice, or comes from outside of its 64x64.
    let mut from_frame = MockDisplay::<Color>::new();
    frame.draw(&mut from_frame).expect("it takes all");
    for rows in [1usize, 6, 16, HEIGHT] {
        let mut mock = MockDisplay::<Color>::new();
        let mut simulated = SimulatorDisplay::<Color>::new(Size::new(WIDTH as u32, HEIGHT as u32));
        let (mut pixels, mut depth) = (vec![0; WIDTH * rows], vec![0; WIDTH * rows]);
        let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("a row fits");
        let mut bands = bands.with_depth(&mut depth).expect("a row fits");
        let clear = |frame: &mut Frame<'_, Rgb565, microraster::frame::DepthBuffer<'_>>| {
            frame.clear_depth(0);
            draw_scene(frame);
        };
        bands.draw(clear, |band| band.draw(&mut mock)).expect("it takes all");
        bands.draw(clear, |band| band.draw(&mut simulated)).expect("it takes all");
        for (i, raw) in whole.iter().enumerate() {
            let at = Point::new((i % WIDTH) as i32, (i / WIDTH) as i32);
            let expected = Rgb565::unpack_draw_color(*raw);
            assert_eq!(mock.get_pixel(at), Some(expected), "{at} in bands of {rows}");
            assert_eq!(simulated.get_pixel(at), expected, "{at} in bands of {rows}");
            assert_eq!(from_frame.get_pixel(at), Some(expected), "{at} from the frame");
        }
        assert_eq!(mock.affected_area().size, Size::new(WIDTH as u32, HEIGHT as u32), "no more");
    }
}

#[test]
fn what_is_cropped_or_cut_by_a_scissor_arrives_in_its_place() {
    let mut pixels: Vec<u16> = (0..(WIDTH * HEIGHT) as u16).collect();
    let raw = |at: Point| (at.y * WIDTH as i32 + at.x) as u16;
    let wanted = Rect::new(9, 11, 23, 30);
    let mut frame = Frame::<Rgb565>::new(&mut pixels, PICTURE).expect("the buffer fits");
    frame.set_scissor(wanted);
    let mut by_scissor = MockDisplay::<Color>::new();
    frame.draw(&mut by_scissor).expect("it takes all");
    frame.set_scissor(Rect::default());
    let mut nothing = MockDisplay::<Color>::new();
    frame.draw(&mut nothing).expect("it takes nothing");
    let mut by_bands = MockDisplay::<Color>::new();
    let mut bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("a row fits");
    bands = bands.rows_at_most(4);
    for number in 0..bands.count() {
        let first = bands.area(number).top as u16 * WIDTH as u16;
        let fill = |frame: &mut Frame<'_, Rgb565>| {
            let area = Rectangle::new(Point::zero(), Size::new(WIDTH as u32, HEIGHT as u32));
            let colors = (0..u16::MAX).map(Rgb565::unpack_draw_color);
            let Ok(()) = frame.fill_contiguous(&area, colors);
        };
        let mut band = bands.draw_band(number, fill).expect("there is such a band");
        assert_eq!(band.pixels().first(), Some(&first), "the first pixel of band {number}");
        band.crop(wanted);
        if band.area().is_empty() {
            band.draw(&mut nothing).expect("it takes nothing");
        } else {
            band.draw(&mut by_bands).expect("it takes all");
        }
    }
    assert_eq!(nothing.affected_area().size, Size::zero(), "an empty area is nothing");
    for at in Rectangle::new(Point::zero(), Size::new(64, 64)).points() {
        let expected = wanted.contains(at.x, at.y).then(|| Rgb565::unpack_draw_color(raw(at)));
        assert_eq!(by_scissor.get_pixel(at), expected, "{at} by scissor");
        assert_eq!(by_bands.get_pixel(at), expected, "{at} by bands");
    }
}

#[test]
fn colours_of_all_formats_survive_the_way_out_and_back() {
    for raw in 0..=u16::MAX {
        let there = |color| Rgb565::pack_draw_color(color);
        assert_eq!(there(Rgb565::unpack_draw_color(raw)), raw, "{raw:04x}");
        let back = Rgb565Be::pack_draw_color(Rgb565Be::unpack_draw_color(raw));
        assert_eq!(back, raw, "{raw:04x}, high byte first");
        assert_eq!(Rgb565::unpack_draw_color(raw), Rgb565Be::unpack_draw_color(raw.to_be()));
    }
    let mut random = Random(5);
    for _ in 0..10_000 {
        let [red, green, blue, alpha] = (random.next() as u32).to_ne_bytes();
        let color = Rgba8888::unpack_draw_color(u32::from_ne_bytes([red, green, blue, alpha]));
        assert_eq!(color, pixelcolor::Rgb888::new(red, green, blue), "by its bytes");
        let packed = Rgba8888::pack_draw_color(color).to_ne_bytes();
        assert_eq!(packed, [red, green, blue, 255], "alpha is gone");
    }
}
