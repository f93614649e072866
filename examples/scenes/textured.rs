//! The measured scenes with a texture: a tilted quad of about 70 600 pixels, w ratio 2.

use microraster::math::{Angle, Mat4, Vec3};
use microraster::{
    Camera, Color, DrawContext, Frame, IndexedList, Less, Mesh, Pass, Perspective,
    PerspectiveCorner, Rgb, Rgb565, Shader, Size, Stats, Uv, VertexInput,
};

use super::{Facts, Group, Probe, Scene, Stage, ROOM};

const SIZE: Size = Size::new(320, 240);

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 1] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [scene("F4", f4::<P>)]
}

static QUAD: [[i16; 3]; 4] = [
    [-16000, -8100, 10000],
    [16000, -8100, 10000],
    [16000, 16000, -10000],
    [-16000, 16000, -10000],
];
static COORDINATES: [[i16; 2]; 4] = [[0, 4096], [4096, 4096], [4096, 0], [0, 0]];
static INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];

#[allow(clippy::cast_possible_truncation, reason = "sixteen bits")]
static TEXTURE: [u16; 128 * 128] = {
    let mut t = [0; 128 * 128];
    let mut i = 0;
    while i < t.len() {
        let (x, y) = (i % 128, i / 128);
        t[i] = (((x ^ y) >> 2) << 11 | x >> 1 << 5 | y >> 2) as u16;
        i += 1;
    }
    t
};

struct Nearest<'a> {
    texels: &'a [u16],
    shift: u32,
    mask: u32,
    up: u32,
}

impl Shader for Nearest<'_> {
    type Vertex = [i16; 2];
    type Varying = Perspective<Uv>;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), vertex: VertexInput<'_, [i16; 2]>) -> PerspectiveCorner<[i16; 2]> {
        (*vertex.attributes).into()
    }

    #[inline(always)]
    fn fragment(&self, uv: &Perspective<Uv>) -> Option<Color> {
        let x = (uv.u as u32 >> self.shift) & self.mask;
        let y = (uv.v as u32 >> self.shift) & self.mask;
        Some(Rgb565::decode(self.texels.get((y << self.up | x) as usize).copied().unwrap_or(0)))
    }
}

fn f4<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    let color = bytemuck::cast_slice_mut(stage.color);
    let frame = Frame::<Rgb565>::new(color, SIZE).and_then(|frame| frame.with_depth(stage.depth));
    if let Ok(mut frame) = frame {
        frame.clear(Rgb::BLACK);
        let camera = Camera::perspective(Angle::from_degrees(45.0), 0.5);
        let scale = 0.0001;
        // z runs from -2 to -4 about -3.
        let mesh: Mesh<'_, [i16; 2], IndexedList<'_, u16>> = Mesh::new(&QUAD, &COORDINATES)
            .indexed(&INDICES)
            .placed(Vec3::new(scale, scale, scale), Vec3::new(0.0, 0.0, -3.0));
        let shader = Nearest { texels: &TEXTURE, shift: 16 + 12 - 7, mask: 127, up: 7 };
        if P::COUNTING {
            let mut stats = Stats::default();
            Pass::new(&camera).depth(Less).count(&mut stats).draw(
                &mut frame,
                &Mat4::identity(),
                &mesh,
                &shader,
            );
            probe.pixels(stats.pixels.into());
        } else {
            probe.measure(|| {
                Pass::new(&camera).depth(Less).draw(&mut frame, &Mat4::identity(), &mesh, &shader)
            });
        }
    }
    Facts { bytes: 2 * ROOM, triangles: 2 }
}
