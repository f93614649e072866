//! Asks the firmware what settings cost, and weighs their code.

use super::core::Core;
use super::plan::{Cost, Setting};
use super::settings::{self, cache_bytes, WEIGHED};
use crate::firmware::board::{self, Board};
use crate::firmware::build::House;
use crate::firmware::sizes::{self, Weights};
use crate::firmware::{emulate, lines, mesh_file};
use microraster::Size;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// The firmware that draws the model.
const EXAMPLE: &str = "budget";

/// Measures on one core.
#[derive(Debug)]
pub(crate) struct Bench {
    house: House,
    board: &'static Board,
    elf: PathBuf,
    folder: Folder,
    display: Size,
}

/// Where the emulator finds the mesh: a folder of one bench alone, removed in the end. Two that
/// share one would measure each other's model.
#[derive(Debug)]
struct Folder(PathBuf);

impl Folder {
    /// Makes a new one in another.
    fn new(parent: &Path) -> Result<Self, String> {
        static MADE: AtomicU32 = AtomicU32::new(0);
        let number = MADE.fetch_add(1, Ordering::Relaxed);
        let path = parent.join(format!("budget-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&path)
            .map_err(|why| format!("cannot make the folder {}: {why}", path.display()))?;
        Ok(Self(path))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // What cannot be removed is in nobody's way.
        let _ = std::fs::remove_file(self.0.join(settings::FILE));
        let _ = std::fs::remove_dir(&self.0);
    }
}

/// Bytes of the code of one setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Code {
    pub(crate) weights: Weights,
    /// All of its flash.
    pub(crate) flash: u64,
    /// Statics beside bands and cache.
    pub(crate) statics: u64,
}

impl Bench {
    /// Builds the firmware and lays out the model for it.
    ///
    /// # Errors
    /// No compiler for the target, a failed build, or a folder that takes no file.
    pub(crate) fn new(core: &Core, words: &[u32], display: Size) -> Result<Self, String> {
        let house = House::find()?;
        let board = board::find(core.board)?;
        let elf = house.example(EXAMPLE, board)?;
        let folder = Folder::new(&house.firmware()?)?;
        mesh_file::write(&folder.0.join(settings::FILE), words)?;
        Ok(Self { house, board, elf, folder, display })
    }

    /// What the settings cost, in their order.
    ///
    /// # Errors
    /// No emulator, or firmware that failed.
    pub(crate) fn costs(&self, settings: &[Setting]) -> Result<Vec<Cost>, String> {
        if settings.is_empty() {
            return Ok(Vec::new());
        }
        let words: Vec<_> = settings.iter().map(|setting| setting.word(self.display)).collect();
        let printed = emulate::run(self.board, &self.elf, &self.folder.0, &words, None)?;
        costs(settings, &words, &printed)
    }

    /// Links the code of a setting alone and weighs it.
    ///
    /// # Errors
    /// The build failed, or links a heap.
    pub(crate) fn code(&self, setting: Setting) -> Result<Code, String> {
        let variant = setting.variant();
        let file = self.house.example_of(EXAMPLE, &variant, self.board)?;
        let elf = sizes::read(&file, &variant, self.board)?;
        let buffers = (2 * WEIGHED * size_of::<u16>() + cache_bytes(setting.cache)) as u64;
        Ok(Code {
            weights: Weights::of(&elf),
            flash: elf.flash().into(),
            statics: u64::from(elf.ram()).saturating_sub(buffers),
        })
    }
}

/// Reads what the firmware printed of the settings.
fn costs(settings: &[Setting], words: &[String], printed: &str) -> Result<Vec<Cost>, String> {
    let figure = |line: &str, name: &str| lines::value(line, name)?.parse::<u64>().ok();
    settings
        .iter()
        .zip(words)
        .map(|(&setting, word)| {
            let mut all = printed.lines();
            let line = all.find(|line| lines::value(line, "setting") == Some(word));
            line.and_then(|line| {
                let instructions = figure(line, "instructions")?;
                Some(Cost { setting, instructions, stack: figure(line, "stack")? })
            })
            .ok_or_else(|| format!("the firmware says nothing of {word} but `{printed}`"))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::super::plan::Shading;
    use super::*;

    #[test]
    fn each_bench_has_a_folder_of_its_own_that_is_gone_in_the_end() {
        let parent = std::env::temp_dir();
        let folders = [(); 2].map(|()| Folder::new(&parent).expect("a temporary folder"));
        let paths = folders.each_ref().map(|folder| folder.0.clone());
        assert_ne!(paths[0], paths[1], "two at a time");
        for path in &paths {
            mesh_file::write(&path.join(settings::FILE), &[1, 2]).expect("a mesh of its own");
        }
        drop(folders);
        assert!(paths.iter().all(|path| !path.exists()), "{paths:?}");
    }

    #[test]
    fn lines_are_found_by_their_settings() {
        let setting = |cache| Setting { shading: Shading::Flat, cache, rows: 60 };
        let settings = [setting(64), setting(0)];
        let words = settings.map(|setting| setting.word(Size::new(240, 240)));
        assert_eq!(words[0], "flat:64:240:240:60");
        let printed = "setting=flat:0:240:240:60 instructions=7 stack=8\n\
                       setting=flat:64:240:240:60 instructions=5 stack=6\n";
        let expected = [(settings[0], 5, 6), (settings[1], 7, 8)]
            .map(|(setting, instructions, stack)| Cost { setting, instructions, stack });
        assert_eq!(costs(&settings, &words, printed), Ok(expected.to_vec()));
        assert!(costs(&settings, &words, "error: no mesh").is_err(), "an error is no figure");
    }
}
