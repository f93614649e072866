//! The settings with the least error that fit a budget.

use std::fmt::Write as _;

use crate::case::Case;
use crate::costs::BOARDS;
use crate::drawing;
use crate::report::is_traded;
use crate::row::Row;
use crate::table::{millions, number};
use crate::truth::Key;

/// One way to set every knob of a scene.
#[derive(Clone, Debug)]
struct Choice<'a> {
    /// Of each knob, or pair of knobs, the row.
    rows: Vec<&'a Row>,
    /// What it costs, were costs to add up.
    instructions: f64,
    /// The square of the difference from the ideal, were squares to add up.
    square: f64,
    memory: usize,
}

impl Choice<'_> {
    /// Whether it asks for bands of samples in bands of rows: samples have bands of their own.
    fn is_banded_twice(&self) -> bool {
        let is_set = |knob: &str| {
            self.rows.iter().any(|row| row.case.knob() == knob && !row.case.is_default())
        };
        is_set("samples") && is_set("rows")
    }
}

/// A budget such as `2M`, `850k` or a plain number: of instructions a frame, or of bytes.
///
/// # Errors
/// Anything else.
pub(crate) fn budget(text: &str) -> Result<u64, String> {
    let lower = text.to_lowercase();
    let (digits, unit) = match lower.strip_suffix('m') {
        Some(digits) => (digits, 1e6),
        None => lower.strip_suffix('k').map_or((lower.as_str(), 1.0), |digits| (digits, 1e3)),
    };
    match digits.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok((number * unit) as u64),
        _ => Err(format!("`{text}` is no budget: say 2M, 850k or 2000000")),
    }
}

/// The scenes that there are.
fn scenes() -> String {
    let mut names: Vec<String> =
        drawing::all().filter_map(|scene| Case::parse(scene.name)).map(|case| case.scene).collect();
    names.sort();
    names.dedup();
    names.retain(|name| name != "range");
    format!("choose from {}", names.join(", "))
}

/// What is recommended for a scene, as text: at most `budget` instructions a frame and `memory`
/// bytes of buffers.
///
/// # Errors
/// A scene that is not there, or that has no settings to choose.
pub(crate) fn advise(
    rows: &[Row],
    scene: &str,
    board: usize,
    budget: u64,
    memory: usize,
) -> Result<String, String> {
    let of_scene = || rows.iter().filter(|row| row.case.scene == scene);
    let Some(base) = of_scene().find(|row| row.case.is_default() && is_traded(&row.case)) else {
        return Err(format!("there is nothing to choose in a scene `{scene}`; {}", scenes()));
    };
    // A scene may be shown in several ways, as in colours instead of a texture: the first counts.
    let ideal = Key::ideal(&base.case);
    let alike: Vec<&Row> = of_scene().filter(|row| Key::ideal(&row.case) == ideal).collect();
    let choices = choices(&knobs(&alike), base, board);
    let name = BOARDS.get(board).map_or("", |(_, name)| name);
    let fits: Vec<&Choice<'_>> = choices
        .iter()
        .filter(|choice| choice.instructions <= budget as f64 && choice.memory <= memory)
        .filter(|choice| !choice.is_banded_twice())
        .collect();
    let least = fits.iter().map(|choice| choice.square).fold(f64::MAX, f64::min);
    // What differs by less than this is not seen: then the defaults, and what is cheaper.
    let is_as_good = |choice: &&&Choice<'_>| choice.square.sqrt() <= least.sqrt() * 1.01;
    let changes =
        |choice: &Choice<'_>| choice.rows.iter().filter(|row| !row.case.is_default()).count();
    let better = |a: &&&Choice<'_>, b: &&&Choice<'_>| {
        changes(a).cmp(&changes(b)).then(a.instructions.total_cmp(&b.instructions))
    };
    let mut text = format!("{scene} on {name}, {} instructions a frame\n", millions(budget));
    let Some(best) = fits.iter().filter(is_as_good).min_by(better) else {
        let cheapest = choices.iter().min_by(|a, b| a.instructions.total_cmp(&b.instructions));
        let least = cheapest.map_or(0.0, |choice| choice.instructions);
        let smallest = choices.iter().map(|choice| choice.memory).min().unwrap_or(0);
        let _ = writeln!(
            text,
            "nothing fits: the least is {} instructions, and {smallest} bytes of buffers",
            millions(least as u64)
        );
        return Ok(text);
    };
    for row in &best.rows {
        let mark = if row.case.is_default() { "  (the default)" } else { "" };
        let _ = writeln!(text, "  {:14} {}{mark}", row.case.knob(), row.case.setting());
    }
    let _ = writeln!(
        text,
        "about {} instructions, {} off the ideal picture (root mean square of 255), {} bytes of \
         buffers",
        millions(best.instructions as u64),
        number(best.square.sqrt()),
        best.memory
    );
    let _ = writeln!(
        text,
        "the defaults: {} instructions, {} off",
        millions(base.cost.instructions[board]),
        number(base.errors.from_ideal)
    );
    if changes(best) > 1 {
        text.push_str(
            "Costs and squared errors of single changes were added up; draw it to know.\n",
        );
    }
    Ok(text)
}

/// The rows of each knob that can be set by itself; a pair takes the place of its two knobs.
fn knobs<'a>(rows: &[&'a Row]) -> Vec<Vec<&'a Row>> {
    let mut groups: Vec<Vec<&'a Row>> = Vec::new();
    for row in rows {
        match groups.iter_mut().find(|group| group[0].case.knobs == row.case.knobs) {
            Some(group) => group.push(row),
            None => groups.push(vec![row]),
        }
    }
    let pairs: Vec<Case> =
        groups.iter().filter(|g| g[0].case.knobs.len() > 1).map(|g| g[0].case.clone()).collect();
    let in_pair = |group: &Vec<&Row>| {
        let own = &group[0].case.knobs;
        own.len() == 1 && pairs.iter().any(|pair| pair.knobs.contains(&own[0]))
    };
    groups.retain(|group| !in_pair(group) && group.iter().any(|row| row.case.is_default()));
    groups
}

fn choices<'a>(knobs: &[Vec<&'a Row>], base: &Row, board: usize) -> Vec<Choice<'a>> {
    let square = |row: &Row| row.errors.from_ideal.powi(2);
    let mut all = vec![Choice {
        rows: Vec::new(),
        instructions: base.cost.instructions[board] as f64,
        square: square(base),
        memory: base.memory,
    }];
    for rows in knobs {
        let Some(own) = rows.iter().find(|row| row.case.is_default()) else { continue };
        all = all
            .iter()
            .flat_map(|choice| {
                rows.iter().map(move |row| {
                    let [cost, before] = [row, own].map(|row| row.cost.instructions[board] as f64);
                    Choice {
                        rows: choice.rows.iter().copied().chain([*row]).collect(),
                        instructions: choice.instructions + cost - before,
                        square: (choice.square + square(row) - square(own)).max(0.0),
                        memory: (choice.memory + row.memory).saturating_sub(own.memory),
                    }
                })
            })
            .collect();
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn budgets_are_read() {
        for (text, number) in [("2M", 2_000_000), ("850k", 850_000), ("1.5m", 1_500_000), ("7", 7)]
        {
            assert_eq!(budget(text), Ok(number), "{text}");
        }
        for text in ["", "M", "-2M", "0", "nan", "2G", "inf"] {
            assert!(budget(text).is_err(), "{text}");
        }
    }
}
