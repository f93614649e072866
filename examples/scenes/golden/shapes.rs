//! The meshes of the small pictures.

use microraster::math::Vec3;
use microraster::models::{TEAPOT_INDICES, TEAPOT_NORMALS, TEAPOT_POSITIONS, TEAPOT_SCALE};
use microraster::{
    AnyTopology, Consecutive, IndexedList, List, Mesh, Normal, RestartIndices, Rgb, TriangleFan,
    TriangleStrip,
};

/// A mesh by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Newell's teapot, with normals.
    Teapot,
    /// The colour cube: a corner's colour is where it lies.
    Cube,
    /// The colour cube in positions that use their range.
    FineCube,
    /// A box with one colour a side.
    Box,
    /// A chequered floor, one colour a square.
    Floor,
    /// One sheet, in one of three colours.
    Sheet(usize),
    /// Four triangles from a far corner each to two behind the eye, below, above and beside it.
    Rays,
    /// The box by strips.
    Strips,
    /// A disc of twelve triangles about its middle.
    Disc,
}

/// What belongs to the vertices or faces of a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Attributes {
    Normals(&'static [Normal]),
    Colors(&'static [Rgb]),
    FaceColors(&'static [Rgb]),
}

/// A mesh as the arrays that it is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Arrays {
    pub(crate) positions: &'static [[i16; 3]],
    pub(crate) attributes: Attributes,
    pub(crate) topology: AnyTopology<'static>,
    pub(crate) scale: Vec3,
    pub(crate) offset: Vec3,
}

impl Arrays {
    /// The mesh, with attributes that the caller took from it.
    pub(crate) fn mesh<A>(
        &self,
        attributes: &'static [A],
    ) -> Mesh<'static, A, AnyTopology<'static>> {
        Mesh::new(self.positions, attributes)
            .with_topology(self.topology)
            .placed(self.scale, self.offset)
    }
}

impl Shape {
    pub(crate) fn arrays(self) -> Arrays {
        let one = Vec3::new(1.0, 1.0, 1.0);
        match self {
            Self::Teapot => Arrays {
                positions: &TEAPOT_POSITIONS,
                attributes: Attributes::Normals(&TEAPOT_NORMALS),
                topology: AnyTopology::Indexed16(IndexedList::new(&TEAPOT_INDICES)),
                scale: Vec3::new(TEAPOT_SCALE, TEAPOT_SCALE, TEAPOT_SCALE),
                offset: Vec3::ZERO,
            },
            Self::Cube => Arrays {
                positions: &CORNERS,
                attributes: Attributes::Colors(&CORNER_COLORS),
                topology: AnyTopology::Indexed8(IndexedList::new(&BOX_INDICES)),
                scale: one,
                offset: Vec3::ZERO,
            },
            Self::FineCube => Arrays {
                positions: &FINE_CORNERS,
                attributes: Attributes::Colors(&CORNER_COLORS),
                topology: AnyTopology::Indexed8(IndexedList::new(&BOX_INDICES)),
                scale: one * (1.0 / f32::from(FINE)),
                offset: Vec3::ZERO,
            },
            Self::Box => Arrays {
                positions: &CORNERS,
                attributes: Attributes::FaceColors(&SIDE_COLORS),
                topology: AnyTopology::Indexed8(IndexedList::new(&BOX_INDICES)),
                scale: one,
                offset: Vec3::ZERO,
            },
            Self::Floor => Arrays {
                positions: &FLOOR,
                attributes: Attributes::FaceColors(&FLOOR_COLORS),
                topology: AnyTopology::Indexed16(IndexedList::new(&FLOOR_INDICES)),
                scale: one,
                offset: Vec3::ZERO,
            },
            Self::Sheet(i) => Arrays {
                positions: &SHEET,
                attributes: Attributes::FaceColors(SHEET_COLORS[i % 3]),
                topology: AnyTopology::List(List::new(SHEET.len())),
                scale: one,
                offset: Vec3::ZERO,
            },
            Self::Strips => Arrays {
                positions: &CORNERS,
                attributes: Attributes::FaceColors(&SIDE_COLORS),
                topology: AnyTopology::RestartStrip8(TriangleStrip::new(RestartIndices::new(
                    &STRIP_INDICES,
                ))),
                scale: one,
                offset: Vec3::ZERO,
            },
            Self::Disc => Arrays {
                positions: &DISC,
                attributes: Attributes::Colors(&DISC_COLORS),
                topology: AnyTopology::Fan(TriangleFan::new(Consecutive::new(DISC.len()))),
                scale: Vec3::new(0.01, 0.01, 0.01),
                offset: Vec3::ZERO,
            },
            Self::Rays => Arrays {
                positions: &RAYS,
                attributes: Attributes::Colors(&RAY_COLORS),
                topology: AnyTopology::List(List::new(RAYS.len())),
                scale: Vec3::new(RAY_SCALE, RAY_SCALE, RAY_SCALE),
                offset: Vec3::ZERO,
            },
        }
    }
}

static CORNERS: [[i16; 3]; 8] = [
    [-1, -1, -1],
    [1, -1, -1],
    [-1, 1, -1],
    [1, 1, -1],
    [-1, -1, 1],
    [1, -1, 1],
    [-1, 1, 1],
    [1, 1, 1],
];

/// Half a side of the fine cube.
const FINE: i16 = 1 << 14;

static FINE_CORNERS: [[i16; 3]; 8] = {
    let mut corners = CORNERS;
    let mut i = 0;
    while i < 24 {
        corners[i / 3][i % 3] *= FINE;
        i += 1;
    }
    corners
};

static CORNER_COLORS: [Rgb; 8] = [
    Rgb::BLACK,
    Rgb::RED,
    Rgb::GREEN,
    Rgb::new(255, 255, 0),
    Rgb::BLUE,
    Rgb::new(255, 0, 255),
    Rgb::new(0, 255, 255),
    Rgb::WHITE,
];

/// Counter-clockwise from outside: front, back, right, left, top, bottom.
static BOX_INDICES: [u8; 36] = [
    4, 5, 7, 4, 7, 6, 1, 0, 2, 1, 2, 3, 5, 1, 3, 5, 3, 7, 0, 4, 6, 0, 6, 2, 6, 7, 3, 6, 3, 2, 0, 1,
    5, 0, 5, 4,
];

/// The same six sides, with a restart after each but the last.
static STRIP_INDICES: [u8; 29] = [
    5, 7, 4, 6, 255, 0, 2, 1, 3, 255, 1, 3, 5, 7, 255, 4, 6, 0, 2, 255, 7, 3, 6, 2, 255, 1, 5, 0, 4,
];

/// The middle, and a rim of which the first corner is the last one too.
static DISC: [[i16; 3]; 14] = [
    [0, 0, 0],
    [100, 0, 0],
    [87, 50, 0],
    [50, 87, 0],
    [0, 100, 0],
    [-50, 87, 0],
    [-87, 50, 0],
    [-100, 0, 0],
    [-87, -50, 0],
    [-50, -87, 0],
    [0, -100, 0],
    [50, -87, 0],
    [87, -50, 0],
    [100, 0, 0],
];

#[allow(clippy::cast_possible_truncation, reason = "fewer than 14")]
static DISC_COLORS: [Rgb; 14] = {
    let mut colors = [Rgb::BLACK; 14];
    let mut i = 1;
    while i < 14 {
        let part = i as u8 * 18;
        colors[i] = Rgb::new(part, 255 - part, 120);
        i += 1;
    }
    colors
};

static SIDE_COLORS: [Rgb; 12] = {
    let sides = [
        Rgb::new(235, 95, 85),
        Rgb::new(255, 190, 120),
        Rgb::new(110, 180, 95),
        Rgb::new(70, 130, 180),
        Rgb::new(240, 230, 200),
        Rgb::new(95, 75, 100),
    ];
    let mut colors = [Rgb::BLACK; 12];
    let mut i = 0;
    while i < 12 {
        colors[i] = sides[i / 2];
        i += 1;
    }
    colors
};

/// Squares along a side of the floor.
const SQUARES: usize = 12;
const LINES: usize = SQUARES + 1;

/// From -12 to 12 at height 0.
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "below 13")]
static FLOOR: [[i16; 3]; LINES * LINES] = {
    let mut positions = [[0; 3]; LINES * LINES];
    let mut i = 0;
    while i < LINES * LINES {
        positions[i] = [(i % LINES) as i16 * 2 - 12, 0, (i / LINES) as i16 * 2 - 12];
        i += 1;
    }
    positions
};

#[allow(clippy::cast_possible_truncation, reason = "fewer than 169 vertices")]
static FLOOR_INDICES: [u16; 6 * SQUARES * SQUARES] = {
    let mut indices = [0; 6 * SQUARES * SQUARES];
    let mut i = 0;
    while i < SQUARES * SQUARES {
        let a = (i / SQUARES * LINES + i % SQUARES) as u16;
        let (b, c, d) = (a + 1, a + LINES as u16, a + LINES as u16 + 1);
        let six = [a, c, d, a, d, b];
        let mut k = 0;
        while k < 6 {
            indices[6 * i + k] = six[k];
            k += 1;
        }
        i += 1;
    }
    indices
};

static FLOOR_COLORS: [Rgb; 2 * SQUARES * SQUARES] = {
    let mut colors = [Rgb::BLACK; 2 * SQUARES * SQUARES];
    let mut i = 0;
    while i < 2 * SQUARES * SQUARES {
        let light = (i / 2 % SQUARES + i / 2 / SQUARES).is_multiple_of(2);
        colors[i] = if light { Rgb::new(230, 220, 200) } else { Rgb::new(90, 60, 70) };
        i += 1;
    }
    colors
};

static SHEET: [[i16; 3]; 6] =
    [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, -1, 0], [1, 1, 0], [-1, 1, 0]];

static SHEET_COLORS: [&[Rgb]; 3] = [
    &[Rgb::new(235, 95, 85), Rgb::new(225, 80, 75)],
    &[Rgb::new(70, 130, 180), Rgb::new(60, 115, 165)],
    &[Rgb::new(255, 200, 90), Rgb::new(245, 185, 80)],
];

/// Positions use their range: that is where precision comes from.
const RAY_SCALE: f32 = 0.05 / 300.0;

static RAYS: [[i16; 3]; 12] = [
    // Below.
    [0, -900, -24000],
    [-9000, -900, 12000],
    [9000, -900, 12000],
    // Above.
    [9000, 1200, -27000],
    [9000, 900, 12000],
    [-12000, 900, 12000],
    // To the left and to the right.
    [-18000, 0, 15000],
    [-3600, 2400, -18000],
    [3000, -12000, 15000],
    [12000, -600, 15000],
    [-1200, 9000, 15000],
    [3600, 0, -21000],
];

static RAY_COLORS: [Rgb; 12] = [
    Rgb::new(255, 255, 255),
    Rgb::new(235, 40, 30),
    Rgb::new(30, 60, 235),
    Rgb::new(20, 30, 60),
    Rgb::new(60, 230, 120),
    Rgb::new(250, 220, 60),
    Rgb::new(255, 90, 200),
    Rgb::new(240, 240, 160),
    Rgb::new(60, 20, 110),
    Rgb::new(40, 200, 230),
    Rgb::new(240, 120, 20),
    Rgb::new(10, 60, 40),
];
