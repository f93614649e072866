//! docs/TRADEOFF.md and the CSV file.

use std::fmt::Write as _;

use crate::costs::{Costs, BOARDS};
use crate::errors::Spread;
use crate::report::is_traded;
use crate::row::{is_on_front, Row};

/// A column: its head, and what it says of a row.
type Column = (String, fn(&Row, usize) -> String, usize);

fn spread(spread: Option<Spread>) -> String {
    spread.map_or(String::new(), |s| format!("{} / {}", number(s.mean), number(s.max)))
}

/// Three digits that count.
pub(crate) fn number(v: f64) -> String {
    match v.abs() {
        0.0 => "0".into(),
        v if v < 1e-3 => format!("{v:.0e}"),
        v if v < 0.1 => format!("{v:.3}"),
        v if v < 10.0 => format!("{v:.2}"),
        v if v < 100.0 => format!("{v:.1}"),
        _ => format!("{v:.0}"),
    }
}

pub(crate) fn millions(count: u64) -> String {
    match count {
        0..=99_999 => format!("{:.1} k", count as f64 / 1e3),
        100_000..=999_999 => format!("{:.0} k", count as f64 / 1e3),
        _ => format!("{:.2} M", count as f64 / 1e6),
    }
}

fn decibels(psnr: f64) -> String {
    if psnr.is_finite() {
        format!("{psnr:.1}")
    } else {
        "exact".into()
    }
}

/// All columns; those that say nothing, or the same of every row, are left out of a table.
fn columns() -> Vec<Column> {
    let mut columns: Vec<Column> = vec![
        (
            "coverage, pixels".into(),
            |r, _| r.errors.coverage.map_or(String::new(), |n| n.to_string()),
            0,
        ),
        ("depth, codes".into(), |r, _| spread(r.errors.codes), 0),
        ("depth, units".into(), |r, _| spread(r.errors.units), 0),
        ("texels".into(), |r, _| spread(r.errors.texels), 0),
        (
            "colour".into(),
            |r, _| format!("{} / {}", number(r.errors.color.mean), number(r.errors.color.max)),
            0,
        ),
        ("PSNR".into(), |r, _| decibels(r.errors.color.psnr), 0),
        (
            "beyond a step".into(),
            |r, _| format!("{:.2} %", r.errors.color.beyond_a_step * 100.0),
            0,
        ),
        ("from afar".into(), |r, _| decibels(r.errors.from_afar), 0),
        ("from ideal".into(), |r, _| number(r.errors.from_ideal), 0),
    ];
    for (board, (_, name)) in BOARDS.iter().enumerate() {
        columns.push((
            (*name).to_owned(),
            |row, board| {
                let count = row.cost.instructions[board];
                let by = |parts: u64| count as f64 / parts.max(1) as f64;
                let pixel = number(by(row.pixels));
                if row.triangles > 16 {
                    format!("{} ({pixel}, {})", millions(count), number(by(row.triangles.into())))
                } else {
                    format!("{} ({pixel})", millions(count))
                }
            },
            board,
        ));
    }
    columns.push(("RAM".into(), |r, _| r.memory.to_string(), 0));
    columns.push(("flash".into(), |r, _| r.flash.map_or(String::new(), |b| format!("{b:+}")), 0));
    columns
}

/// One knob in one scene.
pub(crate) fn table(rows: &[&Row]) -> String {
    let says = |column: &Column| {
        let cells: Vec<_> = rows.iter().map(|row| column.1(row, column.2)).collect();
        let always = column.0 == "PSNR" || BOARDS.iter().any(|(_, name)| *name == column.0);
        let differs = cells.iter().any(|cell| Some(cell) != cells.first());
        always || (differs && cells.iter().any(|cell| !cell.is_empty()))
    };
    let columns: Vec<Column> = columns().into_iter().filter(says).collect();
    let mut text = String::from("| setting |");
    // Writing to a string cannot fail.
    for (head, ..) in &columns {
        let _ = write!(text, " {head} |");
    }
    let _ = write!(text, "\n| --- |{}", " ---: |".repeat(columns.len()));
    for row in rows {
        let mark = if row.case.is_default() { "**" } else { "" };
        let is_beaten = is_traded(&row.case) && !is_on_front(row, rows, Row::error);
        let front = if is_beaten { " ○" } else { "" };
        let _ = write!(text, "\n| {mark}{}{mark}{front} |", row.case.setting());
        for (_, cell, board) in &columns {
            let _ = write!(text, " {} |", cell(row, *board));
        }
    }
    text
}

/// Every number of every case.
pub(crate) fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "case,default,coverage,depth_codes_mean,depth_codes_max,depth_units_mean,depth_units_max,\
         texels_mean,texels_max,colour_mean,colour_max,psnr,beyond_a_step,psnr_from_afar,\
         rms_from_ideal,ram,flash,pixels,triangles",
    );
    for (board, _) in BOARDS {
        let _ = write!(text, ",{board}");
    }
    for row in rows {
        let errors = &row.errors;
        let two = |spread: Option<Spread>| {
            spread.map_or(",".into(), |s| format!("{:.6},{:.6}", s.mean, s.max))
        };
        let _ = write!(
            text,
            "\n{},{},{},{},{},{},{:.4},{:.4},{:.3},{:.6},{:.3},{:.4},{},{},{},{}",
            row.case.name(),
            row.case.is_default(),
            errors.coverage.map_or(String::new(), |n| n.to_string()),
            two(errors.codes),
            two(errors.units),
            two(errors.texels),
            errors.color.mean,
            errors.color.max,
            errors.color.psnr,
            errors.color.beyond_a_step,
            errors.from_afar,
            errors.from_ideal,
            row.memory,
            row.flash.map_or(String::new(), |bytes| bytes.to_string()),
            row.pixels,
            row.triangles
        );
        for count in row.cost.instructions {
            let _ = write!(text, ",{count}");
        }
    }
    text + "\n"
}

/// Where the counts come from.
pub(crate) fn source(costs: &Costs) -> String {
    format!("counted on commit {} with {}", costs.commit, costs.compiler)
}
