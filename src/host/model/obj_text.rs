//! What stands in front of the OBJ reader: every line checked, and written anew in the few forms
//! that the reader takes without fail.
//!
//! The reader (`tobj`) names no lines, stops at continued ones, fills missing normals with the
//! previous ones and opens whatever a file tells it to. So it never sees the file, but this:
//!
//! ```text
//! vt inf inf          the texture coordinate of corners that have none
//! vn 0 0 0            the normal of corners that have none
//! v 1 2 3             three numbers, as written in the file
//! o 2                 the faces that follow have material 2
//! f 1/2/1 2/3/1 3/1/4 three or more corners, all indices present, positive, in range
//! ```

use super::lines::{Continuation, Lines};
use super::obj_checker::Checker;
use super::ModelError;
use std::io::{self, BufRead, Read};
use std::path::Path;
use std::prelude::rust_2021::*;

/// The file as checked lines, to be read by `tobj`.
#[derive(Debug)]
pub(super) struct ObjText<'a, R> {
    lines: Lines<'a, R>,
    checker: Checker<'a>,
    /// Where the next byte to read lies in the checker's output.
    at: usize,
    /// Why reading ended early.
    pub(super) failure: Option<ModelError>,
}

impl<'a, R: BufRead> ObjText<'a, R> {
    pub(super) fn new(reader: R, path: &'a Path) -> Self {
        Self {
            lines: Lines::new(reader, path, Continuation::Backslash),
            checker: Checker::new(path),
            at: 0,
            failure: None,
        }
    }

    /// The line that was read last.
    pub(super) fn line(&self) -> usize {
        self.lines.last()
    }

    pub(super) fn into_checker(self) -> Checker<'a> {
        self.checker
    }

    /// Reads lines until there is something to give; false at the end of the file.
    fn refill(&mut self) -> Result<bool, ModelError> {
        self.checker.out.clear();
        self.at = 0;
        while self.checker.out.is_empty() {
            match self.lines.next(&mut self.checker.warnings)? {
                Some((line, text)) => self.checker.line(line, text)?,
                None => return Ok(false),
            }
        }
        Ok(true)
    }
}

impl<R: BufRead> BufRead for ObjText<'_, R> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.at >= self.checker.out.len() {
            if let Err(failure) = self.refill() {
                self.failure = Some(failure);
                return Err(io::Error::other("a line was refused"));
            }
        }
        Ok(self.checker.out.get(self.at..).unwrap_or_default())
    }

    fn consume(&mut self, bytes: usize) {
        self.at += bytes;
    }
}

impl<R: BufRead> Read for ObjText<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.fill_buf()?.read(buffer)?;
        self.consume(read);
        Ok(read)
    }
}
