//! The texture of the tilted planes, and the ways of reading it.

#![allow(clippy::cast_possible_truncation, reason = "texels of 16 bits")]

use microraster::texture::{
    Bilinear, Filter, FineBilinear, MipMap, MipSampler, Nearest, Repeat, Sample, Sampler, Texture,
};
use microraster::Rgb565;

/// Texels along each side.
pub(crate) const SIDE: u16 = 128;

const WORDS: usize = MipMap::<Rgb565>::words_needed(SIDE, SIDE);

/// Checks of 8 texels with a ramp across and one down, and all smaller pictures of it.
pub(crate) static WORDS_OF_LEVELS: [u16; WORDS] = {
    let side = SIDE as usize;
    let (mut words, mut i) = ([0; WORDS], 0);
    while i < side * side {
        let (x, y) = (i % side, i / side);
        let check = (x / 8 + y / 8) % 2;
        words[i] = ((x / 4) << 11 | (y / 2) << 5 | (check * 31)) as u16;
        i += 1;
    }
    match MipMap::<Rgb565>::reduce(&mut words, SIDE, SIDE) {
        Ok(()) => words,
        Err(_) => panic!("as many words as are needed"),
    }
};

const LEVELS: MipMap<'static, Rgb565> = match MipMap::new(&WORDS_OF_LEVELS, SIDE, SIDE) {
    Ok(levels) => levels,
    Err(_) => panic!("as many words as are needed"),
};

/// A way of reading the texture.
pub(crate) trait Reading {
    /// What reads it.
    type Sampler: Sample + Copy;
    /// A sampler for which one repeat is 2^`unit_bits` units of the vertices.
    fn sampler(unit_bits: u32) -> Option<Self::Sampler>;
}

/// By a filter, from the largest picture.
pub(crate) struct Plain<F>(F);

impl<F: Filter + Default> Reading for Plain<F> {
    type Sampler = Sampler<'static, Rgb565, F>;

    fn sampler(unit_bits: u32) -> Option<Self::Sampler> {
        let texture: Texture<'static, Rgb565> = LEVELS.base();
        let sampler = Sampler::new(texture, F::default(), Repeat, Repeat).ok()?;
        Some(sampler.unit_bits(unit_bits))
    }
}

/// By a filter, from the picture whose texels suit.
pub(crate) struct Mip<F>(F);

impl<F: Filter + Default> Reading for Mip<F> {
    type Sampler = MipSampler<'static, Rgb565, F>;

    fn sampler(unit_bits: u32) -> Option<Self::Sampler> {
        Some(MipSampler::new(LEVELS, F::default(), Repeat, Repeat).unit_bits(unit_bits))
    }
}

pub(crate) type ByNearest = Plain<Nearest>;
pub(crate) type ByBilinear = Plain<Bilinear>;
pub(crate) type ByFineBilinear = Plain<FineBilinear>;
pub(crate) type ByMipNearest = Mip<Nearest>;
pub(crate) type ByMipBilinear = Mip<Bilinear>;
