//! Fraction bits of a pixel: what other grids than the crate's would show, drawn by the reference.

use std::fmt::Write as _;

use crate::scenes::Model;
use crate::table::number;
use crate::truth::{on_grid, Key, Shading, Truths};

/// Fraction bits that are compared.
const BITS: [u32; 7] = [2, 3, 4, 5, 6, 7, 8];

/// How finely vertices are kept, in steps of a mesh's half size, beside the grids.
const POSITIONS: [(&str, Option<u32>); 3] =
    [("8 bits", Some(127)), ("16 bits", Some(32_767)), ("f32", None)];

/// Farthest a coordinate may lie from the picture's middle, in pixels, so that edge functions fit
/// 30 bits and a sign: 4096 at the crate's four bits, as `GUARD` says. An edge value is at most the
/// square of twice that, times the steps of a pixel.
fn reach(bits: u32) -> u32 {
    let square = (1_u32 << 30) >> bits;
    square.isqrt() / 2
}

/// A table of grids: in how many pixels each scene shows another triangle than corners that lie
/// where they are.
pub(crate) fn table(truths: &mut Truths, bunny: Option<Model<'_>>) -> String {
    let scenes = [
        ("slivers", Shading::Colors),
        ("teapot", Shading::AtVertices),
        ("distant", Shading::AtVertices),
        ("plane-10", Shading::Nearest),
    ];
    let keys = scenes.map(|(scene, shading)| Key::new(scene, shading));
    let mut text = String::from("| fraction bits | reach, pixels |");
    // Writing to a string cannot fail.
    for key in &keys {
        let _ = write!(text, " {} |", key.scene);
    }
    let _ = write!(text, "\n| --- | ---: |{}", " ---: |".repeat(keys.len()));
    for bits in BITS {
        let mark = if bits == crate::truth::GRID_BITS { "**" } else { "" };
        let _ = write!(text, "\n| {mark}{bits}{mark} | {} |", reach(bits));
        for key in &keys {
            let exact = truths.get(key, bunny);
            let drawn = on_grid(key, bits, bunny);
            let seen = exact.exact.seen().iter().zip(drawn.seen());
            let shown = seen.clone().filter(|(a, b)| a.is_some() || b.is_some()).count();
            let wrong = seen.filter(|(a, b)| a != b).count();
            let share = 100.0 * wrong as f64 / shown.max(1) as f64;
            let _ = write!(text, " {wrong} ({} %) |", number(share));
        }
    }
    text
}

/// A table of grids and of positions of vertices, on the ball seen whole and close.
pub(crate) fn with_positions(truths: &mut Truths) -> String {
    let mut text = String::from("| positions |");
    for bits in BITS {
        let _ = write!(text, " {bits} |");
    }
    let _ = write!(text, "\n| --- |{}", " ---: |".repeat(BITS.len()));
    for scene in ["sphere", "sphere-close"] {
        let exact = truths.get(&Key::new(scene, Shading::AtVertices), None);
        for (name, steps) in POSITIONS {
            let _ = write!(text, "\n| {scene}, {name} |");
            for bits in BITS {
                let key = Key { steps, ..Key::new(scene, Shading::AtVertices) };
                let drawn = on_grid(&key, bits, None);
                let seen = exact.exact.seen().iter().zip(drawn.seen());
                let _ = write!(text, " {} |", seen.filter(|(a, b)| a != b).count());
            }
        }
    }
    text
}
