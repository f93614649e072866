//! An ILI9341 as a place that bytes are sent to.

use embassy_stm32::gpio::Output;
use embassy_stm32::mode::Async;
use embassy_stm32::spi::{mode::Master, Error, Spi};
use embassy_time::Timer;

/// Commands of the panel, with what follows them before the first picture.
const SLEEP_OUT: u8 = 0x11;
const DISPLAY_ON: u8 = 0x29;
const COLUMNS: u8 = 0x2A;
const ROWS: u8 = 0x2B;
const PIXELS: u8 = 0x2C;
/// On its side, blue before red in the panel's glass.
const ORIENTATION: (u8, &[u8]) = (0x36, &[0xE8]);
/// Sixteen bits a pixel.
const FORMAT: (u8, &[u8]) = (0x3A, &[0x55]);

/// The panel on its bus.
pub struct Panel {
    bus: Spi<'static, Async, Master>,
    select: Output<'static>,
    data_or_command: Output<'static>,
    /// Stays high.
    _reset: Output<'static>,
}

impl Panel {
    /// Resets the panel and turns it on.
    pub async fn start(
        bus: Spi<'static, Async, Master>,
        select: Output<'static>,
        data_or_command: Output<'static>,
        mut reset: Output<'static>,
    ) -> Result<Self, Error> {
        reset.set_low();
        Timer::after_millis(10).await;
        reset.set_high();
        Timer::after_millis(120).await;
        let mut panel = Self { bus, select, data_or_command, _reset: reset };
        panel.command(SLEEP_OUT, &[])?;
        Timer::after_millis(120).await;
        for (command, data) in [ORIENTATION, FORMAT, (DISPLAY_ON, &[])] {
            panel.command(command, data)?;
        }
        Ok(panel)
    }

    /// Sends pixels, high byte first, for the area of these columns and rows: left, top, and
    /// right and bottom behind the last.
    pub async fn send(
        &mut self,
        [left, top, right, bottom]: [u16; 4],
        pixels: &[u8],
    ) -> Result<(), Error> {
        for (command, first, behind) in [(COLUMNS, left, right), (ROWS, top, bottom)] {
            let ([a, b], [c, d]) = (first.to_be_bytes(), (behind - 1).to_be_bytes());
            self.command(command, &[a, b, c, d])?;
        }
        self.select.set_low();
        self.data_or_command.set_low();
        let mut sent = self.bus.blocking_write(&[PIXELS]);
        if sent.is_ok() {
            self.data_or_command.set_high();
            sent = self.bus.write(pixels).await;
        }
        self.select.set_high();
        sent
    }

    /// Sends a command and its data, and waits: it is over in a microsecond. Were it awaited, the
    /// other task would draw a whole band before the next byte.
    fn command(&mut self, command: u8, data: &[u8]) -> Result<(), Error> {
        self.select.set_low();
        self.data_or_command.set_low();
        let mut sent = self.bus.blocking_write(&[command]);
        if sent.is_ok() && !data.is_empty() {
            self.data_or_command.set_high();
            sent = self.bus.blocking_write(data);
        }
        self.select.set_high();
        sent
    }
}
