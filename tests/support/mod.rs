//! What several tests share: random numbers, the brute-force rasterizer.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]
#![allow(dead_code, reason = "each test takes what it needs")]

use microraster::raster::{
    Scanline, ScreenVertex, SpanBatch, SpanWalk, Spans, Traversal, Triangle, GUARD,
};
use microraster::{Clip, Color, DrawContext, FlatColor, Rect, Rgb, Shader, Size, VertexInput};

/// A small generator (SplitMix64): the same numbers on every machine.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in `from..=to`.
    pub(crate) fn range(&mut self, from: i32, to: i32) -> i32 {
        let span = (i64::from(to) - i64::from(from) + 1) as u64;
        (i64::from(from) + (self.next() % span) as i64) as i32
    }

    /// A number in 0..1.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// A corner of some size class, 0 to 9: in the picture, on the grid, tiny, far outside, mixed.
pub(crate) fn any_corner(random: &mut Random, class: i32, picture: Size) -> ScreenVertex {
    let class = if class == 9 { random.range(0, 8) } else { class };
    let (w, h) = (i32::from(picture.width) * 16, i32::from(picture.height) * 16);
    let side = GUARD * 16;
    let (x, y) = match class {
        // In the picture, on subpixels, on pixel corners, on centres, on halves.
        0 => (random.range(0, w), random.range(0, h)),
        1 => (random.range(0, w / 16) * 16, random.range(0, h / 16) * 16),
        2 => (random.range(0, w / 16) * 16 + 8, random.range(0, h / 16) * 16 + 8),
        3 => (random.range(0, w / 8) * 8, random.range(0, h / 8) * 8),
        // A few subpixels.
        4 => (random.range(150, 190), random.range(150, 190)),
        // Far outside, and at the very ends.
        5 => (random.range(-side + w / 2, side + w / 2), random.range(-side + h / 2, side + h / 2)),
        6 => (random.range(-2000, 3000), random.range(-2000, 3000)),
        // Sixteen pixels high at most.
        7 => (random.range(-300, 600), random.range(100, 356)),
        _ => (
            w / 2 + [-side, side, 0, -8, 8][random.range(0, 4) as usize],
            h / 2 + [-side, side, 0, -8, 8][random.range(0, 4) as usize],
        ),
    };
    ScreenVertex::from_bits(x, y, 0)
}

/// The definition of coverage, word for word: E >= bias on all three edges at the pixel's centre.
pub(crate) fn covers(v: &[ScreenVertex; 3], x: i32, y: i32) -> bool {
    let p = v.map(|v| (i64::from(v.x.to_bits()), i64::from(v.y.to_bits())));
    let area = (p[1].0 - p[0].0) * (p[2].1 - p[0].1) - (p[2].0 - p[0].0) * (p[1].1 - p[0].1);
    if area == 0 {
        return false;
    }
    let order = if area > 0 { [0, 1, 2] } else { [0, 2, 1] };
    let (px, py) = (i64::from(x) * 16 + 8, i64::from(y) * 16 + 8);
    (0..3).all(|i| {
        let (a, b) = (p[order[i]], p[order[(i + 1) % 3]]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let edge = dx * (py - a.1) - dy * (px - a.0);
        let top = dy == 0 && dx > 0;
        let left = dy < 0;
        edge >= i64::from(!(top || left))
    })
}

/// The same for an area of at most 32 columns, a word a row, the leftmost pixel in the lowest bit:
/// all three edges at all centres, none left out.
pub(crate) fn covered(v: &[ScreenVertex; 3], area: Rect) -> Vec<u32> {
    let p = v.map(|v| (i64::from(v.x.to_bits()), i64::from(v.y.to_bits())));
    let area_of = (p[1].0 - p[0].0) * (p[2].1 - p[0].1) - (p[2].0 - p[0].0) * (p[1].1 - p[0].1);
    let order = if area_of < 0 { [0, 2, 1] } else { [0, 1, 2] };
    // E - bias at the centre of the area's first pixel, and from column to column and row to row.
    let (px, py) = (i64::from(area.left) * 16 + 8, i64::from(area.top) * 16 + 8);
    let edges = [0, 1, 2].map(|i| {
        let (a, b) = (p[order[i]], p[order[(i + 1) % 3]]);
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let top_or_left = dy < 0 || dy == 0 && dx > 0;
        // Without an area nothing is covered.
        let bias = i64::from(!top_or_left || area_of == 0);
        let at_first = dx * (py - a.1) - dy * (px - a.0) - bias;
        (at_first, -16 * dy, 16 * dx)
    });
    let [a, b, c] = edges;
    let row = |y: i32| {
        let y = i64::from(y - area.top);
        let at = |(first, _, down): (i64, i64, i64)| first + down * y;
        let mut values = [at(a), at(b), at(c)];
        let mut word = 0;
        for x in area.left..area.right {
            // No sum comes near 2^63.
            let is_inside = values[0] | values[1] | values[2];
            word |= u32::from(is_inside >= 0) << (x - area.left);
            values[0] = values[0].wrapping_add(a.1);
            values[1] = values[1].wrapping_add(b.1);
            values[2] = values[2].wrapping_add(c.1);
        }
        word
    };
    (area.top..area.bottom).map(row).collect()
}

/// The pixels that the shipped spans cover, in the same form.
pub(crate) fn spans(triangle: &Triangle, area: Rect) -> Vec<u32> {
    let mut rows = vec![0_u32; (area.bottom - area.top) as usize];
    let mut batch = SpanBatch::default();
    let mut walk = Spans::default();
    Scanline.start(&mut walk, triangle, &area, &mut batch);
    loop {
        for span in batch.spans() {
            assert!(span.first <= span.left && span.left < span.right, "{span:?}");
            assert!(span.right <= span.behind, "{span:?}");
            let ones = u64::from(u32::MAX) >> (32 - (span.right - span.left));
            let run = (ones << (span.left - area.left)) as u32;
            let row = &mut rows[(span.y - area.top) as usize];
            assert!(*row & run == 0, "a pixel twice: {span:?}");
            *row |= run;
        }
        if batch.is_last() {
            return rows;
        }
        walk.next_spans(&mut batch);
    }
}

/// Draws white triangles whose positions come in clip space, as they are.
pub(crate) struct InClipSpace;

impl Shader for InClipSpace {
    type Vertex = [i32; 4];
    type Varying = FlatColor;
    type Prepared = ();
    const OWN_POSITIONS: bool = true;

    fn prepare(&self, _: &DrawContext) {}

    fn position(&self, (): &(), [x, y, z, w]: &[i32; 4]) -> Option<Clip> {
        Clip::new(*x, *y, *z, *w)
    }

    fn vertex(&self, (): &(), _: VertexInput<'_, [i32; 4]>) -> Color {
        Rgb::WHITE.into()
    }

    fn fragment(&self, _: &Self::Prepared, varying: &FlatColor) -> Option<Color> {
        Some(varying.color())
    }
}
