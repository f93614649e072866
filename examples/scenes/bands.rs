//! The lit bunny in bands: drawn again for each, and recorded once. Sums over all bands, clears
//! excluded, recording included.
//!
//! Four turns of 90 degrees, since bands take long; one band redrawn is what a frame costs.

use microraster::math::{Angle, Mat4, Vec3};
use microraster::{
    Camera, Color, Cull, DepthBuffer, DisplayList, Frame, FrameError, Gouraud, Less, ListTriangle,
    ListVertex, Pass, Rgb, Rgb565, Size, Stats, VertexCache,
};

use super::standard::{bunny, camera, facts, light, LitWithPlanes, SIZE};
use super::{Facts, Group, Probe, Scene, Stage, CACHED};

/// Vertices and triangles for which there is room: more than half of the bunny.
const ROOM: usize = 2400;
/// Most bands.
const BANDS: usize = 60;

/// Memory of a recorded mesh.
#[derive(Debug)]
pub(crate) struct ListRoom {
    vertices: [ListVertex<Color>; ROOM],
    triangles: [ListTriangle; ROOM],
    bands: [u16; BANDS],
    cache: VertexCache<u16, CACHED>,
}

impl ListRoom {
    /// Nothing recorded yet.
    pub(crate) const NEW: Self = Self {
        vertices: [ListVertex::with_blank(Color::new(0, 0, 0)); ROOM],
        triangles: [ListTriangle::BLANK; ROOM],
        bands: [0; BANDS],
        cache: VertexCache::with_blank(0),
    };
}

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 14] {
    /// A number of bands, both ways.
    macro_rules! both {
        ($($count:literal),*) => {
            [$(
                scene(concat!("M1-bunny-redrawn-", $count), |stage, frame, probe| {
                    draw::<P>(stage, frame, probe, $count, false)
                }),
                scene(concat!("M1-bunny-recorded-", $count), |stage, frame, probe| {
                    draw::<P>(stage, frame, probe, $count, true)
                }),
            )*]
        };
    }
    fn scene<P>(
        name: &'static str,
        draw: fn(&mut Stage<'_>, frame: u32, probe: &mut P) -> Facts,
    ) -> Scene<P> {
        Scene { name, group: Group::Bands, frames: 4, bunny: true, draw }
    }
    both!(1, 2, 4, 8, 16, 30, 60)
}

/// Draws the bunny in so many bands.
fn draw<P: Probe>(
    stage: &mut Stage<'_>,
    turn: u32,
    probe: &mut P,
    bands: u16,
    recorded: bool,
) -> Facts {
    let mesh = bunny(stage);
    let picture = Picture { mesh, turn, rows: SIZE.height.div_ceil(bands), recorded };
    // Buffers are of the picture's size.
    let _ = picture.draw(stage, probe);
    facts(mesh.triangles())
}

/// A picture in bands.
#[derive(Clone, Copy)]
struct Picture<'a> {
    mesh: LitWithPlanes<'a>,
    turn: u32,
    rows: u16,
    recorded: bool,
}

impl Picture<'_> {
    fn draw<P: Probe>(&self, stage: &mut Stage<'_>, probe: &mut P) -> Result<(), FrameError> {
        let Self { mesh, turn, rows, recorded } = *self;
        let camera: Camera = camera();
        let angle = Angle::from_degrees(90.0 * turn as f32);
        let model = Mat4::translation(Vec3::new(0.0, 0.0, -3.0178)) * Mat4::rotation_y(angle);
        let shader = Gouraud::new(light());
        let pass = Pass::new(&camera).depth(Less).cull(Cull::Back);
        let Stage { color, depth, cache, list, .. } = stage;
        let ListRoom { vertices, triangles, bands, cache: places } = &mut **list;
        let mut recording = None;
        if recorded {
            let list = DisplayList::new(vertices, triangles, bands);
            let mut pass = pass;
            recording =
                Some(probe.measure(|| pass.record(list, SIZE, &model, &mesh, &shader, places)));
        }
        let width = usize::from(SIZE.width);
        // Each band lies where the picture has it, so that sending it costs nothing here.
        let pixels: &mut [u16] = bytemuck::cast_slice_mut(color);
        let whole = pixels.get_mut(..width * usize::from(SIZE.height)).unwrap_or_default();
        let mut written = 0;
        for (first, pixels) in
            (0..).step_by(rows.into()).zip(whole.chunks_mut(width * usize::from(rows)))
        {
            let size = Size::new(SIZE.width, rows.min(SIZE.height - first));
            let frame = Frame::<Rgb565>::new(pixels, size)?.with_depth(depth)?;
            let mut frame: Frame<'_, Rgb565, DepthBuffer<'_>> = frame.band(first, SIZE.height)?;
            frame.clear(Rgb::BLACK);
            if P::COUNTING {
                let mut stats = Stats::default();
                pass.count(&mut stats).draw_cached(&mut frame, &model, &mesh, &shader, cache);
                written += u64::from(stats.pixels);
                continue;
            }
            let mut pass = pass;
            match &mut recording {
                // What could not be drawn would differ from the host's picture.
                Some(recording) => {
                    let _ = probe.measure(|| pass.replay(&mut frame, recording));
                }
                None => probe.measure(|| {
                    pass.draw_cached(&mut frame, &model, &mesh, &shader, cache);
                }),
            }
        }
        probe.pixels(written);
        Ok(())
    }
}
