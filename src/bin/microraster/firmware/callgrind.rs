//! The scenes on the host: instructions of the measured parts, counted by callgrind.

use super::scenes::{self, ListRoom, Model, Probe, Stage, ROOM};
use std::process::{Command, Stdio};

/// Runs what is measured, in a function that callgrind knows by its name.
struct Runner;

/// The part that callgrind counts.
#[inline(never)]
fn measured_part<T>(work: impl FnOnce() -> T) -> T {
    // Not the last thing that the function does, so that no call becomes a jump.
    std::hint::black_box(work())
}

impl Probe for Runner {
    const COUNTING: bool = false;

    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T {
        measured_part(work)
    }

    fn pixels(&mut self, _written: u64) {}
}

/// Draws all frames of a scene and nothing else.
///
/// # Errors
/// No measured scene has this name.
pub(crate) fn draw(name: &str, bunny: Option<Model<'_>>) -> Result<(), String> {
    let scene = scenes::standard::<Runner>().find(|scene| scene.name == name);
    let scene = scene.ok_or_else(|| format!("there is no measured scene `{name}`"))?;
    let (mut color, mut depth) = (vec![0; ROOM], vec![0; ROOM]);
    let mut cache = Box::default();
    let mut list = Box::new(ListRoom::NEW);
    for frame in 0..scene.frames {
        color.fill(0);
        depth.fill(0);
        let mut stage = Stage {
            color: &mut color,
            depth: &mut depth,
            cache: &mut cache,
            bunny,
            list: &mut list,
        };
        (scene.draw)(&mut stage, frame, &mut Runner);
    }
    Ok(())
}

/// Whether callgrind can be started.
pub(crate) fn is_installed() -> bool {
    let version = Command::new("valgrind").arg("--version").stdin(Stdio::null()).output();
    version.is_ok_and(|output| output.status.success())
}

/// Instructions of all frames of a scene, of this program under callgrind.
///
/// # Errors
/// Callgrind cannot be started, or counted nothing.
pub(crate) fn count(scene: &str) -> Result<u64, String> {
    let program = std::env::current_exe().map_err(|why| why.to_string())?;
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .args(["--collect-atstart=no", "--toggle-collect=*measured_part*"])
        .arg(program)
        .args(["firmware", "--on-host", scene])
        .stdin(Stdio::null())
        .output()
        .map_err(|why| format!("cannot start valgrind: {why}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    collected(&text).ok_or_else(|| format!("callgrind counted nothing of {scene}:\n{text}"))
}

/// The count in what callgrind printed; `None` where there is none, or nothing was counted.
fn collected(text: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.split_once("Collected : "));
    line.and_then(|(_, count)| count.trim().parse().ok()).filter(|count| *count > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_is_found() {
        let text = |count| format!("==1== Events    : Ir\n==1== Collected : {count}\n==1==\n");
        assert_eq!(collected(&text("75321")), Some(75_321), "as callgrind prints it");
        assert_eq!(collected(&text("0")), None, "the function was not found");
        assert_eq!(collected("==1== Events    : Ir\n"), None, "it ended early");
    }
}
