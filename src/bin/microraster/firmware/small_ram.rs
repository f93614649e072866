//! `--small-ram`: displays that are drawn on in so little RAM, each frame compared with the host's.

#[path = "../../../../examples/small_ram/display.rs"]
pub(super) mod display;

use super::board::{self, Board};
use super::build::House;
use super::figures::Figures;
use super::scenes::{hash, Model};
use super::{emulate, lines, sizes};
use display::{Display, Turntable, DISPLAYS, FRAMES};
use microraster::{Frame, FrameError, Rgb565};
use std::path::Path;

const EXAMPLE: &str = "small_ram";

/// A board for each display: Cortex-M0 with the display's RAM and no more.
const BOARDS: [Board; 3] = [
    // The machine itself has no more than this.
    of("microbit", &["__flash_length=256K", "__ram_length=16K"]),
    of("mps2-an385", &["__ram_length=32K"]),
    of("mps2-an385", &["__ram_length=64K"]),
];

const fn of(machine: &'static str, symbols: &'static [&'static str]) -> Board {
    Board { name: "m0", target: "thumbv6m-none-eabi", machine, symbols, counter: &[] }
}

/// Draws on all displays, prints a line for each, and puts the table into `file`.
///
/// # Errors
/// A build or a run failed, a frame differs from the host's, or the stack reaches the statics.
pub(crate) fn show(
    house: &House,
    bunny: Option<Model<'_>>,
    file: Option<&Path>,
) -> Result<(), String> {
    let mut figures = Figures::default();
    for (display, board) in DISPLAYS.iter().zip(&BOARDS) {
        let mesh = match bunny {
            Some(bunny) if display.bunny => {
                let normals = bytemuck::cast_slice(bunny.normals);
                display::fitted(bunny.positions, normals, bunny.indices)
            }
            None if display.bunny => continue,
            _ => display::teapot(),
        };
        figures.board(&format!(
            "{}, {}",
            display.name,
            if display.bunny { "bunny" } else { "teapot" }
        ));
        let cost = measure(house, board, display, &frames(display, mesh)?)?;
        println!("{cost}");
        cost.put(&mut figures);
    }
    file.map_or(Ok(()), |file| figures.write(file, "small RAM"))
}

/// Hashes of all frames as the host draws them, each at once.
pub(super) fn frames(display: &Display, mesh: display::Model<'_>) -> Result<Vec<u64>, String> {
    let size = display.size;
    let room = usize::from(size.width) * usize::from(size.height);
    let (mut pixels, mut depth) = (vec![0; room], vec![0; room]);
    let turntable = Turntable::new(mesh);
    let hashes = (0..FRAMES).map(|number| {
        let mut frame = Frame::<Rgb565>::new(&mut pixels, size)?.with_depth(&mut depth)?;
        if display.smooth {
            turntable.draw_smooth(&mut frame, number);
        } else {
            turntable.draw_flat(&mut frame, number);
        }
        Ok(hash::fnv1a(hash::START, bytemuck::cast_slice(&pixels)))
    });
    hashes.collect::<Result<_, FrameError>>().map_err(|why| why.to_string())
}

/// What a display takes.
#[derive(Clone, Copy, Debug)]
struct Cost<'a> {
    display: &'a Display,
    machine: &'a str,
    /// Statics beside colour and depth.
    statics: usize,
    stack: usize,
    flash: u32,
    /// Of a frame, clears included.
    instructions: u64,
}

/// Builds and runs.
fn measure<'a>(
    house: &House,
    board: &'a Board,
    display: &'a Display,
    expected: &[u64],
) -> Result<Cost<'a>, String> {
    let options: &[_] = if display.bunny { &["--cfg", "microraster_mesh"] } else { &[] };
    let linked = house.example_with(EXAMPLE, display.name, board, options)?;
    let elf = sizes::read(&linked, display.name, board)?;
    let folder = house.firmware()?;
    let run =
        |board: &Board| lines::Report::read(&emulate::run(board, &linked, &folder, &[], None)?);
    let report = run(board)?;
    // The same file where instructions are counted: flash and RAM begin at the same addresses.
    let counted = run(board::find(board.name)?)?;
    for report in [&report, &counted] {
        let hashes: Vec<_> = report.frames.iter().map(|frame| frame.hash).collect();
        if hashes != expected {
            let name = display.name;
            return Err(format!("{name}: the board drew {hashes:x?}, the host {expected:x?}"));
        }
    }
    let sum: u64 = counted.frames.iter().map(|frame| frame.instructions).sum();
    let statics = elf.ram() as usize;
    let free = display.ram.checked_sub(statics);
    match free.filter(|&free| report.stack < free) {
        Some(_) => Ok(Cost {
            display,
            machine: board.machine,
            statics: statics.saturating_sub(display.buffers()),
            stack: report.stack,
            flash: elf.flash(),
            instructions: sum / counted.frames.len().max(1) as u64,
        }),
        None => Err(format!(
            "{}: {statics} bytes of statics and {} of stack are more than the RAM",
            display.name, report.stack
        )),
    }
}

impl Cost<'_> {
    /// Bytes of RAM that nothing has touched.
    fn left(&self) -> usize {
        self.display.ram.saturating_sub(self.display.buffers() + self.statics + self.stack)
    }

    /// The rows of the table.
    fn put(&self, figures: &mut Figures) {
        let Display { size, rows, ram, smooth, .. } = self.display;
        for (what, figure) in [
            ("RAM of the memory map", *ram),
            ("colour and 16-bit depth", self.display.buffers()),
            ("stack, the deepest", self.stack),
            ("all other statics", self.statics),
            ("RAM left", self.left()),
            ("flash, with the model", self.flash as usize),
        ] {
            figures.put(what, figure.to_string());
        }
        figures.put("shading", if *smooth { "Gouraud" } else { "flat" }.into());
        figures.put("bands", format!("{} of {rows} rows", size.height.div_ceil(*rows)));
        figures.put("instructions a frame", format!("{:.2} M", self.instructions as f64 / 1e6));
        figures.put("frames equal to the host's", FRAMES.to_string());
        figures.put("machine", self.machine.into());
    }
}

impl std::fmt::Display for Cost<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { display, machine, statics, stack, flash, instructions } = self;
        let Display { name, ram, .. } = display;
        write!(
            f,
            "display={name} machine={machine} ram={ram} buffers={} stack={stack} statics={statics} \
             left={} flash={flash} instructions={instructions} frames={FRAMES} equal=yes",
            display.buffers(),
            self.left()
        )
    }
}
