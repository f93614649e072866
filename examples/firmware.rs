//! Draws the scenes on a bare-metal target, measures and hashes every frame and prints one line
//! for each. `cargo firmware` builds it, runs it under QEMU and compares it with the host.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
mod board;
#[cfg(target_os = "none")]
#[allow(dead_code, reason = "the host asks the scenes more than the board does")]
mod scenes;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This runs on boards: `cargo firmware` builds it and runs it under QEMU.");
}

#[cfg(target_os = "none")]
mod firmware {
    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        crate::board::run::run(crate::scenes::scenes())
    }
}
