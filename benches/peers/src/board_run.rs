//! The same on a board: builds the firmware of `board/` and reads what it prints.

use crate::board;
use crate::build::{House, Profile};
use crate::emulate;

/// What a renderer took for a scene.
#[derive(Debug)]
pub(crate) struct Count {
    pub(crate) scene: String,
    pub(crate) renderer: String,
    /// Instructions a frame.
    pub(crate) instructions: f64,
    pub(crate) triangles: f64,
    /// Pixels of a thousand that differ from ours.
    pub(crate) different: f64,
}

/// Builds and runs; a line for every scene and renderer.
pub(crate) fn counts() -> Result<Vec<Count>, String> {
    let here = std::path::absolute(env!("CARGO_MANIFEST_DIR")).map_err(|why| why.to_string())?;
    let root = here.join("../..");
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), Into::into);
    // Others allocate.
    let libraries = "core,alloc";
    let house = House {
        package: here.join("board"),
        target: target.join("peers"),
        libraries,
        profile: Profile::Release,
    };
    let board = board::find("m4")?;
    // The large memory of the board, and where its map lies.
    let map = format!("link-arg=-L{}", root.display());
    let memory =
        ["link-arg=--defsym=__ram_origin=0x21000000", "link-arg=--defsym=__ram_length=16M"];
    let options = ["-C", &map, "-C", memory[0], "-C", memory[1]];
    let elf = house.program("peers-board", board, &options)?;
    let printed = emulate::run(board, &elf, &house.package, &[], None)?;
    printed.lines().map(|line| parse(line).ok_or_else(|| format!("what is this: {line}"))).collect()
}

/// A line of the firmware's.
fn parse(line: &str) -> Option<Count> {
    let word = |name: &str| {
        let mut words = line.split(' ').filter_map(|word| word.split_once('='));
        words.find(|(key, _)| *key == name).map(|(_, value)| value)
    };
    let number = |name: &str| word(name)?.parse::<f64>().ok();
    Some(Count {
        scene: word("scene")?.into(),
        renderer: word("renderer")?.into(),
        instructions: number("instructions")? / number("frames")?,
        triangles: number("triangles")?,
        different: number("different")?,
    })
}

#[cfg(test)]
mod tests {
    use super::parse;

    #[test]
    fn lines_are_taken_apart_and_others_refused() {
        let line = "scene=S1 renderer=euc instructions=320 frames=16 triangles=7 different=4.5";
        let count = parse(line).expect("a line as the firmware prints it");
        assert_eq!((count.scene.as_str(), count.renderer.as_str()), ("S1", "euc"));
        assert!((count.instructions - 20.0).abs() < 1e-9 && (count.different - 4.5).abs() < 1e-9);
        assert!((count.triangles - 7.0).abs() < 1e-9);
        assert!(parse("panicked at the library").is_none());
        assert!(parse("scene=S1 renderer=euc instructions=many frames=16").is_none());
    }
}
