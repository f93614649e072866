//! Replays scenes whose pictures were made by an exact reference.
//!
//! The folder is the one that `MICRORASTER_CONFORMANCE` names, or the shared one beside a working
//! copy. Without either, the few scenes that the project holds are replayed; where
//! `MICRORASTER_REQUIRE_SHARED` is set, that is a failure.
//!
//! `cargo test --test conformance -- --nocapture` shows every scene.

#[path = "conformance/expected.rs"]
mod expected;
#[path = "conformance/folder.rs"]
mod folder;
#[path = "conformance/replay.rs"]
mod replay;
#[path = "conformance/scene.rs"]
mod scene;

use std::path::Path;

use expected::Expected;
use folder::{say, scenes};
use replay::{is_in_range, replay};
use scene::{Kind, Scene};

/// What is wrong with the picture of a scene, or nothing.
fn check(path: &Path) -> Result<String, String> {
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
    let scene = Scene::parse(&text)?;
    let bytes = std::fs::read(path.with_extension("exp")).map_err(|error| error.to_string())?;
    let expected = Expected::parse(&bytes).ok_or("the expected picture cannot be read")?;
    let report = replay(&scene, &expected);
    let facts = format!("{report:?}");
    // Each primitive is blended with what is stored in 8 bits, the reference rounds once.
    let blends = scene.draws.iter().any(|draw| draw.setting("blend") != "none");
    // Lines may run differently along their attributes: by up to 15 % of the range on short ones.
    let lines = scene.draws.iter().any(|draw| draw.kind == Kind::Lines);
    // Places between texels are rounded to 1/256 of the way.
    let filters = scene.texture.as_ref().is_some_and(|texels| texels.is_linear);
    // Quotients are made of 16 bits: where w differs a thousandfold, few of them are left of 1 / w.
    let far = scene.draws.iter().flat_map(|draw| draw.primitives()).any(|corners| {
        let w = || corners.iter().map(|corner| corner.position[3]);
        !scene.clip && w().fold(0.0, f32::max) > 1000.0 * w().fold(f32::MAX, f32::min)
    });
    let color = if lines { 38 } else { 1 + i32::from(blends || filters || far) };
    // Corners are rounded to codes and so is each pixel, half a code each; a plane's own error is
    // at most a sixteenth of a code.
    let deep = report.depth > 1.0 + 0.0625;
    let wrong = report.coverage + report.counts + report.primitives > 0
        || deep
        || report.color > color
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
    let scenes = scenes();
    let mut wrong = 0;
    for path in &scenes {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        match check(path) {
            Ok(facts) => println!("{name}: right, {facts}"),
            Err(facts) => {
                println!("{name}: WRONG, {facts}");
                wrong += 1;
            }
        }
    }
    say(&format!("{} scenes replayed", scenes.len()));
    assert_eq!(wrong, 0, "of {} scenes these are wrong", scenes.len());
}
