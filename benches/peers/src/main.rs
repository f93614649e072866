//! Draws the measured scenes with this crate and with others, in one run, and compares time and
//! pictures. Nothing of it reaches users of the crate: it is a package of its own.

extern crate alloc;

#[path = "../../../src/bin/microraster/firmware/board.rs"]
#[allow(dead_code, reason = "one board of many")]
mod board;
mod board_run;
#[path = "../../../src/bin/microraster/firmware/build.rs"]
#[allow(dead_code, reason = "one kind of build of many")]
mod build;
#[path = "../../../src/bin/microraster/firmware/emulate.rs"]
mod emulate;
mod figures;
mod llvmpipe;
mod measure;
mod model;
mod renderers;
mod scene;
mod threaded;

use std::path::PathBuf;

use anyhow::Context;
use clap::Parser;

use measure::Comparison;
use scene::{Mesh, Scene, Size};

/// Draws the measured scenes with other renderers too, and compares.
#[derive(Debug, Parser)]
struct Arguments {
    /// Pictures' sides.
    #[arg(long, value_delimiter = ',', default_values = ["320x240", "1280x720"], value_parser = size)]
    sizes: Vec<Size>,
    /// Scenes; all of them unless given.
    #[arg(long, value_delimiter = ',')]
    scenes: Vec<String>,
    /// How often each renderer draws each scene, in turn; the least time of each counts.
    #[arg(long, default_value_t = 15)]
    rounds: usize,
    /// Measures this crate alone, by one thread and by as many as there are cores.
    #[arg(long)]
    threads: bool,
    /// Counts instructions on Cortex-M4F under QEMU instead, of those that run there.
    #[arg(long, conflicts_with_all = ["threads", "pictures", "scenes", "sizes"])]
    board: bool,
    /// Where to put every picture, as PNG.
    #[arg(long)]
    pictures: Option<PathBuf>,
    /// The page whose tables to write anew, between their marks.
    #[arg(long)]
    figures: Option<PathBuf>,
}

fn size(text: &str) -> Result<Size, String> {
    let sides = text.split_once('x').and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    match sides {
        Some((width @ 16..=4096, height @ 16..=4096)) => Ok(Size { width, height }),
        _ => Err("as in 320x240, 16 to 4096 a side".into()),
    }
}

impl Arguments {
    fn wants(&self, scene: &Scene) -> bool {
        self.scenes.is_empty() || self.scenes.iter().any(|name| name == scene.name)
    }
}

/// One thread against all.
fn threads(arguments: &Arguments, bunny: Option<&Mesh>) -> anyhow::Result<()> {
    let cores = std::thread::available_parallelism()?.get();
    let mut rows = Vec::new();
    for &size in &arguments.sizes {
        for scene in scene::scenes(size, bunny) {
            if arguments.wants(&scene) {
                let gain = measure::threads(&scene, size, cores, arguments.rounds)?;
                let at_most = measure::at_once(&scene, size, cores, arguments.rounds)?;
                println!(
                    "{}x{} {} by {cores} threads: x{gain:.2}, pictures of their own: x{at_most:.2}",
                    size.width, size.height, scene.name
                );
                rows.push((size, scene.name, [gain, at_most]));
            }
        }
    }
    if let Some(page) = &arguments.figures {
        figures::write_threads(page, cores, &rows)?;
    }
    Ok(())
}

fn main() -> anyhow::Result<()> {
    let arguments = Arguments::parse();
    // llvmpipe on the thread that calls it: one core, like the others.
    std::env::set_var("LP_NUM_THREADS", "0");
    if arguments.board {
        let counts = board_run::counts().map_err(anyhow::Error::msg)?;
        println!("{}", figures::board_table(&counts));
        return match &arguments.figures {
            Some(page) => figures::write_board(page, &counts),
            None => Ok(()),
        };
    }
    let bunny = match std::env::var_os("MICRORASTER_MODELS").map(PathBuf::from) {
        Some(models) => Some(model::read(&models.join("obj/bunny-npm/bunny.obj"))?),
        None => {
            eprintln!("peers: MICRORASTER_MODELS names no folder: the bunny is left out");
            None
        }
    };
    let bunny = bunny.as_ref();
    if arguments.threads {
        return threads(&arguments, bunny);
    }
    let mut comparisons: Vec<(Size, Vec<Comparison>)> = Vec::new();
    for &size in &arguments.sizes {
        let mut rows = Vec::new();
        for scene in scene::scenes(size, bunny) {
            if arguments.wants(&scene) {
                let comparison = measure::compare(&scene, size, arguments.rounds);
                println!("{}", figures::line(size, &comparison));
                if let Some(folder) = &arguments.pictures {
                    comparison.save(folder, size).context("a picture could not be written")?;
                }
                rows.push(comparison);
            }
        }
        comparisons.push((size, rows));
    }
    if let Some(page) = &arguments.figures {
        figures::write(page, &comparisons)?;
    }
    Ok(())
}
