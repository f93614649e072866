//! `microraster simulate`: a model file in, TGA pictures out.

pub(crate) mod options;
mod picture;
mod render;
mod view;

use indicatif::{ProgressBar, ProgressStyle};
use microraster::host::{fnv1a64_after, AtomicFile, MeshData, Model, FNV1A64_START};
use options::{Cull, Format, PictureSize, Shade, Switch, Traversal};
use picture::Picture;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use view::View;

/// What stands under the options in `--help`.
const EXAMPLES: &str = "\
Examples:
  microraster simulate
      The bundled teapot, 320x240, into out.tga.
  microraster simulate model.obj -o model.tga --size 240x240 --yaw 120 --pitch 30
      Your own model on a square display, turned and seen from above.
  microraster simulate model.obj -o turn.tga --frames 36
      turn-000.tga to turn-035.tga: the model turns once, 10 degrees a picture.
  microraster simulate soup.asc --shade flat --format rgba8888 --depth off
      A triangle soup in its own order: what is drawn later covers what is there.

At the end one line of facts goes to standard output:
  model=teapot triangles=... drawn=... clipped=... pixels=... hash=... ms=...
    triangles  in the model
    drawn      triangles that reached the rasterizer
    clipped    triangles cut at the near plane or far beyond the picture's edge, drawn or not
    pixels     written, each time one is
    hash       FNV-1a (64 bits) of the colour bytes as they lie in memory
    ms         spent on drawing, without reading and writing files
Of several pictures, counts and times are sums, and the hash is of all bytes in order.

Warnings about the model go to standard error. On an error the exit code is 1, and no picture is
written, replaced or left unfinished. A run that is interrupted may leave hidden files beside the
pictures, named .FILE.tga.NUMBER.part; they can be removed.";

/// Draw a model into a TGA picture, as a display would show it.
///
/// The model is seen in the middle of the picture, where it fills 80 % of the height (less if its
/// width would not fit; with --frames, over the whole turn), with a field of view of 45 degrees,
/// under one directional light and ambient light, before dark blue.
#[derive(Debug, clap::Args)]
#[command(after_long_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The model: MODEL.obj, or MODEL.asc, a triangle soup [default: the bundled teapot]
    ///
    /// A soup is the word `triangle` and three times `x y z nx ny nz u v`, and so on. An OBJ file
    /// may name material libraries in its own folder or below.
    model: Option<PathBuf>,

    /// The picture to write
    ///
    /// With --frames, FILE-000.tga and so on. It appears when it is complete.
    #[arg(short, long, value_name = "FILE.tga", default_value = "out.tga")]
    output: PathBuf,

    /// Width and height in pixels, each 1 to 8192
    #[arg(long, value_name = "WxH", default_value = "320x240")]
    size: PictureSize,

    /// The display's pixel format; the picture shows what is left of the colours
    #[arg(long, value_enum, default_value_t = Format::Rgb565)]
    format: Format,

    /// Light each face, or each corner and blend
    #[arg(long, value_enum, default_value_t = Shade::Gouraud)]
    shade: Shade,

    /// Whether a 16-bit depth buffer sorts the pixels
    #[arg(long, value_enum, default_value_t = Switch::On)]
    depth: Switch,

    /// Turn the model about its upright axis, in degrees, counter-clockwise as seen from above
    #[arg(long, value_name = "DEG", default_value_t = 30.0, allow_negative_numbers = true)]
    yaw: f32,

    /// Look down on the model, in degrees; negative looks up
    #[arg(long, value_name = "DEG", default_value_t = 20.0, allow_negative_numbers = true)]
    pitch: f32,

    /// Draw this many pictures, in which the model turns a full circle
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1000))]
    frames: Option<u16>,

    /// How the pixels of a triangle are found; all four find the same
    #[arg(long, value_enum, default_value_t = Traversal::Spans)]
    traversal: Traversal,

    /// Which faces are left out: front faces are counter-clockwise as seen
    #[arg(long, value_enum, default_value_t = Cull::None)]
    cull: Cull,
}

/// Draws and writes all pictures, then prints the facts.
///
/// # Errors
///
/// A message for the user: the model cannot be loaded, an argument makes no sense, or a picture
/// cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let paths = output_paths(&arguments.output, arguments.frames)?;
    let (name, model) = load(arguments.model.as_deref())?;
    let views = View::all(arguments, &model)?;

    let parts = MeshData::of_model(&model, arguments.shade == Shade::Flat);

    // Pictures stay under temporary names until all are complete.
    let bar = progress(paths.len());
    let mut facts = Facts::default();
    let mut files = Vec::new();
    for (path, view) in paths.iter().zip(&views) {
        let mut picture = Picture::new(arguments.size, arguments.format);
        let start = Instant::now();
        let cannot = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        render::render(view, &parts, &mut picture).map_err(|error| cannot(&error))?;
        facts.add(&picture, start.elapsed());
        let mut file = AtomicFile::create(path).map_err(|error| cannot(&error))?;
        if arguments.model.as_deref().is_some_and(|model| is_same(model, file.target())) {
            return Err(cannot(&"this is the model; write the picture elsewhere"));
        }
        picture.write_tga(&mut file).map_err(|error| cannot(&error))?;
        file.seal().map_err(|error| cannot(&error))?;
        files.push(file);
        bar.inc(1);
    }
    bar.finish_and_clear();
    for file in files {
        let path = file.target().display().to_string();
        file.commit().map_err(|error| format!("{path}: {error}"))?;
    }

    let line = facts.line(&name, model.triangle_count());
    match writeln!(io::stdout(), "{line}") {
        // A reader that has seen enough, like `head`, is no error.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(format!("cannot print: {error}"))
        }
        _ => Ok(()),
    }
}

/// The name for the facts, and the model; its warnings are printed.
fn load(path: Option<&Path>) -> Result<(String, Model), String> {
    /// Cells along the side of a patch: 6320 triangles.
    const TEAPOT_DIVISIONS: u8 = 10;
    let Some(path) = path else {
        return Ok(("teapot".to_owned(), Model::teapot(TEAPOT_DIVISIONS)));
    };
    let model = Model::load(path).map_err(|error| error.to_string())?;
    for warning in &model.warnings {
        eprintln!("microraster: warning: {warning}");
    }
    // The facts are words: a name is one.
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Ok((name.replace(char::is_whitespace, "_"), model))
}

/// Whether two paths lead to one file that exists.
fn is_same(a: &Path, b: &Path) -> bool {
    let [a, b] = [a, b].map(std::fs::canonicalize);
    matches!((a, b), (Ok(a), Ok(b)) if a == b)
}

/// The file of each picture.
fn output_paths(output: &Path, frames: Option<u16>) -> Result<Vec<PathBuf>, String> {
    let is_tga = output.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("tga"));
    let Some(stem) = output.file_stem().filter(|_| is_tga) else {
        let output = output.display();
        return Err(format!("{output}: pictures are TGA; end the name in .tga"));
    };
    let Some(frames) = frames else {
        return Ok(vec![output.to_path_buf()]);
    };
    let named = |frame| {
        let mut name = stem.to_owned();
        name.push(format!("-{frame:03}.tga"));
        output.with_file_name(name)
    };
    Ok((0..frames).map(named).collect())
}

/// A bar on standard error for several pictures, if that is a terminal.
fn progress(pictures: usize) -> ProgressBar {
    if pictures < 2 {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(pictures as u64);
    match ProgressStyle::with_template("{bar:40} {pos}/{len} pictures, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// What the pictures so far have told.
#[derive(Debug)]
struct Facts {
    drawn: u64,
    clipped: u64,
    pixels: u64,
    hash: u64,
    time: Duration,
}

impl Default for Facts {
    fn default() -> Self {
        Self { drawn: 0, clipped: 0, pixels: 0, hash: FNV1A64_START, time: Duration::ZERO }
    }
}

impl Facts {
    fn add(&mut self, picture: &Picture, time: Duration) {
        self.drawn += picture.drawn;
        self.clipped += picture.clipped;
        self.pixels += picture.pixels;
        self.hash = fnv1a64_after(self.hash, &picture.bytes);
        self.time += time;
    }

    fn line(&self, model: &str, triangles: usize) -> String {
        format!(
            "model={model} triangles={triangles} drawn={} clipped={} pixels={} hash={:016x} ms={:.1}",
            self.drawn,
            self.clipped,
            self.pixels,
            self.hash,
            self.time.as_secs_f64() * 1e3
        )
    }
}
