//! On ordinary scenes nothing is skipped.
#![allow(dead_code, reason = "the scenes serve other programs too")]

#[path = "../../examples/scenes/mod.rs"]
mod all;

use all::{scenes, ListRoom, Probe, Stage, ROOM};
use microraster::VertexCache;

/// Counts what could not be drawn.
#[derive(Default)]
struct Count {
    pixels: u64,
    skipped: u64,
}

impl Probe for Count {
    const COUNTING: bool = true;

    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T {
        work()
    }

    fn pixels(&mut self, written: u64) {
        self.pixels += written;
    }

    fn skipped(&mut self, primitives: u32) {
        self.skipped += u64::from(primitives);
    }
}

#[test]
fn every_ordinary_scene_skips_nothing() {
    let (mut color, mut depth) = (vec![0; ROOM], vec![0; ROOM]);
    let mut cache = VertexCache::new();
    let mut list = ListRoom::NEW;
    let mut drawn = 0;
    // The bunny's own file is not part of the repository.
    for scene in scenes::<Count>().filter(|scene| !scene.bunny) {
        let mut count = Count::default();
        for frame in 0..scene.frames {
            let (color, depth) = (&mut color, &mut depth);
            let mut stage = Stage { color, depth, cache: &mut cache, bunny: None, list: &mut list };
            (scene.draw)(&mut stage, frame, &mut count);
        }
        assert_eq!(count.skipped, 0, "{}", scene.name);
        drawn += u32::from(count.pixels > 0);
    }
    assert!(drawn > 40, "{drawn} scenes are not all of them");
}
