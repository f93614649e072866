//! The host program: `simulate` draws a model into a picture file, `firmware` draws scenes as
//! firmware and compares them with the host's, `budget` says what a model takes of a target.

mod budget;
mod firmware;
mod simulate;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Exact, lean 3D rendering for microcontroller displays: the host side.
#[derive(Debug, Parser)]
#[command(name = "microraster", version)]
struct Program {
    /// What to do.
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Simulate(simulate::Arguments),
    /// Draw the scenes as firmware under QEMU and compare every frame with the host's.
    Firmware(firmware::Arguments),
    Budget(budget::Arguments),
}

fn main() -> ExitCode {
    let program = match Program::try_parse() {
        Ok(program) => program,
        Err(message) => {
            // Help and version come this way too, and go to standard output.
            let is_error = message.use_stderr();
            return match message.print() {
                Ok(()) if !is_error => ExitCode::SUCCESS,
                _ => ExitCode::FAILURE,
            };
        }
    };
    let outcome = match program.command {
        Command::Simulate(arguments) => simulate::run(&arguments),
        Command::Firmware(arguments) => firmware::run(&arguments),
        Command::Budget(arguments) => match budget::run(&arguments) {
            Ok(budget::Verdict::DoesNotFit) => return ExitCode::from(2),
            outcome => outcome.map(|_| ()),
        },
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("microraster: {message}");
            ExitCode::FAILURE
        }
    }
}
