//! Why a model was not loaded, and where.

use std::path::{Path, PathBuf};
use std::prelude::rust_2021::*;
use std::{error, fmt};

/// Why a model file was not loaded: which file, which line, what is wrong, what to do.
///
/// Its text is one line in the form that editors follow:
///
/// ```text
/// cube.obj:12: position 9 does not exist, 8 have been read; correct the index
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ModelError {
    /// The file in which it was found: the model, or a material library.
    pub path: PathBuf,
    /// The line, counted from 1; `None` where the file as a whole is meant.
    pub line: Option<usize>,
    /// What is wrong.
    pub reason: String,
    /// What to do about it.
    pub advice: String,
}

impl ModelError {
    pub(super) fn new(
        path: &Path,
        line: impl Into<Option<usize>>,
        reason: impl Into<String>,
        advice: impl Into<String>,
    ) -> Self {
        Self {
            path: path.to_path_buf(),
            line: line.into(),
            reason: reason.into(),
            advice: advice.into(),
        }
    }
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.path.display())?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        write!(f, " {}; {}", self.reason, self.advice)
    }
}

impl error::Error for ModelError {}
