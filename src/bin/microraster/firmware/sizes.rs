//! `--sizes`: what the size proofs weigh, by the kind of code.

use super::board::Board;
use super::build::House;
use super::elf::{Elf, Symbol};
use super::figures::Figures;
use std::path::Path;

/// The examples that are weighed, each adding to the one before it.
const PROOFS: [&str; 3] = ["size_flat", "size_gouraud", "size_two"];

/// Kinds of code, in the order of the table's columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// This crate and the example.
    Own,
    /// What is used of the core library.
    Core,
    /// Exception vectors and what runs before `main`.
    Runtime,
    /// What only a panic reaches.
    Panic,
    /// Soft floats, divisions and memory functions that the compiler calls.
    Builtins,
}

impl Kind {
    /// What a symbol is, by its plain name.
    fn of(symbol: &Symbol) -> Self {
        let name = format!("{:#}", rustc_demangle::demangle(&symbol.name));
        let has = |parts: &[&str]| parts.iter().any(|part| name.contains(part));
        let starts = |parts: &[&str]| parts.iter().any(|part| name.starts_with(part));
        let own = has(&["microraster::", "size_", "budget::"]);
        if symbol.section.starts_with(".vector") || symbol.section.starts_with(".trap") {
            Self::Runtime
        } else if has(&["core::panicking", "rust_begin_unwind"])
            || (!own && has(&["panic", "unwrap_failed", "expect_failed", "_fail"]))
        {
            Self::Panic
        } else if starts(&["compiler_builtins::", "<compiler_builtins"])
            || starts(&["__aeabi_", "mem", "__mul", "__div", "__udiv", "__mod", "__umod"])
            || starts(&["__add", "__sub", "__float", "__fix", "__clz", "__ash", "__lsh", "__cmp"])
        {
            Self::Builtins
        } else if !own
            && (has(&["cortex_m_rt", "riscv_rt"])
                || starts(&["Reset", "main", "HardFault", "DefaultHandler", "DefaultPreInit"])
                || starts(&["_start", "_default", "_setup", "_continue", "_dispatch", "__pre"])
                || starts(&["__EXCEPTIONS", "__INTERRUPTS", "__RESET", "ExceptionHandler"]))
        {
            Self::Runtime
        } else if !own && starts(&["core::", "<core::", "<&", "<u", "<i"]) {
            Self::Core
        } else {
            Self::Own
        }
    }
}

/// Bytes of flash by kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Weights {
    pub(crate) own: u32,
    pub(crate) core: u32,
    pub(crate) runtime: u32,
    pub(crate) panic: u32,
    pub(crate) builtins: u32,
    /// What no symbol names: constants, padding, the vectors' fixed part.
    pub(crate) rest: u32,
}

impl Weights {
    /// Weighs a file.
    pub(crate) fn of(elf: &Elf) -> Self {
        let mut weights = Self::default();
        for symbol in &elf.symbols {
            *match Kind::of(symbol) {
                Kind::Own => &mut weights.own,
                Kind::Core => &mut weights.core,
                Kind::Runtime => &mut weights.runtime,
                Kind::Panic => &mut weights.panic,
                Kind::Builtins => &mut weights.builtins,
            } += symbol.size;
        }
        // The vector table counts as runtime in full, also what no symbol names.
        let vectors = |name: &str| name.starts_with(".vector");
        let table: u32 = elf.sections.iter().filter(|s| vectors(&s.name)).map(|s| s.size).sum();
        let named = elf.symbols.iter().filter(|s| vectors(&s.section)).map(|s| s.size).sum();
        weights.runtime += table.saturating_sub(named);
        let listed =
            weights.own + weights.core + weights.runtime + weights.panic + weights.builtins;
        weights.rest = elf.flash().saturating_sub(listed);
        weights
    }

    /// What the crate answers for: not vectors and runtime, panics and builtins.
    fn counted(self) -> u32 {
        self.own + self.core + self.rest
    }
}

/// What the proofs weigh on a board: what each is for, and its bytes.
///
/// # Errors
/// A build failed, a file cannot be read, or a proof links a heap.
pub(crate) fn figures(house: &House, board: &Board) -> Result<Vec<(String, u32)>, String> {
    let (mut figures, mut before) = (Vec::new(), 0);
    for proof in PROOFS {
        let elf = proof_elf(house, board, proof)?;
        let weight = match proof {
            "size_two" => elf.flash().saturating_sub(before),
            _ => Weights::of(&elf).counted(),
        };
        let what = match proof {
            "size_flat" => "flash of flat triangles, bytes",
            "size_gouraud" => "flash of Gouraud with depth, bytes",
            _ => "flash of a second shader and state, bytes",
        };
        figures.push((what.to_owned(), weight));
        before = elf.flash();
    }
    Ok(figures)
}

/// Builds a proof; it must not link a heap.
fn proof_elf(house: &House, board: &Board, proof: &str) -> Result<Elf, String> {
    read(&house.example(proof, board)?, proof, board)
}

/// Reads a file, which must not link a heap.
///
/// # Errors
/// The file cannot be read, or links a heap.
pub(crate) fn read(file: &Path, proof: &str, board: &Board) -> Result<Elf, String> {
    let bytes = std::fs::read(file).map_err(|why| format!("{}: {why}", file.display()))?;
    let elf = Elf::read(&bytes)?;
    match elf.allocator() {
        Some(name) => Err(format!("{proof} on {} links a heap: {name}", board.name)),
        None => Ok(elf),
    }
}

/// Builds and weighs the proofs; with `verbose`, every symbol too.
///
/// # Errors
/// A build failed, a file cannot be read, or a proof links a heap.
pub(crate) fn print(house: &House, boards: &[&Board], verbose: bool) -> Result<(), String> {
    println!(
        "{:5} {:14} {:>8} {:>8} {:>8} {:>10} {:>8} {:>8} {:>9} {:>8}",
        "board",
        "example",
        "counted",
        "own",
        "core",
        "constants",
        "runtime",
        "panic",
        "builtins",
        "flash"
    );
    for board in boards {
        let mut before = None;
        for proof in PROOFS {
            let elf = proof_elf(house, board, proof)?;
            if proof == "size_flat" {
                contains_nothing_else(&elf, board)?;
            }
            let weights = Weights::of(&elf);
            println!(
                "{:5} {proof:14} {:8} {:8} {:8} {:10} {:8} {:8} {:9} {:8}",
                board.name,
                weights.counted(),
                weights.own,
                weights.core,
                weights.rest,
                weights.runtime,
                weights.panic,
                weights.builtins,
                elf.flash()
            );
            if proof == "size_two" {
                let more = before.map_or(0, |one| i64::from(elf.flash()) - i64::from(one));
                println!("board={} second_combination={more}", board.name);
            }
            before = Some(elf.flash());
            if verbose {
                symbols(&elf);
            }
        }
    }
    Ok(())
}

/// Every symbol, the largest first.
fn symbols(elf: &Elf) {
    let mut symbols: Vec<_> = elf.symbols.iter().collect();
    symbols.sort_by(|a, b| b.size.cmp(&a.size).then_with(|| a.name.cmp(&b.name)));
    for symbol in symbols {
        let kind = format!("{:?}", Kind::of(symbol)).to_lowercase();
        println!("    {:6} {kind:9} {:#}", symbol.size, rustc_demangle::demangle(&symbol.name));
    }
}

/// What is weighed one at a time, as `examples/size_feature.rs` names it.
const FEATURES: [&str; 38] = [
    "depth",
    "constant depth",
    "read-only depth",
    "polygon offset",
    "depth range",
    "stencil",
    "gouraud",
    "lambert",
    "point light",
    "blinn-phong",
    "phong",
    "matcap",
    "nearest texture",
    "bilinear texture",
    "affine texture",
    "texture every 16",
    "exact texture",
    "mip-mapped texture",
    "fog at vertices",
    "fog at fragments",
    "alpha blending",
    "multiply blending",
    "dither 4x4",
    "dither 8x8",
    "colour mask",
    "indexed",
    "planes of triangles",
    "strip",
    "lines",
    "midpoint lines",
    "wide lines",
    "stippled lines",
    "rectangular lines",
    "smooth lines",
    "wireframe",
    "points",
    "supersampling",
    "counting",
];

/// Parts of names that belong to one feature or another: flat triangles contain none of them.
const FOREIGN: [&str; 17] = [
    "texture",
    "lighting",
    "fog",
    "phong",
    "matcap",
    "perspective",
    "blend",
    "dither",
    "color_mask",
    "depth_state",
    "stencil",
    "::line::",
    "::point",
    "resolve",
    "smooth_color",
    "facing",
    "counter",
];

/// Names of what is not asked for, which stand in types beside the others.
const DEFAULTS: [&str; 5] = [
    "blend::Replace",
    "dither::Undithered",
    "color_mask::AllChannels",
    "counter::Uncounted",
    "environment::Modulate",
];

/// Flat triangles must contain no function of another feature.
fn contains_nothing_else(flat: &Elf, board: &Board) -> Result<(), String> {
    match foreign(flat, &FOREIGN) {
        Some(what) => Err(format!("flat triangles on {} contain {what}", board.name)),
        None => Ok(()),
    }
}

/// The first function of this crate whose name contains one of the parts, as `part: name`.
pub(super) fn foreign(elf: &Elf, parts: &[&str]) -> Option<String> {
    elf.symbols.iter().filter(|symbol| Kind::of(symbol) == Kind::Own).find_map(|symbol| {
        let mut name = format!("{:#}", rustc_demangle::demangle(&symbol.name));
        for default in DEFAULTS {
            name = name.replace(default, "");
        }
        let part = parts.iter().find(|part| name.contains(*part))?;
        Some(format!("{part}: {name}"))
    })
}

/// Weighs each feature alone, as bytes of flash more than flat triangles, and puts them into a
/// table.
///
/// # Errors
/// A build failed, a file cannot be read or links a heap, or flat triangles contain code of another
/// feature.
pub(crate) fn features(house: &House, board: &Board, figures: &mut Figures) -> Result<(), String> {
    figures.board(board.name);
    let weigh = |feature: &str| {
        let file = house.example_of("size_feature", feature, board)?;
        read(&file, feature, board)
    };
    let flat = weigh("flat")?;
    contains_nothing_else(&flat, board)?;
    println!("board={} feature=flat flash={}", board.name, flat.flash());
    figures.put("flat triangles, all", flat.flash().to_string());
    for feature in FEATURES {
        let more = i64::from(weigh(feature)?.flash()) - i64::from(flat.flash());
        println!("board={} feature={feature:?} more={more}", board.name);
        figures.put(feature, more.to_string());
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kind(name: &str) -> Kind {
        Kind::of(&Symbol { name: name.into(), section: ".text".into(), size: 4 })
    }

    #[test]
    fn symbols_are_told_apart_by_their_names() {
        assert_eq!(kind("_ZN11microraster6raster5spans4next17h0123456789abcdefE"), Kind::Own);
        assert_eq!(kind("_ZN4core9panicking5panic17h0123456789abcdefE"), Kind::Panic);
        assert_eq!(kind("rust_begin_unwind"), Kind::Panic);
        assert_eq!(kind("_ZN11microraster5depth10depth_fail17h0123456789abcdefE"), Kind::Own);
        assert_eq!(kind("__aeabi_fmul"), Kind::Builtins);
        assert_eq!(kind("memset"), Kind::Builtins);
        assert_eq!(kind("Reset"), Kind::Runtime);
        assert_eq!(kind("_ZN4core3fmt5write17h0123456789abcdefE"), Kind::Core);
    }

    #[test]
    fn what_no_symbol_names_is_constants() {
        let section = |name: &str, size| super::super::elf::Section {
            name: name.into(),
            size,
            stored: true,
            writable: false,
        };
        let elf = Elf {
            sections: vec![section(".vector_table", 64), section(".text", 100)],
            symbols: vec![Symbol { name: "draw".into(), section: ".text".into(), size: 90 }],
            names: Vec::new(),
        };
        let weights = Weights::of(&elf);
        assert_eq!((weights.own, weights.runtime, weights.rest), (90, 64, 10));
        assert_eq!(weights.counted(), 100);
    }
}
