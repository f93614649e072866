//! Draws the cases of `cargo tradeoff` on a bare-metal target, as `firmware` draws its scenes.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[allow(dead_code, reason = "the host asks the scenes more than the board does")]
mod scenes;
#[cfg(target_os = "none")]
#[allow(dead_code, reason = "the host asks the cases more than the board does")]
#[path = "tradeoff/mod.rs"]
mod tradeoff;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This runs on boards: `cargo tradeoff` has it built and run under QEMU.");
}

#[cfg(target_os = "none")]
mod firmware {
    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        crate::board::run::run(crate::tradeoff::cases())
    }
}
