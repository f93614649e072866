//! A lit teapot turns on an ESP32-C3 with an ILI9341 of 320x240 pixels.
#![no_std]
#![no_main]

use core::fmt::Write;

use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::master::{self, Spi};
use esp_hal::time::{Instant, Rate};
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Bands, Camera, Cull, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ILI9341Rgb565;
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use panic_halt as _;
use static_cell::ConstStaticCell;

/// The display, lying on its side.
const PICTURE: Size = Size::new(320, 240);
/// Rows that are drawn and sent at a time: 640 bytes of colour each, and as many of depth.
const ROWS: usize = 80;
const PIXELS: usize = PICTURE.width as usize * ROWS;

static COLOR: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);
static DEPTH: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));

    // The pins: change them here.
    let (clock, data) = (chip.GPIO6, chip.GPIO7);
    let select = Output::new(chip.GPIO10, Level::High, OutputConfig::default());
    let data_or_command = Output::new(chip.GPIO4, Level::Low, OutputConfig::default());
    let reset = Output::new(chip.GPIO5, Level::High, OutputConfig::default());

    // The display.
    let config = master::Config::default().with_frequency(Rate::from_mhz(40));
    let bus = Spi::new(chip.SPI2, config)
        .expect("the bus is as fast as that")
        .with_sck(clock)
        .with_mosi(data);
    let device = ExclusiveDevice::new_no_delay(bus, select).expect("the pin can be set");
    let mut batch = [0; 512];
    let interface = SpiInterface::new(device, data_or_command, &mut batch);
    let mut display = mipidsi::Builder::new(ILI9341Rgb565, interface)
        .orientation(Orientation::new().rotate(Rotation::Deg90).flip_horizontal())
        .color_order(ColorOrder::Bgr)
        .reset_pin(reset)
        .init(&mut Delay::new())
        .expect("the display is there");

    // The scene.
    let mut bands = Bands::<Rgb565>::new(COLOR.take(), PICTURE)
        .and_then(|bands| bands.with_depth(DEPTH.take()))
        .expect("a row fits");
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 3.0, 7.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let shader = Gouraud::lit(&[sun]);
    let white = MonoTextStyle::new(&FONT_10X20, pixelcolor::Rgb565::WHITE);

    let mut text = heapless::String::<16>::new();
    loop {
        let start = Instant::now();
        let time = start.duration_since_epoch().as_millis() % 7200;
        let turned = Mat4::rotation_y((time as f32 / 20.0).degrees());
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
