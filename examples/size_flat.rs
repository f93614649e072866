//! One mesh of flat triangles without depth: the firmware that
//! `cargo firmware --sizes` weighs.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "board/bare.rs"]
mod bare;
#[cfg(target_os = "none")]
#[path = "board/buffer.rs"]
mod buffer;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is weighed, not run: `cargo firmware --sizes`.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::buffer::Buffer;
    use core::hint::black_box;

    static COLOR: Buffer<[u16; 128 * 64]> = Buffer::new([0; 128 * 64]);

    /// What is weighed. Inputs and outputs go through `black_box`, so that nothing is computed
    /// at compile time or left out.
    fn draw(color: &mut [u16]) {
        color.fill(black_box(0xF800));
        black_box(color);
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        if let Some(color) = COLOR.take() {
            draw(color);
        }
        loop {
            core::hint::spin_loop();
        }
    }
}
