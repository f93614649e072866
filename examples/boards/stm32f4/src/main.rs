//! A lit teapot turns on a Black Pill (STM32F411) with an ILI9341 of 320x240 pixels.
#![no_std]
#![no_main]

use core::fmt::Write;

use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use embedded_hal_bus::spi::ExclusiveDevice;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Bands, Camera, Cull, Gouraud, Less, Light, Pass, Rgb, Rgb565, Size};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ILI9341Rgb565;
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use panic_halt as _;
use static_cell::ConstStaticCell;
use stm32f4xx_hal::gpio::{PinState, Speed};
use stm32f4xx_hal::pac::{CorePeripherals, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc;
use stm32f4xx_hal::spi::{Mode, Phase, Polarity, Spi};

/// The display, lying on its side.
const PICTURE: Size = Size::new(320, 240);
/// Rows that are drawn and sent at a time: 640 bytes of colour each, and as many of depth.
const ROWS: usize = 60;
const PIXELS: usize = PICTURE.width as usize * ROWS;

static COLOR: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);
static DEPTH: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

#[cortex_m_rt::entry]
fn main() -> ! {
    let (Some(chip), Some(core)) = (Peripherals::take(), CorePeripherals::take()) else {
        unreachable!("nobody took them")
    };
    let mut clocks = chip.RCC.freeze(rcc::Config::hse(25.MHz()).sysclk(100.MHz()));
    let mut delay = core.SYST.delay(&clocks.clocks);
    let mut clock = chip.TIM2.counter_us(&mut clocks);
    clock.start(u32::MAX.micros()).expect("the timer has 32 bits");

    // The pins: change them here.
    let port = chip.GPIOA.split(&mut clocks);
    let (bus_clock, data) = (port.pa5.into_alternate().speed(Speed::VeryHigh), port.pa7);
    let data = data.into_alternate().speed(Speed::VeryHigh);
    let select = port.pa4.into_push_pull_output_in_state(PinState::High);
    let data_or_command = port.pa3.into_push_pull_output();
    let reset = port.pa2.into_push_pull_output_in_state(PinState::High);

    // The display.
    let mode = Mode { polarity: Polarity::IdleLow, phase: Phase::CaptureOnFirstTransition };
    let bus_pins = (Some(bus_clock), SPI1::NoMiso, Some(data));
    let bus = Spi::new(chip.SPI1, bus_pins, mode, 50.MHz(), &mut clocks);
    let device = ExclusiveDevice::new_no_delay(bus, select).expect("the pin can be set");
    let mut batch = [0; 512];
    let interface = SpiInterface::new(device, data_or_command, &mut batch);
    let mut display = mipidsi::Builder::new(ILI9341Rgb565, interface)
        .orientation(Orientation::new().rotate(Rotation::Deg90).flip_horizontal())
        .color_order(ColorOrder::Bgr)
        .reset_pin(reset)
        .init(&mut delay)
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
        let start = clock.now().ticks();
        let turned = Mat4::rotation_y(((start / 1000 % 7200) as f32 / 20.0).degrees());
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
        let frame_time = clock.now().ticks().wrapping_sub(start).max(1);
        let _ = write!(text, "{} FPS", 1_000_000 / frame_time);
    }
}
