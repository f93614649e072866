//! `--profile`: where a scene's instructions go, by function and by address.

use super::board::Board;
use super::build::House;
use super::emulate;
use std::path::PathBuf;
use std::process::Command;

/// The plugin's source: it runs inside the emulator, so it is no module of this program.
const SOURCE: &str = "examples/board/plugin/count.rs";

/// Prints the profile of the measured part of one scene on one board, as many rows of each table.
///
/// # Errors
/// The plugin, the firmware or the run failed.
pub(crate) fn print(
    house: &House,
    board: &Board,
    words: &[String],
    rows: u32,
) -> Result<(), String> {
    let plugin = build(house)?;
    let elf = house.example("firmware", board)?;
    let folder = house.firmware()?;
    let argument = format!("{},out=profile.txt,top={rows}", plugin.display());
    let out = folder.join("profile.txt");
    emulate::run(board, &elf, &folder, words, Some(&argument))?;
    let report =
        std::fs::read_to_string(&out).map_err(|why| format!("{}: {why}", out.display()))?;
    for line in report.lines() {
        println!("board={} {}", board.name, plain(line));
    }
    Ok(())
}

/// Builds the plugin for this host.
fn build(house: &House) -> Result<PathBuf, String> {
    let folder = std::path::absolute(house.firmware()?).map_err(|why| why.to_string())?;
    let plugin = folder.join(format!(
        "{}count{}",
        std::env::consts::DLL_PREFIX,
        std::env::consts::DLL_SUFFIX
    ));
    let compiler = std::env::var_os("RUSTC").unwrap_or("rustc".into());
    let status = Command::new(compiler)
        .args(["-O", "--edition", "2021", "--crate-type", "cdylib", SOURCE, "-o"])
        .arg(&plugin)
        .current_dir(&house.package)
        .status()
        .map_err(|why| format!("cannot start rustc: {why}"))?;
    if status.success() {
        Ok(plugin)
    } else {
        Err(format!("{SOURCE} does not compile; rustc says why above"))
    }
}

/// The line with the linker's names made readable: a mangled name is its last word.
fn plain(line: &str) -> String {
    match line.rsplit_once(' ') {
        Some((head, name)) if name.starts_with('_') => {
            format!("{head} {:#}", rustc_demangle::demangle(name))
        }
        _ => line.to_string(),
    }
}
