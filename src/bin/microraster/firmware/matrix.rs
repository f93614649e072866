//! `--matrix`: whether all boards draw what the host draws.

use super::board::{Board, Emulator};
use super::build::{House, Profile};
use super::facts::{Counter, Frame, Line};
use super::scenes::{Group, Scene};
use super::{checked, emulate, lines};
use std::fmt::Write as _;

/// One row of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Row {
    board: &'static Board,
    scenes: usize,
    frames: u64,
    equal: usize,
}

/// Builds firmware for each board, draws the scenes there and prints a line for each that differs,
/// and the table. While one board draws, the next one's firmware is built.
///
/// # Errors
/// A build or a run failed, or a board drew another picture than the host.
pub(crate) fn compare(
    house: House,
    boards: &[&'static Board],
    scenes: &[Scene<Counter>],
    expected: &[Vec<Frame>],
    words: &[String],
) -> Result<(), String> {
    let house = House { profile: Profile::Pictures, ..house };
    let folder = house.firmware()?;
    let compared = |scene: &Scene<Counter>| matches!(scene.group, Group::Golden | Group::Gallery);
    let variant = if scenes.iter().all(compared) { "pictures" } else { "" };
    let rows = std::thread::scope(|scope| {
        let mut runs = Vec::new();
        for &board in boards {
            let file = house.example_of("firmware", variant, board)?;
            checked(board, &file)?;
            let folder = &folder;
            let run = move || emulate::run(board, &file, folder, words, None);
            runs.push((board, scope.spawn(run)));
        }
        let rows = runs.into_iter().map(|(board, run)| {
            let printed = run.join().map_err(|_| "a thread that runs firmware stopped")??;
            let report = lines::Report::read(&printed)?;
            Ok(row(board, &lines_of(board, scenes, expected, &report)))
        });
        rows.collect::<Result<Vec<_>, String>>()
    })?;
    print!("{}", table(&rows));
    match rows.iter().map(|row| row.scenes - row.equal).sum() {
        0 => Ok(()),
        wrong => Err(different(wrong)),
    }
}

/// What is said where pictures differ.
pub(crate) fn different(scenes: usize) -> String {
    format!("{scenes} scenes differ between a board and the host")
}

/// A board's lines.
fn lines_of(
    board: &'static Board,
    scenes: &[Scene<Counter>],
    expected: &[Vec<Frame>],
    report: &lines::Report,
) -> Vec<Line> {
    let pairs = scenes.iter().zip(expected);
    pairs.map(|(scene, frames)| Line::of(board.name, scene.name, report, frames)).collect()
}

/// A board's row; what differs is said.
fn row(board: &'static Board, lines: &[Line]) -> Row {
    for line in lines {
        if let Some(how) = &line.differs {
            eprintln!("board={} scene={} {how}", board.name, line.scene());
        }
    }
    Row {
        board,
        scenes: lines.len(),
        frames: lines.iter().map(Line::frames).sum(),
        equal: lines.iter().filter(|line| line.differs.is_none()).count(),
    }
}

/// The table, a line a board.
fn table(rows: &[Row]) -> String {
    let mut text = format!(
        "{:7} {:26} {:12} {:>7} {:>7} {:>7}\n",
        "board", "target", "machine", "scenes", "frames", "equal"
    );
    for Row { board, scenes, frames, equal } in rows {
        let machine = match board.emulator() {
            Emulator::Node => "node",
            Emulator::Qemu(..) => board.machine,
        };
        let (name, target) = (board.name, board.target);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:7} {target:26} {machine:12} {scenes:7} {frames:7} {equal:7}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::board;
    use super::super::lines::{Drawn, Report};
    use super::*;

    #[test]
    fn a_missing_and_a_wrong_picture_are_not_equal() {
        let frame = |hash| Frame { hash, bytes: 8, triangles: 1, pixels: 4 };
        let drawn = |scene: &str, hash| Drawn {
            scene: scene.into(),
            frame: 0,
            instructions: 0,
            hash,
            bytes: 8,
        };
        let report = Report { frames: vec![drawn("a", 1), drawn("b", 3)], stack: 0 };
        let lines: Vec<_> = [("a", 1), ("b", 2), ("c", 3)]
            .map(|(scene, hash)| Line::of("m55", scene, &report, &[frame(hash)]))
            .into();
        let board = board::find("m55").expect("a board");
        let row = row(board, &lines);
        assert_eq!(row, Row { board, scenes: 3, frames: 2, equal: 1 });
        assert_eq!(
            table(&[row]),
            "board   target                     machine       scenes  frames   equal\n\
             m55     thumbv8m.main-none-eabihf  mps3-an547         3       2       1\n"
        );
    }
}
