//! What was left out of a model that loads all the same.

use std::fmt;
use std::path::{Path, PathBuf};
use std::prelude::rust_2021::*;

/// Something in a model file that was left out or made up, where the rest is clear.
///
/// Its text has the form `cube.obj:12: a face of 2 corners is left out`.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ModelWarning {
    /// The file in which it was found: the model, or a material library.
    pub path: PathBuf,
    /// The line, counted from 1; `None` where the file as a whole is meant.
    pub line: Option<usize>,
    /// What was left out or made up.
    pub reason: String,
}

impl fmt::Display for ModelWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", self.path.display())?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        write!(f, " {}", self.reason)
    }
}

/// Warnings while they are gathered: the first of them, and how many more there were.
#[derive(Debug, Default)]
pub(super) struct Warnings {
    kept: Vec<ModelWarning>,
    more: usize,
}

impl Warnings {
    /// So many are kept: a hostile file must not fill the memory with them.
    const KEPT: usize = 64;

    pub(super) fn push(
        &mut self,
        path: &Path,
        line: impl Into<Option<usize>>,
        reason: impl Into<String>,
    ) {
        if self.kept.len() < Self::KEPT {
            self.kept.push(ModelWarning {
                path: path.to_path_buf(),
                line: line.into(),
                reason: reason.into(),
            });
        } else {
            self.more += 1;
        }
    }

    /// The warnings kept, then one that counts the others.
    pub(super) fn into_vec(mut self, path: &Path) -> Vec<ModelWarning> {
        if self.more > 0 {
            self.kept.push(ModelWarning {
                path: path.to_path_buf(),
                line: None,
                reason: std::format!("{} more warnings", self.more),
            });
        }
        self.kept
    }
}
