//! Draws scenes, measures and hashes every frame and prints one line for each.
//!
//! The words of the command line are names of scenes, or `all`, and `frames=N`, which draws only
//! the first N of each.

use crate::board::buffer::Buffer;
use crate::board::{meter, say, semihost, stack};
use crate::scenes::{hash, ListRoom, Model, Probe, Scene, Stage, CACHED, ROOM};
use microraster::{Color, VertexCache};

static COLOR: Buffer<[u32; ROOM]> = Buffer::new([0; ROOM]);
static DEPTH: Buffer<[u16; ROOM]> = Buffer::new([0; ROOM]);
static CACHE: Buffer<VertexCache<Color, CACHED>> =
    Buffer::new(VertexCache::with_blank(Color::new(0, 0, 0)));
static LIST: Buffer<ListRoom> = Buffer::new(ListRoom::NEW);
/// Room for the mesh file, in words so that it is aligned.
static MESH: Buffer<[u32; 32 * 1024]> = Buffer::new([0; 32 * 1024]);
/// Room for the command line.
static WORDS: Buffer<[u8; 4096]> = Buffer::new([0; 4096]);

/// Counts the instructions and the stack of what it measures.
pub(crate) struct Meter {
    /// What measuring nothing counts.
    empty: u64,
    /// Instructions of the frame so far.
    instructions: u64,
    /// Deepest stack of all frames, in bytes below the measuring function.
    stack: usize,
}

impl Probe for Meter {
    const COUNTING: bool = false;

    fn measure<T>(&mut self, work: impl FnOnce() -> T) -> T {
        let mark = stack::paint();
        let (instructions, value) = meter::instructions(work);
        self.stack = self.stack.max(stack::deepest(mark));
        self.instructions += instructions.saturating_sub(self.empty);
        value
    }

    fn pixels(&mut self, _written: u64) {}
}

/// The bunny, when the working directory has it.
fn bunny() -> Option<Model<'static>> {
    let mut file = semihost::File::open(c"bunny.mesh", semihost::Mode::Read)?;
    Model::view(file.read(bytemuck::cast_slice_mut(MESH.take()?))?)
}

/// Draws those of `scenes` that the command line names, or all where it says `all`, and ends.
pub(crate) fn run(scenes: impl Iterator<Item = Scene<Meter>>) -> ! {
    let done = draw_all(scenes);
    if done.is_none() {
        say!("error: the command line is longer than the buffer for it");
    }
    semihost::exit(u32::from(done.is_none()))
}

/// Draws what was asked for; `None` when the board lacks something.
fn draw_all(scenes: impl Iterator<Item = Scene<Meter>>) -> Option<()> {
    let words = semihost::command_line(WORDS.take()?)?;
    let limit = words
        .split(' ')
        .find_map(|word| word.strip_prefix("frames=")?.parse().ok())
        .unwrap_or(u32::MAX);
    let mut stage = Stage {
        color: COLOR.take()?,
        depth: DEPTH.take()?,
        cache: CACHE.take()?,
        bunny: bunny(),
        list: LIST.take()?,
    };
    let empty = meter::instructions(|| ()).0;
    let mut probe = Meter { empty, instructions: 0, stack: 0 };
    for scene in scenes {
        if !words.split(' ').any(|word| word == scene.name || word == "all") {
            continue;
        }
        for frame in 0..scene.frames.min(limit) {
            // A frame must not depend on what was drawn before it.
            stage.color.fill(0);
            stage.depth.fill(0);
            probe.instructions = 0;
            let facts = (scene.draw)(&mut stage, frame, &mut probe);
            say!(
                "scene={} frame={frame} instructions={} hash={:016x} bytes={}",
                scene.name,
                probe.instructions,
                hash::picture(stage.color, facts.bytes),
                facts.bytes
            );
        }
    }
    say!("stack={}", probe.stack);
    Some(())
}
