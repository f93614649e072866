//! What is drawn and where to, hidden from the compiler.

use crate::buffer::Buffer;
use core::hint::black_box;
use microraster::math::{Angle, Mat4, Vec3};
use microraster::texture::{Texture, TextureError};
use microraster::{Camera, DepthBuffer, Format, Frame, Mesh, Normal, Rgb, Size, StencilBuffer};

const PIXELS: usize = 64 * 64;

static COLOR: Buffer<[u32; PIXELS]> = Buffer::new([0; PIXELS]);
static DEPTH: Buffer<[u16; PIXELS]> = Buffer::new([0; PIXELS]);
static STENCIL: Buffer<[u8; PIXELS]> = Buffer::new([0; PIXELS]);

static CORNERS: [[i16; 3]; 6] =
    [[-1, -1, 0], [1, -1, 0], [0, 1, 0], [-1, 1, 1], [1, 1, 1], [0, -1, 1]];
static COLORS: [Rgb; 6] = [Rgb::RED, Rgb::GREEN, Rgb::BLUE, Rgb::WHITE, Rgb::RED, Rgb::BLUE];
static NORMALS: [Normal; 6] = [[0, 0, 127]; 6];
static PLACES: [[i16; 2]; 6] = [[0, 0], [4096, 0], [0, 4096], [99, 99], [30_000, 5], [-30_000, -5]];
static TEXELS: [u32; 128] = [0x1234_5678; 128];

/// The value, of which the compiler knows nothing.
pub(crate) fn hidden<T>(value: T) -> T {
    black_box(value)
}

/// What all frames of the scene share.
pub(crate) struct Buffers {
    /// Room for 64 x 64 pixels of any format.
    pub(crate) color: &'static mut [u32],
    /// As many depths.
    pub(crate) depth: &'static mut [u16],
    /// As many stencil values.
    pub(crate) stencil: &'static mut [u8],
}

impl Buffers {
    /// All of them, once.
    pub(crate) fn take() -> Option<Self> {
        Some(Self {
            color: hidden(COLOR.take()?),
            depth: hidden(DEPTH.take()?),
            stencil: hidden(STENCIL.take()?),
        })
    }

    /// A frame with depth and stencil: a band of a higher picture, with a scissor.
    pub(crate) fn frame<F: Format>(
        &mut self,
    ) -> Option<Frame<'_, F, StencilBuffer<'_, DepthBuffer<'_>>>> {
        let (size, stride) = (hidden(Size::new(40, 40)), hidden(50));
        let pixels = bytemuck::try_cast_slice_mut(self.color).ok()?;
        let frame = Frame::<F>::with_stride(pixels, size, stride).ok()?;
        let frame = frame.with_depth_stride(self.depth, stride).ok()?;
        let frame = frame.with_stencil_stride(self.stencil, stride).ok()?;
        let mut frame = frame.band(hidden(20), hidden(90)).ok()?;
        frame.clear(hidden(Rgb::BLACK));
        frame.clear_color(hidden(Rgb::BLACK));
        frame.clear_depth(hidden(7));
        frame.clear_stencil(hidden(3));
        frame.set_scissor(hidden(microraster::Rect::new(-3, 5, 30, 700)));
        hidden((frame.scissor(), frame.size(), frame.picture(), frame.first_row()));
        Some(frame)
    }

    /// A frame with depth.
    pub(crate) fn deep<F: Format>(&mut self) -> Option<Frame<'_, F, DepthBuffer<'_>>> {
        let pixels = bytemuck::try_cast_slice_mut(self.color).ok()?;
        let frame = Frame::<F>::new(pixels, hidden(Size::new(64, 64))).ok()?;
        let mut frame = frame.with_depth(self.depth).ok()?;
        frame.clear(hidden(Rgb::BLACK));
        frame.clear_depth(hidden(7));
        Some(frame)
    }

    /// A frame of colour alone.
    pub(crate) fn plain<F: Format>(&mut self) -> Option<Frame<'_, F>> {
        let pixels = bytemuck::try_cast_slice_mut(self.color).ok()?;
        let mut frame = Frame::<F>::new(pixels, hidden(Size::new(64, 64))).ok()?;
        frame.clear(hidden(Rgb::BLACK));
        frame.set_scissor(hidden(microraster::Rect::new(-3, 5, 30, 700)));
        frame.reset_scissor();
        Some(frame)
    }
}

/// A camera in perspective, cut at a far plane.
pub(crate) fn camera() -> Camera {
    Camera::perspective(Angle::from_degrees(hidden(45.0)), hidden(0.5)).far(hidden(50.0)).look_at(
        hidden(Vec3::Z),
        hidden(Vec3::ZERO),
        hidden(Vec3::Y),
    )
}

/// Where the mesh is.
pub(crate) fn model() -> Mat4 {
    Mat4::translation(hidden(Vec3::new(0.0, 0.0, -3.0)))
        * Mat4::rotation_y(Angle::from_degrees(hidden(20.0)))
        * Mat4::scale(hidden(Vec3::ONE))
}

fn placed<A>(attributes: &'static [A]) -> Mesh<'static, A> {
    Mesh::new(hidden(&CORNERS[..]), hidden(attributes))
        .placed(hidden(Vec3::ONE), hidden(Vec3::ZERO))
}

/// A mesh of nothing but corners.
pub(crate) fn bare() -> Mesh<'static, ()> {
    placed(&[(); 6])
}

/// A mesh with colours.
pub(crate) fn colored() -> Mesh<'static, Rgb> {
    placed(&COLORS)
}

/// A mesh with normals.
pub(crate) fn lit() -> Mesh<'static, Normal> {
    placed(&NORMALS)
}

/// A mesh with normals and places in a texture.
pub(crate) fn lit_and_placed() -> Mesh<'static, (Normal, [i16; 2])> {
    static BOTH: [(Normal, [i16; 2]); 6] = {
        let mut both = [([0, 0, 127], [0, 0]); 6];
        let mut at = 0;
        while at < both.len() {
            both[at].1 = PLACES[at];
            at += 1;
        }
        both
    };
    placed(&BOTH)
}

/// A mesh with places in a texture.
pub(crate) fn on_texture() -> Mesh<'static, ((), [i16; 2])> {
    static BOTH: [((), [i16; 2]); 6] = {
        let mut both = [((), [0, 0]); 6];
        let mut at = 0;
        while at < both.len() {
            both[at].1 = PLACES[at];
            at += 1;
        }
        both
    };
    placed(&BOTH)
}

/// Texels as words of a format.
pub(crate) fn words<W: bytemuck::Pod>() -> Option<&'static [W]> {
    bytemuck::try_cast_slice(hidden(&TEXELS[..])).ok()
}

/// A texture of 8 x 8 texels.
pub(crate) fn texture() -> Option<Texture<'static>> {
    let texture: Result<_, TextureError> = Texture::new(words()?, hidden(8), hidden(8));
    texture.ok()
}
