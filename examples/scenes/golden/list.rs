//! The pictures.

use fixed::types::I8F8;
use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::{
    AnyBlend, AnyCompare, AnyDepth, AnyDither, AnyOperation, Camera, Cull, Rect, Rgb, Size,
    Supersampling, Winding,
};

use super::shapes::Shape;
use super::{
    corners, Draw, FragmentState, Kind, MeshDraw, Picture, PixelFormat, ScreenCorner, ScreenDraw,
    Shade,
};
use super::{Facts, Probe, Scene, Stage};

const NIGHT: Rgb = Rgb::new(16, 24, 48);
const PAPER: Rgb = Rgb::new(250, 240, 220);

/// A small picture in RGB565, drawn in one go.
const PLAIN: Picture = Picture {
    name: "",
    size: Size::new(96, 64),
    format: PixelFormat::Rgb565,
    band: 0,
    stride: 0,
    samples: None,
    background: NIGHT,
    draws: &[],
};

/// The teapot from the front, with depth.
const TEAPOT: MeshDraw = MeshDraw {
    shape: Shape::Teapot,
    camera: above,
    model: turned,
    shade: Shade::Gouraud,
    depth: AnyDepth::Less,
    cull: Cull::Back,
    front: Winding::CounterClockwise,
    viewport: None,
    scissor: None,
    fragments: None,
};

/// Anything else, seen from all sides.
const OPEN: MeshDraw = MeshDraw { cull: Cull::None, ..TEAPOT };

/// A bar through the whole view: from behind, as depth does not tell the sides of one apart where
/// the mesh is so much larger than the view.
const BAR: MeshDraw =
    MeshDraw { shape: Shape::FineCube, camera: wide, depth: AnyDepth::Off, ..TEAPOT };

/// All of them.
#[allow(dead_code, reason = "the tests ask for the list")]
pub(crate) fn pictures() -> &'static [Picture] {
    &PICTURES
}

static PICTURES: [Picture; 32] = [
    Picture {
        name: "teapot-flat",
        draws: &[Draw::Mesh(MeshDraw { shade: Shade::Flat, ..TEAPOT })],
        ..PLAIN
    },
    Picture { name: "teapot-gouraud", draws: &[Draw::Mesh(TEAPOT)], ..PLAIN },
    Picture {
        name: "teapot-rgba",
        format: PixelFormat::Rgba8888,
        draws: &[Draw::Mesh(TEAPOT)],
        ..PLAIN
    },
    Picture {
        name: "teapot-swapped",
        format: PixelFormat::Rgb565Be,
        draws: &[Draw::Mesh(TEAPOT)],
        ..PLAIN
    },
    Picture { name: "teapot-bands", band: 7, draws: &[Draw::Mesh(TEAPOT)], ..PLAIN },
    Picture {
        name: "teapot-toon",
        background: PAPER,
        draws: &[Draw::Mesh(MeshDraw { shade: Shade::Toon, cull: Cull::None, ..TEAPOT })],
        ..PLAIN
    },
    // Without depth the far side shows through where it comes later.
    Picture {
        name: "painter",
        draws: &[Draw::Mesh(MeshDraw { depth: AnyDepth::Off, shade: Shade::Flat, ..TEAPOT })],
        ..PLAIN
    },
    // Two viewports, one of them cut by a scissor, in a picture that is part of a larger one.
    Picture {
        name: "viewports",
        stride: 101,
        draws: &[
            Draw::Mesh(MeshDraw {
                viewport: Some(Rect::new(2, 4, 46, 60)),
                model: turned,
                ..TEAPOT
            }),
            Draw::Mesh(MeshDraw {
                viewport: Some(Rect::new(40, -8, 112, 64)),
                scissor: Some(Rect::new(50, 6, 94, 58)),
                model: turned_back,
                ..TEAPOT
            }),
        ],
        ..PLAIN
    },
    Picture {
        name: "floor",
        background: Rgb::new(120, 170, 220),
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Floor,
            camera: low,
            model: Mat4::identity,
            ..OPEN
        })],
        ..PLAIN
    },
    // From inside of a box whose walls reach far beyond the guard box.
    Picture {
        name: "inside",
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Box,
            camera: close,
            model: long,
            cull: Cull::Front,
            ..OPEN
        })],
        ..PLAIN
    },
    // Cut at the near plane in the middle of the picture: colours of the cuts lie between.
    Picture {
        name: "near",
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Rays,
            camera: lens,
            model: Mat4::identity,
            ..OPEN
        })],
        ..PLAIN
    },
    // Bars that are cut at the guard box on both sides.
    Picture {
        name: "bars",
        background: PAPER,
        draws: &[
            Draw::Mesh(MeshDraw { model: bar_a, ..BAR }),
            Draw::Mesh(MeshDraw { model: bar_b, ..BAR }),
            Draw::Mesh(MeshDraw { model: bar_c, ..BAR }),
        ],
        ..PLAIN
    },
    Picture {
        name: "orthographic",
        background: PAPER,
        draws: &[
            Draw::Mesh(MeshDraw {
                shape: Shape::Box,
                camera: isometric,
                model: left_box,
                cull: Cull::Back,
                ..OPEN
            }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Cube,
                camera: isometric,
                model: right_box,
                ..OPEN
            }),
        ],
        ..PLAIN
    },
    Picture {
        name: "cube",
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Cube,
            camera: afar,
            model: tilted,
            ..TEAPOT
        })],
        ..PLAIN
    },
    Picture {
        name: "crossing",
        draws: &[
            Draw::Mesh(MeshDraw { shape: Shape::Sheet(0), camera: afar, model: sheet_a, ..OPEN }),
            Draw::Mesh(MeshDraw { shape: Shape::Sheet(1), camera: afar, model: sheet_b, ..OPEN }),
            Draw::Mesh(MeshDraw { shape: Shape::Sheet(2), camera: afar, model: sheet_c, ..OPEN }),
        ],
        ..PLAIN
    },
    // The second box only where the first one is nearer, the third only where nothing is.
    Picture {
        name: "behind",
        draws: &[
            Draw::Mesh(MeshDraw { shape: Shape::Sheet(0), camera: afar, model: sheet_a, ..OPEN }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Sheet(1),
                camera: afar,
                model: sheet_far,
                depth: AnyDepth::Greater,
                ..OPEN
            }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Teapot,
                camera: afar,
                model: small,
                depth: AnyDepth::LessEqual,
                ..TEAPOT
            }),
        ],
        ..PLAIN
    },
    Picture {
        name: "slivers",
        background: Rgb::BLACK,
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Triangles,
            corner: corners::fan,
            depth: AnyDepth::Off,
            fragments: None,
        })],
        ..PLAIN
    },
    Picture {
        name: "lines",
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Lines,
            corner: corners::star,
            depth: AnyDepth::Less,
            fragments: None,
        })],
        ..PLAIN
    },
    Picture {
        name: "points",
        draws: &[
            Draw::Screen(ScreenDraw {
                kind: Kind::Points(5),
                corner: corners::spiral,
                depth: AnyDepth::Less,
                fragments: None,
            }),
            Draw::Screen(ScreenDraw {
                kind: Kind::Points(1),
                corner: corners::dust,
                depth: AnyDepth::Less,
                fragments: None,
            }),
        ],
        ..PLAIN
    },
    Picture {
        name: "wide-lines",
        background: PAPER,
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Wide(4),
            corner: corners::star,
            depth: AnyDepth::Less,
            fragments: None,
        })],
        ..PLAIN
    },
    Picture {
        name: "stipple",
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Stippled(0x1C7F, 2),
            corner: corners::spiral,
            depth: AnyDepth::Less,
            fragments: None,
        })],
        ..PLAIN
    },
    Picture {
        name: "round-points",
        band: 9,
        background: PAPER,
        draws: &[
            Draw::Screen(ScreenDraw {
                kind: Kind::Round(11),
                corner: corners::spiral,
                depth: AnyDepth::Less,
                fragments: None,
            }),
            Draw::Screen(ScreenDraw {
                kind: Kind::Round(4),
                corner: corners::dust,
                depth: AnyDepth::Less,
                fragments: None,
            }),
        ],
        ..PLAIN
    },
    // The box, each side a strip of its own.
    Picture {
        name: "strips",
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Strips,
            camera: afar,
            model: tilted,
            ..TEAPOT
        })],
        ..PLAIN
    },
    // A fan, flat: no two triangles have the colour of the vertex that all share.
    Picture {
        name: "fan",
        background: PAPER,
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Disc,
            camera: afar,
            model: sheet_b,
            shade: Shade::Flat,
            ..OPEN
        })],
        ..PLAIN
    },
    // Each patch by another mode.
    Picture {
        name: "blends",
        draws: &[
            BACKDROP,
            patch(corners::patch::<0>, AnyBlend::ConstantAlpha(100)),
            patch(corners::patch::<1>, AnyBlend::Add),
            patch(corners::patch::<2>, AnyBlend::Multiply),
            patch(corners::patch::<3>, AnyBlend::Subtract),
            patch(corners::patch::<4>, AnyBlend::Average),
        ],
        ..PLAIN
    },
    Picture { name: "dithered-4x4", draws: &[dusk(AnyDither::Four)], ..PLAIN },
    Picture { name: "dithered-8x8", draws: &[dusk(AnyDither::Eight)], ..PLAIN },
    // A sheet on another one, of the same plane but other triangles.
    Picture {
        name: "offset",
        background: PAPER,
        draws: &[
            Draw::Mesh(MeshDraw { shape: Shape::Sheet(1), camera: afar, model: sheet_b, ..OPEN }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Disc,
                camera: afar,
                model: decal,
                depth: AnyDepth::LessEqual,
                fragments: Some(NEARER),
                ..OPEN
            }),
        ],
        ..PLAIN
    },
    // The teapot's shadow: no pixel is darkened twice.
    Picture {
        name: "planar-shadow",
        draws: &[
            Draw::Mesh(MeshDraw { shape: Shape::Floor, camera: high, model: below, ..OPEN }),
            Draw::Mesh(MeshDraw { camera: high, ..TEAPOT }),
            Draw::Mesh(MeshDraw {
                camera: high,
                model: shadow,
                shade: Shade::Solid(Rgb::BLACK),
                cull: Cull::None,
                depth: AnyDepth::LessEqual,
                fragments: Some(ONCE),
                ..TEAPOT
            }),
        ],
        ..PLAIN
    },
    // Another world through a sheet.
    Picture {
        name: "portal",
        draws: &[
            Draw::Mesh(MeshDraw {
                shape: Shape::Box,
                camera: afar,
                model: in_front,
                cull: Cull::Back,
                ..OPEN
            }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Sheet(1),
                camera: afar,
                model: window,
                fragments: Some(MARK),
                ..OPEN
            }),
            Draw::Mesh(MeshDraw {
                shape: Shape::Sheet(1),
                camera: afar,
                model: window,
                depth: AnyDepth::Always,
                fragments: Some(FORGET),
                ..OPEN
            }),
            Draw::Mesh(MeshDraw {
                camera: afar,
                model: behind_the_window,
                fragments: Some(INSIDE),
                ..TEAPOT
            }),
        ],
        ..PLAIN
    },
    Picture {
        name: "supersampled",
        background: PAPER,
        samples: Some(Supersampling::Two),
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Box,
            camera: afar,
            model: tilted,
            cull: Cull::Back,
            ..OPEN
        })],
        ..PLAIN
    },
    Picture {
        name: "supersampled-4x4",
        samples: Some(Supersampling::Four),
        draws: &[Draw::Mesh(MeshDraw {
            shape: Shape::Sheet(2),
            camera: afar,
            model: sheet_b,
            ..OPEN
        })],
        ..PLAIN
    },
];

const BACKDROP: Draw = Draw::Screen(ScreenDraw {
    kind: Kind::Triangles,
    corner: corners::backdrop,
    depth: AnyDepth::Off,
    fragments: None,
});

/// A gradient of dark tones.
const fn dusk(dither: AnyDither) -> Draw {
    Draw::Screen(ScreenDraw {
        kind: Kind::Triangles,
        corner: corners::dusk,
        depth: AnyDepth::Less,
        fragments: Some(FragmentState { dither, ..DRAWN }),
    })
}

/// A patch on the backdrop.
const fn patch(corner: fn(u32) -> Option<ScreenCorner>, blend: AnyBlend) -> Draw {
    Draw::Screen(ScreenDraw {
        kind: Kind::Triangles,
        corner,
        depth: AnyDepth::Off,
        fragments: Some(FragmentState { blend, ..DRAWN }),
    })
}

const DRAWN: FragmentState = FragmentState::PLAIN;

/// Nearer than what has the same plane.
const NEARER: FragmentState = FragmentState { offset: (I8F8::NEG_ONE, -4), ..DRAWN };

/// Dark where nothing has been darkened.
const ONCE: FragmentState = FragmentState {
    blend: AnyBlend::ConstantAlpha(128),
    stencil: (AnyCompare::Equal, 0, AnyOperation::IncrementWrap),
    ..NEARER
};

const MARK: FragmentState =
    FragmentState { stencil: (AnyCompare::Always, 1, AnyOperation::Replace), ..DRAWN };

const INSIDE: FragmentState =
    FragmentState { stencil: (AnyCompare::Equal, 1, AnyOperation::Keep), ..DRAWN };

/// Nothing is near in the window.
const FORGET: FragmentState = FragmentState { range: (0, 0), ..INSIDE };

fn lens() -> Camera {
    Camera::perspective(45.0.degrees(), 0.5)
}

fn above() -> Camera {
    lens().look_at(Vec3::new(0.0, 2.4, 5.4), Vec3::new(0.15, -0.1, 0.0), Vec3::Y)
}

fn low() -> Camera {
    lens().look_at(Vec3::new(0.3, 1.0, 3.0), Vec3::new(0.0, 0.4, 0.0), Vec3::new(0.1, 1.0, 0.0))
}

fn afar() -> Camera {
    lens().look_at(Vec3::new(0.0, 0.0, 4.2), Vec3::ZERO, Vec3::Y)
}

fn close() -> Camera {
    Camera::perspective(70.0.degrees(), 0.01).look_at(
        Vec3::new(0.3, -0.2, 0.9),
        Vec3::new(0.0, 0.1, -9.0),
        Vec3::new(0.2, 1.0, 0.0),
    )
}

fn isometric() -> Camera {
    Camera::orthographic(4.4, 0.0, 7.1).look_at(Vec3::new(3.0, 2.5, 3.0), Vec3::ZERO, Vec3::Y)
}

fn wide() -> Camera {
    Camera::orthographic(4.0, -400.0, 400.0)
}

// Numbers of 1/64 upwards and of 3/128 sideways: matrices of bars so long lose nothing of them.

fn bar_a() -> Mat4 {
    Mat4::from_rows(
        Vec4::new(384.0, 0.0, 0.0, -90.0),
        Vec4::new(24.0, 36.0 / 64.0, 14.0 / 64.0, -298.0 / 64.0),
        Vec4::new(0.0, -14.0 / 64.0, 36.0 / 64.0, 0.0),
        Vec4::W,
    )
}

fn bar_b() -> Mat4 {
    Mat4::from_rows(
        Vec4::new(-384.0, 0.0, 0.0, 60.0),
        Vec4::new(40.0, -36.0 / 64.0, 20.0 / 64.0, -458.0 / 64.0),
        Vec4::new(0.0, 20.0 / 64.0, 36.0 / 64.0, 0.0),
        Vec4::W,
    )
}

fn bar_c() -> Mat4 {
    Mat4::from_rows(
        Vec4::new(12.0, -90.0 / 128.0, -45.0 / 128.0, 198.0 / 128.0),
        Vec4::new(300.0, 0.0, 0.0, 40.0),
        Vec4::new(0.0, -45.0 / 128.0, 90.0 / 128.0, 0.0),
        Vec4::W,
    )
}

fn turned() -> Mat4 {
    Mat4::rotation_y(25.0.degrees())
}

fn turned_back() -> Mat4 {
    Mat4::rotation_y(200.0.degrees())
}

fn tilted() -> Mat4 {
    Mat4::rotation_x(30.0.degrees()) * Mat4::rotation_y(40.0.degrees()) * scale(0.9)
}

fn long() -> Mat4 {
    Mat4::scale(Vec3::new(1.0, 0.8, 6.0))
}

fn left_box() -> Mat4 {
    Mat4::translation(Vec3::new(-0.9, 0.0, 0.9)) * scale(0.8)
}

fn right_box() -> Mat4 {
    Mat4::translation(Vec3::new(1.0, 0.0, -1.0)) * scale(0.8)
}

fn sheet_a() -> Mat4 {
    Mat4::rotation_y(50.0.degrees()) * scale(1.3)
}

fn sheet_b() -> Mat4 {
    Mat4::rotation_y((-35.0).degrees()) * Mat4::rotation_z(20.0.degrees()) * scale(1.3)
}

fn sheet_c() -> Mat4 {
    Mat4::rotation_x(70.0.degrees()) * scale(1.2)
}

fn sheet_far() -> Mat4 {
    Mat4::translation(Vec3::new(0.4, 0.3, -2.0)) * scale(1.6)
}

fn small() -> Mat4 {
    Mat4::translation(Vec3::new(-0.2, -0.5, 1.0)) * Mat4::rotation_y(30.0.degrees()) * scale(0.4)
}

/// On the sheet, which it crosses by a rounding error at most.
fn decal() -> Mat4 {
    sheet_b() * scale(0.7)
}

fn high() -> Camera {
    lens().look_at(Vec3::new(0.0, 3.2, 6.6), Vec3::new(0.2, -0.3, 0.0), Vec3::Y)
}

/// The height of the floor below the teapot.
const FLOOR: f32 = -1.0;

fn below() -> Mat4 {
    Mat4::translation(Vec3::new(0.0, FLOOR, 0.0))
}

/// The teapot, moved along the light to the floor.
fn shadow() -> Mat4 {
    let (x, z) = (-0.75, -0.5);
    let flattened = Mat4::from_rows(
        Vec4::new(1.0, -x, 0.0, x * FLOOR),
        Vec4::new(0.0, 0.0, 0.0, FLOOR),
        Vec4::new(0.0, -z, 1.0, z * FLOOR),
        Vec4::W,
    );
    flattened * turned()
}

fn in_front() -> Mat4 {
    Mat4::translation(Vec3::new(-0.7, -0.5, 0.9)) * tilted() * scale(0.4)
}

fn window() -> Mat4 {
    Mat4::rotation_y(20.0.degrees()) * scale(1.1)
}

fn behind_the_window() -> Mat4 {
    Mat4::translation(Vec3::new(0.3, -0.2, -1.5)) * Mat4::rotation_y(30.0.degrees())
}

fn scale(factor: f32) -> Mat4 {
    Mat4::scale(Vec3::new(factor, factor, factor))
}

/// Picture number `I`.
fn at<P: Probe, const I: usize>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    match PICTURES.get(I) {
        Some(picture) => super::draw(stage, probe, picture),
        None => Facts { bytes: 0, triangles: 0 },
    }
}

/// The scenes of the pictures.
pub(super) fn scenes<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    let draws = [
        at::<P, 0>,
        at::<P, 1>,
        at::<P, 2>,
        at::<P, 3>,
        at::<P, 4>,
        at::<P, 5>,
        at::<P, 6>,
        at::<P, 7>,
        at::<P, 8>,
        at::<P, 9>,
        at::<P, 10>,
        at::<P, 11>,
        at::<P, 12>,
        at::<P, 13>,
        at::<P, 14>,
        at::<P, 15>,
        at::<P, 16>,
        at::<P, 17>,
        at::<P, 18>,
        at::<P, 19>,
        at::<P, 20>,
        at::<P, 21>,
        at::<P, 22>,
        at::<P, 23>,
        at::<P, 24>,
        at::<P, 25>,
        at::<P, 26>,
        at::<P, 27>,
        at::<P, 28>,
        at::<P, 29>,
        at::<P, 30>,
        at::<P, 31>,
    ];
    PICTURES.iter().zip(draws).map(|(picture, draw)| super::scene(picture.name, draw))
}
