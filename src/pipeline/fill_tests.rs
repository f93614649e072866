//! Few pixels, drawn one by one, against spans.

use crate::math::hard_numbers::Random;
use crate::raster::{BoundingBox, ScreenVertex};
use crate::shade::{Average, Dither4, Less, PolygonOffset, ReadOnly, Stats};
use crate::{Color, Cull, Flat, Frame, Rgb, Rgb565, ScreenPass, Size};
use fixed::types::I8F8;

/// What a pass draws and counts with spans by another way must be what it does without.
macro_rules! compare {
    ($triangles:expr, $depth_stride:expr, $pass:expr) => {{
        let draw = |spans: bool| {
            let (mut pixels, mut codes) = ([7_u16; 30], [20_000_u16; 40]);
            let mut stats = Stats::default();
            let frame = Frame::<Rgb565>::new(&mut pixels, Size::new(6, 5))
                .and_then(|frame| frame.with_depth_stride(&mut codes, $depth_stride));
            let mut frame = frame.expect("buffers are large enough");
            let pass = $pass;
            if spans {
                let mut pass = pass.traversal(BoundingBox).count(&mut stats);
                pass.triangles(&mut frame, &Flat::colored(), $triangles);
            } else {
                let mut pass = pass.count(&mut stats);
                pass.triangles(&mut frame, &Flat::colored(), $triangles);
            }
            (pixels, codes, stats)
        };
        let few = draw(false);
        assert_eq!(few, draw(true), "{:?}", $triangles);
        few.2
    }};
}

#[test]
fn few_pixels_are_those_of_spans() {
    let mut random = Random::new(77);
    let (mut drawn, mut pixels) = (0, 0);
    for round in 0..20_000 {
        // Beyond the frame too, and of one depth every other time.
        let beside = (round % 4) * 24 - 20;
        let mut corner = |_| {
            let (word, z) = (random.word(), random.word());
            let axis = |word: u32| (word & 63).cast_signed() + beside;
            let z = if round % 2 == 0 { 30_000 } else { (z >> 16) as u16 };
            let [.., red, green] = word.to_le_bytes();
            let color = Rgb::new(red, green, z.to_le_bytes()[0]).into();
            (ScreenVertex::from_bits(axis(word), axis(word >> 8), z), color)
        };
        let mut triangle = |()| [(), (), ()].map(&mut corner);
        let triangles: &[[(ScreenVertex, Color); 3]; 2] = &[(), ()].map(&mut triangle);
        let pass = ScreenPass::new;
        let stats = [
            compare!(triangles, 6, pass().depth(Less)),
            compare!(triangles, 8, pass().depth(Less)),
            compare!(triangles, 6, pass().depth(ReadOnly::new(Less)).blend(Average)),
            compare!(triangles, 6, pass().depth(PolygonOffset::new(Less, I8F8::ONE, 2))),
            compare!(triangles, 6, pass().dither(Dither4)),
            compare!(triangles, 6, pass().cull(Cull::Back).depth(Less)),
            compare!(triangles, 6, pass().cull(Cull::Front)),
        ];
        for stats in stats {
            (drawn, pixels) = (drawn + stats.drawn, pixels + stats.pixels);
        }
    }
    assert!(drawn > 20_000 && pixels > 20_000, "{drawn} {pixels}");
}
