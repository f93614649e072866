//! Small pictures that are kept and compared exactly.
//!
//! A picture is data: what is drawn in which state, in which memory. [`render`] draws it with the
//! crate; the tests draw the same data with a renderer that shares nothing with the crate.

pub(crate) mod corners;
mod list;
pub(crate) mod render;
pub(crate) mod shapes;

use microraster::math::Mat4;
use microraster::{AnyDepth, Camera, Cull, Rect, Rgb, Size, Winding};

use super::{Facts, Group, Probe, Scene, Stage};
#[allow(unused_imports, reason = "the tests ask for the list")]
pub(crate) use list::pictures;
use shapes::Shape;

/// A picture: its memory, and what is drawn.
pub(crate) struct Picture {
    pub(crate) name: &'static str,
    pub(crate) size: Size,
    pub(crate) format: PixelFormat,
    /// Rows that are drawn at a time; all of them where this is 0.
    pub(crate) band: u16,
    /// Pixels from one row to the next; 0 for no gap.
    pub(crate) stride: u32,
    pub(crate) background: Rgb,
    pub(crate) draws: &'static [Draw],
}

/// How pixels are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PixelFormat {
    Rgb565,
    Rgb565Be,
    Rgba8888,
}

/// What is drawn at once.
#[derive(Clone, Copy)]
pub(crate) enum Draw {
    /// A mesh through a camera.
    Mesh(MeshDraw),
    /// Primitives in screen space: subpixels, depth codes, colours.
    Screen(ScreenDraw),
}

/// A mesh, how it is seen and in which state it is drawn.
#[derive(Clone, Copy)]
pub(crate) struct MeshDraw {
    pub(crate) shape: Shape,
    pub(crate) camera: fn() -> Camera,
    pub(crate) model: fn() -> Mat4,
    pub(crate) shade: Shade,
    pub(crate) depth: AnyDepth,
    pub(crate) cull: Cull,
    pub(crate) front: Winding,
    pub(crate) viewport: Option<Rect>,
    pub(crate) scissor: Option<Rect>,
}

/// How a mesh is coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shade {
    Flat,
    Gouraud,
    /// The shader of a user's own, in four tones.
    Toon,
}

/// A corner: x and y in subpixels, depth code, colour.
pub(crate) type ScreenCorner = (i32, i32, u16, Rgb);

/// Primitives in screen space.
#[derive(Clone, Copy)]
pub(crate) struct ScreenDraw {
    pub(crate) kind: Kind,
    /// Corner `i`, or `None` after the last.
    pub(crate) corner: fn(u32) -> Option<ScreenCorner>,
    pub(crate) depth: AnyDepth,
}

/// What screen corners make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Three corners each, Gouraud.
    Triangles,
    /// Two corners each, one pixel wide.
    Lines,
    /// Two corners each, of so many copies of a line.
    Wide(u8),
    /// A strip through all corners, in a pattern and each of its bits for so many pixels.
    Stippled(u16, u8),
    /// Squares of so many pixels.
    Points(u16),
    /// Discs of so many pixels, by point coordinates.
    Round(u16),
}

/// The list.
pub(crate) fn scenes<P: Probe>() -> impl Iterator<Item = Scene<P>> {
    list::scenes()
}

/// Draws a picture; what it was like is measured.
fn draw<P: Probe>(stage: &mut Stage<'_>, probe: &mut P, picture: &Picture) -> Facts {
    let written = probe.measure(|| render::render(stage.color, stage.depth, picture));
    probe.pixels(written.pixels.into());
    let stride = picture.stride.max(picture.size.width.into());
    let bytes = if picture.format == PixelFormat::Rgba8888 { 4 } else { 2 };
    Facts {
        bytes: stride as usize * usize::from(picture.size.height) * bytes,
        triangles: written.triangles,
    }
}

/// One scene of a picture.
fn scene<P: Probe>(name: &'static str, draw: fn(&mut Stage<'_>, u32, &mut P) -> Facts) -> Scene<P> {
    Scene { name, group: Group::Golden, frames: 1, bunny: false, draw }
}
