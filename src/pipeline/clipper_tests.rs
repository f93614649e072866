//! Two rules of clipping that pictures show too seldom: which bits a cut edge has, and where
//! exactly the near plane lies.

extern crate std;

use super::{ClipPlane, Fan, LEAST_W, NUMBERS, W};
use crate::frame::Size;
use crate::pipeline::mapping::Mapping;
use crate::pipeline::transform::Depth;
use crate::pipeline::Clip;

/// The same numbers on every machine (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn range(&mut self, from: i32, to: i32) -> i32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let span = (i64::from(to) - i64::from(from) + 1).cast_unsigned();
        i32::try_from(i64::from(from) + (self.0 % span).cast_signed()).unwrap_or(from)
    }

    fn corner(&mut self, w: (i32, i32)) -> Clip {
        let w = self.range(w.0, w.1);
        let [x, y] = [0; 2].map(|_: i32| self.range(-(1 << 26), 1 << 26));
        Clip { x, y, z: self.range(0, 1 << 26), w }
    }
}

fn mapping() -> Mapping {
    Mapping::new(0, 0, Size::new(320, 240), Depth::of_row(false))
}

/// What is left of a triangle, and where the point lies that cuts the edge between its first two
/// corners: its screen position and depth.
fn cut_of_first_edge(corners: [Clip; 3]) -> Option<[i32; 3]> {
    let mut fan = Fan::default();
    let clip = |index: u32| corners.get(index as usize).copied();
    fan.cut(&mapping(), clip, &[0, 1, 2])?;
    (0..fan.length).map(|at| *fan.corner(fan.first + at)).find_map(|corner| {
        let [x, y, z, _, second, third, ..] = corner;
        (third == 0 && second > 0 && second < 1 << 30).then_some([x, y, z])
    })
}

#[test]
fn two_triangles_that_share_an_edge_cut_it_at_the_same_point() {
    let mut random = Random(7);
    let mut cut = 0;
    for _ in 0..20_000 {
        // In view, and behind the eye.
        let near = random.corner((1 << 26, 1 << 29));
        let behind = random.corner((-(1 << 29), -(1 << 20)));
        let others = [0; 2].map(|_: i32| random.corner((1 << 26, 1 << 29)));
        let one = cut_of_first_edge([near, behind, others[0]]);
        let other = cut_of_first_edge([behind, near, others[1]]);
        assert_eq!(one, other, "{near:?} to {behind:?}");
        cut += u32::from(one.is_some());
    }
    assert!(cut > 10_000, "edges were cut: {cut}");
}

#[test]
fn the_near_plane_grants_a_64th_of_w_and_no_more_than_six_halves_of_a_position() {
    let mapping = mapping();
    let plane = ClipPlane::new(0, &mapping);
    assert_ne!(plane.axis, LEAST_W, "the near plane of a matrix with a row for z");
    for w in [1, 63, 64, 6400, (6 << 20) - 1, 6 << 20, (6 << 20) + 64, 1 << 29] {
        let granted = (w / 64).min(98_304);
        for (z, is_behind) in [(w + granted, false), (w + granted + 1, true)] {
            let clip = Clip { x: 0, y: 0, z, w };
            assert_eq!(mapping.point(&clip).is_none(), is_behind, "z {z}, w {w}");
            let mut corner = [0; 8];
            corner[..NUMBERS].copy_from_slice(&[0, 0, z, w, 0, 0]);
            assert_eq!(corner[W], w, "where w lies");
            assert_eq!(plane.distance(&corner) < 0, is_behind, "the clipper agrees: z {z}, w {w}");
        }
    }
}
