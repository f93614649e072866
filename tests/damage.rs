//! `Damage`: what changed is within it, and it is no larger than what was drawn.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "pixels of a small picture, random numbers"
)]

mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::models::TEAPOT;
use microraster::raster::ScreenVertex;
use microraster::{
    Bands, Camera, Color, Cull, Damage, DisplayList, Flat, Frame, Gouraud, Less, Light,
    ListTriangle, ListVertex, Pass, Rect, Rgb, Rgb565, ScreenPass, Size, Stats, Thin, VertexCache,
};
use support::Random;

const PICTURE: Size = Size::new(64, 48);

/// The smallest rectangle that holds all pixels of some colour.
fn box_of(pixels: &[u16], is_wanted: impl Fn(usize, u16) -> bool) -> Rect {
    let width = usize::from(PICTURE.width);
    let wanted = pixels.iter().enumerate().filter(|(i, raw)| is_wanted(*i, **raw));
    let one = |i: usize| {
        let (x, y) = ((i % width) as i32, (i / width) as i32);
        Rect::new(x, y, x + 1, y + 1)
    };
    wanted.map(|(i, _)| one(i)).fold(Rect::default(), Rect::union)
}

#[test]
fn a_lone_primitive_damages_the_box_of_its_pixels() {
    let mut random = Random(0xDA3A);
    for case in 0..3000 {
        let mut corner = || {
            let (x, y) = (random.range(-300, 1300), random.range(-300, 1100));
            (ScreenVertex::from_bits(x, y, 0), Color::new(255, 255, 255))
        };
        let corners = [corner(), corner(), corner()];
        let mut pixels = [0u16; 64 * 48];
        let mut frame = Frame::<Rgb565>::new(&mut pixels, PICTURE).expect("the buffer fits");
        let (mut damage, mut stats) = (Damage::new(Size::new(0, 0)), Stats::default());
        let mut pass = ScreenPass::new().count(&mut stats).track_damage(&mut damage);
        match case % 3 {
            0 => pass.triangle(&mut frame, &Flat::colored(), &corners),
            1 => pass.lines(&mut frame, &Flat::colored(), Thin, &[[corners[0], corners[1]]]),
            _ => pass.points(&mut frame, &Flat::colored(), 9, &corners[..1]),
        }
        let expected = box_of(&pixels, |_, raw| raw != 0);
        assert_eq!(damage.next_picture(), expected, "{corners:?}");
        assert_eq!(stats.pixels > 0, !expected.is_empty(), "counted beside it");
    }
}

/// A teapot that comes and goes.
fn turned(step: i32) -> Mat4 {
    Mat4::translation(Vec3::new(step as f32 - 6.0, 0.0, 0.0))
        * Mat4::rotation_y((step as f32 * 30.0).degrees())
}

/// The display that is sent only what changed holds the picture, and how much was sent.
#[test]
fn a_display_that_is_sent_only_damage_shows_each_picture() {
    let camera = Camera::perspective(45.0.degrees(), 0.5).look_at(
        Vec3::new(0.0, 2.0, 9.0),
        Vec3::ZERO,
        Vec3::Y,
    );
    let sun = Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE);
    let shader = Gouraud::lit(&[sun]);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let background = Rgb::new(16, 24, 48);
    let (mut by_tracking, mut by_bounds) = ([0u16; 64 * 48], [0u16; 64 * 48]);
    let (mut tracked, mut bounded) = (Damage::new(PICTURE), Damage::new(PICTURE));
    let (mut sent, mut drawn_bands) = (0, 0);
    let (mut pixels, mut depth) = ([0; 64 * 7], [0; 64 * 7]);
    let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("rows fit");
    let mut bands = bands.with_depth(&mut depth).expect("rows fit");
    let (mut vertices, mut triangles) = ([ListVertex::default(); 900], [ListTriangle::BLANK; 900]);
    let mut numbers = [0; 7];
    for step in 0..14 {
        let model = turned(step);
        let (mut whole, mut codes) = (vec![0; 64 * 48], vec![0; 64 * 48]);
        let frame = Frame::<Rgb565>::new(&mut whole, PICTURE).expect("the buffer fits");
        let mut frame = frame.with_depth(&mut codes).expect("the buffer fits");
        frame.clear(background);
        pass.draw(&mut frame, &model, &TEAPOT, &shader);

        // Drawn in each band, and cut to what changed.
        for number in 0..bands.count() {
            let drawn = bands.draw_band(number, |frame| {
                frame.clear(background);
                let mut pass = pass.track_damage(&mut tracked);
                pass.draw(frame, &model, &TEAPOT, &shader);
            });
            let mut band = drawn.expect("there is such a band");
            band.crop(tracked.area());
            sent += band.pixels().len();
            show(&band, &mut by_tracking);
        }
        tracked.next_picture();
        assert!(by_tracking[..] == whole, "picture {step} by tracking");

        // Recorded, so that it is known before a band is drawn.
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
        let mut cache = VertexCache::<u16, 512>::new();
        let mut recording = pass.record(list, PICTURE, &model, &TEAPOT, &shader, &mut cache);
        let expected = box_of(&whole, |i, _| codes[i] != 0);
        assert_eq!(recording.bounds().union(expected), recording.bounds(), "picture {step}");
        let slack = |bound: i32, exact: i32| bound.abs_diff(exact) <= 1;
        let Rect { left, top, right, bottom } = recording.bounds();
        assert!(
            expected.is_empty()
                || slack(left, expected.left) && slack(right, expected.right)
                || left == 0
                || right == 64,
            "picture {step}: {expected:?} in {left} {top} {right} {bottom}"
        );
        bounded.add(recording.bounds());
        let changed = bounded.next_picture();
        for number in 0..bands.count() {
            if bands.area(number).intersection(changed).is_empty() {
                continue;
            }
            drawn_bands += 1;
            let drawn = bands.draw_band(number, |frame| {
                frame.clear(background);
                pass.replay(frame, &mut recording).expect("the list fits the picture");
            });
            let mut band = drawn.expect("there is such a band");
            band.crop(changed);
            show(&band, &mut by_bounds);
        }
        assert!(by_bounds[..] == whole, "picture {step} by bounds");
    }
    assert!(sent < 14 * 64 * 48 / 2, "{sent} pixels were sent");
    assert!(drawn_bands < 14 * 7 * 3 / 4, "{drawn_bands} bands were drawn");
}

#[test]
fn replayed_meshes_are_tracked_as_drawn_ones_are() {
    let camera = Camera::perspective(45.0.degrees(), 0.5);
    let shader = Gouraud::lit(&[Light::directional(Vec3::new(-0.3, -0.6, -1.0), Rgb::WHITE)]);
    let mut pass = Pass::new(&camera).cull(Cull::Back).depth(Less);
    let mut random = Random(0x4E91);
    let (mut seen, mut too_short) = (0, 0);
    for case in 0..60 {
        // Also beside the picture, and through the near plane.
        let mut side = |low, high| random.range(low, high) as f32 / 10.0;
        let model = Mat4::translation(Vec3::new(side(-40, 40), side(-30, 30), side(-80, 10)));
        let room = random.range(0, 900) as usize;
        let mut vertices = vec![ListVertex::default(); room];
        let mut triangles = vec![ListTriangle::BLANK; room];
        let (mut numbers, mut cache) = ([0; 48], VertexCache::<u16, 64>::new());
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
        let mut recording = pass.record(list, PICTURE, &model, &TEAPOT, &shader, &mut cache);
        let rows = random.range(1, 48) as usize;
        let [drawn, replayed, shared] = [0, 1, 2].map(|way| {
            let (mut pixels, mut depth) = (vec![0; 64 * rows], vec![0; 64 * rows]);
            let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("rows fit");
            let mut bands = bands.with_depth(&mut depth).expect("rows fit");
            let mut damage = Damage::new(Size::new(0, 0));
            for number in 0..bands.count() {
                bands.draw_band(number, |frame| {
                    frame.clear(Rgb::BLACK);
                    let mut pass = pass.track_damage(&mut damage);
                    match way {
                        1 => {
                            pass.replay_or_draw(frame, &mut recording, &model, &TEAPOT, &shader);
                        }
                        2 if recording.check().is_ok() => {
                            pass.replay_shared(frame, &recording).expect("recorded for it");
                        }
                        _ => pass.draw(frame, &model, &TEAPOT, &shader),
                    }
                });
            }
            damage.next_picture()
        });
        assert_eq!((drawn, drawn), (replayed, shared), "case {case}");
        let bounds = recording.bounds();
        assert_eq!(bounds.union(drawn), bounds, "case {case}");
        too_short += u32::from(recording.check().is_err());
        seen += u32::from(!drawn.is_empty());
    }
    assert!(seen > 20 && too_short > 5, "{seen} in sight, {too_short} in lists too short");
}

/// Puts a band where a display has it.
fn show(band: &microraster::Band<'_, Rgb565>, display: &mut [u16]) {
    let area = band.area();
    for (row, y) in band.pixels().chunks(area.width().max(1) as usize).zip(area.top..) {
        let at = (y * 64 + area.left) as usize;
        display[at..at + row.len()].copy_from_slice(row);
    }
}
