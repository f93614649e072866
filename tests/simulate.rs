//! The host program as a user meets it: pictures, facts, messages, exit codes.
#![cfg(feature = "tools")]

use microraster::host::fnv1a64;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// An empty folder, removed in the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("microraster-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    fn simulate(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_microraster"))
            .current_dir(&self.0)
            .arg("simulate")
            .args(arguments)
            .output()
            .unwrap()
    }

    #[track_caller]
    fn facts(&self, arguments: &[&str]) -> String {
        let output = self.simulate(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments:?}: {errors}");
        String::from_utf8(output.stdout).unwrap()
    }

    fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn fact<'a>(facts: &'a str, name: &str) -> &'a str {
    let mut words = facts.split_whitespace();
    words
        .find_map(|word| word.strip_prefix(name)?.strip_prefix('='))
        .unwrap_or_else(|| panic!("no {name} in {facts}"))
}

fn pixels(path: &Path) -> image::RgbaImage {
    image::open(path).unwrap().to_rgba8()
}

#[test]
fn without_arguments_it_draws_the_teapot() {
    let folder = Folder::new("teapot");
    let facts = folder.facts(&[]);
    assert_eq!(facts.lines().count(), 1, "one line of facts: {facts}");
    let names: Vec<_> = facts.split_whitespace().filter_map(|w| w.split('=').next()).collect();
    assert_eq!(
        names,
        ["model", "triangles", "drawn", "clipped", "pixels", "hash", "ms"],
        "{facts}"
    );
    assert_eq!(fact(&facts, "model"), "teapot", "{facts}");
    assert_eq!(fact(&facts, "triangles"), "6320", "{facts}");
    assert_eq!(fact(&facts, "hash").len(), 16, "{facts}");
    assert_eq!(folder.names(), ["out.tga"], "one picture");
    let picture = pixels(&folder.0.join("out.tga"));
    assert_eq!(picture.dimensions(), (320, 240), "the default size");

    // It fills at most 80 % of the height, and touches that or nearly the whole width.
    let lit = |x: u32, y: u32| picture.get_pixel(x, y).0 != picture.get_pixel(0, 0).0;
    let rows = (0..240).filter(|&y| (0..320).any(|x| lit(x, y))).count();
    let columns = (0..320).filter(|&x| (0..240).any(|y| lit(x, y))).count();
    assert!(rows <= 194 && columns <= 306, "{columns} x {rows}");
    assert!(rows >= 150 || columns >= 240, "{columns} x {rows}");
}

#[test]
fn the_hash_is_that_of_the_colour_bytes() {
    let folder = Folder::new("hash");
    let facts = folder.facts(&["--format", "rgba8888", "--size", "64x48", "-o", "a.tga"]);
    let bytes: Vec<u8> =
        pixels(&folder.0.join("a.tga")).pixels().flat_map(|pixel| pixel.0).collect();
    // What was not drawn has alpha 0 or 255 in memory; the file is opaque.
    let transparent: Vec<u8> = bytes
        .chunks_exact(4)
        .flat_map(|p| match p {
            [0, 0, 0, _] => [0; 4],
            p => [p[0], p[1], p[2], p[3]],
        })
        .collect();
    let hashes = [&bytes, &transparent].map(|bytes| format!("{:016x}", fnv1a64(bytes)));
    assert!(hashes.iter().any(|hash| hash == fact(&facts, "hash")), "{facts} {hashes:?}");

    // Swapped bytes are another memory and the same picture.
    let plain = folder.facts(&["--size", "64x48", "-o", "b.tga"]);
    let swapped = folder.facts(&["--size", "64x48", "-o", "c.tga", "--format", "rgb565be"]);
    assert_ne!(fact(&plain, "hash"), fact(&swapped, "hash"), "other bytes");
    assert_eq!(
        pixels(&folder.0.join("b.tga")),
        pixels(&folder.0.join("c.tga")),
        "the same picture"
    );
}

#[test]
fn frames_are_numbered_and_turn_once() {
    let folder = Folder::new("frames");
    let facts = folder.facts(&["--frames", "4", "--size", "40x30", "-o", "turn.tga"]);
    assert_eq!(facts.lines().count(), 1, "{facts}");
    let names: Vec<_> = (0..4).map(|i| format!("turn-00{i}.tga")).collect();
    assert_eq!(folder.names(), names, "four pictures");
    folder.facts(&["--yaw", "120", "--frames", "4", "--size", "40x30", "-o", "late.tga"]);
    assert_eq!(
        pixels(&folder.0.join("turn-001.tga")),
        pixels(&folder.0.join("late-000.tga")),
        "a quarter of a turn"
    );
}

#[test]
fn all_traversals_and_own_models_draw() {
    let folder = Folder::new("models");
    fs::write(folder.0.join("my model.obj"), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\nf 1 2\n")
        .unwrap();
    fs::write(
        folder.0.join("a.asc"),
        "triangle\n-1 -1 0 0 0 1 0 0\n1 -1 0 0 0 1 0 0\n0 1 0 0 0 1 0 0\n",
    )
    .unwrap();
    let view = ["--size", "40x30", "--yaw", "0", "--pitch", "0"];
    let mut hashes = Vec::new();
    for model in ["my model.obj", "a.asc"] {
        for traversal in ["spans", "box", "blocks", "walk"] {
            let own = [model, "--traversal", traversal, "--cull", "back"];
            let facts = folder.facts(&[&own[..], &view].concat());
            assert_eq!(fact(&facts, "model"), model.replace(' ', "_"), "{facts}");
            assert_eq!(fact(&facts, "drawn"), "1", "{facts}");
            hashes.push(fact(&facts, "hash").to_owned());
        }
    }
    hashes.dedup();
    assert_eq!(hashes.len(), 1, "one picture: {hashes:?}");
    let facts = folder.facts(&[&["a.asc", "--cull", "front"][..], &view].concat());
    assert_eq!(fact(&facts, "pixels"), "0", "{facts}");
}

#[test]
fn errors_say_why_and_leave_no_file() {
    let folder = Folder::new("errors");
    fs::write(folder.0.join("bad.obj"), "v 0 0 0\nf 1 2 3\n").unwrap();
    fs::create_dir(folder.0.join("taken-002.tga")).unwrap();
    let before = folder.names();
    for (arguments, message) in [
        (&["bad.obj"][..], "microraster: bad.obj:2: position 2 does not exist"),
        (&["none.obj"], "microraster: none.obj: it cannot be read"),
        (&["-o", "a.png"], "microraster: a.png: pictures are TGA"),
        (&["-o", "none/a.tga"], "microraster: none/a.tga: "),
        (&["-o", "taken.tga", "--frames", "3"], "microraster: taken-002.tga: it exists"),
        (&["--yaw", "nan"], "microraster: --yaw NaN"),
    ] {
        let output = folder.simulate(arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments:?}: {errors}");
        assert!(errors.starts_with(message), "{arguments:?}: {errors}");
        assert!(output.stdout.is_empty(), "{arguments:?}: no facts");
        assert_eq!(folder.names(), before, "{arguments:?}: no file");
    }
    for arguments in [["--size", "0x5"], ["--size", "9"], ["--size", "5000x5"], ["--frames", "0"]] {
        let output = folder.simulate(&arguments);
        assert!(!output.status.success(), "{arguments:?}");
        assert_eq!(folder.names(), before, "{arguments:?}: no file");
    }
}
