//! The tables.

use std::path::Path;

use anyhow::Context;

use crate::board_run::Count;
use crate::measure::{renderers, Comparison};
use crate::renderers::RENDERERS;
use crate::scene::Size;

/// How many times our time another took: above 1 where we are faster.
fn ratio(comparison: &Comparison, renderer: &str) -> Option<(f64, f64)> {
    let ours = comparison.results.first()?;
    let theirs = comparison.results.iter().find(|result| result.renderer == renderer)?;
    Some((theirs.time.as_secs_f64() / ours.time.as_secs_f64(), theirs.different))
}

/// A scene's line on the terminal.
pub(crate) fn line(size: Size, comparison: &Comparison) -> String {
    let results = comparison.results.iter().map(|result| {
        let (ratio, different) = ratio(comparison, result.renderer).unwrap_or((f64::NAN, 0.0));
        let micros = result.time.as_micros();
        format!("{}={micros}us x{ratio:.2} different={different:.1}/1000", result.renderer)
    });
    let results: Vec<_> = results.collect();
    format!("{}x{} {} {}", size.width, size.height, comparison.scene, results.join(" "))
}

/// Writes the tables of a page anew.
pub(crate) fn write(page: &Path, all: &[(Size, Vec<Comparison>)]) -> anyhow::Result<()> {
    let times = table(all, |(ratio, _)| format!("{ratio:.2}"));
    let pictures = table(all, |(_, different)| format!("{different:.1}"));
    replace(page, "peers", &times)?;
    replace(page, "peers-pictures", &pictures)
}

/// Writes the table of threads anew.
pub(crate) fn write_threads(
    page: &Path,
    cores: usize,
    rows: &[(Size, &str, [f64; 2])],
) -> anyhow::Result<()> {
    let mut table = format!("| | at | {cores} threads | {cores} pictures at once |\n");
    table += "| --- | ---: | ---: | ---: |\n";
    for (size, scene, [gain, at_most]) in rows {
        let Size { width, height } = size;
        table += &format!("| {scene} | {width}x{height} | {gain:.2} | {at_most:.2} |\n");
    }
    replace(page, "threads", &table)
}

/// Pixels of the picture on the board.
const PIXELS: f64 = 320.0 * 240.0;

/// Instructions by pixel of the picture (F, blend), by triangle (S) or by frame (M).
pub(crate) fn board_table(counts: &[Count]) -> String {
    let names: Vec<_> = RENDERERS.iter().map(|(name, _)| *name).collect();
    let mut table = format!("| | a | {} |\n", names.join(" | "));
    table += &format!("| --- | --- |{}\n", " ---: |".repeat(names.len()));
    let mut scenes: Vec<&str> = counts.iter().map(|count| count.scene.as_str()).collect();
    scenes.dedup();
    for scene in scenes {
        let of = |name: &str| counts.iter().find(|c| c.scene == scene && c.renderer == name);
        let kind = match scene.as_bytes().first() {
            Some(b'F' | b'b') => "pixel",
            Some(b'S') => "triangle",
            _ => "frame",
        };
        table += &format!("| {scene} | {kind} |");
        for name in &names {
            let cell = of(name).map(|count| {
                let figure = match kind {
                    "pixel" => format!("{:.2}", count.instructions / PIXELS),
                    "triangle" => format!("{:.0}", count.instructions / count.triangles),
                    _ => format!("{:.2} M", count.instructions / 1e6),
                };
                // A picture of which a tenth is otherwise is another scene's.
                if count.different < 100.0 {
                    figure
                } else {
                    format!("{figure} \\*")
                }
            });
            table += &format!(" {} |", cell.unwrap_or_default());
        }
        table.push('\n');
    }
    table
}

/// Writes the table of the board anew.
pub(crate) fn write_board(page: &Path, counts: &[Count]) -> anyhow::Result<()> {
    replace(page, "peers-board", &board_table(counts))
}

/// Puts a table between its marks.
fn replace(page: &Path, name: &str, table: &str) -> anyhow::Result<()> {
    let unreadable = || format!("{} could not be read", page.display());
    let mut text = std::fs::read_to_string(page).with_context(unreadable)?;
    let start = format!("<!-- figures {name}: made by `cargo peers`, not by hand -->\n");
    let from = text.find(&start).with_context(|| format!("no mark of {name} in the page"))?;
    let from = from + start.len();
    let end = text[from..].find("<!-- end of figures -->");
    let length = end.with_context(|| format!("no end of {name}"))?;
    text.replace_range(from..from + length, table);
    std::fs::write(page, text).with_context(|| format!("{} could not be written", page.display()))
}

/// A row for every scene and size, a column for every renderer but ours.
fn table(all: &[(Size, Vec<Comparison>)], cell: impl Fn((f64, f64)) -> String) -> String {
    let names: Vec<_> = renderers().skip(1).map(|(name, _)| name).collect();
    let mut table = format!("| | at | {} |\n", names.join(" | "));
    table += &format!("| --- | ---: |{}\n", " ---: |".repeat(names.len()));
    for (size, comparisons) in all {
        for comparison in comparisons {
            table += &format!("| {} | {}x{} |", comparison.scene, size.width, size.height);
            for name in &names {
                table += &format!(" {} |", ratio(comparison, name).map(&cell).unwrap_or_default());
            }
            table.push('\n');
        }
    }
    table
}
