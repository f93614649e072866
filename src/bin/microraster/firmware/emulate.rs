//! Runs firmware under QEMU, or WebAssembly in node, and gives what it printed.

use super::board::{Board, Emulator};
use super::build::House;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// How long one run may take. A wrong memory map hangs rather than fails.
const PATIENCE: Duration = Duration::from_secs(240);

/// What serves WebAssembly, in the package's folder.
const NODE_SCRIPT: &str = "examples/board/node.mjs";

/// Runs `elf` on `board` with these words, in the folder where it finds its files, and returns
/// the lines that it printed. `plugin` is an argument for QEMU's `-plugin`.
///
/// # Errors
/// No emulator, a run that took too long, or firmware that ended with an error.
pub(crate) fn run(
    board: &Board,
    elf: &Path,
    folder: &Path,
    words: &[String],
    plugin: Option<&str>,
) -> Result<String, String> {
    // Absolute, because the emulator runs elsewhere.
    let absolute =
        |path: &Path| std::path::absolute(path).map_err(|why| format!("{}: {why}", path.display()));
    let elf = absolute(elf)?;
    let (program, before) = match board.emulator() {
        Emulator::Qemu(program, before) => (program, before),
        Emulator::Node => {
            let script = absolute(&House::find()?.package.join(NODE_SCRIPT))?;
            let mut command = Command::new("node");
            command.arg(script).arg(elf).args(words);
            return watch(board, command, folder, "nodejs");
        }
    };
    let mut semihosting = String::from("enable=on,target=native,arg=firmware");
    for word in words {
        semihosting.push_str(",arg=");
        semihosting.push_str(word);
    }
    let mut command = Command::new(program);
    command
        .args(before)
        .args(["-machine", board.machine])
        .args(["-display", "none", "-monitor", "none", "-serial", "none"])
        .args(["-icount", "shift=7", "-semihosting-config", &semihosting])
        .args(plugin.map(|plugin| ["-plugin", plugin]).into_iter().flatten())
        .arg("-kernel")
        .arg(elf);
    watch(board, command, folder, "qemu-system-arm qemu-system-misc")
}

/// Runs a command in a folder and gives what it printed; `packages` are Debian's that have it.
fn watch(
    board: &Board,
    mut command: Command,
    folder: &Path,
    packages: &str,
) -> Result<String, String> {
    let program = command.get_program().to_string_lossy().into_owned();
    command
        .current_dir(folder)
        .env_remove("LD_LIBRARY_PATH")
        .stdin(Stdio::null())
        .stdout(Stdio::piped());
    let mut child = command.spawn().map_err(|why| {
        format!(
            "board {}: cannot start {program}: {why}; on Debian, `apt-get install {packages}` \
             installs it",
            board.name
        )
    })?;
    // A full pipe would stop the emulator, so somebody must read while the clock is watched.
    let pipe = child.stdout.take();
    let reader = std::thread::spawn(move || {
        let mut text = Vec::new();
        let read = pipe.map_or(Ok(0), |mut pipe| pipe.read_to_end(&mut text));
        read.map(|_| String::from_utf8_lossy(&text).into_owned())
    });
    let status = wait(&mut child).map_err(|why| format!("board {}: {why}", board.name))?;
    let printed = reader
        .join()
        .map_err(|_| "the thread that reads the emulator's output stopped".to_string())?
        .map_err(|why| format!("cannot read what the firmware prints: {why}"))?;
    match status {
        0 => Ok(printed),
        code => Err(format!(
            "the firmware of board {} ended with status {code} (101: a panic, 134: a fault); it \
             printed:\n{printed}",
            board.name
        )),
    }
}

/// The exit status of `child`, which is ended when it takes too long.
fn wait(child: &mut Child) -> Result<i32, String> {
    let start = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return Ok(status.code().unwrap_or(134)),
            Ok(None) if start.elapsed() < PATIENCE => {
                std::thread::sleep(Duration::from_millis(10));
            }
            Ok(None) => {
                let ended = child.kill().and_then(|()| child.wait());
                let seconds = PATIENCE.as_secs();
                return Err(match ended {
                    Ok(_) => format!("the firmware ran longer than {seconds} s and was ended"),
                    Err(why) => {
                        format!("it ran longer than {seconds} s and cannot be ended: {why}")
                    }
                });
            }
            Err(why) => return Err(format!("lost the emulator: {why}")),
        }
    }
}
