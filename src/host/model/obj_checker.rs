//! One line of an OBJ file at a time: checked, counted, written anew.

use super::lines::quoted;
use super::warning::Warnings;
use super::{too_many, Model, ModelError};
use std::collections::{BTreeSet, HashMap};
use std::format;
use std::io::Write;
use std::path::Path;
use std::prelude::rust_2021::*;

/// How many corners a face may have.
const MOST_CORNERS: usize = 1 << 17;

/// How often the material may change: each change costs the reader a model of its own.
const MOST_CHANGES: usize = 1 << 16;

/// How many material libraries are looked for.
const MOST_LIBRARIES: usize = 16;

/// The attributes before those of the file, for corners that lack them.
const PROLOGUE: &[u8] = b"vt inf inf\nvn 0 0 0\n";

/// Keywords that group or name things, with no bearing on the picture.
const SILENT: [&str; 4] = ["o", "g", "s", "mg"];

/// What the lines so far have told.
#[derive(Debug)]
pub(super) struct Checker<'a> {
    path: &'a Path,
    /// What is left of the last line, and at first the prologue.
    pub(super) out: Vec<u8>,
    positions: usize,
    texture_coordinates: usize,
    normals: usize,
    triangles: usize,
    changes: usize,
    /// The material in force, and the one of the last face.
    material: usize,
    written: Option<usize>,
    numbers: HashMap<String, usize>,
    noted: BTreeSet<String>,
    /// The names after `usemtl`, each once; the first is that of faces before any.
    pub(super) materials: Vec<String>,
    /// What stands after `mtllib`, and where.
    pub(super) libraries: Vec<(usize, String)>,
    pub(super) warnings: Warnings,
}

impl<'a> Checker<'a> {
    pub(super) fn new(path: &'a Path) -> Self {
        Self {
            path,
            out: PROLOGUE.to_vec(),
            positions: 0,
            texture_coordinates: 0,
            normals: 0,
            triangles: 0,
            changes: 0,
            material: 0,
            written: None,
            numbers: HashMap::from([(String::new(), 0)]),
            noted: BTreeSet::new(),
            materials: Vec::from([String::new()]),
            libraries: Vec::new(),
            warnings: Warnings::default(),
        }
    }
}

impl Checker<'_> {
    /// Checks one line and writes what is left of it.
    pub(super) fn line(&mut self, line: usize, text: &str) -> Result<(), ModelError> {
        let text = text.trim();
        let (keyword, rest) = text
            .split_once(char::is_whitespace)
            .map_or((text, ""), |(keyword, rest)| (keyword, rest.trim()));
        // A comment may follow numbers; within a word `#` is none (`1.#INF` of old C libraries).
        let numbers = match rest.find(" #").or_else(|| rest.find("\t#")) {
            Some(comment) => rest.get(..comment).unwrap_or_default(),
            None if rest.starts_with('#') => "",
            None => rest,
        };
        match keyword {
            "v" => self.position(line, numbers),
            "vt" => self.texture_coordinate(line, numbers),
            "vn" => self.normal(line, numbers),
            "f" | "fo" => self.face(line, numbers),
            "usemtl" => self.use_material(line, rest),
            "mtllib" => {
                self.library(line, rest);
                Ok(())
            }
            "" => Ok(()),
            _ if keyword.starts_with('#') || SILENT.contains(&keyword) => Ok(()),
            "l" | "p" => {
                self.note(line, keyword, "lines and points are left out");
                Ok(())
            }
            _ => {
                let reason = format!("the keyword {} is not used", quoted(keyword));
                self.note(line, keyword, reason);
                Ok(())
            }
        }
    }

    fn position(&mut self, line: usize, numbers: &str) -> Result<(), ModelError> {
        let words = self.numbers(line, numbers, 3, "a position")?;
        // Faces with such a position are left out later, when it is known which these are.
        if words.iter().flatten().any(|(_, number)| !number.is_finite()) {
            let reason = "a position is infinite or no number; its faces are left out";
            self.warnings.push(self.path, line, reason);
        }
        count(&mut self.positions, self.path, line, "positions")?;
        self.write("v", words);
        Ok(())
    }

    fn texture_coordinate(&mut self, line: usize, numbers: &str) -> Result<(), ModelError> {
        let [u, v, _] = self.numbers(line, numbers, 1, "a texture coordinate")?;
        let zero = Some(("0", 0.0));
        let mut words = [u, v.or(zero), None];
        if words.iter().flatten().any(|(_, number)| !number.is_finite()) {
            let reason = "a texture coordinate is infinite or no number; it becomes 0 0";
            self.warnings.push(self.path, line, reason);
            words = [zero, zero, None];
        }
        count(&mut self.texture_coordinates, self.path, line, "texture coordinates")?;
        self.write("vt", words);
        Ok(())
    }

    fn normal(&mut self, line: usize, numbers: &str) -> Result<(), ModelError> {
        let words = self.numbers(line, numbers, 3, "a normal")?;
        count(&mut self.normals, self.path, line, "normals")?;
        self.write("vn", words);
        Ok(())
    }

    fn face(&mut self, line: usize, corners: &str) -> Result<(), ModelError> {
        let length = corners.split_whitespace().count();
        if length < 3 {
            let reason = format!("a face of {length} corners is left out");
            self.warnings.push(self.path, line, reason);
            return Ok(());
        }
        if length > MOST_CORNERS {
            return Err(ModelError::new(
                self.path,
                line,
                format!("the face has {length} corners, more than {MOST_CORNERS}"),
                "split the face",
            ));
        }
        self.triangles += length - 2;
        if self.triangles > Model::LIMIT {
            return Err(too_many(self.path, line, "triangles"));
        }

        self.name_material(line)?;
        self.out.push(b'f');
        for corner in corners.split_whitespace() {
            self.corner(line, corner)?;
        }
        self.out.push(b'\n');
        Ok(())
    }

    /// Tells the reader of the material in force, if it is not that of the last face.
    fn name_material(&mut self, line: usize) -> Result<(), ModelError> {
        if self.written == Some(self.material) {
            return Ok(());
        }
        self.changes += 1;
        if self.changes > MOST_CHANGES {
            return Err(ModelError::new(
                self.path,
                line,
                format!("the material changes more than {MOST_CHANGES} times"),
                "sort the faces by material",
            ));
        }
        self.written = Some(self.material);
        let material = self.material;
        self.put(format_args!("o {material}\n"));
        Ok(())
    }

    /// Checks a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` and writes all three indices.
    fn corner(&mut self, line: usize, corner: &str) -> Result<(), ModelError> {
        let mut parts = corner.split('/');
        let mut part = || parts.next().filter(|part| !part.is_empty());
        let (v, vt, vn) = (part(), part(), part());
        if parts.next().is_some() || v.is_none() {
            return Err(ModelError::new(
                self.path,
                line,
                format!("{} is no corner of a face", quoted(corner)),
                "write v, v/vt, v//vn or v/vt/vn",
            ));
        }
        let v = self.index(line, v, self.positions, "position")?;
        let vt = self.optional(line, vt, self.texture_coordinates, "texture coordinate");
        let vn = self.optional(line, vn, self.normals, "normal");
        // The prologue holds number 1 of both, for corners without.
        self.put(format_args!(
            " {}/{}/{}",
            v.unwrap_or(1),
            vt.map_or(1, |vt| vt + 1),
            vn.map_or(1, |vn| vn + 1)
        ));
        Ok(())
    }

    /// The index of an attribute that a face can do without: a wrong one is left out.
    fn optional(
        &mut self,
        line: usize,
        word: Option<&str>,
        read: usize,
        what: &str,
    ) -> Option<usize> {
        self.index(line, word, read, what).unwrap_or_else(|error| {
            let reason = format!("{}; it is left out", error.reason);
            self.note(line, what, reason);
            None
        })
    }

    /// The index that `word` means, counted from 1, when `read` values have been read.
    fn index(
        &self,
        line: usize,
        word: Option<&str>,
        read: usize,
        what: &str,
    ) -> Result<Option<usize>, ModelError> {
        let Some(word) = word else { return Ok(None) };
        let error = |reason: String, advice: &str| ModelError::new(self.path, line, reason, advice);
        let number: i64 = word.parse().map_err(|_| {
            let reason = format!("{} is no index of a {what}", quoted(word));
            error(reason, "write a whole number")
        })?;
        let index = match usize::try_from(number.unsigned_abs()) {
            Ok(0) => {
                let reason = format!("a {what} has the index 0");
                return Err(error(reason, "count from 1, or from -1 backwards"));
            }
            Ok(back) if number < 0 => (read + 1).checked_sub(back).filter(|&index| index > 0),
            Ok(index) => Some(index).filter(|&index| index <= read),
            Err(_) => None,
        };
        match index {
            Some(index) => Ok(Some(index)),
            None => Err(error(
                format!("{what} {number} does not exist, {read} have been read so far"),
                "correct the index, or move the face behind what it uses",
            )),
        }
    }

    fn use_material(&mut self, line: usize, name: &str) -> Result<(), ModelError> {
        if let Some(&number) = self.numbers.get(name) {
            self.material = number;
            return Ok(());
        }
        if self.materials.len() >= MOST_CHANGES {
            return Err(ModelError::new(
                self.path,
                line,
                format!("more than {MOST_CHANGES} materials"),
                "merge materials",
            ));
        }
        self.material = self.materials.len();
        self.materials.push(name.to_owned());
        self.numbers.insert(name.to_owned(), self.material);
        Ok(())
    }

    fn library(&mut self, line: usize, names: &str) {
        if names.is_empty() {
            self.warnings.push(self.path, line, "mtllib names no file");
        } else if self.libraries.iter().any(|(_, known)| known == names) {
            // Exporters repeat the line before each object.
        } else if self.libraries.len() < MOST_LIBRARIES {
            self.libraries.push((line, names.to_owned()));
        } else {
            let reason = format!("only {MOST_LIBRARIES} mtllib lines are followed");
            self.note(line, "mtllib", reason);
        }
    }

    /// Warns of `keyword` once.
    fn note(&mut self, line: usize, keyword: &str, reason: impl Into<String>) {
        /// A file of noise must not fill the memory with its words.
        const MOST: usize = 64;
        if self.noted.len() < MOST && self.noted.insert(keyword.chars().take(32).collect()) {
            self.warnings.push(self.path, line, reason);
        }
    }

    /// The first three words of `text`, of which `needed` must be there, as numbers.
    fn numbers<'t>(
        &self,
        line: usize,
        text: &'t str,
        needed: usize,
        what: &str,
    ) -> Result<[Option<(&'t str, f32)>; 3], ModelError> {
        let mut numbers = [None; 3];
        let mut words = text.split_whitespace();
        for (index, number) in numbers.iter_mut().enumerate() {
            let Some(word) = words.next() else {
                if index >= needed {
                    break;
                }
                return Err(ModelError::new(
                    self.path,
                    line,
                    format!("{what} needs {needed} numbers and has {index}"),
                    "complete the line; the file may be cut off",
                ));
            };
            *number = Some(match word.parse::<f32>() {
                Ok(parsed) => (word, parsed),
                Err(_) if word.contains(".#") => ("nan", f32::NAN),
                Err(_) => {
                    return Err(ModelError::new(
                        self.path,
                        line,
                        format!("{} is no number", quoted(word)),
                        "write it like -1.5 or 2e-3",
                    ))
                }
            });
        }
        Ok(numbers)
    }

    fn write(&mut self, keyword: &str, words: [Option<(&str, f32)>; 3]) {
        self.put(format_args!("{keyword}"));
        for (word, _) in words.into_iter().flatten() {
            self.put(format_args!(" {word}"));
        }
        self.out.push(b'\n');
    }

    fn put(&mut self, text: std::fmt::Arguments<'_>) {
        // A `Vec` takes all bytes.
        let _ = self.out.write_fmt(text);
    }
}

/// Counts one more of `what`, within the limit.
fn count(counter: &mut usize, path: &Path, line: usize, what: &str) -> Result<(), ModelError> {
    *counter += 1;
    if *counter > Model::LIMIT {
        return Err(too_many(path, line, what));
    }
    Ok(())
}
