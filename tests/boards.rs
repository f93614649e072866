//! The pictures in the README files of `examples/boards` are those that the boards draw, and those
//! that arrive at panels through the driver that boards use.
#![cfg(feature = "embedded-graphics")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]

use std::cell::{Cell, RefCell};
use std::convert::Infallible;
use std::path::Path;
use std::rc::Rc;

use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::{Drawable, Point};
use embedded_graphics::text::Text;
use embedded_hal::delay::DelayNs;
use embedded_hal::{digital, spi};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Band, Bands, Camera, Cull, DisplayList, DrawFormat, Format, Gouraud, Less, Light, ListTriangle,
    ListVertex, Pass, Rgb, Rgb565, Rgb565Be, Size, VertexCache,
};
use mipidsi::interface::SpiInterface;
use mipidsi::models::{ILI9341Rgb565, Model, ST7789};
use mipidsi::options::{Orientation, Rotation};

const SQUARE: Size = Size::new(240, 240);
const WIDE: Size = Size::new(320, 240);

/// The square display sees less to the sides, from further away.
fn camera(picture: Size) -> Camera {
    let eye = if picture == SQUARE { Vec3::new(0.0, 3.8, 8.8) } else { Vec3::new(0.0, 3.0, 7.0) };
    Camera::perspective(45.0.degrees(), 0.5).look_at(eye, Vec3::ZERO, Vec3::Y)
}

fn sun() -> Light {
    Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204))
}

/// The scene of the boards at 45 degrees, in bands of so many rows.
fn draw_bands<F: DrawFormat<Raw = u16, DrawColor = pixelcolor::Rgb565>>(
    picture: Size,
    rows: u16,
    send: impl FnMut(Band<'_, F>) -> Result<(), Infallible>,
) {
    let pixels = usize::from(picture.width) * usize::from(rows);
    let (mut color, mut depth) = (vec![0; pixels], vec![0; pixels]);
    let mut bands = Bands::<F>::new(&mut color, picture)
        .and_then(|bands| bands.with_depth(&mut depth))
        .expect("a row fits");
    let camera = camera(picture);
    let (turned, shader) = (Mat4::rotation_y(45.0.degrees()), Gouraud::lit(&[sun()]));
    let white = MonoTextStyle::new(&FONT_10X20, pixelcolor::Rgb565::WHITE);
    let Ok(()) = bands.draw(
        |frame| {
            frame.clear(Rgb::new(16, 24, 48));
            Pass::new(&camera).cull(Cull::Back).depth(Less).draw(frame, &turned, &TEAPOT, &shader);
            let Ok(_) = Text::new("FPS", Point::new(8, 20), white).draw(frame);
        },
        send,
    );
}

/// What a display of [`Rgb565`] shows of 16 bits.
fn shown(pixel: u16) -> [u8; 3] {
    let color = Rgb565::unpack(pixel);
    [color.red(), color.green(), color.blue()]
}

/// The picture in a display's memory that is written to directly.
fn draw(picture: Size, rows: u16) -> Vec<[u8; 3]> {
    let mut display = Vec::new();
    draw_bands::<Rgb565>(picture, rows, |band| {
        display.extend(band.pixels().iter().copied().map(shown));
        Ok(())
    });
    display
}

/// Commands, each with its data.
type Commands = Vec<(u8, Vec<u8>)>;

/// A panel on four wires: what it was sent, as commands with their data.
#[derive(Clone, Debug, Default)]
struct Wires {
    data_follows: Rc<Cell<bool>>,
    sent: Rc<RefCell<Commands>>,
}

impl digital::ErrorType for Wires {
    type Error = Infallible;
}

/// The wire that tells data from commands.
impl digital::OutputPin for Wires {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.data_follows.set(false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.data_follows.set(true);
        Ok(())
    }
}

impl spi::ErrorType for Wires {
    type Error = Infallible;
}

impl spi::SpiDevice for Wires {
    fn transaction(&mut self, operations: &mut [spi::Operation<'_, u8>]) -> Result<(), Infallible> {
        let mut sent = self.sent.borrow_mut();
        for operation in operations {
            let spi::Operation::Write(bytes) = operation else { panic!("nothing is read") };
            if self.data_follows.get() {
                sent.last_mut().expect("a command").1.extend_from_slice(bytes);
            } else {
                sent.extend(bytes.iter().map(|command| (*command, Vec::new())));
            }
        }
        Ok(())
    }
}

impl Wires {
    /// What a panel of this size shows after all that.
    fn picture(&self, size: Size) -> Vec<[u8; 3]> {
        let (width, height) = (usize::from(size.width), usize::from(size.height));
        let mut memory = vec![None; width * height];
        let (mut columns, mut rows) = (0..0, 0..0);
        for (command, data) in self.sent.borrow().iter() {
            let pairs = data.chunks_exact(2).map(|pair| u16::from_be_bytes([pair[0], pair[1]]));
            let ends: Vec<_> = pairs.clone().take(2).map(usize::from).collect();
            match command {
                0x2A => columns = ends[0]..ends[1] + 1,
                0x2B => rows = ends[0]..ends[1] + 1,
                0x2C => {
                    let places = rows.clone().flat_map(|y| columns.clone().map(move |x| (x, y)));
                    assert_eq!(pairs.len(), places.clone().count(), "as many as the window has");
                    for ((x, y), pixel) in places.zip(pairs) {
                        let old = memory[y * width + x].replace(pixel);
                        assert!(old.is_none(), "{x}, {y} came twice");
                    }
                }
                _ => {}
            }
        }
        memory.into_iter().map(|pixel| shown(pixel.expect("every pixel came"))).collect()
    }
}

/// Time that passes at once.
struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _: u32) {}
}

/// What a panel shows that gets its bands through its driver.
fn through_driver<F, M>(
    model: M,
    orientation: Orientation,
    picture: Size,
    rows: u16,
) -> Vec<[u8; 3]>
where
    F: DrawFormat<Raw = u16, DrawColor = pixelcolor::Rgb565>,
    M: Model<ColorFormat = pixelcolor::Rgb565>,
{
    let (wires, mut batch) = (Wires::default(), [0; 512]);
    let interface = SpiInterface::new(wires.clone(), wires.clone(), &mut batch);
    let builder = mipidsi::Builder::new(model, interface).orientation(orientation);
    let builder = if picture == SQUARE { builder.display_size(240, 240) } else { builder };
    let mut display = builder.init(&mut NoDelay).expect("a panel");
    draw_bands::<F>(picture, rows, |band| {
        band.draw(&mut display).expect("no wire is broken");
        Ok(())
    });
    wires.picture(picture)
}

fn is_kept(name: &str, size: Size, drawn: &[[u8; 3]]) {
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/pictures").join(name);
    let (width, height) = (size.width.into(), size.height.into());
    let drawn = image::RgbImage::from_raw(width, height, drawn.concat()).expect("a picture");
    if std::env::var_os("MICRORASTER_REWRITE_GOLDENS").is_some() {
        drawn.save(&kept).expect("written");
    }
    let kept = image::open(&kept).expect("the kept picture").into_rgb8();
    assert!(drawn == kept, "{name} is another picture");
}

#[test]
fn the_square_display_shows_the_picture_of_its_readme() {
    is_kept("board-240x240.png", SQUARE, &draw(SQUARE, 40));
}

#[test]
fn the_wide_display_shows_the_picture_of_its_readme() {
    let drawn = draw(WIDE, 60);
    assert!(drawn == draw(WIDE, 80), "bands of 80 rows");
    is_kept("board-320x240.png", WIDE, &drawn);
}

#[test]
fn bytes_in_the_order_of_panels_are_the_same_picture() {
    let mut sent = Vec::new();
    draw_bands::<Rgb565Be>(WIDE, 40, |band| {
        sent.extend_from_slice(band.as_bytes());
        Ok(())
    });
    let pixels = sent.chunks_exact(2).map(|pair| shown(u16::from_be_bytes([pair[0], pair[1]])));
    assert!(pixels.eq(draw(WIDE, 40)));
}

#[test]
fn each_pixel_goes_through_the_driver_once() {
    let (square, wide) = (draw(SQUARE, 40), draw(WIDE, 60));
    let upright = Orientation::new();
    let turned = upright.rotate(Rotation::Deg90).flip_horizontal();
    assert!(through_driver::<Rgb565, _>(ST7789, upright, SQUARE, 40) == square, "ST7789");
    assert!(through_driver::<Rgb565Be, _>(ST7789, upright, SQUARE, 7) == square, "ST7789, Be");
    assert!(through_driver::<Rgb565, _>(ILI9341Rgb565, turned, WIDE, 60) == wide, "ILI9341");
    // As the README of `pico` has it for a panel on its side.
    let turned = upright.rotate(Rotation::Deg90);
    assert!(through_driver::<Rgb565, _>(ST7789, turned, WIDE, 40) == wide, "ST7789 on its side");
}

#[test]
fn the_list_of_two_cores_holds_what_is_seen_at_every_turn() {
    let (mut vertices, mut triangles) = ([ListVertex::default(); 400], [ListTriangle::BLANK; 512]);
    let (shader, mut cache) = (Gouraud::lit(&[sun()]), VertexCache::<u16, 512>::new());
    let mut list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    let mut most = (0, 0);
    for step in 0..7200 {
        let turned = Mat4::rotation_y((step as f32 / 20.0).degrees());
        let recording = Pass::new(&camera(SQUARE)).cull(Cull::Back).record(
            list,
            Size::new(240, 240),
            &turned,
            &TEAPOT,
            &shader,
            &mut cache,
        );
        assert_eq!(recording.check(), Ok(()), "room at {step}");
        list = recording.into_list();
        most = (list.vertices().max(most.0), list.triangles().max(most.1));
    }
    assert!(most.0 > 300 && most.1 > 400, "{most:?} is no teapot");
}

#[test]
fn all_of_the_teapot_is_seen_all_of_the_turn() {
    for picture in [SQUARE, WIDE] {
        let (width, height) = (usize::from(picture.width), usize::from(picture.height));
        let (mut pixels, mut depth) = (vec![0; width * height], vec![0; width * height]);
        let camera = camera(picture);
        for step in 0..72u8 {
            let frame = microraster::Frame::<Rgb565>::new(&mut pixels, picture);
            let frame = frame.and_then(|frame| frame.with_depth(&mut depth));
            let mut frame = frame.expect("buffers of the picture's size");
            frame.clear(Rgb::BLACK);
            let turned = Mat4::rotation_y((f32::from(step) * 5.0).degrees());
            let shader = Gouraud::lit(&[sun()]);
            Pass::new(&camera)
                .cull(Cull::Back)
                .depth(Less)
                .draw(&mut frame, &turned, &TEAPOT, &shader);
            let at_border = |i: usize| {
                let (x, y) = (i % width, i / width);
                x == 0 || y == 0 || x + 1 == width || y + 1 == height
            };
            let cut = depth.iter().enumerate().filter(|(i, code)| at_border(*i) && **code > 0);
            assert_eq!(cut.count(), 0, "{picture:?} at {} degrees", u32::from(step) * 5);
            assert!(depth.iter().any(|code| *code > 0), "there is a teapot");
        }
    }
}
