//! `microraster firmware`: draws the scenes on boards under QEMU and compares every frame with
//! the host's, bit for bit.

mod asm;
pub(crate) mod board;
pub(crate) mod build;
mod bunny;
mod callgrind;
mod cycles;
mod dma;
pub(crate) mod elf;
pub(crate) mod emulate;
mod facts;
mod figures;
mod ladder;
pub(crate) mod lines;
mod loops;
mod marks;
mod matrix;
pub(crate) mod mesh_file;
mod no_panic;
mod per;
mod performance;
mod profile;
mod record;
#[path = "../../../../examples/scenes/mod.rs"]
pub(crate) mod scenes;
pub(crate) mod sizes;
mod small_ram;

use board::Board;
use build::House;
use elf::Elf;
use facts::{Counter, Frame, Line};
use figures::Figures;
use per::Per;
use record::Record;
use scenes::{Model, Scene};
use std::path::{Path, PathBuf};

/// Targets for which the bare library is built by `--library`.
const LIBRARY_TARGETS: [&str; 4] = [
    "thumbv6m-none-eabi",
    "thumbv7em-none-eabihf",
    "riscv32imc-unknown-none-elf",
    "wasm32-unknown-unknown",
];

/// What the help says under the options.
const HELP: &str = "\
Each scene becomes one line; instructions, pixels and triangles are the means of its frames, and
the hash of several frames is that of their hashes. Then one line a board: flash and RAM of the
whole firmware with its 320x240 buffers, and the deepest stack of what was measured, in bytes.

MICRORASTER_MODELS names a folder with obj/bunny-npm/bunny.obj; without it the scenes that need
it are skipped, or fail when MICRORASTER_REQUIRE_SHARED is set.";

/// What to draw, where, and what to print of it.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(crate) struct Arguments {
    /// Boards, of m0, m3, m4, m7, m33, m55, rv32 and wasm32; m4 and m0 by default.
    #[arg(long, value_delimiter = ',', value_name = "BOARD")]
    boards: Vec<String>,
    /// Scenes by name, or the lists `bands`, `gallery`, `golden`, `standard` and `all`, which is the
    /// default.
    #[arg(long, value_delimiter = ',', value_name = "SCENE")]
    scenes: Vec<String>,
    /// Compare the golden and gallery scenes on all boards, or on --boards, and print a table. The
    /// firmware is built sooner than what is measured, with other optimisations.
    #[arg(long, conflicts_with_all = ["figures", "performance", "gate", "asm", "profile", "sizes",
        "example", "ladder", "no_panic", "library"])]
    matrix: bool,
    /// Draw only the first frames of each scene.
    #[arg(long, value_name = "N")]
    frames: Option<u32>,
    /// Memory by section; with --sizes, every symbol.
    #[arg(short, long)]
    verbose: bool,
    /// Put what scenes, --features or --ladder measure into the tables of a Markdown file.
    #[arg(long, value_name = "FILE")]
    figures: Option<PathBuf>,
    /// Draw the measured scenes on five boards and on the host, and write docs/PERFORMANCE.md, the
    /// README's table and the record docs/performance.csv. Takes some minutes.
    #[arg(long, conflicts_with_all = ["boards", "scenes", "frames", "profile", "asm", "sizes",
        "ladder", "no_panic", "library", "figures"])]
    performance: bool,
    /// Fail where a figure has risen by more than 2 % over those of a record.
    #[arg(long, value_name = "RECORD", conflicts_with_all = ["frames", "profile", "asm", "sizes",
        "ladder", "no_panic", "library"])]
    gate: Option<PathBuf>,
    /// Print the hot loops of one scene: each instruction, and how often it was executed.
    #[arg(long, value_name = "SCENE", conflicts_with_all = ["scenes", "sizes", "library",
        "profile"])]
    asm: Option<String>,
    /// Draw one scene on the host and nothing else: what callgrind counts.
    #[arg(long, hide = true, value_name = "SCENE")]
    on_host: Option<String>,
    /// Print where the instructions of one scene go, by function and by address.
    #[arg(long, value_name = "SCENE", conflicts_with_all = ["scenes", "sizes", "library"])]
    profile: Option<String>,
    /// Rows of each of the profile's tables.
    #[arg(long, value_name = "N", default_value_t = 60, requires = "profile")]
    rows: u32,
    /// Weigh the size proofs instead: flash by kind of code.
    #[arg(long, conflicts_with_all = ["scenes", "library"])]
    sizes: bool,
    /// With --sizes, weigh each feature alone, as flash more than flat triangles.
    #[arg(long, requires = "sizes")]
    features: bool,
    /// Run every case of another example that draws cases, and print its lines as they are.
    #[arg(long, value_name = "EXAMPLE", conflicts_with_all = ["scenes", "profile", "figures", "sizes", "ladder", "no_panic", "library"])]
    example: Option<String>,
    /// Weigh and run a ladder of scenes instead, each with one feature more than the one before;
    /// with --figures, put a table for each board into a Markdown file.
    #[arg(long, conflicts_with_all = ["scenes", "sizes", "library", "profile", "no_panic", "asm"])]
    ladder: bool,
    /// Look for a way to panic in firmware that draws with everything, instead.
    #[arg(long, conflicts_with_all = ["scenes", "sizes", "library", "profile", "figures", "asm"])]
    no_panic: bool,
    /// Draw a turning model in 16, 32 and 64 KB of RAM for everything, each linked with a memory map
    /// of that, and compare every frame; with --figures, put the table into a Markdown file.
    #[arg(long, conflicts_with_all = ["boards", "scenes", "frames", "matrix", "gate", "asm",
        "profile", "sizes", "example", "ladder", "no_panic", "library"])]
    small_ram: bool,
    /// Draw each band while a simulated DMA sends the one before, and say what that gains over
    /// waiting; with --figures, put the table into a Markdown file.
    #[arg(long, conflicts_with_all = ["scenes", "frames", "matrix", "gate", "asm", "profile",
        "sizes", "example", "ladder", "no_panic", "library", "small_ram"])]
    dma: bool,
    /// Build the bare library, without alloc, for Armv6-M, Armv7E-M, RISC-V and wasm instead.
    #[arg(long, conflicts_with_all = ["scenes", "boards"])]
    library: bool,
}

/// Does what was asked.
///
/// # Errors
/// What is missing, what failed, or that a board drew another picture than the host.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let house = House::find()?;
    if let Some(scene) = &arguments.on_host {
        let words = bunny::find(&house.package).and_then(|file| bunny::convert(&file)).ok();
        return callgrind::draw(scene, words.as_deref().and_then(view));
    }
    let names = match arguments.boards.as_slice() {
        [] if arguments.performance => performance::boards(),
        [] if arguments.matrix => board::BOARDS.iter().map(|board| board.name.to_owned()).collect(),
        [] => ["m4", "m0"].map(str::to_owned).to_vec(),
        boards => boards.to_vec(),
    };
    let boards: Vec<_> = names.iter().map(|name| board::find(name)).collect::<Result<_, _>>()?;
    if arguments.library {
        return LIBRARY_TARGETS.iter().try_for_each(|target| {
            house.library(target)?;
            println!("target={target} library=built");
            Ok(())
        });
    }
    if arguments.no_panic {
        return no_panic::check(&house, &boards);
    }
    if arguments.ladder {
        return boards
            .iter()
            .try_for_each(|board| ladder::climb(&house, board, arguments.figures.as_deref()));
    }
    if arguments.features {
        let mut figures = Figures::default();
        for board in boards {
            sizes::features(&house, board, &mut figures)?;
        }
        return arguments.figures.as_ref().map_or(Ok(()), |file| figures.write(file, ""));
    }
    if arguments.sizes {
        return sizes::print(&house, &boards, arguments.verbose);
    }

    if let Some(example) = &arguments.example {
        return boards.iter().try_for_each(|board| lines_of(&house, board, example));
    }

    if arguments.dma {
        return dma::show(&house, &boards, arguments.figures.as_deref());
    }
    if arguments.small_ram {
        let words = mesh(&house, &mut Vec::new())?;
        let bunny = words.as_deref().and_then(view);
        return small_ram::show(&house, bunny, arguments.figures.as_deref());
    }
    let names = match arguments.profile.as_ref().or(arguments.asm.as_ref()) {
        Some(scene) => vec![scene.clone()],
        None if arguments.performance => vec!["standard".to_owned()],
        None if !arguments.scenes.is_empty() => arguments.scenes.clone(),
        None if arguments.matrix => ["golden", "gallery"].map(str::to_owned).to_vec(),
        None => vec!["all".to_owned()],
    };
    let mut scenes = facts::asked(&names)?;
    let asked = scenes.len();
    let mesh = mesh(&house, &mut scenes)?;
    if arguments.performance && scenes.len() < asked {
        return Err("the tables and the record need all measured scenes".into());
    }
    let bunny = mesh.as_deref().and_then(view);
    let limit = arguments.frames.unwrap_or(u32::MAX);
    let mut words: Vec<_> = scenes.iter().map(|scene| scene.name.to_string()).collect();
    words.push(format!("frames={limit}"));
    if arguments.profile.is_some() {
        return boards
            .iter()
            .try_for_each(|board| profile::print(&house, board, &words, arguments.rows));
    }
    if arguments.asm.is_some() {
        return boards.iter().try_for_each(|board| asm::print(&house, board, &words));
    }

    let expected: Vec<_> = scenes.iter().map(|scene| facts::draw(scene, bunny, limit)).collect();
    if arguments.matrix {
        return matrix::compare(house, &boards, &scenes, &expected, &words);
    }
    let (mut all, mut record) = (Vec::new(), Record::default());
    let mut figures = Figures::default();
    for board in &boards {
        let lines = compare(&house, board, &scenes, &expected, &words, arguments.verbose)?;
        // What is not measured has no figure to keep.
        let is_measured = |scene: &Scene<Counter>| scene.group == scenes::Group::Standard;
        let measured = scenes.iter().zip(&lines).filter(|(scene, _)| is_measured(scene));
        record.add(measured.map(|(_, line)| line), &build::compiler(board.target)?);
        if arguments.figures.is_some() {
            figures.board(board.name);
            for line in &lines {
                let per = Per::of(line.scene());
                let figure = line.instructions() as f64 / per.count(line) as f64;
                figures.put(&format!("{}, instructions a {per}", line.scene()), per.text(figure));
            }
        }
        all.extend(lines);
    }
    match all.iter().filter(|line| line.differs.is_some()).count() {
        0 => {}
        wrong => return Err(matrix::different(wrong)),
    }
    if let Some(file) = &arguments.figures {
        figures.write(file, "")?;
    }
    if arguments.performance {
        performance::write(&house, &boards, &all, &record)?;
    }
    arguments.gate.as_ref().map_or(Ok(()), |file| record::gate(&record, file))
}

/// The mesh in the words of its file.
fn view(words: &[u32]) -> Option<Model<'_>> {
    Model::view(bytemuck::cast_slice(words))
}

/// Writes the bunny's mesh file for the firmware and gives its words. Where there is no bunny,
/// the scenes that need it are taken out, loudly.
fn mesh(house: &House, scenes: &mut Vec<Scene<Counter>>) -> Result<Option<Vec<u32>>, String> {
    let file = house.firmware()?.join(build::MESH_FILE);
    let why = match bunny::find(&house.package) {
        Ok(model) => {
            let words = bunny::convert(&model)?;
            mesh_file::write(&file, &words)?;
            return Ok(Some(words));
        }
        Err(why) => why,
    };
    // A mesh that an earlier run left would be drawn by the board alone.
    if file.exists() {
        std::fs::remove_file(&file).map_err(|why| format!("{}: {why}", file.display()))?;
    }
    let before = scenes.len();
    for scene in scenes.iter().filter(|scene| scene.bunny) {
        println!("scene={} skipped: {why}", scene.name);
    }
    scenes.retain(|scene| !scene.bunny);
    if scenes.len() < before && std::env::var_os("MICRORASTER_REQUIRE_SHARED").is_some() {
        return Err("scenes were skipped, and MICRORASTER_REQUIRE_SHARED forbids that".into());
    }
    Ok(None)
}

/// Prints the lines of an example's cases on a board, each with the board's name before it.
fn lines_of(house: &House, board: &Board, example: &str) -> Result<(), String> {
    mesh(house, &mut Vec::new())?;
    let file = house.example(example, board)?;
    println!("board={} compiler={}", board.name, build::compiler(board.target)?.replace(' ', "-"));
    let words = ["all".to_string()];
    let printed = emulate::run(board, &file, &house.firmware()?, &words, None)?;
    for line in printed.lines().filter(|line| !line.is_empty()) {
        println!("board={} {line}", board.name);
    }
    Ok(())
}

/// Reads firmware, which must not link a heap; `None` for WebAssembly, which says nothing of flash
/// and RAM.
fn checked(board: &Board, file: &Path) -> Result<Option<Elf>, String> {
    let bytes = std::fs::read(file).map_err(|why| format!("{}: {why}", file.display()))?;
    let heap = |name: &str| format!("the firmware of {} links a heap: {name}", board.name);
    if board.emulator() == board::Emulator::Node {
        let has = |name: &str| bytes.windows(name.len()).any(|part| part == name.as_bytes());
        let found = elf::ALLOCATORS.into_iter().find(|name| has(name));
        return found.map_or(Ok(None), |name| Err(heap(name)));
    }
    let elf = Elf::read(&bytes).map_err(|why| format!("{}: {why}", file.display()))?;
    elf.allocator().map_or(Ok(()), |name| Err(heap(name)))?;
    Ok(Some(elf))
}

/// Runs the scenes on a board and prints its lines.
fn compare(
    house: &House,
    board: &'static Board,
    scenes: &[Scene<Counter>],
    expected: &[Vec<Frame>],
    words: &[String],
    verbose: bool,
) -> Result<Vec<Line>, String> {
    let file = house.example("firmware", board)?;
    let elf = checked(board, &file)?;
    let printed = emulate::run(board, &file, &house.firmware()?, words, None)?;
    let report = lines::Report::read(&printed)?;

    let mut lines = Vec::new();
    for (scene, expected) in scenes.iter().zip(expected) {
        let line = Line::of(board.name, scene.name, &report, expected);
        println!("{line}");
        if let Some(how) = &line.differs {
            eprintln!("board={} scene={} {how}", board.name, scene.name);
        }
        lines.push(line);
    }
    let Some(elf) = elf else {
        println!("board={} stack={}", board.name, report.stack);
        return Ok(lines);
    };
    println!("board={} flash={} ram={} stack={}", board.name, elf.flash(), elf.ram(), report.stack);
    if verbose {
        for section in elf.sections.iter().filter(|section| section.size > 0) {
            let memory = match (section.stored, section.writable) {
                (true, true) => "flash+ram",
                (true, false) => "flash",
                (false, _) => "ram",
            };
            println!("board={} section={} {memory}={}", board.name, section.name, section.size);
        }
    }
    Ok(lines)
}
