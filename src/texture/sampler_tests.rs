//! Rows that are mixed before they are drawn show what is fetched pixel by pixel.

#![allow(clippy::cast_possible_truncation, reason = "numbers are cut to what is wanted")]

extern crate std;
use super::{Sample, Sampler};
use crate::color::{Color, Format, Rgb565, Rgb565Be, Rgba8888};
use crate::math::hard_numbers::Random;
use crate::shade::Uv;
use crate::texture::{Bilinear, Clamp, Mirror, Repeat, Texture, Wrap};
use std::vec::Vec;

/// Compares rows of a texture; how many there were.
fn compare<V: Wrap>(random: &mut Random, texture: Texture<'_, Rgb565>, down: V) -> u32 {
    let sampler = Sampler::new(texture, Bilinear, Repeat, down).expect("sides are powers of two");
    let mut rows = 0;
    for _ in 0..40 {
        let texel = 1u32 << 28 >> texture.width().trailing_zeros();
        let way = match random.word() % 4 {
            0 => random.word().cast_signed() >> (random.word() % 32),
            1 => (texel.wrapping_sub(random.word() % 3)).cast_signed(),
            _ => (random.word() % texel.max(1)).cast_signed(),
        };
        let [u, v] = [random.word().cast_signed(), random.word().cast_signed()];
        let (begun, way) =
            (Sample::begin(&sampler, Uv { u, v }), sampler.begun_way(Uv { u: way, v: 0 }));
        if !sampler.mixes(way) {
            continue;
        }
        rows += 1;
        let mut mixed = [0; 40];
        let mixed = &mut mixed[..random.word() as usize % 41];
        assert_eq!(sampler.mix_row(begun, way.u, mixed), Some(()), "the texture has all its data");
        for (number, word) in (0i32..).zip(mixed.iter()) {
            let at = Uv { u: begun.u.wrapping_add(way.u.wrapping_mul(number)), v: begun.v };
            let surface = Color { blue_red: random.word(), green: random.word() };
            let plain = Sample::fetch_begun(&sampler, at).expect("a texel");
            let lit = sampler.modulate_begun(at, surface).expect("a texel");
            check::<Rgb565, V>(*word, plain, lit, surface);
            check::<Rgb565Be, V>(*word, plain, lit, surface);
            check::<Rgba8888, V>(*word, plain, lit, surface);
        }
    }
    rows
}

fn check<F: Format, V: Wrap>(word: u32, plain: Color, lit: Color, surface: Color)
where
    F::Raw: PartialEq + core::fmt::Debug,
{
    type Of<'a, V> = Sampler<'a, Rgb565, Bilinear, Repeat, V>;
    assert_eq!(<Of<'_, V>>::show_mixed::<F>(word, None), F::pack(plain), "plain");
    assert_eq!(
        <Of<'_, V>>::show_mixed::<F>(word, Some(surface)),
        F::pack(lit),
        "under {surface:?}"
    );
}

#[test]
fn rows_that_are_mixed_show_what_is_fetched() {
    let mut random = Random::new(91);
    let mut rows = 0;
    for _ in 0..300 {
        let [width, height] = [(); 2].map(|()| 1u16 << (random.word() % 7));
        let texels: Vec<u16> = (0..u32::from(width) * u32::from(height))
            .map(|_| match random.word() % 8 {
                0 => 0,
                1 => u16::MAX,
                _ => random.word() as u16,
            })
            .collect();
        let texture = Texture::new(&texels, width, height).expect("as many texels");
        rows += compare(&mut random, texture, Repeat);
        rows += compare(&mut random, texture, Mirror);
        rows += compare(&mut random, texture, Clamp);
    }
    assert!(rows > 10_000, "{rows} rows were mixed");
}
