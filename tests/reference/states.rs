//! Tests and blending of fragments, of random states, against the crate: two ways to the same
//! definitions.

use fixed::types::I8F8;
use microraster::host::reference::{
    DepthPrecision, Draw, Interpolation, Kind, Reference, Snap, Space, State, Vertex,
};
use microraster::raster::ScreenVertex;
use microraster::{
    AnyBlend, AnyCompare, AnyDepth, AnyDepthState, AnyMask, AnyOperation, Color, Cull, Flat, Frame,
    Rect, Rgb, Rgba8888, ScreenPass, Size, Stencil, Stenciled, Winding,
};

use crate::stencil_states::{COMPARES, OPERATIONS};
use crate::support::Random;

const SIZE: Size = Size::new(24, 20);
const PIXELS: usize = 24 * 20;

fn one_of<T: Copy>(random: &mut Random, all: &[T]) -> T {
    all[random.next() as usize % all.len()]
}

fn is_rare(random: &mut Random) -> bool {
    random.next().is_multiple_of(4)
}

const TESTS: [AnyDepth; 8] = [
    AnyDepth::Off,
    AnyDepth::Always,
    AnyDepth::Less,
    AnyDepth::LessEqual,
    AnyDepth::Equal,
    AnyDepth::Greater,
    AnyDepth::GreaterEqual,
    AnyDepth::NotEqual,
];

const BLENDS: [AnyBlend; 7] = [
    AnyBlend::Alpha,
    AnyBlend::ConstantAlpha(77),
    AnyBlend::Premultiplied,
    AnyBlend::Add,
    AnyBlend::Multiply,
    AnyBlend::Subtract,
    AnyBlend::Average,
];

fn any_state(random: &mut Random) -> State {
    // Few different values, so that equal ones meet.
    let byte = |random: &mut Random| one_of(random, &[0, 1, 2, 3, 254, 255]);
    let bits = |random: &mut Random| one_of(random, &[255, 255, 1, 0x55]);
    let stencil = Stencil::new(one_of(random, &COMPARES), byte(random))
        .on_fail(one_of(random, &OPERATIONS))
        .on_depth_fail(one_of(random, &OPERATIONS))
        .on_pass(one_of(random, &OPERATIONS))
        .read_mask(bits(random))
        .write_mask(bits(random));
    let [left, top] = [0, 1].map(|_| random.range(-2, 12));
    State {
        cull: one_of(random, &[Cull::None, Cull::None, Cull::Back, Cull::Front]),
        front: one_of(random, &[Winding::CounterClockwise, Winding::Clockwise]),
        depth: AnyDepthState {
            test: one_of(random, &TESTS),
            read_only: is_rare(random),
            constant: is_rare(random),
            offset: one_of(random, &[(I8F8::ZERO, 0), (I8F8::ONE, 10), (I8F8::ONE, -3000)]),
            range: one_of(random, &[(0, 65_535), (0, 65_535), (1_000, 40_000), (9_000, 3)]),
        },
        stencil: random.next().is_multiple_of(2).then_some(stencil),
        blend: AnyBlend::Replace,
        mask: AnyMask { red: true, green: !is_rare(random), blue: !is_rare(random) },
        scissor: random
            .next()
            .is_multiple_of(3)
            .then(|| Rect::new(left, top, left + random.range(1, 20), top + random.range(1, 20))),
    }
}

/// A triangle of one colour: corners with codes.
type Triangle = ([ScreenVertex; 3], Color);

fn any_triangle(random: &mut Random, code: impl Fn(&mut Random) -> u16) -> Triangle {
    let corners = [(); 3].map(|()| {
        let (x, y) = (random.range(-100, 500), random.range(-100, 420));
        ScreenVertex::from_bits(x, y, code(random))
    });
    let [r, g, b, a, ..] = random.next().to_le_bytes();
    (corners, Color::new(r, g, b).with_alpha(a))
}

fn draw_by_crate(
    buffers: (&mut [u32], &mut [u16], &mut [u8]),
    state: &State,
    (corners, color): &Triangle,
) {
    let frame = Frame::<Rgba8888>::new(buffers.0, SIZE).expect("sizes fit");
    let frame = frame.with_depth(buffers.1).expect("sizes fit");
    let mut frame = frame.with_stencil(buffers.2).expect("sizes fit");
    if let Some(scissor) = state.scissor {
        frame.set_scissor(scissor);
    }
    let corners = corners.map(|v| (v, *color));
    let keep = AnyOperation::Keep;
    let off = Stencil::new(AnyCompare::Always, 0).on_fail(keep).on_depth_fail(keep).on_pass(keep);
    ScreenPass::new()
        .cull(state.cull)
        .front_face(state.front)
        .depth(Stenciled::new(state.depth, state.stencil.unwrap_or(off)))
        .blend(state.blend)
        .color_mask(state.mask)
        .triangle(&mut frame, &Flat::colored(), &corners);
}

fn draw_by_reference(picture: &mut Reference, state: &State, (corners, color): &Triangle) {
    let vertex = |v: &ScreenVertex| {
        let [x, y] = [v.x, v.y].map(f64::from);
        Vertex { position: [x, y, v.z.into(), 1.0], varyings: Vec::new() }
    };
    let color = [color.red(), color.green(), color.blue(), color.alpha()].map(f64::from);
    picture.draw(&Draw {
        space: Space::Window,
        kind: Kind::Triangles,
        vertices: &corners.each_ref().map(vertex),
        corners: &[0, 1, 2],
        interpolation: Interpolation::Perspective,
        state: *state,
        shade: &|_| Some(color),
    });
}

fn channels(word: u32) -> [f64; 3] {
    let [r, g, b, _] = word.to_ne_bytes();
    [r, g, b].map(f64::from)
}

#[test]
fn every_state_leaves_what_the_crate_leaves() {
    let mut random = Random(31);
    let mut seen = 0;
    for round in 0..400 {
        let background = [12, 34, 56];
        let mut color = vec![0_u32; PIXELS];
        let [r, g, b] = background;
        Frame::<Rgba8888>::new(&mut color, SIZE).expect("sizes fit").clear(Rgb::new(r, g, b));
        let (mut depth, mut stencil) = (vec![0_u16; PIXELS], vec![0_u8; PIXELS]);
        let mut exact = Reference::new(SIZE, background.map(f64::from))
            .snap(Snap::Bits(4))
            .depth_precision(DepthPrecision::Codes);
        // Triangles that face the viewer have the same codes everywhere: nothing is near a border.
        for _ in 0..12 {
            let state = any_state(&mut random);
            let code = one_of(&mut random, &[0, 2, 5, 20_000, 20_010, 30_000, 65_535]);
            let triangle = any_triangle(&mut random, |_| code);
            draw_by_crate((&mut color, &mut depth, &mut stencil), &state, &triangle);
            draw_by_reference(&mut exact, &state, &triangle);
        }
        let depths: Vec<f64> = depth.iter().map(|code| f64::from(*code)).collect();
        assert!(depths == exact.depths(), "depth {round}");
        assert!(stencil == exact.stencil(), "stencil {round}");
        let drawn: Vec<_> = color.iter().map(|word| channels(*word)).collect();
        assert!(drawn == exact.colors(), "colours {round}");
        seen += exact.seen().iter().filter(|seen| seen.is_some()).count();
        // Once what is stored is the same, one that is blended.
        let blend = one_of(&mut random, &BLENDS);
        let state = State { blend, ..State::PLAIN };
        let triangle = any_triangle(&mut random, |_| 9);
        draw_by_crate((&mut color, &mut depth, &mut stencil), &state, &triangle);
        draw_by_reference(&mut exact, &state, &triangle);
        for (word, exact) in color.iter().zip(exact.colors()) {
            for (drawn, exact) in channels(*word).into_iter().zip(exact) {
                // A step, and a sixteenth where channels glow.
                assert!((drawn - exact).abs() <= 17.0 / 16.0, "{drawn} for {exact}, {blend:?}");
            }
        }
    }
    assert!(seen > 50_000, "hardly tested: {seen} pixels");
}

/// The larger change of codes from a pixel to the next one, across or down.
fn steepest(corners: &[ScreenVertex; 3]) -> f64 {
    let [a, b, c] = corners.map(|v| [f64::from(v.x), f64::from(v.y), f64::from(v.z)]);
    let [p, q] = [b, c].map(|v| [0, 1, 2].map(|i| v[i] - a[i]));
    let area = p[0] * q[1] - p[1] * q[0];
    let across = p[2] * q[1] - q[2] * p[1];
    let down = q[2] * p[0] - p[2] * q[0];
    (across / area).abs().max((down / area).abs())
}

#[test]
fn tilted_triangles_have_the_depths_of_the_crate() {
    let mut random = Random(32);
    let mut worst = [0.0_f64; 2];
    for round in 0..2_000 {
        // Either corners are rounded into a range, or triangles are moved.
        let moved = round % 2 == 0;
        let offset = (I8F8::from_num(random.range(-12, 12)) / 4, random.range(-50, 50) as i16);
        let range = (random.next() as u16, random.next() as u16);
        let full = AnyDepthState::new(AnyDepth::Always);
        let depth =
            if moved { AnyDepthState { offset, ..full } } else { AnyDepthState { range, ..full } };
        let state = State { depth, ..State::PLAIN };
        let triangle = any_triangle(&mut random, |random| random.range(2, 65_000) as u16);
        if moved && steepest(&triangle.0) >= 32_767.0 {
            // Beyond the slopes by which the crate moves.
            continue;
        }
        let mut color = vec![0; PIXELS];
        let (mut depth, mut stencil) = (vec![0_u16; PIXELS], vec![0_u8; PIXELS]);
        draw_by_crate((&mut color, &mut depth, &mut stencil), &state, &triangle);
        let mut exact = Reference::new(SIZE, [0.0; 3]);
        draw_by_reference(&mut exact, &state, &triangle);
        for ((depth, exact), seen) in depth.iter().zip(exact.depths()).zip(exact.seen()) {
            if seen.is_some() {
                let error = (f64::from(*depth) - exact).abs();
                worst[usize::from(moved)] = worst[usize::from(moved)].max(error);
            }
        }
    }
    println!("in a range, and moved, in codes: {worst:.4?}");
    // Each pixel is rounded, and before it corners into a range; a plane's own error is at most a
    // sixteenth.
    assert!(worst[0] <= 1.0 + 0.0625 && worst[1] <= 0.5 + 0.0625, "{worst:?}");
    assert!(worst[0] > 0.5 && worst[1] > 0.4, "the bounds are no guess: {worst:?}");
}

#[test]
fn what_is_discarded_leaves_nothing_and_counts() {
    let vertex = |x: f64, y: f64| Vertex { position: [x, y, 700.0, 1.0], varyings: Vec::new() };
    let vertices = [vertex(-9.0, -9.0), vertex(99.0, -9.0), vertex(-9.0, 99.0)];
    let count = Stencil::new(AnyCompare::Always, 0).on_fail(AnyOperation::Keep);
    let count = count.on_depth_fail(AnyOperation::Keep).on_pass(AnyOperation::IncrementWrap);
    let state =
        State { depth: AnyDepthState::new(AnyDepth::Less), stencil: Some(count), ..State::PLAIN };
    let mut picture = Reference::new(SIZE, [1.5; 3]);
    // The second primitive has a corner that is no vertex.
    for (draw, corners) in [[0, 1, 2, 0, 1, 3], [0, 1, 3, 0, 1, 2]].iter().enumerate() {
        picture.draw(&Draw {
            space: Space::Window,
            kind: Kind::Triangles,
            vertices: &vertices,
            corners,
            interpolation: Interpolation::Perspective,
            state,
            // A chequerboard, the other way round the second time.
            shade: &|f| ((f.x + f.y) % 2 == draw as u16).then_some([200.4, 0.0, 300.0, 0.0]),
        });
        let is_first = |i: usize| (i % 24 + i / 24).is_multiple_of(2);
        for i in 0..PIXELS {
            let drawn = match (is_first(i), draw) {
                (true, _) => Some(0),
                (false, 1) => Some(3),
                (false, _) => None,
            };
            assert_eq!(picture.seen()[i], drawn, "pixel {i}");
            assert_eq!(picture.stencil()[i], u8::from(drawn.is_some()), "pixel {i}");
            assert_eq!(picture.depths()[i], if drawn.is_some() { 700.0 } else { 0.0 }, "{i}");
            let rounded = if drawn.is_some() { [200, 0, 255] } else { [2; 3] };
            assert_eq!(picture.rounded_colors()[i], rounded, "pixel {i}");
            assert_eq!(picture.counts()[i], draw as u32 + 1, "pixel {i}");
        }
    }
}
