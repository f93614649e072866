//! Builds for a bare target: with rustup's core library where the target is installed, else with
//! a core library that Debian's compiler builds from its own source.

use super::board::{Board, Emulator};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The places that a build needs.
#[derive(Debug)]
pub(crate) struct House {
    /// The folder of the package's `Cargo.toml`.
    pub(crate) package: PathBuf,
    /// Cargo's target folder.
    pub(crate) target: PathBuf,
    /// What of the standard library is built where the target's is not installed.
    pub(crate) libraries: &'static str,
    /// How firmware is built.
    pub(crate) profile: Profile,
}

/// How firmware is built.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Profile {
    /// As it is measured.
    Release,
    /// Sooner, for its pictures alone: nothing of it is measured.
    Pictures,
}

impl Profile {
    /// As cargo names it, and the folder of what it builds.
    const fn name(self) -> &'static str {
        match self {
            Self::Release => "release",
            Self::Pictures => "pictures",
        }
    }
}

/// Where Debian keeps its compiler; rustup's may come first on the path.
const DEBIAN_RUSTC: &str = "/usr/bin/rustc";
const DEBIAN_CARGO: &str = "/usr/bin/cargo";
/// Names of the linker, the newest that the recipe was proven with first.
const LINKERS: [&str; 2] = ["ld.lld-22", "ld.lld"];
/// The same for WebAssembly.
const WASM_LINKERS: [&str; 2] = ["wasm-ld-22", "wasm-ld"];
/// A counter that stands still, for boards that have theirs in different places: one firmware then
/// serves all.
const NO_COUNTER: &[&str] = &["__counter=__sbss", "__counter_ps=0"];
/// What of the caller's environment would change a nested build. RUSTFLAGS, for one, replaces the
/// link arguments of `.cargo/config.toml`, and the firmware would come out empty.
const FOREIGN: [&str; 8] = [
    "RUSTFLAGS",
    "CARGO_ENCODED_RUSTFLAGS",
    "CARGO_BUILD_RUSTFLAGS",
    "CARGO_BUILD_TARGET",
    "CARGO_UNSTABLE_BUILD_STD",
    "LD_LIBRARY_PATH",
    "RUSTC_WRAPPER",
    "RUSTC_WORKSPACE_WRAPPER",
];

/// The mesh that firmware reads, or that is linked into it.
pub(crate) const MESH_FILE: &str = "bunny.mesh";

/// Names the feature to the examples that are built for one at a time.
const FEATURE: &str = "MICRORASTER_FEATURE";

impl House {
    /// Finds the package: cargo names it when it runs this program.
    ///
    /// # Errors
    /// This program was not started from a checkout.
    pub(crate) fn find() -> Result<Self, String> {
        let package = std::env::var_os("CARGO_MANIFEST_DIR")
            .map_or_else(|| PathBuf::from("."), PathBuf::from);
        if !package.join("examples/firmware.rs").is_file() || !package.join("memory.x").is_file() {
            return Err("examples/firmware.rs and memory.x are not here: firmware is built from \
                        the crate's repository; run `cargo firmware` inside a clone of it"
                .into());
        }
        let target = std::env::var_os("CARGO_TARGET_DIR")
            .map_or_else(|| package.join("target"), |folder| package.join(PathBuf::from(folder)));
        Ok(Self { package, target, libraries: "core", profile: Profile::Release })
    }

    /// The folder for finished firmware and what it reads, made when missing.
    ///
    /// # Errors
    /// The folder cannot be made.
    pub(crate) fn firmware(&self) -> Result<PathBuf, String> {
        let folder = self.target.join("firmware");
        std::fs::create_dir_all(&folder)
            .map_err(|why| format!("cannot make the folder {}: {why}", folder.display()))?;
        Ok(folder)
    }

    /// Builds an example for a board and returns a copy of its ELF file that stays.
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    pub(crate) fn example(&self, name: &str, board: &Board) -> Result<PathBuf, String> {
        self.example_of(name, "", board)
    }

    /// The same of an example that is built for one `feature` at a time.
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    pub(crate) fn example_of(
        &self,
        name: &str,
        feature: &str,
        board: &Board,
    ) -> Result<PathBuf, String> {
        self.example_with(name, feature, board, &[])
    }

    /// The same with what the linker knew of who refers to whom, for [`super::elf::references`].
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    pub(crate) fn example_with_references(
        &self,
        name: &str,
        feature: &str,
        board: &Board,
    ) -> Result<PathBuf, String> {
        self.example_with(name, feature, board, &["-C", "link-arg=--emit-relocs"])
    }

    /// Builds an example with more `options` for the compiler, which may name the mesh file of
    /// [`firmware`](Self::firmware) by the environment's `MICRORASTER_MESH`.
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    pub(crate) fn example_with(
        &self,
        name: &str,
        feature: &str,
        board: &Board,
        options: &[&str],
    ) -> Result<PathBuf, String> {
        let mut arguments = vec!["--example", name];
        arguments.push("--");
        arguments.extend(options);
        let counter = match self.profile {
            Profile::Pictures if !board.counter.is_empty() => NO_COUNTER,
            _ => board.counter,
        };
        let symbols = board.symbols.iter().chain(counter);
        let symbols: Vec<_> = symbols.map(|symbol| format!("link-arg=--defsym={symbol}")).collect();
        for symbol in &symbols {
            arguments.extend(["-C", symbol]);
        }
        let file = match board.emulator() {
            Emulator::Node => format!("{name}.wasm"),
            Emulator::Qemu(..) => name.to_owned(),
        };
        let built = self.cargo(board.target, feature, &arguments)?.join("examples").join(file);
        let variant = if feature.is_empty() { "" } else { "-" };
        let variant = format!("{variant}{}", feature.replace(' ', "-"));
        let profile = match self.profile {
            Profile::Release => "",
            Profile::Pictures => "-pictures",
        };
        let kept = self.firmware()?.join(format!("{name}{variant}-{}{profile}.elf", board.name));
        std::fs::copy(&built, &kept)
            .map_err(|why| format!("cannot copy {}: {why}", built.display()))?;
        Ok(kept)
    }

    /// Builds the bare library for a target.
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    pub(crate) fn library(&self, target: &str) -> Result<(), String> {
        self.cargo(target, "", &["--lib", "--"]).map(|_| ())
    }

    /// Builds the package's program for a board, with more `options` for the compiler.
    ///
    /// # Errors
    /// No compiler for the target, or the build failed.
    #[allow(dead_code, reason = "for packages of firmware, which this one is not")]
    pub(crate) fn program(
        &self,
        name: &str,
        board: &Board,
        options: &[&str],
    ) -> Result<PathBuf, String> {
        let mut arguments = vec!["--bin", name, "--"];
        arguments.extend(options);
        Ok(self.cargo(board.target, "", &arguments)?.join(name))
    }

    /// Runs `cargo rustc` with `arguments`, which contain a `--`; returns the folder
    /// that the result lies in.
    fn cargo(&self, target: &str, feature: &str, arguments: &[&str]) -> Result<PathBuf, String> {
        let toolchain = Toolchain::find(target)?;
        let mut folder = self.target.clone();
        let mut command = match &toolchain {
            Toolchain::Rustup => Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into())),
            Toolchain::Debian { .. } => {
                // One for all targets: what runs while building is built once.
                folder = folder.join("debian");
                Command::new(DEBIAN_CARGO)
            }
        };
        for name in FOREIGN {
            command.env_remove(name);
        }
        let profile = self.profile.name();
        command.args(["rustc", "--locked", "--quiet", "--profile", profile, "--target", target]);
        command.args(arguments);
        match feature {
            "" => command.env_remove(FEATURE),
            _ => command.env(FEATURE, feature),
        };
        let mesh = std::path::absolute(self.firmware()?.join(MESH_FILE));
        command.env("MICRORASTER_MESH", mesh.map_err(|why| why.to_string())?);
        if let Toolchain::Debian { linker } = &toolchain {
            // The compiler is a release; building core needs its unstable half.
            command
                .env("RUSTC", DEBIAN_RUSTC)
                .env("RUSTC_BOOTSTRAP", "1")
                .env("CARGO_UNSTABLE_BUILD_STD", self.libraries)
                .arg("-C")
                .arg(format!("linker={linker}"));
        }
        let status = command
            .env("CARGO_TARGET_DIR", &folder)
            .current_dir(&self.package)
            .stdin(Stdio::null())
            .status()
            .map_err(|why| format!("cannot start cargo: {why}"))?;
        if status.success() {
            Ok(folder.join(target).join(profile))
        } else {
            Err(format!("the build for {target} failed; cargo says why above"))
        }
    }
}

/// What the compiler that serves a target says of itself, such as `rustc 1.90.0`.
///
/// # Errors
/// No compiler for the target.
pub(crate) fn compiler(target: &str) -> Result<String, String> {
    let program = match Toolchain::find(target)? {
        Toolchain::Rustup => "rustc",
        Toolchain::Debian { .. } => DEBIAN_RUSTC,
    };
    let version = text_of(program, &["--version"]).unwrap_or_default();
    Ok(version.split_whitespace().take(2).collect::<Vec<_>>().join(" "))
}

/// Which compiler serves a target.
#[derive(Debug)]
enum Toolchain {
    /// The compiler on the path has the target's core library.
    Rustup,
    /// Debian's compiler builds the core library.
    Debian {
        /// The linker's name.
        linker: &'static str,
    },
}

impl Toolchain {
    /// The first that is there.
    fn find(target: &str) -> Result<Self, String> {
        let sysroot = text_of("rustc", &["--print", "sysroot"]).unwrap_or_default();
        let has = |root: &str, path: &str| Path::new(root.trim()).join(path).exists();
        if !sysroot.is_empty() && has(&sysroot, &format!("lib/rustlib/{target}")) {
            return Ok(Self::Rustup);
        }
        let debian = text_of(DEBIAN_RUSTC, &["--print", "sysroot"]).unwrap_or_default();
        let source = "lib/rustlib/src/rust/library/core";
        let linkers = if target.starts_with("wasm32") { WASM_LINKERS } else { LINKERS };
        let linker = linkers.into_iter().find(|name| text_of(name, &["--version"]).is_some());
        match linker {
            Some(linker) if Path::new(DEBIAN_CARGO).exists() && has(&debian, source) => {
                Ok(Self::Debian { linker })
            }
            _ => Err(format!(
                "no compiler here can build for {target}. With rustup, run `rustup target add \
                 {target}`; on Debian, `apt-get install cargo-web rustc-web rust-web-src lld-22`"
            )),
        }
    }
}

/// What a program prints; `None` when it cannot be started or fails.
fn text_of(program: &str, arguments: &[&str]) -> Option<String> {
    let mut command = Command::new(program);
    if program == DEBIAN_RUSTC {
        // The path that cargo sets up for rustup's compiler misleads Debian's.
        command.env_remove("LD_LIBRARY_PATH");
    }
    let output = command.args(arguments).stdin(Stdio::null()).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then_some(text)
}
