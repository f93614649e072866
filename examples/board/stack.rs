//! How deep the stack has been: paint what is free, run, look how much paint is left.

use core::ptr::addr_of_mut;

/// A word that nobody else is likely to write.
const PAINT: u32 = 0x5AFE_57AC;

/// How far below the stack's top to look: painting megabytes costs more than the scene.
const REACH: usize = 16 * 1024;

#[allow(unsafe_code, reason = "addresses that the linker script gives, not data")]
extern "C" {
    /// End of what the linker placed in RAM; the stack grows down towards it.
    #[cfg_attr(target_arch = "arm", link_name = "__euninit")]
    #[cfg_attr(target_arch = "riscv32", link_name = "__ebss")]
    #[cfg_attr(target_arch = "wasm32", link_name = "__stack_low")]
    static mut BOTTOM: u32;
    /// The top of the stack.
    #[cfg_attr(target_arch = "wasm32", link_name = "__stack_high")]
    static mut _stack_start: u32;
}

/// Where the painting starts: above the statics and at most `REACH` below the top.
#[allow(unsafe_code, reason = "only addresses are taken, nothing is read")]
fn floor() -> *mut u32 {
    let reach = addr_of_mut!(_stack_start).wrapping_byte_sub(REACH);
    addr_of_mut!(BOTTOM).max(reach)
}

/// Where the paint ends: what is used of the stack before the work that is watched.
#[derive(Clone, Copy)]
pub(crate) struct Mark(usize);

/// Paints from the floor to a little under the caller's frame.
#[inline(never)]
#[allow(unsafe_code, reason = "memory under the stack pointer has no other access")]
pub(crate) fn paint() -> Mark {
    let marker = 0u32;
    let mark = core::ptr::from_ref(&marker) as usize;
    let top = mark.saturating_sub(64) & !3;
    let mut word = floor();
    while (word as usize) < top {
        // SAFETY: RAM between the statics and the stack pointer, used by nobody.
        unsafe {
            word.write_volatile(PAINT);
            word = word.add(1);
        }
    }
    Mark(mark)
}

/// Deepest use in bytes of all the stack since it was painted; about 16 KB means that or more.
#[inline(never)]
#[allow(dead_code, reason = "for who counts all of the RAM")]
pub(crate) fn deepest_of_all() -> usize {
    deepest(Mark(addr_of_mut!(_stack_start) as usize))
}

/// Deepest use in bytes below `mark`, since `paint` gave it; about 16 KB means that or more.
#[inline(never)]
#[allow(unsafe_code, reason = "memory under the stack pointer has no other access")]
pub(crate) fn deepest(mark: Mark) -> usize {
    let mut word = floor().cast_const();
    // SAFETY: reads RAM between the statics and the stack's top.
    while (word as usize) < mark.0 && unsafe { word.read_volatile() } == PAINT {
        word = word.wrapping_add(1);
    }
    mark.0.saturating_sub(word as usize)
}
