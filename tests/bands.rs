//! `Bands`: how many rows fit, what is handed out when, and that it is the whole frame's picture.
#![cfg(feature = "std")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "random numbers are cut to what is wanted"
)]
#![allow(dead_code, reason = "the scenes serve other programs too")]

#[path = "support/choices.rs"]
mod choices;
#[path = "support/repertoire.rs"]
mod repertoire;
#[path = "support/scene_parts.rs"]
mod scene_parts;
#[path = "../examples/scenes/mod.rs"]
mod scenes;
mod support;

use microraster::math::{AngleUnits, Mat4, Vec3};
use microraster::texture::{Bilinear, MipMap, MipSampler, Nearest, Repeat};
use microraster::{
    Adaptive, AnyDepthState, AnyStencil, Band, Bands, Camera, Consecutive, Damage, DisplayList,
    Every, Exact, FrameError, Less, ListTriangle, ListVertex, Mesh, Pass, Rect, Rgb, Rgb565,
    Shader, Size, Stenciled, Textured, TriangleStrip, VertexCache,
};
use repertoire::{check_bands, Scene};
use scenes::golden::render::render;
use scenes::golden::{pictures, Picture};
use support::Random;

const PICTURE: Size = Size::new(64, 48);

/// How many rows fit into buffers of so many pixels and codes.
fn rows(picture: Size, pixels: usize, codes: usize) -> Result<(u16, u16), FrameError> {
    let (mut pixels, mut codes) = (vec![0; pixels], vec![0; codes]);
    let bands = Bands::<Rgb565>::new(&mut pixels, picture)?.with_depth(&mut codes)?;
    Ok((bands.rows(), bands.count()))
}

#[test]
fn as_many_whole_rows_fit_as_the_shortest_buffer_holds() {
    assert_eq!(rows(PICTURE, 64 * 7 + 63, 64 * 9), Ok((7, 7)), "colour decides");
    assert_eq!(rows(PICTURE, 64 * 16, 64 * 5), Ok((5, 10)), "depth decides");
    assert_eq!(rows(PICTURE, 64 * 100, 64 * 100), Ok((48, 1)), "no more than there are");
    assert_eq!(rows(PICTURE, 64, 64), Ok((1, 48)), "one row");
    assert_eq!(rows(Size::new(8192, 8192), 8192, 8192), Ok((1, 8192)), "the largest picture");
}

#[test]
fn buffers_without_a_row_and_pictures_that_are_none_are_refused() {
    let short = Err(FrameError::Color { needed: 64, got: 63 });
    assert_eq!(rows(PICTURE, 63, 64), short, "a pixel is missing");
    let short = Err(FrameError::Depth { needed: 64, got: 0 });
    assert_eq!(rows(PICTURE, 64, 0), short, "no codes at all");
    assert_eq!(rows(Size::new(0, 48), 64, 64), Err(FrameError::Empty), "no columns");
    assert_eq!(rows(Size::new(64, 0), 64, 64), Err(FrameError::Empty), "no rows");
    assert_eq!(
        rows(Size::new(8193, 1), 9000, 9000),
        Err(FrameError::TooLarge { got: 8193 }),
        "wide"
    );
    assert_eq!(rows(Size::new(1, 8193), 64, 64), Err(FrameError::TooLarge { got: 8193 }), "tall");
    let mut pixels = vec![0; 64];
    let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE);
    let refused = bands.and_then(|bands| bands.with_stencil(&mut [0; 20]).map(|_| ())).err();
    assert_eq!(refused, Some(FrameError::Stencil { needed: 64, got: 20 }), "stencil");
}

#[test]
fn a_cropped_band_holds_what_lies_in_the_area_and_says_where() {
    let mut random = Random(0xC409);
    for case in 0..2000 {
        let size = Size::new(random.range(1, 9) as u16, random.range(1, 9) as u16);
        let mut buffer: Vec<u16> = (0..size.width * size.height + 5).collect();
        let rows = random.range(1, size.height.into()) as u16;
        let mut bands = Bands::<Rgb565>::new(&mut buffer, size).expect("a whole frame");
        bands = bands.rows_at_most(rows);
        let number = random.range(0, i32::from(bands.count()) - 1) as u16;
        let mut band = bands.draw_band(number, |_| ()).expect("there is such a band");
        let area = band.area();
        let mut expected = band.pixels().to_vec();
        let mut kept = area;
        for _ in 0..2 {
            let mut side = |past: i32| random.range(-2, past + 2);
            let (left, top) = (side(area.right), side(area.bottom));
            let right = left + side(area.right);
            let to = Rect::new(left, top, right, top + side(area.bottom));
            let before = kept;
            kept = kept.intersection(to);
            let columns = before.width() as usize;
            expected = expected
                .iter()
                .enumerate()
                .filter(|(i, _)| {
                    let (x, y) = ((i % columns.max(1)) as i32, (i / columns.max(1)) as i32);
                    kept.contains(before.left + x, before.top + y)
                })
                .map(|(_, raw)| *raw)
                .collect();
            band.crop(to);
            if kept.is_empty() {
                kept = Rect::new(before.left, before.top, before.left, before.top);
            }
            assert_eq!(band.area(), kept, "case {case}: {to:?} of {before:?}");
            assert_eq!(band.pixels(), expected, "case {case}: {to:?} of {before:?}");
            assert_eq!(band.as_bytes().len(), expected.len() * 2, "two bytes a pixel");
        }
    }
}

#[test]
fn areas_as_far_as_numbers_reach_leave_a_band_what_they_share_with_it() {
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, 2, 5, 8191, 8192, i32::MAX - 1, i32::MAX];
    let mut random = Random(0xE4D5);
    let mut buffer = vec![0; 8192 * 2];
    for size in [(1, 8192), (8192, 1), (2, 8192), (3, 5)] {
        for case in 0..300 {
            let size = Size::new(size.0, size.1);
            let bands = Bands::<Rgb565>::new(&mut buffer, size).expect("the buffer fits");
            let mut bands = bands.rows_at_most(random.range(0, 65_535) as u16);
            let number = random.range(0, i32::from(bands.count()) - 1) as u16;
            let mut end = || ends[random.range(0, 10) as usize];
            let (area, scissor) =
                (Rect::new(end(), end(), end(), end()), Rect::new(end(), end(), end(), end()));
            let mut damage = Damage::new(Size::new(0, 0));
            damage.add(area);
            let whole = bands.area(number);
            let drawn = bands.draw_band(number, |frame| {
                frame.set_scissor(scissor);
                frame.clear(Rgb::RED);
            });
            let mut band = drawn.expect("there is such a band");
            assert_eq!(band.area(), whole, "case {case}");
            band.crop(damage.area());
            let shared = whole.intersection(area);
            let pixels = shared.width() as usize * shared.height() as usize;
            assert_eq!(band.pixels().len(), pixels, "case {case}: {area:?}");
            assert!(shared.is_empty() || band.area() == shared, "case {case}: {area:?}");
        }
    }
}

#[test]
fn two_buffers_in_turn_hold_the_same_bands_and_never_the_same_one_twice() {
    let scene = |frame: &mut microraster::Frame<'_, Rgb565>| {
        frame.clear(microraster::Rgb::new(1, 2, 3));
        frame.set_scissor(Rect::new(5, 7, 40, 33));
        frame.clear(microraster::Rgb::new(200, 100, 50));
    };
    for rows in [1, 7, 16, 48] {
        let (mut one, mut two, mut three) =
            (vec![0; 64 * rows], vec![0; 64 * rows], vec![0; 64 * rows]);
        let mut expected = Vec::new();
        let mut bands = Bands::<Rgb565>::new(&mut three, PICTURE).expect("a row fits");
        bands
            .draw(scene, |band| {
                expected.extend_from_slice(band.pixels());
                Ok::<(), FrameError>(())
            })
            .expect("nobody refuses");
        let mut bands = Bands::<Rgb565>::new(&mut one, PICTURE).expect("a row fits");
        let mut spare = Some(&mut two[..]);
        for _picture in 0..2 {
            let (mut sent, mut flying) = (Vec::new(), None::<Band<'_, Rgb565>>);
            bands
                .draw_double_buffered(scene, |band| {
                    assert_eq!(
                        band.first_row() as usize,
                        sent.len() / 64 + {
                            flying.as_ref().map_or(0, |band| band.size().height as usize)
                        }
                    );
                    let free = match flying.replace(band) {
                        Some(band) => {
                            sent.extend_from_slice(band.pixels());
                            band.into_buffer()
                        }
                        None => spare.take().expect("at the beginning there is one"),
                    };
                    // What is handed back may hold anything.
                    free.fill(0xDEAD);
                    Ok::<_, FrameError>(free)
                })
                .expect("buffers suffice");
            let last = flying.expect("the last band");
            sent.extend_from_slice(last.pixels());
            spare = Some(last.into_buffer());
            assert!(sent == expected, "{rows} rows");
        }
    }
}

#[test]
fn a_buffer_that_is_too_short_or_missing_is_an_error_and_no_picture() {
    let (mut one, mut two, mut short) = ([0; 64 * 8], [0; 64 * 8], [0; 64 * 8 - 1]);
    let mut bands = Bands::<Rgb565>::new(&mut one, PICTURE).expect("eight rows");
    let too_short = FrameError::Color { needed: 64 * 8, got: 64 * 8 - 1 };
    assert_eq!(bands.swap_buffer(&mut short[..]).err(), Some(too_short), "not taken");
    assert!(bands.draw_band(0, |_| ()).is_some(), "the buffer before is still there");
    let mut drawn = 0;
    let result = bands.draw_double_buffered(|_| drawn += 1, |_band| Ok::<_, FrameError>(&mut []));
    assert_eq!(result, Err(FrameError::Color { needed: 64 * 8, got: 0 }), "an empty one back");
    assert_eq!(drawn, 1, "no further band");
    assert!(bands.draw_band(0, |_| ()).is_none(), "there is no buffer");
    let result =
        bands.draw_double_buffered(|_| drawn += 1, |band| Ok::<_, FrameError>(band.into_buffer()));
    assert_eq!(result, Err(FrameError::Color { needed: 64 * 8, got: 0 }), "still none");
    assert_eq!(drawn, 1, "nothing drawn for nobody");
    assert_eq!(bands.swap_buffer(&mut two[..]).map(|before| before.len()), Ok(0), "a new one");
    assert!(bands.draw_band(5, |_| ()).is_some_and(|band| band.pixels().len() == 512), "as ever");
}

#[test]
fn bands_come_from_the_top_and_an_error_of_the_sender_ends_them() {
    let mut pixels = vec![0; 64 * 10];
    let mut bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("ten rows");
    let (mut drawn, mut sent) = (Vec::new(), Vec::new());
    let result = bands.draw(
        |frame| drawn.push((frame.first_row(), frame.size(), frame.picture())),
        |band| {
            assert_eq!(band.pixels().len(), 64 * usize::from(band.size().height), "no gaps");
            sent.push((band.first_row(), band.size().height));
            if band.first_row() == 30 {
                Err("the cable fell out")
            } else {
                Ok(())
            }
        },
    );
    assert_eq!(result, Err("the cable fell out"), "passed through");
    assert_eq!(sent, [(0, 10), (10, 10), (20, 10), (30, 10)], "in order, none after the error");
    assert_eq!(drawn.len(), 4, "none is drawn for nothing");
    assert!(drawn.iter().all(|(_, _, picture)| *picture == PICTURE), "{drawn:?}");
    let last = bands.draw_band(4, |_| ()).map(|band| (band.first_row(), band.size().height));
    assert_eq!(last, Some((40, 8)), "what is left");
    assert!(bands.draw_band(5, |_| ()).is_none(), "there are five");
    assert!(bands.draw_band(u16::MAX, |_| ()).is_none(), "far beyond");
    let first = bands.draw_band(0, |_| ()).map(|band| (band.first_row(), band.size().height));
    assert_eq!(first, Some((0, 10)), "again, in full height");
}

#[test]
fn a_scissor_lasts_for_one_band() {
    let mut pixels = vec![0; 64 * 16];
    let mut bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("sixteen rows");
    let mut reach = Vec::new();
    let Ok::<(), ()>(()) = bands.draw(
        |frame| {
            reach.push(frame.scissor());
            frame.set_scissor(Rect::new(3, 3, 5, 5));
        },
        |_| Ok(()),
    ) else {
        unreachable!("nothing fails")
    };
    let whole = [0, 16, 32].map(|top| Rect::new(0, top, 64, top + 16));
    assert_eq!(reach, whole, "each begins with all of its rows");
}

/// Heights of bands: single rows, odd ones, what displays like, and all of them.
const HEIGHTS: [u16; 8] = [1, 2, 3, 5, 7, 16, 17, 240];

#[test]
fn golden_pictures_are_the_same_in_bands_of_any_height() {
    let pixels = |picture: &Picture| {
        let (mut color, mut depth) = (vec![0u32; scenes::ROOM], vec![0u16; scenes::ROOM]);
        let written = render(&mut color, &mut depth, picture);
        assert!(written.skipped == 0 && written.pixels > 0, "{}", picture.name);
        color
    };
    for picture in pictures() {
        let whole = pixels(picture);
        for rows in HEIGHTS {
            let banded = pixels(&Picture { band: rows, ..*picture });
            assert!(whole == banded, "{} in bands of {rows}", picture.name);
        }
    }
}

#[test]
fn random_scenes_are_the_same_through_bands() {
    let (mut random, mut pixels) = (Random(29), 0);
    for number in 0..3000 {
        let scene = Scene::new(Random(random.next()));
        let rows = match number % 4 {
            0 => 1 + (random.next() >> 13) as u16 % scene.size.height,
            _ => HEIGHTS[number / 4 % HEIGHTS.len()],
        };
        pixels += check_bands::<Rgb565, Stenciled<AnyDepthState, AnyStencil>, _>(&scene, rows);
    }
    assert!(pixels > 300_000, "{pixels} pixels are too few");
}

/// Texels along each side of the largest picture.
const SIDE: u16 = 64;

/// The pictures of a mip-map, each in a colour of its own: which one was chosen is what is seen.
fn mips() -> Vec<u16> {
    let (mut texels, mut side) = (Vec::new(), SIDE);
    while side > 0 {
        let color = [0xF800, 0x07E0, 0x001F, 0xFFE0, 0xF81F, 0x07FF, 0xFFFF];
        let texel = color[side.trailing_zeros() as usize];
        texels.extend((0..side * side).map(|i| texel ^ (i % 3)));
        side /= 2;
    }
    texels
}

/// Draws a floor up to the horizon, whole and in bands, drawn again and recorded.
fn check_floor(shader: &impl Shader<Vertex = ((), [i16; 2])>, random: &mut Random) -> usize {
    let corners = [[-100i16, 0, -100], [100, 0, -100], [-100, 0, 100], [100, 0, 100]];
    let places = [[0, 0], [9000, 0], [0, 9000], [9000, 9000i16]].map(|place| ((), place));
    let floor = Mesh::new(&corners, &places).with_topology(TriangleStrip::new(Consecutive::new(4)));
    let mut unit = || random.unit() as f32 - 0.5;
    let eye = Vec3::new(unit() * 90.0, 2.0 + 20.0 * (unit() + 0.5), unit() * 90.0);
    let camera = Camera::perspective(60.0.degrees(), 0.5).look_at(
        eye,
        Vec3::new(unit() * 200.0, 0.0, unit() * 200.0),
        Vec3::new(unit(), 1.0, unit()),
    );
    let model = Mat4::identity();
    let draw = |rows: u16, records: bool| {
        let length = 64 * usize::from(rows);
        let (mut pixels, mut codes) = (vec![0; length], vec![0; length]);
        let bands = Bands::<Rgb565>::new(&mut pixels, PICTURE).expect("rows fit");
        let mut bands = bands.with_depth(&mut codes).expect("rows fit");
        let (mut vertices, mut triangles) =
            (vec![ListVertex::default(); 64], vec![ListTriangle::BLANK; 64]);
        let mut numbers = [0; 48];
        let mut cache = VertexCache::<u16, 4>::new();
        let list = DisplayList::new(&mut vertices, &mut triangles, &mut numbers);
        let mut pass = Pass::new(&camera).depth(Less);
        let mut recording = pass.record(list, PICTURE, &model, &floor, shader, &mut cache);
        let mut sent = Vec::new();
        let drawn = bands.draw::<FrameError>(
            |frame| {
                frame.clear(Rgb::BLACK);
                if records {
                    pass.replay(frame, &mut recording).expect("made for this picture");
                } else {
                    pass.draw(frame, &model, &floor, shader);
                }
            },
            |band| {
                sent.extend_from_slice(band.pixels());
                Ok(())
            },
        );
        assert_eq!(drawn, Ok(()), "nothing fails");
        sent
    };
    let whole = draw(PICTURE.height, false);
    for rows in HEIGHTS.map(|rows| rows.min(PICTURE.height)) {
        for records in [false, true] {
            assert!(draw(rows, records) == whole, "{rows} rows from {eye:?}, recorded: {records}");
        }
    }
    let mut seen: Vec<u16> = whole.iter().map(|texel| texel & 0x8410).collect();
    seen.sort_unstable();
    seen.dedup();
    seen.len()
}

#[test]
fn mip_maps_choose_the_same_picture_in_bands() {
    let texels = mips();
    let mips = MipMap::<Rgb565>::new(&texels, SIDE, SIDE).expect("all pictures are there");
    let nearest = MipSampler::new(mips, Nearest, Repeat, Repeat).unit_bits(8);
    let bilinear = MipSampler::new(mips, Bilinear, Repeat, Repeat).unit_bits(8);
    let (mut random, mut colours) = (Random(0x31B), 0);
    for _ in 0..40 {
        let r = &mut random;
        colours += check_floor(&Textured::new(nearest), r);
        colours += check_floor(&Textured::new(nearest).perspective(Every::<8>), r);
        colours += check_floor(&Textured::new(bilinear).perspective(Adaptive), r);
        colours += check_floor(&Textured::new(bilinear).perspective(Exact), r);
    }
    // Black beside the floor, and more than one picture of the map on it.
    assert!(colours > 3 * 160, "{colours} colours are too few");
}
