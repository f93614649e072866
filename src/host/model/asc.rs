//! The triangle soup: `triangle`, then three times `x y z nx ny nz u v`.

use super::builder::{Builder, RawCorner};
use super::lines::{quoted, Continuation, Lines};
use super::warning::Warnings;
use super::{too_many, Material, Model, ModelError};
use std::format;
use std::io::BufRead;
use std::path::Path;
use std::prelude::rust_2021::*;

/// How many numbers a corner has.
const PER_CORNER: usize = 8;

/// How many numbers a triangle has.
const PER_TRIANGLE: usize = 3 * PER_CORNER;

pub(super) fn read(reader: impl BufRead, path: &Path) -> Result<Model, ModelError> {
    let mut warnings = Warnings::default();
    let mut lines = Lines::new(reader, path, Continuation::None);
    let mut builder = Builder::default();
    let group = builder.group(Material::named(""));

    // The numbers of the triangle that is being read; `None` between triangles.
    let mut numbers: Option<Vec<f32>> = None;
    let mut triangles = 0;
    while let Some((line, text)) = lines.next(&mut warnings)? {
        let meaning = text.split('#').next().unwrap_or_default();
        for word in meaning.split_whitespace() {
            let Some(so_far) = &mut numbers else {
                if word != "triangle" {
                    return Err(unexpected(path, line, word));
                }
                numbers = Some(Vec::with_capacity(PER_TRIANGLE));
                continue;
            };
            so_far.push(number(path, line, word, so_far.len())?);
            if so_far.len() == PER_TRIANGLE {
                if triangles == Model::LIMIT {
                    return Err(too_many(path, line, "triangles"));
                }
                triangles += 1;
                add(&mut builder, group, so_far);
                numbers = None;
            }
        }
    }

    if let Some(so_far) = numbers {
        return Err(ModelError::new(
            path,
            lines.last(),
            format!(
                "the file ends after {} of the {PER_TRIANGLE} numbers of a triangle",
                so_far.len()
            ),
            "complete the triangle or remove it",
        ));
    }
    if triangles == 0 {
        return Err(ModelError::new(
            path,
            lines.last(),
            "the file ends without a triangle",
            "check that this is the file you meant",
        ));
    }
    let mut model = builder.finish();
    model.warnings = warnings.into_vec(path);
    Ok(model)
}

/// Adds the triangle of 24 numbers.
fn add(builder: &mut Builder, group: usize, numbers: &[f32]) {
    let mut corners = numbers.chunks_exact(PER_CORNER).map(|corner| {
        let at = |index: usize| corner.get(index).copied().unwrap_or_default();
        RawCorner {
            position: builder.position([at(0), at(1), at(2)]),
            normal: builder.normal([at(3), at(4), at(5)]),
            texture: Some(builder.texture([at(6), at(7)])),
        }
    });
    if let (Some(a), Some(b), Some(c)) = (corners.next(), corners.next(), corners.next()) {
        builder.triangle(group, [a, b, c]);
    }
}

/// The finite number that `word` is, the `index`-th of its triangle.
fn number(path: &Path, line: usize, word: &str, index: usize) -> Result<f32, ModelError> {
    const NAMES: [&str; PER_CORNER] = ["x", "y", "z", "nx", "ny", "nz", "u", "v"];
    match word.parse::<f32>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(ModelError::new(
            path,
            line,
            format!(
                "{} of corner {} is {}, no finite number",
                NAMES.get(index % PER_CORNER).copied().unwrap_or_default(),
                index / PER_CORNER + 1,
                quoted(word)
            ),
            format!("write {PER_CORNER} numbers for each corner: x y z nx ny nz u v"),
        )),
    }
}

fn unexpected(path: &Path, line: usize, word: &str) -> ModelError {
    ModelError::new(
        path,
        line,
        format!("{} stands where `triangle` should", quoted(word)),
        format!("begin each triangle with that word; {PER_TRIANGLE} numbers follow it"),
    )
}
