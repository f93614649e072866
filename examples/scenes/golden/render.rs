//! Draws a picture with the crate.

use core::ops::AddAssign;

use bytemuck::Pod;
use microraster::math::Vec3;
use microraster::raster::ScreenVertex;
use microraster::{
    AnyDepth, AnyDepthState, AnyOperation, AnyStencil, Color, DepthBuffer, DrawContext, Flat,
    Format, Frame, FrameError, Gouraud, Lambert, Light, Pass, PointCoordinates, Rgb, Rgb565,
    Rgb565Be, Rgba8888, ScreenPass, Shader, Size, SmoothColor, Stats, Stencil, StencilBuffer,
    Stenciled, Stippled, Supersampling, Thin, Undithered, VertexInput, Wide,
};

use super::super::toon::shader::Toon;
use super::shapes::Attributes;
use super::{
    Draw, FragmentState, Kind, MeshDraw, Picture, PixelFormat, ScreenCorner, ScreenDraw, Shade,
};

/// Where light comes from, what it is like and what it falls on.
pub(crate) const SUN: Vec3 = Vec3::new(-0.3, -0.6, -1.0);
pub(crate) const SUN_COLOR: Rgb = Rgb::new(204, 204, 204);
pub(crate) const AMBIENT: Rgb = Rgb::new(51, 51, 51);
pub(crate) const MATERIAL: Rgb = Rgb::new(230, 190, 140);

/// The tones of [`Shade::Toon`], from dark to bright.
pub(crate) const TONES: [Rgb; 4] =
    [Rgb::new(60, 20, 80), Rgb::new(150, 40, 90), Rgb::new(235, 95, 85), Rgb::new(255, 190, 120)];
/// Towards the light of [`Shade::Toon`].
pub(crate) const TOWARDS_LIGHT: Vec3 = Vec3::new(0.9, 1.0, 0.5);

/// What was drawn.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Written {
    pub(crate) pixels: u32,
    pub(crate) triangles: u32,
    pub(crate) skipped: u32,
}

impl AddAssign for Written {
    fn add_assign(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.triangles += other.triangles;
        self.skipped += other.skipped;
    }
}

impl AddAssign<Stats> for Written {
    fn add_assign(&mut self, stats: Stats) {
        self.pixels += stats.pixels;
        self.triangles += stats.triangles + stats.lines + stats.points;
        self.skipped += stats.skipped;
    }
}

/// Draws it, band by band where it says so.
pub(crate) fn render(color: &mut [u32], depth: &mut [u16], picture: &Picture) -> Written {
    match picture.format {
        PixelFormat::Rgb565 => bands::<Rgb565>(color, depth, picture),
        PixelFormat::Rgb565Be => bands::<Rgb565Be>(color, depth, picture),
        PixelFormat::Rgba8888 => bands::<Rgba8888>(color, depth, picture),
    }
    .unwrap_or_default()
}

fn bands<F: Format>(
    color: &mut [u32],
    depth: &mut [u16],
    picture: &Picture,
) -> Result<Written, FrameError>
where
    F::Raw: Pod,
{
    let Size { width, height, .. } = picture.size;
    let stride = picture.stride.max(width.into());
    let rows = if picture.band == 0 { height } else { picture.band };
    if let Some(samples) = picture.samples {
        return sampled::<F>(color, depth, picture, samples);
    }
    let mut pixels: &mut [F::Raw] = bytemuck::cast_slice_mut(color);
    // What no depth of a small picture needs.
    let (depth, stencil) = depth.split_at_mut(depth.len() / 2);
    let stencil: &mut [u8] = bytemuck::cast_slice_mut(stencil);
    let (mut first, mut written) = (0, Written::default());
    while first < height {
        let rows = rows.min(height - first);
        let length = (stride as usize * usize::from(rows)).min(pixels.len());
        let (band, rest) = core::mem::take(&mut pixels).split_at_mut(length);
        pixels = rest;
        let size = Size::new(width, rows);
        // The depth of a band is forgotten when the next one begins.
        let mut frame = Frame::<F>::with_stride(band, size, stride)?
            .with_depth(depth)?
            .with_stencil(stencil)?
            .band(first, height)?;
        written += draw_all(&mut frame, picture);
        first += rows;
    }
    Ok(written)
}

/// A frame with all that pictures ask for.
type FullFrame<'a, F> = Frame<'a, F, StencilBuffer<'a, DepthBuffer<'a>>>;

fn draw_all<F: Format>(frame: &mut FullFrame<'_, F>, picture: &Picture) -> Written {
    let mut written = Written::default();
    frame.clear(picture.background);
    for draw in picture.draws {
        match draw {
            Draw::Mesh(draw) => written += mesh(frame, draw),
            Draw::Screen(draw) => written += screen(frame, draw),
        }
    }
    written
}

/// The mean of several samples a pixel, four rows of pixels at a time.
fn sampled<F: Format>(
    color: &mut [u32],
    depth: &mut [u16],
    picture: &Picture,
    samples: Supersampling,
) -> Result<Written, FrameError>
where
    F::Raw: Pod,
{
    const ROWS: u16 = 4;
    let Size { width, height, .. } = picture.size;
    let factor = samples.factor();
    let (pixels, fine) = color.split_at_mut(color.len() / 2);
    let pixels: &mut [F::Raw] = bytemuck::cast_slice_mut(pixels);
    let (depth, stencil) = depth.split_at_mut(depth.len() / 2);
    let stencil: &mut [u8] = bytemuck::cast_slice_mut(stencil);
    let mut frame = Frame::<F>::new(pixels, picture.size)?;
    let (mut first, mut written) = (0, Written::default());
    while first < height {
        let rows = ROWS.min(height - first);
        let size = Size::new(width * factor, rows * factor);
        let mut fine = Frame::<Rgba8888>::new(fine, size)?
            .with_depth(depth)?
            .with_stencil(stencil)?
            .band(first * factor, height * factor)?;
        written += draw_all(&mut fine, picture);
        samples.resolve(&fine, &mut frame, &Undithered);
        first += rows;
    }
    Ok(written)
}

fn mesh<F: Format>(frame: &mut FullFrame<'_, F>, draw: &MeshDraw) -> Stats {
    let sun = Light::directional(SUN, SUN_COLOR);
    let light = || Lambert::new(&[sun]).ambient(AMBIENT).material(MATERIAL);
    let toon = || Toon { tones: TONES.map(Color::from), to_light: TOWARDS_LIGHT };
    match (draw.shape.arrays().attributes, draw.shade) {
        (Attributes::Normals(normals), Shade::Solid(color)) => {
            through(frame, draw, normals, false, &Flat::solid(color))
        }
        (Attributes::Normals(normals), Shade::Flat) => {
            through(frame, draw, normals, false, &Flat::new(light()))
        }
        (Attributes::Normals(normals), Shade::Gouraud) => {
            through(frame, draw, normals, false, &Gouraud::new(light()))
        }
        (Attributes::Normals(normals), Shade::Toon) => {
            through(frame, draw, normals, false, &toon())
        }
        (Attributes::Colors(colors), Shade::Flat) => {
            through(frame, draw, colors, false, &Flat::colored())
        }
        (Attributes::Colors(colors), _) => through(frame, draw, colors, false, &Gouraud::colored()),
        (Attributes::FaceColors(colors), _) => through(frame, draw, colors, true, &Flat::colored()),
    }
}

fn through<F: Format, A, H: Shader<Vertex = A>>(
    frame: &mut FullFrame<'_, F>,
    draw: &MeshDraw,
    attributes: &'static [A],
    by_face: bool,
    shader: &H,
) -> Stats {
    let mesh = draw.shape.arrays().mesh(attributes);
    let mesh = if by_face { mesh.by_face() } else { mesh };
    let camera = (draw.camera)();
    let mut pass = Pass::new(&camera).cull(draw.cull).front_face(draw.front);
    if let Some(viewport) = draw.viewport {
        pass = pass.viewport(viewport);
    }
    if let Some(scissor) = draw.scissor {
        frame.set_scissor(scissor);
    }
    let mut stats = Stats::default();
    let model = &(draw.model)();
    match draw.fragments {
        None => pass.depth(draw.depth).count(&mut stats).draw(frame, model, &mesh, shader),
        Some(fragments) => {
            pass.depth(depth_of(draw.depth, &fragments))
                .blend(fragments.blend)
                .dither(fragments.dither)
                .count(&mut stats)
                .draw(frame, model, &mesh, shader);
        }
    }
    frame.reset_scissor();
    stats
}

/// The tests of a draw that are chosen when the program runs.
fn depth_of(test: AnyDepth, fragments: &FragmentState) -> Stenciled<AnyDepthState, AnyStencil> {
    let FragmentState { offset, range, stencil: (compare, reference, on_pass), .. } = *fragments;
    let keep = AnyOperation::Keep;
    let stencil = Stencil::new(compare, reference);
    let stencil = stencil.on_fail(keep).on_depth_fail(keep).on_pass(on_pass);
    Stenciled::new(AnyDepthState { offset, range, ..AnyDepthState::new(test) }, stencil)
}

/// Corners of a strip at most.
const STRIP: usize = 64;

/// Colours in a disc that fills the point's square.
struct Round;

impl Shader for Round {
    type Vertex = ();
    type Varying = (SmoothColor, PointCoordinates);
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> (Color, ()) {
        (Color::new(0, 0, 0), ())
    }

    fn fragment(&self, _: &Self::Prepared, (color, at): &Self::Varying) -> Option<Color> {
        (at.radius_squared() < 1 << 26).then(|| color.color())
    }
}

fn screen<F: Format>(frame: &mut FullFrame<'_, F>, draw: &ScreenDraw) -> Stats {
    let shaded = |(x, y, z, color): ScreenCorner| (ScreenVertex::from_bits(x, y, z), color.into());
    let corner = |i: u32| (draw.corner)(i).map(shaded);
    let mut stats = Stats::default();
    let shader = Gouraud::colored();
    let mut i = 0;
    if let Some(fragments) = draw.fragments {
        let pass = ScreenPass::new().depth(depth_of(draw.depth, &fragments));
        let mut pass = pass.blend(fragments.blend).dither(fragments.dither).count(&mut stats);
        while let (Some(a), Some(b), Some(c)) = (corner(i), corner(i + 1), corner(i + 2)) {
            pass.triangle(frame, &shader, &[a, b, c]);
            i += 3;
        }
        return stats;
    }
    let mut pass = ScreenPass::new().depth(draw.depth).count(&mut stats);
    while let Some(a) = corner(i) {
        let a: (ScreenVertex, Color) = a;
        match (draw.kind, corner(i + 1), corner(i + 2)) {
            (Kind::Points(size), ..) => {
                pass.points(frame, &shader, size, &[a]);
                i += 1;
            }
            (Kind::Round(size), ..) => {
                let (vertex, color) = a;
                pass.points(frame, &Round, size, &[(vertex, (color, ()))]);
                i += 1;
            }
            (Kind::Wide(width), Some(b), _) => {
                pass.lines(frame, &shader, Wide(width), &[[a, b]]);
                i += 2;
            }
            (Kind::Stippled(pattern, factor), ..) => {
                let mut corners = [a; STRIP];
                let mut count = 0;
                for (place, at) in corners.iter_mut().zip(0..) {
                    let Some(corner) = corner(at) else { break };
                    (*place, count) = (corner, count + 1);
                }
                let style = Stippled::new(pattern, factor, Thin);
                pass.line_strip(frame, &shader, style, corners.iter().take(count));
                break;
            }
            (Kind::Lines, Some(b), _) => {
                pass.lines(frame, &shader, Thin, &[[a, b]]);
                i += 2;
            }
            (Kind::Triangles, Some(b), Some(c)) => {
                pass.triangle(frame, &shader, &[a, b, c]);
                i += 3;
            }
            _ => break,
        }
    }
    stats
}
