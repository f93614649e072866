//! Draws a user's model with the settings that `cargo budget` asks for and prints what they cost.
//!
//! Each word `SHADING:CACHE:WIDTH:HEIGHT:ROWS` becomes a line: instructions of a frame, the mean of
//! some views, and the deepest stack. Built as a variant `SHADING CACHE` it has only the code of
//! those, for a look at its size.
#![cfg_attr(target_os = "none", no_std, no_main)]

#[cfg(target_os = "none")]
#[allow(dead_code, reason = "the host asks for more of it")]
mod settings;

#[cfg(target_os = "none")]
#[path = "../board/mod.rs"]
mod board;
#[cfg(target_os = "none")]
#[path = "../board/feature.rs"]
mod feature;
#[cfg(target_os = "none")]
#[path = "../scenes/model.rs"]
mod model;

#[cfg(not(target_os = "none"))]
fn main() {
    println!("This runs under QEMU: `cargo budget` builds it and asks it.");
}

#[cfg(target_os = "none")]
mod firmware {
    use crate::board::buffer::Buffer;
    use crate::board::{meter, say, semihost, stack};
    use crate::feature;
    use crate::model::{Model, HEADER};
    use crate::settings::{self, BAND_ROOM, DISTANCE, MESH_ROOM, VIEWS, WEIGHED};
    use core::hint::black_box;
    use microraster::math::{Angle, Mat4, Vec3};
    use microraster::{
        Camera, Color, Cull, DepthBuffer, Flat, Frame, Gouraud, IndexedList, Lambert, Less, Light,
        Mesh, Normal, Pass, Rgb, Rgb565, Shader, Size, Varying, VertexCache,
    };

    /// Whether this is one of the variants that are weighed.
    const IS_WEIGHED: bool = option_env!("MICRORASTER_FEATURE").is_some();

    /// Elements of a buffer that is small in what is weighed.
    const fn room(measured: usize, weighed: usize) -> usize {
        if IS_WEIGHED {
            weighed
        } else {
            measured
        }
    }

    static COLOR: Buffer<[u16; room(BAND_ROOM, WEIGHED)]> =
        Buffer::new([0; room(BAND_ROOM, WEIGHED)]);
    static DEPTH: Buffer<[u16; room(BAND_ROOM, WEIGHED)]> =
        Buffer::new([0; room(BAND_ROOM, WEIGHED)]);
    static MESH: Buffer<[u32; MESH_ROOM / 4]> = Buffer::new([0; MESH_ROOM / 4]);
    static WORDS: Buffer<[u8; 4096]> = Buffer::new([0; 4096]);

    const BLANK: Color = Color::new(0, 0, 0);
    static CACHE_64: Buffer<VertexCache<Color, 64>> = Buffer::new(VertexCache::with_blank(BLANK));
    static CACHE_256: Buffer<VertexCache<Color, 256>> = Buffer::new(VertexCache::with_blank(BLANK));
    static CACHE_1024: Buffer<VertexCache<Color, 1024>> =
        Buffer::new(VertexCache::with_blank(BLANK));
    const _: () = assert!(
        size_of::<VertexCache<Color, 64>>() == settings::cache_bytes(64),
        "the host counts as many bytes"
    );

    type Band<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;
    type Part<'a> = Mesh<'a, Normal, IndexedList<'a, u16>>;

    /// The caches; only those that are asked for are linked.
    struct Caches {
        small: Option<&'static mut VertexCache<Color, 64>>,
        middle: Option<&'static mut VertexCache<Color, 256>>,
        large: Option<&'static mut VertexCache<Color, 1024>>,
    }

    impl Caches {
        /// Whether firmware of this shading and cache is wanted.
        const fn linked(gouraud: &str, flat: &str) -> bool {
            !IS_WEIGHED || feature::is(gouraud) || feature::is(flat)
        }

        fn take() -> Self {
            let small = if const { Self::linked("gouraud 64", "flat 64") } {
                CACHE_64.take()
            } else {
                None
            };
            let middle = if const { Self::linked("gouraud 256", "flat 256") } {
                CACHE_256.take()
            } else {
                None
            };
            let large = if const { Self::linked("gouraud 1024", "flat 1024") } {
                CACHE_1024.take()
            } else {
                None
            };
            Self { small, middle, large }
        }

        /// Draws with the cache of this size.
        fn draw<S>(
            &mut self,
            cache: u16,
            view: &View,
            band: &mut Band<'_>,
            part: &Part<'_>,
            shader: &S,
        ) where
            S: Shader<Vertex = Normal>,
            S::Varying: Varying<Corner = Color>,
        {
            let View { camera, model } = view;
            let mut pass = Pass::new(camera).depth(Less).cull(Cull::Back);
            let Self { small, middle, large } = self;
            match (cache, small, middle, large) {
                (64, Some(small), _, _) => pass.draw_cached(band, model, part, shader, *small),
                (256, _, Some(middle), _) => pass.draw_cached(band, model, part, shader, *middle),
                (1024, _, _, Some(large)) => pass.draw_cached(band, model, part, shader, *large),
                _ if const { Self::linked("gouraud 0", "flat 0") } => {
                    pass.draw(band, model, part, shader);
                }
                _ => {}
            }
        }
    }

    /// From where the model is seen.
    struct View {
        camera: Camera,
        model: Mat4,
    }

    /// The view of this number.
    fn view(number: u16) -> View {
        let turn = Angle::from_turns(f32::from(number) / f32::from(VIEWS));
        View {
            camera: Camera::perspective(Angle::from_degrees(45.0), 0.1),
            model: Mat4::translation(Vec3::new(0.0, 0.0, -DISTANCE)) * Mat4::rotation_y(turn),
        }
    }

    fn lighting() -> Lambert<1> {
        let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
        Lambert::new(&[sun]).ambient(Rgb::new(51, 51, 51)).material(Rgb::new(230, 190, 140))
    }

    /// How a frame is drawn.
    #[derive(Clone, Copy)]
    struct Setting {
        gouraud: bool,
        cache: u16,
        size: Size,
        rows: u16,
    }

    impl Setting {
        /// Reads `SHADING:CACHE:WIDTH:HEIGHT:ROWS`.
        fn read(word: &str) -> Option<Self> {
            let mut parts = word.split(':');
            let gouraud = match parts.next()? {
                "gouraud" => true,
                "flat" => false,
                _ => return None,
            };
            let mut number = || parts.next()?.parse::<u16>().ok();
            let cache = number()?;
            let size = Size::new(number()?, number()?);
            Some(Self { gouraud, cache, size, rows: number()?.max(1) })
        }
    }

    /// What is drawn with and into.
    struct Stage<'a> {
        color: &'a mut [u16],
        depth: &'a mut [u16],
        caches: Caches,
        file: &'a [u8],
    }

    impl Stage<'_> {
        /// Draws all parts of the model into all bands; `None` where a band is too large.
        fn frame(&mut self, setting: Setting, view: &View) -> Option<()> {
            let Setting { gouraud, cache, size, rows } = setting;
            let mut first = 0;
            while first < size.height {
                let held = Size::new(size.width, rows.min(size.height.saturating_sub(first)));
                let frame = Frame::<Rgb565>::new(self.color, held).ok()?;
                let mut band = frame.with_depth(self.depth).ok()?.band(first, size.height).ok()?;
                band.clear(Rgb::new(16, 24, 48));
                let mut rest = self.file;
                while let Some(part) = Model::view(rest) {
                    let mesh = Mesh::new(part.positions, part.normals)
                        .indexed(part.indices)
                        .placed(Vec3::splat(part.scale), Vec3::ZERO);
                    if gouraud && const { wants("gouraud") } {
                        self.caches.draw(cache, view, &mut band, &mesh, &Gouraud::new(lighting()));
                    }
                    if !gouraud && const { wants("flat") } {
                        self.caches.draw(cache, view, &mut band, &mesh, &Flat::new(lighting()));
                    }
                    let bytes = HEADER
                        + size_of_val(part.positions)
                        + size_of_val(part.normals)
                        + size_of_val(part.indices);
                    rest = rest.get(bytes.next_multiple_of(4)..).unwrap_or(&[]);
                }
                first = first.saturating_add(rows);
            }
            Some(())
        }
    }

    /// Whether firmware of this shading is wanted.
    const fn wants(shading: &str) -> bool {
        let Some(wanted) = option_env!("MICRORASTER_FEATURE") else { return true };
        let (wanted, shading) = (wanted.as_bytes(), shading.as_bytes());
        let mut at = 0;
        while at < shading.len() && at < wanted.len() && wanted[at] == shading[at] {
            at += 1;
        }
        at == shading.len()
    }

    /// Measures what the command line asks for; `None` when the board lacks something.
    fn measure() -> Option<()> {
        let words = semihost::command_line(WORDS.take()?)?;
        let mut file = semihost::File::open(c"budget.mesh", semihost::Mode::Read)?;
        let mut stage = Stage {
            color: COLOR.take()?,
            depth: DEPTH.take()?,
            caches: Caches::take(),
            file: file.read(bytemuck::cast_slice_mut(MESH.take()?))?,
        };
        let empty = meter::instructions(|| ()).0;
        for word in words.split(' ').filter(|word| word.contains(':')) {
            let setting = Setting::read(word)?;
            let (mut sum, mut deepest) = (0, 0);
            for number in 0..VIEWS {
                let view = view(number);
                let mark = stack::paint();
                let (instructions, drawn) = meter::instructions(|| stage.frame(setting, &view));
                drawn?;
                deepest = deepest.max(stack::deepest(mark));
                sum += instructions.saturating_sub(empty);
            }
            say!("setting={word} instructions={} stack={deepest}", sum / u64::from(VIEWS));
        }
        Some(())
    }

    /// Draws one view of hidden data, as a user's firmware would; returns nothing.
    fn weighed() -> Option<()> {
        static FILE: [u32; 8] = [0; 8];
        let cache = if const { Caches::linked("gouraud 64", "flat 64") } {
            64
        } else if const { Caches::linked("gouraud 256", "flat 256") } {
            256
        } else if const { Caches::linked("gouraud 1024", "flat 1024") } {
            1024
        } else {
            0
        };
        let mut stage = Stage {
            color: COLOR.take()?,
            depth: DEPTH.take()?,
            caches: Caches::take(),
            file: bytemuck::cast_slice(black_box(&FILE)),
        };
        let size = black_box(Size::new(8, 8));
        let setting = Setting { gouraud: wants("gouraud"), cache, size, rows: black_box(8) };
        stage.frame(setting, &view(black_box(0)))?;
        black_box(stage.color);
        Some(())
    }

    #[cfg_attr(target_arch = "arm", cortex_m_rt::entry)]
    #[cfg_attr(target_arch = "riscv32", riscv_rt::entry)]
    fn main() -> ! {
        if const { IS_WEIGHED } {
            black_box(weighed());
            loop {
                core::hint::spin_loop();
            }
        }
        let done = measure();
        if done.is_none() {
            say!("error: no mesh, a band that is too large, or a setting of no known form");
        }
        semihost::exit(u32::from(done.is_none()))
    }
}
