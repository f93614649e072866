//! The scenes that are drawn on every target and compared by hash.
//!
//! The firmware, the host program and the tests include this folder, so that all of them draw
//! from the same source.

pub(crate) mod bands;
pub(crate) mod fragments;
pub(crate) mod gallery;
pub(crate) mod golden;
pub(crate) mod grid;
pub(crate) mod hash;
pub(crate) mod model;
pub(crate) mod operations;
pub(crate) mod primitives;
pub(crate) mod standard;
pub(crate) mod textured;
pub(crate) mod toon;
pub(crate) mod vertices;

pub(crate) use bands::ListRoom;
use microraster::{Color, VertexCache};
pub(crate) use model::Model;

/// Words of colour and of depth that every [`Stage`] holds.
pub(crate) const ROOM: usize = 320 * 240;

/// Vertices that the [`Stage`]'s cache holds.
pub(crate) const CACHED: usize = 2048;

/// What a scene draws into.
#[derive(Debug)]
pub(crate) struct Stage<'a> {
    /// At least [`ROOM`] words: 320x240 pixels of any format.
    pub(crate) color: &'a mut [u32],
    /// At least [`ROOM`] depths.
    pub(crate) depth: &'a mut [u16],
    /// Where shared vertices are kept: enough for every vertex of the bunny.
    pub(crate) cache: &'a mut VertexCache<Color, CACHED>,
    /// The bunny, whose licence keeps it out of this repository; `None` where it is missing.
    pub(crate) bunny: Option<Model<'a>>,
    /// Where meshes are recorded.
    pub(crate) list: &'a mut ListRoom,
}

/// Wraps the part of a scene that is measured.
pub(crate) trait Probe {
    /// Whether the scene counts what it draws and reports it by [`Probe::pixels`]. Firmware that
    /// is measured does not.
    const COUNTING: bool;
    /// Does the measured work; clears happen outside of it.
    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T;
    /// Takes note of pixels that were written by the measured work.
    fn pixels(&mut self, written: u64);
    /// Takes note of primitives that could not be drawn.
    fn skipped(&mut self, _primitives: u32) {}
}

/// What a scene says of a frame that it drew.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Facts {
    /// Bytes of colour from the start of the buffer that make up the picture.
    pub(crate) bytes: usize,
    /// Triangles, lines or points submitted.
    pub(crate) triangles: u32,
}

/// Which list a scene belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    /// Measured scenes, the same in every renderer that is compared.
    Standard,
    /// Small pictures that are kept and compared exactly.
    Golden,
    /// Pictures to look at.
    Gallery,
    /// A measured scene in bands.
    Bands,
}

/// One scene.
pub(crate) struct Scene<P> {
    /// A word without spaces and commas.
    pub(crate) name: &'static str,
    /// Which list it is in.
    pub(crate) group: Group,
    /// Frames that are drawn, numbered from 0.
    pub(crate) frames: u32,
    /// Whether it draws [`Stage::bunny`].
    pub(crate) bunny: bool,
    /// Clears, draws one frame and says what it drew.
    pub(crate) draw: fn(&mut Stage<'_>, frame: u32, probe: &mut P) -> Facts,
}

/// The measured scenes.
pub(crate) fn standard<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    standard::scenes()
        .into_iter()
        .chain(primitives::scenes())
        .chain(toon::scenes())
        .chain(fragments::scenes())
        .chain(operations::scenes())
        .chain(textured::scenes())
        .chain(vertices::scenes())
}

/// The golden pictures and the gallery.
pub(crate) fn pictures<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    golden::scenes().chain(gallery::scenes())
}

/// All scenes.
pub(crate) fn scenes<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    standard().chain(pictures()).chain(bands::scenes())
}
