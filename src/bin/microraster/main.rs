//! The host program: `firmware` draws scenes as firmware and compares them with the host's.

mod firmware;

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
    /// Draw the scenes as firmware under QEMU and compare every frame with the host's.
    Firmware(firmware::Arguments),
}

fn main() -> ExitCode {
    let outcome = match Program::parse().command {
        Command::Firmware(arguments) => firmware::run(&arguments),
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}
