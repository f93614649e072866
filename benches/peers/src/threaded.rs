//! This crate in bands, by several threads: lit meshes recorded once, all else drawn in each band.

use microraster::host::ParallelBands;
use microraster::{
    Color, Corner, Cull, DisplayList, Flat, Gouraud, Less, ListTriangle, ListVertex, Normal, Pass,
    Rgb565, Shader, Varying, VertexCache,
};

use crate::renderers::microraster::{ready, Cache, Drawing, Ready};
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
        let Self { ready, pool } = self;
        match ready.drawing.lit() {
            Some((_, light, true)) => {
                pool.install(|| replayed(ready, number, &Gouraud::new(light)));
            }
            Some((_, light, false)) => pool.install(|| replayed(ready, number, &Flat::new(light))),
            None => pool.install(|| {
                let Ready { drawing, size, pixels, depth, .. } = ready;
                if let Ok(bands) = ParallelBands::<Rgb565>::new(pixels, depth, *size) {
                    bands.draw(|frame| drawing.draw(frame, number, &mut Cache::new()));
                }
            }),
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.ready.picture()
    }
}

/// Vertices and triangles that a list has room for: enough for the largest mesh.
const ROOM: usize = 8192;

/// Records a lit mesh and draws its bands from the one list.
fn replayed<H>(ready: &mut Ready, number: usize, shader: &H)
where
    H: Shader<Vertex = Normal> + Sync,
    H::Prepared: Sync,
    H::Varying: Varying<Corner = Color>,
{
    let Ready { drawing, size, pixels, depth, .. } = ready;
    let Some((mesh, ..)) = drawing.lit() else { return };
    let (camera, model) = (Drawing::camera(), drawing.model(number));
    let mut vertices = vec![ListVertex::<Corner<H::Varying>>::default(); ROOM];
    let mut triangles = vec![ListTriangle::BLANK; ROOM];
    let list = DisplayList::new(&mut vertices, &mut triangles, &mut []);
    let mut cache = VertexCache::<u16, 2048>::new();
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let recording = pass.record(list, *size, &model, &mesh, shader, &mut cache);
    let bands = ParallelBands::<Rgb565>::new(pixels, depth, *size);
    if let (Ok(recording), Ok(bands)) = (recording, bands) {
        bands.draw(|frame| {
            let drawn = Pass::new(&Drawing::camera()).depth(Less).replay_shared(frame, &recording);
            debug_assert!(drawn.is_ok(), "recorded for this picture");
        });
    }
}
