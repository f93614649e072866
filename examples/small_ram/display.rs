//! The displays that the example draws on, and what is drawn there.

use microraster::math::{Angle, Mat4, Vec3};
use microraster::models::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_POSITIONS};
use microraster::{
    Camera, Color, Cull, DepthBuffer, Flat, Frame, Gouraud, IndexedList, Lambert, Less, Light,
    Mesh, Normal, Pass, Rgb, Rgb565, Shader, Size, Varying,
};

/// Frames of one turn.
pub(crate) const FRAMES: u16 = 8;

/// A model with normals.
pub(crate) type Model<'a> = Mesh<'a, Normal, IndexedList<'a, u16>>;

/// What is drawn, and through how many rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Display {
    /// The example's variant.
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    /// Rows of a band.
    pub(crate) rows: u16,
    /// Whether the model is the bunny, which is not in this repository; else the teapot.
    pub(crate) bunny: bool,
    /// Smooth shading; else flat.
    pub(crate) smooth: bool,
    /// RAM for everything, in bytes.
    pub(crate) ram: usize,
}

impl Display {
    /// Pixels of a band.
    pub(crate) const fn band(&self) -> usize {
        self.size.width as usize * self.rows as usize
    }

    /// Bytes of colour and of depth.
    pub(crate) const fn buffers(&self) -> usize {
        self.band() * (size_of::<u16>() + size_of::<u16>())
    }
}

/// All of them.
pub(crate) const DISPLAYS: [Display; 3] = [
    Display {
        name: "128x64",
        size: Size::new(128, 64),
        rows: 16,
        bunny: false,
        smooth: false,
        ram: 16 * 1024,
    },
    Display {
        name: "320x240",
        size: Size::new(320, 240),
        rows: 15,
        bunny: false,
        smooth: true,
        ram: 32 * 1024,
    },
    Display {
        name: "240x240",
        size: Size::new(240, 240),
        rows: 60,
        bunny: true,
        smooth: true,
        ram: 64 * 1024,
    },
];

/// What turns, and the camera that looks at it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Turntable<'a> {
    model: Model<'a>,
    camera: Camera,
}

/// The frame of a band, or of the whole picture.
type Target<'a> = Frame<'a, Rgb565, DepthBuffer<'a>>;

impl<'a> Turntable<'a> {
    /// A model in a box of about 2 units about the origin.
    pub(crate) fn new(model: Model<'a>) -> Self {
        Self { model, camera: Camera::perspective(Angle::from_degrees(45.0), 0.5) }
    }

    /// Draws one frame in flat triangles.
    pub(crate) fn draw_flat(&self, target: &mut Target<'_>, number: u16) {
        self.draw(target, number, &Flat::new(light()));
    }

    /// Draws one frame in Gouraud triangles.
    pub(crate) fn draw_smooth(&self, target: &mut Target<'_>, number: u16) {
        self.draw(target, number, &Gouraud::new(light()));
    }

    fn draw<S>(&self, target: &mut Target<'_>, number: u16, shader: &S)
    where
        S: Shader<Vertex = Normal>,
        S::Varying: Varying<Corner = Color>,
    {
        let turn = Angle::from_turns(f32::from(number) / f32::from(FRAMES));
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -3.4)) * Mat4::rotation_y(turn);
        target.clear(Rgb::new(16, 24, 48));
        let mut pass = Pass::new(&self.camera).depth(Less).cull(Cull::Back);
        pass.draw(target, &model, &self.model, shader);
    }
}

fn light() -> Lambert<1> {
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::new(204, 204, 204));
    Lambert::new(&[sun]).ambient(Rgb::new(51, 51, 51)).material(Rgb::new(230, 190, 140))
}

/// The teapot, of a height of 2 units.
pub(crate) fn teapot() -> Model<'static> {
    fitted(&TEAPOT_POSITIONS, &TEAPOT_NORMALS, &TEAPOT_INDICES)
}

/// A mesh in a box about the origin of 2 units in height.
pub(crate) fn fitted<'a>(
    positions: &'a [[i16; 3]],
    normals: &'a [Normal],
    indices: &'a [u16],
) -> Model<'a> {
    let (mut low, mut high) = ([i16::MAX; 3], [i16::MIN; 3]);
    for position in positions {
        for axis in 0..3 {
            low[axis] = low[axis].min(position[axis]);
            high[axis] = high[axis].max(position[axis]);
        }
    }
    let middle = |axis: usize| (f32::from(low[axis]) + f32::from(high[axis])) * 0.5;
    let scale = 2.0 / (f32::from(high[1]) - f32::from(low[1]));
    let offset = Vec3::new(middle(0), middle(1), middle(2)) * -scale;
    Mesh::new(positions, normals).indexed(indices).placed(Vec3::splat(scale), offset)
}
