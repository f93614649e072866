//! How many cases are tried, and what is said about it.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, OnceLock, PoisonError};
use std::time::Instant;

use crate::support::Random;

/// Tells the run with many cases from the plain one.
const THOROUGH: &str = "MICRORASTER_EXTREMES";
const WRITE: &str = "MICRORASTER_WRITE_FIGURES";
const BEGIN: &str = "<!-- robustness: made by `cargo extremes`, not by hand -->";
const END: &str = "<!-- end of robustness -->";

/// What is tried on many cases, in the order of the table. What is exhaustive tries all there are
/// in the thorough run.
const PROPERTIES: [(&str, Kind); 18] = [
    ("coverage is the definition's, in all size classes", Kind::Random),
    ("coverage at the ends of the range and of slivers", Kind::Random),
    ("coverage of all triangles on the half pixels of 8x8", Kind::Exhaustive),
    ("order of corners, winding and culling change no pixel", Kind::Random),
    ("order of indices changes no pixel, through clipping", Kind::Random),
    ("shared edges are drawn once, up to the guard box", Kind::Random),
    ("shared edges are drawn once, through any camera and in bands", Kind::Random),
    ("planes are within their bound", Kind::Random),
    ("depth and colour are within their bound", Kind::Random),
    ("scissors and bands change no pixel", Kind::Random),
    ("points lie where clip coordinates say, w from 1 to 2^30", Kind::Random),
    ("scenes of everything at random: no panic, same in bands", Kind::Random),
    ("floats of any bits, in every argument", Kind::Random),
    ("depth codes through encode and compare", Kind::Exhaustive),
    ("RGB565 pixels under every alpha and mode", Kind::Exhaustive),
    ("colours in every cell of both dithers", Kind::Exhaustive),
    ("reciprocals of all mantissas", Kind::Exhaustive),
    ("inverse square roots of all normalised numbers", Kind::Exhaustive),
];

/// Which numbers a property is tried on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Random,
    Exhaustive,
}

/// What came of a property.
#[derive(Clone, Copy, Debug)]
struct Tried {
    cases: u64,
    seconds: f64,
}

/// What came of all that are done, in the order of [`PROPERTIES`].
static DONE: Mutex<[Option<Tried>; PROPERTIES.len()]> = Mutex::new([None; PROPERTIES.len()]);

/// Whether this is the run with many cases.
pub(crate) fn is_thorough() -> bool {
    static IS: OnceLock<bool> = OnceLock::new();
    *IS.get_or_init(|| std::env::var_os(THOROUGH).is_some_and(|value| value == "thorough"))
}

/// Whether this run will write the README.
fn is_writing() -> bool {
    is_thorough() && std::env::var_os(WRITE).is_some()
}

/// A number of cases: for the plain run, and for the thorough one.
pub(crate) fn cases(plain: u64, thorough: u64) -> u64 {
    if is_thorough() {
        thorough
    } else {
        plain
    }
}

/// Tries a property on at least so many random cases; `check` says how many it has tried.
pub(crate) fn random(
    property: &str,
    wanted: u64,
    seed: u64,
    mut check: impl FnMut(&mut Random) -> u64,
) {
    perform(property, Kind::Random, || {
        let (mut random, mut tried) = (Random(seed), 0);
        while tried < wanted {
            tried += check(&mut random);
        }
        tried
    });
}

/// Tries a property on all cases there are, or in the plain run on some of them; `check` says how
/// many it has tried.
pub(crate) fn exhaustive(property: &str, check: impl FnOnce() -> u64) {
    perform(property, Kind::Exhaustive, check);
}

fn perform(property: &str, kind: Kind, check: impl FnOnce() -> u64) {
    let place = PROPERTIES.iter().position(|known| *known == (property, kind));
    let place = place.expect("a property of the table");
    if !cfg!(debug_assertions) {
        assert!(run_with_checks(), "the run with overflow checks failed, see above");
        return;
    }
    let start = Instant::now();
    let cases = check();
    let tried = Tried { cases, seconds: start.elapsed().as_secs_f64() };
    println!("extremes: {cases} cases, 0 failures: {property} ({:.1} s)", tried.seconds);
    let mut done = DONE.lock().unwrap_or_else(PoisonError::into_inner);
    done[place] = Some(tried);
    let all: Vec<Tried> = done.iter().copied().flatten().collect();
    if all.len() == PROPERTIES.len() {
        finish(&all);
    }
}

/// A build without overflow checks would prove less: it has the properties tried by one with them,
/// once, and all tests of this one stand or fall with that.
fn run_with_checks() -> bool {
    static RUN: OnceLock<bool> = OnceLock::new();
    *RUN.get_or_init(|| {
        let filters = std::env::args().skip(1).filter(|argument| argument != "--nocapture");
        let status = Command::new(env!("CARGO"))
            .args(["test", "--profile", "extremes", "--test", "extremes", "--"])
            .args(filters)
            .args(["--nocapture"])
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env(THOROUGH, "thorough")
            .status();
        status.is_ok_and(|status| status.success())
    })
}

/// When the last property is done: the sums, a file for programs and, if asked for, the README.
fn finish(all: &[Tried]) {
    let sum = |kind: Kind| -> u64 {
        let of_kind = PROPERTIES.iter().zip(all).filter(|((_, k), _)| *k == kind);
        of_kind.map(|(_, tried)| tried.cases).sum()
    };
    let (random, exhaustive) = (sum(Kind::Random), sum(Kind::Exhaustive));
    println!("extremes: {random} random cases and {exhaustive} exhaustive ones, 0 failures");
    assert!(!is_thorough() || random >= 100_000_000, "{random} random cases are too few");
    let file = results_file();
    std::fs::write(&file, lines(all)).expect("the build's folder can be written");
    println!("extremes: figures in {}", file.display());
    if is_writing() {
        let text = std::fs::read_to_string(readme()).expect("the README can be read");
        let text = replaced(&text, &table(all)).expect("the README has a place for the figures");
        std::fs::write(readme(), text).expect("the README can be written");
    }
}

fn results_file() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("extremes.tsv")
}

fn readme() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md")
}

/// One property a line: name, kind, cases, failures, seconds.
fn lines(all: &[Tried]) -> String {
    let mut text = String::from("property\tkind\tcases\tfailures\tseconds\n");
    for ((name, kind), Tried { cases, seconds }) in PROPERTIES.iter().zip(all) {
        let _ = writeln!(text, "{name}\t{kind:?}\t{cases}\t0\t{seconds:.2}");
    }
    text
}

/// The table of the README; who fails never gets as far as here.
fn table(all: &[Tried]) -> String {
    let mut text = String::from("| property | cases | failures |\n| --- | ---: | ---: |\n");
    for ((name, kind), tried) in PROPERTIES.iter().zip(all) {
        let all = if *kind == Kind::Exhaustive { "all " } else { "" };
        let _ = writeln!(text, "| {name} | {all}{} | 0 |", spaced(tried.cases));
    }
    let sum = |kind: Kind| {
        let of_kind = PROPERTIES.iter().zip(all).filter(|((_, k), _)| *k == kind);
        spaced(of_kind.map(|(_, tried)| tried.cases).sum())
    };
    let _ = writeln!(text, "| random cases in all | {} | 0 |", sum(Kind::Random));
    let _ = write!(text, "| exhaustive cases in all | {} | 0 |", sum(Kind::Exhaustive));
    text
}

/// A number in groups of three digits.
fn spaced(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

fn replaced(text: &str, table: &str) -> Option<String> {
    let (before, rest) = text.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{table}\n{END}{after}"))
}

#[test]
fn the_readme_has_a_row_without_failures_for_every_property() {
    if is_writing() {
        return;
    }
    let text = std::fs::read_to_string(readme()).expect("the README can be read");
    let (_, rest) = text.split_once(BEGIN).expect("figures begin");
    let (table, _) = rest.split_once(END).expect("figures end");
    for (name, _) in PROPERTIES {
        let row = table.lines().find(|row| row.starts_with(&format!("| {name} |")));
        let row = row.unwrap_or_else(|| panic!("no figure of: {name}"));
        assert!(row.ends_with("| 0 |"), "{row}");
    }
}
