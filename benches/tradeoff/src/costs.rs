//! What cases cost: counted in QEMU, or as it was recorded.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Boards that are counted, as `cargo firmware` names them, and as tables do.
pub(crate) const BOARDS: [(&str, &str); 3] = [("m4", "M4F"), ("m0", "M0+"), ("rv32", "RV32")];

/// The place of a board in [`BOARDS`]: by either name.
pub(crate) fn board(name: &str) -> Option<usize> {
    let name = name.to_lowercase();
    BOARDS.iter().position(|(short, long)| *short == name || long.to_lowercase() == name)
}

/// Instructions of a case by board, and the hash of what was drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Cost {
    pub(crate) instructions: [u64; BOARDS.len()],
    pub(crate) hash: u64,
}

/// All counts, and what they were made of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Costs {
    pub(crate) cases: BTreeMap<String, Cost>,
    /// The commit on which they were counted.
    pub(crate) commit: String,
    pub(crate) compiler: String,
    /// A digest of the sources that the counts depend on.
    sources: String,
}

/// The record, in the repository.
fn record(root: &Path) -> PathBuf {
    root.join("docs/tradeoff/costs.csv")
}

impl Costs {
    /// Counts every case on every board, or says why that cannot be done here.
    ///
    /// # Errors
    /// No emulator or compiler, or the firmware failed; the command said why.
    pub(crate) fn count(root: &Path) -> Result<Self, String> {
        let boards: Vec<_> = BOARDS.iter().map(|(name, _)| *name).collect();
        let cargo = std::env::var_os("CARGO").unwrap_or("cargo".into());
        let output = Command::new(cargo)
            .args(["firmware", "--example", "tradeoff", "--boards", &boards.join(",")])
            .current_dir(root)
            .stdin(Stdio::null())
            .stderr(Stdio::inherit())
            .output()
            .map_err(|why| format!("cannot start cargo: {why}"))?;
        if !output.status.success() {
            return Err("`cargo firmware` failed; it says why above".into());
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let mut costs = Self {
            commit: text_of(root, "git", &["rev-parse", "--short", "HEAD"]),
            sources: digest(root)?,
            ..Self::default()
        };
        for line in text.lines() {
            costs.read(line).ok_or_else(|| format!("the firmware printed `{line}`"))?;
        }
        Ok(costs)
    }

    /// One line of the firmware.
    fn read(&mut self, line: &str) -> Option<()> {
        let value = |name: &str| {
            line.split_whitespace().find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
        };
        let board = board(value("board")?)?;
        if let Some(compiler) = value("compiler") {
            self.compiler = compiler.replace('-', " ");
        } else if let Some(name) = value("scene") {
            let hash = u64::from_str_radix(value("hash")?, 16).ok()?;
            let cost =
                self.cases.entry(name.to_owned()).or_insert(Cost { hash, ..Cost::default() });
            // One picture on all boards.
            if cost.hash != hash {
                return None;
            }
            *cost.instructions.get_mut(board)? = value("instructions")?.parse().ok()?;
        } else {
            value("stack")?;
        }
        Some(())
    }

    /// The recorded counts.
    ///
    /// # Errors
    /// There are none, or the sources have changed since.
    pub(crate) fn recorded(root: &Path) -> Result<Self, String> {
        let file = record(root);
        let text =
            std::fs::read_to_string(&file).map_err(|why| format!("{}: {why}", file.display()))?;
        let costs = Self::parse(&text)
            .ok_or_else(|| format!("{}: not a record of costs", file.display()))?;
        if costs.sources == digest(root)? {
            Ok(costs)
        } else {
            Err(format!(
                "{}: counted on commit {} with {}, and the sources have changed since; install \
                 QEMU (`cargo firmware` says how) and count anew",
                file.display(),
                costs.commit,
                costs.compiler
            ))
        }
    }

    fn parse(text: &str) -> Option<Self> {
        let mut lines = text.lines();
        let mut head = lines.next()?.strip_prefix("# ")?.split(", ");
        let mut word = |name: &str| Some(head.next()?.strip_prefix(name)?.to_owned());
        let mut costs = Self {
            commit: word("commit ")?,
            compiler: word("compiler ")?,
            sources: word("sources ")?,
            cases: BTreeMap::new(),
        };
        for line in lines.skip(1) {
            let mut cells = line.split(',');
            let (name, hash) = (cells.next()?, u64::from_str_radix(cells.next()?, 16).ok()?);
            let mut instructions = [0; BOARDS.len()];
            for count in &mut instructions {
                *count = cells.next()?.parse().ok()?;
            }
            costs.cases.insert(name.to_owned(), Cost { instructions, hash });
        }
        Some(costs)
    }

    /// Records the counts.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn write(&self, root: &Path) -> Result<(), String> {
        let file = record(root);
        std::fs::write(&file, self.text()).map_err(|why| format!("{}: {why}", file.display()))
    }

    fn text(&self) -> String {
        let mut text = format!(
            "# commit {}, compiler {}, sources {}\ncase,hash",
            self.commit, self.compiler, self.sources
        );
        // Writing to a string cannot fail.
        for (_, name) in BOARDS {
            let _ = write!(text, ",{name}");
        }
        for (name, cost) in &self.cases {
            let _ = write!(text, "\n{name},{:016x}", cost.hash);
            for count in cost.instructions {
                let _ = write!(text, ",{count}");
            }
        }
        text + "\n"
    }
}

fn text_of(folder: &Path, program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).current_dir(folder).output();
    output.map(|o| String::from_utf8_lossy(&o.stdout).trim().to_owned()).unwrap_or_default()
}

/// A digest of what the counts depend on: the library, and what the cases are made of.
fn digest(root: &Path) -> Result<String, String> {
    let mut files = Vec::new();
    for place in
        ["src", "examples/tradeoff", "examples/scenes", "examples/gallery", "examples/board"]
    {
        sources(&root.join(place), &mut files)?;
    }
    files.push(root.join("Cargo.toml"));
    files.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    // The host's own part of the library is in no firmware.
    let host = [root.join("src/host"), root.join("src/bin")];
    for file in files.iter().filter(|file| !host.iter().any(|folder| file.starts_with(folder))) {
        let text =
            std::fs::read_to_string(file).map_err(|why| format!("{}: {why}", file.display()))?;
        // What is only said costs nothing.
        let lines = text.lines().map(str::trim).filter(|line| !line.starts_with("//"));
        for byte in lines.flat_map(str::bytes) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    Ok(format!("{hash:016x}"))
}

fn sources(folder: &Path, files: &mut Vec<PathBuf>) -> Result<(), String> {
    let cannot = |why: std::io::Error| format!("{}: {why}", folder.display());
    for entry in std::fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if path.is_dir() {
            sources(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample() -> Costs {
        let mut costs = Costs {
            commit: "abc".into(),
            compiler: "rustc 1.90".into(),
            sources: "00".into(),
            ..Costs::default()
        };
        let cost = Cost { instructions: [1, 2, 3], hash: 0xff };
        costs.cases.insert("fill/depth=off".into(), cost);
        costs
    }

    #[test]
    fn a_record_is_read_back() {
        assert_eq!(Costs::parse(&sample().text()), Some(sample()));
        assert_eq!(Costs::parse("case,hash"), None);
    }

    #[test]
    fn boards_that_draw_other_pictures_are_an_error() {
        let mut costs = Costs::default();
        let line = |board, hash| {
            format!("board={board} scene=a/b=c frame=0 instructions=7 hash={hash:016x} bytes=4")
        };
        assert_eq!(costs.read(&line("m4", 5)), Some(()));
        assert_eq!(costs.read(&line("m0", 5)), Some(()));
        assert_eq!(costs.read(&line("rv32", 6)), None);
        assert_eq!(costs.cases["a/b=c"].instructions, [7, 7, 0]);
    }
}
