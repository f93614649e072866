//! Puts what was measured between the marks of a Markdown file; prose around them is written by
//! hand.

use std::fmt::Write as _;
use std::path::Path;

/// A Markdown file with marked blocks.
#[derive(Debug)]
pub(crate) struct Document {
    text: String,
    name: String,
}

impl Document {
    /// Reads it.
    ///
    /// # Errors
    /// The file is not there.
    pub(crate) fn read(file: &Path) -> Result<Self, String> {
        let name = file.display().to_string();
        let text = std::fs::read_to_string(file).map_err(|why| format!("{name}: {why}"))?;
        Ok(Self { text, name })
    }

    /// Replaces what stands in a block.
    ///
    /// # Errors
    /// There is no such block.
    pub(crate) fn put(&mut self, block: &str, content: &str) -> Result<(), String> {
        let begin = format!("<!-- {block}: made by `cargo tradeoff`, not by hand -->");
        let end = format!("<!-- end of {block} -->");
        let replaced = self.text.split_once(&begin).and_then(|(before, rest)| {
            let (_, after) = rest.split_once(&end)?;
            let mut text = String::new();
            // Writing to a string cannot fail.
            let _ = write!(text, "{before}{begin}\n{content}\n{end}{after}");
            Some(text)
        });
        self.text = replaced
            .ok_or_else(|| format!("{}: no block between `{begin}` and `{end}`", self.name))?;
        Ok(())
    }

    /// Writes it back.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn write(&self) -> Result<(), String> {
        std::fs::write(&self.name, &self.text).map_err(|why| format!("{}: {why}", self.name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_is_replaced_and_a_missing_one_is_an_error() {
        let text =
            "a\n<!-- x: made by `cargo tradeoff`, not by hand -->\nold\n<!-- end of x -->\nb";
        let mut document = Document { text: text.into(), name: "T.md".into() };
        assert_eq!(document.put("x", "new"), Ok(()));
        assert_eq!(document.text, text.replace("old", "new"));
        assert!(document.put("y", "new").is_err());
    }
}
