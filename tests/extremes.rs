//! The extremes: every clause of what numbers may do to a renderer, and properties over many
//! millions of random cases.
//!
//! `cargo test` tries a few hundred thousand. `cargo extremes`, or `cargo test --release --test
//! extremes`, tries the numbers that stand in the README, with overflow checks on; with
//! `MICRORASTER_WRITE_FIGURES=1` it writes that table. A *case* is one triangle, plane, pixel or
//! operation that was compared with its definition, and all follow from fixed seeds.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted; pictures are small"
)]

#[path = "support/choices.rs"]
mod choices;
#[path = "support/repertoire.rs"]
mod repertoire;
#[path = "support/scene_parts.rs"]
mod scene_parts;
mod support;

#[path = "extremes/any_number.rs"]
mod any_number;
#[path = "extremes/coverage.rs"]
mod coverage;
#[path = "extremes/depth.rs"]
mod depth;
#[path = "extremes/frames.rs"]
mod frames;
#[path = "extremes/lattice.rs"]
mod lattice;
#[path = "extremes/order.rs"]
mod order;
#[path = "extremes/pixels.rs"]
mod pixels;
#[path = "extremes/planes.rs"]
mod planes;
#[path = "extremes/projection.rs"]
mod projection;
#[path = "extremes/random_scenes.rs"]
mod random_scenes;
#[path = "extremes/rotations.rs"]
mod rotations;
#[path = "extremes/scenes.rs"]
mod scenes;
#[path = "extremes/shared_edges.rs"]
mod shared_edges;
#[path = "extremes/slivers.rs"]
mod slivers;
#[path = "extremes/tables.rs"]
mod tables;
#[path = "extremes/tally.rs"]
mod tally;
#[path = "extremes/textures.rs"]
mod textures;
