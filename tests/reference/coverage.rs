//! Which pixels are covered, against half planes, drawings and areas.

use microraster::host::reference::{
    looks, mean_colors, Draw, Interpolation, Kind, Reference, Snap, Space, State, Vertex,
};
use microraster::Size;

use crate::support::Random;

/// Corners in pixels as white triangles.
pub(crate) fn draw_white(picture: &mut Reference, corners: &[[f64; 2]]) {
    let vertex = |&[x, y]: &[f64; 2]| Vertex { position: [x, y, 0.0, 1.0], varyings: Vec::new() };
    let vertices: Vec<Vertex> = corners.iter().map(vertex).collect();
    let corners: Vec<u32> = (0..).take(vertices.len()).collect();
    picture.draw(&Draw {
        space: Space::Window,
        kind: Kind::Triangles,
        vertices: &vertices,
        corners: &corners,
        interpolation: Interpolation::Linear,
        state: State::PLAIN,
        shade: &|_| Some([255.0; 4]),
    });
}

/// How often each pixel is covered, row by row.
fn drawn(picture: &Reference) -> Vec<String> {
    let digit =
        |count: &u32| char::from_digit(*count, 10).map_or('?', |d| if d == '0' { '.' } else { d });
    let rows = picture.counts().chunks(picture.size().width.into());
    rows.map(|row| row.iter().map(digit).collect()).collect()
}

#[test]
fn a_half_plane_covers_the_centres_on_its_side() {
    let mut random = Random(1);
    for _ in 0..300 {
        // Through a point of the picture, in some direction; what is to its left is far away.
        let [x, y] = [0, 1].map(|_| 32.0 * random.unit());
        let angle = 2.0 * std::f64::consts::PI * random.unit();
        let (down, right) = angle.sin_cos();
        let at = |along: f64, beside: f64| {
            [x + along * right - beside * down, y + along * down + beside * right]
        };
        let look = [0, 1].map(|_| random.unit() - 0.5);
        for snap in [Snap::Exact, Snap::Bits(8)] {
            let mut picture = Reference::new(Size::new(32, 32), [0.0; 3]).look(look).snap(snap);
            draw_white(&mut picture, &[at(-400.0, 0.0), at(400.0, 0.0), at(0.0, 400.0)]);
            // Corners are rounded by half a step at most, by axis.
            let rounding = if snap == Snap::Exact { 1e-7 } else { 0.5_f64.sqrt() / 256.0 };
            for (i, count) in picture.counts().iter().enumerate() {
                let (column, row) = ((i % 32) as f64, (i / 32) as f64);
                let (dx, dy) = (column + 0.5 + look[0] - x, row + 0.5 + look[1] - y);
                let beside = dy * right - dx * down;
                if beside.abs() > 2.0 * rounding {
                    assert_eq!(*count > 0, beside > 0.0, "{beside} beside {x} {y} {angle}");
                }
            }
        }
    }
}

#[test]
fn centres_on_edges_belong_to_what_is_right_of_and_below_them() {
    let square = |left: f64, top: f64, right: f64, bottom: f64| {
        let [a, b, c, d] = [[left, top], [right, top], [right, bottom], [left, bottom]];
        [a, b, c, a, d, c]
    };
    let mut picture = Reference::new(Size::new(6, 4), [0.0; 3]);
    draw_white(&mut picture, &square(1.5, 0.5, 4.5, 2.5));
    let expected = [
        ".111..", //
        ".111..", "......", "......",
    ];
    assert_eq!(drawn(&picture), expected, "from the centre of (1, 0) to that of (4, 2)");
    // Corners on centres, edges that rise and fall through centres.
    let mut picture = Reference::new(Size::new(6, 6), [0.0; 3]);
    draw_white(&mut picture, &[[0.5, 0.5], [4.5, 0.5], [0.5, 4.5]]);
    let expected = [
        "1111..", //
        "111...", "11....", "1.....", "......", "......",
    ];
    assert_eq!(drawn(&picture), expected, "the long edge lies to the right");
    draw_white(&mut picture, &[[4.5, 4.5], [4.5, 0.5], [0.5, 4.5]]);
    let expected = [
        "1111..", //
        "1111..", "1111..", "1111..", "......", "......",
    ];
    assert_eq!(drawn(&picture), expected, "and to the left of the other half");
}

#[test]
fn a_lattice_of_triangles_covers_every_pixel_once() {
    // Corners on centres, corners and edges of pixels: every kind of tie.
    for step in [0.5, 1.0, 1.5, 2.0, 3.5] {
        for (shift, look) in [(0.0, 0.0), (0.5, 0.0), (0.25, 0.25), (0.0, -0.5)] {
            for falls in [false, true] {
                let mut picture = Reference::new(Size::new(12, 12), [0.0; 3]).look([look; 2]);
                let side = (16.0 / step) as i32;
                let at = |i: i32, j: i32| [i, j].map(|i| f64::from(i) * step + shift - 2.0);
                for (i, j) in (0..side).flat_map(|j| (0..side).map(move |i| (i, j))) {
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    let two = if falls { [a, b, c, c, a, d] } else { [b, a, d, b, c, d] };
                    draw_white(&mut picture, &two);
                }
                let counts = picture.counts();
                assert!(counts.iter().all(|count| *count == 1), "{step}, {shift}: {counts:?}");
            }
        }
    }
}

#[test]
fn the_mean_of_256_looks_is_the_area() {
    let mut random = Random(2);
    let mut balance = 0.0;
    for _ in 0..100 {
        let corners = [(); 3].map(|()| [0, 1].map(|_| 1.0 + 14.0 * random.unit()));
        let pictures = looks(16).map(|look| {
            let mut picture = Reference::new(Size::new(16, 16), [0.0; 3]).look(look);
            draw_white(&mut picture, &corners);
            picture
        });
        let seen: f64 = mean_colors(pictures).iter().map(|color| color[0] / 255.0).sum();
        let [a, b, c] = corners;
        let area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs() / 2.0;
        let side = |a: [f64; 2], b: [f64; 2]| (b[0] - a[0]).hypot(b[1] - a[1]);
        let around = side(a, b) + side(b, c) + side(c, a);
        // Only cells of 1/16 pixel that an edge crosses are wrong, by half of one at a time on
        // either side; edges that run along cells are wrong for long.
        let bound = around / 16.0 / 2.0 + 1.0 / 256.0;
        assert!((seen - area).abs() <= bound, "{seen} of {area}: {corners:?}");
        balance += (seen - area) / area;
    }
    assert!(balance.abs() / 100.0 < 0.01, "on one side: {balance}");
}

#[test]
fn corners_are_rounded_to_the_nearest_place_of_the_grid() {
    // The left edge of a square about a row of centres, looked at around it.
    for bits in [2, 4, 8] {
        let step = 1.0 / f64::from(1 << bits);
        for (from, to) in [(0.49, 0.0), (0.5, 1.0), (0.51, 1.0), (-0.5, 0.0), (-0.51, -1.0)] {
            let left = 2.0 + from * step;
            let covers = |at: f64| {
                let picture = Reference::new(Size::new(4, 1), [0.0; 3]).snap(Snap::Bits(bits));
                let mut picture = picture.look([at - 2.5, 0.0]);
                draw_white(&mut picture, &[[left, -9.0], [left, 9.0], [99.0, 0.5]]);
                picture.counts()[2] == 1
            };
            let edge = 2.0 + to * step;
            assert!(!covers(edge - step / 64.0), "{from} steps of 2^-{bits}");
            assert!(covers(edge), "{from} steps of 2^-{bits}");
        }
    }
}

#[test]
fn bits_and_exact_cover_alike_what_lies_on_the_grid() {
    let mut random = Random(3);
    for _ in 0..200 {
        let corners = [(); 3].map(|()| [0, 1].map(|_| f64::from(random.range(-300, 700)) / 16.0));
        let counts = [Snap::Exact, Snap::Bits(4), Snap::Bits(6)].map(|snap| {
            let mut picture = Reference::new(Size::new(24, 24), [0.0; 3]).snap(snap);
            draw_white(&mut picture, &corners);
            picture.counts().to_vec()
        });
        assert!(counts[0] == counts[1] && counts[0] == counts[2], "{corners:?}");
    }
}
