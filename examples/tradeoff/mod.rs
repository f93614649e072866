//! Scenes with every setting of every knob: what `cargo tradeoff` measures.
//!
//! A case is named `SCENE/KNOB=SETTING`, or `SCENE/KNOB+KNOB=SETTING+SETTING`. The firmware counts
//! what it costs, the host compares its picture with the reference renderer's, and both draw from
//! this source. Geometry, cameras, lights and textures are values that the reference reads too.

pub(crate) mod depth;
pub(crate) mod fill;
pub(crate) mod heads_up;
pub(crate) mod inverse_root;
pub(crate) mod meshes;
pub(crate) mod planes;
pub(crate) mod sampled;
pub(crate) mod slivers;
pub(crate) mod sphere;
pub(crate) mod terrain;
pub(crate) mod texture;

use crate::scenes::{Facts, Group, Probe, Scene, Stage};
use microraster::math::{Mat4, Vec3};
use microraster::{IndexedList, Mesh};

/// Draws one case.
type Drawing<P> = fn(&mut Stage<'_>, u32, &mut P) -> Facts;

/// A case that is drawn once.
const fn case<P>(name: &'static str, draw: Drawing<P>) -> Scene<P> {
    Scene { name, group: Group::Standard, frames: 1, bunny: false, draw }
}

/// Cases of one knob in one scene, by its settings.
macro_rules! knob {
    ($scene:literal, $knob:literal, $($setting:literal => $draw:expr),+ $(,)?) => {
        [$($crate::tradeoff::case(concat!($scene, "/", $knob, "=", $setting), $draw)),+]
    };
}
use knob;

/// A mesh and where it stands, as both renderers read it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape<'a> {
    pub(crate) positions: &'a [[i16; 3]],
    pub(crate) indices: &'a [u16],
    /// From positions to model space.
    pub(crate) scale: Vec3,
    pub(crate) offset: Vec3,
    /// From model space to the world.
    pub(crate) model: Mat4,
}

impl<'a> Shape<'a> {
    /// The mesh, with what a shader wants beside its positions.
    pub(crate) fn mesh<A>(&self, attributes: &'a [A]) -> Mesh<'a, A, IndexedList<'a, u16>> {
        Mesh::new(self.positions, attributes).indexed(self.indices).placed(self.scale, self.offset)
    }
}

/// All cases.
pub(crate) fn cases<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    planes::cases()
        .chain(fill::cases())
        .chain(depth::cases())
        .chain(slivers::cases())
        .chain(meshes::cases())
        .chain(sphere::cases())
        .chain(terrain::cases())
        .chain(heads_up::cases())
}
