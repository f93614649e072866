//! Two bands in flight: one is drawn while a simulated DMA sends the other, against waiting for each.
//!
//! `cargo firmware --dma` runs it under QEMU, compares what the display shows with the host's
//! pictures and says what overlapping gains.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
#[allow(dead_code, reason = "this reads no files")]
mod board;
#[cfg(target_os = "none")]
#[path = "../small_ram/display.rs"]
#[allow(dead_code, reason = "one display and one shading of several")]
mod display;
#[cfg(target_os = "none")]
#[path = "../scenes/hash.rs"]
#[allow(dead_code, reason = "the hash of bytes, not of a scene's picture")]
mod hash;
#[cfg(target_os = "none")]
mod simulated;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This runs on boards: `cargo firmware --dma` runs it under QEMU.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::board::buffer::Buffer;
    use crate::board::meter::Instant;
    use crate::board::{say, semihost, stack};
    use crate::display::{teapot, Display, Turntable, DISPLAYS, FRAMES};
    use crate::hash;
    use crate::simulated::SimulatedDma;
    use microraster::{Bands, DepthBuffer, FrameError, Rgb565};

    const DISPLAY: Display = DISPLAYS[1];
    const PIXELS: usize = DISPLAY.size.width as usize * DISPLAY.size.height as usize;
    /// Cycles of the core that sending a pixel takes: 16 bits at 62.5 Mbit/s, at 125 MHz.
    const CYCLES_PER_PIXEL: u64 = 16 * 125_000_000 / 62_500_000;

    /// Two buffers of pixels for one of depth, which stays with the core.
    static FIRST: Buffer<[u16; DISPLAY.band()]> = Buffer::new([0; DISPLAY.band()]);
    static SECOND: Buffer<[u16; DISPLAY.band()]> = Buffer::new([0; DISPLAY.band()]);
    static DEPTH: Buffer<[u16; DISPLAY.band()]> = Buffer::new([0; DISPLAY.band()]);
    static PANEL: Buffer<[u16; PIXELS]> = Buffer::new([0; PIXELS]);

    /// Why a picture is not complete.
    enum Failure {
        /// A buffer is too short for a band.
        TooShort,
        /// A buffer did not come back.
        Lost,
    }

    impl From<FrameError> for Failure {
        fn from(_: FrameError) -> Self {
            Self::TooShort
        }
    }

    /// How bands are sent.
    #[derive(Clone, Copy)]
    enum Way {
        /// In no time, to see what drawing takes alone.
        AtOnce,
        /// Each is waited for.
        Blocking,
        /// One is drawn while the other is sent.
        Overlapped,
    }

    /// What draws and sends.
    struct Stage {
        bands: Bands<'static, Rgb565, DepthBuffer<'static>>,
        /// The buffer that nobody has.
        spare: Option<&'static mut [u16]>,
        dma: SimulatedDma<'static>,
        turntable: Turntable<'static>,
    }

    impl Stage {
        fn take() -> Option<Self> {
            let bands = Bands::new(FIRST.take()?, DISPLAY.size).ok()?;
            Some(Self {
                bands: bands.with_depth(DEPTH.take()?).ok()?,
                spare: Some(SECOND.take()?),
                dma: SimulatedDma::new(PANEL.take()?),
                turntable: Turntable::new(teapot()),
            })
        }

        /// Draws and sends a frame.
        fn frame(&mut self, number: u16, way: Way) -> Result<(), Failure> {
            let Self { bands, spare, dma, turntable } = self;
            bands.draw_double_buffered(
                |frame| turntable.draw_smooth(frame, number),
                |band| {
                    let empty = match way {
                        Way::AtOnce => {
                            dma.start(band, 0);
                            dma.finish()
                        }
                        Way::Blocking => {
                            dma.start(band, CYCLES_PER_PIXEL);
                            dma.finish()
                        }
                        Way::Overlapped => {
                            let empty = dma.finish().or_else(|| spare.take());
                            dma.start(band, CYCLES_PER_PIXEL);
                            empty
                        }
                    };
                    empty.ok_or(Failure::Lost)
                },
            )?;
            // The last band is still on its way.
            if let Some(buffer) = dma.finish() {
                *spare = Some(buffer);
            }
            Ok(())
        }

        /// Draws a turn and prints a line for each frame.
        fn turn(&mut self, name: &str, way: Way) -> Result<(), Failure> {
            for number in 0..FRAMES {
                let (began, before) = (Instant::now(), self.dma.simulating());
                self.frame(number, way)?;
                let instructions = self.dma.elapsed(began, before);
                let shown: &[u8] = bytemuck::cast_slice(self.dma.panel());
                say!(
                    "scene={name} frame={number} instructions={instructions} hash={:016x} bytes={}",
                    hash::fnv1a(hash::START, shown),
                    shown.len()
                );
            }
            Ok(())
        }
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        let mark = stack::paint();
        let drawn = Stage::take().ok_or(Failure::TooShort).and_then(|mut stage| {
            stage.turn("at-once", Way::AtOnce)?;
            stage.turn("blocking", Way::Blocking)?;
            stage.turn("overlapped", Way::Overlapped)
        });
        match drawn {
            Ok(()) => say!("stack={}", stack::deepest(mark)),
            Err(Failure::TooShort) => say!("error: a buffer is too short for a band"),
            Err(Failure::Lost) => say!("error: a buffer did not come back"),
        }
        semihost::exit(u32::from(drawn.is_err()))
    }
}
