//! Topologies against the lists that they stand for, written out.
#![allow(clippy::cast_possible_truncation, reason = "a few vertices")]

extern crate std;

use std::vec::Vec;

use super::*;
use crate::math::hard_numbers::Random;

/// Parts between restarts, each with its own first place.
fn parts(sequence: &[Step]) -> Vec<Vec<u32>> {
    sequence
        .split(|step| *step == Step::Restart)
        .map(|part| {
            let vertex = |step: &Step| match step {
                Step::Vertex(vertex) => *vertex,
                Step::Restart => unreachable!("split there"),
            };
            part.iter().map(vertex).collect()
        })
        .collect()
}

/// A triangle, and its provoking vertices by both conventions.
type Provoked = ([u32; 3], u32, u32);

/// A line, and whether it goes on from the one before.
type Chained = ([u32; 2], bool);

/// Triangles as OpenGL 4.6 has them in tables 10.1 and 13.2: corners in the order of the surface,
/// and the provoking vertices of both conventions.
fn strip(part: &[u32]) -> Vec<Provoked> {
    (2..part.len())
        .map(|i| {
            let (a, b, c) = (part[i - 2], part[i - 1], part[i]);
            let corners = if i % 2 == 0 { [a, b, c] } else { [b, a, c] };
            (corners, a, c)
        })
        .collect()
}

fn fan(part: &[u32]) -> Vec<Provoked> {
    (2..part.len()).map(|i| ([part[0], part[i - 1], part[i]], part[i - 1], part[i])).collect()
}

/// Whether a triangle has these corners in this turn.
fn same_turn(a: [u32; 3], b: [u32; 3]) -> bool {
    (0..3).any(|turn| [0, 1, 2].map(|k| a[(k + turn) % 3]) == b)
}

fn check_triangles<T>(topology: &T, expected: &[Provoked])
where
    T: Topology<Primitive = [u32; 3]>,
{
    let first: Vec<_> = topology.iter().collect();
    let last: Vec<_> = LastProvoking(*topology).iter().collect();
    assert_eq!((first.len(), last.len()), (expected.len(), expected.len()), "how many");
    assert_eq!(topology.count() as usize, expected.len(), "count");
    let mut cursor = T::Cursor::default();
    for (i, (corners, a, b)) in expected.iter().enumerate() {
        assert!(same_turn(first[i], *corners) && first[i][0] == *a, "{:?}", (first[i], corners));
        assert!(same_turn(last[i], *corners) && last[i][0] == *b, "{:?}", (last[i], corners));
        let numbered = topology.next::<false>(&mut cursor);
        assert_eq!(numbered.map(|(number, _)| number as usize), Some(i), "numbers");
    }
    assert_eq!(topology.next::<false>(&mut cursor), None, "behind the last");
    assert_eq!(topology.next::<false>(&mut cursor), None, "and again");
}

/// Indices with a restart now and then, often several at once.
fn indices(random: &mut Random) -> Vec<u8> {
    let length = random.word() % 24;
    let index = |i| if random.word().is_multiple_of(5) { 255 } else { i as u8 };
    (0..length).map(index).collect()
}

fn steps(indices: &[u8], restarts: bool) -> Vec<Step> {
    let step = |index: &u8| match index {
        255 if restarts => Step::Restart,
        _ => Step::Vertex((*index).into()),
    };
    indices.iter().map(step).collect()
}

fn wide<I>(indices: &[u8], restart: I, wide: impl Fn(u8) -> I) -> Vec<I>
where
    I: Copy,
{
    indices.iter().map(|index| if *index == 255 { restart } else { wide(*index) }).collect()
}

#[test]
fn strips_and_fans_are_the_lists_that_they_stand_for() {
    let mut random = Random::new(31);
    for _ in 0..4_000 {
        let bytes = indices(&mut random);
        let halves = wide(&bytes, u16::MAX, u16::from);
        let words = wide(&bytes, u32::MAX, u32::from);
        let all = |restarts, of: fn(&[u32]) -> Vec<Provoked>| -> Vec<Provoked> {
            parts(&steps(&bytes, restarts)).iter().flat_map(|part| of(part)).collect()
        };
        check_triangles(&TriangleStrip::new(Indices::new(&bytes)), &all(false, strip));
        check_triangles(&TriangleFan::new(Indices::new(&bytes)), &all(false, fan));
        let (strips, fans) = (all(true, strip), all(true, fan));
        check_triangles(&TriangleStrip::new(RestartIndices::new(&bytes)), &strips);
        check_triangles(&TriangleStrip::new(RestartIndices::new(&halves)), &strips);
        check_triangles(&TriangleStrip::new(RestartIndices::new(&words)), &strips);
        check_triangles(&TriangleFan::new(RestartIndices::new(&bytes)), &fans);
        check_triangles(&TriangleFan::new(RestartIndices::new(&halves)), &fans);
        check_triangles(&TriangleFan::new(RestartIndices::new(&words)), &fans);
        let plain: Vec<u32> = (0..bytes.len() as u32).collect();
        check_triangles(&TriangleStrip::new(Consecutive::new(plain.len())), &strip(&plain));
        check_triangles(&TriangleFan::new(Consecutive::new(plain.len())), &fan(&plain));
    }
}

#[test]
fn lists_have_their_triangles_in_order_and_nothing_of_what_is_left_over() {
    for vertices in 0..20_u32 {
        let plain: Vec<u32> = (0..vertices).collect();
        let triples = |all: &[u32]| -> Vec<_> {
            all.chunks_exact(3).map(|v| ([v[0], v[1], v[2]], v[0], v[2])).collect()
        };
        check_triangles(&List::new(vertices as usize), &triples(&plain));
        let backwards: Vec<u32> = plain.iter().rev().copied().collect();
        let bytes: Vec<u8> = backwards.iter().map(|i| *i as u8).collect();
        check_triangles(&IndexedList::new(&backwards), &triples(&backwards));
        check_triangles(&IndexedList::new(&bytes), &triples(&backwards));
    }
}

/// Lines, and which of them go on from the one before.
fn lines<T: Topology<Primitive = [u32; 2]>>(topology: &T) -> Vec<Chained> {
    let mut cursor = T::Cursor::default();
    let mut lines = Vec::new();
    while let Some((number, line)) = topology.next::<false>(&mut cursor) {
        assert_eq!(number as usize, lines.len(), "numbers");
        lines.push((line, topology.continues(&cursor)));
    }
    assert!(topology.next::<false>(&mut cursor).is_none(), "behind the last");
    assert_eq!(topology.count() as usize, lines.len(), "count");
    assert!(!T::LAST_PROVOKES && LastProvoking::<T>::LAST_PROVOKES, "conventions");
    assert!(LastProvoking(*topology).iter().eq(topology.iter()), "a line keeps its way");
    lines
}

#[test]
fn lines_and_points_are_those_of_their_vertices() {
    let mut random = Random::new(32);
    for _ in 0..4_000 {
        let bytes = indices(&mut random);
        for restarts in [false, true] {
            let parts = parts(&steps(&bytes, restarts));
            let chain = |part: &[u32]| -> Vec<_> {
                part.windows(2).enumerate().map(|(i, w)| ([w[0], w[1]], i > 0)).collect()
            };
            let ring = |part: &[u32]| {
                let mut lines = chain(part);
                if part.len() > 1 {
                    lines.push(([part[part.len() - 1], part[0]], true));
                }
                lines
            };
            let pairs = |part: &[u32]| -> Vec<_> {
                part.chunks_exact(2).map(|w| ([w[0], w[1]], false)).collect()
            };
            let all = |of: &dyn Fn(&[u32]) -> Vec<Chained>| -> Vec<Chained> {
                parts.iter().flat_map(|part| of(part)).collect()
            };
            let (list, strip, closed, points) = if restarts {
                let indices = RestartIndices::new(&bytes);
                let points: Vec<_> = Points::new(indices).iter().collect();
                assert_eq!(Points::new(indices).count() as usize, points.len(), "count");
                let strip = lines(&LineStrip::new(indices));
                (lines(&LineList::new(indices)), strip, lines(&LineLoop::new(indices)), points)
            } else {
                let indices = Indices::new(&bytes);
                let points: Vec<_> = Points::new(indices).iter().collect();
                assert_eq!(Points::new(indices).count() as usize, points.len(), "count");
                let strip = lines(&LineStrip::new(indices));
                (lines(&LineList::new(indices)), strip, lines(&LineLoop::new(indices)), points)
            };
            assert_eq!(list, all(&pairs), "list");
            assert_eq!(strip, all(&chain), "strip");
            assert_eq!(closed, all(&ring), "loop");
            let vertices: Vec<[u32; 1]> = parts.concat().into_iter().map(|v| [v]).collect();
            assert_eq!(points, vertices, "points");
        }
    }
}

#[test]
fn the_runtime_topology_agrees_with_the_types() {
    fn same<T: Topology<Primitive = [u32; 3]>>(any: AnyTopology<'_>, typed: T) {
        assert!(any.iter().eq(typed.iter()), "first provokes: {any:?}");
        let last = (LastProvoking(any), LastProvoking(typed));
        assert!(last.0.iter().eq(last.1.iter()), "last provokes: {any:?}");
        assert_eq!(any.count(), typed.count(), "count: {any:?}");
        assert!(any.count() > 0, "a topology without triangles proves nothing");
    }
    let bytes = [3_u8, 1, 2, 0, 255, 2, 1, 5, 6, 7];
    let halves = wide(&bytes, u16::MAX, u16::from);
    let words = wide(&bytes, u32::MAX, u32::from);
    same(AnyTopology::List(List::new(9)), List::new(9));
    same(AnyTopology::Indexed8(IndexedList::new(&bytes)), IndexedList::new(&bytes));
    same(AnyTopology::Indexed16(IndexedList::new(&halves)), IndexedList::new(&halves));
    same(AnyTopology::Indexed32(IndexedList::new(&words)), IndexedList::new(&words));
    let (all, small, large) =
        (Consecutive::new(9), Indices::new(&bytes[..4]), Indices::new(&halves[..4]));
    let (small_parts, large_parts) = (RestartIndices::new(&bytes), RestartIndices::new(&halves));
    same(AnyTopology::Strip(TriangleStrip::new(all)), TriangleStrip::new(all));
    same(AnyTopology::Strip8(TriangleStrip::new(small)), TriangleStrip::new(small));
    same(AnyTopology::Strip16(TriangleStrip::new(large)), TriangleStrip::new(large));
    let (parts8, parts16) = (TriangleStrip::new(small_parts), TriangleStrip::new(large_parts));
    same(AnyTopology::RestartStrip8(parts8), parts8);
    same(AnyTopology::RestartStrip16(parts16), parts16);
    same(AnyTopology::Fan(TriangleFan::new(all)), TriangleFan::new(all));
    same(AnyTopology::Fan8(TriangleFan::new(small)), TriangleFan::new(small));
    same(AnyTopology::Fan16(TriangleFan::new(large)), TriangleFan::new(large));
    let (parts8, parts16) = (TriangleFan::new(small_parts), TriangleFan::new(large_parts));
    same(AnyTopology::RestartFan8(parts8), parts8);
    same(AnyTopology::RestartFan16(parts16), parts16);
}
