//! The host program: `simulate` draws a model into a picture file.

mod simulate;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Exact, lean 3D rendering for microcontroller displays.
#[derive(Debug, Parser)]
#[command(version)]
struct Program {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Simulate(simulate::Arguments),
}

fn main() -> ExitCode {
    let outcome = match Program::parse().command {
        Command::Simulate(arguments) => simulate::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("microraster: {message}");
            ExitCode::FAILURE
        }
    }
}
