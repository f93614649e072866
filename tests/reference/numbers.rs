//! Numbers that nobody draws with on purpose: nothing panics, and what cannot be drawn is left out.

use microraster::host::reference::compare::{Difference, RGBA8888_STEPS};
use microraster::host::reference::{
    Draw, Fragment, Interpolation, Kind, Progress, Reference, Snap, Space, State, TexelGrid, Vertex,
};
use microraster::texture::AnyWrap;
use microraster::{Rect, Size};

const SIZE: Size = Size::new(16, 12);
const LINES: Kind = Kind::Lines { width: 3, progress: Progress::Nearest };

fn spaces() -> [Space; 3] {
    let viewport = Rect::from_size(SIZE);
    [Space::Window, Space::Clip { viewport, far: false }, Space::Clip { viewport, far: true }]
}

fn white(_: &Fragment<'_>) -> Option<[f64; 4]> {
    Some([255.0; 4])
}

/// Draws vertices one after the other, without culling.
fn drawn(size: Size, snap: Snap, space: Space, kind: Kind, positions: &[[f64; 4]]) -> Reference {
    let vertex = |position: &[f64; 4]| Vertex { position: *position, varyings: vec![position[0]] };
    let vertices: Vec<Vertex> = positions.iter().map(vertex).collect();
    let corners: Vec<u32> = (0..).take(vertices.len()).collect();
    let mut picture = Reference::new(size, [0.0; 3]).snap(snap);
    picture.draw(&Draw {
        space,
        kind,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Perspective,
        state: State::PLAIN,
        shade: &white,
    });
    picture
}

#[test]
fn what_has_a_corner_that_is_no_number_or_infinite_is_left_out_and_counts() {
    let good = [[-0.5, -0.5, 0.1, 1.0], [0.9, 0.0, 0.1, 1.0], [0.0, 0.9, 0.1, 1.0]];
    let in_window = good.map(|[x, y, _, w]| [8.0 + 8.0 * x, 6.0 + 6.0 * y, 100.0, w]);
    for space in spaces() {
        let good = if space == Space::Window { in_window } else { good };
        let points = Kind::Points { side: 4.0 };
        for (kind, each) in [(Kind::Triangles, 3), (LINES, 2), (points, 1)] {
            let good = &good[..each];
            let alone = drawn(SIZE, Snap::Exact, space, kind, good);
            assert!(alone.counts().iter().sum::<u32>() > 5, "{space:?} {kind:?}");
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                for place in 0..4 * each {
                    let mut positions = good.to_vec();
                    positions[place / 4][place % 4] = bad;
                    positions.extend(good);
                    let both = drawn(SIZE, Snap::Exact, space, kind, &positions);
                    assert_eq!(both.counts(), alone.counts(), "{space:?} {kind:?} {positions:?}");
                    let numbers = both.seen().iter().flatten();
                    assert!(numbers.copied().all(|number| number == 1), "the first counts");
                }
            }
        }
    }
}

#[test]
fn numbers_of_any_size_are_drawn_without_a_panic_into_any_picture() {
    let numbers = [0.0, -0.0, 1.0, -1.0, 1e-300, -1e-300, 1e9, -1e10, 1e38, -1e300, f64::MAX];
    let mut random = crate::support::Random(9);
    for i in 0..3_000 {
        let mut number = || numbers[random.next() as usize % numbers.len()];
        let positions = [(); 6].map(|()| [(); 4].map(|()| number()));
        let side = number();
        let snap = [Snap::Exact, Snap::Bits(4), Snap::Bits(0), Snap::Bits(99)][i % 4];
        let size = [SIZE, Size::new(0, 0), Size::new(0, 5), Size::new(5, 0)][i / 4 % 4];
        for kind in [Kind::Triangles, LINES, Kind::Points { side }] {
            for space in spaces() {
                drawn(size, snap, space, kind, &positions);
            }
        }
    }
}

#[test]
fn a_triangle_that_reaches_farther_than_numbers_do_still_covers_the_picture() {
    for far in [1e3, 1e9, 1e12, 1e30] {
        let corners = [[-far, -far, 0.0, 1.0], [far, -far, 0.0, 1.0], [0.0, far, 0.0, 1.0]];
        for snap in [Snap::Exact, Snap::Bits(4), Snap::Bits(0)] {
            let picture = drawn(SIZE, snap, Space::Window, Kind::Triangles, &corners);
            assert!(picture.counts().iter().all(|count| *count == 1), "{far} {snap:?}");
        }
    }
}

#[test]
fn steps_of_lines_longer_than_any_counter_run_on() {
    let line = [[-4e9, 5.5, 0.0, 1.0], [4e9, 5.5, 0.0, 1.0]];
    let picture = drawn(SIZE, Snap::Exact, Space::Window, LINES, &[line, line].concat());
    assert_eq!(picture.counts().iter().sum::<u32>(), 2 * 3 * 16, "both lines, three rows");
}

#[test]
fn a_grid_without_texels_has_number_zero_only() {
    for wrap in [AnyWrap::Repeat, AnyWrap::Mirror, AnyWrap::Clamp] {
        let grid = TexelGrid { width: 0, height: 0, wraps: [wrap; 2] };
        for u in [0.0, -3.5, 1e300, f64::NAN] {
            assert_eq!(grid.nearest([u, 0.5]), 0, "{wrap:?} {u}");
            assert_eq!(grid.bilinear([0.5, u]).map(|(texel, _)| texel), [0; 4], "{wrap:?} {u}");
        }
    }
}

#[test]
fn what_is_no_number_is_never_right() {
    let exact = [[0.0; 3], [f64::NAN, 0.0, 0.0]];
    let difference = Difference::between(&[[0.0; 3]; 2], &exact, RGBA8888_STEPS);
    assert_eq!((difference.max, difference.beyond_a_step), (f64::INFINITY, 0.5), "{difference:?}");
}
