//! A text file as lines: numbered, joined where one continues, clean, and never too long.

use super::warning::Warnings;
use super::ModelError;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Take};
use std::path::Path;
use std::prelude::rust_2021::*;
use std::{format, fs};

/// Opens a regular file of at most `largest` bytes; the error is a reason without its path.
///
/// Devices and pipes are not opened: they may never end.
pub(super) fn open(path: &Path, largest: u64) -> Result<BufReader<Take<File>>, String> {
    let cannot = |error| format!("it cannot be read ({error})");
    let facts = fs::metadata(path).map_err(cannot)?;
    if !facts.is_file() {
        return Err("it is no regular file".to_owned());
    }
    if facts.len() > largest {
        return Err(format!("it has {} bytes, and at most {largest} are read", facts.len()));
    }
    let file = File::open(path).map_err(cannot)?;
    // The file may grow while it is read.
    Ok(BufReader::with_capacity(1 << 16, file.take(largest)))
}

/// Whether lines that end in a backslash continue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Continuation {
    #[cfg_attr(
        not(feature = "tools"),
        allow(dead_code, reason = "only OBJ and MTL files continue lines")
    )]
    Backslash,
    None,
}

/// The lines of a text file.
///
/// Line ends may be LF or CR LF; a byte order mark and NUL bytes are dropped; bytes that are no
/// UTF-8 become replacement characters, for names in an old encoding do no harm.
#[derive(Debug)]
pub(super) struct Lines<'a, R> {
    reader: R,
    path: &'a Path,
    continuation: Continuation,
    /// The line that was read last, counted from 1.
    last: usize,
    saw_nul: bool,
    bytes: Vec<u8>,
    text: String,
}

impl Lines<'_, ()> {
    /// The largest model file, in bytes.
    pub(super) const LARGEST_FILE: u64 = 256 << 20;

    /// The longest line, in bytes, its continuations included.
    const LONGEST: usize = 4 << 20;
}

impl<'a, R: BufRead> Lines<'a, R> {
    pub(super) fn new(reader: R, path: &'a Path, continuation: Continuation) -> Self {
        Self {
            reader,
            path,
            continuation,
            last: 0,
            saw_nul: false,
            bytes: Vec::new(),
            text: String::new(),
        }
    }

    /// The line that was read last, counted from 1; 1 before the first.
    pub(super) fn last(&self) -> usize {
        self.last.max(1)
    }

    /// The next line and its number, that of its first part; `None` at the end of the file.
    pub(super) fn next(
        &mut self,
        warnings: &mut Warnings,
    ) -> Result<Option<(usize, &str)>, ModelError> {
        self.bytes.clear();
        let first = self.last + 1;
        let mut any = false;
        loop {
            let start = self.bytes.len();
            if self.append()? == 0 {
                break;
            }
            any = true;
            self.last += 1;
            self.refuse_wide_text()?;
            self.trim_end(start);
            if self.continuation == Continuation::Backslash && self.bytes.last() == Some(&b'\\') {
                self.bytes.pop();
                self.bytes.push(b' ');
                continue;
            }
            break;
        }
        if !any {
            return Ok(None);
        }

        // NUL bytes come from files that were padded or cut; what surrounds them is meant.
        if self.bytes.contains(&0) {
            self.bytes.retain(|&byte| byte != 0);
            if !self.saw_nul {
                self.saw_nul = true;
                warnings.push(self.path, first, "NUL bytes are left out");
            }
        }
        self.text.clear();
        self.text.push_str(&String::from_utf8_lossy(&self.bytes));
        Ok(Some((first, &self.text)))
    }

    /// Appends the bytes of one line, its end included; how many these are.
    fn append(&mut self) -> Result<usize, ModelError> {
        let room = Lines::LONGEST.saturating_sub(self.bytes.len());
        let read =
            self.reader.by_ref().take(room as u64 + 1).read_until(b'\n', &mut self.bytes).map_err(
                |error| {
                    ModelError::new(
                        self.path,
                        self.last + 1,
                        format!("it cannot be read ({error})"),
                        "check the file",
                    )
                },
            )?;
        if read > room {
            return Err(ModelError::new(
                self.path,
                self.last + 1,
                format!("the line is longer than {} bytes", Lines::LONGEST),
                "check that the file is text, or split the line",
            ));
        }
        Ok(read)
    }

    /// Drops the line end of the part that begins at `start`, and blanks before it.
    fn trim_end(&mut self, start: usize) {
        while self.bytes.len() > start && self.bytes.last().is_some_and(u8::is_ascii_whitespace) {
            self.bytes.pop();
        }
    }

    /// Handles the byte order mark of the first line.
    fn refuse_wide_text(&mut self) -> Result<(), ModelError> {
        if self.last != 1 {
            return Ok(());
        }
        if self.bytes.starts_with(&[0xef, 0xbb, 0xbf]) {
            self.bytes.drain(..3);
        }
        if self.bytes.starts_with(&[0xfe, 0xff]) || self.bytes.starts_with(&[0xff, 0xfe]) {
            return Err(ModelError::new(
                self.path,
                1,
                "the text is UTF-16",
                "save the file as UTF-8",
            ));
        }
        Ok(())
    }
}

/// The word for a message: escaped, and cut if it is long.
pub(super) fn quoted(word: &str) -> String {
    let mut short: String = word.chars().take(24).collect();
    if short.len() < word.len() {
        short.push('…');
    }
    format!("{short:?}")
}
