//! Everything together, at random and at the extremes: nothing panics, no band and no scissor
//! changes a bit, and every primitive is accounted for.

use crate::choices::Bytes;
use crate::repertoire::{check, Scene};
use crate::support::Random;
use crate::tally::{cases, random};
use microraster::{AnyDepthState, AnyStencil, Rgb565, Rgba8888, Size, Stats, Stenciled};
use std::path::Path;

#[test]
fn nothing_panics_and_no_band_or_scissor_changes_a_bit() {
    let (mut pixels, mut scenes) = (0_u64, 0_u64);
    let property = "scenes of everything at random: no panic, same in bands";
    random(property, cases(60_000, 5_000_000), 71, |random| {
        let scene = Scene::new(Random(random.next()));
        scenes += 1;
        let stats: Stats = if scenes.is_multiple_of(2) {
            check::<Rgb565, AnyDepthState, _>(&scene)
        } else {
            check::<Rgba8888, Stenciled<AnyDepthState, AnyStencil>, _>(&scene)
        };
        pixels += u64::from(stats.pixels);
        [stats.triangles, stats.lines, stats.points].into_iter().map(u64::from).sum()
    });
    assert!(pixels >= 100 * scenes, "{pixels} pixels of {scenes} scenes are too few");
}

#[test]
fn the_longest_pictures_are_drawn_like_any_other() {
    for (seed, size) in [(1, Size::new(4096, 3)), (2, Size::new(2, 4096)), (3, Size::new(8192, 1))]
    {
        for seed in seed * 100..seed * 100 + 12 {
            let scene = Scene { choices: Random(seed), tame: true, size };
            check::<Rgb565, AnyDepthState, _>(&scene);
        }
    }
}

#[test]
fn what_the_fuzzer_keeps_is_drawn_without_fault() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/draw");
    // The published package has no fuzzer.
    let Ok(files) = std::fs::read_dir(folder) else { return };
    let mut seen = 0;
    for file in files {
        let bytes = std::fs::read(file.expect("a file of the corpus").path()).expect("its bytes");
        // The first byte tells the fuzzer which of both to draw.
        let Some((_, rest)) = bytes.split_first() else { continue };
        check::<Rgb565, AnyDepthState, _>(&Scene::new(Bytes(rest)));
        check::<Rgba8888, Stenciled<AnyDepthState, AnyStencil>, _>(&Scene::new(Bytes(rest)));
        seen += 1;
    }
    assert!(seen > 10, "{seen} files are no corpus");
}
