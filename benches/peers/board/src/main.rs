//! Draws the measured scenes with every renderer that runs without an operating system, and prints
//! the instructions that each takes. `cargo peers --board` builds it and runs it under QEMU.
#![no_std]
#![no_main]

extern crate alloc;

#[path = "../../../../examples/board/mod.rs"]
#[allow(dead_code, reason = "other firmware uses more of a board")]
mod board;
#[path = "../../src/renderers/mod.rs"]
#[allow(dead_code, reason = "the host's program uses more of a renderer")]
mod renderers;
#[path = "../../src/scene.rs"]
mod scene;

use core::mem::MaybeUninit;

// Its critical sections are what the allocator is locked by.
use cortex_m as _;

use embedded_alloc::LlffHeap;

use board::{meter, say, semihost};
use scene::Size;

/// Room for vertices, lists and depth in floats: what others allocate.
const ROOM: usize = 15 << 20;

#[global_allocator]
static HEAP: LlffHeap = LlffHeap::empty();

/// The picture that all figures are of.
const SIZE: Size = Size { width: 320, height: 240 };

/// Hands the allocator its memory.
#[allow(unsafe_code, reason = "an allocator is given memory that nobody else has")]
fn start_heap() {
    static mut MEMORY: MaybeUninit<[u8; ROOM]> = MaybeUninit::uninit();
    // SAFETY: called once, before anything is allocated, and the memory is the heap's alone.
    unsafe { HEAP.init(core::ptr::addr_of_mut!(MEMORY) as usize, ROOM) }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    start_heap();
    let (overhead, ()) = meter::instructions(|| ());
    for scene in scene::scenes(SIZE, None) {
        let mut ours = alloc::vec::Vec::new();
        for (name, make) in renderers::RENDERERS {
            let Some(mut renderer) = make(&scene, SIZE) else { continue };
            let mut total = 0;
            for frame in 0..scene.frames() {
                renderer.clear();
                total += meter::instructions(|| renderer.draw(frame)).0 - overhead;
            }
            let picture = renderer.picture();
            if ours.is_empty() {
                ours.clone_from(&picture);
            }
            let different = renderers::difference(&ours, &picture);
            let (frames, triangles) = (scene.frames(), scene.triangles.len());
            say!(
                "scene={} renderer={name} instructions={total} frames={frames} \
                 triangles={triangles} different={different:.1}",
                scene.name
            );
        }
    }
    semihost::exit(0)
}
