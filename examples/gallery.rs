//! Draws pictures of the gallery into TGA files.
//!
//! `cargo run --features std --example gallery` lists them; `... -- NAME` draws one into `NAME.tga`,
//! `-o FILE.tga` elsewhere, `--frames N` a turn of N frames into numbered files.

#[path = "gallery/mod.rs"]
mod gallery;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use gallery::{Canvas, Picture, PICTURES, PIXELS, WORDS};
use microraster::host::{AtomicFile, Tga};
use microraster::{Format, Rgb565, Stats};

const USAGE: &str = "usage: gallery NAME [-o FILE.tga] [--frames N]";

/// What the command line asks for.
struct Request {
    picture: &'static Picture,
    file: PathBuf,
    frames: Option<u16>,
}

impl Request {
    fn parse(mut words: impl Iterator<Item = String>) -> Result<Self, String> {
        let (mut name, mut file, mut frames) = (None, None, None);
        while let Some(word) = words.next() {
            match word.as_str() {
                "-o" => file = Some(words.next().ok_or("-o wants a file")?.into()),
                "--frames" => {
                    let count = words.next().ok_or("--frames wants a number")?;
                    let count: u16 = count.parse().map_err(|_| format!("{count}: no number"))?;
                    frames = Some(count);
                }
                _ if word.starts_with('-') => return Err(format!("{word}: unknown\n{USAGE}")),
                _ if name.is_some() => return Err(format!("{word}: one too many\n{USAGE}")),
                _ => name = Some(word),
            }
        }
        let name = name.ok_or(USAGE)?;
        let picture = PICTURES.iter().find(|picture| picture.name == name);
        let picture = picture.ok_or_else(|| format!("there is no picture `{name}`"))?;
        Ok(Self { picture, file: file.unwrap_or_else(|| format!("{name}.tga").into()), frames })
    }
}

/// Draws a picture at a turn into a file.
fn draw(picture: &Picture, turn: f32, file: &Path) -> Result<Stats, String> {
    let (mut pixels, mut depth) = (vec![0; PIXELS], vec![0; PIXELS]);
    let mut canvas = Canvas {
        picture: picture.size,
        first_row: 0,
        rows: picture.size.height,
        pixels: &mut pixels,
        depth: &mut depth,
        words: &mut vec![0; WORDS],
    };
    let mut stats = Stats::default();
    (picture.draw)(&mut canvas, turn, &mut stats).map_err(|why| why.to_string())?;

    let (width, height) = (picture.size.width.into(), picture.size.height.into());
    let colors = pixels.iter().take(width * height).map(|pixel| {
        let color = Rgb565::unpack(*pixel);
        [color.red(), color.green(), color.blue(), 255]
    });
    let colors: Vec<_> = colors.collect();
    let why = |error: &dyn std::fmt::Display| format!("{}: {error}", file.display());
    let tga = Tga::new(width, height).map_err(|error| why(&error))?;
    let mut output = AtomicFile::create(file).map_err(|error| why(&error))?;
    tga.write(&mut output, &colors).map_err(|error| why(&error))?;
    output.commit().map_err(|error| why(&error))?;
    Ok(stats)
}

fn run() -> Result<(), String> {
    let words: Vec<_> = std::env::args().skip(1).collect();
    if words.is_empty() {
        println!("{USAGE}\n");
        for picture in &PICTURES {
            println!("{:12} {}", picture.name, picture.about);
        }
        return Ok(());
    }
    let Request { picture, file, frames } = Request::parse(words.into_iter())?;
    let Some(frames) = frames else {
        let stats = draw(picture, picture.turn, &file)?;
        println!("{}: {stats:?}", file.display());
        return Ok(());
    };
    for frame in 0..frames {
        let turn = picture.turn + 360.0 * f32::from(frame) / f32::from(frames);
        let numbered = file.with_extension(format!("{frame:04}.tga"));
        draw(picture, turn, &numbered)?;
    }
    println!("{frames} frames");
    Ok(())
}

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("gallery: {message}");
            ExitCode::FAILURE
        }
    }
}
