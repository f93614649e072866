//! The scenes, in floats: what every renderer is handed, and turns into its own form beforehand.
//!
//! The board's program includes this file too: no operating system is needed for anything here.

use alloc::vec;
use alloc::vec::Vec;

/// The picture's sides in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    pub(crate) width: u16,
    pub(crate) height: u16,
}

impl Size {
    pub(crate) fn aspect(self) -> f32 {
        f32::from(self.width) / f32::from(self.height)
    }

    pub(crate) fn pixels(self) -> usize {
        usize::from(self.width) * usize::from(self.height)
    }
}

/// A colour of 8 bits a channel.
pub(crate) type Rgb = [u8; 3];

/// Where a triangle's colours come from.
#[derive(Clone, Debug)]
pub(crate) enum Shading {
    /// One for all.
    Solid(Rgb),
    /// One a vertex, interpolated.
    Smooth(Vec<Rgb>),
    /// One a triangle.
    Faces(Vec<Rgb>),
    /// Normals, lit at vertices: interpolated, or that of a triangle's first one.
    Lit { normals: Vec<[f32; 3]>, smooth: bool },
    /// Places in [`TEXELS`], (0, 0) at the upper left, nearest texel.
    Textured(Vec<[f32; 2]>),
    /// The same between the four nearest texels, times a colour a vertex if there are colours.
    Filtered { places: Vec<[f32; 2]>, colors: Option<Vec<Rgb>> },
    /// One for all, and how much of it covers what lies beneath, of 255.
    Glass(Rgb, u8),
}

/// One of the measured scenes.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) name: &'static str,
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) triangles: Vec<[usize; 3]>,
    pub(crate) shading: Shading,
    pub(crate) depth: bool,
    /// Leaves out triangles that run clockwise on the screen.
    pub(crate) culled: bool,
    /// Turns by 22.5 degrees a frame, 16 frames long.
    pub(crate) turns: bool,
}

pub(crate) const FIELD_OF_VIEW: f32 = 45.0;
pub(crate) const NEAR: f32 = 0.5;
pub(crate) const FAR: f32 = 20.0;
/// Where meshes stand.
const DISTANCE: f32 = 3.0178;

/// The direction in which light falls, what is left of it in shade, and the rest.
pub(crate) const SUN: [f32; 3] = [-0.3, -0.6, -1.0];
pub(crate) const AMBIENT: f32 = 0.2;
pub(crate) const DIFFUSE: f32 = 0.8;
pub(crate) const MATERIAL: Rgb = [230, 190, 140];

/// Texels along each side.
pub(crate) const SIDE: usize = 128;

/// Checks of 16 texels, with a ramp across and one down, as RGB565.
pub(crate) static TEXELS: [u16; SIDE * SIDE] = {
    let (mut data, mut i) = ([0; SIDE * SIDE], 0);
    while i < SIDE * SIDE {
        let (x, y) = (i % SIDE, i / SIDE);
        let check = (x / 16 + y / 16) % 2;
        data[i] = ((x / 4) << 11 | (y / 2) << 5 | (check * 31)) as u16;
        i += 1;
    }
    data
};

/// 5, 6 and 5 bits as 8 each.
pub(crate) fn rgb(texel: u16) -> Rgb {
    let [red, green, blue] = [texel >> 11, texel >> 5 & 63, texel & 31].map(u32::from);
    [(red * 255 + 15) / 31, (green * 255 + 31) / 63, (blue * 255 + 15) / 31].map(|c| c as u8)
}

/// 8 bits a channel as 5, 6 and 5.
pub(crate) fn rgb565([red, green, blue]: Rgb) -> u16 {
    u16::from(red) >> 3 << 11 | u16::from(green) >> 2 << 5 | u16::from(blue) >> 3
}

/// A matrix by rows.
pub(crate) type Matrix = [[f32; 4]; 4];

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    core::array::from_fn(|row| {
        core::array::from_fn(|column| (0..4).map(|k| a[row][k] * b[k][column]).sum())
    })
}

/// From the eye's space (looking along -z) to clip space as OpenGL has it.
pub(crate) fn projection(size: Size) -> Matrix {
    let y = 1.0 / libm::tanf(FIELD_OF_VIEW.to_radians() / 2.0);
    let depth = NEAR - FAR;
    [
        [y / size.aspect(), 0.0, 0.0, 0.0],
        [0.0, y, 0.0, 0.0],
        [0.0, 0.0, (FAR + NEAR) / depth, 2.0 * FAR * NEAR / depth],
        [0.0, 0.0, -1.0, 0.0],
    ]
}

impl Scene {
    /// From the mesh's space to the eye's, in a frame.
    pub(crate) fn model_view(&self, frame: usize) -> Matrix {
        let (angle, away) =
            if self.turns { (22.5_f32 * frame as f32, DISTANCE) } else { (0.0, 0.0) };
        let (sin, cos) = libm::sincosf(angle.to_radians());
        [[cos, 0.0, sin, 0.0], [0.0, 1.0, 0.0, 0.0], [-sin, 0.0, cos, -away], [0.0, 0.0, 0.0, 1.0]]
    }

    /// Frames of a round.
    pub(crate) fn frames(&self) -> usize {
        if self.turns {
            16
        } else {
            1
        }
    }

    /// The direction to the light in the mesh's space, of length 1.
    pub(crate) fn to_light(&self, frame: usize) -> [f32; 3] {
        let length = libm::sqrtf(SUN.iter().map(|c| c * c).sum());
        let model_view = self.model_view(frame);
        core::array::from_fn(|column| {
            (0..3).map(|row| model_view[row][column] * -SUN[row] / length).sum()
        })
    }
}

fn scene(
    name: &'static str,
    positions: Vec<[f32; 3]>,
    triangles: Vec<[usize; 3]>,
    shading: Shading,
) -> Scene {
    Scene { name, positions, triangles, shading, depth: true, culled: false, turns: false }
}

/// The scenes; those of the bunny where there is one.
pub(crate) fn scenes(size: Size, bunny: Option<&Mesh>) -> Vec<Scene> {
    // Half the height of the screen at distance 2, and 0.2 % more.
    let half = 2.0 * libm::tanf(FIELD_OF_VIEW.to_radians() / 2.0);
    let (x, y) = (half * size.aspect() * 1.002, half * 1.002);
    let quad = || vec![[-x, -y, -2.0], [x, -y, -2.0], [x, y, -2.0], [-x, y, -2.0]];
    let two = || vec![[0, 1, 2], [0, 2, 3]];
    let orange = || Shading::Solid([255, 128, 0]);
    let colors = || vec![[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255]];
    let leaning =
        || vec![[-1.6, -0.81, -2.0], [1.6, -0.81, -2.0], [1.6, 1.6, -4.0], [-1.6, 1.6, -4.0]];
    let places = || vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let filtered = |colors| Shading::Filtered { places: places(), colors };
    let mut scenes = vec![
        Scene { depth: false, ..scene("F1", quad(), two(), orange()) },
        scene("F2", quad(), two(), orange()),
        scene("F3", quad(), two(), Shading::Smooth(colors())),
        scene("F4", leaning(), two(), Shading::Textured(places())),
        scene("F5", leaning(), two(), filtered(None)),
        scene("F5m", leaning(), two(), filtered(Some(colors()))),
        Scene { depth: false, ..scene("blend", quad(), two(), Shading::Glass([255, 128, 0], 120)) },
        grid(half * size.aspect(), half),
    ];
    scenes.extend(lit("M1-teapot", "M2-teapot", &teapot()));
    if let Some(bunny) = bunny {
        scenes.extend(lit("M1-bunny", "M2-bunny", bunny));
    }
    scenes
}

/// 160x120 quads, each triangle in a colour of its own.
fn grid(x: f32, y: f32) -> Scene {
    const COLUMNS: usize = 160;
    const ROWS: usize = 120;
    let mut positions = Vec::new();
    for row in 0..=ROWS {
        for column in 0..=COLUMNS {
            let across = column as f32 / COLUMNS as f32 * 2.0 - 1.0;
            let up = 1.0 - row as f32 / ROWS as f32 * 2.0;
            positions.push([across * x, up * y, -2.0]);
        }
    }
    let (mut triangles, mut colors) = (Vec::new(), Vec::new());
    for row in 0..ROWS {
        for column in 0..COLUMNS {
            let a = row * (COLUMNS + 1) + column;
            let (b, c, d) = (a + 1, a + COLUMNS + 2, a + COLUMNS + 1);
            for (at, triangle) in [[a, c, b], [a, d, c]].into_iter().enumerate() {
                triangles.push(triangle);
                colors.push([column as u8, 2 * row as u8, 128 + 64 * at as u8]);
            }
        }
    }
    scene("S1", positions, triangles, Shading::Faces(colors))
}

/// Positions, normals and triangles.
pub(crate) type Mesh = (Vec<[f32; 3]>, Vec<[f32; 3]>, Vec<[usize; 3]>);

/// A mesh in smooth and in flat shading, centred on its box and scaled to a height of 2.
fn lit(
    smooth: &'static str,
    flat: &'static str,
    (positions, normals, triangles): &Mesh,
) -> [Scene; 2] {
    let bound = |axis: usize, choose: fn(f32, f32) -> f32| {
        positions.iter().map(|p| p[axis]).reduce(choose).unwrap_or(0.0)
    };
    let low: [f32; 3] = core::array::from_fn(|axis| bound(axis, f32::min));
    let high: [f32; 3] = core::array::from_fn(|axis| bound(axis, f32::max));
    let scale = 2.0 / (high[1] - low[1]);
    let positions: Vec<_> = positions
        .iter()
        .map(|p| core::array::from_fn(|axis| (p[axis] - (low[axis] + high[axis]) / 2.0) * scale))
        .collect();
    [(smooth, true), (flat, false)].map(|(name, smooth)| {
        let shading = Shading::Lit { normals: normals.clone(), smooth };
        Scene {
            culled: true,
            turns: true,
            ..scene(name, positions.clone(), triangles.clone(), shading)
        }
    })
}

/// The bundled teapot.
fn teapot() -> Mesh {
    use microraster::models::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_POSITIONS};
    let positions = TEAPOT_POSITIONS.iter().map(|p| p.map(f32::from)).collect();
    let normals = TEAPOT_NORMALS.iter().map(|n| unit(n.map(f32::from))).collect();
    let triangles =
        TEAPOT_INDICES.chunks_exact(3).map(|t| core::array::from_fn(|at| t[at].into())).collect();
    (positions, normals, triangles)
}

/// A vector of length 1.
pub(crate) fn unit(v: [f32; 3]) -> [f32; 3] {
    let length = libm::sqrtf(v.iter().map(|c| c * c).sum());
    v.map(|c| c / length)
}
