//! A picture with several samples a pixel, a few rows at a time.

use microraster::{
    DepthBuffer, Frame, Rect, Rgb, Rgb565, Rgba8888, Size, Supersampling, Undithered,
};

use crate::scenes::standard::SIZE;
use crate::scenes::{Probe, Stage, ROOM};

/// Samples, in an RGBA frame with depth.
pub(crate) type Fine<'a> = Frame<'a, Rgba8888, DepthBuffer<'a>>;

/// Draws with `FACTOR` x `FACTOR` samples a pixel, 2 or 4: `draw` is called for each band of
/// samples. Clearing the samples is measured as well: a plain frame is cleared once, this one for
/// every band.
pub(crate) fn draw<P: Probe, const FACTOR: u16>(
    stage: &mut Stage<'_>,
    probe: &mut P,
    mut draw: impl FnMut(&mut Fine<'_>, &mut P),
) {
    let supersampling = if FACTOR == 2 { Supersampling::Two } else { Supersampling::Four };
    let (pixels, samples) = stage.color.split_at_mut(ROOM / 2);
    let Ok(mut frame) = Frame::<Rgb565>::new(bytemuck::cast_slice_mut(pixels), SIZE) else {
        return;
    };
    let (width, height) = (SIZE.width * FACTOR, SIZE.height * FACTOR);
    // As many rows of pixels as the other half of the words has samples for: 640 x 60, 1280 x 24.
    let rows = if FACTOR == 2 { 30 } else { 6 };
    for first in (0..SIZE.height).step_by(rows.into()) {
        let size = Size::new(width, rows * FACTOR);
        let fine = Frame::<Rgba8888>::new(samples, size)
            .and_then(|fine| fine.with_depth(stage.depth))
            .and_then(|fine| fine.band(first * FACTOR, height));
        let Ok(mut fine) = fine else { return };
        probe.measure(|| fine.clear(Rgb::BLACK));
        draw(&mut fine, probe);
        let cut = Rect::new(0, first.into(), SIZE.width.into(), (first + rows).into());
        frame.set_scissor(cut);
        probe.measure(|| supersampling.resolve(&fine, &mut frame, &Undithered));
    }
}
