//! Where the scenes lie.

use std::io::Write;
use std::path::{Path, PathBuf};

/// The folder of scenes.
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
pub(crate) fn say(line: &str) {
    // Where nobody listens, nobody misses it.
    let _ = writeln!(std::io::stderr(), "conformance: {line}");
}

/// The scenes of the folder, by name; at least one.
pub(crate) fn scenes() -> Vec<PathBuf> {
    let folder = folder();
    let entries = std::fs::read_dir(&folder).expect("the folder of scenes can be read");
    let mut scenes: Vec<PathBuf> = entries
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|extension| extension == "scene"))
        .collect();
    scenes.sort();
    assert!(!scenes.is_empty(), "no scenes in {}", folder.display());
    scenes
}
