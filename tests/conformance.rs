//! Replays scenes whose pictures were made by an exact reference.
//!
//! The folder is the one that `MICRORASTER_CONFORMANCE` names, or the shared one beside a working
//! copy. Without either, the few scenes that the project holds are replayed; where
//! `MICRORASTER_REQUIRE_SHARED` is set, that is a failure.
//!
//! What the crate cannot do yet is left out of the comparison: colours of textures, of blending
//! and of perspective-correct varyings, attributes of lines, and depth tests that do not write. A
//! line on standard error says how many scenes that concerns, by reason; `cargo test --test
//! conformance -- --nocapture` shows every scene.

#[path = "conformance/expected.rs"]
mod expected;
#[path = "conformance/replay.rs"]
mod replay;
#[path = "conformance/scene.rs"]
mod scene;

use std::collections::BTreeMap;
use std::io::Write;
use std::path::{Path, PathBuf};

use expected::Expected;
use replay::{is_in_range, replay, Limits};
use scene::Scene;

/// Where the scenes lie.
fn folder() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    if let Some(named) = std::env::var_os("MICRORASTER_CONFORMANCE") {
        return named.into();
    }
    let shared = root.join("../shared/conformance");
    if shared.is_dir() {
        return shared;
    }
    let required = std::env::var_os("MICRORASTER_REQUIRE_SHARED").is_some();
    assert!(!required, "the shared conformance scenes are required, and missing");
    say("no conformance folder: only the scenes that the project holds are replayed");
    root.join("tests/conformance/scenes")
}

/// Writes a line that is seen although the test passes: it is not printed, which would be kept.
fn say(line: &str) {
    // Where nobody listens, nobody misses it.
    let _ = writeln!(std::io::stderr(), "conformance: {line}");
}

/// How many scenes something is left out of, by what and why.
type LeftOut = BTreeMap<String, usize>;

/// What is wrong with the picture of a scene, or nothing.
fn check(path: &Path, all_left_out: &mut LeftOut) -> Result<String, String> {
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
    let scene = Scene::parse(&text)?;
    let bytes = std::fs::read(path.with_extension("exp")).map_err(|error| error.to_string())?;
    let expected = Expected::parse(&bytes).ok_or("the expected picture cannot be read")?;
    let limits = Limits::of(&scene);
    let report = replay(&scene, &expected, limits);
    let left_out =
        [limits.color.map(|why| ("colours", why)), limits.depth.map(|why| ("depth", why))];
    let mut facts = format!("{report:?}");
    for (what, why) in left_out.into_iter().flatten() {
        facts += &format!("; {what} not compared: {why}");
        *all_left_out.entry(format!("{what} ({why})")).or_default() += 1;
    }
    // Corners are rounded to codes and so is each pixel, half a code each; a plane's own error is
    // at most a sixteenth of a code.
    let deep = report.depth > 1.0 + 0.0625;
    let wrong = report.coverage + report.counts + report.primitives > 0
        || deep
        || report.color > 1
        || report.compared == 0
        || (report.skipped > 0 && is_in_range(&scene));
    if wrong {
        Err(facts)
    } else {
        Ok(facts)
    }
}

#[test]
fn scenes_look_as_the_reference_says() {
    let folder = folder();
    let entries = std::fs::read_dir(&folder).expect("the folder of scenes can be read");
    let mut scenes: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "scene"))
        .collect();
    scenes.sort();
    assert!(!scenes.is_empty(), "no scenes in {}", folder.display());
    let (mut wrong, mut left_out) = (0, LeftOut::new());
    for path in &scenes {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match check(path, &mut left_out) {
            Ok(facts) => println!("{name}: right, {facts}"),
            Err(facts) => {
                println!("{name}: WRONG, {facts}");
                wrong += 1;
            }
        }
    }
    let left_out: Vec<String> =
        left_out.iter().map(|(what, scenes)| format!("{what} of {scenes}")).collect();
    let left_out = if left_out.is_empty() { "nothing".into() } else { left_out.join(", ") };
    say(&format!("{} scenes replayed; not compared: {left_out}", scenes.len()));
    assert_eq!(wrong, 0, "of {} scenes these are wrong", scenes.len());
}
