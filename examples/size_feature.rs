//! One triangle drawn with one feature: the firmware that `cargo firmware --sizes --features`
//! weighs, once for each. The feature's name comes from the build's environment; what belongs to
//! the others is not linked.
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

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This is weighed, not run: `cargo firmware --sizes --features`.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::buffer::Buffer;
    use crate::feature::is;
    use core::hint::black_box;
    use fixed::types::I8F8;
    use microraster::math::{Angle, Mat4, Vec3};
    use microraster::texture::{MipMap, MipSampler, Nearest, Repeat, Sampler, Texture};
    use microraster::{
        Affine, Alpha, AtFragments, BlinnPhong, Camera, Channels, Consecutive, ConstantDepth, Cull,
        DepthBuffer, DepthRange, Dither4, Dither8, Equal, Every, Exact, FacePlane, FacePlanes,
        Flat, Fog, Fogged, Frame, Gouraud, Lambert, Less, Light, LineList, Matcap, Mesh, Midpoint,
        Multiply, NoDepth, Normal, Off, Pass, Phong, PlaneScale, Points, PolygonOffset, ReadOnly,
        Rectangle, Replace, Rgb, Rgb565, Size, Smooth, Stats, Stencil, StencilBuffer, Stenciled,
        Stippled, Supersampling, Textured, Thin, TriangleStrip, Undithered, Wide,
    };

    const SIDE: usize = 64;

    static COLOR: Buffer<[u16; SIDE * SIDE]> = Buffer::new([0; SIDE * SIDE]);
    static DEPTH: Buffer<[u16; SIDE * SIDE]> = Buffer::new([0; SIDE * SIDE]);
    static VALUES: Buffer<[u8; SIDE * SIDE]> = Buffer::new([0; SIDE * SIDE]);
    static FINE: Buffer<[u16; SIDE * SIDE]> = Buffer::new([0; SIDE * SIDE]);
    static CORNERS: [[i16; 3]; 3] = [[-1, -1, 0], [1, -1, 0], [0, 1, 0]];
    static COLORS: [Rgb; 3] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE];
    static NORMALS: [Normal; 3] = [[0, 0, 127]; 3];
    static PLACES: [((), [i16; 2]); 3] = [((), [0, 0]), ((), [4096, 0]), ((), [0, 4096])];
    static INDICES: [u16; 3] = [0, 1, 2];
    const SCALE: PlaneScale = PlaneScale::of(&CORNERS, &INDICES);
    static PLANES: [FacePlane; 1] = SCALE.bake(&CORNERS, &INDICES);
    static TEXELS: [u16; 85] = [0xF800; 85];

    /// Draws with the feature of this name, if it is the one.
    macro_rules! features {
        ($($name:literal => $draw:expr;)*) => {
            $(if const { is($name) } {
                $draw;
            })*
        };
    }

    type Plain<'a> = Frame<'a, Rgb565>;
    type Deep<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;
    type Masked<'a> = Frame<'a, Rgb565, StencilBuffer<'a, NoDepth>>;

    fn camera() -> Camera {
        Camera::perspective(Angle::from_degrees(black_box(45.0)), 0.5)
    }

    fn model() -> Mat4 {
        Mat4::translation(black_box(Vec3::new(0.0, 0.0, -3.0)))
    }

    fn flat() -> Flat<microraster::Solid<()>> {
        Flat::solid(black_box(Rgb::RED))
    }

    /// A mesh of nothing but corners.
    static BARE: Mesh<'static, ()> = Mesh::new(&CORNERS, &[(), (), ()]);
    static COLORED: Mesh<'static, Rgb> = Mesh::new(&CORNERS, &COLORS);
    static LIT: Mesh<'static, Normal> = Mesh::new(&CORNERS, &NORMALS);
    static PLACED: Mesh<'static, ((), [i16; 2])> = Mesh::new(&CORNERS, &PLACES);

    /// The texture, known to fit when the program is built.
    static TEXTURE: Texture<'_> = match Texture::new(&TEXELS, 8, 8) {
        Ok(texture) => texture,
        Err(_) => panic!("the size fits the data"),
    };

    fn texture() -> Texture<'static> {
        *black_box(&TEXTURE)
    }

    fn sun() -> Light {
        Light::directional(black_box(Vec3::new(0.0, -1.0, -1.0)), Rgb::WHITE)
    }

    fn lamp() -> Light<microraster::PointLight> {
        Light::point(black_box(Vec3::new(0.0, 1.0, 1.0)), Rgb::WHITE)
    }

    fn fog() -> Fog {
        Fog::exponential(Rgb::WHITE, black_box(0.3))
    }

    fn plain(frame: &mut Plain<'_>) {
        let camera = &camera();
        let pass = || Pass::new(camera);
        let model = &model();
        macro_rules! textured {
            ($sampler:expr) => {
                if let Ok(sampler) = $sampler {
                    pass().draw(frame, model, &PLACED, &Textured::new(sampler));
                }
            };
        }
        features! {
            "flat" => pass().draw(frame, model, &BARE, &flat());
            "gouraud" => pass().draw(frame, model, &COLORED, &Gouraud::colored());
            "indexed" => pass().draw(frame, model, &BARE.indexed(&INDICES), &flat());
            "planes of triangles" => pass().cull(Cull::Back).draw(
                frame,
                model,
                &BARE.with_planes(FacePlanes::new(&PLANES, SCALE)),
                &flat()
            );
            "strip" => pass().draw(
                frame,
                model,
                &BARE.with_topology(TriangleStrip::new(Consecutive::new(3))),
                &flat()
            );
            "lines" => pass().draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Thin
            );
            "midpoint lines" => pass().draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Midpoint
            );
            "wide lines" => pass().draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Wide(black_box(3))
            );
            "stippled lines" => pass().draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Stippled::new(black_box(0x5555), 1, Thin)
            );
            "rectangular lines" => pass().draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Rectangle(black_box(3))
            );
            "smooth lines" => pass().blend(Alpha).draw_lines(
                frame,
                model,
                &BARE.with_topology(LineList::new(Consecutive::new(2))),
                &flat(),
                Smooth(black_box(3))
            );
            "wireframe" => pass().draw_wireframe(frame, model, &BARE, &flat(), Thin);
            "points" => pass().draw_points(
                frame,
                model,
                &BARE.with_topology(Points::new(Consecutive::new(3))),
                &flat(),
                &black_box(5_u16)
            );
            "alpha blending" => pass().blend(Alpha).draw(frame, model, &BARE, &flat());
            "multiply blending" => pass().blend(Multiply).draw(frame, model, &BARE, &flat());
            "dither 4x4" => pass().dither(Dither4).draw(frame, model, &BARE, &flat());
            "dither 8x8" => pass().dither(Dither8).draw(frame, model, &BARE, &flat());
            "colour mask" => {
                pass().color_mask(Channels::<true, false, true>).draw(frame, model, &BARE, &flat())
            };
            "nearest texture" => textured!(Sampler::nearest(texture()));
            "bilinear texture" => textured!(Sampler::bilinear(texture()));
            "affine texture" => if let Ok(sampler) = Sampler::nearest(texture()) {
                let shader = Textured::new(sampler).perspective(Affine);
                pass().draw(frame, model, &PLACED, &shader);
            };
            "texture every 16" => if let Ok(sampler) = Sampler::nearest(texture()) {
                let shader = Textured::new(sampler).perspective(Every::<16>);
                pass().draw(frame, model, &PLACED, &shader);
            };
            "exact texture" => if let Ok(sampler) = Sampler::nearest(texture()) {
                let shader = Textured::new(sampler).perspective(Exact);
                pass().draw(frame, model, &PLACED, &shader);
            };
            "mip-mapped texture" => if let Ok(levels) = MipMap::<Rgb565>::new(&TEXELS, 8, 8) {
                let sampler = MipSampler::new(levels, Nearest, Repeat, Repeat);
                pass().draw(frame, model, &PLACED, &Textured::new(sampler));
            };
            "lambert" => pass().draw(frame, model, &LIT, &Flat::lit(&[sun()]));
            "point light" => pass().draw(frame, model, &LIT, &Flat::lit(&[lamp()]));
            "blinn-phong" => {
                pass().draw(frame, model, &LIT, &Flat::new(BlinnPhong::new(&[sun()])))
            };
            "phong" => pass().draw(frame, model, &LIT, &Phong::new(Lambert::new(&[sun()])));
            "matcap" => if let Ok(sampler) = Sampler::nearest(texture()) {
                pass().draw(frame, model, &LIT, &Matcap::new(sampler));
            };
            "fog at vertices" => pass().draw(frame, model, &BARE, &Fogged::new(flat(), fog()));
            "fog at fragments" => {
                pass().draw(frame, model, &BARE, &Fogged::new(flat(), fog()).at(AtFragments))
            };
            "counting" => {
                let mut stats = Stats::default();
                pass().count(&mut stats).draw(frame, model, &BARE, &flat());
                black_box(stats);
            };
            "supersampling" => if let Some(fine) = FINE.take() {
                if let Ok(mut fine) = Plain::new(fine, Size::new(64, 64)) {
                    pass().draw(&mut fine, model, &BARE, &flat());
                    Supersampling::Two.resolve(&fine, frame, &Undithered);
                }
            };
        }
    }

    fn deep(frame: &mut Deep<'_>) {
        let camera = &camera();
        let pass = || Pass::new(camera);
        let model = &model();
        features! {
            "depth" => pass().depth(Less).draw(frame, model, &BARE, &flat());
            "constant depth" => {
                pass().depth(ConstantDepth::new(Less)).draw(frame, model, &BARE, &flat())
            };
            "read-only depth" => {
                pass().depth(ReadOnly::new(Less)).draw(frame, model, &BARE, &flat())
            };
            "polygon offset" => {
                let offset = PolygonOffset::new(Less, black_box(I8F8::ONE), black_box(1));
                pass().depth(offset).draw(frame, model, &BARE, &flat())
            };
            "depth range" => {
                let range = DepthRange::new(Less, black_box(100), black_box(9000));
                pass().depth(range).draw(frame, model, &BARE, &flat())
            };
        }
    }

    fn masked(frame: &mut Masked<'_>) {
        let stencil = Stencil::new(Equal, black_box(1)).on_pass(Replace);
        let depth = Stenciled::new(Off, stencil);
        Pass::new(&camera()).depth(depth).draw(frame, &model(), &BARE, &flat());
    }

    /// The features that need depth.
    const DEEP: bool = is("depth")
        || is("constant depth")
        || is("read-only depth")
        || is("polygon offset")
        || is("depth range");

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        if let Some(color) = COLOR.take() {
            if let Ok(mut frame) = Frame::<Rgb565>::new(color, Size::new(64, 64)) {
                if const { is("stencil") } {
                    let values = VALUES.take().map_or(&mut [] as &mut [u8], |values| values);
                    if let Ok(mut frame) = frame.with_stencil(values) {
                        frame.clear(Rgb::BLACK);
                        masked(&mut frame);
                    }
                } else if const { DEEP } {
                    let codes = DEPTH.take().map_or(&mut [] as &mut [u16], |codes| codes);
                    if let Ok(mut frame) = frame.with_depth(codes) {
                        frame.clear(Rgb::BLACK);
                        deep(&mut frame);
                    }
                } else {
                    frame.clear(Rgb::BLACK);
                    plain(&mut frame);
                }
            }
        }
        loop {
            core::hint::spin_loop();
        }
    }
}
