//! Draws the scenes on the host, compares them with what a board drew, and prints the facts.

use super::lines::{Drawn, Report};
use super::scenes::{hash, scenes, ListRoom, Model, Probe, Scene, Stage, ROOM};
use std::fmt;

/// One frame, as the host drew it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Frame {
    /// Hash of the picture.
    pub(crate) hash: u64,
    /// Bytes of the picture.
    pub(crate) bytes: usize,
    /// Triangles submitted.
    pub(crate) triangles: u32,
    /// Pixels written by the measured part.
    pub(crate) pixels: u64,
}

/// Counts pixels where the board counts instructions.
#[derive(Debug, Default)]
pub(crate) struct Counter {
    /// Pixels of the frame so far.
    pixels: u64,
}

impl Probe for Counter {
    const COUNTING: bool = true;

    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T {
        work()
    }

    fn pixels(&mut self, written: u64) {
        self.pixels += written;
    }
}

/// Draws the first `limit` frames of a scene.
pub(crate) fn draw(scene: &Scene<Counter>, bunny: Option<Model<'_>>, limit: u32) -> Vec<Frame> {
    let (mut color, mut depth) = (vec![0; ROOM], vec![0; ROOM]);
    let mut cache = Box::default();
    let mut list = Box::new(ListRoom::NEW);
    (0..scene.frames.min(limit))
        .map(|frame| {
            // As the firmware does: a frame must not depend on what was drawn before it.
            color.fill(0);
            depth.fill(0);
            let mut counter = Counter::default();
            let mut stage = Stage {
                color: &mut color,
                depth: &mut depth,
                cache: &mut cache,
                bunny,
                list: &mut list,
            };
            let facts = (scene.draw)(&mut stage, frame, &mut counter);
            Frame {
                hash: hash::picture(&color, facts.bytes),
                bytes: facts.bytes,
                triangles: facts.triangles,
                pixels: counter.pixels,
            }
        })
        .collect()
}

/// The scenes that a list of names asks for: `bands`, `gallery`, `golden`, `standard`, `all` or names.
///
/// # Errors
/// A name that no scene has.
pub(crate) fn asked(names: &[String]) -> Result<Vec<Scene<Counter>>, String> {
    use super::scenes::Group;
    let wants = |scene: &Scene<Counter>, name: &String| match name.as_str() {
        "all" => true,
        "bands" => scene.group == Group::Bands,
        "gallery" => scene.group == Group::Gallery,
        "golden" => scene.group == Group::Golden,
        "standard" => scene.group == Group::Standard,
        name => scene.name == name,
    };
    for name in names {
        if !scenes::<Counter>().any(|scene| wants(&scene, name)) {
            let known: Vec<_> = scenes::<Counter>().map(|scene| scene.name).collect();
            return Err(format!(
                "there is no scene `{name}`; choose bands, gallery, golden, standard, all or of {}",
                known.join(", ")
            ));
        }
    }
    Ok(scenes().filter(|scene| names.iter().any(|name| wants(scene, name))).collect())
}

/// One line of facts: a scene on a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    board: &'static str,
    scene: String,
    frames: u64,
    instructions: u64,
    pixels: u64,
    triangles: u64,
    hash: u64,
    /// The first frame in which the board differs, and what it drew there.
    pub(crate) differs: Option<String>,
}

impl Line {
    /// Compares what a board's report says of a scene.
    pub(crate) fn of(
        board: &'static str,
        scene: &str,
        report: &Report,
        expected: &[Frame],
    ) -> Self {
        let own = report.frames.iter().filter(|frame| frame.scene == scene);
        Self::compare(board, scene, &own.cloned().collect::<Vec<_>>(), expected)
    }

    /// Compares a scene's frames; sums are over all frames.
    pub(crate) fn compare(
        board: &'static str,
        scene: &str,
        drawn: &[Drawn],
        expected: &[Frame],
    ) -> Self {
        let differs = if drawn.len() == expected.len() {
            let mut pairs = drawn.iter().zip(expected);
            let wrong = pairs.find(|(drawn, expected)| {
                (drawn.hash, drawn.bytes) != (expected.hash, expected.bytes)
            });
            wrong.map(|(drawn, expected)| {
                format!(
                    "frame {}: the board drew {:016x} in {} bytes, the host {:016x} in {}",
                    drawn.frame, drawn.hash, drawn.bytes, expected.hash, expected.bytes
                )
            })
        } else {
            Some(format!("the board drew {} frames, the host {}", drawn.len(), expected.len()))
        };
        // Of several frames, the hash of their hashes, as the board drew them.
        let hash = match drawn {
            [one] => one.hash,
            several => several
                .iter()
                .fold(hash::START, |state, frame| hash::fnv1a(state, &frame.hash.to_le_bytes())),
        };
        Self {
            board,
            scene: scene.to_string(),
            frames: drawn.len() as u64,
            instructions: drawn.iter().map(|frame| frame.instructions).sum(),
            pixels: expected.iter().map(|frame| frame.pixels).sum(),
            triangles: expected.iter().map(|frame| u64::from(frame.triangles)).sum(),
            hash,
            differs,
        }
    }
}

impl Line {
    /// The board's name.
    pub(crate) const fn board(&self) -> &'static str {
        self.board
    }

    /// Instructions of a frame, the mean.
    pub(crate) fn mean_instructions(&self) -> u64 {
        self.mean(self.instructions)
    }

    /// The mean of a frame of a sum over all frames.
    fn mean(&self, sum: u64) -> u64 {
        (sum + self.frames / 2).checked_div(self.frames).unwrap_or(0)
    }

    /// The scene's name.
    pub(crate) fn scene(&self) -> &str {
        &self.scene
    }

    /// Frames that were drawn.
    pub(crate) const fn frames(&self) -> u64 {
        self.frames
    }

    /// Instructions of all frames.
    pub(crate) const fn instructions(&self) -> u64 {
        self.instructions
    }

    /// Pixels of all frames.
    pub(crate) const fn pixels(&self) -> u64 {
        self.pixels
    }

    /// Triangles of all frames.
    pub(crate) const fn triangles(&self) -> u64 {
        self.triangles
    }
}

impl fmt::Display for Line {
    /// Figures are the means of a frame.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "board={} scene={} instructions={} pixels={} triangles={}",
            self.board,
            self.scene,
            self.mean_instructions(),
            self.mean(self.pixels),
            self.mean(self.triangles)
        )?;
        for (name, count) in [("per_pixel", self.pixels), ("per_triangle", self.triangles)] {
            if count > 0 {
                write!(f, " {name}={:.2}", self.instructions as f64 / count as f64)?;
            } else {
                write!(f, " {name}=-")?;
            }
        }
        let equal = if self.differs.is_none() { "yes" } else { "no" };
        write!(f, " hash={:016x} equal={equal}", self.hash)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_names_of_their_own() {
        let mut names: Vec<_> = scenes::<Counter>().map(|scene| scene.name).collect();
        names.sort_unstable();
        let twice: Vec<_> = names.windows(2).filter(|pair| pair[0] == pair[1]).collect();
        assert!(twice.is_empty(), "{twice:?}");
    }

    fn drawn(frame: u32, hash: u64) -> Drawn {
        Drawn { scene: "S1".into(), frame, instructions: 1000, hash, bytes: 8 }
    }

    fn expected(hash: u64) -> Frame {
        Frame { hash, bytes: 8, triangles: 10, pixels: 400 }
    }

    #[test]
    fn a_line_has_the_form_that_is_kept() {
        let line = Line::compare("m4", "S1", &[drawn(0, 7)], &[expected(7)]);
        assert_eq!(
            line.to_string(),
            "board=m4 scene=S1 instructions=1000 pixels=400 triangles=10 per_pixel=2.50 \
             per_triangle=100.00 hash=0000000000000007 equal=yes"
        );
    }

    #[test]
    fn several_frames_give_means_and_one_hash() {
        let frames = [drawn(0, 7), drawn(1, 8)];
        let line = Line::compare("m4", "S1", &frames, &[expected(7), expected(8)]).to_string();
        assert!(line.contains("instructions=1000 pixels=400 triangles=10"), "printed {line}");
        let swapped = [drawn(0, 8), drawn(1, 7)];
        let other = Line::compare("m4", "S1", &swapped, &[expected(8), expected(7)]).to_string();
        assert!(line != other, "the order of frames must change the hash");
    }

    #[test]
    fn one_wrong_frame_and_one_missing_frame_differ() {
        let frames = [drawn(0, 7), drawn(1, 9)];
        let line = Line::compare("m4", "S1", &frames, &[expected(7), expected(8)]);
        assert!(line.to_string().ends_with("equal=no"), "printed {line}");
        assert!(line.differs.is_some_and(|why| why.starts_with("frame 1")), "which frame");
        let line = Line::compare("m4", "S1", &frames[..1], &[expected(7), expected(8)]);
        assert!(line.differs.is_some(), "a frame is missing");
    }
}
