//! The table of figures in a Markdown file, made from what was just measured.

use std::fmt;
use std::path::Path;

const END: &str = "<!-- end of figures -->";

/// The line before a table; a file with several tables has a name for each.
fn begin(name: &str) -> String {
    let space = if name.is_empty() { "" } else { " " };
    format!("<!-- figures{space}{name}: made by `cargo firmware`, not by hand -->")
}

/// Rows of the table, one a figure; a cell a board.
#[derive(Debug, Default)]
pub(crate) struct Figures {
    boards: Vec<String>,
    rows: Vec<(String, Vec<String>)>,
}

impl Figures {
    /// Starts a column.
    pub(crate) fn board(&mut self, name: &str) {
        self.boards.push(name.to_owned());
    }

    /// Puts a figure into the column that was started last.
    pub(crate) fn put(&mut self, what: &str, figure: String) {
        let column = self.boards.len().saturating_sub(1);
        let row = match self.rows.iter().position(|(name, _)| name == what) {
            Some(row) => row,
            None => {
                self.rows.push((what.to_owned(), Vec::new()));
                self.rows.len() - 1
            }
        };
        if let Some((_, cells)) = self.rows.get_mut(row) {
            cells.resize(column, String::new());
            cells.push(figure);
        }
    }

    /// Replaces what stands between the marks of this name, which may be empty.
    ///
    /// # Errors
    /// The file cannot be read or written, or has no such marks.
    pub(crate) fn write(&self, file: &Path, name: &str) -> Result<(), String> {
        let cannot = |why: &dyn std::fmt::Display| format!("{}: {why}", file.display());
        let text = std::fs::read_to_string(file).map_err(|why| cannot(&why))?;
        let replaced = self.replaced(&text, name).ok_or_else(|| {
            cannot(&format!("figures go between the lines `{}` and `{END}`", begin(name)))
        })?;
        std::fs::write(file, replaced).map_err(|why| cannot(&why))
    }

    fn replaced(&self, text: &str, name: &str) -> Option<String> {
        let begin = begin(name);
        let (before, rest) = text.split_once(&begin)?;
        let (_, after) = rest.split_once(END)?;
        Some(format!("{before}{begin}\n{}\n{END}{after}", self))
    }
}

impl fmt::Display for Figures {
    /// As Markdown, without a last end of line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("| |")?;
        self.boards.iter().try_for_each(|board| write!(f, " {board} |"))?;
        write!(f, "\n| --- |{}", " ---: |".repeat(self.boards.len()))?;
        self.rows.iter().try_for_each(|(what, cells)| {
            let mut cells = cells.clone();
            cells.resize(self.boards.len(), String::new());
            write!(f, "\n| {what} | {} |", cells.join(" | "))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_takes_the_place_of_the_old_one() {
        let mut figures = Figures::default();
        figures.board("m4");
        figures.put("one", "1".into());
        figures.board("m0");
        figures.put("one", "2".into());
        figures.put("late", "3".into());
        figures.board("rv32");
        figures.put("one", "4".into());
        let table = "| | m4 | m0 | rv32 |\n| --- | ---: | ---: | ---: |\n| one | 1 | 2 | 4 |\n\
                     | late |  | 3 |  |";
        let (first, second) = (begin(""), begin("ladder m4"));
        let text = |one: &str, two: &str| {
            format!("above\n{first}\n{one}\n{END}\nbelow\n{second}\n{two}\n{END}\nend\n")
        };
        let old = text("old", "older");
        assert_eq!(figures.replaced(&old, ""), Some(text(table, "older")), "the first");
        assert_eq!(figures.replaced(&old, "ladder m4"), Some(text("old", table)), "the second");
        assert_eq!(figures.replaced("no marks", ""), None, "nowhere to put it");
        assert_eq!(figures.replaced(&old, "ladder"), None, "no such name");
    }
}
