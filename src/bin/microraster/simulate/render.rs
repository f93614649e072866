//! Drawing a view: the same code that firmware runs.

use super::options::{self, Shade};
use super::picture::Picture;
use super::view::View;
use microraster::host::MeshData;
use microraster::math::{Angle, Mat4, Vec3};
use microraster::raster::AnyTraversal;
use microraster::{
    AnyDepth, Camera, Cull, Flat, Format, Frame, FrameError, Gouraud, Lambert, Light, Pass, Rgb,
    Rgb565, Rgb565Be, Rgba8888, Size, Stats,
};

/// The nearest that anything is seen, in radii of the model; points come no nearer than 1/4.
const NEAR: f32 = 0.125;

/// Dark, and no model's own black.
const BACKGROUND: Rgb = Rgb::new(16, 24, 48);

/// Draws `view` of a model whose parts are `parts` into `picture`.
pub(crate) fn render(
    view: &View,
    parts: &[MeshData],
    picture: &mut Picture,
) -> Result<(), FrameError> {
    let mut stats = Stats::default();
    match picture.format {
        options::Format::Rgb565 => draw::<Rgb565>(view, parts, picture, &mut stats)?,
        options::Format::Rgb565be => draw::<Rgb565Be>(view, parts, picture, &mut stats)?,
        options::Format::Rgba8888 => draw::<Rgba8888>(view, parts, picture, &mut stats)?,
    }
    picture.drawn = stats.drawn.into();
    picture.clipped = stats.clipped.into();
    picture.pixels = stats.pixels.into();
    Ok(())
}

/// Draws into a buffer of one format and keeps its bytes.
#[allow(clippy::cast_possible_truncation, reason = "angles and lengths of a view suit an f32")]
fn draw<F: Format>(
    view: &View,
    parts: &[MeshData],
    picture: &mut Picture,
    stats: &mut Stats,
) -> Result<(), FrameError> {
    let size = picture.size;
    let mut pixels = vec![<F::Raw as bytemuck::Zeroable>::zeroed(); size.pixels()];
    let mut depth = vec![0; size.pixels()];
    let mut frame =
        Frame::<F>::new(&mut pixels, Size::new(size.width, size.height))?.with_depth(&mut depth)?;
    frame.clear(BACKGROUND);
    let camera = Camera::perspective(Angle::from_radians(2.0 * View::HALF_FIELD as f32), NEAR);
    let [x, y, z] = view.center.map(|middle| middle as f32);
    let [right, up] = view.shift.map(|shift| shift as f32);
    let model = Mat4::translation(Vec3::new(right, up, -view.distance as f32))
        * Mat4::rotation_x(Angle::from_radians(view.pitch as f32))
        * Mat4::rotation_y(Angle::from_radians(view.yaw as f32))
        * Mat4::scale(Vec3::splat(view.scale as f32))
        * Mat4::translation(-Vec3::new(x, y, z));
    let pass = || {
        Pass::new(&camera)
            .cull(match view.cull {
                options::Cull::None => Cull::None,
                options::Cull::Back => Cull::Back,
                options::Cull::Front => Cull::Front,
            })
            .traversal(match view.traversal {
                options::Traversal::Spans => AnyTraversal::Spans,
                options::Traversal::Box => AnyTraversal::Box,
                options::Traversal::Blocks => AnyTraversal::Blocks,
                options::Traversal::Walk => AnyTraversal::Walk,
            })
            .depth(if view.depth { AnyDepth::Less } else { AnyDepth::Off })
    };
    for part in parts {
        let lit = light(part.color);
        match view.shade {
            Shade::Flat => {
                pass().count(stats).draw(&mut frame, &model, &part.mesh(), &Flat::new(lit));
            }
            Shade::Gouraud => {
                pass().count(stats).draw(&mut frame, &model, &part.mesh(), &Gouraud::new(lit));
            }
        }
    }
    picture.bytes = bytemuck::cast_slice(&pixels).to_vec();
    Ok(())
}

/// Light from the upper right behind the camera, and a fifth of it from everywhere.
fn light(material: Rgb) -> Lambert<1> {
    let sun = Light::directional(Vec3::new(-0.4, -0.4, -0.8), Rgb::new(204, 204, 204));
    Lambert::new(&[sun]).ambient(Rgb::new(51, 51, 51)).material(material)
}
