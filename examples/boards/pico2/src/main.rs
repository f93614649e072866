//! Both cores of a Raspberry Pi Pico 2 draw and send bands of one picture: a teapot that core 0
//! recorded. As RISC-V, where the hardware's crate starts no second core, core 0 does it alone.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::sync::atomic::{AtomicU16, Ordering};

use embedded_graphics::mono_font::{ascii::FONT_10X20, MonoTextStyle};
use embedded_graphics::pixelcolor::{self, RgbColor};
use embedded_graphics::prelude::*;
use embedded_graphics::text::Text;
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use hal::fugit::RateExtU32;
use hal::gpio::bank0::{Gpio17, Gpio18, Gpio19, Gpio20, Gpio21};
use hal::gpio::{FunctionSio, FunctionSpi, Pin, PullDown, SioOutput};
use hal::pac::SPI0;
use hal::Clock;
use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::{
    Camera, Corner, Cull, DirectionalLight, DisplayList, Frame, Gouraud, Lambert, Less, Light,
    ListTriangle, ListVertex, Pass, Recording, Rgb, Rgb565, Size, SmoothColor, VertexCache,
};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;
use panic_halt as _;
use rp235x_hal as hal;
use spin::{Mutex, RwLock};
use static_cell::{ConstStaticCell, StaticCell};

/// The display.
const PICTURE: Size = Size::new(240, 240);
/// Rows that a core draws and sends at a time: 480 bytes of colour each, and as many of depth.
const ROWS: u16 = 40;
const PIXELS: usize = PICTURE.width as usize * ROWS as usize;
const BANDS: u16 = PICTURE.height.div_ceil(ROWS);

// The pins: change them here and in `main`.
type Data = Pin<Gpio19, FunctionSpi, PullDown>;
type Clocking = Pin<Gpio18, FunctionSpi, PullDown>;
type Output<Number> = Pin<Number, FunctionSio<SioOutput>, PullDown>;
type Bus = hal::Spi<hal::spi::Enabled, SPI0, (Data, Clocking)>;
type Device = ExclusiveDevice<Bus, Output<Gpio17>, NoDelay>;
type Panel =
    mipidsi::Display<SpiInterface<'static, Device, Output<Gpio20>>, ST7789, Output<Gpio21>>;

type Shader = Gouraud<Lambert<1, DirectionalLight>>;

/// What both cores draw: core 0 changes it between pictures.
struct Scene {
    teapot: Recording<'static, Shader>,
    text: heapless::String<16>,
}

/// What a core draws into.
struct Buffers {
    color: [u16; PIXELS],
    depth: [u16; PIXELS],
}

static SCENE: RwLock<Option<Scene>> = RwLock::new(None);
/// The first band that no core has taken.
static NEXT: AtomicU16 = AtomicU16::new(BANDS);
static DISPLAY: StaticCell<Mutex<Panel>> = StaticCell::new();
static BATCH: ConstStaticCell<[u8; 512]> = ConstStaticCell::new([0; 512]);
static BUFFERS: [ConstStaticCell<Buffers>; 2] =
    [const { ConstStaticCell::new(Buffers { color: [0; PIXELS], depth: [0; PIXELS] }) }; 2];
static SHADER: StaticCell<Shader> = StaticCell::new();
static VERTICES: StaticCell<[ListVertex<Corner<SmoothColor>>; 400]> = StaticCell::new();
static TRIANGLES: ConstStaticCell<[ListTriangle; 512]> =
    ConstStaticCell::new([ListTriangle::BLANK; 512]);
#[cfg(target_arch = "arm")]
static STACK: hal::multicore::Stack<2048> = hal::multicore::Stack::new();

/// Tells the boot ROM that this is a program, and for which kind of core.
#[link_section = ".start_block"]
#[used]
#[allow(unsafe_code, reason = "a section is named")]
static IMAGE: hal::block::ImageDef = hal::block::ImageDef::secure_exe();

#[hal::entry]
fn main() -> ! {
    let mut chip = hal::pac::Peripherals::take().expect("nobody took them");
    let mut watchdog = hal::Watchdog::new(chip.WATCHDOG);
    let clocks = hal::clocks::init_clocks_and_plls(
        12_000_000,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut watchdog,
    )
    .expect("the crystal has 12 MHz");
    let mut timer = hal::Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);
    #[allow(unused_mut, reason = "for core 1")]
    let mut sio = hal::Sio::new(chip.SIO);
    let pins =
        hal::gpio::Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);

    // The display.
    let bus = hal::Spi::new(chip.SPI0, (pins.gpio19.reconfigure(), pins.gpio18.reconfigure()))
        .init(
            &mut chip.RESETS,
            clocks.peripheral_clock.freq(),
            75.MHz(),
            embedded_hal::spi::MODE_3,
        );
    let mut backlight = pins.gpio22.into_push_pull_output();
    let _ = backlight.set_high();
    let device = ExclusiveDevice::new_no_delay(bus, pins.gpio17.reconfigure()).expect("a pin");
    let interface = SpiInterface::new(device, pins.gpio20.reconfigure(), BATCH.take());
    let display: Panel = mipidsi::Builder::new(ST7789, interface)
        .display_size(PICTURE.width, PICTURE.height)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(pins.gpio21.reconfigure())
        .init(&mut timer)
        .expect("the display is there");
    let display = &*DISPLAY.init(Mutex::new(display));

    // Core 1 takes bands for good, core 0 between recordings.
    let [mine, others] = &BUFFERS;
    let mine = mine.take();
    #[cfg(target_arch = "arm")]
    {
        let others = others.take();
        let mut cores = hal::multicore::Multicore::new(&mut chip.PSM, &mut chip.PPB, &mut sio.fifo);
        cores.cores()[1]
            .spawn(STACK.take().expect("nobody took it"), move || loop {
                draw_bands(others, display);
            })
            .expect("core 1 starts");
    }
    #[cfg(not(target_arch = "arm"))]
    let _ = others;

    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    let shader = &*SHADER.init(Gouraud::lit(&[sun]));
    let mut list = DisplayList::new(
        VERTICES.init_with(|| [ListVertex::default(); 400]),
        TRIANGLES.take(),
        &mut [],
    );
    let mut cache = VertexCache::<u16, 512>::new();
    let mut text = heapless::String::new();
    loop {
        let start = timer.get_counter().ticks();
        let turned = Mat4::rotation_y(((start / 1000 % 7200) as f32 / 20.0).degrees());
        let teapot = Pass::new(&camera())
            .cull(Cull::Back)
            .record(list, PICTURE, &turned, &TEAPOT, shader, &mut cache);
        *SCENE.write() = Some(Scene { teapot, text });
        NEXT.store(0, Ordering::Release);
        draw_bands(mine, display);

        // Waits until core 1 has drawn its last band; it sends that meanwhile.
        let scene = SCENE.write().take().expect("only this core takes it");
        list = scene.teapot.into_list();
        text = heapless::String::new();
        let frame_time = timer.get_counter().ticks() - start;
        let _ = write!(text, "{} FPS", 1_000_000 / frame_time.max(1));
    }
}

fn camera() -> Camera {
    Camera::perspective(45.0.degrees(), 0.5).look_at(Vec3::new(0.0, 3.8, 8.8), Vec3::ZERO, Vec3::Y)
}

/// Draws and sends bands until all are taken.
fn draw_bands(buffers: &mut Buffers, display: &Mutex<Panel>) {
    let camera = camera();
    while NEXT.load(Ordering::Acquire) < BANDS {
        let scene = SCENE.read();
        // Taken under the lock: it belongs to this scene.
        let number = NEXT.fetch_add(1, Ordering::AcqRel);
        let (Some(Scene { teapot, text }), true) = (scene.as_ref(), number < BANDS) else { return };
        let first_row = number * ROWS;
        let size = Size::new(PICTURE.width, ROWS.min(PICTURE.height - first_row));
        let mut frame = Frame::<Rgb565>::new(&mut buffers.color, size)
            .and_then(|frame| frame.with_depth(&mut buffers.depth)?.band(first_row, PICTURE.height))
            .expect("the buffers hold a band");
        frame.clear(Rgb::new(16, 24, 48));
        Pass::new(&camera)
            .depth(Less)
            .replay_shared(&mut frame, teapot)
            .expect("a list that holds what is seen of a teapot, in this picture");
        let white = MonoTextStyle::new(&FONT_10X20, pixelcolor::Rgb565::WHITE);
        let Ok(_) = Text::new(text, Point::new(8, 20), white).draw(&mut frame);
        drop(scene);

        // While one core sends, the other draws.
        frame.draw(&mut *display.lock()).expect("the display takes pixels");
    }
}
