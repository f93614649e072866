//! Draws the scenes on a bare-metal target, measures and hashes every frame and prints one line
//! for each. `cargo firmware` builds it, runs it under QEMU and compares it with the host.
#![cfg_attr(any(target_os = "none", target_os = "unknown"), no_std, no_main)]

#[cfg(any(target_os = "none", target_os = "unknown"))]
mod board;
#[cfg(any(target_os = "none", target_os = "unknown"))]
#[path = "board/feature.rs"]
mod feature;
#[cfg(any(target_os = "none", target_os = "unknown"))]
#[path = "board/run.rs"]
mod run;
#[cfg(any(target_os = "none", target_os = "unknown"))]
#[allow(dead_code, reason = "the host asks the scenes more than the board does")]
mod scenes;

#[cfg(not(any(target_os = "none", target_os = "unknown")))]
fn main() {
    println!("This runs on boards: `cargo firmware` builds it and runs it under QEMU.");
}

#[cfg(any(target_os = "none", target_os = "unknown"))]
mod firmware {
    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    #[cfg_attr(
        target_arch = "wasm32",
        export_name = "run",
        allow(unsafe_code, reason = "the name by which it is called from outside")
    )]
    fn main() -> ! {
        // What is only compared is less to build.
        if const { crate::feature::is("pictures") } {
            crate::run::run(crate::scenes::pictures())
        } else {
            crate::run::run(crate::scenes::scenes())
        }
    }
}
