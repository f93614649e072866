//! Material libraries: found within the folder of the model, checked, then read by `tobj`.

use super::lines::{self, quoted, Continuation, Lines};
use super::warning::Warnings;
use super::{Material, ModelError};
use std::collections::HashMap;
use std::fmt::Write;
use std::path::{Component, Path, PathBuf};
use std::prelude::rust_2021::*;
use std::{format, fs};

/// The largest library, in bytes.
const LARGEST: u64 = 16 << 20;

/// How many materials of a library are read.
const MOST_MATERIALS: usize = 1 << 14;

/// How many materials all libraries may define.
const MOST_IN_ALL: usize = 1 << 16;

/// The materials of the libraries that the lines of a model name, by their names.
///
/// What is missing or may not be opened is a warning: the model has a form without it.
pub(super) fn read_all(
    model: &Path,
    libraries: &[(usize, String)],
    warnings: &mut Warnings,
) -> HashMap<String, Material> {
    let folder = match model.parent() {
        Some(folder) if folder != Path::new("") => folder,
        _ => Path::new("."),
    };
    let mut materials = HashMap::new();
    for (line, names) in libraries {
        // One name with blanks in it, or several names.
        let whole = confine(folder, names);
        let several = whole.is_err() && names.contains(char::is_whitespace);
        let names = if several {
            names.split_whitespace().take(16).collect()
        } else {
            Vec::from([names.as_str()])
        };
        for name in names {
            let loaded = confine(folder, name).and_then(|path| {
                read(folder, &path, &folder.join(name), warnings).map_err(|error| {
                    format!("{} (line {})", error.reason, error.line.unwrap_or_default())
                })
            });
            match loaded {
                Ok(library) if materials.len() <= MOST_IN_ALL => {
                    for (name, material) in library {
                        materials.entry(name).or_insert(material);
                    }
                }
                Ok(_) => warnings.push(model, *line, "too many materials; some are left out"),
                Err(reason) => warnings.push(
                    model,
                    *line,
                    format!("the material library {} is left out: {reason}", quoted(name)),
                ),
            }
        }
    }
    materials
}

/// The regular file that `name` means, if it lies in `folder` or below; links are followed first.
pub(super) fn confine(folder: &Path, name: &str) -> Result<PathBuf, String> {
    let name = name.replace('\\', "/");
    let relative = Path::new(&name);

    // Refuse by the name alone what leads out, before the file system is asked.
    let mut depth = 0_usize;
    for component in relative.components() {
        match component {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir if depth > 0 => depth -= 1,
            _ => return Err("it is not in the folder of the model".to_owned()),
        }
    }

    let cannot = |error| format!("it cannot be found ({error})");
    let folder = fs::canonicalize(folder).map_err(cannot)?;
    let path = fs::canonicalize(folder.join(relative)).map_err(cannot)?;
    if !path.starts_with(&folder) {
        return Err("a link leads out of the folder of the model".to_owned());
    }
    if !path.is_file() {
        return Err("it is no regular file".to_owned());
    }
    Ok(path)
}

/// Reads the library at `path`; `shown` stands in warnings.
fn read(
    folder: &Path,
    path: &Path,
    shown: &Path,
    warnings: &mut Warnings,
) -> Result<HashMap<String, Material>, ModelError> {
    let unreadable = |reason: String| ModelError::new(shown, None, reason, "check the file");
    let file = lines::open(path, LARGEST).map_err(unreadable)?;
    let mut lines = Lines::new(file, shown, Continuation::Backslash);

    // Write anew, in the form that the reader takes without fail, what is used.
    let mut clean = String::new();
    let mut textures = Vec::new();
    let mut count = 0;
    while let Some((line, text)) = lines.next(warnings)? {
        let text = text.trim();
        let (keyword, rest) = text
            .split_once(char::is_whitespace)
            .map_or((text, ""), |(keyword, rest)| (keyword, rest.trim()));
        let written = match keyword {
            "newmtl" if rest.is_empty() => Err("a material without a name is left out".to_owned()),
            "newmtl" => {
                count += 1;
                if count > MOST_MATERIALS {
                    warnings.push(shown, line, "more materials are left out");
                    break;
                }
                Ok(writeln!(clean, "newmtl {rest}"))
            }
            "Kd" if count > 0 => {
                color(rest).map(|[red, green, blue]| writeln!(clean, "Kd {red} {green} {blue}"))
            }
            "map_Kd" if count > 0 => texture(folder, rest).map(|path| {
                textures.push(path);
                writeln!(clean, "map_Kd {}", textures.len() - 1)
            }),
            _ => continue,
        };
        if let Err(reason) = written {
            warnings.push(shown, line, reason);
        }
    }

    let (materials, _) = tobj::load_mtl_buf(&mut clean.as_bytes())
        .map_err(|error| unreadable(format!("it is no material library ({error})")))?;
    Ok(materials
        .into_iter()
        .map(|read| {
            let texture = read
                .diffuse_texture
                .and_then(|number| textures.get(number.parse::<usize>().ok()?).cloned());
            let material = Material {
                diffuse: read.diffuse.unwrap_or(Material::GREY),
                texture,
                name: read.name,
            };
            (material.name.clone(), material)
        })
        .collect())
}

/// The colour `r g b`, or `r` for a grey, brought into 0..=1.
fn color(text: &str) -> Result<[f32; 3], String> {
    let mut numbers = [None; 3];
    for (number, word) in numbers.iter_mut().zip(text.split_whitespace()) {
        *number = word.parse::<f32>().ok().filter(|number| number.is_finite());
        if number.is_none() {
            return Err(format!("Kd is left out: {} is no colour", quoted(word)));
        }
    }
    match numbers {
        [Some(red), Some(green), Some(blue)] => Ok([red, green, blue]),
        [Some(grey), None, None] => Ok([grey; 3]),
        _ => Err("Kd is left out: it needs 3 numbers".to_owned()),
    }
    .map(|color| color.map(|channel| channel.clamp(0.0, 1.0)))
}

/// The texture file, which stands behind any options.
fn texture(folder: &Path, text: &str) -> Result<PathBuf, String> {
    let name = if text.starts_with('-') {
        text.split_whitespace().next_back().unwrap_or_default()
    } else {
        text
    };
    if name.is_empty() {
        return Err("map_Kd names no file".to_owned());
    }
    confine(folder, name)
        .map_err(|reason| format!("the texture {} is left out: {reason}", quoted(name)))
}
