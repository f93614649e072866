//! Time and pictures of one scene, renderer after renderer, round after round.

use std::path::Path;
use std::sync::Barrier;
use std::time::{Duration, Instant};

use anyhow::Context;

use crate::renderers::{difference, Make, Renderer, RENDERERS};
use crate::scene::{Rgb, Scene, Size};
use crate::{llvmpipe, threaded};

/// What a renderer did with a scene.
#[derive(Debug)]
pub(crate) struct Result {
    pub(crate) renderer: &'static str,
    /// The least time of all frames of a round.
    pub(crate) time: Duration,
    /// Pixels, of a thousand, that differ from ours by more than [`TOLERANCE`](crate::renderers::TOLERANCE); of the last frame.
    pub(crate) different: f64,
    picture: Vec<Rgb>,
}

/// A scene, and what each renderer that can draw it did; ours is the first.
#[derive(Debug)]
pub(crate) struct Comparison {
    pub(crate) scene: &'static str,
    pub(crate) results: Vec<Result>,
}

/// All renderers of the host, ours first.
pub(crate) fn renderers() -> impl Iterator<Item = (&'static str, Make)> {
    let [ours, others @ ..] = RENDERERS;
    [ours, ("llvmpipe", llvmpipe::make)].into_iter().chain(others)
}

/// Draws a scene with every renderer in turn, so many times.
pub(crate) fn compare(scene: &Scene, size: Size, rounds: usize) -> Comparison {
    let mut ready: Vec<_> = renderers()
        .filter_map(|(name, make)| Some((name, make(scene, size)?, Duration::MAX)))
        .collect();
    for _ in 0..rounds {
        for (_, renderer, least) in &mut ready {
            *least = round(renderer.as_mut(), scene.frames()).min(*least);
        }
    }
    let mut ours = Vec::new();
    let results = ready.into_iter().map(|(renderer, mut drawn, time)| {
        let picture = drawn.picture();
        if ours.is_empty() {
            ours.clone_from(&picture);
        }
        Result { renderer, time, different: difference(&ours, &picture), picture }
    });
    Comparison { scene: scene.name, results: results.collect() }
}

/// How many times faster so many threads are than one; their pictures must be the same.
pub(crate) fn threads(
    scene: &Scene,
    size: Size,
    threads: usize,
    rounds: usize,
) -> anyhow::Result<f64> {
    let mut one = RENDERERS[0].1(scene, size).context("this crate draws all scenes")?;
    let mut all = threaded::make(scene, size, threads)?;
    let mut least = [Duration::MAX; 2];
    for _ in 0..rounds {
        for (renderer, least) in [&mut one, &mut all].into_iter().zip(&mut least) {
            *least = round(renderer.as_mut(), scene.frames()).min(*least);
        }
    }
    anyhow::ensure!(one.picture() == all.picture(), "{}: pictures differ", scene.name);
    Ok(least[0].as_secs_f64() / least[1].as_secs_f64())
}

/// A round is at least this long where threads draw pictures of their own, so that it does not matter
/// that one begins a little later.
const LONG: Duration = Duration::from_millis(10);

/// How many times as many pictures so many threads draw as one does, each its own, in the same time:
/// what the machine's cores are worth to each other, and what several threads can gain at most.
pub(crate) fn at_once(
    scene: &Scene,
    size: Size,
    threads: usize,
    rounds: usize,
) -> anyhow::Result<f64> {
    let mut one = RENDERERS[0].1(scene, size).context("this crate draws all scenes")?;
    let frames = scene.frames();
    let first = round(one.as_mut(), frames).max(Duration::from_nanos(1));
    let times = (LONG.as_nanos() / first.as_nanos()).clamp(1, 10_000);
    let mut long_round = move || (0..times).map(|_| round(one.as_mut(), frames)).sum::<Duration>();
    let alone = (0..rounds).map(|_| long_round()).min().unwrap_or_default();
    let barrier = Barrier::new(threads);
    let work = || {
        let mut mine = RENDERERS[0].1(scene, size).context("this crate draws all scenes")?;
        let long_round = |_| {
            barrier.wait();
            (0..times).map(|_| round(mine.as_mut(), frames)).sum::<Duration>()
        };
        anyhow::Ok((0..rounds).map(long_round).collect::<Vec<_>>())
    };
    let theirs = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        let joined = workers.into_iter().map(|worker| worker.join().expect("a thread stopped"));
        joined.collect::<anyhow::Result<Vec<_>>>()
    })?;
    let slowest = |round: usize| theirs.iter().map(|times| times[round]).max().unwrap_or_default();
    let together = (0..rounds).map(slowest).min().unwrap_or_default();
    Ok(threads as f64 * alone.as_secs_f64() / together.as_secs_f64())
}

/// The time to draw all frames; clears excluded.
fn round(renderer: &mut dyn Renderer, frames: usize) -> Duration {
    let mut time = Duration::ZERO;
    for frame in 0..frames {
        renderer.clear();
        let start = Instant::now();
        renderer.draw(frame);
        time += start.elapsed();
    }
    time
}

impl Comparison {
    /// Writes every renderer's picture of the last frame.
    pub(crate) fn save(&self, folder: &Path, size: Size) -> anyhow::Result<()> {
        std::fs::create_dir_all(folder)?;
        let (width, height) = (size.width.into(), size.height.into());
        for result in &self.results {
            let name = format!("{}-{width}x{height}-{}.png", self.scene, result.renderer);
            let (bytes, color) = (result.picture.as_flattened(), image::ColorType::Rgb8);
            image::save_buffer(folder.join(name), bytes, width, height, color)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::renderers::TOLERANCE;
    use crate::scene::{scenes, Shading};

    /// Renderers whose corners keep fractions of pixels, which have the same picture but for
    /// rounding.
    const FINE: [&str; 4] = ["microraster", "llvmpipe", "retrofire", "euc"];

    /// Where the driver is installed it takes part.
    #[test]
    fn llvmpipe_is_asked_for() {
        assert!(renderers().any(|(name, _)| name == "llvmpipe"), "it is in the list");
        let size = Size { width: 32, height: 24 };
        let scenes = scenes(size, None);
        let scene = scenes.first().expect("there are scenes");
        if llvmpipe::make(scene, size).is_none() {
            eprintln!("no llvmpipe here: install libegl1 and libgl1-mesa-dri to compare with it");
            return;
        }
        let results = compare(scene, size, 1).results;
        assert!(results.iter().any(|result| result.renderer == "llvmpipe"), "it draws");
    }

    #[test]
    fn renderers_of_fine_corners_draw_the_same_pictures() {
        let size = Size { width: 160, height: 120 };
        for scene in scenes(size, None) {
            // Of the grid's diagonals, which go through pixel centres, see the page.
            if scene.name == "S1" {
                continue;
            }
            let comparison = compare(&scene, size, 1);
            // Of the crates none filters, and one blends.
            let is_rare = matches!(scene.shading, Shading::Filtered { .. } | Shading::Glass(..));
            let least = if is_rare { 1 } else { 3 };
            assert!(comparison.results.len() >= least, "{} is drawn by few", scene.name);
            for result in &comparison.results {
                if FINE.contains(&result.renderer) {
                    let Result { renderer, different, .. } = result;
                    let lit = result.picture.iter().filter(|pixel| **pixel != [0; 3]).count();
                    assert!(lit > 1000, "{renderer} draws nothing of {}", scene.name);
                    assert!(*different < 15.0, "{renderer}, {}: {different}/1000", scene.name);
                }
            }
        }
    }

    #[test]
    fn differences_are_counted_beyond_the_tolerance_alone() {
        let ours = [[10, 20, 30]; 4];
        let mut theirs = ours;
        theirs[1][2] += TOLERANCE;
        assert!(difference(&ours, &theirs) < f64::EPSILON);
        theirs[3][0] += TOLERANCE + 1;
        assert!((difference(&ours, &theirs) - 250.0).abs() < f64::EPSILON);
    }
}
