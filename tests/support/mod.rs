//! What several tests share: random numbers, the brute-force rasterizer.
#![allow(dead_code, reason = "each test takes what it needs")]

use microraster::raster::ScreenVertex;

/// A small generator (SplitMix64): the same numbers on every machine.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in `from..=to`.
    pub fn range(&mut self, from: i32, to: i32) -> i32 {
        let span = (i64::from(to) - i64::from(from) + 1) as u64;
        (i64::from(from) + (self.next() % span) as i64) as i32
    }

    /// A number in 0..1.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// The definition of coverage, word for word: E >= bias on all three edges at the pixel's centre.
pub fn covers(v: &[ScreenVertex; 3], x: i32, y: i32) -> bool {
    let p: Vec<(i64, i64)> =
        v.iter().map(|v| (i64::from(v.x.to_bits()), i64::from(v.y.to_bits()))).collect();
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
