use super::Footprint;
use crate::color::Color;

/// What gives a colour at a place of a texture: a sampler of any kind.
pub trait Sample {
    /// What is sampled for a run of pixels.
    type Level: Sample;

    /// What suits pixels of this footprint; `footprint` is made only where it is needed.
    fn level(&self, footprint: impl FnOnce() -> Footprint) -> Self::Level;

    /// The colour at (`u`, `v`): the vertex's units with 16 fraction bits, wrapping. `None` discards
    /// the fragment, which only a sampler of your own does.
    fn fetch(&self, u: i32, v: i32) -> Option<Color>;
}
