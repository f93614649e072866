//! The README keeps its word: its example is the one that is compiled, its picture the one that
//! the program draws.
#![cfg(feature = "tools")]

use std::path::Path;
use std::process::Command;

fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()))
}

#[test]
fn its_example_is_the_compiled_one() {
    let readme = text("README.md");
    let (_, rest) = readme.split_once("```rust\n").expect("an example");
    let (example, _) = rest.split_once("```").expect("its end");
    let source = text("examples/hello.rs");
    let (_, body) = source.split_once("#![no_std]\n\n").expect("the head of the file");
    assert_eq!(example, body, "examples/hello.rs and the README");
    let lines = example.lines().filter(|line| !line.is_empty()).count();
    assert!(lines <= 25, "{lines} lines are no short example");
}

#[test]
fn its_picture_is_what_simulate_draws() {
    let folder = std::env::temp_dir().join(format!("microraster-readme-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("out.tga");
    let program = env!("CARGO_BIN_EXE_microraster");
    let status = Command::new(program).args(["simulate", "-o"]).arg(&file).output();
    assert!(status.is_ok_and(|output| output.status.success()), "simulate draws");
    let drawn = image::open(&file).expect("a picture").into_rgb8();
    std::fs::remove_dir_all(&folder).expect("the folder goes");
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/pictures/teapot.png");
    if std::env::var_os("MICRORASTER_REWRITE_GOLDENS").is_some() {
        drawn.save(&kept).expect("written");
    }
    let kept = image::open(&kept).expect("the kept picture").into_rgb8();
    assert!(drawn == kept, "the picture in the README is another one");
}

#[test]
fn it_names_the_two_commands_and_what_is_missing() {
    let readme = text("README.md");
    for words in
        ["\ncargo simulate\n", "\ncargo test --all-features\n", "Not there yet", "Anti-goals"]
    {
        assert!(readme.contains(words), "the README lacks {words:?}");
    }
}
