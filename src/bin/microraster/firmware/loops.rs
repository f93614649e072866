//! The page of loops: what was executed in the scenes that miss a mark, so that one sees why.

use super::per::Per;
use super::profile::Profile;
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// A scene that misses its mark on a board.
pub(crate) struct Missed<'a> {
    pub(crate) board: &'a str,
    pub(crate) scene: &'a str,
    /// What the mark is of: the scene, or something that it is a part of.
    pub(crate) mark: &'a str,
    pub(crate) figure: String,
    pub(crate) most: String,
    pub(crate) per: Per,
    /// How many of what the scene is counted by.
    pub(crate) units: f64,
    pub(crate) profile: &'a Profile,
}

/// Functions of less than such a part of a scene are left out.
const SMALL: f64 = 0.01;
/// Instructions that were executed less often than one in so many of the most executed one are
/// left out.
const COOL: u64 = 2;

/// The whole page.
pub(crate) fn page(missed: &[Missed<'_>]) -> String {
    let mut text = String::from(
        "# The loops of what misses its mark\n\n\
         `cargo firmware --performance` writes this page. For each scene that takes more than was \
         asked of it ([the table](PERFORMANCE.md#against-the-marks)): its functions, by \
         instructions a pixel, triangle, vertex or frame; of scenes that are counted by pixel \
         also the loop, as the emulator disassembles it, with how often each instruction was \
         executed a pixel.\n",
    );
    if missed.is_empty() {
        text.push_str("\nNo scene does.\n");
    }
    for missed in missed {
        let Missed { board, scene, mark, figure, most, per, units, profile } = missed;
        let part = if mark == scene { String::new() } else { format!(" ({mark})") };
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\n## {scene} on {board}{part}: {figure} a {per}, at most {most}\n");
        let _ = writeln!(text, "| a {per} | function |\n| ---: | --- |");
        for (function, count) in functions(profile) {
            let _ = writeln!(text, "| {} | `{function}` |", per.text(count as f64 / units));
        }
        if scene.starts_with('F') {
            let _ = writeln!(text, "\n```text\n{}```", listing(profile, *units));
        }
    }
    text
}

/// Functions and their instructions, the largest first.
fn functions(profile: &Profile) -> Vec<(String, u64)> {
    let mut counts: BTreeMap<&str, u64> = BTreeMap::new();
    for place in &profile.places {
        *counts.entry(&place.function).or_default() += place.count;
    }
    let least = profile.instructions as f64 * SMALL;
    let mut functions: Vec<_> = counts
        .into_iter()
        .filter(|(_, count)| *count as f64 >= least)
        .map(|(function, count)| (short(function), count))
        .collect();
    functions.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    functions
}

/// A function's name without its hash, what it is generic over and where modules lie.
fn short(function: &str) -> String {
    let name = format!("{:#}", rustc_demangle::demangle(function));
    let (mut plain, mut depth) = (String::new(), 0_u32);
    for c in name.chars() {
        match c {
            // What begins a path is the type that a method is of; what follows a name is generic.
            '<' if depth == 0 && (plain.is_empty() || plain.ends_with('<')) => plain.push(c),
            '<' => depth += 1,
            '>' if depth > 0 => depth -= 1,
            _ if depth == 0 => plain.push(c),
            _ => {}
        }
    }
    let plain = plain.replace("microraster::", "").replace("::::", "::");
    plain.trim_end_matches("::").to_owned()
}

/// The loop, in the order of addresses.
fn listing(profile: &Profile, units: f64) -> String {
    let mut text = String::new();
    for place in profile.hot(COOL) {
        let each = place.count as f64 / units;
        let _ = writeln!(text, "{each:5.2}  {:08x}  {}", place.address, place.text);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::profile::Place;
    use super::*;

    fn profile() -> Profile {
        let place = |count, address, function: &str| Place {
            count,
            address,
            text: format!("i{address:x}"),
            function: function.to_owned(),
        };
        let places = vec![
            place(60, 0x22, "draw"),
            place(80, 0x20, "draw"),
            place(39, 0x24, "draw"),
            place(20, 0x10, "start"),
            place(1, 0x40, "rare"),
        ];
        Profile { instructions: 200, taken: 0, places }
    }

    #[test]
    fn what_misses_a_mark_is_shown_by_function_and_by_instruction() {
        let profile = profile();
        let missed = Missed {
            board: "m4",
            scene: "F5",
            mark: "F5",
            figure: "20.00".into(),
            most: "9.00".into(),
            per: Per::of("F5"),
            units: 10.0,
            profile: &profile,
        };
        let page = page(&[missed]);
        assert!(page.contains("## F5 on m4: 20.00 a pixel, at most 9.00"), "{page}");
        assert!(page.contains("| 17.90 | `draw` |\n| 2.00 | `start` |"), "{page}");
        assert!(!page.contains("rare"), "{page}");
        let (loop_at, rest) =
            (page.find("```text"), " 8.00  00000020  i20\n 6.00  00000022  i22\n```");
        assert!(loop_at.is_some() && page.contains(rest), "{page}");
    }

    #[test]
    fn names_lose_what_they_are_generic_over() {
        let long = "<microraster::raster::spans::Spans>::start";
        assert_eq!(short(long), "<raster::spans::Spans>::start");
        let long =
            "<microraster::pipeline::fill::Ready<microraster::shade::Flat>>::draw::<A<B>, C>";
        assert_eq!(short(long), "<pipeline::fill::Ready>::draw");
    }
}
