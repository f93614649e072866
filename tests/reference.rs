//! The reference renderer against pictures of another exact reference, and against what is known
//! on paper.
#![cfg(feature = "std")]
#![allow(dead_code, reason = "what reads scenes serves another test too")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "numbers of small pictures; floats that have to be the same"
)]

#[path = "conformance/expected.rs"]
mod expected;
#[path = "conformance/folder.rs"]
mod folder;
#[path = "conformance/scene.rs"]
mod scene;
mod support;

#[path = "reference/conformance.rs"]
mod conformance;
#[path = "reference/coverage.rs"]
mod coverage;
#[path = "reference/numbers.rs"]
mod numbers;
#[path = "reference/perspective.rs"]
mod perspective;
#[path = "reference/shading.rs"]
mod shading;
#[path = "reference/states.rs"]
mod states;
#[path = "support/stencil_states.rs"]
mod stencil_states;
