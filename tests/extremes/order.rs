//! What has no bearing on coverage: the order of corners and of triangles, and the winding.

use crate::coverage::{ENDS, PICTURE};
use crate::shared_edges::{above, drawn, floor};
use crate::support::{any_corner, covered, spans, Random};
use crate::tally::{cases, random};
use microraster::math::{Mat4, Vec3};
use microraster::raster::{ScreenVertex, Triangle};
use microraster::{
    Camera, Color, Cull, Flat, Frame, Mesh, Pass, Rect, Rgb, Rgba8888, ScreenPass, Winding,
};

const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

fn flipped(winding: Winding) -> Winding {
    match winding {
        Winding::CounterClockwise => Winding::Clockwise,
        Winding::Clockwise => Winding::CounterClockwise,
    }
}

/// The rows that a pass writes of a triangle, a bit a pixel.
fn screen(v: [ScreenVertex; 3], cull: Cull, front: Winding) -> Vec<u32> {
    let mut words = vec![0; 32 * 24];
    let mut frame = Frame::<Rgba8888>::new(&mut words, PICTURE).expect("the buffer fits");
    let triangle = v.map(|v| (v, Color::from(Rgb::WHITE)));
    ScreenPass::new().cull(cull).front_face(front).triangle(
        &mut frame,
        &Flat::colored(),
        &triangle,
    );
    let bits = |row: &[u32]| row.iter().rev().fold(0, |bits, w| bits << 1 | u32::from(*w != 0));
    words.chunks(32).map(bits).collect()
}

fn corners(random: &mut Random) -> [ScreenVertex; 3] {
    let class = random.range(0, 10);
    [0; 3].map(|_: i32| {
        if class == 10 {
            let (x, y) = ENDS[random.range(0, 3) as usize];
            ScreenVertex::from_bits(x, y, 0)
        } else {
            any_corner(random, class, PICTURE)
        }
    })
}

#[test]
fn order_of_corners_winding_and_flipped_culling_never_change_coverage() {
    let whole = Rect::from_size(PICTURE);
    let property = "order of corners, winding and culling change no pixel";
    let mut number = 0;
    random(property, cases(60_000, 9_000_000), 41, |random| {
        let v = corners(random);
        let expected = covered(&v, whole);
        for order in ORDERS {
            let v = order.map(|i| v[i]);
            let found = Triangle::new(v, PICTURE).map_or(vec![0; 24], |t| spans(&t, whole));
            assert!(found == expected, "{v:?}");
        }
        number += 1;
        if number % 8 != 0 {
            return 1;
        }
        // The same through the pass: one side is seen, the other is not, and turning both the
        // triangle and the winding or the culling about changes nothing.
        let back = [v[0], v[2], v[1]];
        for front in [Winding::CounterClockwise, Winding::Clockwise] {
            let seen = screen(v, Cull::Back, front);
            let turned = flipped(front);
            assert!(seen == screen(back, Cull::Back, turned), "turned about: {v:?}");
            assert!(seen == screen(v, Cull::Front, turned), "the other side culled: {v:?}");
            assert!(seen == screen(back, Cull::Front, front), "both: {v:?}");
            let other = screen(v, Cull::Front, front);
            let either = [&seen, &other].map(|rows| rows.iter().all(|row| *row == 0));
            assert!(either[0] || either[1], "both sides seen: {v:?}");
            let both: Vec<u32> = seen.iter().zip(&other).map(|(a, b)| a | b).collect();
            assert!(both == expected, "one side or the other: {v:?}");
        }
        1
    });
}

/// The pixels of a mesh, its triangles in any order, each from any of its corners on.
fn shuffled(random: &mut Random, indices: &[u16]) -> Vec<u16> {
    let mut triangles: Vec<[u16; 3]> = indices.as_chunks::<3>().0.to_vec();
    for i in (1..triangles.len()).rev() {
        triangles.swap(i, random.range(0, i as i32) as usize);
        triangles[i].rotate_left(random.range(0, 2) as usize);
    }
    triangles.into_iter().flatten().collect()
}

#[test]
fn order_of_indices_and_flipped_winding_never_change_coverage_of_a_clipped_mesh() {
    let property = "order of indices changes no pixel, through clipping";
    let mut clipped = 0;
    random(property, cases(60_000, 5_000_000), 42, |random| {
        let (positions, indices) = floor(random);
        let colors = vec![Rgb::WHITE; positions.len()];
        let reach = [20.0, 200.0][random.range(0, 1) as usize];
        let place = Vec3::splat(reach / 32_000.0);
        let mesh = Mesh::new(&positions, &colors).placed(place, Vec3::ZERO);
        let camera: Camera = above(random);
        let picture = |indices: &[u16], front: Winding| {
            drawn(|frame, stats| {
                let mut pass = Pass::new(&camera).cull(Cull::Back).front_face(front).count(stats);
                pass.draw(frame, &Mat4::identity(), &mesh.indexed(indices), &Flat::colored());
            })
        };
        let (pixels, stats) = picture(&indices, Winding::Clockwise);
        let again = shuffled(random, &indices);
        let (others, _) = picture(&again, Winding::Clockwise);
        assert!(pixels == others, "in another order: {camera:?} {indices:?} {again:?}");
        let turned: Vec<u16> = again.iter().rev().copied().collect();
        let (others, other) = picture(&turned, Winding::CounterClockwise);
        assert!(pixels == others, "turned about: {camera:?} {indices:?}");
        assert_eq!(stats.pixels, other.pixels, "each pixel once: {camera:?}");
        clipped += u64::from(stats.clipped);
        stats.triangles.into()
    });
    assert!(clipped > 1_000 || !cfg!(debug_assertions), "hardly tested: {clipped}");
}
