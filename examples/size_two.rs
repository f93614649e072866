//! As `size_gouraud`, with a second shader and state: the firmware that
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
    use microraster::math::{Angle, Mat4, Vec3};
    use microraster::{Camera, Flat, Frame, Gouraud, Less, Mesh, Pass, Rgb, Rgb565, Size};

    static COLOR: Buffer<[u16; 128 * 64]> = Buffer::new([0; 128 * 64]);
    static DEPTH: Buffer<[u16; 128 * 64]> = Buffer::new([0; 128 * 64]);
    static CORNERS: [[i16; 3]; 3] = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]];
    static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];

    /// What is weighed. Inputs and outputs go through `black_box`, so that nothing is computed
    /// at compile time or left out.
    fn draw(color: &mut [u16], depth: &mut [u16]) {
        let camera = Camera::perspective(Angle::from_degrees(black_box(45.0)), 0.5);
        let model = Mat4::translation(black_box(Vec3::new(0.0, 0.0, -3.0)));
        if let Ok(frame) = Frame::<Rgb565>::new(color, Size::new(128, 64)) {
            if let Ok(mut frame) = frame.with_depth(depth) {
                frame.clear(Rgb::BLACK);
                let mesh = Mesh::new(&CORNERS, &COLORS);
                Pass::new(&camera).depth(Less).draw(&mut frame, &model, &mesh, &Gouraud::colored());
                Pass::new(&camera).draw(&mut frame, &model, &mesh, &Flat::colored());
            }
        }
        black_box(color);
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        if let (Some(color), Some(depth)) = (COLOR.take(), DEPTH.take()) {
            draw(color, depth);
        }
        loop {
            core::hint::spin_loop();
        }
    }
}
