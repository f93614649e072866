//! This crate in bands, by several threads: lit meshes recorded in as many parts as there are threads,
//! each by one of them, all else drawn in each band.

use std::cell::RefCell;

use microraster::host::ParallelBands;
use microraster::math::Mat4;
use microraster::{
    Color, Cull, DisplayList, Flat, Gouraud, Less, ListTriangle, ListVertex, Normal, Pass,
    Recording, Rgb565, Shader, Varying, VertexCache,
};

use crate::renderers::microraster::{ready, Cache, Drawing, Lit, Ready};
use crate::renderers::Renderer;
use crate::scene::{Rgb, Scene, Size};

/// Vertices and triangles that a part's list has room for: enough for the largest mesh.
const ROOM: usize = 8192;

/// What a part of a mesh is recorded with.
struct Part {
    vertices: Vec<ListVertex<Color>>,
    triangles: Vec<ListTriangle>,
    cache: Box<VertexCache<u16, 2048>>,
}

impl Part {
    fn new() -> Self {
        Self {
            vertices: vec![ListVertex::default(); ROOM],
            triangles: vec![ListTriangle::BLANK; ROOM],
            cache: Box::new(VertexCache::new()),
        }
    }
}

struct Threaded {
    ready: Ready,
    parts: Vec<Part>,
}

/// A scene made ready for so many threads, of which the caller's is one.
pub(crate) fn make(scene: &Scene, size: Size, threads: usize) -> anyhow::Result<Box<dyn Renderer>> {
    // Refused from the second scene on: the threads are there.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).use_current_thread();
    let made = pool.build_global();
    let all = rayon::current_num_threads();
    anyhow::ensure!(all == threads, "{all} threads instead of {threads}: {made:?}");
    let parts = (0..threads).map(|_| Part::new()).collect();
    Ok(Box::new(Threaded { ready: ready(scene, size), parts }))
}

impl Renderer for Threaded {
    /// By the threads that draw, as in a program of its own: what one of them has cleared is in its
    /// core's cache.
    fn clear(&mut self) {
        let Ready { size, pixels, depth, .. } = &mut self.ready;
        if let Ok(bands) = ParallelBands::<Rgb565>::new(pixels, depth, *size) {
            bands.draw(|frame| frame.clear(microraster::Rgb::BLACK));
        }
    }

    fn draw(&mut self, number: usize) {
        thread_local! {
            static CACHE: RefCell<Box<Cache>> = RefCell::new(Box::new(Cache::new()));
        }
        let Self { ready, parts } = self;
        match ready.drawing.lit() {
            Some((_, light, true)) => replayed(ready, parts, number, &Gouraud::new(light)),
            Some((_, light, false)) => replayed(ready, parts, number, &Flat::new(light)),
            None => {
                let Ready { drawing, size, pixels, depth, .. } = ready;
                if let Ok(bands) = ParallelBands::<Rgb565>::new(pixels, depth, *size) {
                    bands.draw(|frame| {
                        CACHE.with_borrow_mut(|cache| drawing.draw(frame, number, cache));
                    });
                }
            }
        }
    }

    fn picture(&mut self) -> Vec<Rgb> {
        self.ready.picture()
    }
}

/// Records a part of a lit mesh.
fn recorded<'a, H>(
    Part { vertices, triangles, cache }: &'a mut Part,
    mesh: &Lit<'_>,
    size: microraster::Size,
    model: &Mat4,
    shader: &'a H,
) -> Recording<'a, H>
where
    H: Shader<Vertex = Normal>,
    H::Varying: Varying<Corner = Color>,
{
    let list = DisplayList::new(vertices, triangles, &mut []);
    let camera = Drawing::camera();
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    pass.record(list, size, model, mesh, shader, cache)
}

/// Records a lit mesh in parts, and draws each band from all of them in their order.
fn replayed<H>(ready: &mut Ready, parts: &mut [Part], number: usize, shader: &H)
where
    H: Shader<Vertex = Normal> + Sync,
    H::Prepared: Send + Sync,
    H::Varying: Varying<Corner = Color>,
{
    let Ready { drawing, size, pixels, depth, .. } = ready;
    let (size, model) = (*size, drawing.model(number));
    let Some((mesh, ..)) = drawing.lit() else { return };
    let mut recordings: Vec<Option<Recording<'_, H>>> = parts.iter().map(|_| None).collect();
    let meshes = drawing.parts(&mesh, parts.len());
    let model = &model;
    rayon::in_place_scope(|scope| {
        let mut work = recordings.iter_mut().zip(parts).zip(meshes);
        let first = work.next();
        for ((place, part), mesh) in work {
            scope.spawn(move |_| *place = Some(recorded(part, &mesh, size, model, shader)));
        }
        if let Some(((place, part), mesh)) = first {
            *place = Some(recorded(part, &mesh, size, model, shader));
        }
    });
    if let Ok(bands) = ParallelBands::<Rgb565>::new(pixels, depth, size) {
        bands.draw(|frame| {
            let camera = Drawing::camera();
            for recording in recordings.iter().flatten() {
                let drawn = Pass::new(&camera).depth(Less).replay_shared(frame, recording);
                debug_assert!(drawn.is_ok(), "recorded for this picture");
            }
        });
    }
}
