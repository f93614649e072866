//! What the pictures should be: each scene once more, by the reference renderer.

mod flat;
mod geometry;
mod lit;
pub(crate) mod planes;

use microraster::host::reference::{looks, mean_colors, Reference, Snap};
use std::collections::HashMap;
use std::rc::Rc;

use crate::case::Case;
use crate::scenes::standard::SIZE;
use crate::scenes::Model;

/// Looks at a pixel across and down, where a pixel is what it shows on average.
const LOOKS: u16 = 4;

/// Fraction bits of a pixel on the crate's own grid.
pub(crate) const GRID_BITS: u32 = 4;

/// What a scene shows.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    /// Seen at the centres of pixels, corners where they are.
    pub(crate) exact: Reference,
    /// The same with corners on the crate's grid.
    pub(crate) snapped: Reference,
    /// What colours are compared with.
    pub(crate) colors: Vec<[f64; 3]>,
}

/// By what colours are made, and whether a pixel is a point or an area.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    pub(crate) scene: String,
    pub(crate) shading: Shading,
    pub(crate) is_area: bool,
    /// To what part of the mesh's half size vertices of the ball are rounded, if they are.
    pub(crate) steps: Option<u32>,
}

/// How surfaces get their colours.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shading {
    /// The nearest texel.
    Nearest,
    /// A texture that is continuous between texels.
    Continuous,
    /// The mesh's colours in perspective.
    Colors,
    /// Light at vertices, linear on the screen.
    AtVertices,
    /// Light, and fog, at each point.
    AtPoints,
    /// As the scene's own shader has it, without its shortcuts.
    Own,
    /// By a way of blending.
    Blended(String),
    /// Lines a pixel wide.
    Lines,
    /// Pairs of surfaces to a distance: the setting of the range.
    Range(String),
}

impl Key {
    /// A scene by its points.
    pub(crate) fn new(scene: &str, shading: Shading) -> Self {
        Self { scene: scene.into(), shading, is_area: false, steps: None }
    }

    /// What a case is held against: what its knob would show if it cost nothing to be exact, and
    /// all else as the case has it.
    pub(crate) fn of(case: &Case) -> Self {
        let knob = case.knob();
        let (shading, is_area) = match (case.scene.as_str(), knob.as_str()) {
            (_, "perspective") => (Shading::Nearest, false),
            (_, "perspective x filter") => (Shading::Continuous, true),
            (_, "colour") => (Shading::Colors, false),
            ("range", _) => (Shading::Range(case.setting()), false),
            ("fill", _) => (Shading::Colors, false),
            ("slivers", _) => (Shading::Colors, true),
            (_, "samples") => (Shading::AtVertices, true),
            (_, "normals" | "fog") => (Shading::AtPoints, false),
            (_, "inverse-root") => (Shading::Own, false),
            (_, "blend") => (Shading::Blended(case.setting()), false),
            (_, "line") => (Shading::Lines, true),
            _ => (Shading::AtVertices, false),
        };
        Self { is_area, ..Self::new(&case.scene, shading) }
    }

    /// The best that the scene could show, whatever the knob: what settings of different knobs are
    /// compared by.
    pub(crate) fn ideal(case: &Case) -> Self {
        let own = Self::of(case);
        let shading = match own.shading {
            Shading::Nearest => Shading::Continuous,
            Shading::AtVertices => Shading::AtPoints,
            other => other,
        };
        Self { shading, is_area: true, ..own }
    }
}

/// All truths so far: many cases share one.
#[derive(Debug, Default)]
pub(crate) struct Truths {
    known: HashMap<Key, Rc<Truth>>,
}

impl Truths {
    /// The truth of a key, drawn when it is first asked for.
    pub(crate) fn get(&mut self, key: &Key, bunny: Option<Model<'_>>) -> Rc<Truth> {
        if let Some(truth) = self.known.get(key) {
            return Rc::clone(truth);
        }
        let draw = |start: Reference| {
            let mut picture = start;
            paint(key, bunny, &mut picture);
            picture
        };
        let blank = || Reference::new(SIZE, background(key));
        let exact = draw(blank());
        let snapped = draw(blank().snap(Snap::Bits(GRID_BITS)));
        let colors = if key.is_area {
            mean_colors(looks(LOOKS).map(|look| draw(blank().look(look))))
        } else {
            exact.colors().to_vec()
        };
        let truth = Rc::new(Truth { exact, snapped, colors });
        self.known.insert(key.clone(), Rc::clone(&truth));
        truth
    }
}

/// A scene drawn with corners on another grid: what `bits` fraction bits of a pixel would show.
pub(crate) fn on_grid(key: &Key, bits: u32, bunny: Option<Model<'_>>) -> Reference {
    let mut picture = Reference::new(SIZE, background(key)).snap(Snap::Bits(bits));
    paint(key, bunny, &mut picture);
    picture
}

fn background(key: &Key) -> [f64; 3] {
    match (key.scene.as_str(), &key.shading) {
        ("terrain", _) => flat::channels(crate::scenes::gallery::pictures::terrain::HAZE),
        ("heads-up", Shading::Lines) => [16.0, 24.0, 48.0],
        _ => [0.0; 3],
    }
}

fn paint(key: &Key, bunny: Option<Model<'_>>, picture: &mut Reference) {
    match key.scene.as_str() {
        "fill" => flat::fill(picture),
        "range" => flat::range(&key.shading, picture),
        "slivers" => flat::slivers(picture),
        "heads-up" => flat::heads_up(&key.shading, picture),
        "teapot" | "distant" | "bunny" => lit::mesh(&key.scene, &key.shading, bunny, picture),
        "sphere" | "sphere-close" => lit::sphere(key, picture),
        "terrain" => lit::terrain(&key.shading, picture),
        scene => planes::plane(scene, &key.shading, picture),
    }
}
