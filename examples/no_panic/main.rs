//! Draws with everything that the crate has: the firmware in which `cargo firmware --no-panic`
//! looks for a way to panic, and must find none.
//!
//! Inputs are hidden from the compiler: no branch is left out because of what is drawn here. Built
//! as its variant `panic` it draws nothing and reads behind an array instead, which must be found.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "../board/buffer.rs"]
mod buffer;
#[cfg(target_os = "none")]
#[path = "../board/feature.rs"]
mod feature;
#[cfg(target_os = "none")]
mod fragments;
#[cfg(target_os = "none")]
mod inputs;
#[cfg(target_os = "none")]
mod meshes;
#[cfg(target_os = "none")]
mod primitives;
#[cfg(target_os = "none")]
mod textures;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is looked at, not run: `cargo firmware --no-panic`.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::{feature, fragments, inputs, meshes, primitives, textures};
    use core::hint::black_box;

    /// Linked if and only if something may panic, whatever the compiler makes of the functions
    /// on the way here.
    static PANIC_IS_REACHABLE: u8 = 0;

    #[panic_handler]
    fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
        loop {
            black_box(&PANIC_IS_REACHABLE);
        }
    }

    /// Draws all of it; `None` where a buffer is too small.
    fn draw() -> Option<()> {
        let mut buffers = inputs::Buffers::take()?;
        meshes::draw(&mut buffers)?;
        textures::draw(&mut buffers)?;
        fragments::draw(&mut buffers)?;
        primitives::draw(&mut buffers)
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        if const { feature::is("panic") } {
            #[allow(
                clippy::indexing_slicing,
                reason = "what the check must find: a panic for an index out of range"
            )]
            let word = [1_u8, 2, 3][black_box(3)];
            black_box(word);
        } else {
            black_box(draw());
        }
        loop {
            core::hint::spin_loop();
        }
    }
}
