//! `--no-panic`: links firmware that draws with everything and looks for a way to panic in it.

use super::board::Board;
use super::build::House;
use super::elf::{references, Elf, Reference};
use std::path::Path;

/// The firmware that is looked at.
const EXAMPLE: &str = "no_panic";
/// Its variant that panics.
const PANICS: &str = "panic";

/// Parts of the names of what only a panic reaches, in the core library and the firmware.
const PARTS: [&str; 10] = [
    "core::panicking",
    "panic_fmt",
    "panic_bounds_check",
    "panic_const_",
    "panic_already_",
    "_fail::",
    "unwrap_failed",
    "expect_failed",
    "rust_begin_unwind",
    // What the example's panic handler refers to.
    "PANIC_IS_REACHABLE",
];

/// Whether a linked symbol is there for panics alone.
///
/// What the library calls its own has its name in front, and is none.
fn is_panic(symbol: &str) -> bool {
    let name = format!("{:#}", rustc_demangle::demangle(symbol));
    let name = name.trim_start_matches('<');
    // With an end to the name, so that those that end in `_fail` can be told.
    let named = format!("{name}::");
    !name.starts_with("microraster::") && PARTS.iter().any(|part| named.contains(part))
}

/// Links the firmware for each board and fails where it can panic. Of boards with one target, which
/// run the same code, the first is enough.
///
/// # Errors
/// A build failed, or something may panic: what, and who refers to it.
pub(crate) fn check(house: &House, boards: &[&'static Board]) -> Result<(), String> {
    let is_first = |number: usize| {
        let target = boards[number].target;
        boards.iter().position(|board| board.target == target) == Some(number)
    };
    let boards = boards.iter().enumerate().filter(|(number, _)| is_first(*number));
    boards.map(|(_, board)| board).try_for_each(|board| one(house, board))
}

/// Checks one board. Before its firmware, the variant that panics must be found out.
fn one(house: &House, board: &Board) -> Result<(), String> {
    if found(&house.example_with_references(EXAMPLE, PANICS, board)?)?.is_none() {
        return Err(format!(
            "the firmware of {} that reads behind an array is taken for one that cannot panic: \
             this check is worth nothing",
            board.name
        ));
    }
    let file = house.example_with_references(EXAMPLE, "", board)?;
    match found(&file)? {
        Some(ways) => Err(format!(
            "the firmware of {} may panic; `llvm-symbolizer -e {} ADDRESS` shows the line:\n{ways}",
            board.name,
            file.display()
        )),
        None => {
            println!("board={} panics=none", board.name);
            Ok(())
        }
    }
}

/// The ways to panic in a file, a line each; `None` where there are none.
fn found(file: &Path) -> Result<Option<String>, String> {
    let problem = |why: String| format!("{}: {why}", file.display());
    let bytes = std::fs::read(file).map_err(|why| problem(why.to_string()))?;
    let names = Elf::read(&bytes).map_err(problem)?.names;
    Ok(ways(&names, &references(&bytes).map_err(problem)?))
}

/// What may panic among `names`, each with who refers to it.
fn ways(names: &[String], references: &[Reference]) -> Option<String> {
    let plain = |name: &str| format!("{:#}", rustc_demangle::demangle(name));
    let mut lines = Vec::new();
    for name in names.iter().filter(|name| is_panic(name)) {
        lines.push(format!("  {}", plain(name)));
        for reference in references.iter().filter(|reference| reference.to == *name) {
            let (address, from) = (reference.address, plain(&reference.from));
            lines.push(format!("    from {address:#x} in {from}"));
        }
    }
    (!lines.is_empty()).then(|| lines.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_are_told_by_their_names() {
        for panic in [
            "_RNvNtNtCscC3515bCoUh_4core9panicking11panic_const23panic_const_div_by_zero",
            "_ZN4core9panicking18panic_bounds_check17h0123456789abcdefE",
            "_ZN4core6option13unwrap_failed17h0123456789abcdefE",
            "_ZN4core6result13unwrap_failed17h0123456789abcdefE",
            "_ZN4core6option13expect_failed17h0123456789abcdefE",
            "_ZN4core5slice5index16slice_index_fail17h0123456789abcdefE",
            "_ZN4core5slice5index26slice_start_index_len_fail17h0123456789abcdefE",
            "_ZN4core4cell22panic_already_borrowed17h0123456789abcdefE",
            "rust_begin_unwind",
            "_RNvNtCs30HDsCAPNyL_8no_panic8firmware18PANIC_IS_REACHABLE",
        ] {
            assert!(is_panic(panic), "{panic}");
        }
        for calm in [
            "_ZN11microraster5depth10depth_fail17h0123456789abcdefE",
            "_ZN8no_panic8textures4show17h0123456789abcdefE",
            "_RNvNtCs30HDsCAPNyL_8no_panic8textures4draw",
            "Reset",
        ] {
            assert!(!is_panic(calm), "{calm}");
        }
    }

    #[test]
    fn a_way_to_panic_says_who_takes_it() {
        let names = ["draw", "rust_begin_unwind"].map(String::from);
        let reference = Reference { address: 64, from: "draw".into(), to: names[1].clone() };
        assert_eq!(
            ways(&names, &[reference]).as_deref(),
            Some("  rust_begin_unwind\n    from 0x40 in draw")
        );
        assert_eq!(ways(&names[..1], &[]), None, "drawing is no panic");
    }
}
