//! Draw calls from raw bytes: a scene over the whole repertoire, whole, in bands and under a
//! scissor. What holds of the random scenes of `tests/extremes` must hold of it.
#![no_main]

#[path = "../../tests/support/choices.rs"]
mod choices;
#[path = "../../tests/support/repertoire.rs"]
mod repertoire;
#[path = "../../tests/support/scene_parts.rs"]
mod scene_parts;
#[path = "../../tests/support/mod.rs"]
mod support;

use choices::Bytes;
use libfuzzer_sys::fuzz_target;
use microraster::{AnyDepthState, AnyStencil, Rgb565, Rgba8888, Stenciled};
use repertoire::{check, Scene};

fuzz_target!(|data: &[u8]| {
    let Some((first, rest)) = data.split_first() else { return };
    let scene = Scene::new(Bytes(rest));
    if first % 2 == 0 {
        check::<Rgb565, AnyDepthState, _>(&scene);
    } else {
        check::<Rgba8888, Stenciled<AnyDepthState, AnyStencil>, _>(&scene);
    }
});
