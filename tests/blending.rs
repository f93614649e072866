//! What becomes of a fragment's colour: blending, dither and colour mask against their definitions.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    clippy::float_cmp,
    reason = "random numbers are cut to what is wanted"
)]

mod support;

use microraster::host::reference;
use microraster::raster::ScreenVertex;
use microraster::{
    Add, AllChannels, Alpha, AnyBlend, AnyDither, AnyMask, Average, Blend, Channels, Color,
    ColorMask, ConstantAlpha, Corner, Dither, Dither4, Dither8, DrawContext, FlatColor, Format,
    Frame, Gouraud, Less, Multiply, Off, Premultiplied, Rect, Replace, Rgb, Rgb565, Rgb565Be,
    Rgba8888, Row, ScreenPass, Shader, Size, State, Subtract, Thin, Undithered, VertexInput, Wide,
};
use support::Random;

const MODES: [AnyBlend; 9] = [
    AnyBlend::Replace,
    AnyBlend::Alpha,
    AnyBlend::ConstantAlpha(0),
    AnyBlend::ConstantAlpha(77),
    AnyBlend::Premultiplied,
    AnyBlend::Add,
    AnyBlend::Multiply,
    AnyBlend::Subtract,
    AnyBlend::Average,
];

/// The three channels of a colour, 0 to 255.
fn channels(color: Color) -> [f64; 3] {
    [color.red(), color.green(), color.blue()].map(f64::from)
}

/// The definition of a mode, with alpha as the format resolves it.
fn exact<F: Steps>(mode: AnyBlend, source: Color, stored: [f64; 3]) -> [f64; 3] {
    let (mode, alpha) = match mode {
        AnyBlend::ConstantAlpha(alpha) => (AnyBlend::Alpha, alpha),
        _ => (mode, source.alpha()),
    };
    let [r, g, b] = channels(source);
    reference::blended(mode, [r, g, b, 255.0 * F::alpha(alpha)], stored)
}

/// A format whose channels are numbers of steps.
trait Steps: Format {
    /// Steps of red, green and blue up to full.
    const STEPS: [f64; 3];
    /// Alpha as the format resolves it.
    fn alpha(alpha: u8) -> f64;
    fn raw(random: &mut Random) -> Self::Raw;
    fn steps(raw: Self::Raw) -> [f64; 3];
}

impl Steps for Rgb565 {
    const STEPS: [f64; 3] = [31.0, 63.0, 31.0];
    fn alpha(alpha: u8) -> f64 {
        // Ties between 32nds go to the side of the 256ths.
        let fine = u32::from(alpha) + u32::from(alpha > 127);
        f64::from((fine + 4) / 8) / 32.0
    }
    fn raw(random: &mut Random) -> u16 {
        random.next() as u16
    }
    fn steps(raw: u16) -> [f64; 3] {
        [raw >> 11, raw >> 5 & 63, raw & 31].map(f64::from)
    }
}

impl Steps for Rgb565Be {
    const STEPS: [f64; 3] = Rgb565::STEPS;
    fn alpha(alpha: u8) -> f64 {
        Rgb565::alpha(alpha)
    }
    fn raw(random: &mut Random) -> u16 {
        random.next() as u16
    }
    fn steps(raw: u16) -> [f64; 3] {
        Rgb565::steps(u16::from_be(raw))
    }
}

impl Steps for Rgba8888 {
    const STEPS: [f64; 3] = [255.0; 3];
    fn alpha(alpha: u8) -> f64 {
        f64::from(alpha) / 255.0
    }
    fn raw(random: &mut Random) -> u32 {
        Self::pack(any_color(random))
    }
    fn steps(raw: u32) -> [f64; 3] {
        let [r, g, b, a] = raw.to_ne_bytes();
        assert_eq!(a, 255, "opaque");
        [r, g, b].map(f64::from)
    }
}

fn any_color(random: &mut Random) -> Color {
    // One in four channels at an end.
    let mut channel = || match random.next() % 8 {
        0 => 0,
        1 => 255,
        _ => random.next() as u8,
    };
    let (r, g, b, a) = (channel(), channel(), channel(), channel());
    Color::new(r, g, b).with_alpha(a)
}

fn blended<F: Format>(mode: &impl Blend, color: Color, stored: F::Raw) -> F::Raw {
    F::pack(mode.blend::<F>(&mode.source::<F>(color), stored))
}

/// Fails where a channel is a step or more beside the definition.
fn check<F: Steps>(mode: AnyBlend, color: Color, stored: F::Raw) {
    let got = F::steps(blended::<F>(&mode, color, stored));
    let (source, beneath) = (channels(color), F::steps(stored));
    // What is stored stands for its share of full.
    let below = [0, 1, 2].map(|channel| beneath[channel] * 255.0 / F::STEPS[channel]);
    let exact = exact::<F>(mode, color, below);
    for channel in 0..3 {
        let expected = exact[channel] * F::STEPS[channel] / 255.0;
        let glows = mode == AnyBlend::Premultiplied && source[channel] > f64::from(color.alpha());
        let bound = if glows { 17.0 / 16.0 } else { 1.0 };
        assert!(
            (got[channel] - expected).abs() < bound,
            "{mode:?}, channel {channel} of {color:?} over {beneath:?}: {} for {expected}",
            got[channel]
        );
    }
}

fn check_random<F: Steps>(seed: u64) {
    let mut random = Random(seed);
    for mode in MODES {
        for _ in 0..100_000 {
            let (color, stored) = (any_color(&mut random), F::raw(&mut random));
            check::<F>(mode, color, stored);
        }
    }
}

#[test]
fn every_mode_is_within_a_step_of_its_definition() {
    check_random::<Rgb565>(1);
    check_random::<Rgb565Be>(2);
    check_random::<Rgba8888>(3);
}

#[test]
fn alpha_is_resolved_to_the_nearest_32nd_and_both_ends_are_whole() {
    for alpha in 0..=255 {
        let exact = f64::from(alpha) / 255.0;
        let off = (Rgb565::alpha(alpha) - exact).abs();
        assert!(off <= 0.5 / 32.0 + 0.5 / 256.0, "{alpha} is {off} off");
    }
    assert_eq!((Rgb565::alpha(0), Rgb565::alpha(255)), (0.0, 1.0), "ends");
}

#[test]
fn every_stored_565_pixel_under_every_alpha_of_the_extremes() {
    // The same value in all channels: each is on its own.
    for mode in MODES {
        for alpha in 0..=255 {
            for source in [0, 1, 127, 128, 254, 255] {
                let color = Color::new(source, source, source).with_alpha(alpha);
                for value in 0..64 {
                    let raw = (value / 2) << 11 | value << 5 | (value / 2);
                    check::<Rgb565>(mode, color, raw);
                }
            }
        }
    }
}

#[test]
fn every_pair_of_8_bit_channels_under_every_alpha_of_some() {
    for mode in MODES {
        for source in 0..=255 {
            for stored in 0..=255 {
                let alpha = [0, 1, 127, 128, 254, 255][usize::from(stored % 6_u8)];
                let color = Color::new(source, source, source).with_alpha(alpha);
                let stored = Rgba8888::pack(Color::new(stored, stored, stored));
                check::<Rgba8888>(mode, color, stored);
            }
        }
    }
}

#[test]
fn what_changes_nothing_keeps_every_bit_and_what_covers_replaces() {
    fn keeps<F: Steps>() {
        let mut random = Random(5);
        for _ in 0..100_000 {
            let (color, stored) = (any_color(&mut random), F::raw(&mut random));
            let same = |raw: F::Raw| bytemuck::bytes_of(&raw) == bytemuck::bytes_of(&stored);
            let black = Color::new(0, 0, 0);
            let clear = black.with_alpha(0);
            assert!(same(blended::<F>(&Alpha, color.with_alpha(0), stored)), "alpha 0");
            assert!(same(blended::<F>(&ConstantAlpha(0), color, stored)), "constant alpha 0");
            assert!(same(blended::<F>(&Premultiplied, clear, stored)), "premultiplied nothing");
            assert!(same(blended::<F>(&Add, black, stored)), "nothing added");
            assert!(same(blended::<F>(&Subtract, black, stored)), "nothing taken away");
            assert!(same(blended::<F>(&Multiply, Color::new(255, 255, 255), stored)), "times 1");
            let raw = F::pack(color);
            let replaces =
                |blended: F::Raw| bytemuck::bytes_of(&blended) == bytemuck::bytes_of(&raw);
            let opaque = color.with_alpha(255);
            assert!(replaces(blended::<F>(&Alpha, opaque, stored)), "opaque");
            let covered = blended::<F>(&Premultiplied, opaque, stored);
            assert!(replaces(covered), "premultiplied and opaque");
        }
    }
    keeps::<Rgb565>();
    keeps::<Rgb565Be>();
    keeps::<Rgba8888>();
}

#[test]
fn colors_with_any_fraction_stay_in_their_channel() {
    let mut random = Random(6);
    for _ in 0..200_000 {
        let color = Color { blue_red: random.next() as u32, green: random.next() as u32 };
        let stored = Rgba8888::raw(&mut random);
        for mode in MODES {
            check::<Rgba8888>(mode, color, stored);
        }
    }
}

/// One colour with an alpha of its own, in runs or pixel by pixel.
struct Glass<const RUNS: bool>;

impl<const RUNS: bool> Shader for Glass<RUNS> {
    type Vertex = ();
    type Varying = FlatColor;
    type Prepared = ();

    fn prepare(&self, _: &DrawContext) {}

    fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> Corner<FlatColor> {
        Color::default()
    }

    fn fragment(&self, _: &Self::Prepared, varying: &FlatColor) -> Option<Color> {
        Some(varying.color())
    }

    fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, FlatColor>) {
        let color = row.varying().color();
        if RUNS {
            row.fill(color);
        } else {
            row.each(|varying| self.fragment(&(), varying));
        }
    }
}

const SIZE: Size = Size::new(40, 12);

/// A background of all sorts, and what `draw` makes of it.
fn picture<F: Steps>(
    draw: impl FnOnce(&mut Frame<'_, F, microraster::DepthBuffer<'_>>),
) -> Vec<F::Raw> {
    let mut random = Random(9);
    let mut pixels: Vec<_> = (0..40 * 12).map(|_| F::raw(&mut random)).collect();
    let mut depth = vec![0; 40 * 12];
    let frame = Frame::<F>::new(&mut pixels, SIZE).expect("sizes fit");
    draw(&mut frame.with_depth(&mut depth).expect("sizes fit"));
    pixels
}

/// A triangle that covers the picture but for its lower right corner.
fn corners<T>(corners: [T; 3]) -> [(ScreenVertex, T); 3] {
    let [a, b, c] = corners;
    let at = |x: i32, y: i32| ScreenVertex::from_bits(16 * x, 16 * y, 9000);
    [(at(0, 0), a), (at(44, -1), b), (at(1, 13), c)]
}

fn every_road_gives_the_same_bits<F: Steps, B: Blend + Copy>(blend: B, any: AnyBlend)
where
    F::Raw: PartialEq + core::fmt::Debug,
{
    let mut random = Random(11);
    for _ in 0..40 {
        let color = any_color(&mut random);
        let triangle = corners([color; 3]);
        let pass = || ScreenPass::new().blend(blend);
        let runs = picture::<F>(|frame| pass().triangle(frame, &Glass::<true>, &triangle));
        let pixels = picture::<F>(|frame| pass().triangle(frame, &Glass::<false>, &triangle));
        let tested = picture::<F>(|frame| {
            pass().depth(Less).triangle(frame, &Glass::<true>, &triangle);
        });
        let chosen = picture::<F>(|frame| {
            ScreenPass::new()
                .blend(any)
                .dither(AnyDither::Undithered)
                .color_mask(AnyMask { red: true, green: true, blue: true })
                .triangle(frame, &Glass::<true>, &triangle);
        });
        assert_eq!(runs, pixels, "{any:?} of {color:?}: runs");
        assert_eq!(runs, tested, "{any:?} of {color:?}: with depth");
        assert_eq!(runs, chosen, "{any:?} of {color:?}: chosen when the program runs");
    }
}

fn every_mode_of<F: Steps>()
where
    F::Raw: PartialEq + core::fmt::Debug,
{
    every_road_gives_the_same_bits::<F, _>(Replace, AnyBlend::Replace);
    every_road_gives_the_same_bits::<F, _>(Alpha, AnyBlend::Alpha);
    every_road_gives_the_same_bits::<F, _>(ConstantAlpha(77), AnyBlend::ConstantAlpha(77));
    every_road_gives_the_same_bits::<F, _>(Premultiplied, AnyBlend::Premultiplied);
    every_road_gives_the_same_bits::<F, _>(Add, AnyBlend::Add);
    every_road_gives_the_same_bits::<F, _>(Multiply, AnyBlend::Multiply);
    every_road_gives_the_same_bits::<F, _>(Subtract, AnyBlend::Subtract);
    every_road_gives_the_same_bits::<F, _>(Average, AnyBlend::Average);
}

#[test]
fn runs_pixels_depth_and_runtime_modes_give_the_same_bits() {
    every_mode_of::<Rgb565>();
    every_mode_of::<Rgb565Be>();
    every_mode_of::<Rgba8888>();
}

#[test]
fn swapped_bytes_are_blended_like_unswapped_ones() {
    let mut random = Random(12);
    for mode in MODES {
        for _ in 0..10_000 {
            let (color, stored) = (any_color(&mut random), random.next() as u16);
            let straight = blended::<Rgb565>(&mode, color, stored);
            let swapped = blended::<Rgb565Be>(&mode, color, stored.to_be());
            assert_eq!(u16::from_be(swapped), straight, "{mode:?} of {color:?} over {stored:04x}");
        }
    }
}

#[test]
fn packed_pixels_are_blended_too() {
    struct Packed;
    impl Shader for Packed {
        type Vertex = ();
        type Varying = FlatColor;
        type Prepared = ();
        fn prepare(&self, _: &DrawContext) {}
        fn vertex(&self, (): &(), _: VertexInput<'_, ()>) -> Corner<FlatColor> {
            Color::default()
        }
        fn fragment(&self, _: &Self::Prepared, varying: &FlatColor) -> Option<Color> {
            Some(varying.color())
        }
        fn span<S: State, F: Format>(&self, _: &Self::Prepared, row: Row<'_, S, F, FlatColor>) {
            row.each_packed(|varying| Some(F::pack(varying.color())));
        }
    }
    let triangle = corners([Color::new(16, 32, 64); 3]);
    let packed = picture::<Rgba8888>(|frame| {
        ScreenPass::new().blend(Add).triangle(frame, &Packed, &triangle)
    });
    let plain = picture::<Rgba8888>(|frame| {
        ScreenPass::new().blend(Add).triangle(frame, &Glass::<false>, &triangle);
    });
    assert_eq!(packed, plain, "eight bits are all there is");
}

/// The mean over a cell at `(x, y)` of what a colour is dithered to, in steps.
fn mean<W: Dither>(dither: W, color: Color, side: i32) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for y in 0..side {
        let mut thresholds = dither.thresholds(0, y);
        for _ in 0..side {
            let first = W::first(&thresholds).expect("dithered");
            let got = Rgb565::steps(Rgb565::pack_dithered(color, first));
            for (sum, got) in sum.iter_mut().zip(got) {
                *sum += got / f64::from(side * side);
            }
            W::step(&mut thresholds);
        }
    }
    sum
}

#[test]
fn the_mean_of_a_dithered_cell_is_the_colour() {
    fn check(dither: impl Dither + Copy, side: i32, bound: f64) {
        let mut worst: f64 = 0.0;
        for value in 0..=255 {
            let got = mean(dither, Color::new(value, value, value), side);
            for (got, steps) in got.into_iter().zip(Rgb565::STEPS) {
                worst = worst.max((got - f64::from(value) * steps / 255.0).abs());
            }
        }
        assert!(worst < bound, "a mean is {worst} of a step beside its colour");
        assert!(worst > bound / 2.0, "the bound is no guess: {worst}");
    }
    check(Dither4, 4, DITHER_4);
    check(Dither8, 8, DITHER_8);
}

/// How far a dithered cell's mean may be from the colour, in steps of the format.
const DITHER_4: f64 = 1.0 / 16.0;
const DITHER_8: f64 = 1.0 / 16.0;

#[test]
fn black_and_white_are_not_dithered() {
    for (value, raw) in [(0, 0), (255, 0xFFFF)] {
        for (x, y) in (0..8).flat_map(|y| (0..8).map(move |x| (x, y))) {
            let color = Color::new(value, value, value);
            for dither in [AnyDither::Four, AnyDither::Eight] {
                let first = AnyDither::first(&dither.thresholds(x, y)).expect("dithered");
                assert_eq!(Rgb565::pack_dithered(color, first), raw, "{dither:?} at {x}, {y}");
                let dimmed = Rgb565::dim(color);
                assert_eq!(Rgb565::pack_dimmed(dimmed, first), raw, "{dither:?} at {x}, {y}");
            }
        }
    }
}

#[test]
fn no_channel_runs_over_whatever_the_colour() {
    let mut random = Random(14);
    for i in 0..300_000 {
        let color = Color { blue_red: random.next() as u32, green: random.next() as u32 };
        let dither = if i % 2 == 0 { AnyDither::Four } else { AnyDither::Eight };
        let thresholds = dither.thresholds(random.range(-9, 9), random.range(-9, 9));
        let first = AnyDither::first(&thresholds).expect("dithered");
        let got = Rgb565::steps(Rgb565::pack_dithered(color, first));
        let dimmed = Rgb565::steps(Rgb565::pack_dimmed(Rgb565::dim(color), first));
        for (k, value) in channels(color).into_iter().enumerate() {
            let exact = value * Rgb565::STEPS[k] / 255.0;
            assert!((got[k] - exact).abs() < 1.0, "{color:?}: {} for {exact}", got[k]);
            // The fraction counts, and the half step does not.
            let step = Rgb565::STEPS[k] / 255.0 / 2.0;
            assert!((dimmed[k] - exact).abs() < 1.0 + step, "{color:?}: {}", dimmed[k]);
        }
    }
}

/// Triangles of all sizes in all colours, under a dither.
fn dithered<F: Steps, W: Dither + Copy>(
    dither: W,
    blend: impl Blend + Copy,
    scissors: &[Rect],
) -> Vec<F::Raw> {
    picture::<F>(|frame| {
        for scissor in scissors {
            frame.set_scissor(*scissor);
            let mut random = Random(15);
            for i in 0..60 {
                let size = Size::new(40, 12);
                let triangle = [0; 3].map(|_: i32| {
                    let end = |random: &mut Random| [0, 255, 7][random.range(0, 2) as usize];
                    let color = Rgb::new(end(&mut random), end(&mut random), end(&mut random));
                    (support::any_corner(&mut random, i % 10, size), Color::from(color))
                });
                let pass = ScreenPass::new().dither(dither).blend(blend);
                pass.depth(Off).triangle(frame, &Gouraud::colored(), &triangle);
            }
        }
    })
}

#[test]
fn the_cells_of_a_dither_repeat_all_over_a_large_picture() {
    fn check(dither: impl Dither, side: usize) {
        const WIDE: usize = 150;
        let size = Size::new(150, 150);
        let (mut pixels, mut depth) = (vec![0_u16; WIDE * WIDE], vec![0; WIDE * WIDE]);
        let frame = Frame::<Rgb565>::new(&mut pixels, size).expect("sizes fit");
        let mut frame = frame.with_depth(&mut depth).expect("sizes fit");
        let corner = |x: i32, y: i32| {
            (ScreenVertex::from_bits(x * 16, y * 16, 9), Color::from(Rgb::new(100, 101, 102)))
        };
        let all = [corner(0, 0), corner(300, 0), corner(0, 300)];
        ScreenPass::new().dither(dither).depth(Less).triangle(
            &mut frame,
            &Gouraud::colored(),
            &all,
        );
        for (i, pixel) in pixels.iter().enumerate() {
            let (x, y) = (i % WIDE, i / WIDE);
            let first = pixels[y % side * WIDE + x % side];
            assert_eq!(*pixel, first, "pixel {x}, {y} of cells of {side}");
        }
        let mut kinds = pixels.clone();
        kinds.sort_unstable();
        kinds.dedup();
        assert!(kinds.len() > 2, "it dithers: {kinds:?}");
    }
    check(Dither4, 4);
    check(Dither8, 8);
}

#[test]
fn dither_is_the_same_in_every_scissor_and_chosen_at_run_time() {
    let whole = [Rect::from_size(SIZE)];
    let parts = [
        Rect::new(0, 0, 13, 12),
        Rect::new(13, 0, 30, 7),
        Rect::new(13, 7, 30, 12),
        Rect::new(30, 0, 40, 12),
    ];
    let four = dithered::<Rgb565, _>(Dither4, Replace, &whole);
    assert_eq!(four, dithered::<Rgb565, _>(Dither4, Replace, &parts), "4x4 in parts");
    let chosen = dithered::<Rgb565, _>(AnyDither::Four, AnyBlend::Replace, &whole);
    assert_eq!(four, chosen, "4x4 chosen");
    let eight = dithered::<Rgb565, _>(Dither8, Replace, &whole);
    assert_eq!(eight, dithered::<Rgb565, _>(Dither8, Replace, &parts), "8x8 in parts");
    let chosen = dithered::<Rgb565, _>(AnyDither::Eight, AnyBlend::Replace, &whole);
    assert_eq!(eight, chosen, "8x8 chosen");
    let plain = dithered::<Rgb565, _>(Undithered, Replace, &whole);
    let chosen = dithered::<Rgb565, _>(AnyDither::Undithered, AnyBlend::Replace, &whole);
    assert_eq!(plain, chosen, "undithered chosen");
    assert!(plain != four && four != eight, "dither is seen");
    let blended = dithered::<Rgb565, _>(Dither4, Average, &whole);
    let chosen = dithered::<Rgb565, _>(AnyDither::Four, AnyBlend::Average, &parts);
    assert_eq!(blended, chosen, "blended and dithered");
    let (swapped, straight) = (dithered::<Rgb565Be, _>(Dither4, Replace, &whole), four);
    // Backgrounds differ where nothing is drawn.
    let same = swapped.iter().zip(&straight).filter(|(be, le)| u16::from_be(**be) == **le).count();
    assert!(same > 300, "swapped bytes are dithered alike: {same}");
}

#[test]
fn eight_bits_are_not_dithered() {
    let whole = [Rect::from_size(SIZE)];
    let plain = dithered::<Rgba8888, _>(Undithered, Replace, &whole);
    assert_eq!(plain, dithered::<Rgba8888, _>(Dither4, Replace, &whole), "4x4");
    assert_eq!(plain, dithered::<Rgba8888, _>(Dither8, Replace, &whole), "8x8");
}

#[test]
fn interpolated_colours_are_dithered_within_a_step() {
    // A large triangle, whose planes come in pieces, from end to end of each channel.
    let size = Size::new(512, 64);
    let mut pixels = vec![0; 512 * 64];
    let mut frame = Frame::<Rgb565>::new(&mut pixels, size).expect("sizes fit");
    let at = |x: i32, y: i32| ScreenVertex::from_bits(16 * x, 16 * y, 0);
    let (left, right) = (Color::from(Rgb::BLACK), Color::from(Rgb::WHITE));
    let triangle = [(at(0, 0), left), (at(512, -512), right), (at(512, 512), right)];
    ScreenPass::new().dither(Dither8).triangle(&mut frame, &Gouraud::colored(), &triangle);
    let covered = |x: usize, y: usize| x > y;
    for (i, raw) in pixels.iter().enumerate().filter(|(i, _)| covered(i % 512, i / 512)) {
        let t = (f64::from((i % 512) as u32) + 0.5) / 512.0;
        for (got, steps) in Rgb565::steps(*raw).into_iter().zip(Rgb565::STEPS) {
            // A quarter of an 8-bit step for the planes.
            assert!((got - t * steps).abs() < 1.0 + 0.25 * steps / 255.0, "{got} at {i}, {t}");
        }
    }
}

#[test]
fn lines_and_points_are_dithered_as_triangles_are() {
    let mut random = Random(16);
    for i in 0..400 {
        let color = match i {
            0 => Color::new(255, 255, 255),
            1 => Color::new(0, 0, 0),
            _ => any_color(&mut random).with_alpha(255),
        };
        // Of one colour, so that each pixel says which.
        let corner = |random: &mut Random| (support::any_corner(random, 0, SIZE), color);
        let ends = [corner(&mut random), corner(&mut random)];
        for kind in 0..4 {
            let drawn = |dither: AnyDither| {
                picture::<Rgb565>(|frame| {
                    frame.clear_color(Rgb::new(8, 8, 8));
                    let mut pass = ScreenPass::new().dither(dither);
                    let shader = Gouraud::colored();
                    match kind {
                        0 => pass.lines(frame, &shader, Thin, &[ends]),
                        1 => pass.lines(frame, &shader, Wide(3), &[ends]),
                        2 => pass.points(frame, &shader, 1, &ends),
                        _ => pass.points(frame, &shader, 5, &ends),
                    }
                })
            };
            let background = Rgb565::pack(Color::new(8, 8, 8));
            let plain = drawn(AnyDither::Undithered);
            for dither in [AnyDither::Four, AnyDither::Eight] {
                let width = usize::from(SIZE.width);
                for (i, (got, plain)) in drawn(dither).iter().zip(&plain).enumerate() {
                    let thresholds = dither.thresholds((i % width) as i32, (i / width) as i32);
                    let first = AnyDither::first(&thresholds).expect("dithered");
                    let dimmed = Rgb565::dim(color);
                    // On a plane, red may have lent one of blue's 65536ths.
                    let lent = dimmed.blue_red.wrapping_sub(1 << 16);
                    let lent = Rgb565::pack_dimmed(Color { blue_red: lent, ..dimmed }, first);
                    let expected = Rgb565::pack_dimmed(dimmed, first);
                    let is_right = *got == expected || (*got == lent && kind < 2);
                    let is_drawn = *got != background || *plain != background;
                    assert!(!is_drawn || is_right, "kind {kind}, {color:?} at {i}");
                }
            }
        }
    }
}

#[test]
fn masked_channels_keep_their_bits() {
    fn check<F: Steps, M: ColorMask + Copy>(mask: M)
    where
        F::Raw: PartialEq + core::fmt::Debug,
    {
        let [red, green, blue] = mask.channels();
        let triangle =
            corners([Color::new(255, 0, 100), Color::new(3, 77, 9), Color::new(0, 255, 1)]);
        let shader = Gouraud::colored();
        let before = picture::<F>(|_| ());
        let all = picture::<F>(|frame| ScreenPass::new().triangle(frame, &shader, &triangle));
        let some = picture::<F>(|frame| {
            ScreenPass::new().color_mask(mask).triangle(frame, &shader, &triangle);
        });
        let chosen = picture::<F>(|frame| {
            let mask = AnyMask { red, green, blue };
            ScreenPass::new().color_mask(mask).triangle(frame, &shader, &triangle);
        });
        assert_eq!(some, chosen, "chosen when the program runs");
        for ((before, all), some) in before.iter().zip(&all).zip(&some) {
            let expected = [red, green, blue]
                .into_iter()
                .zip(F::steps(*before))
                .zip(F::steps(*all))
                .map(|((written, before), after)| if written { after } else { before });
            assert!(expected.eq(F::steps(*some)), "{before:?} {all:?} {some:?}");
        }
    }
    fn masks<F: Steps>()
    where
        F::Raw: PartialEq + core::fmt::Debug,
    {
        check::<F, _>(AllChannels);
        check::<F, _>(Channels::<true, false, false>);
        check::<F, _>(Channels::<false, true, false>);
        check::<F, _>(Channels::<true, false, true>);
        check::<F, _>(Channels::<false, false, false>);
    }
    masks::<Rgb565>();
    masks::<Rgb565Be>();
    masks::<Rgba8888>();
}
