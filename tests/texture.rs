//! Samplers against real arithmetic: every format, wrap and filter, at all sizes and extremes.
#![cfg(feature = "std")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a reference in f64, whose values are known to be small"
)]

use microraster::host::reference::{self, TexelGrid};
use microraster::texture::{
    Add, Alpha8, AnyEnvironment, AnyFilter, AnySampler, AnyTexture, AnyWrap, Bgr888, Bgra8888,
    BigEndian, Bilinear, Clamp, ClampAny, Decal, Environment, Filter, FineBilinear, Footprint,
    Indexed4, Indexed8, LittleEndian, Luminance8, MipMap, MipSampler, Mirror, Modulate, Nearest,
    Reduce, Repeat, Replace, Rgb888, Rgba4444, Rgba5551, Sample, Sampler, TexelFormat, Texture,
    TextureError, Wrap,
};
use microraster::{Color, Format, Rgb565, Rgba8888, Uv};

/// Numbers without a pattern (Marsaglia's xorshift).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 16
    }

    /// A coordinate: anywhere, near a whole texel or half of one, or at an extreme.
    fn coordinate(&mut self, unit_bits: u32) -> i32 {
        let any = self.next() as i32;
        match self.next() % 4 {
            0 => any,
            1 => (any & -(1 << (unit_bits + 3))).wrapping_add((self.next() % 3) as i32 - 1),
            2 => {
                let extremes = [0, -1, 1, i32::MAX, i32::MIN, 32767 << 16, -32767 << 16, 1 << 28];
                extremes[self.next() as usize % extremes.len()]
            }
            _ => any >> (self.next() % 16),
        }
    }
}

/// A texel's channels of 0 to 255, not rounded: red, green, blue, alpha.
type Real = [f64; 4];

/// Which texels are asked for.
struct Place {
    size: [u16; 2],
    wraps: [AnyWrap; 2],
    unit_bits: u32,
}

impl Place {
    fn grid(&self) -> TexelGrid {
        let [width, height] = self.size.map(usize::from);
        TexelGrid { width, height, wraps: self.wraps }
    }

    /// Coordinates in repeats; exact, as texels of them need 43 bits.
    fn repeats(&self, u: i32, v: i32) -> [f64; 2] {
        [u, v].map(|at| f64::from(at) / f64::from(self.unit_bits + 16).exp2())
    }

    fn nearest(&self, u: i32, v: i32) -> usize {
        self.grid().nearest(self.repeats(u, v))
    }

    fn bilinear(&self, u: i32, v: i32) -> [(usize, f64); 4] {
        self.grid().bilinear(self.repeats(u, v))
    }
}

/// A colour's channels of 0 to 255: what was rounded is not known to be.
fn real(color: Color) -> Real {
    let channel = |field: u32| (f64::from(field & 0xFFFF) - 128.0) / 256.0;
    [
        channel(color.blue_red),
        channel(color.green >> 16),
        channel(color.blue_red >> 16),
        f64::from(color.alpha()),
    ]
}

fn furthest(a: Real, b: Real) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// One format: its data at random, and what its words mean by the book.
trait Subject: TexelFormat {
    /// Furthest that a decoded channel is off, in 8-bit steps.
    const DECODED: f64;
    /// Furthest that a mixed channel is off in 8-bit steps, beside what the place is: weights and
    /// the format's own rounding.
    const MIX: f64;
    const PALETTE: &'static Self::Palette;
    fn word(bits: u64) -> Self::Word;
    fn meaning(words: &[Self::Word], index: usize) -> Real;
}

fn fields(word: u32, places: [(u32, u32); 4]) -> Real {
    places.map(|(shift, bits)| {
        if bits == 0 {
            return 255.0;
        }
        let full = (1u32 << bits) - 1;
        f64::from(word >> shift & full) * 255.0 / f64::from(full)
    })
}

const P565: [(u32, u32); 4] = [(11, 5), (5, 6), (0, 5), (0, 0)];
const P8888: [(u32, u32); 4] = [(0, 8), (8, 8), (16, 8), (24, 8)];

macro_rules! subjects {
    ($($format:ty, $decoded:expr, $mix:expr, $palette:expr, |$bits:ident| $word:expr,
        |$words:ident, $index:ident| $meaning:expr;)*) => {
        $(impl Subject for $format {
            const DECODED: f64 = $decoded;
            const MIX: f64 = $mix;
            const PALETTE: &'static Self::Palette = $palette;
            fn word($bits: u64) -> Self::Word {
                $word
            }
            fn meaning($words: &[Self::Word], $index: usize) -> Real {
                $meaning
            }
        })*
    };
}

const fn palette565<const N: usize>() -> [u16; N] {
    let (mut palette, mut i) = ([0; N], 0);
    while i < N {
        palette[i] = (i * 40503 + 77) as u16;
        i += 1;
    }
    palette
}

const fn palette8888<const N: usize>() -> [u32; N] {
    let (mut palette, mut i) = ([0; N], 0);
    while i < N {
        palette[i] = (i as u32).wrapping_mul(2_654_435_761).to_le();
        i += 1;
    }
    palette
}

const fn palette_color<const N: usize>() -> [Color; N] {
    let (mut palette, mut i) = ([Color::new(0, 0, 0); N], 0);
    while i < N {
        let [r, g, b, a] = (i as u32).wrapping_mul(2_654_435_761).to_le_bytes();
        palette[i] = Color::new(r, g, b).with_alpha(a);
        i += 1;
    }
    palette
}

/// The half of a byte that holds a texel.
fn half(words: &[u8], index: usize) -> usize {
    let pair = words[index / 2];
    usize::from(if index.is_multiple_of(2) { pair >> 4 } else { pair & 15 })
}

/// Five bits are repeated into eight, floor(33/4 x) for 255/31 x: at most three quarters of a step is
/// cut off, and the factor gives less than that. Six bits are closer.
const REPEATED: f64 = 0.75;

// Eight bits of weight are off by half of 2^-8 in one share, which moves four texels by that: one
// step where they are as far apart as can be. Eleven bits: an eighth. Bits that are repeated say
// 33/32 for 255/248 and are not rounded: half a step.
subjects! {
    Rgb565, REPEATED, 0.125 + 0.5, &(), |bits| bits as u16, |words, i| fields(words[i].into(), P565);
    Rgba8888, 0.0, 1.0, &(), |bits| bits as u32, |words, i| fields(u32::from_le(words[i]), P8888);
    Rgba5551, REPEATED, 1.0 + REPEATED, &(), |bits| bits as u16,
        |words, i| fields(words[i].into(), [(11, 5), (6, 5), (1, 5), (0, 1)]);
    Rgba4444, 0.0, 1.0, &(), |bits| bits as u16,
        |words, i| fields(words[i].into(), [(12, 4), (8, 4), (4, 4), (0, 4)]);
    Luminance8, 0.0, 0.5, &(), |bits| bits as u8, |words, i| {
        let grey = f64::from(words[i]);
        [grey, grey, grey, 255.0]
    };
    Alpha8, 0.0, 0.5, &(), |bits| bits as u8,
        |words, i| [255.0, 255.0, 255.0, words[i].into()];
    Color, 0.0, 1.0, &(), |bits| {
        let [r, g, b, a, ..] = bits.to_le_bytes();
        Color::new(r, g, b).with_alpha(a)
    }, |words, i| real(words[i]);
    LittleEndian, REPEATED, 0.125 + 0.5, &(), |bits| (bits as u16).to_le_bytes(),
        |words, i| fields(u16::from_le_bytes(words[i]).into(), P565);
    BigEndian<Rgba4444>, 0.0, 1.0, &(), |bits| (bits as u16).to_le_bytes(),
        |words, i| fields(u16::from_be_bytes(words[i]).into(), [(12, 4), (8, 4), (4, 4), (0, 4)]);
    Rgb888, 0.0, 1.0, &(), |bits| [bits as u8, (bits >> 8) as u8, (bits >> 16) as u8],
        |words, i| {
            let [r, g, b] = words[i].map(f64::from);
            [r, g, b, 255.0]
        };
    Bgr888, 0.0, 1.0, &(), |bits| [bits as u8, (bits >> 8) as u8, (bits >> 16) as u8],
        |words, i| {
            let [b, g, r] = words[i].map(f64::from);
            [r, g, b, 255.0]
        };
    Bgra8888, 0.0, 1.0, &(), |bits| (bits as u32).to_ne_bytes(),
        |words, i| {
            let [b, g, r, a] = words[i].map(f64::from);
            [r, g, b, a]
        };
    Indexed8<Rgb565>, REPEATED, 0.125 + 0.5, &palette565(), |bits| bits as u8,
        |words, i| fields(palette565::<256>()[usize::from(words[i])].into(), P565);
    Indexed8<Rgba8888>, 0.0, 1.0, &palette8888(), |bits| bits as u8,
        |words, i| fields(u32::from_le(palette8888::<256>()[usize::from(words[i])]), P8888);
    Indexed8<Color>, 0.0, 1.0, &palette_color(), |bits| bits as u8,
        |words, i| real(palette_color::<256>()[usize::from(words[i])]);
    Indexed4<Rgb565>, REPEATED, 0.125 + 0.5, &palette565(), |bits| bits as u8,
        |words, i| fields(palette565::<16>()[half(words, i)].into(), P565);
    Indexed4<Rgba8888>, 0.0, 1.0, &palette8888(), |bits| bits as u8,
        |words, i| fields(u32::from_le(palette8888::<16>()[half(words, i)]), P8888);
    Indexed4<Color>, 0.0, 1.0, &palette_color(), |bits| bits as u8,
        |words, i| real(palette_color::<16>()[half(words, i)]);
}

/// Furthest that a place between texels is off, in 8-bit steps of both axes: half of 2^-`bits` texel
/// each.
fn place_off(bits: u32) -> f64 {
    255.0 / f64::from(bits).exp2()
}

/// Furthest that a channel is off that is mixed by five bits: rounded twice to one of 31 steps.
const BLENDED: f64 = 255.0 / 31.0 + REPEATED;

/// Words at random for a texture of this size.
fn words<T: Subject>(random: &mut Random, [w, h]: [u16; 2]) -> Vec<T::Word> {
    let texels = usize::from(w) * usize::from(h);
    (0..texels.div_ceil(T::TEXELS_PER_WORD)).map(|_| T::word(random.next())).collect()
}

/// Compares both filters of one texture under one pair of wraps.
fn check<T: Subject, U: Wrap, V: Wrap>(
    random: &mut Random,
    words: &[T::Word],
    place: &Place,
    (across, down): (U, V),
    samples: usize,
) where
    T::Texel: PartialEq + std::fmt::Debug,
{
    let Place { size: [w, h], wraps, unit_bits } = *place;
    let texture = Texture::<T>::with_palette(words, T::PALETTE, w, h).expect("words are enough");
    let nearest = Sampler::new(texture, Nearest, across, down).expect("a size for these wraps");
    let bilinear = Sampler::new(texture, Bilinear, across, down).expect("a size for these wraps");
    let fine = Sampler::new(texture, FineBilinear, across, down).expect("a size for these wraps");
    let (nearest, bilinear) = (nearest.unit_bits(unit_bits), bilinear.unit_bits(unit_bits));
    let fine = fine.unit_bits(unit_bits);
    // Formats that have no cheaper way mix as finely by both filters.
    let (places, blend) = if T::PLACES == 5 { (5, BLENDED) } else { (8, T::MIX) };
    // A side of any length is cut off on the way.
    let cut = if U::ANY_SIZE { 2.0 * 255.0 / f64::from(unit_bits + 4).exp2() } else { 0.0 };
    for _ in 0..samples {
        let (u, v) = (random.coordinate(unit_bits), random.coordinate(unit_bits));
        let name = || format!("{w}x{h}, {wraps:?}, 2^{unit_bits} units, at {u}, {v}");

        let index = place.nearest(u, v);
        let texel = T::fetch(words, T::PALETTE, index).expect("an index inside");
        assert_eq!(nearest.sample(u, v), T::decode(texel), "{}", name());
        let off = furthest(real(T::decode(texel)), T::meaning(words, index));
        assert!(off <= T::DECODED + 1e-9, "{}: decoded {off} steps off", name());

        let mut expected = [0.0; 4];
        for (index, share) in place.bilinear(u, v) {
            for (sum, channel) in expected.iter_mut().zip(T::meaning(words, index)) {
                *sum += share * channel;
            }
        }
        let mixed = [(bilinear.sample(u, v), places, blend), (fine.sample(u, v), 8, T::MIX)];
        for (got, places, mix) in mixed {
            let off = furthest(real(got), expected);
            // The alpha that is asked for has no fraction.
            let bound = place_off(places) + mix + cut + if got.alpha() < 255 { 0.5 } else { 0.0 };
            assert!(off <= bound, "{}: {off} steps off, {expected:?}, {:?}", name(), real(got));
        }

        // A run of pixels.
        let way = Uv { u: random.coordinate(unit_bits), v: random.coordinate(unit_bits) };
        check_run(&nearest, Uv { u, v }, way);
        check_run(&bilinear, Uv { u, v }, way);
        check_run(&fine, Uv { u, v }, way);
    }
}

/// What a run steps shows what each of its pixels would alone.
fn check_run(sampler: &impl Sample, mut uv: Uv, way: Uv) {
    let (mut begun, begun_way) = (sampler.begin(uv), sampler.begun_way(way));
    let step = |at: &mut Uv, way: Uv| {
        (at.u, at.v) = (at.u.wrapping_add(way.u), at.v.wrapping_add(way.v));
    };
    for pixel in 0..4 {
        let alone = sampler.fetch(uv.u, uv.v);
        assert_eq!(sampler.fetch_begun(begun), alone, "pixel {pixel} at {uv:?} by {way:?}");
        step(&mut uv, way);
        step(&mut begun, begun_way);
    }
}

fn check_sizes<T: Subject>()
where
    T::Texel: PartialEq + std::fmt::Debug,
{
    let mut random = Random(0x0123_4567_89AB_CDEF);
    let sizes =
        [[1, 1], [1, 8], [8, 1], [2, 2], [16, 4], [64, 64], [1, 4096], [4096, 1], [256, 512]];
    for size in sizes {
        let words = words::<T>(&mut random, size);
        for unit_bits in [0, 1, 4, 8, 12, 14, 15] {
            let place = |wraps| Place { size, wraps, unit_bits };
            use AnyWrap as W;
            let r = &mut random;
            check::<T, _, _>(r, &words, &place([W::Repeat, W::Repeat]), (Repeat, Repeat), 200);
            check::<T, _, _>(r, &words, &place([W::Clamp, W::Clamp]), (Clamp, Clamp), 200);
            check::<T, _, _>(r, &words, &place([W::Mirror, W::Mirror]), (Mirror, Mirror), 200);
            check::<T, _, _>(r, &words, &place([W::Repeat, W::Clamp]), (Repeat, Clamp), 100);
            check::<T, _, _>(r, &words, &place([W::Mirror, W::Repeat]), (Mirror, Repeat), 100);
            let any = (ClampAny, ClampAny);
            check::<T, _, _>(r, &words, &place([W::Clamp, W::Clamp]), any, 100);
        }
    }
    for size in [[3, 5], [100, 37], [1, 4095], [640, 3]] {
        let words = words::<T>(&mut random, size);
        for unit_bits in [0, 4, 8, 12, 15] {
            let place = Place { size, wraps: [AnyWrap::Clamp, AnyWrap::Clamp], unit_bits };
            check::<T, _, _>(&mut random, &words, &place, (ClampAny, ClampAny), 500);
        }
    }
}

macro_rules! formats_are_sampled {
    ($($name:ident: $format:ty;)*) => {
        $(#[test]
        fn $name() {
            check_sizes::<$format>();
        })*
    };
}

formats_are_sampled! {
    rgb565_is_sampled: Rgb565;
    little_endian_is_sampled: LittleEndian;
    big_endian_is_sampled: BigEndian<Rgba4444>;
    rgb888_is_sampled: Rgb888;
    bgr888_is_sampled: Bgr888;
    bgra8888_is_sampled: Bgra8888;
    rgba8888_is_sampled: Rgba8888;
    rgba5551_is_sampled: Rgba5551;
    rgba4444_is_sampled: Rgba4444;
    luminance8_is_sampled: Luminance8;
    alpha8_is_sampled: Alpha8;
    colors_are_sampled: Color;
    indexed8_of_rgb565_is_sampled: Indexed8<Rgb565>;
    indexed8_of_rgba8888_is_sampled: Indexed8<Rgba8888>;
    indexed8_of_colors_is_sampled: Indexed8<Color>;
    indexed4_of_rgb565_is_sampled: Indexed4<Rgb565>;
    indexed4_of_rgba8888_is_sampled: Indexed4<Rgba8888>;
    indexed4_of_colors_is_sampled: Indexed4<Color>;
}

#[test]
fn the_largest_texture_is_sampled() {
    let mut random = Random(99);
    let size = [4096, 4096];
    let bytes = words::<Luminance8>(&mut random, size);
    let pairs = words::<Rgb565>(&mut random, size);
    for unit_bits in [0, 12, 15] {
        let place = |wrap| Place { size, wraps: [wrap; 2], unit_bits };
        let r = &mut random;
        check::<Luminance8, _, _>(r, &bytes, &place(AnyWrap::Repeat), (Repeat, Repeat), 10_000);
        check::<Luminance8, _, _>(r, &bytes, &place(AnyWrap::Mirror), (Mirror, Mirror), 10_000);
        check::<Rgb565, _, _>(r, &pairs, &place(AnyWrap::Clamp), (Clamp, Clamp), 10_000);
        check::<Rgb565, _, _>(r, &pairs, &place(AnyWrap::Clamp), (ClampAny, ClampAny), 10_000);
    }
}

#[test]
fn a_565_texel_goes_unchanged_into_565_by_every_filter_and_under_white() {
    let white = Color::new(255, 255, 255);
    for raw in 0..=u16::MAX {
        let data = [raw];
        let texture = Texture::<Rgb565>::new(&data, 1, 1).expect("one texel");
        let nearest = Sampler::nearest(texture).expect("one is a power of two").sample(5, -9);
        let bilinear = Sampler::bilinear(texture).expect("one is a power of two");
        let fine = Sampler::new(texture, FineBilinear, Repeat, Repeat).expect("as before");
        let [bilinear, fine] = [bilinear.sample(1234, -77_777), fine.sample(1234, -77_777)];
        for color in [nearest, bilinear, fine, Modulate.combine(nearest, white)] {
            assert_eq!(Rgb565::pack(color), raw, "{raw:04x}");
        }
        let shown =
            [nearest.red(), nearest.green(), nearest.blue(), nearest.alpha()].map(f64::from);
        let off = furthest(shown, fields(raw.into(), P565));
        assert!(off <= 1.0, "{raw:04x}: {off} steps in RGBA8888");
        for mixed in [bilinear, fine] {
            let (mixed, nearest) = (Rgba8888::pack(mixed), Rgba8888::pack(nearest));
            assert_eq!(mixed, nearest, "{raw:04x} mixed with itself");
        }
        // Inside of a picture all four are read at once, and weights are not zero.
        let data = [raw; 16];
        let texture = Texture::<Rgb565>::new(&data, 4, 4).expect("16 texels");
        let bilinear = Sampler::bilinear(texture).expect("four is a power of two");
        let (u, v) = (i32::from(raw) << 11, i32::from(raw) << 7);
        assert_eq!(Rgb565::pack(bilinear.sample(u, v)), raw, "{raw:04x} in a picture");
    }
}

/// Samplers chosen at run time give the bits of the typed ones.
#[test]
fn any_sampler_equals_the_types() {
    fn typed<T: Subject, F: Filter, U: Wrap, V: Wrap>(
        texture: Texture<'_, T>,
        any: AnyTexture<'_>,
        (filter, any_filter): (F, AnyFilter),
        (across, any_across): (U, AnyWrap),
        (down, any_down): (V, AnyWrap),
    ) {
        let typed = Sampler::new(texture, filter, across, down).expect("powers of two");
        let any = AnySampler::new(any, any_filter, any_across, any_down).expect("powers of two");
        let (typed, any) = (typed.unit_bits(9), any.unit_bits(9));
        let mut random = Random(7);
        for _ in 0..200 {
            let (u, v) = (random.coordinate(9), random.coordinate(9));
            assert_eq!(any.fetch(u, v), Some(typed.sample(u, v)), "{any:?} at {u}, {v}");
        }
    }
    fn wraps<T: Subject>(any: impl Fn(Texture<'static, T>) -> AnyTexture<'static>) {
        let data = words::<T>(&mut Random(3), [8, 16]).leak();
        let texture = Texture::with_palette(data, T::PALETTE, 8, 16).expect("words are enough");
        let any = any(texture);
        let nearest = (Nearest, AnyFilter::Nearest);
        let bilinear = (Bilinear, AnyFilter::Bilinear);
        let fine = (FineBilinear, AnyFilter::FineBilinear);
        let repeat = (Repeat, AnyWrap::Repeat);
        let clamp = (Clamp, AnyWrap::Clamp);
        let mirror = (Mirror, AnyWrap::Mirror);
        typed(texture, any, nearest, repeat, clamp);
        typed(texture, any, nearest, clamp, mirror);
        typed(texture, any, nearest, mirror, repeat);
        typed(texture, any, bilinear, repeat, clamp);
        typed(texture, any, bilinear, clamp, mirror);
        typed(texture, any, bilinear, mirror, repeat);
        typed(texture, any, fine, repeat, mirror);
    }
    wraps::<Rgb565>(AnyTexture::Rgb565);
    wraps::<Rgba8888>(AnyTexture::Rgba8888);
    wraps::<Rgba5551>(AnyTexture::Rgba5551);
    wraps::<Rgba4444>(AnyTexture::Rgba4444);
    wraps::<Luminance8>(AnyTexture::Luminance8);
    wraps::<Alpha8>(AnyTexture::Alpha8);
    wraps::<Indexed8<Rgb565>>(AnyTexture::Indexed8);
    wraps::<Indexed8<Rgba8888>>(AnyTexture::Indexed8Rgba8888);
    wraps::<Indexed8<Color>>(AnyTexture::Indexed8Color);
    wraps::<Indexed4<Rgb565>>(AnyTexture::Indexed4);
    wraps::<Indexed4<Rgba8888>>(AnyTexture::Indexed4Rgba8888);
    wraps::<Indexed4<Color>>(AnyTexture::Indexed4Color);
}

#[test]
fn what_does_not_fit_is_an_error() {
    let new = |width, height, words: usize| {
        Texture::<Luminance8>::new(&vec![0; words], width, height).map(|_| ()).err()
    };
    assert_eq!(new(0, 4, 16), Some(TextureError::Empty), "no width");
    assert_eq!(new(4, 0, 16), Some(TextureError::Empty), "no height");
    assert_eq!(new(4097, 1, 5000), Some(TextureError::TooLarge { got: 4097 }), "too wide");
    assert_eq!(new(1, u16::MAX, 70_000), Some(TextureError::TooLarge { got: u16::MAX }), "high");
    assert_eq!(new(4, 4, 15), Some(TextureError::Length { needed: 16, got: 15 }), "too short");
    assert_eq!(new(4, 4, 17), None, "longer than needed");
    let halves = |words: usize| {
        Texture::<Indexed4>::with_palette(&vec![0; words], &[0; 16], 3, 3).map(|_| ()).err()
    };
    assert_eq!(halves(4), Some(TextureError::Length { needed: 5, got: 4 }), "nine halves");
    assert_eq!(halves(5), None, "nine halves");

    let odd = Texture::<Luminance8>::new(&[0; 12], 3, 4).expect("twelve texels");
    let error = TextureError::NotPowerOfTwo { width: 3, height: 4 };
    assert_eq!(Sampler::nearest(odd).err(), Some(error), "repeat");
    assert_eq!(Sampler::new(odd, Nearest, ClampAny, Clamp).err(), Some(error), "one axis only");
    assert!(Sampler::new(odd, Bilinear, ClampAny, ClampAny).is_ok(), "any size");
    assert_eq!(MipMap::<Luminance8>::new(&[0; 99], 3, 4).err(), Some(error), "mip-maps");
    let short = TextureError::Length { needed: 21, got: 20 };
    assert_eq!(MipMap::<Luminance8>::new(&[0; 20], 4, 4).err(), Some(short), "16 + 4 + 1");
}

#[test]
fn the_level_is_that_of_the_exact_derivative() {
    let mut random = Random(41);
    let mut seen = [0; 13];
    for _ in 0..200_000 {
        let bits = [(random.next() % 13) as u32, (random.next() % 13) as u32];
        let unit_bits = (random.next() % 16) as u32;
        let last = bits[0].max(bits[1]);
        let mut any = || (random.next() as i32) >> (random.next() % 32);
        let footprint = Footprint { right: [any(), any()], down: [any(), any()] };
        let got = footprint.level(bits, unit_bits, last);

        let [width, height] = bits.map(|bits| 1 << bits);
        let grid = TexelGrid { width, height, wraps: [AnyWrap::Repeat; 2] };
        let unit = f64::from(unit_bits + 16).exp2();
        let repeats = |way: [i32; 2]| way.map(|at| f64::from(at) / unit);
        let detail = grid.detail(repeats(footprint.right), repeats(footprint.down));
        // Within 2^-13 of the way of a border either is right.
        let [low, high] =
            [detail - 2e-4, detail + 1e-9].map(|detail| grid.nearest_level(detail) as u32);
        assert!((low..=high).contains(&got), "{footprint:?} {bits:?} 2^{unit_bits}: {got}");
        seen[got as usize] += 1;
    }
    assert!(seen.iter().all(|&times| times > 100), "every level was met: {seen:?}");
    assert_eq!(Footprint::default().level([12, 12], 12, 12), 0, "no way at all");
    let longest = Footprint { right: [i32::MIN; 2], down: [i32::MAX; 2] };
    assert_eq!(longest.level([12, 12], 0, 12), 12, "the longest way");
}

/// Every smaller picture is the mean of the one before it.
#[test]
fn mip_maps_are_means() {
    fn check_format<T: Subject + Reduce>(bits: [u32; 4], full: f64)
    where
        T::Word: Default,
    {
        let mut random = Random(11);
        for (w, h) in [(1, 1), (2, 2), (8, 8), (1, 16), (16, 1), (32, 4)] {
            let needed = MipMap::<T>::words_needed(w, h);
            let mut data = words::<T>(&mut random, [w, h]);
            data.resize(needed, T::Word::default());
            T::reduce(&mut data, w, h).expect("powers of two, enough words");
            let mips = MipMap::<T>::new(&data, w, h).expect("powers of two, enough words");
            assert_eq!(mips.levels(), w.max(h).ilog2() + 1, "{w}x{h}");
            let mut start = 0;
            for number in 1..mips.levels() {
                let (above, here) = (mips.level(number - 1), mips.level(number));
                let next = start + usize::from(above.width()) * usize::from(above.height());
                let (width, height) = (above.width().into(), above.height().into());
                let grid = TexelGrid { width, height, wraps: [AnyWrap::Clamp; 2] };
                let texels: Vec<Real> =
                    (start..next).map(|index| T::meaning(&data, index)).collect();
                let above = reference::Texture::new(grid, &texels).expect("as many texels");
                for (i, mean) in above.halved().texels().iter().enumerate() {
                    let got = T::meaning(&data, next + i);
                    for ((got, mean), bits) in got.into_iter().zip(mean).zip(bits) {
                        // Half a step of the stored channel.
                        let step = full / (f64::from(bits).exp2() - 1.0);
                        assert!((got - mean).abs() <= step / 2.0 + 1e-9, "{got} for {mean}");
                    }
                }
                assert_eq!(above.halved().grid().width, usize::from(here.width()), "{w}x{h}");
                start = next;
            }
            assert_eq!(start + 1, needed, "{w}x{h}: the last picture is one texel");
        }
    }
    check_format::<Rgb565>([5, 6, 5, 8], 255.0);
    check_format::<Rgba8888>([8; 4], 255.0);
    check_format::<Rgba5551>([5, 5, 5, 1], 255.0);
    check_format::<Rgba4444>([4; 4], 255.0);
    check_format::<Luminance8>([8; 4], 255.0);
    check_format::<Alpha8>([8; 4], 255.0);
}

#[test]
fn a_mip_sampler_reads_the_picture_that_suits() {
    // Each level has a grey of its own.
    let mut data = vec![10; 64];
    data.extend([20; 16].iter().chain(&[30; 4]).chain(&[40]));
    let mips = MipMap::<Luminance8>::new(&data, 8, 8).expect("85 texels");
    let sampler = MipSampler::new(mips, Bilinear, Repeat, Repeat).unit_bits(12);
    // One texel is 512 units.
    for (units, grey) in
        [(0, 10), (512, 10), (724, 10), (725, 20), (1448, 20), (1449, 30), (9000, 40)]
    {
        let ways = [([units, 0], [0, 0]), ([0, 0], [0, -units]), ([-units, 0], [0, units])];
        for (right, down) in ways {
            let [right, down] = [right, down].map(|way: [i32; 2]| way.map(|at| at << 16));
            let level = sampler.level(&Footprint { right, down });
            assert_eq!(level.sample(123_456, -99).red(), grey, "{units} units a pixel");
        }
    }
    // Indexed texels begin each picture with a new word.
    let halves = [0x11, 0x11, 0x20];
    let palette = std::array::from_fn(|i| i as u16);
    let mips =
        MipMap::<Indexed4>::with_palette(&halves, &palette, 2, 2).expect("two bytes and one");
    assert_eq!(MipMap::<Indexed4>::words_needed(2, 2), 3, "four halves, and one");
    let sampler = MipSampler::new(mips, Nearest, Repeat, Repeat);
    assert_eq!(Rgb565::pack(sampler.at(0).sample(0, 0)), 1, "the large picture");
    assert_eq!(Rgb565::pack(sampler.at(1).sample(0, 0)), 2, "the small one");
    assert_eq!(
        sampler.at(99).sample(5, 5),
        sampler.at(1).sample(5, 5),
        "numbers end with the last one"
    );
}

#[test]
fn environments_follow_their_formulas() {
    let mut random = Random(5);
    let mut worst = [0.0f64; 3];
    for _ in 0..300_000 {
        let mut color = || {
            let [r, g, b, a, extreme, ..] = random.next().to_le_bytes();
            let or = |value: u8, bit: u8| if extreme >> bit & 1 == 1 { value } else { 255 };
            Color::new(or(r, 0), or(g, 1), or(b, 2)).with_alpha(or(a, 3))
        };
        let (texel, surface) = (color(), color());
        let (t, s) = (real(texel), real(surface));
        let alpha = t[3] * s[3] / 255.0;
        let over = t[3] / 255.0;
        let each = |f: &dyn Fn(f64, f64) -> f64, alpha: f64| {
            [f(t[0], s[0]), f(t[1], s[1]), f(t[2], s[2]), alpha]
        };
        let expected = [
            each(&|t, s| t * s / 255.0, alpha),
            each(&|t, s| t * over + s * (1.0 - over), s[3]),
            each(&|t, s| (t + s).min(255.0), alpha),
        ];
        let got = [
            Modulate.combine(texel, surface),
            Decal.combine(texel, surface),
            Add.combine(texel, surface),
        ];
        for ((worst, got), expected) in worst.iter_mut().zip(got).zip(expected) {
            // What is shown: the value with its half, cut off.
            let shown = [got.red(), got.green(), got.blue(), got.alpha()].map(f64::from);
            let off = furthest(shown, expected);
            *worst = worst.max(off);
        }
        assert_eq!(Replace.combine(texel, surface), texel, "replaced");
        let any = [AnyEnvironment::Modulate, AnyEnvironment::Decal, AnyEnvironment::Add]
            .map(|any| any.combine(texel, surface));
        assert_eq!(any, got, "chosen at run time");
        assert_eq!(AnyEnvironment::Replace.combine(texel, surface), texel, "chosen at run time");

        let white = Color::new(255, 255, 255);
        let shown = |color: Color| [color.red(), color.green(), color.blue(), color.alpha()];
        assert_eq!(shown(Modulate.combine(texel, white)), shown(texel), "under white");
        let opaque = Decal.combine(texel.with_alpha(255), surface);
        assert_eq!(shown(opaque)[..3], shown(texel)[..3], "an opaque decal");
        let clear = Decal.combine(texel.with_alpha(0), surface);
        assert_eq!(shown(clear), shown(surface), "a decal that is not there");
    }
    let [modulate, decal, add] = worst;
    assert!(modulate <= 1.0, "modulate is {modulate} steps off");
    assert!(decal <= 1.0, "decal is {decal} steps off");
    assert!(add <= 1.0, "add is {add} steps off");
}
