//! `cargo tradeoff`: what every setting of every knob costs, and how far from the truth it is.

mod advice;
#[path = "../../../src/bin/microraster/firmware/bunny.rs"]
mod bunny;
mod case;
mod costs;
mod doc_lines;
mod document;
mod drawing;
mod errors;
mod memory;
#[path = "../../../src/bin/microraster/firmware/mesh_file.rs"]
#[allow(dead_code, reason = "the firmware command writes the file; this tool reads its words")]
mod mesh_file;
mod plot;
mod report;
mod row;
#[path = "../../../examples/scenes/mod.rs"]
#[allow(dead_code, reason = "the tool draws none but its own cases")]
mod scenes;
mod side_by_side;
mod subpixels;
mod table;
mod texels;
#[path = "../../../examples/tradeoff/mod.rs"]
mod tradeoff;
mod traversals;
mod truth;

use clap::Parser;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use costs::Costs;
use report::Report;

/// Weighs the accuracy of every setting of microraster against its cost.
///
/// Without options, counts all cases on all boards under QEMU and writes docs/TRADEOFF.md, and
/// tables, plots and pictures beside it. Without QEMU, the recorded counts are used where they are
/// not stale.
#[derive(Debug, Parser)]
#[command(name = "cargo tradeoff", version)]
struct Arguments {
    /// Recommend settings for so many instructions a frame, such as 2M, instead of writing files.
    #[arg(long, value_name = "INSTRUCTIONS", requires = "scene")]
    budget: Option<String>,
    /// The core of the budget: m4f, m0+ or rv32.
    #[arg(long, value_name = "CORE", default_value = "m4f")]
    target: String,
    /// The scene of the budget.
    #[arg(long, value_name = "SCENE")]
    scene: Option<String>,
    /// Bytes of buffers that the budget allows, such as 320k.
    #[arg(long, value_name = "BYTES", requires = "budget")]
    memory: Option<String>,
    /// Use the recorded counts, even where QEMU is installed.
    #[arg(long)]
    recorded: bool,
    /// Compare every picture with the reference and print the table, without any costs and
    /// without writing a file.
    #[arg(long, conflicts_with_all = ["budget", "recorded"])]
    errors: bool,
    /// Draw a scene in a way of finding pixels and nothing else: what callgrind counts.
    #[arg(long, hide = true, requires = "scene", conflicts_with_all = ["budget", "errors"])]
    traversal: Option<traversals::Way>,
    /// How many times.
    #[arg(long, hide = true, default_value_t = 1)]
    times: u32,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("tradeoff: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), String> {
    if let (Some(way), Some(scene)) = (arguments.traversal, &arguments.scene) {
        return traversals::draw(scene, way, arguments.times).map(|_| ());
    }
    let root = root();
    if let (Some(budget), Some(scene)) = (&arguments.budget, &arguments.scene) {
        let budget = advice::budget(budget)?;
        let board = board_of(&arguments.target)?;
        let memory = arguments.memory.as_deref().map_or(Ok(u64::MAX), advice::budget)?;
        let memory = usize::try_from(memory).unwrap_or(usize::MAX);
        let costs = Costs::recorded(&root)?;
        let report = Report::new(&root, &costs, |name| name.scene == *scene)?;
        print!("{}", advice::advise(&report.rows, scene, board, budget, memory)?);
        println!("{}", table::source(&costs));
        return Ok(());
    }
    if arguments.errors {
        let report = Report::new(&root, &Costs::default(), |_| true)?;
        print!("{}", table::csv(&report.rows));
        return Ok(());
    }
    let costs = if arguments.recorded {
        Costs::recorded(&root)?
    } else {
        match Costs::count(&root) {
            Ok(costs) => costs,
            Err(why) => {
                eprintln!("tradeoff: {why}");
                eprintln!("tradeoff: taking the recorded counts");
                Costs::recorded(&root)?
            }
        }
    };
    let mut report = Report::new(&root, &costs, |_| true)?;
    costs.write(&root)?;
    report.write(&root, &costs)
}

/// The board of a core's name.
fn board_of(target: &str) -> Result<usize, String> {
    let name = match target.to_lowercase().as_str() {
        "m4f" | "m4" => "m4",
        "m0+" | "m0" => "m0",
        "rv32" => "rv32",
        _ => return Err(format!("there is no core `{target}`; choose m4f, m0+ or rv32")),
    };
    costs::board(name).ok_or_else(|| format!("the core `{target}` is not counted"))
}

/// The crate's repository, which this package lies in.
fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).unwrap_or(package).to_path_buf()
}
