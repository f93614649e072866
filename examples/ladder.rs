//! One triangle, drawn with one feature more on each rung: the firmware that
//! `cargo firmware --ladder` weighs and runs, once for each. The rung's name comes from the build's
//! environment; what belongs to the rungs above is not linked.
//!
//! It prints its figures without `core::fmt`, which would weigh more than the first rungs.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[path = "board/bare.rs"]
mod bare;
#[cfg(target_os = "none")]
#[path = "board/buffer.rs"]
mod buffer;
#[cfg(target_os = "none")]
#[path = "board/feature.rs"]
mod feature;
#[cfg(target_os = "none")]
#[path = "board/meter.rs"]
mod meter;
#[cfg(target_os = "none")]
#[path = "board/semihost.rs"]
#[allow(dead_code, reason = "other firmware asks more of the host")]
mod semihost;
#[cfg(target_os = "none")]
#[path = "board/stack.rs"]
mod stack;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is weighed and run under QEMU: `cargo firmware --ladder`.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::buffer::Buffer;
    use crate::{feature, meter, semihost, stack};
    use core::fmt::Write;
    use core::hint::black_box;
    use microraster::math::{Angle, Mat4, Vec3};
    use microraster::texture::{Bilinear, MipMap, MipSampler, Repeat, Sampler, Texture};
    use microraster::{
        Adaptive, Affine, BlinnPhong, Camera, Channels, Consecutive, ConstantAlpha, DepthBuffer,
        Dither4, Equal, Flat, Fog, Fogged, Frame, Gouraud, Lambert, Less, Light, Mesh, Normal,
        Pass, Points, Replace, Rgb, Rgb565, Size, Stencil, StencilBuffer, Stenciled, Textured,
        Thin,
    };

    const WIDTH: u16 = 128;
    const HEIGHT: u16 = 64;
    const PIXELS: usize = WIDTH as usize * HEIGHT as usize;

    static COLOR: Buffer<[u16; PIXELS]> = Buffer::new([0; PIXELS]);
    static DEPTH: Buffer<[u16; PIXELS]> = Buffer::new([0; PIXELS]);
    static STENCIL: Buffer<[u8; PIXELS]> = Buffer::new([0; PIXELS]);
    static CORNERS: [[i16; 3]; 3] = [[-2, -1, 0], [2, -1, 0], [0, 1, 0]];
    static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];
    static PLACES: [(Rgb, [i16; 2]); 3] =
        [(Rgb::RED, [0, 4096]), (Rgb::GREEN, [4096, 4096]), (Rgb::BLUE, [2048, 0])];
    static LIT: [(Normal, [i16; 2]); 3] =
        [([-40, 0, 120], [0, 4096]), ([40, 0, 120], [4096, 4096]), ([0, 40, 120], [2048, 0])];
    static TEXELS: [u16; 85] = [0xFDA0; 85];

    type Plain<'a> = Frame<'a, Rgb565>;
    type Deep<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;
    type Full<'a> = Frame<'a, Rgb565, StencilBuffer<'a, DepthBuffer<'a>>>;

    fn camera() -> Camera {
        Camera::perspective(Angle::from_degrees(black_box(45.0)), 0.5)
    }

    /// Turned about the upright axis, so that perspective is seen.
    fn model() -> Mat4 {
        Mat4::translation(black_box(Vec3::new(0.0, 0.0, -3.0)))
            * Mat4::rotation_y(Angle::from_degrees(black_box(40.0)))
    }

    fn texture() -> Option<Texture<'static>> {
        Texture::new(black_box(&TEXELS), 8, 8).ok()
    }

    fn suns() -> [Light; 2] {
        let sun = |direction| Light::directional(black_box(direction), Rgb::new(140, 140, 140));
        [sun(Vec3::new(0.0, -1.0, -1.0)), sun(Vec3::new(1.0, 0.0, -1.0))]
    }

    fn half() -> ConstantAlpha {
        ConstantAlpha(black_box(128))
    }

    fn fog() -> Fog {
        Fog::exponential(Rgb::WHITE, black_box(0.1))
    }

    /// Draws the first rung.
    fn plain(frame: &mut Plain<'_>) {
        frame.clear(Rgb::BLACK);
        let shader = Flat::solid(black_box(Rgb::RED));
        let mesh = Mesh::new(&CORNERS, &[(), (), ()]);
        Pass::new(&camera()).draw(frame, &model(), &mesh, &shader);
        black_box(frame);
    }

    /// Draws a rung with depth; `None` where a texture's size is wrong.
    fn deep(frame: &mut Deep<'_>) -> Option<()> {
        frame.clear(Rgb::BLACK);
        let camera = &camera();
        let pass = || Pass::new(camera).depth(Less);
        let model = &model();
        let colored = Gouraud::colored();
        let placed = Mesh::new(&CORNERS, &PLACES);
        if const { feature::is("depth") } {
            let shader = Flat::solid(black_box(Rgb::RED));
            pass().draw(frame, model, &Mesh::new(&CORNERS, &[(), (), ()]), &shader);
        }
        if const { feature::is("gouraud") } {
            pass().draw(frame, model, &Mesh::new(&CORNERS, &COLORS), &colored);
        }
        if const { feature::is("texture") } {
            let shader = Textured::on(colored, Sampler::nearest(texture()?).ok()?);
            pass().draw(frame, model, &placed, &shader.perspective(Affine));
        }
        if const { feature::is("perspective") } {
            let shader = Textured::on(colored, Sampler::nearest(texture()?).ok()?);
            pass().draw(frame, model, &placed, &shader.perspective(Adaptive));
        }
        if const { feature::is("bilinear") } {
            let shader = Textured::on(colored, Sampler::bilinear(texture()?).ok()?);
            pass().draw(frame, model, &placed, &shader);
        }
        if const { feature::is("blend") } {
            let shader = Textured::on(colored, Sampler::bilinear(texture()?).ok()?);
            pass().blend(half()).draw(frame, model, &placed, &shader);
        }
        if const { feature::is("fog") } {
            let shader = Textured::on(colored, Sampler::bilinear(texture()?).ok()?);
            pass().blend(half()).draw(frame, model, &placed, &Fogged::new(shader, fog()));
        }
        if const { feature::is("lights") } {
            let lit = Gouraud::new(Lambert::new(&suns()));
            let shader = Textured::on(lit, Sampler::bilinear(texture()?).ok()?);
            let mesh = Mesh::new(&CORNERS, &LIT);
            pass().blend(half()).draw(frame, model, &mesh, &Fogged::new(shader, fog()));
        }
        black_box(frame);
        Some(())
    }

    /// Draws the last rung: highlights, mip-maps, stencil, dither and mask besides, the triangle's
    /// edges as lines and its corners as points.
    fn full(frame: &mut Full<'_>) -> Option<()> {
        frame.clear(Rgb::BLACK);
        let camera = &camera();
        let model = &model();
        let lit =
            Gouraud::new(BlinnPhong::new(&suns()).specular(black_box(Rgb::WHITE), black_box(20)));
        let levels = MipMap::<Rgb565>::new(black_box(&TEXELS), 8, 8).ok()?;
        let sampler = MipSampler::new(levels, Bilinear, Repeat, Repeat);
        let stencil = Stencil::new(Equal, black_box(0)).on_pass(Replace);
        Pass::new(camera)
            .depth(Stenciled::new(Less, stencil))
            .blend(half())
            .dither(Dither4)
            .color_mask(Channels::<true, true, false>)
            .draw(
                frame,
                model,
                &Mesh::new(&CORNERS, &LIT),
                &Fogged::new(Textured::on(lit, sampler), fog()),
            );
        let mesh = Mesh::new(&CORNERS, &COLORS);
        let colored = Gouraud::colored();
        Pass::new(camera).draw_wireframe(frame, model, &mesh, &colored, Thin);
        let corners = mesh.with_topology(Points::new(Consecutive::new(3)));
        Pass::new(camera).draw_points(frame, model, &corners, &colored, &black_box(5_u16));
        black_box(frame);
        Some(())
    }

    /// The measured frame with bytes of colour, depth and stencil; `None` where a buffer is gone.
    fn measured() -> Option<(u64, usize, [usize; 3])> {
        let size = Size::new(WIDTH, HEIGHT);
        let [color, depth, stencil] = [2 * PIXELS, 2 * PIXELS, PIXELS];
        let empty = meter::instructions(|| ()).0;
        let measure = |draw: &mut dyn FnMut() -> Option<()>| {
            let mark = stack::paint();
            let (instructions, drawn) = meter::instructions(draw);
            drawn?;
            Some((instructions.saturating_sub(empty), stack::deepest(mark)))
        };
        if const { feature::is("nothing") } {
            let (instructions, stack) = measure(&mut || Some(()))?;
            return Some((instructions, stack, [0, 0, 0]));
        }
        let mut frame = Plain::new(COLOR.take()?, size).ok()?;
        if const { feature::is("flat") } {
            let (instructions, stack) = measure(&mut || {
                plain(&mut frame);
                Some(())
            })?;
            return Some((instructions, stack, [color, 0, 0]));
        }
        let mut frame = frame.with_depth(DEPTH.take()?).ok()?;
        if const { !feature::is("all") } {
            let (instructions, stack) = measure(&mut || deep(&mut frame))?;
            return Some((instructions, stack, [color, depth, 0]));
        }
        let mut frame = frame.with_stencil(STENCIL.take()?).ok()?;
        let (instructions, stack) = measure(&mut || full(&mut frame))?;
        Some((instructions, stack, [color, depth, stencil]))
    }

    /// Prints ` name=value`.
    fn print(console: &mut semihost::File, name: &str, value: u64) {
        let mut digits = [b'0'; 20];
        let (mut rest, mut used) = (value, 0_usize);
        for digit in digits.iter_mut().rev() {
            *digit = b'0' | u8::try_from(rest % 10).unwrap_or(0);
            rest /= 10;
            used = used.wrapping_add(1);
            if rest == 0 {
                break;
            }
        }
        let text = digits.get(20_usize.saturating_sub(used)..).unwrap_or(&[]);
        for part in [" ", name, "=", core::str::from_utf8(text).unwrap_or("")] {
            // A console that is gone cannot be told about.
            let _ = console.write_str(part);
        }
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        let figures = measured();
        if let (Some((instructions, stack, [color, depth, stencil])), Some(mut console)) =
            (figures, semihost::File::console())
        {
            print(&mut console, "instructions", instructions);
            print(&mut console, "stack", stack as u64);
            print(&mut console, "color", color as u64);
            print(&mut console, "depth", depth as u64);
            print(&mut console, "stencil", stencil as u64);
            let _ = console.write_str("\n");
        }
        semihost::exit(u32::from(figures.is_none()))
    }
}
