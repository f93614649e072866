//! A user's shader, and the same picture by a loop written by hand: what the abstraction costs.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "columns and rows of the picture; codes are the upper half of a plane"
)]

#[path = "../shader/toon.rs"]
pub(crate) mod shader;

use microraster::math::Vec3;
use microraster::raster::{
    Gradients, Scanline, ScreenVertex, SpanBatch, SpanWalk, Spans, Traversal, Triangle,
};
use microraster::{Color, Frame, Less, Rect, Rgb, Rgb565, Scalar, ScreenPass, Shader, Size};

use super::{Facts, Group, Probe, Scene, Stage, ROOM};
use shader::{PackedToon, Toon};

const SIZE: Size = Size::new(320, 240);

/// The list.
pub(crate) fn scenes<P: Probe>() -> [Scene<P>; 4] {
    let scene = |name, draw| Scene { name, group: Group::Standard, frames: 1, bunny: false, draw };
    [
        scene("toon", toon::<P>),
        scene("toon-by-hand", toon_by_hand::<P>),
        scene("toon-packed", toon_packed::<P>),
        scene("toon-packed-by-hand", toon_packed_by_hand::<P>),
    ]
}

const TONES: [Color; 4] = [
    Color::new(60, 20, 80),
    Color::new(150, 40, 90),
    Color::new(235, 95, 85),
    Color::new(255, 190, 120),
];

const SHADER: Toon = Toon { tones: TONES, to_light: Vec3::Z };

/// Two triangles over the whole screen, each corner with its brightness.
fn triangles() -> [[(ScreenVertex, u16); 3]; 2] {
    let corner =
        |x: i32, y: i32, z, brightness| (ScreenVertex::from_bits(x * 16, y * 16, z), brightness);
    let (a, b) = (corner(0, 0, 100, 0), corner(320, 0, 9_000, 30_000));
    let (c, d) = (corner(320, 240, 60_000, 65_535), corner(0, 240, 30_000, 50_000));
    [[a, b, c], [a, c, d]]
}

fn facts() -> Facts {
    Facts { bytes: 2 * ROOM, triangles: 2 }
}

fn toon<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    by_shader(stage, probe, &SHADER)
}

fn toon_packed<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    by_shader(stage, probe, &PackedToon(SHADER))
}

fn toon_by_hand<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    by_hand(stage, probe, &TONES, Rgb565::encode)
}

fn toon_packed_by_hand<P: Probe>(stage: &mut Stage<'_>, _frame: u32, probe: &mut P) -> Facts {
    by_hand(stage, probe, &TONES.map(Rgb565::encode), |tone| tone)
}

fn by_shader<P, H>(stage: &mut Stage<'_>, probe: &mut P, shader: &H) -> Facts
where
    P: Probe,
    H: Shader<Varying = Scalar>,
{
    let color = bytemuck::cast_slice_mut(stage.color);
    let frame = Frame::<Rgb565>::new(color, SIZE).and_then(|frame| frame.with_depth(stage.depth));
    if let Ok(mut frame) = frame {
        frame.clear(Rgb::BLACK);
        let triangles = triangles();
        probe.measure(|| {
            ScreenPass::new().depth(Less).triangles(&mut frame, shader, &triangles);
        });
        probe.pixels(ROOM as u64);
    }
    facts()
}

/// The same by slices and planes, as one would write it for this one picture.
fn by_hand<P: Probe, T: Copy>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    tones: &[T; 4],
    pack: impl Fn(T) -> u16,
) -> Facts {
    let color: &mut [u16] = bytemuck::cast_slice_mut(stage.color);
    if let (Some(color), Some(depth)) = (color.get_mut(..ROOM), stage.depth.get_mut(..ROOM)) {
        color.fill(0);
        depth.fill(0);
        let triangles = triangles();
        probe.measure(|| {
            for triangle in &triangles {
                fill(color, depth, triangle, tones, &pack);
            }
        });
        probe.pixels(ROOM as u64);
    }
    facts()
}

#[inline(never)]
fn fill<T: Copy>(
    color: &mut [u16],
    depth: &mut [u16],
    corners: &[(ScreenVertex, u16); 3],
    tones: &[T; 4],
    pack: &impl Fn(T) -> u16,
) {
    let [a, b, c] = corners;
    let Some(triangle) = Triangle::new([a.0, b.0, c.0], SIZE) else { return };
    let gradients = Gradients::new(&triangle);
    let mut z_plane = gradients.plane(a.0.z, b.0.z, c.0.z);
    let mut tone_plane = gradients.plane(a.1, b.1, c.1);
    for plane in [&mut z_plane, &mut tone_plane] {
        plane.origin = plane.origin.wrapping_add(0x8000);
    }
    let (mut walk, mut batch) = (Spans::default(), SpanBatch::default());
    Scanline.start(&mut walk, &triangle, &Rect::from_size(SIZE), &mut batch);
    loop {
        for span in batch.spans() {
            let (from, to) =
                ((span.y * 320 + span.left) as usize, (span.y * 320 + span.right) as usize);
            let mut z = z_plane.at(span.left, span.y);
            let mut tone = tone_plane.at(span.left, span.y);
            let Some((pixels, cells)) = color.get_mut(from..to).zip(depth.get_mut(from..to)) else {
                return;
            };
            for (pixel, cell) in pixels.iter_mut().zip(cells) {
                let code = (z >> 16) as u16;
                if code > *cell {
                    *cell = code;
                    *pixel = pack(tones[(tone >> 30) as usize]);
                }
                z = z.wrapping_add(z_plane.dx);
                tone = tone.wrapping_add(tone_plane.dx);
                // Unrolled by the compiler, this loop spills, as the crate's own does.
                core::hint::black_box(());
            }
        }
        if batch.is_last() {
            return;
        }
        walk.next_spans(&mut batch);
    }
}
