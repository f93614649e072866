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

    // 80 % of the height are 192 rows.
    let [left, top, right, bottom] = margins(&picture);
    assert!(top.abs_diff(24) <= 1 && bottom.abs_diff(24) <= 1, "{top} and {bottom} rows free");
    assert!(left.abs_diff(right) <= 1 && left >= 8, "{left} and {right} columns free");
}

/// How much of a picture is free around what is drawn: left, top, right, bottom.
fn margins(picture: &image::RgbaImage) -> [u32; 4] {
    let (width, height) = picture.dimensions();
    let drawn = |x: u32, y: u32| picture.get_pixel(x, y) != picture.get_pixel(0, 0);
    let column = |x: &u32| (0..height).any(|y| drawn(*x, y));
    let row = |y: &u32| (0..width).any(|x| drawn(x, *y));
    let left = (0..width).find(column).expect("something is drawn");
    let top = (0..height).find(row).expect("something is drawn");
    let right = (0..width).rev().find(column).map_or(0, |x| width - 1 - x);
    let bottom = (0..height).rev().find(row).map_or(0, |y| height - 1 - y);
    [left, top, right, bottom]
}

/// Two bricks, of which the smaller stands on an end of the other: the middle of their common box
/// is seen anywhere but in the middle of what is seen.
fn lopsided() -> String {
    let mut text = String::new();
    for [low, high] in [[[0, 0, 0], [9, 2, 3]], [[7, 2, -5], [9, 8, 0]]] {
        for corner in 0..8 {
            let [x, y, z] = [0, 1, 2].map(|axis| [low, high][corner >> axis & 1][axis]);
            text += &format!("v {x} {y} {z}\n");
        }
        for [a, b, c, d] in
            [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
        {
            text += &format!("f {} {} {} {}\n", a - 8, b - 8, c - 8, d - 8);
        }
    }
    text
}

#[test]
fn what_is_seen_lies_in_the_middle_and_fills_the_picture() {
    let folder = Folder::new("middle");
    fs::write(folder.0.join("a.obj"), lopsided()).unwrap();
    for model in [&["a.obj"][..], &[]] {
        for size in ["320x240", "200x300", "90x400"] {
            for (yaw, pitch) in [("0", "0"), ("30", "20"), ("200", "-50"), ("77", "90")] {
                let view = ["--size", size, "--yaw", yaw, "--pitch", pitch];
                folder.facts(&[model, &view].concat());
                let picture = pixels(&folder.0.join("out.tga"));
                let (width, height) = picture.dimensions();
                let [left, top, right, bottom] = margins(&picture);
                let what = format!("{model:?} {view:?}: {left} {top} {right} {bottom}");
                assert!(left.abs_diff(right) <= 2 && top.abs_diff(bottom) <= 2, "{what}");
                // 10 % of the height or 2.5 % of the width are free on each side, never less.
                let (across, up) = (width / 40, height / 10);
                assert!(left + 1 >= across && top + 1 >= up, "{what}");
                assert!(left <= across + 2 || top <= up + 2, "{what}");
            }
        }
    }
}

#[test]
fn a_turn_is_seen_from_one_place_that_has_room_for_all_of_it() {
    let folder = Folder::new("turn");
    fs::write(folder.0.join("a.obj"), lopsided()).unwrap();
    folder.facts(&["a.obj", "--frames", "12", "-o", "turn.tga"]);
    let all = (0..12).map(|i| margins(&pixels(&folder.0.join(format!("turn-{i:03}.tga")))));
    let [left, top, right, bottom] =
        all.reduce(|a, b| [0, 1, 2, 3].map(|side| a[side].min(b[side]))).unwrap();
    let what = format!("{left} {top} {right} {bottom}");
    assert!(left.abs_diff(right) <= 2 && top.abs_diff(bottom) <= 2, "{what}");
    assert!(left <= 10 || top <= 26, "{what}");
    assert!(left >= 7 && top >= 23, "{what}");
}

#[test]
fn the_hash_is_that_of_the_colour_bytes() {
    let folder = Folder::new("hash");
    let facts = folder.facts(&["--format", "rgba8888", "--size", "64x48", "-o", "a.tga"]);
    let bytes: Vec<u8> =
        pixels(&folder.0.join("a.tga")).pixels().flat_map(|pixel| pixel.0).collect();
    assert_eq!(format!("{:016x}", fnv1a64(&bytes)), fact(&facts, "hash"), "{facts}");

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
    for arguments in [
        &["--size", "0x5"][..],
        &["--size", "9"],
        &["--size", "8193x5"],
        &["--frames", "0"],
        &["--no-such-option"],
    ] {
        let output = folder.simulate(arguments);
        assert_eq!(output.status.code(), Some(1), "{arguments:?}");
        assert!(!output.stderr.is_empty() && output.stdout.is_empty(), "{arguments:?}");
        assert_eq!(folder.names(), before, "{arguments:?}: no file");
    }
    let help = folder.simulate(&["--help"]);
    assert!(help.status.success() && help.stderr.is_empty(), "help is no error");
}

#[test]
fn the_model_is_never_written_over() {
    let folder = Folder::new("over");
    fs::write(folder.0.join("a.tga"), lopsided()).unwrap();
    let before = folder.names();
    for output in ["a.tga", "./a.tga"] {
        let output = folder.simulate(&["a.tga", "-o", output]);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{errors}");
        assert!(errors.contains("a.tga: this is the model"), "{errors}");
        assert_eq!(folder.names(), before, "no file");
    }
    assert_eq!(fs::read_to_string(folder.0.join("a.tga")).unwrap(), lopsided(), "as it was");
}

#[cfg(unix)]
#[test]
fn a_link_as_output_stays_one_whether_it_leads_somewhere_or_not() {
    let folder = Folder::new("links");
    fs::create_dir(folder.0.join("below")).unwrap();
    std::os::unix::fs::symlink("below/b.tga", folder.0.join("a.tga")).unwrap();
    for _ in 0..2 {
        folder.facts(&["--size", "16x12", "-o", "a.tga"]);
        assert!(folder.0.join("a.tga").is_symlink(), "still a link");
        assert!(fs::symlink_metadata(folder.0.join("below/b.tga")).unwrap().is_file(), "a file");
    }
    std::os::unix::fs::symlink("c.tga", folder.0.join("c.tga")).unwrap();
    let output = folder.simulate(&["-o", "c.tga"]);
    assert_eq!(output.status.code(), Some(1), "a link to itself");
}
