//! Ways to find a triangle's pixels: their cost, counted on the host by callgrind. Only the first is
//! built for boards.

use clap::ValueEnum;
use microraster::raster::AnyTraversal;
use microraster::{Cull, Flat, Frame, Gouraud, Less, Pass, Rgb565};
use std::fmt::Write as _;
use std::process::{Command, Stdio};

use crate::scenes::hash;
use crate::scenes::standard::{camera, light, SIZE};
use crate::scenes::ROOM;
use crate::table::millions;
use crate::tradeoff::meshes::{Distant, Subject, Teapot};
use crate::tradeoff::slivers;

/// What is drawn.
const SCENES: [&str; 3] = ["teapot", "distant", "slivers"];

/// A way to find pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Way {
    Spans,
    BoundingBox,
    Blocks,
    BlockWalk,
}

impl Way {
    fn traversal(self) -> AnyTraversal {
        match self {
            Self::Spans => AnyTraversal::Spans,
            Self::BoundingBox => AnyTraversal::Box,
            Self::Blocks => AnyTraversal::Blocks,
            Self::BlockWalk => AnyTraversal::Walk,
        }
    }
}

/// Draws a scene so many times, and gives the hash of the picture.
///
/// # Errors
/// A scene that is none of these.
pub(crate) fn draw(scene: &str, way: Way, times: u32) -> Result<u64, String> {
    let (mut words, mut depth) = (vec![0_u32; ROOM / 2], vec![0; ROOM]);
    for _ in 0..times {
        words.fill(0);
        let frame = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(&mut words), SIZE)
            .and_then(|frame| frame.with_depth(&mut depth));
        let mut frame = frame.map_err(|why| why.to_string())?;
        frame.clear_depth(0);
        let camera = camera();
        let pass = Pass::new(&camera).depth(Less).traversal(way.traversal());
        match scene {
            "slivers" => {
                let shape = slivers::shape();
                let mesh = shape.mesh(&slivers::COLORS).by_face();
                let mut pass = pass;
                pass.draw(&mut frame, &shape.model, &mesh, &Flat::colored());
            }
            "teapot" | "distant" => {
                let subject = if scene == "teapot" { Teapot::shape } else { Distant::shape };
                let (shape, normals) = subject(None);
                let mesh = shape.mesh(normals);
                let shader = Gouraud::new(light());
                pass.cull(Cull::Back).draw(&mut frame, &shape.model, &mesh, &shader);
            }
            _ => return Err(format!("`{scene}` is no scene of traversals")),
        }
    }
    Ok(hash::picture(&words, 2 * ROOM))
}

/// Instructions of a frame on the host: what ten more frames cost, over ten.
fn count(scene: &str, way: Way) -> Result<u64, String> {
    let [one, eleven] = [1, 11].map(|times| collected(scene, way, times));
    Ok((eleven?.saturating_sub(one?)) / 10)
}

/// All instructions of a run of this program that draws so many frames.
fn collected(scene: &str, way: Way, times: u32) -> Result<u64, String> {
    let program = std::env::current_exe().map_err(|why| why.to_string())?;
    let name = way.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default();
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(["--traversal", &name, "--scene", scene, "--times", &times.to_string()])
        .stdin(Stdio::null())
        .output()
        .map_err(|why| format!("cannot start valgrind: {why}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let line = text.lines().find_map(|line| line.split_once("Collected : "));
    line.and_then(|(_, count)| count.trim().parse().ok())
        .ok_or_else(|| format!("valgrind printed no count:\n{text}"))
}

/// A table of all ways and scenes.
///
/// # Errors
/// There is no valgrind, or two ways draw different pictures.
pub(crate) fn table() -> Result<String, String> {
    let mut text = String::from("| traversal |");
    // Writing to a string cannot fail.
    for scene in SCENES {
        let _ = write!(text, " {scene} |");
    }
    let _ = write!(text, "\n| --- |{}", " ---: |".repeat(SCENES.len()));
    for way in Way::value_variants() {
        let mark = if *way == Way::Spans { "**" } else { "" };
        let name = way.to_possible_value();
        let name = name.as_ref().map_or("", |value| value.get_name());
        let _ = write!(text, "\n| {mark}{name}{mark} |");
        for scene in SCENES {
            if draw(scene, *way, 1)? != draw(scene, Way::Spans, 1)? {
                return Err(format!("{name} draws another picture of {scene} than spans"));
            }
            let _ = write!(text, " {} |", millions(count(scene, *way)?));
        }
    }
    Ok(text)
}
