//! This crate in bands, by several threads.

use microraster::host::ParallelBands;
use microraster::Rgb565;

use crate::renderers::microraster::{ready, Cache, Ready};
use crate::renderers::Renderer;
use crate::scene::{Rgb, Scene, Size};

struct Threaded {
    ready: Ready,
    pool: rayon::ThreadPool,
}

/// A scene made ready for so many threads.
pub(crate) fn make(scene: &Scene, size: Size, threads: usize) -> anyhow::Result<Box<dyn Renderer>> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    Ok(Box::new(Threaded { ready: ready(scene, size), pool }))
}

impl Renderer for Threaded {
    fn clear(&mut self) {
        self.ready.clear();
    }

    fn draw(&mut self, number: usize) {
        let Ready { drawing, size, pixels, depth, .. } = &mut self.ready;
        self.pool.install(|| {
            if let Ok(bands) = ParallelBands::<Rgb565>::new(pixels, depth, *size) {
                bands.draw(|frame| drawing.draw(frame, number, &mut Cache::new()));
            }
        });
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.ready.picture()
    }
}
