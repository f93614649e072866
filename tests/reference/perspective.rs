//! Clip space: planes and their varyings against rays, clipping against polygons made by hand.

use microraster::host::reference::{
    Draw, Fragment, Interpolation, Kind, Progress, Reference, Space, State, Vertex,
};
use microraster::{AnyDepth, AnyDepthState, Rect, Size};

const SIZE: Size = Size::new(40, 30);
const VIEW: Rect = Rect::from_size(SIZE);

/// A camera that looks along -z, with a near distance of 1: tangents of half the angles are 1
/// across and 3/4 down.
fn clip([x, y, z]: [f64; 3]) -> [f64; 4] {
    [x, y / 0.75, 1.0, -z]
}

/// Where the ray through a place, in pixels, goes: x and y at distance 1.
fn ray([x, y]: [f64; 2]) -> [f64; 2] {
    [x / 20.0 - 1.0, 0.75 * (1.0 - y / 15.0)]
}

/// A plane `y = -1 + z / 4` that goes down into the distance, with its x and z as varyings.
fn floor() -> Vec<Vertex> {
    let corner = |(x, z): (f64, f64)| Vertex {
        position: clip([x, -1.0 + z / 4.0, z]),
        varyings: vec![x, z],
    };
    [(-50.0, 20.0), (50.0, 20.0), (50.0, -90.0), (-50.0, -90.0)].map(corner).to_vec()
}

/// What a ray meets of it: x and z.
fn met(at: [f64; 2]) -> [f64; 2] {
    let [x, y] = ray(at);
    // -d y = 1 + d / 4, for a distance d.
    let distance = 1.0 / (-y - 0.25);
    [x * distance, -distance]
}

fn draw(picture: &mut Reference, far: bool, shade: &dyn Fn(&Fragment<'_>) -> Option<[f64; 4]>) {
    picture.draw(&Draw {
        space: Space::Clip { viewport: VIEW, far },
        kind: Kind::Triangles,
        vertices: &floor(),
        corners: &[0, 1, 2, 0, 2, 3],
        interpolation: Interpolation::Perspective,
        state: State { depth: AnyDepthState::new(AnyDepth::Less), ..State::PLAIN },
        shade,
    });
}

#[test]
fn a_plane_through_the_eye_is_where_rays_meet_it() {
    for look in [[0.0, 0.0], [0.25, -0.4]] {
        let mut picture = Reference::new(SIZE, [0.0; 3]).look(look);
        draw(&mut picture, false, &|f| {
            let at = [f64::from(f.x) + 0.5 + look[0], f64::from(f.y) + 0.5 + look[1]];
            let here = met(at);
            // Central differences of the exact function, of an error of h^2.
            let h = 1e-4;
            let slope = |axis: usize| {
                let mut ends = [at; 2];
                ends[0][axis] -= h;
                ends[1][axis] += h;
                let [a, b] = ends.map(met);
                [0, 1].map(|i| (b[i] - a[i]) / (2.0 * h))
            };
            for i in 0..2 {
                let size = 1e-5 * (1.0 + here[1].abs());
                assert!((f.varyings[i] - here[i]).abs() < size, "{:?}: {here:?}", f.varyings);
                for (along, axis) in [(f.along_x, 0), (f.along_y, 1)] {
                    let exact = slope(axis)[i];
                    let bound = 1e-4 * (1.0 + here[1] * here[1]);
                    assert!((along[i] - exact).abs() < bound, "{along:?}: {exact}");
                }
            }
            Some([255.0; 4])
        });
        // Each pixel whose ray meets the plane between the near plane and its far end, once.
        for (i, (count, code)) in picture.counts().iter().zip(picture.depths()).enumerate() {
            let at = [(i % 40) as f64 + 0.5 + look[0], (i / 40) as f64 + 0.5 + look[1]];
            let [x, z] = met(at);
            let is_met = z < -1.0 && z > -90.0 && x.abs() < 50.0;
            assert_eq!(*count, u32::from(is_met), "at {at:?}, which meets {z}");
            let exact = if is_met { 2.0 + 65_531.0 / -z } else { 0.0 };
            assert!((code - exact).abs() < 0.01, "{code} for {exact}");
        }
    }
}

#[test]
fn derivatives_are_what_neighbours_differ_by_where_varyings_are_linear() {
    let vertex = |x: f64, y: f64, v: f64| Vertex { position: [x, y, 0.0, 7.0], varyings: vec![v] };
    let mut picture = Reference::new(Size::new(8, 8), [0.0; 3]);
    picture.draw(&Draw {
        space: Space::Window,
        kind: Kind::Triangles,
        // 5 + 2 x - 3 y.
        vertices: &[vertex(0.0, 0.0, 5.0), vertex(10.0, 0.0, 25.0), vertex(0.0, 10.0, -25.0)],
        corners: &[0, 1, 2],
        interpolation: Interpolation::Linear,
        state: State::PLAIN,
        shade: &|f| {
            let exact = 5.0 + 2.0 * (f64::from(f.x) + 0.5) - 3.0 * (f64::from(f.y) + 0.5);
            for (got, exact) in [(f.varyings, exact), (f.along_x, 2.0), (f.along_y, -3.0)] {
                assert!((got[0] - exact).abs() < 1e-12, "{got:?} for {exact}");
            }
            Some([255.0; 4])
        },
    });
    assert!(picture.counts().contains(&1), "something is drawn");
}

/// A triangle with its tip before the eye and two corners behind the near plane, x to the right:
/// at 2 w of the tip the plane cuts both edges half way.
#[test]
fn the_near_plane_leaves_the_polygon_that_is_made_by_hand() {
    let vertex = |position: [f64; 4], v: f64| Vertex { position, varyings: vec![v] };
    // z is 1 everywhere: what has w < 1 is cut off.
    let tip = vertex([0.0, 3.0, 1.0, 4.0], 0.0);
    let left = vertex([-4.0, -3.0, 1.0, -2.0], 60.0);
    let right = vertex([4.0, -3.0, 1.0, -2.0], 60.0);
    // At half way w is 1, x is -2 and 2, y is 0, and the varying is 30: on the screen the tip lies
    // at (20, 15 - 15 * 3 / 4), the cuts at (20 - 40, 15) and (20 + 40, 15).
    let cut = [[20.0, 3.75], [-20.0, 15.0], [60.0, 15.0]];
    let mut by_hand = Reference::new(SIZE, [0.0; 3]);
    super::coverage::draw_white(&mut by_hand, &cut);
    for interpolation in [Interpolation::Linear, Interpolation::Perspective] {
        let mut picture = Reference::new(SIZE, [0.0; 3]);
        picture.draw(&Draw {
            space: Space::Clip { viewport: VIEW, far: false },
            kind: Kind::Triangles,
            vertices: &[tip.clone(), left.clone(), right.clone()],
            corners: &[0, 1, 2],
            interpolation,
            state: State::PLAIN,
            shade: &|f| {
                // Part t of the way down from the tip, on the screen.
                let t = (f64::from(f.y) + 0.5 - 3.75) / 11.25;
                let exact = match interpolation {
                    Interpolation::Linear => 30.0 * t,
                    // (30 t / 1) / ((1 - t) / 4 + t / 1)
                    _ => 30.0 * t / ((1.0 - t) / 4.0 + t),
                };
                assert!((f.varyings[0] - exact).abs() < 1e-5, "{:?} for {exact}", f.varyings);
                Some([255.0; 4])
            },
        });
        assert_eq!(picture.counts(), by_hand.counts(), "{interpolation:?}");
    }
    // One corner behind: a polygon of four, drawn once.
    let picture = |corners: [&Vertex; 3]| {
        let mut picture = Reference::new(SIZE, [0.0; 3]);
        picture.draw(&Draw {
            space: Space::Clip { viewport: VIEW, far: false },
            kind: Kind::Triangles,
            vertices: &corners.map(Clone::clone),
            corners: &[0, 1, 2],
            interpolation: Interpolation::Perspective,
            state: State::PLAIN,
            shade: &|f| Some([f.varyings[0], f64::from(u8::from(f.front)), 0.0, 255.0]),
        });
        picture
    };
    let far_left = vertex([-1.0, 1.0, 1.0, 2.0], 9.0);
    let far_right = vertex([1.0, 1.0, 1.0, 2.0], 9.0);
    let behind = vertex([0.0, -6.0, 1.0, -1.0], 9.0);
    // Two thirds of the way to the eye's plane: w is 1 a third of the way, at x of -2/3 and 2/3
    // and y of -4/3. Down at y = -1 the view ends.
    let [a, b] = [[10.0, 7.5], [30.0, 7.5]];
    let cuts = [[20.0 + 20.0 * 2.0 / 3.0, 35.0], [20.0 - 20.0 * 2.0 / 3.0, 35.0]];
    let mut by_hand = Reference::new(SIZE, [0.0; 3]);
    super::coverage::draw_white(&mut by_hand, &[a, b, cuts[0], a, cuts[0], cuts[1]]);
    for corners in [
        [&far_left, &far_right, &behind],
        [&far_right, &behind, &far_left],
        [&behind, &far_left, &far_right],
    ] {
        let picture = picture(corners);
        assert_eq!(picture.counts(), by_hand.counts(), "a polygon of four corners");
        let seen = picture.colors().iter().zip(picture.counts()).filter(|(_, count)| **count > 0);
        for ([red, front, _], _) in seen {
            assert!((red - 9.0).abs() < 1e-9 && *front == 0.0, "clockwise, {red}");
        }
    }
}

#[test]
fn the_far_plane_and_the_eye_cut_as_well() {
    let mut near = Reference::new(SIZE, [0.0; 3]);
    draw(&mut near, true, &|_| Some([255.0; 4]));
    let mut all = Reference::new(SIZE, [0.0; 3]);
    draw(&mut all, false, &|_| Some([255.0; 4]));
    assert_eq!(near.counts(), all.counts(), "z is never below 0 here");
    // z falls from 1 at the left to -1 at the right: the right half lies beyond the far plane.
    let vertex = |x: f64, y: f64| Vertex { position: [x, y, -x, 1.0], varyings: Vec::new() };
    let mut picture = Reference::new(SIZE, [0.0; 3]);
    picture.draw(&Draw {
        space: Space::Clip { viewport: VIEW, far: true },
        kind: Kind::Triangles,
        vertices: &[vertex(-1.0, -1.0), vertex(1.0, -1.0), vertex(1.0, 1.0), vertex(-1.0, 1.0)],
        corners: &[0, 1, 2, 0, 2, 3],
        interpolation: Interpolation::Perspective,
        state: State::PLAIN,
        shade: &|_| Some([255.0; 4]),
    });
    for (i, count) in picture.counts().iter().enumerate() {
        assert_eq!(*count, u32::from(i % 40 < 20), "column {}", i % 40);
    }
}

#[test]
fn lines_and_points_are_cut_at_the_near_plane_too() {
    let vertex = |position: [f64; 4], v: f64| Vertex { position, varyings: vec![v] };
    let vertices = [
        vertex([0.0, 0.0, 1.0, 2.0], 0.0),
        // Half way w is 1 and x is 2: the line leaves the view to the right.
        vertex([4.0, 0.0, 1.0, 0.0], 80.0),
        vertex([0.0, 0.0, 1.0, 0.5], 0.0),
    ];
    let picture = |kind: Kind, corners: &[u32]| {
        let mut picture = Reference::new(SIZE, [0.0; 3]);
        picture.draw(&Draw {
            space: Space::Clip { viewport: VIEW, far: false },
            kind,
            vertices: &vertices,
            corners,
            interpolation: Interpolation::Linear,
            state: State::PLAIN,
            shade: &|f| Some([f.varyings[0], 0.0, 0.0, 255.0]),
        });
        picture
    };
    let line = picture(Kind::Lines { width: 1, progress: Progress::Longer }, &[0, 1]);
    for (i, count) in line.counts().iter().enumerate() {
        // Ends on edges of pixels belong to what lies above and to the left of them, by (-e, -e^2).
        let is_on = i / 40 == 14 && i % 40 >= 20;
        assert_eq!(*count, u32::from(is_on), "{} {}", i % 40, i / 40);
        if is_on {
            let exact = 40.0 * (((i % 40) as f64 + 0.5 - 20.0) / 40.0);
            assert!((line.colors()[i][0] - exact).abs() < 1e-6, "{exact}");
        }
    }
    let point = picture(Kind::Points { side: 3.0 }, &[0, 2]);
    assert_eq!(point.counts().iter().sum::<u32>(), 9, "the second one lies before the near plane");
}
