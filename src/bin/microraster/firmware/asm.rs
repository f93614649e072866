//! `--asm`: the hot loops of a scene as the core executes them, with counts beside each
//! instruction.

use super::board::Board;
use super::build::House;
use super::profile::{Place, Profile, Profiler};
use std::fmt::Write as _;

/// Instructions that were executed less often than one in so many of the most executed one are
/// left out.
const COOL: u64 = 8;

/// Prints the hot loops of a scene on a board.
///
/// # Errors
/// The plugin, the firmware or the run failed.
pub(crate) fn print(house: &House, board: &Board, words: &[String]) -> Result<(), String> {
    let profile = Profiler::new(house, board)?.run(words)?;
    let Profile { instructions, taken, .. } = profile;
    println!("board={} instructions={instructions} taken={taken}", board.name);
    print!("{}", listing(&profile));
    Ok(())
}

/// The listing, in the order of addresses; `...` stands for what is not hot.
fn listing(profile: &Profile) -> String {
    let places = profile.hot(COOL);
    let mut text = String::new();
    let mut before: Option<&Place> = None;
    for place in &places {
        // Writing to a string cannot fail.
        if before.is_none_or(|before| before.function != place.function) {
            let _ = writeln!(text, "\n{:#}", rustc_demangle::demangle(&place.function));
        } else if before.is_some_and(|before| place.address - before.address > 4) {
            text.push_str("         ...\n");
        }
        let Place { count, address, text: instruction, .. } = place;
        let share = *count as f64 * 100.0 / profile.instructions.max(1) as f64;
        let _ = writeln!(text, "{count:>12} {share:6.2}%  {address:08x}  {instruction}");
        before = Some(place);
    }
    let listed: u64 = places.iter().map(|place| place.count).sum();
    let share = listed as f64 * 100.0 / profile.instructions.max(1) as f64;
    let _ = writeln!(text, "\n{share:.1} % of all instructions are listed");
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hot_instructions_are_listed_in_order_with_gaps() {
        let place = |count, address, function: &str| Place {
            count,
            address,
            text: format!("i{address:x}"),
            function: function.to_owned(),
        };
        let places = vec![
            place(800, 0x20, "f"),
            place(799, 0x22, "f"),
            place(99, 0x26, "f"),
            place(100, 0x28, "f"),
            place(200, 0x10, "e"),
        ];
        let text = listing(&Profile { instructions: 2000, taken: 0, places });
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(
            lines,
            [
                "",
                "e",
                "         200  10.00%  00000010  i10",
                "",
                "f",
                "         800  40.00%  00000020  i20",
                "         799  39.95%  00000022  i22",
                "         ...",
                "         100   5.00%  00000028  i28",
                "",
                "95.0 % of all instructions are listed",
            ]
        );
    }
}
