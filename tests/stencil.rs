//! Stencil tests and operations against their definition, pixel by pixel.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    reason = "random numbers are cut to what is wanted"
)]

#[path = "support/stencil_states.rs"]
mod stencil_states;
mod support;

use microraster::frame::Supplies;
use microraster::raster::ScreenVertex;
use microraster::{
    Always, AnyCompare, AnyDepth, AnyOperation, AnyStencil, Color, DecrementClamp, DecrementWrap,
    DepthBuffer, DepthTest, DrawContext, Equal, Flat, Frame, FrameError, Gouraud, Greater,
    GreaterEqual, IncrementClamp, IncrementWrap, Invert, Keep, Less, LessEqual, Never, NotEqual,
    Off, Rect, Replace, Rgb, Rgb565, Scalar, ScreenPass, Shader, Size, Stats, Stencil,
    StencilBuffer, StencilCompare, StencilOperation, Stenciled, Thin, VertexInput, Wide, Zero,
};
use stencil_states::{COMPARES, OPERATIONS};
use support::Random;

const SIZE: Size = Size::new(24, 10);
const PIXELS: usize = 24 * 10;
/// What is drawn.
const INK: u16 = 0xF81F;
const COLOR: Rgb = Rgb::new(255, 0, 255);
/// How near it is.
const CODE: u16 = 30_000;

/// A test and its operations: compare, fail, depth fail, pass.
type Choice = (AnyCompare, [AnyOperation; 3]);

/// Reference, read mask, write mask.
type Numbers = [u8; 3];

fn state(
    (compare, [fail, depth_fail, pass]): Choice,
    [reference, read, write]: Numbers,
) -> AnyStencil {
    Stencil::new(compare, reference)
        .on_fail(fail)
        .on_depth_fail(depth_fail)
        .on_pass(pass)
        .read_mask(read)
        .write_mask(write)
}

/// What a frame holds.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Buffers {
    pixels: Vec<u16>,
    codes: Vec<u16>,
    values: Vec<u8>,
}

impl Buffers {
    /// Codes on both sides of the one that is drawn, and values of all kinds.
    fn random(random: &mut Random, length: usize) -> Self {
        let mut of = |make: &dyn Fn(&mut Random) -> u16| {
            (0..length).map(|_| make(random)).collect::<Vec<_>>()
        };
        let pixels = of(&|random| random.next() as u16 & 0x07FF);
        let codes = of(&|random| CODE - 1 + random.range(0, 2) as u16);
        let values = of(&|random| match random.range(0, 5) {
            0 => 0,
            1 => 255,
            2 => random.range(0, 2) as u16 + 126,
            _ => random.next() as u16 & 255,
        });
        Self { pixels, codes, values: values.into_iter().map(|value| value as u8).collect() }
    }

    fn frame(&mut self) -> Frame<'_, Rgb565, StencilBuffer<'_, DepthBuffer<'_>>> {
        let frame = Frame::new(&mut self.pixels, SIZE).expect("sizes fit");
        let frame = frame.with_depth(&mut self.codes).expect("sizes fit");
        frame.with_stencil(&mut self.values).expect("sizes fit")
    }
}

/// The definition, from the tables of the OpenGL specification: what is left of a pixel's colour,
/// depth and stencil value when a fragment of [`INK`] and [`CODE`] meets them.
fn met(
    (compare, [fail, depth_fail, pass]): Choice,
    [reference, read, write]: Numbers,
    depth: AnyDepth,
    (pixel, code, value): (u16, u16, u8),
) -> (u16, u16, u8) {
    let (left, right) = (i32::from(reference & read), i32::from(value & read));
    let is_seen = match compare {
        AnyCompare::Never => false,
        AnyCompare::Less => left < right,
        AnyCompare::LessEqual => left <= right,
        AnyCompare::Equal => left == right,
        AnyCompare::Greater => left > right,
        AnyCompare::GreaterEqual => left >= right,
        AnyCompare::NotEqual => left != right,
        AnyCompare::Always => true,
        other => panic!("no definition of {other:?}"),
    };
    let is_near = match depth {
        AnyDepth::Off => true,
        AnyDepth::Less => CODE > code,
        AnyDepth::GreaterEqual => CODE <= code,
        other => panic!("no definition of {other:?}"),
    };
    let operation = match (is_seen, is_near) {
        (false, _) => fail,
        (true, false) => depth_fail,
        (true, true) => pass,
    };
    let stored = i32::from(value);
    let wanted = match operation {
        AnyOperation::Keep => stored,
        AnyOperation::Zero => 0,
        AnyOperation::Replace => i32::from(reference),
        AnyOperation::IncrementClamp => (stored + 1).min(255),
        AnyOperation::IncrementWrap => (stored + 1) % 256,
        AnyOperation::DecrementClamp => (stored - 1).max(0),
        AnyOperation::DecrementWrap => (stored + 255) % 256,
        AnyOperation::Invert => 255 - stored,
        other => panic!("no definition of {other:?}"),
    };
    // Bit by bit.
    let value = (0..8).fold(0, |sum, bit| {
        let from = if write >> bit & 1 == 1 { wanted } else { stored };
        sum | (from as u8) & 1 << bit
    });
    let written = depth != AnyDepth::Off && is_seen && is_near;
    (if is_seen && is_near { INK } else { pixel }, if written { CODE } else { code }, value)
}

fn any_numbers(random: &mut Random) -> Numbers {
    let mask = |random: &mut Random| match random.range(0, 3) {
        0 => 255,
        1 => 1 << random.range(0, 7),
        _ => random.next() as u8,
    };
    let reference = match random.range(0, 3) {
        0 => random.range(0, 1) as u8 * 255,
        _ => random.next() as u8,
    };
    [reference, mask(random), mask(random)]
}

/// The rectangle that a triangle's corners cover whole, and more.
fn all() -> [(ScreenVertex, Color); 3] {
    [(0, 0), (40, 0), (0, 40)]
        .map(|(x, y)| (ScreenVertex::from_bits(16 * x, 16 * y, CODE), COLOR.into()))
}

/// All comparisons with all operations, `depth` and masks of all kinds.
fn for_all_choices(
    random: &mut Random,
    mut check: impl FnMut(&mut Random, Choice, AnyDepth, Numbers),
) {
    for compare in COMPARES {
        for operation in 0..8 * 8 * 8 {
            let operations = [operation % 8, operation / 8 % 8, operation / 64];
            let choice = (compare, operations.map(|i| OPERATIONS[i]));
            let depth = [AnyDepth::Off, AnyDepth::Less, AnyDepth::GreaterEqual]
                [random.range(0, 2) as usize];
            let numbers = any_numbers(random);
            check(random, choice, depth, numbers);
        }
    }
}

#[test]
fn every_test_and_operation_does_what_its_definition_says() {
    let mut random = Random(31);
    for_all_choices(&mut random, |random, choice, depth, numbers| {
        let before = Buffers::random(random, PIXELS);
        let mut after = before.clone();
        let mut stats = Stats::default();
        ScreenPass::new()
            .depth(Stenciled::new(depth, state(choice, numbers)))
            .count(&mut stats)
            .triangle(&mut after.frame(), &Flat::colored(), &all());
        let mut drawn = 0;
        for i in 0..PIXELS {
            let met =
                met(choice, numbers, depth, (before.pixels[i], before.codes[i], before.values[i]));
            let got = (after.pixels[i], after.codes[i], after.values[i]);
            assert_eq!(got, met, "{choice:?}, {numbers:?}, {depth:?}, value {}", before.values[i]);
            drawn += u32::from(met.0 == INK);
        }
        assert_eq!(stats.pixels, drawn, "pixels are those that are written");
    });
}

/// The frame after a draw under typed states, from `before`.
fn drawn<D: DepthTest>(before: &Buffers, depth: D) -> Buffers
where
    for<'a> StencilBuffer<'a, DepthBuffer<'a>>: Supplies<D::Access>,
{
    let mut after = before.clone();
    ScreenPass::new().depth(depth).triangle(&mut after.frame(), &Gouraud::colored(), &all());
    after
}

#[test]
fn runtime_states_give_the_same_bits_as_the_types() {
    fn compares<C: StencilCompare>(typed: &C, any: AnyCompare) {
        for (reference, stored) in (0..=255).flat_map(|a| (0..=255).map(move |b| (a, b))) {
            let (one, other) = (typed.compares(reference, stored), any.compares(reference, stored));
            assert_eq!(one, other, "{any:?} of {reference}, {stored}");
        }
    }
    fn operations<P: StencilOperation>(typed: &P, any: AnyOperation) {
        assert_eq!(typed.keeps(), any.keeps(), "{any:?}");
        for (reference, stored) in (0..=255).flat_map(|a| (0..=255).map(move |b| (a, b))) {
            let (one, other) = (typed.apply(reference, stored), any.apply(reference, stored));
            assert_eq!(one, other, "{any:?} of {reference}, {stored}");
        }
    }
    compares(&Never, AnyCompare::Never);
    compares(&Less, AnyCompare::Less);
    compares(&LessEqual, AnyCompare::LessEqual);
    compares(&Equal, AnyCompare::Equal);
    compares(&Greater, AnyCompare::Greater);
    compares(&GreaterEqual, AnyCompare::GreaterEqual);
    compares(&NotEqual, AnyCompare::NotEqual);
    compares(&Always, AnyCompare::Always);
    operations(&Keep, AnyOperation::Keep);
    operations(&Zero, AnyOperation::Zero);
    operations(&Replace, AnyOperation::Replace);
    operations(&IncrementClamp, AnyOperation::IncrementClamp);
    operations(&IncrementWrap, AnyOperation::IncrementWrap);
    operations(&DecrementClamp, AnyOperation::DecrementClamp);
    operations(&DecrementWrap, AnyOperation::DecrementWrap);
    operations(&Invert, AnyOperation::Invert);

    // Through the pixel loop, each place with something and with nothing.
    let before = Buffers::random(&mut Random(32), PIXELS);
    let any = |operations| {
        let state = state((AnyCompare::Less, operations), [100, 0x7F, 0xF7]);
        drawn(&before, Stenciled::new(AnyDepth::Less, state))
    };
    let test = Stencil::new(Less, 100).read_mask(0x7F).write_mask(0xF7);
    let keep = AnyOperation::Keep;
    assert_eq!(drawn(&before, Stenciled::new(Less, test)), any([keep; 3]), "nothing");
    let typed = drawn(&before, Stenciled::new(Less, test.on_fail(Invert)));
    assert_eq!(typed, any([AnyOperation::Invert, keep, keep]), "where it fails");
    let typed = drawn(&before, Stenciled::new(Less, test.on_depth_fail(DecrementWrap)));
    assert_eq!(typed, any([keep, AnyOperation::DecrementWrap, keep]), "behind");
    let typed = drawn(&before, Stenciled::new(Less, test.on_pass(IncrementClamp)));
    assert_eq!(typed, any([keep, keep, AnyOperation::IncrementClamp]), "where it passes");
    let all = test.on_fail(Zero).on_depth_fail(Replace).on_pass(DecrementClamp);
    let operations = [AnyOperation::Zero, AnyOperation::Replace, AnyOperation::DecrementClamp];
    assert_eq!(drawn(&before, Stenciled::new(Less, all)), any(operations), "everywhere");
}

/// Discards every second column.
struct Fence;

impl Shader for Fence {
    type Vertex = Rgb;
    type Varying = Scalar;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, Rgb>) -> u16 {
        0
    }

    fn fragment(&self, (): &(), varying: &Scalar) -> Option<Color> {
        (varying.get() >> 9 & 1 == 0).then(|| COLOR.into())
    }
}

#[test]
fn discarded_fragments_leave_nothing_whatever_they_fail() {
    let mut random = Random(33);
    // From 0 on, 512 a column.
    let fence = [(0, 0, 0), (40, 0, 512 * 40), (0, 40, 0)]
        .map(|(x, y, at)| (ScreenVertex::from_bits(16 * x, 16 * y, CODE), at));
    for_all_choices(&mut random, |random, choice, depth, numbers| {
        let before = Buffers::random(random, PIXELS);
        let mut after = before.clone();
        ScreenPass::new().depth(Stenciled::new(depth, state(choice, numbers))).triangle(
            &mut after.frame(),
            &Fence,
            &fence,
        );
        for i in 0..PIXELS {
            let cell = (before.pixels[i], before.codes[i], before.values[i]);
            let met = if i % 2 == 0 { met(choice, numbers, depth, cell) } else { cell };
            let got = (after.pixels[i], after.codes[i], after.values[i]);
            assert_eq!(got, met, "{choice:?}, {numbers:?}, {depth:?}, pixel {i}");
        }
    });
}

#[test]
fn strides_bands_and_scissors_find_the_same_values() {
    // Colours, depth and stencil of three strides, three rows of a picture of ten.
    let (strides, rows, first) = ([30_usize, 27, 41], 3_usize, 4_u16);
    let corner = |x: i32, y: i32| (ScreenVertex::from_bits(x, y, CODE), Color::from(COLOR));
    let lines = [[corner(5, 70), corner(350, 95)], [corner(300, 8), corner(90, 150)]];
    let points: Vec<_> = (0..60).map(|i| corner(i * 37 % 390, i * 53 % 170)).collect();
    let mut random = Random(34);
    for one_stride in [false, true] {
        let strides = if one_stride { [strides[0]; 3] } else { strides };
        for kind in 0..5 {
            let choice = (
                AnyCompare::LessEqual,
                [AnyOperation::Invert, AnyOperation::Zero, AnyOperation::IncrementWrap],
            );
            let state = Stenciled::new(AnyDepth::Less, state(choice, [128, 255, 255]));
            let scissor = Rect::new(3, 0, 21, 6);
            let draw = |frame: &mut Frame<'_, Rgb565, StencilBuffer<'_, DepthBuffer<'_>>>| {
                frame.set_scissor(scissor);
                let mut pass = ScreenPass::new().depth(state);
                let shader = Flat::colored();
                match kind {
                    0 => pass.triangle(frame, &shader, &all()),
                    1 => pass.lines(frame, &shader, Thin, &lines),
                    2 => pass.lines(frame, &shader, Wide(3), &lines),
                    3 => pass.points(frame, &shader, 1, &points),
                    _ => pass.points(frame, &shader, 4, &points),
                }
            };
            let whole = Buffers::random(&mut random, PIXELS);
            let mut expected = whole.clone();
            draw(&mut expected.frame());

            // The same values where the band is, and others about it.
            let mut band = Buffers::random(&mut random, rows * 41);
            let place = |row: usize, x: usize| (row + usize::from(first)) * 24 + x;
            for (row, x) in (0..rows).flat_map(|row| (0..24).map(move |x| (row, x))) {
                band.pixels[row * strides[0] + x] = whole.pixels[place(row, x)];
                band.codes[row * strides[1] + x] = whole.codes[place(row, x)];
                band.values[row * strides[2] + x] = whole.values[place(row, x)];
            }
            let before = band.clone();
            let size = Size::new(24, 3);
            let [color, depth, stencil] = strides.map(|stride| stride as u32);
            let mut frame = Frame::with_stride(&mut band.pixels, size, color)
                .and_then(|frame| frame.with_depth_stride(&mut band.codes, depth))
                .and_then(|frame| frame.with_stencil_stride(&mut band.values, stencil))
                .and_then(|frame| frame.band(first, 10))
                .expect("sizes fit");
            draw(&mut frame);
            let mut changed = 0;
            for (row, x) in (0..rows).flat_map(|row| (0..41).map(move |x| (row, x))) {
                let expected_at = |all: &Buffers| {
                    let at = place(row, x);
                    (all.pixels[at], all.codes[at], all.values[at])
                };
                let at = strides.map(|stride| row * stride + x);
                let got = |all: &Buffers| (all.pixels[at[0]], all.codes[at[1]], all.values[at[2]]);
                if x < 24 {
                    assert_eq!(got(&band), expected_at(&expected), "kind {kind}");
                    changed += usize::from(got(&band) != got(&before));
                } else {
                    let gap = strides.map(|stride| x < stride);
                    let (now, then) = (got(&band), got(&before));
                    assert!(!gap[0] || now.0 == then.0, "a gap of colour");
                    assert!(!gap[1] || now.1 == then.1, "a gap of depth");
                    assert!(!gap[2] || now.2 == then.2, "a gap of stencil");
                }
            }
            assert!(changed > 0, "kind {kind} draws in the band");
        }
    }
}

#[test]
fn a_stencil_needs_no_depth_and_leaves_it_to_passes_without() {
    let before = Buffers::random(&mut Random(35), PIXELS);
    let (mut alone, mut both) = (before.clone(), before.clone());
    let test = Stencil::new(Less, 100).on_pass(Invert);
    let frame = Frame::<Rgb565>::new(&mut alone.pixels, SIZE).expect("sizes fit");
    let mut frame = frame.with_stencil(&mut alone.values).expect("sizes fit");
    ScreenPass::new().depth(Stenciled::new(Off, test)).triangle(
        &mut frame,
        &Gouraud::colored(),
        &all(),
    );
    ScreenPass::new().depth(Stenciled::new(Off, test)).triangle(
        &mut both.frame(),
        &Flat::colored(),
        &all(),
    );
    assert_eq!(alone, both, "the same without depth");
    let mut plain = before.clone();
    ScreenPass::new().depth(Less).triangle(&mut plain.frame(), &Flat::colored(), &all());
    assert_eq!(plain.values, before.values, "untouched");
    assert!(plain.codes.iter().zip(&before.codes).any(|(a, b)| a != b), "depth is written");
}

#[test]
fn clearing_reaches_the_scissor_and_no_further() {
    let before = Buffers::random(&mut Random(36), PIXELS);
    for scissor in [
        Rect::new(0, 0, 24, 10),
        Rect::new(0, 2, 24, 7),
        Rect::new(5, 1, 9, 4),
        Rect::new(9, 9, 2, 2),
    ] {
        let mut after = before.clone();
        let mut frame = after.frame();
        frame.set_scissor(scissor);
        frame.clear(COLOR);
        frame.clear_depth(7);
        frame.clear_stencil(9);
        for i in 0..PIXELS {
            let inside = scissor.contains((i % 24) as i32, (i / 24) as i32);
            let got = (after.pixels[i], after.codes[i], after.values[i]);
            let kept = (before.pixels[i], before.codes[i], before.values[i]);
            assert_eq!(got, if inside { (INK, 7, 9) } else { kept }, "{scissor:?}, pixel {i}");
        }
    }
    let (mut pixels, mut values) = (vec![0; PIXELS], vec![1; PIXELS]);
    let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("sizes fit");
    frame.with_stencil(&mut values).expect("sizes fit").clear(COLOR);
    assert_eq!((pixels, values), (vec![INK; PIXELS], vec![0; PIXELS]), "without depth");
}

#[test]
fn buffers_that_are_too_short_are_refused() {
    let (mut pixels, mut values) = ([0; PIXELS], [0; PIXELS]);
    let mut refused = |length: usize, stride: u32| {
        let frame = Frame::<Rgb565>::new(&mut pixels, SIZE).expect("sizes fit");
        frame.with_stencil_stride(&mut values[..length], stride).err()
    };
    assert_eq!(refused(PIXELS, 24), None, "just enough");
    let short = FrameError::Stencil { needed: 240, got: 239 };
    assert_eq!(refused(PIXELS - 1, 24), Some(short), "one less");
    assert_eq!(short.to_string(), "the stencil buffer needs 240 values and has 239");
    assert_eq!(refused(PIXELS, 23), Some(FrameError::Stride { needed: 24, got: 23 }), "stride");
    let long = FrameError::Stencil { needed: u32::MAX, got: 240 };
    assert_eq!(refused(PIXELS, u32::MAX), Some(long), "a stride without end");
}
