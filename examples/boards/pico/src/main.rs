//! A lit teapot turns on a Raspberry Pi Pico with an ST7789 of 240x240 pixels.
#![no_std]
#![no_main]

use core::fmt::Write;

use embassy_rp::gpio::{Level, Output};
use embassy_rp::spi::{self, Spi};
use embassy_time::{Delay, Instant};
use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use embedded_hal_bus::spi::ExclusiveDevice;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Bands, Camera, Cull, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;
use panic_halt as _;
use static_cell::ConstStaticCell;

/// The display.
const PICTURE: Size = Size::new(240, 240);
/// Rows that are drawn and sent at a time: 480 bytes of colour each, and as many of depth.
const ROWS: usize = 40;
const PIXELS: usize = PICTURE.width as usize * ROWS;

static COLOR: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);
static DEPTH: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

#[cortex_m_rt::entry]
fn main() -> ! {
    let pins = embassy_rp::init(Default::default());

    // The pins: change them here.
    let (clock, data) = (pins.PIN_18, pins.PIN_19);
    let select = Output::new(pins.PIN_17, Level::High);
    let data_or_command = Output::new(pins.PIN_20, Level::Low);
    let reset = Output::new(pins.PIN_21, Level::High);
    let _backlight = Output::new(pins.PIN_22, Level::High);

    // The display.
    let mut config = spi::Config::default();
    config.frequency = 62_500_000;
    config.polarity = spi::Polarity::IdleHigh;
    config.phase = spi::Phase::CaptureOnSecondTransition;
    let bus = Spi::new_blocking_txonly(pins.SPI0, clock, data, config);
    let device = ExclusiveDevice::new_no_delay(bus, select).expect("the pin can be set");
    let mut batch = [0; 512];
    let mut display =
        mipidsi::Builder::new(ST7789, SpiInterface::new(device, data_or_command, &mut batch))
            .display_size(PICTURE.width, PICTURE.height)
            .invert_colors(ColorInversion::Inverted)
            .reset_pin(reset)
            .init(&mut Delay)
            .expect("the display answers");

    // The scene.
    let mut bands = Bands::<Rgb565>::new(COLOR.take(), PICTURE)
        .and_then(|bands| bands.with_depth(DEPTH.take()))
        .expect("a row fits");
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 3.8, 8.8),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let shader = Gouraud::lit(&[sun]);
    let white = MonoTextStyle::new(&FONT_10X20, pixelcolor::Rgb565::WHITE);

    let mut text = heapless::String::<16>::new();
    loop {
        let start = Instant::now();
        let turned = Mat4::rotation_y(((start.as_millis() % 7200) as f32 / 20.0).degrees());
        bands
            .draw(
                |frame| {
                    frame.clear(Rgb::new(16, 24, 48));
                    Pass::new(&camera)
                        .cull(Cull::Back)
                        .depth(Less)
                        .draw(frame, &turned, &TEAPOT, &shader);
                    let Ok(_) = Text::new(&text, Point::new(8, 20), white).draw(frame);
                },
                |band| band.draw(&mut display),
            )
            .expect("the display takes all pixels");
        text.clear();
        let _ = write!(text, "{} FPS", 1_000_000 / start.elapsed().as_micros().max(1));
    }
}
