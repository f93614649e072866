//! What the figures are held against: the marks that were set for them, and what other renderers
//! take for the same scenes. All of it is written by hand; `docs/PERFORMANCE.md` says where it
//! comes from.

/// What was asked of a scene, and the best of the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Mark {
    pub(crate) scene: &'static str,
    /// At most so much, by the scene's own unit, on Cortex-M4F and on Cortex-M0+.
    pub(crate) most: [Option<f64>; 2],
    /// The least that another renderer takes on either.
    pub(crate) peers: [&'static str; 2],
}

/// The boards that marks are for, in their order.
pub(crate) const BOARDS: [&str; 2] = ["m4", "m0"];

/// A mark of both boards.
const fn mark(scene: &'static str, m4: f64, m0: f64, peers: [&'static str; 2]) -> Mark {
    Mark { scene, most: [Some(m4), Some(m0)], peers }
}

/// All of them.
pub(crate) const MARKS: [Mark; 16] = [
    mark("clear", 55e3, 95e3, ["113 k, tgx", ""]),
    mark("F1", 0.65, 1.0, ["2.0, small3dlib and rlsw", "4.4, small3dlib"]),
    mark("F2", 9.5, 14.0, ["9.6, TinyGL", "45.8, small3dlib"]),
    mark("F2-constant", 7.0, 10.0, ["8.5, small3dlib", "13.2, small3dlib"]),
    mark("F3", 20.0, 28.0, ["27.5, TinyGL", "115, small3dlib"]),
    mark("F4", 29.0, 44.0, ["39.4, tgx", "98 affine, 414 exact, small3dlib"]),
    mark("F5", 60.0, 105.0, ["108, small3dlib", ""]),
    mark("F5m", 72.0, 125.0, ["173.7, tgx", ""]),
    mark("blend", 8.5, 13.0, ["", ""]),
    mark("S1", 450.0, 800.0, ["862, small3dlib", "1868, small3dlib"]),
    mark("S1-raster", 300.0, 550.0, ["507, small3dlib", ""]),
    mark("M1-teapot", 1.5e6, 2.7e6, ["2.22 M, tgx", ""]),
    Mark { scene: "M2-teapot", most: [None; 2], peers: ["1.87 M, embedded-3dgfx", ""] },
    mark("M1-bunny", 1.8e6, 3.6e6, ["2.69 M, tgx", "11.6 M, small3dlib"]),
    mark(
        "M2-bunny",
        1.5e6,
        3.2e6,
        ["2.24 M, tgx", "11.0 M, 5.75 M with one depth a triangle, small3dlib"],
    ),
    mark(LIT_VERTEX, 110.0, 330.0, ["", ""]),
];

/// Transforming and lighting a vertex: what no scene measures alone.
pub(crate) const LIT_VERTEX: &str = "vertex, transformed and lit";
/// The scenes that it is made of: the first, and what the second takes more than the third.
pub(crate) const LIT_VERTEX_OF: [&str; 3] = ["vertex", "vertex-sun", "vertex-unlit"];

/// The scenes of the table's short form.
pub(crate) fn is_in_short(scene: &str) -> bool {
    scene != LIT_VERTEX && scene != "blend" && MARKS.iter().any(|mark| mark.scene == scene)
}

#[cfg(test)]
mod tests {
    use super::super::facts::Counter;
    use super::super::scenes::standard;
    use super::*;

    #[test]
    fn marks_are_of_scenes() {
        let names: Vec<_> = standard::<Counter>().map(|scene| scene.name).collect();
        let scenes = MARKS.iter().map(|mark| mark.scene).filter(|scene| *scene != LIT_VERTEX);
        for scene in scenes.chain(LIT_VERTEX_OF) {
            assert!(names.contains(&scene), "{scene}");
        }
    }
}
