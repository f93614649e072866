//! Triangles at the ends of what coordinates hold, each named.

use crate::coverage::{check_at, BOTTOM, ENDS, LEFT, PICTURE, RIGHT, TOP};
use crate::support::Random;
use microraster::raster::ScreenVertex;
use microraster::{Color, Flat, Frame, Rgb, Rgba8888, ScreenPass, Size, Stats};

/// Draws one triangle and counts.
fn count(size: Size, v: [(i32, i32); 3]) -> Stats {
    let mut pixels = vec![0; usize::from(size.width) * usize::from(size.height)];
    let mut frame = Frame::<Rgba8888>::new(&mut pixels, size).expect("it fits");
    let mut stats = Stats::default();
    let triangle = v.map(|(x, y)| (ScreenVertex::from_bits(x, y, 0), Color::from(Rgb::WHITE)));
    ScreenPass::new().count(&mut stats).triangle(&mut frame, &Flat::colored(), &triangle);
    stats
}

#[test]
fn triangles_without_area_are_counted_as_degenerate_and_draw_nothing() {
    let mut random = Random(81);
    for i in 0..20_000 {
        let any = |random: &mut Random| (random.range(LEFT, RIGHT), random.range(TOP, BOTTOM));
        let (a, b) = (any(&mut random), any(&mut random));
        // Three times a point, two points, and three points in a line.
        let middle = (a.0.midpoint(b.0), a.1.midpoint(b.1));
        let end = (2 * middle.0 - a.0, 2 * middle.1 - a.1);
        let v = match i % 3 {
            0 => [a, a, a],
            1 => [a, b, a],
            _ => [a, middle, end],
        };
        let stats = count(PICTURE, v);
        assert_eq!((stats.degenerate, stats.drawn, stats.pixels), (1, 0, 0), "{v:?}");
        assert_eq!(check_at(v), 0, "{v:?}");
    }
}

#[test]
fn a_triangle_of_the_least_area_covers_a_pixel_only_where_its_corner_is_a_centre() {
    let mut pixels = 0;
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
        for v in [
            [(x, y), (x + 1, y), (x, y + 1)],
            [(x, y), (x - 1, y), (x, y - 1)],
            [(x, y), (x + 1, y), (x + 1, y + 1)],
            [(x, y), (x + 1, y + 1), (x, y + 1)],
            [(x, y), (x + 131, y + 130), (x + 130, y + 129)],
        ] {
            pixels += check_at(v);
        }
    }
    assert!(pixels > 0, "none of them holds a centre");
}

#[test]
fn slivers_of_8192_pixels_a_subpixel_wide_are_right_at_every_height() {
    let mut pixels = 0;
    for y in TOP..=BOTTOM - 1 {
        // Off the picture but for a few: those beside it must leave it alone.
        if (y - 192).abs() < 220 || y % 97 == 0 {
            pixels += check_at([(LEFT, y), (RIGHT, y), (RIGHT, y + 1)]);
            pixels += check_at([(LEFT, y), (RIGHT, y + 1), (LEFT, y + 1)]);
        }
    }
    for x in LEFT..RIGHT - 1 {
        if (x - 256).abs() < 280 || x % 97 == 0 {
            pixels += check_at([(x, TOP), (x + 1, TOP), (x, BOTTOM)]);
        }
    }
    // From corner to corner, and every step of the far end.
    for step in 0..4_000 {
        pixels += check_at([(LEFT, TOP), (RIGHT, BOTTOM - step), (RIGHT, BOTTOM - step - 1)]);
        pixels += check_at([(RIGHT, TOP), (LEFT + step, BOTTOM), (LEFT + step + 1, BOTTOM)]);
    }
    assert!(pixels > 1_000, "{pixels} pixels are too few to mean much");
}

#[test]
fn vertices_on_pixel_centres_and_half_pixels_follow_the_top_left_rule() {
    // A square on centres owns its upper and left centres and not its lower and right ones.
    let square = |left: i32, top: i32, side: i32| {
        let [a, b, c, d] =
            [(left, top), (left + side, top), (left + side, top + side), (left, top + side)];
        check_at([a, b, c]) + check_at([a, c, d])
    };
    for offset in 0..16 {
        let expected = |centers: i32| (centers * centers) as u32;
        assert_eq!(square(16 * 4 + offset, 16 * 4 + offset, 16 * 5), expected(5), "at {offset}");
    }
    // Half a pixel on a side holds a centre in one place of four, on or left of and above it.
    for (x, y) in (0..32).flat_map(|y| (0..32).map(move |x| (x, y))) {
        let holds = |v: i32| (v..v + 8).any(|at| at.rem_euclid(16) == 8);
        let expected = u32::from(holds(x) && holds(y));
        assert_eq!(square(160 + x, 160 + y, 8), expected, "at {x}, {y}");
    }
}

#[test]
fn edges_through_corners_and_centres_of_pixels_are_right_in_every_direction() {
    let directions = (-24..=24).flat_map(|dy| (-24..=24).map(move |dx| (dx, dy)));
    for (dx, dy) in directions.filter(|direction| *direction != (0, 0)) {
        for through in [(256, 192), (264, 200), (256, 200), (260, 196)] {
            let at = |k: i32| (through.0 + k * dx, through.1 + k * dy);
            // To one side and the other of the same edge.
            check_at([at(-16), at(16), (through.0 - 7 * dy, through.1 + 7 * dx)]);
            check_at([at(-16), at(16), (through.0 + 7 * dy, through.1 - 7 * dx)]);
            let far = 2_600;
            check_at([at(-far), at(far), (through.0 - 9 * dy, through.1 + 9 * dx)]);
        }
    }
}

#[test]
fn corners_4096_pixels_away_are_drawn_and_one_subpixel_farther_skipped() {
    for size in [PICTURE, Size::new(1, 1), Size::new(7, 3), Size::new(300, 2)] {
        let (x, y) = (i32::from(size.width) * 8, i32::from(size.height) * 8);
        for (end, step) in [(65_536, 1), (-65_536, -1)] {
            for moved in [-1, 0, 1] {
                let out = end + moved * step;
                // Along one axis, along the other, along both.
                for far in [(x + out, y), (x, y + out), (x + out, y + out)] {
                    let stats = count(size, [(x - 24, y + 40), (x + 40, y - 24), far]);
                    let skipped = u32::from(moved > 0);
                    assert_eq!(stats.skipped, skipped, "{moved} beyond {end}: {size:?}");
                    let others = stats.drawn + stats.outside + stats.degenerate;
                    assert_eq!(others, 1 - skipped, "{moved} beyond {end}: {size:?}");
                }
            }
        }
    }
    // What is drawn there is right.
    for step in 0..300 {
        for (k, end) in ENDS.into_iter().enumerate() {
            let inward = |from: i32, middle: i32| from + step * (middle - from).signum();
            let near = (inward(end.0, 256), inward(end.1, 192));
            let opposite = ENDS[(k + 2) % 4];
            check_at([near, opposite, (256 + step, 192 - step)]);
        }
    }
}

#[test]
fn coordinates_of_any_bits_are_skipped_or_drawn_and_counted() {
    let mut random = Random(82);
    let hard = [i32::MIN, i32::MIN + 1, -65_537, -1, 0, 1, 65_537, i32::MAX - 1, i32::MAX];
    let number = |random: &mut Random| match random.range(0, 2) {
        0 => hard[random.range(0, 8) as usize],
        1 => random.next() as i32,
        _ => random.range(0, 500),
    };
    for _ in 0..50_000 {
        let v = [0; 3].map(|_: i32| (number(&mut random), number(&mut random)));
        let stats = count(PICTURE, v);
        let sum = stats.skipped + stats.degenerate + stats.outside + stats.drawn;
        assert_eq!((stats.triangles, sum), (1, 1), "{v:?}");
    }
}
