//! Textures of the least and the largest size, and coordinates at both ends.

use microraster::raster::ScreenVertex;
use microraster::texture::{
    AnyFilter, AnySampler, AnyTexture, AnyWrap, Sample, Texture, TextureError,
};
use microraster::{Exact, Format, Frame, PerspectiveCorner, Rgb565, ScreenPass, Size, Textured};

const FILTERS: [AnyFilter; 3] = [AnyFilter::Nearest, AnyFilter::Bilinear, AnyFilter::FineBilinear];
const WRAPS: [AnyWrap; 3] = [AnyWrap::Repeat, AnyWrap::Clamp, AnyWrap::Mirror];
const ENDS: [i16; 10] = [i16::MIN, -32_767, -32_766, -1, 0, 1, 255, 32_766, i16::MAX - 1, i16::MAX];

fn made(width: u16, height: u16, words: usize) -> Result<(), TextureError> {
    Texture::<Rgb565>::new(&vec![0; words], width, height).map(|_| ())
}

#[test]
fn sides_from_1_to_4096_make_a_texture_and_0_and_4097_do_not() {
    assert_eq!(made(0, 1, 9), Err(TextureError::Empty), "no column");
    assert_eq!(made(1, 0, 9), Err(TextureError::Empty), "no row");
    assert_eq!(made(1, 1, 1), Ok(()), "one texel");
    assert_eq!(made(1, 1, 0), Err(TextureError::Length { needed: 1, got: 0 }), "and no word");
    for side in [4095, 4096] {
        assert_eq!(made(side, 1, usize::from(side)), Ok(()), "{side} wide");
        assert_eq!(made(1, side, usize::from(side)), Ok(()), "{side} high");
    }
    for got in [4097, u16::MAX] {
        assert_eq!(made(got, 1, 70_000), Err(TextureError::TooLarge { got }), "{got} wide");
        assert_eq!(made(1, got, 70_000), Err(TextureError::TooLarge { got }), "{got} high");
    }
}

/// All samplers of a texture.
fn samplers<'a>(
    texture: Texture<'a, Rgb565>,
) -> impl Iterator<Item = (AnyFilter, AnyWrap, AnyWrap, u32, AnySampler<'a>)> {
    let filters = FILTERS.into_iter().flat_map(|filter| WRAPS.map(|across| (filter, across)));
    let wraps = filters.flat_map(|(filter, across)| WRAPS.map(|down| (filter, across, down)));
    wraps.flat_map(move |(filter, across, down)| {
        (0..=16).map(move |bits| {
            let sampler = AnySampler::new(AnyTexture::Rgb565(texture), filter, across, down);
            let sampler = sampler.expect("powers of two").unit_bits(bits);
            (filter, across, down, bits, sampler)
        })
    })
}

/// Coordinates with 16 fraction bits: of whole units, and a step beside them.
fn coordinates() -> impl Iterator<Item = i32> + Clone {
    let whole = |unit: i16| i32::from(unit) << 16;
    ENDS.into_iter().flat_map(move |unit| [whole(unit), whole(unit) + 1, whole(unit) | 0xFFFF])
}

#[test]
fn a_texture_of_one_texel_has_its_colour_at_every_coordinate() {
    let texels = [0xC5A3];
    let texture = Texture::<Rgb565>::new(&texels, 1, 1).expect("one texel");
    for (filter, across, down, bits, sampler) in samplers(texture) {
        for (u, v) in coordinates().flat_map(|u| coordinates().map(move |v| (u, v))) {
            let found = sampler.fetch(u, v).map(Rgb565::pack);
            let what = (filter, across, down, bits);
            assert_eq!(found, Some(0xC5A3), "{what:?} at {u:x}, {v:x}");
        }
    }
}

/// The number of the texel at a coordinate, by the definition of each wrap.
fn texel(wrap: AnyWrap, at: i32, bits: u32, side: i64) -> i64 {
    // Repeats of 2^bits units with 16 fraction bits each.
    let number = (i64::from(at) * side) >> (bits.min(15) + 16);
    match wrap {
        AnyWrap::Repeat => number.rem_euclid(side),
        AnyWrap::Clamp => number.clamp(0, side - 1),
        AnyWrap::Mirror => {
            let twice = number.rem_euclid(2 * side);
            twice.min(2 * side - 1 - twice)
        }
        other => panic!("no definition of {other:?}"),
    }
}

#[test]
fn a_texture_of_4096_x_4096_texels_is_read_to_its_last_one_at_both_ends_of_the_coordinates() {
    let word = |x: i64, y: i64| (x * 31 + y * 4_099) as u16;
    let texels: Vec<u16> = (0..4096).flat_map(|y| (0..4096).map(move |x| word(x, y))).collect();
    let texture = Texture::<Rgb565>::new(&texels, 4096, 4096).expect("the largest there is");
    let mut corners = [false; 4];
    for (filter, across, down, bits, sampler) in samplers(texture) {
        for (u, v) in coordinates().flat_map(|u| coordinates().map(move |v| (u, v))) {
            let found = sampler.fetch(u, v).map(Rgb565::pack);
            if filter != AnyFilter::Nearest {
                assert!(found.is_some(), "{filter:?} at {u:x}, {v:x}");
                continue;
            }
            let at = (texel(across, u, bits, 4096), texel(down, v, bits, 4096));
            let what = (across, down, bits);
            assert_eq!(found, Some(word(at.0, at.1)), "{what:?} at {u:x}, {v:x}: {at:?}");
            for (corner, seen) in
                [(0, 0), (4095, 0), (0, 4095), (4095, 4095)].iter().zip(&mut corners)
            {
                *seen |= *corner == at;
            }
        }
    }
    assert_eq!(corners, [true; 4], "all corners are met");
}

#[test]
fn triangles_with_coordinates_from_end_to_end_show_nothing_but_the_texture() {
    // Two colours only, in no order that a step beyond the texture would keep.
    let texels: Vec<u16> =
        (0..64 * 32).map(|i| if i * 7 % 5 < 2 { 0xF800 } else { 0x07E0 }).collect();
    let texture = Texture::<Rgb565>::new(&texels, 64, 32).expect("texels for its size");
    let size = Size::new(96, 80);
    for (filter, across, down, bits, sampler) in samplers(texture) {
        if filter != AnyFilter::Nearest {
            continue;
        }
        for w in [[1, 1, 1], [1, 1 << 20, 300]] {
            let mut pixels = vec![1; 96 * 80];
            let mut frame = Frame::<Rgb565>::new(&mut pixels, size).expect("it fits");
            let at = |x: i32, y: i32| ScreenVertex::from_bits(16 * x, 16 * y, 0);
            let corner = |u: i16, v: i16, w: i32| ((), PerspectiveCorner::new([u, v], w));
            let triangle = [
                (at(0, 0), corner(i16::MIN, -32_767, w[0])),
                (at(96, 0), corner(i16::MAX, -1, w[1])),
                (at(0, 80), corner(-32_767, i16::MAX, w[2])),
            ];
            let shader = Textured::new(sampler).perspective(Exact);
            ScreenPass::new().triangle(&mut frame, &shader, &triangle);
            let what = (across, down, bits, w);
            let drawn = pixels.iter().filter(|pixel| **pixel != 1);
            assert!(drawn.clone().count() > 3_000, "{what:?}");
            assert!(drawn.clone().all(|raw| [0xF800, 0x07E0].contains(raw)), "{what:?}");
        }
    }
}
