//! What is projected in place has the bits of what is projected with all questions asked.

#![allow(clippy::cast_possible_truncation, reason = "numbers are cut to what is wanted")]

use super::Mapping;
use crate::frame::{Size, MAX_SIDE};
use crate::math::hard_numbers::Random;
use crate::pipeline::assembly::{area_by_coordinates, area_by_sides, area_of};
use crate::pipeline::projected::{flag, Projected, RAISED};
use crate::pipeline::transform::Depth;
use crate::pipeline::Clip;
use crate::raster::first_center;

/// Any viewport: small ones, long ones and large ones.
fn any_size(random: &mut Random) -> Size {
    let mut side = || {
        let bits = random.word() % 14;
        u16::try_from(random.word() % (1 << bits) + 1).unwrap_or(1).min(MAX_SIDE)
    };
    Size::new(side(), side())
}

/// Depth from w with any near distance, or from a row of the matrix.
fn any_depth(random: &mut Random) -> Depth {
    let near = f32::from_bits((97 + random.word() % 70) << 23 | random.word() >> 9);
    match random.word() % 4 {
        0 => Depth::of_row(false),
        1 => Depth::of_row(true),
        _ => Depth::of_w(near).unwrap_or(Depth::of_row(true)),
    }
}

/// Any position, most of them in view or at its ends.
fn any_clip(random: &mut Random, depth: &Depth) -> Clip {
    let w = (random.word().cast_signed() >> 2) >> (random.word() % 31);
    let w = if random.word().is_multiple_of(8) { w } else { w.max(depth.w_min) };
    let mut coordinate = || match random.word() % 8 {
        0 => random.word().cast_signed() >> 2,
        1 => w.wrapping_add((random.word() % 5).cast_signed() - 2),
        2 => w.wrapping_neg().wrapping_add((random.word() % 5).cast_signed() - 2),
        _ => ((i64::from(random.word().cast_signed()) * i64::from(w)) >> 31) as i32,
    };
    let [x, y, z] = [coordinate(), coordinate(), coordinate()];
    let limited = |v: i32| v.clamp(1 - Clip::LIMIT, Clip::LIMIT - 1);
    let z = if depth.is_row() { limited(z) } else { 0 };
    Clip { x: limited(x), y: limited(y), z, w: limited(w) }
}

fn project(mapping: &Mapping, clip: &Clip) -> Projected {
    mapping.project([clip.x, clip.y, clip.w], || clip.z)
}

#[test]
fn a_vertex_in_view_has_the_bits_of_any_vertex() {
    let mut random = Random::new(31);
    let (mut in_view, mut beside) = (0, 0);
    for _ in 0..20_000 {
        let (size, depth) = (any_size(&mut random), any_depth(&mut random));
        let mapping = Mapping::new(0, 0, size, depth);
        for _ in 0..50 {
            let clip = any_clip(&mut random, &depth);
            let (one, other) = (project(&mapping, &clip), mapping.project_any(&clip));
            assert_eq!(one, other, "{clip:?} by {mapping:?}");
            if one.flags() & flag::ANY == 0 {
                // Edges through it reach no centre beyond the viewport.
                let place = mapping.place(&one);
                for (bits, side) in [(place.x_bits(), size.width), (place.y_bits(), size.height)] {
                    assert!(
                        (0..=side.into()).contains(&first_center(bits)),
                        "{clip:?} by {mapping:?}"
                    );
                }
                in_view += 1;
            } else {
                beside += 1;
            }
        }
    }
    assert!(in_view > 200_000 && beside > 200_000, "{in_view} in view, {beside} beside");
}

#[test]
fn raised_coordinates_are_those_of_words() {
    let ends = [i16::MIN, -1, 0, 1, i16::MAX];
    let all = (i16::MIN..=i16::MAX).flat_map(|one| ends.map(|end| [(one, end), (end, one)]));
    for (x, y) in all.flatten() {
        let vertex = Projected::new(x.into(), y.into(), 0, 0);
        let (raised_x, raised_y) = vertex.raised();
        assert_eq!((raised_x - RAISED, raised_y - RAISED), (x.into(), y.into()));
    }
}

#[test]
fn areas_in_view_fit_into_32_bits() {
    let mut random = Random::new(32);
    let mut compared = 0;
    for round in 0..20_000 {
        // The largest that are not large, and any.
        let size = match round % 4 {
            0 => Size::new(4094, 1024),
            1 => Size::new(1024, 4094),
            2 => Size::new(2048, 2048),
            _ => any_size(&mut random),
        };
        let mapping = Mapping::new(0, 0, size, Depth::of_row(true));
        let corners = [0; 3].map(|_: i32| {
            // Most at the very ends of the view.
            let w = 1 << 29;
            let mut end = || match random.word() % 3 {
                0 => w,
                1 => -w,
                _ => (i64::from(random.word().cast_signed()) >> 2) as i32,
            };
            project(&mapping, &Clip { x: end(), y: end(), z: w / 2, w })
        });
        let [a, b, c] = &corners;
        if (a.flags() | b.flags() | c.flags()) & flag::ANY == 0 {
            for area in [area_by_sides(&corners), area_by_coordinates(&corners)] {
                assert_eq!(i64::from(area), area_of(&corners), "{corners:?}");
            }
            compared += 1;
        }
    }
    assert!(compared > 10_000, "{compared}");
}

#[test]
fn a_point_has_the_place_of_any_point_unless_both_are_far_beside() {
    let mut random = Random::new(35);
    let (mut near, mut far) = (0, 0);
    for _ in 0..20_000 {
        let (size, depth) = (any_size(&mut random), any_depth(&mut random));
        let mapping = Mapping::new(-77, 500, size, depth);
        for _ in 0..50 {
            let clip = any_clip(&mut random, &depth);
            let (z, easy_w) = (|| clip.z, mapping.easy_w());
            let one = mapping.inlined_point([clip.x, clip.y, clip.w], z, easy_w);
            let other = mapping.point(&clip);
            assert_eq!(one.is_some(), other.is_some(), "{clip:?} by {mapping:?}");
            let (one, other) = (one.unwrap_or_default(), other.unwrap_or_default());
            let offsets = [
                (one.x_bits() - mapping.center_x, other.x_bits() - mapping.center_x),
                (one.y_bits() - mapping.center_y, other.y_bits() - mapping.center_y),
            ];
            for (one, other) in offsets {
                assert_eq!(one.clamp(-(1 << 20), 1 << 20), other, "{clip:?} by {mapping:?}");
                assert!(one.abs() <= 1 << 28, "no sum overflows");
                *(if one == other { &mut near } else { &mut far }) += 1;
            }
            assert_eq!(one.z, other.z, "{clip:?} by {mapping:?}");
        }
    }
    assert!(near > 500_000 && far > 200, "{near} near, {far} far");
}
