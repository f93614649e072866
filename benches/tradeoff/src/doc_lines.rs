//! Figures in the documentation of the crate's knobs: a line that follows a mark with the name of a
//! case is made anew.
//!
//! ```text
//! /// <!-- tradeoff: plane-10/perspective=exact -->
//! /// In the scene `plane-10`: ...
//! ```

use std::path::{Path, PathBuf};

use crate::costs::BOARDS;
use crate::row::Row;
use crate::table::{millions, number};

const MARK: &str = "/// <!-- tradeoff: ";

/// What is said of a case.
fn line(row: &Row) -> String {
    let by_pixel = row.triangles <= 16 && row.pixels > 0;
    let count = |board: usize| {
        let count = row.cost.instructions[board];
        if by_pixel {
            number(count as f64 / row.pixels as f64)
        } else {
            millions(count)
        }
    };
    let unit = if by_pixel { "instructions a pixel" } else { "instructions a frame" };
    let counts: Vec<_> = BOARDS
        .iter()
        .enumerate()
        .map(|(board, (_, name))| format!("{} ({name})", count(board)))
        .collect();
    let (setting, scene) = (row.case.setting(), &row.case.scene);
    let mut text = format!("`{setting}` in the scene `{scene}`: {} {unit}", counts.join(", "));
    if let Some(texels) = row.errors.texels {
        text += &format!("; {} texels off, {} at most", number(texels.mean), number(texels.max));
    }
    if row.errors.color.psnr.is_finite() {
        text += &format!("; PSNR {:.1} dB", row.errors.color.psnr);
    }
    text + "."
}

/// Makes the lines of all files of a folder anew; files that do not change are not written.
///
/// # Errors
/// A mark with the name of no case, or a file that cannot be read or written.
pub(crate) fn renew(folder: &Path, rows: &[Row]) -> Result<(), String> {
    for file in files(folder)? {
        let cannot = |why: &dyn std::fmt::Display| format!("{}: {why}", file.display());
        let text = std::fs::read_to_string(&file).map_err(|why| cannot(&why))?;
        if let Some(renewed) = renewed(&text, rows).map_err(|why| cannot(&why))? {
            std::fs::write(&file, renewed).map_err(|why| cannot(&why))?;
        }
    }
    Ok(())
}

/// A text with its lines made anew; `None` if that changes nothing.
fn renewed(text: &str, rows: &[Row]) -> Result<Option<String>, String> {
    let mut lines = text.split('\n').map(str::to_owned).collect::<Vec<_>>();
    for at in 0..lines.len() {
        let Some((indent, rest)) = lines[at].split_once(MARK) else { continue };
        let (indent, name) = (indent.to_owned(), rest.trim_end_matches(" -->").to_owned());
        let Some(row) = rows.iter().find(|row| row.case.name() == name) else {
            return Err(format!("there is no case `{name}`"));
        };
        let new = format!("{indent}/// {}", line(row));
        match lines.get_mut(at + 1) {
            Some(next) => *next = new,
            None => return Err(format!("nothing follows the mark of `{name}`")),
        }
    }
    let renewed = lines.join("\n");
    Ok((renewed != text).then_some(renewed))
}

fn files(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let cannot = |why: std::io::Error| format!("{}: {why}", folder.display());
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(cannot)? {
        let path = entry.map_err(cannot)?.path();
        if path.is_dir() {
            files.extend(self::files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mark_of_no_case_is_an_error() {
        let text = format!("    {MARK}a/b=c -->\n    /// old");
        assert!(renewed(&text, &[]).is_err());
        assert_eq!(renewed("fn a() {}\n", &[]), Ok(None));
    }
}
