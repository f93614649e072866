//! `microraster budget` as a user meets it: a report, messages, exit codes.
//!
//! What is measured needs QEMU and a compiler for the target. Where they are missing the test says
//! so and passes; with `MICRORASTER_REQUIRE_SHARED` set it fails.
#![cfg(feature = "tools")]

use std::path::PathBuf;
use std::process::{Command, Output};

/// A cube in the temporary folder, removed in the end.
struct Cube(PathBuf);

impl Cube {
    fn new(name: &str) -> Self {
        let file = format!("microraster-budget-{name}-{}.obj", std::process::id());
        let path = std::env::temp_dir().join(file);
        let mut text = String::new();
        for corner in 0..8 {
            text += &format!("v {} {} {}\n", corner & 1, corner >> 1 & 1, corner >> 2);
        }
        for face in ["1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6"] {
            text += &format!("f {face}\n");
        }
        std::fs::write(&path, text).unwrap();
        Self(path)
    }
}

impl Drop for Cube {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

fn budget(model: &str, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_microraster"))
        .args(["budget", model])
        .args(arguments.split_whitespace())
        .output()
        .unwrap()
}

#[test]
fn what_makes_no_sense_is_an_error_that_says_what_to_do() {
    let cube = Cube::new("errors");
    let cube = cube.0.to_str().unwrap();
    let good = "--display 240x240 --ram 64K --target m0+@133MHz";
    for (model, arguments, message) in [
        ("no-such-file.obj", good, "name a readable OBJ or ASC file"),
        ("Cargo.toml", good, "Cargo.toml"),
        (cube, "--display 240 --ram 64K --target m0+@133MHz", "write it like 320x240"),
        (cube, "--display -1x240 --ram 64K --target m0+@133MHz", "write it like 320x240"),
        (cube, "--display 240x240 --ram lots --target m0+@133MHz", "write it like 64K"),
        (cube, "--display 240x240 --ram -1 --target m0+@133MHz", "write it like 64K"),
        (cube, "--display 240x240 --ram 8G --target m0+@133MHz", "1 to 4095M"),
        (cube, "--display 240x240 --ram 64K --flash -2K --target m0+@133MHz", "write it like 64K"),
        (cube, "--display 240x240 --ram 64K --target z80@4MHz", "choose from m0+, m3"),
        (cube, "--display 240x240 --ram 64K --target m0+", "write it like m0+@133MHz"),
        (cube, "--display 240x240 --ram 64K", "--target"),
    ] {
        let output = budget(model, arguments);
        let errors = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{model} {arguments}: {errors}");
        assert!(errors.contains(message), "{model} {arguments}: no `{message}` in {errors}");
        assert!(output.stdout.is_empty(), "{model} {arguments}: no report");
    }
}

#[test]
fn a_cube_fits_and_a_tenth_of_its_code_does_not() {
    let cube = Cube::new("report");
    let cube = cube.0.to_str().unwrap();
    let target = "--display 64x48 --ram 32K --target m0+@48MHz";
    let output = budget(cube, target);
    let errors = String::from_utf8(output.stderr).unwrap();
    if output.status.code() == Some(1) {
        let missing = errors.contains("apt-get install") || errors.contains("rustup target add");
        assert!(missing, "it failed although all of it is there: {errors}");
        eprintln!("skipped: {errors}");
        let required = std::env::var_os("MICRORASTER_REQUIRE_SHARED").is_some();
        assert!(!required, "MICRORASTER_REQUIRE_SHARED forbids to skip: {errors}");
        return;
    }
    let report = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(0), "{report}{errors}");
    for part in [
        ": 12 triangles, ",
        "\nfits m0+ at 48 MHz, 64x48 pixels\n",
        "Gouraud, 16-bit depth, the whole picture at once",
        "      6 144  colour, 48 rows\n",
        " frames a second\n",
        " cycles an instruction, assumed: ",
        "  bands of 24 rows: 6 144 bytes of RAM less, ",
        "  flat shading: ",
    ] {
        assert!(report.contains(part), "no `{part}` in\n{report}");
    }
    // More than the cube covers, and no more than some hundred instructions a pixel.
    let instructions: u64 = report
        .lines()
        .find_map(|line| line.trim().split_once(" instructions a frame"))
        .and_then(|(number, _)| number.replace(' ', "").parse().ok())
        .unwrap_or_else(|| panic!("no instructions in\n{report}"));
    assert!((10_000..1_000_000).contains(&instructions), "{report}");

    let small = budget(cube, &format!("{target} --flash 2K"));
    let report = String::from_utf8(small.stdout).unwrap();
    assert_eq!(small.status.code(), Some(2), "{report}");
    assert!(report.contains("\ndoes not fit m0+") && report.contains(" more than there are"));
    assert!(report.contains("To make it fit, give up first"), "{report}");
}
