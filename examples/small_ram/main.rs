//! A turning model on a display, in so little RAM: 16 KB for everything at 128x64.
//!
//! `cargo firmware --small-ram` links it once for each display, with a memory map of the RAM that
//! there is, runs it under QEMU and compares every frame with the host's.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
#[allow(dead_code, reason = "this reads no files")]
mod board;
#[cfg(target_os = "none")]
#[allow(dead_code, reason = "the host asks for more of it")]
mod display;
#[cfg(target_os = "none")]
#[path = "../board/feature.rs"]
mod feature;
#[cfg(target_os = "none")]
#[path = "../scenes/hash.rs"]
#[allow(dead_code, reason = "the hash of bands, not of whole pictures")]
mod hash;
#[cfg(all(target_os = "none", microraster_mesh))]
#[path = "../scenes/model.rs"]
mod model;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This runs on boards: `cargo firmware --small-ram` runs it under QEMU.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::board::buffer::Buffer;
    use crate::board::{meter, say, semihost, stack};
    use crate::display::{Display, Model, Turntable, DISPLAYS, FRAMES};
    use crate::{display, feature, hash};
    use microraster::{Bands, Rgb565};

    /// The display that this is built for.
    const DISPLAY: Display = {
        let [small, large, square] = DISPLAYS;
        if feature::is(large.name) {
            large
        } else if feature::is(square.name) {
            square
        } else {
            small
        }
    };

    static PIXELS: Buffer<[u16; DISPLAY.band()]> = Buffer::new([0; DISPLAY.band()]);
    static DEPTH: Buffer<[u16; DISPLAY.band()]> = Buffer::new([0; DISPLAY.band()]);

    /// A mesh file in flash.
    #[cfg(microraster_mesh)]
    mod mesh {
        /// Aligned for what it holds.
        #[repr(C, align(4))]
        pub(super) struct File<T: ?Sized>(pub(super) T);

        pub(super) static MESH: &File<[u8]> = &File(*include_bytes!(env!("MICRORASTER_MESH")));
    }

    /// The model, which lies in flash; `None` where this was built without it.
    fn model() -> Option<Model<'static>> {
        #[cfg(microraster_mesh)]
        if DISPLAY.bunny {
            let file = crate::model::Model::view(&mesh::MESH.0)?;
            return Some(display::fitted(file.positions, file.normals, file.indices));
        }
        (!DISPLAY.bunny).then(display::teapot)
    }

    /// Draws a turn and prints a line for each frame; `None` where something is missing.
    fn show() -> Option<()> {
        stack::paint();
        let empty = meter::instructions(|| ()).0;
        let turntable = Turntable::new(model()?);
        let bands = Bands::<Rgb565>::new(PIXELS.take()?, DISPLAY.size).ok()?;
        let mut bands = bands.with_depth(DEPTH.take()?).ok()?;
        for number in 0..FRAMES {
            let (mut sum, mut state, mut bytes) = (0, hash::START, 0);
            for band in 0..bands.count() {
                let (instructions, drawn) = meter::instructions(|| {
                    let target = &mut bands;
                    target
                        .draw_band(band, |frame| {
                            if const { DISPLAY.smooth } {
                                turntable.draw_smooth(frame, number);
                            } else {
                                turntable.draw_flat(frame, number);
                            }
                        })
                        .map(|band| band.size())
                });
                drawn?;
                sum += instructions.saturating_sub(empty);
                // Lent out again: what is printed is not measured.
                let sent = bands.draw_band(band, |_| {})?;
                let sent = sent.as_bytes();
                state = hash::fnv1a(state, sent);
                bytes += sent.len();
            }
            say!(
                "scene={} frame={number} instructions={sum} hash={state:016x} bytes={bytes}",
                DISPLAY.name
            );
        }
        say!("stack={}", stack::deepest_of_all());
        Some(())
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        let done = show();
        if done.is_none() {
            say!("error: this was built without the model, or a buffer is too small");
        }
        semihost::exit(u32::from(done.is_none()))
    }
}
