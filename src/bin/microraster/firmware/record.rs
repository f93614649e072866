//! The recorded figures, `docs/performance.csv`, and the gate: no figure may rise by more than
//! 2 % without the record being changed in the same commit.

use super::facts::Line;
use std::fmt::{self, Write as _};
use std::path::Path;

/// How far a figure may be from the recorded one, in hundredths.
const TOLERANCE: u64 = 2;
/// The first line of the file.
const HEADER: &str = "board,scene,instructions,compiler";

/// One recorded figure.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Entry {
    board: String,
    scene: String,
    /// Instructions a frame.
    instructions: u64,
    /// What the compiler that built the firmware says of its version.
    compiler: String,
}

/// The recorded figures.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Record {
    entries: Vec<Entry>,
}

impl Record {
    /// Takes note of what a board measured with a compiler's code.
    pub(crate) fn add<'a>(&mut self, lines: impl Iterator<Item = &'a Line>, compiler: &str) {
        self.entries.extend(lines.map(|line| Entry {
            board: line.board().to_owned(),
            scene: line.scene().to_owned(),
            instructions: line.mean_instructions(),
            compiler: compiler.replace(',', ";"),
        }));
    }

    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be read, or a line has another form.
    pub(crate) fn load(file: &Path) -> Result<Self, String> {
        let cannot = |why: String| format!("{}: {why}", file.display());
        let text = std::fs::read_to_string(file).map_err(|why| cannot(why.to_string()))?;
        Self::read(&text).map_err(cannot)
    }

    /// Writes a file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn save(&self, file: &Path) -> Result<(), String> {
        std::fs::write(file, self.to_string()).map_err(|why| format!("{}: {why}", file.display()))
    }

    fn read(text: &str) -> Result<Self, String> {
        let mut lines = text.lines();
        if lines.next() != Some(HEADER) {
            return Err(format!("the first line is not `{HEADER}`"));
        }
        let entry = |line: &str| {
            let fields: Vec<_> = line.split(',').collect();
            let [board, scene, instructions, compiler] = fields.as_slice() else { return None };
            Some(Entry {
                board: (*board).to_owned(),
                scene: (*scene).to_owned(),
                instructions: instructions.parse().ok()?,
                compiler: (*compiler).to_owned(),
            })
        };
        let entries = lines
            .map(|line| entry(line).ok_or_else(|| format!("no recorded figure is `{line}`")))
            .collect::<Result<_, _>>()?;
        Ok(Self { entries })
    }

    /// What of this, just measured, is away from what `old` says.
    pub(crate) fn changes(&self, old: &Self) -> Vec<Change> {
        let change = |new: &Entry| {
            let is_same = |old: &&Entry| (&old.board, &old.scene) == (&new.board, &new.scene);
            let old = old.entries.iter().find(is_same);
            let recorded = old.map(|old| old.instructions);
            let change = match recorded {
                None => Direction::Unrecorded,
                Some(before) if new.instructions * 100 > before * (100 + TOLERANCE) => {
                    Direction::Rise
                }
                Some(before) if new.instructions * 100 < before * (100 - TOLERANCE) => {
                    Direction::Fall
                }
                Some(_) => return None,
            };
            Some(Change {
                board: new.board.clone(),
                scene: new.scene.clone(),
                direction: change,
                before: recorded.unwrap_or(0),
                after: new.instructions,
                other_compiler: old
                    .map(|old| old.compiler.clone())
                    .filter(|compiler| *compiler != new.compiler),
            })
        };
        self.entries.iter().filter_map(change).collect()
    }
}

impl fmt::Display for Record {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{HEADER}")?;
        self.entries.iter().try_for_each(|entry| {
            let Entry { board, scene, instructions, compiler } = entry;
            writeln!(f, "{board},{scene},{instructions},{compiler}")
        })
    }
}

/// Where a figure went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Direction {
    Rise,
    Fall,
    Unrecorded,
}

/// A figure that is not the recorded one, nor near it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Change {
    board: String,
    scene: String,
    direction: Direction,
    before: u64,
    after: u64,
    /// The compiler of the record, where it was another: then the code differs for its sake.
    other_compiler: Option<String>,
}

impl Change {
    /// Whether the gate stays closed for it: not for what fell, nor where compilers differ.
    pub(crate) fn fails(&self) -> bool {
        self.direction != Direction::Fall && self.other_compiler.is_none()
    }
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { board, scene, direction, before, after, other_compiler } = self;
        write!(f, "board={board} scene={scene} recorded=")?;
        if *direction == Direction::Unrecorded {
            write!(f, "- instructions={after}: record it")?;
        } else {
            let percent = (*after as f64 / (*before).max(1) as f64 - 1.0) * 100.0;
            write!(f, "{before} instructions={after} change={percent:+.1}%: ")?;
            f.write_str(if *direction == Direction::Rise {
                "costs more than is recorded"
            } else {
                "costs less; record it"
            })?;
        }
        other_compiler.as_ref().map_or(Ok(()), |compiler| {
            write!(f, " (a warning: the record is of another compiler, {compiler})")
        })
    }
}

/// Compares what was measured with the record in a file and prints what is away from it.
///
/// # Errors
/// No such record, or a figure that the gate is closed for.
pub(crate) fn gate(measured: &Record, file: &Path) -> Result<(), String> {
    let changes = measured.changes(&Record::load(file)?);
    let mut text = String::new();
    for change in &changes {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "gate: {change}");
    }
    eprint!("{text}");
    match changes.iter().filter(|change| change.fails()).count() {
        0 => {
            println!("gate: {} figures compared with {}", measured.entries.len(), file.display());
            Ok(())
        }
        count => Err(format!(
            "{count} figures are not those of {}; where that is meant, run `cargo firmware \
             --performance` and say why in the commit",
            file.display()
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(figures: &[(&str, &str, u64, &str)]) -> Record {
        let entries = figures.iter().map(|(board, scene, instructions, compiler)| Entry {
            board: (*board).to_owned(),
            scene: (*scene).to_owned(),
            instructions: *instructions,
            compiler: (*compiler).to_owned(),
        });
        Record { entries: entries.collect() }
    }

    #[test]
    fn a_record_is_read_back() {
        let record = record(&[("m4", "F1", 75_000, "rustc 1.85.0 (x)"), ("m0", "F1", 9, "y")]);
        assert_eq!(Record::read(&record.to_string()), Ok(record), "all of it");
    }

    #[test]
    fn a_foreign_line_is_an_error_that_shows_it() {
        for line in ["m4,F1,75000", "m4,F1,many,rustc", "m4,F1,1,rustc,more", "", "m4,F1,-1,rustc"]
        {
            let message = Record::read(&format!("{HEADER}\n{line}\n")).expect_err(line);
            assert!(message.contains(&format!("`{line}`")), "{message}");
        }
        let message = Record::read("m4,F1,1,rustc\n").expect_err("no header");
        assert!(message.contains(HEADER), "{message}");
    }

    #[test]
    fn the_gate_closes_just_beyond_two_percent() {
        let old = record(&[("m4", "F1", 10_000, "a"), ("m0", "F1", 20_000, "a")]);
        for (after, closes) in [(10_200, false), (10_201, true), (9_000, false), (10_000, false)] {
            let changes = record(&[("m4", "F1", after, "a")]).changes(&old);
            assert_eq!(changes.iter().any(Change::fails), closes, "{after}: {changes:?}");
        }
    }

    #[test]
    fn a_change_says_scene_board_and_both_figures() {
        let old = record(&[("m4", "F1", 10_000, "a")]);
        let said = |after| {
            let changes = record(&[("m4", "F1", after, "a")]).changes(&old);
            changes.iter().map(ToString::to_string).collect::<Vec<_>>()
        };
        assert_eq!(
            said(10_300),
            ["board=m4 scene=F1 recorded=10000 instructions=10300 change=+3.0%: costs more than \
              is recorded"]
        );
        assert_eq!(
            said(9_700),
            ["board=m4 scene=F1 recorded=10000 instructions=9700 change=-3.0%: costs less; \
              record it"]
        );
        assert!(said(9_800).is_empty(), "within two percent");
    }

    #[test]
    fn another_compiler_only_warns() {
        let old = record(&[("m4", "F1", 10_000, "rustc 1.0")]);
        let changes = record(&[("m4", "F1", 20_000, "rustc 2.0")]).changes(&old);
        let said: Vec<_> = changes.iter().map(ToString::to_string).collect();
        assert!(!changes.iter().any(Change::fails), "{said:?}");
        assert!(said[0].ends_with("another compiler, rustc 1.0)"), "{said:?}");
    }

    #[test]
    fn a_scene_without_a_record_closes_the_gate() {
        let old = record(&[("m4", "F1", 10_000, "a")]);
        let changes = record(&[("m0", "F1", 10_000, "a")]).changes(&old);
        assert!(changes.iter().any(Change::fails), "{changes:?}");
        assert_eq!(
            changes[0].to_string(),
            "board=m0 scene=F1 recorded=- instructions=10000: record it"
        );
    }
}
