//! A lit teapot turns on a NUCLEO-H743ZI with an ILI9341 of 320x240 pixels, without a display
//! driver: one task draws bands in the panel's order of bytes, another sends them by DMA meanwhile.
#![no_std]
#![no_main]

mod panel;

use core::fmt::Write;

use embassy_executor::Spawner;
use embassy_futures::yield_now;
use embassy_stm32::gpio::{Level, Output, Speed};
use embassy_stm32::rcc::{self, Pll, PllDiv, PllMul, PllPreDiv, PllSource, Sysclk};
use embassy_stm32::spi::{self, Spi};
use embassy_stm32::{bind_interrupts, dma, peripherals};
use embassy_sync::blocking_mutex::raw::NoopRawMutex;
use embassy_sync::zerocopy_channel::{Channel, Receiver, Sender};
use embassy_time::Instant;
use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{Camera, Cull, Frame, Gouraud, Less, Light, Pass, Rgb, Rgb565Be, Size};
use panel::Panel;
use panic_halt as _;
use static_cell::{ConstStaticCell, StaticCell};

/// The display, lying on its side.
const PICTURE: Size = Size::new(320, 240);
/// Rows that are drawn and sent at a time: 640 bytes of colour each, twice, and as many of depth.
const ROWS: u16 = 40;
const PIXELS: usize = PICTURE.width as usize * ROWS as usize;

/// Pixels on their way to the panel.
struct Band {
    first_row: u16,
    rows: u16,
    pixels: [u16; PIXELS],
}

impl Band {
    const EMPTY: Self = Self { first_row: 0, rows: 0, pixels: [0; PIXELS] };
}

static BANDS: ConstStaticCell<[Band; 2]> = ConstStaticCell::new([Band::EMPTY; 2]);
static CHANNEL: StaticCell<Channel<'static, NoopRawMutex, Band>> = StaticCell::new();
static DEPTH: ConstStaticCell<[u16; PIXELS]> = ConstStaticCell::new([0; PIXELS]);

bind_interrupts!(struct Interrupts {
    DMA1_STREAM0 => dma::InterruptHandler<peripherals::DMA1_CH0>;
});

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    if let Some(mut core) = cortex_m::Peripherals::take() {
        core.SCB.enable_icache();
    }
    // 400 MHz from the internal oscillator; SPI1 gets 100 MHz.
    let mut config = embassy_stm32::Config::default();
    config.rcc.pll1 = Some(Pll {
        source: PllSource::HSI,
        prediv: PllPreDiv::DIV4,
        mul: PllMul::MUL50,
        fracn: None,
        divp: Some(PllDiv::DIV2),
        divq: Some(PllDiv::DIV8),
        divr: None,
    });
    config.rcc.sys = Sysclk::PLL1_P;
    config.rcc.ahb_pre = rcc::AHBPrescaler::DIV2;
    config.rcc.apb1_pre = rcc::APBPrescaler::DIV2;
    config.rcc.apb2_pre = rcc::APBPrescaler::DIV2;
    config.rcc.apb3_pre = rcc::APBPrescaler::DIV2;
    config.rcc.apb4_pre = rcc::APBPrescaler::DIV2;
    config.rcc.voltage_scale = rcc::VoltageScale::Scale1;
    let chip = embassy_stm32::init(config);

    // The pins: change them here.
    let (clock, data) = (chip.PA5, chip.PB5);
    let select = Output::new(chip.PD14, Level::High, Speed::VeryHigh);
    let data_or_command = Output::new(chip.PD15, Level::Low, Speed::VeryHigh);
    let reset = Output::new(chip.PF12, Level::High, Speed::Low);

    let mut config = spi::Config::default();
    config.frequency = embassy_stm32::time::mhz(50);
    let bus = Spi::new_txonly(chip.SPI1, clock, data, chip.DMA1_CH0, Interrupts, config);
    let panel = Panel::start(bus, select, data_or_command, reset).await.expect("the bus works");

    let channel = CHANNEL.init(Channel::new(BANDS.take()));
    let (empty, full) = channel.split();
    spawner.spawn(send(panel, full).expect("it runs once"));
    draw(empty).await
}

/// Sends bands: while DMA does, the other task runs.
#[embassy_executor::task]
async fn send(mut panel: Panel, mut full: Receiver<'static, NoopRawMutex, Band>) -> ! {
    loop {
        let band = full.receive().await;
        let pixels = &band.pixels[..usize::from(PICTURE.width) * usize::from(band.rows)];
        let area = [0, band.first_row, PICTURE.width, band.first_row + band.rows];
        panel.send(area, bytemuck::cast_slice(pixels)).await.expect("the bus works");
        full.receive_done();
    }
}

/// Draws pictures, band by band, into what is empty.
async fn draw(mut empty: Sender<'static, NoopRawMutex, Band>) -> ! {
    let depth = DEPTH.take();
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 3.0, 7.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let shader = Gouraud::lit(&[sun]);
    let white = MonoTextStyle::new(&FONT_10X20, Rgb565::WHITE);

    let mut text = heapless::String::<16>::new();
    loop {
        let start = Instant::now();
        let turned = Mat4::rotation_y(((start.as_millis() % 7200) as f32 / 20.0).degrees());
        for first_row in (0..PICTURE.height).step_by(ROWS.into()) {
            let band = empty.send().await;
            band.first_row = first_row;
            band.rows = ROWS.min(PICTURE.height - first_row);
            let size = Size::new(PICTURE.width, band.rows);
            let mut frame = Frame::<Rgb565Be>::new(&mut band.pixels, size)
                .and_then(|frame| frame.with_depth(depth)?.band(first_row, PICTURE.height))
                .expect("the buffers hold a band");
            frame.clear(Rgb::new(16, 24, 48));
            Pass::new(&camera)
                .cull(Cull::Back)
                .depth(Less)
                .draw(&mut frame, &turned, &TEAPOT, &shader);
            let Ok(_) = Text::new(&text, Point::new(8, 20), white).draw(&mut frame);
            empty.send_done();
            // The next band goes out as soon as the one before has.
            yield_now().await;
        }
        text.clear();
        let _ = write!(text, "{} FPS", 1_000_000 / start.elapsed().as_micros().max(1));
    }
}
