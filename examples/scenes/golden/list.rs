//! The pictures.

use microraster::math::{AngleUnits, Mat4, Vec3, Vec4};
use microraster::{AnyDepth, Camera, Cull, Rect, Rgb, Size, Winding};

use super::shapes::Shape;
use super::{corners, Draw, Kind, MeshDraw, Picture, PixelFormat, ScreenDraw, Shade};
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

static PICTURES: [Picture; 24] = [
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
        })],
        ..PLAIN
    },
    Picture {
        name: "lines",
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Lines,
            corner: corners::star,
            depth: AnyDepth::Less,
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
            }),
            Draw::Screen(ScreenDraw {
                kind: Kind::Points(1),
                corner: corners::dust,
                depth: AnyDepth::Less,
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
        })],
        ..PLAIN
    },
    Picture {
        name: "stipple",
        draws: &[Draw::Screen(ScreenDraw {
            kind: Kind::Stippled(0x1C7F, 2),
            corner: corners::spiral,
            depth: AnyDepth::Less,
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
            }),
            Draw::Screen(ScreenDraw {
                kind: Kind::Round(4),
                corner: corners::dust,
                depth: AnyDepth::Less,
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
];

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
    ];
    PICTURES.iter().zip(draws).map(|(picture, draw)| super::scene(picture.name, draw))
}
