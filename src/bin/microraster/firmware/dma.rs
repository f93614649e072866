//! `--dma`: what it gains to draw a band while the one before is sent.

use super::board::Board;
use super::build::House;
use super::emulate;
use super::figures::Figures;
use super::lines::Report;
use super::small_ram::{self, display};
use std::path::Path;

const EXAMPLE: &str = "dma";
/// How bands are sent, as the firmware calls it and as the table does.
const WAYS: [(&str, &str); 3] = [
    ("at-once", "drawn, not sent"),
    ("blocking", "each band waited for"),
    ("overlapped", "one drawn while one is sent"),
];

/// Runs the example on boards, prints a line for each, and puts the table into `file`.
///
/// # Errors
/// A build or a run failed, or the panel shows another picture than the host's.
pub(crate) fn show(house: &House, boards: &[&Board], file: Option<&Path>) -> Result<(), String> {
    let expected = small_ram::frames(&display::DISPLAYS[1], display::teapot())?;
    let mut figures = Figures::default();
    for board in boards {
        let elf = house.example(EXAMPLE, board)?;
        let report = Report::read(&emulate::run(board, &elf, &house.firmware()?, &[], None)?)?;
        figures.board(board.name);
        let mut line = format!("board={}", board.name);
        for (way, what) in WAYS {
            let instructions = mean(&report, way, &expected)
                .map_err(|why| format!("board {}, {way}: {why}", board.name))?;
            line.push_str(&format!(" {way}={instructions}"));
            figures.put(what, format!("{:.2} M", instructions as f64 / 1e6));
        }
        println!("{line} frames={} equal=yes", expected.len());
    }
    file.map_or(Ok(()), |file| figures.write(file, "two bands"))
}

/// Instructions of a frame that was sent in this way, where all frames are as expected.
fn mean(report: &Report, way: &str, expected: &[u64]) -> Result<u64, String> {
    let frames = report.frames.iter().filter(|frame| frame.scene == way);
    let hashes: Vec<_> = frames.clone().map(|frame| frame.hash).collect();
    if hashes != expected {
        return Err(format!("the display shows {hashes:x?}, the host draws {expected:x?}"));
    }
    let sum: u64 = frames.map(|frame| frame.instructions).sum();
    Ok(sum / expected.len().max(1) as u64)
}

#[cfg(test)]
mod tests {
    use super::super::lines::Drawn;
    use super::*;

    #[test]
    fn the_mean_is_of_one_way_and_of_equal_pictures_alone() {
        let drawn = |scene: &str, instructions, hash| Drawn {
            scene: scene.into(),
            frame: 0,
            instructions,
            hash,
            bytes: 8,
        };
        let frames = vec![drawn("at-once", 1, 7), drawn("at-once", 4, 8), drawn("blocking", 9, 7)];
        let report = Report { frames, stack: 0 };
        assert_eq!(mean(&report, "at-once", &[7, 8]), Ok(2));
        assert!(mean(&report, "at-once", &[7, 7]).is_err(), "a wrong picture");
        assert!(mean(&report, "blocking", &[7, 8]).is_err(), "a picture is missing");
    }
}
