//! Small pictures that are kept and compared exactly.

use super::{Facts, Group, Probe, Scene, Stage};

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 1] {
    [Scene { name: "ramp", group: Group::Golden, frames: 2, bunny: false, draw: ramp::<P> }]
}

/// 64 words that rise from the frame's number.
fn ramp<P: Probe>(stage: &mut Stage<'_>, frame: u32, probe: &mut P) -> Facts {
    let color = stage.color.get_mut(..64).unwrap_or_default();
    probe.measure(|| {
        let mut value = frame;
        for word in color.iter_mut() {
            *word = value;
            value = value.wrapping_mul(3).wrapping_add(1);
        }
    });
    if P::COUNTING {
        probe.pixels(color.len() as u64);
    }
    Facts { bytes: color.len() * 4, triangles: 1 }
}
