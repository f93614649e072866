//! `--profile`: where a scene's instructions go, by function and by address.

use super::board::Board;
use super::build::House;
use super::emulate;
use std::path::PathBuf;
use std::process::Command;

/// The plugin's source: it runs inside the emulator, so it is no module of this program.
const SOURCE: &str = "examples/board/plugin/count.rs";

/// What was executed in the measured parts of a run.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Profile {
    pub(crate) instructions: u64,
    /// Branches, calls and returns that were taken.
    pub(crate) taken: u64,
    /// Every instruction of the firmware that was executed.
    pub(crate) places: Vec<Place>,
}

/// One instruction of the firmware.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) count: u64,
    pub(crate) address: u64,
    /// As the emulator disassembles it.
    pub(crate) text: String,
    /// The function that it is in, as the linker names it.
    pub(crate) function: String,
}

impl Profile {
    /// Reads the plugin's report.
    fn read(report: &str) -> Result<Self, String> {
        let mut profile = Self::default();
        for line in report.lines() {
            let (kind, rest) = line.split_once(' ').unwrap_or((line, ""));
            let known = match kind {
                "instructions" => rest.parse().map(|count| profile.instructions = count).ok(),
                "taken" => rest.parse().map(|count| profile.taken = count).ok(),
                "address" => place(rest).map(|place| profile.places.push(place)),
                _ => Some(()),
            };
            known.ok_or_else(|| format!("the plugin's report has the line `{line}`"))?;
        }
        let listed: u64 = profile.places.iter().map(|place| place.count).sum();
        if listed == profile.instructions && listed > 0 {
            Ok(profile)
        } else {
            Err(format!("the plugin lists {listed} of {} instructions", profile.instructions))
        }
    }
}

impl Profile {
    /// The instructions that were executed at least one time for `cool` times of the most executed
    /// one, in the order of addresses.
    pub(crate) fn hot(&self, cool: u64) -> Vec<&Place> {
        let most = self.places.iter().map(|place| place.count).max().unwrap_or(0);
        let hot = |place: &&Place| place.count.saturating_mul(cool) >= most;
        let mut places: Vec<_> = self.places.iter().filter(hot).collect();
        places.sort_by_key(|place| place.address);
        places
    }
}

/// A row by address: count, share, address, the instruction, the function.
fn place(row: &str) -> Option<Place> {
    let words: Vec<_> = row.split_whitespace().collect();
    let [count, _share, address, text @ .., function] = words.as_slice() else { return None };
    Some(Place {
        count: count.parse().ok()?,
        address: u64::from_str_radix(address, 16).ok()?,
        text: text.join(" "),
        function: (*function).to_owned(),
    })
}

/// The firmware of a board, ready to be run with the plugin.
#[derive(Debug)]
pub(crate) struct Profiler<'a> {
    board: &'a Board,
    plugin: PathBuf,
    elf: PathBuf,
    folder: PathBuf,
}

impl<'a> Profiler<'a> {
    /// Builds both.
    ///
    /// # Errors
    /// The plugin or the firmware does not build.
    pub(crate) fn new(house: &House, board: &'a Board) -> Result<Self, String> {
        let (plugin, elf) = (build(house)?, house.example("firmware", board)?);
        Ok(Self { board, plugin, elf, folder: house.firmware()? })
    }

    /// Runs the scenes of `words` and counts.
    ///
    /// # Errors
    /// The run failed.
    pub(crate) fn run(&self, words: &[String]) -> Result<Profile, String> {
        Profile::read(&self.report(words, u32::MAX)?)
    }

    /// What the plugin reports of a run, with as many rows of each table.
    fn report(&self, words: &[String], rows: u32) -> Result<String, String> {
        let Self { board, plugin, elf, folder } = self;
        let argument = format!("{},out=profile.txt,top={rows}", plugin.display());
        emulate::run(board, elf, folder, words, Some(&argument))?;
        let out = folder.join("profile.txt");
        std::fs::read_to_string(&out).map_err(|why| format!("{}: {why}", out.display()))
    }
}

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
    for line in Profiler::new(house, board)?.report(words, rows)?.lines() {
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_is_read_back() {
        let report = "instructions 30\ntaken 9\nfunction 30 100.00% f\nmnemonic 10 33.33% ldr\n\
                      address           20  66.67% 0000001a str.w    r0, [r1, #4]     _RNvf\n\
                      address           10  33.33% 0000001e bx       lr               _RNvf\n";
        let place = |count, address, text: &str| Place {
            count,
            address,
            text: text.to_owned(),
            function: "_RNvf".to_owned(),
        };
        let places = vec![place(20, 0x1a, "str.w r0, [r1, #4]"), place(10, 0x1e, "bx lr")];
        assert_eq!(Profile::read(report), Ok(Profile { instructions: 30, taken: 9, places }));
    }

    #[test]
    fn a_report_that_leaves_something_out_is_an_error() {
        for report in [
            "",
            "instructions 30\naddress 20 66% 0000001a nop f\n",
            "instructions many\n",
            "instructions 1\naddress 1 100%\n",
        ] {
            assert!(Profile::read(report).is_err(), "{report}");
        }
    }
}
