//! Draws cases on the host.

use microraster::host::reference::compare::{rgb565, rgba8888, RGB565_STEPS, RGBA8888_STEPS};

use crate::scenes::{hash, ListRoom, Model, Probe, Scene, Stage, ROOM};
use crate::tradeoff::cases;

/// Counts pixels where the board counts instructions.
#[derive(Debug, Default)]
pub(crate) struct Counter {
    pixels: u64,
}

impl Probe for Counter {
    const COUNTING: bool = true;

    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T {
        work()
    }

    fn pixels(&mut self, written: u64) {
        self.pixels += written;
    }
}

/// All cases, to be drawn on the host.
pub(crate) fn all() -> impl Iterator<Item = Scene<Counter>> {
    cases()
}

/// A case's picture.
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    /// Red, green and blue, 0 to 255.
    pub(crate) colors: Vec<[f64; 3]>,
    /// What a step of each channel is.
    pub(crate) steps: [f64; 3],
    /// Depth codes, 0 where nothing was drawn.
    pub(crate) codes: Vec<u16>,
    /// Hash of the stored bytes.
    pub(crate) hash: u64,
    pub(crate) pixels: u64,
    pub(crate) triangles: u32,
}

/// Draws one.
pub(crate) fn draw(scene: &Scene<Counter>, bunny: Option<Model<'_>>) -> Drawing {
    let (mut color, mut depth) = (vec![0; ROOM], vec![0; ROOM]);
    let mut cache = Box::default();
    let mut counter = Counter::default();
    let mut list = Box::new(ListRoom::NEW);
    let mut stage =
        Stage { color: &mut color, depth: &mut depth, cache: &mut cache, bunny, list: &mut list };
    let facts = (scene.draw)(&mut stage, 0, &mut counter);
    let is_wide = facts.bytes == 4 * ROOM;
    let is_big_endian = scene.name.ends_with("=rgb565-be");
    let colors = if is_wide {
        color.iter().map(|word| rgba8888(*word)).collect()
    } else {
        let words: &[u16] = bytemuck::cast_slice(&color);
        let decoded = |word: &u16| rgb565(if is_big_endian { word.swap_bytes() } else { *word });
        words.iter().take(ROOM).map(decoded).collect()
    };
    Drawing {
        colors,
        steps: if is_wide { RGBA8888_STEPS } else { RGB565_STEPS },
        codes: depth,
        hash: hash::picture(&color, facts.bytes),
        pixels: counter.pixels,
        triangles: facts.triangles,
    }
}
