//! A file that appears whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::{format, process};

/// Tells apart the temporary files of one process.
static COUNTER: AtomicU32 = AtomicU32::new(0);

/// A file under construction: bytes go to a temporary sibling, [`commit`](Self::commit) renames
/// it to its real name, and dropping it without that removes it.
///
/// So a reader sees the old file or the new one, never a part, and an error halfway leaves
/// nothing behind; a process that is killed leaves the temporary file, `.NAME.NUMBER.part`. To publish several files together, write and [`seal`](Self::seal) each, then
/// commit all.
///
/// ```
/// use microraster::host::AtomicFile;
/// use std::io::Write;
///
/// # fn main() -> std::io::Result<()> {
/// let path = std::env::temp_dir().join("microraster-doc-atomic.txt");
/// let mut file = AtomicFile::create(&path)?;
/// file.write_all(b"whole")?;
/// assert!(!path.exists());
/// file.commit()?;
/// assert_eq!(std::fs::read(&path)?, b"whole");
/// # std::fs::remove_file(&path)
/// # }
/// ```
#[derive(Debug)]
pub struct AtomicFile {
    target: PathBuf,
    temporary: PathBuf,
    /// `None` once sealed: a long sequence of pictures must not hold a handle each.
    writer: Option<BufWriter<File>>,
    committed: bool,
}

impl AtomicFile {
    /// Opens a temporary file in the folder of `target`.
    ///
    /// A symbolic link as target stays one: the file that it names is replaced, or made where it
    /// does not exist.
    ///
    /// # Errors
    ///
    /// The folder does not exist or may not be written, or `target` exists and is no regular
    /// file: a device or a folder is never replaced.
    pub fn create(target: impl AsRef<Path>) -> io::Result<Self> {
        let target = followed(target.as_ref())?;
        let Some(name) = target.file_name() else {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
        };

        // A name that nobody else has: a leading dot, the process, a counter.
        let mut hidden = OsString::from(".");
        hidden.push(name);
        let count = COUNTER.fetch_add(1, Ordering::Relaxed);
        hidden.push(format!(".{}-{count}.part", process::id()));
        let temporary = target.with_file_name(hidden);
        let file = OpenOptions::new().write(true).create_new(true).open(&temporary)?;

        Ok(Self { target, temporary, writer: Some(BufWriter::new(file)), committed: false })
    }

    /// Where the file will appear.
    #[must_use]
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// Writes out what is buffered and closes the temporary file; writing ends here.
    ///
    /// # Errors
    ///
    /// The last bytes could not be written (a full disk, as a rule).
    pub fn seal(&mut self) -> io::Result<()> {
        match self.writer.take() {
            Some(mut writer) => writer.flush(),
            None => Ok(()),
        }
    }

    /// Seals the file and gives it its name, in place of a file that had it before.
    ///
    /// # Errors
    ///
    /// Sealing or renaming failed; the temporary file is removed then.
    pub fn commit(mut self) -> io::Result<()> {
        self.seal()?;
        fs::rename(&self.temporary, &self.target)?;
        self.committed = true;
        Ok(())
    }
}

/// Where a file is or will be, behind all links.
fn followed(target: &Path) -> io::Result<PathBuf> {
    /// As many links as Linux follows.
    const LINKS: usize = 40;
    let mut target = target.to_path_buf();
    for _ in 0..LINKS {
        match fs::symlink_metadata(&target) {
            Ok(there) if there.is_symlink() => {
                let named = fs::read_link(&target)?;
                target = target.parent().unwrap_or(Path::new("")).join(named);
            }
            Ok(there) if !there.is_file() => {
                return Err(io::Error::new(
                    io::ErrorKind::InvalidInput,
                    "it exists and is no regular file",
                ));
            }
            // A file to replace, or none; what else is wrong shows when the file is opened.
            _ => return Ok(target),
        }
    }
    Err(io::Error::new(io::ErrorKind::InvalidInput, "too many links lead to each other"))
}

impl Write for AtomicFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.writer {
            Some(writer) => writer.write(bytes),
            None => Err(io::Error::other("the file is sealed")),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.writer {
            Some(writer) => writer.flush(),
            None => Ok(()),
        }
    }
}

impl Drop for AtomicFile {
    fn drop(&mut self) {
        if !self.committed {
            drop(self.writer.take());
            // Nobody is left to tell: an error here stays silent.
            let _ = fs::remove_file(&self.temporary);
        }
    }
}
