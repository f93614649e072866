//! Small pictures that are kept and compared exactly.
//!
//! A picture is data: what is drawn in which state, in which memory. [`render`] draws it with the
//! crate; the tests draw the same data with a renderer that shares nothing with the crate.

pub(crate) mod corners;
mod list;
pub(crate) mod render;
pub(crate) mod shapes;

use fixed::types::I8F8;
use microraster::math::Mat4;
use microraster::{
    AnyBlend, AnyCompare, AnyDepth, AnyDither, AnyOperation, Camera, Cull, Rect, Rgb, Size,
    Supersampling, Winding,
};

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
    /// Samples that are drawn of each pixel, if not one.
    pub(crate) samples: Option<Supersampling>,
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
    /// Where it is not as types say.
    pub(crate) fragments: Option<FragmentState>,
}

/// What becomes of fragments, chosen when the program runs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FragmentState {
    pub(crate) blend: AnyBlend,
    pub(crate) dither: AnyDither,
    /// Slope and units.
    pub(crate) offset: (I8F8, i16),
    /// Farthest and nearest code.
    pub(crate) range: (u16, u16),
    /// Comparison, reference, and what is left where it is passed.
    pub(crate) stencil: (AnyCompare, u8, AnyOperation),
}

impl FragmentState {
    /// All are drawn, as they are.
    pub(crate) const PLAIN: Self = Self {
        blend: AnyBlend::Replace,
        dither: AnyDither::Undithered,
        offset: (I8F8::ZERO, 0),
        range: (0, u16::MAX),
        stencil: (AnyCompare::Always, 0, AnyOperation::Keep),
    };
}

/// How a mesh is coloured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shade {
    Flat,
    Gouraud,
    /// One colour.
    Solid(Rgb),
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
    /// Where it is not as types say.
    pub(crate) fragments: Option<FragmentState>,
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
    probe.skipped(written.skipped);
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
