//! Images that `embedded-graphics` and its readers show are textures as they are, without a copy.
#![cfg(feature = "embedded-graphics")]
#![allow(clippy::expect_used, reason = "a picture that cannot be drawn is a failure")]
#![allow(clippy::cast_possible_truncation, reason = "sides of small pictures")]

use embedded_graphics::image::{GetPixel, ImageRaw};
use embedded_graphics::pixelcolor::raw;
use embedded_graphics::pixelcolor::{Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use microraster::texture::{
    Bgr888, Bgra8888, BigEndian, LittleEndian, Luminance8, Nearest, Repeat, Sampler, TexelFormat,
    Texture,
};
use microraster::Color;

const WIDTH: u16 = 8;
const HEIGHT: u16 = 4;
const TEXELS: usize = 32;

/// Bytes without a pattern.
fn noise<const N: usize>() -> [u8; N] {
    let mut bits = 1u32;
    core::array::from_fn(|_| {
        bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
        (bits >> 24) as u8
    })
}

/// Eight bits a channel, as they are shown.
fn channels(color: Color) -> [u8; 3] {
    [color.red(), color.green(), color.blue()]
}

/// The channels of a texture's texels, row by row.
fn texels<T: TexelFormat<Palette = ()>>(words: &[T::Word]) -> Vec<[u8; 3]> {
    let texture = Texture::<T>::new(words, WIDTH, HEIGHT).expect("the size fits the data");
    let sampler = Sampler::new(texture, Nearest, Repeat, Repeat).expect("powers of two");
    let sampler = sampler.unit_bits(12);
    let places = (0..i32::from(HEIGHT)).flat_map(|y| (0..i32::from(WIDTH)).map(move |x| (x, y)));
    // Places of 16 bits of fraction, 2^12 units a side, at the middle of each texel.
    let color = |(x, y)| sampler.sample((2 * x + 1) << (28 - 4), (2 * y + 1) << (28 - 3));
    places.map(|place| channels(color(place))).collect()
}

/// The pixels that a target gets, as bits of the channels.
fn shown<C: PixelColor>(
    image: &impl GetPixel<Color = C>,
    channels: fn(C) -> [u8; 3],
) -> Vec<[u8; 3]> {
    let places = (0..i32::from(HEIGHT)).flat_map(|y| (0..i32::from(WIDTH)).map(move |x| (x, y)));
    places.map(|(x, y)| channels(image.pixel(Point::new(x, y)).expect("inside"))).collect()
}

/// Five and six bits, repeated into eight.
fn of_rgb565(color: Rgb565) -> [u8; 3] {
    let [r, g, b] = [color.r(), color.g(), color.b()];
    [r << 3 | r >> 2, g << 2 | g >> 4, b << 3 | b >> 2]
}

fn of_rgb888(color: Rgb888) -> [u8; 3] {
    [color.r(), color.g(), color.b()]
}

#[test]
fn raw_images_show_the_same_as_textures() {
    let bytes = noise::<{ 2 * TEXELS + 1 }>();
    // An odd address as well as an even one.
    for bytes in [&bytes[..2 * TEXELS], &bytes[1..]] {
        let image = ImageRaw::<Rgb565, raw::BigEndian>::new(bytes, WIDTH.into());
        assert_eq!(texels::<BigEndian>(bytes.as_chunks().0), shown(&image, of_rgb565), "big");
        let image = ImageRaw::<Rgb565, raw::LittleEndian>::new(bytes, WIDTH.into());
        assert_eq!(texels::<LittleEndian>(bytes.as_chunks().0), shown(&image, of_rgb565), "little");
    }
    let bytes = noise::<{ 3 * TEXELS }>();
    let image = ImageRaw::<Rgb888>::new(&bytes, WIDTH.into());
    let expected = shown(&image, of_rgb888);
    assert_eq!(texels::<microraster::texture::Rgb888>(bytes.as_chunks().0), expected, "24 bits");
    let bytes = noise::<TEXELS>();
    let image = ImageRaw::<Gray8>::new(&bytes, WIDTH.into());
    let grey = |color: Gray8| [color.luma(); 3];
    assert_eq!(texels::<Luminance8>(&bytes), shown(&image, grey), "grey");
}

/// A BMP file of so many bits a pixel, with masks where there are 16.
fn bmp(bits: u16, pixels: &[u8]) -> Vec<u8> {
    let masks: &[u32] = if bits == 16 { &[0xF800, 0x07E0, 0x001F, 0] } else { &[] };
    // The header of version 4 has room for masks.
    let header = if bits == 16 { 108 } else { 40 };
    let start = 14 + header;
    let mut file = b"BM".to_vec();
    file.extend(((start + pixels.len()) as u32).to_le_bytes());
    file.extend([0; 4]);
    file.extend((start as u32).to_le_bytes());
    file.extend((header as u32).to_le_bytes());
    file.extend(u32::from(WIDTH).to_le_bytes());
    file.extend(u32::from(HEIGHT).to_le_bytes());
    file.extend(1u16.to_le_bytes());
    file.extend(bits.to_le_bytes());
    file.extend(if bits == 16 { 3u32 } else { 0 }.to_le_bytes());
    file.extend((pixels.len() as u32).to_le_bytes());
    file.extend([0; 16]);
    file.extend(masks.iter().flat_map(|mask| mask.to_le_bytes()));
    file.resize(start, 0);
    file.extend(pixels);
    file
}

/// The rows of a picture in the other order.
fn turned(texels: &[[u8; 3]]) -> Vec<[u8; 3]> {
    texels.chunks(WIDTH.into()).rev().flatten().copied().collect()
}

#[test]
fn bmp_files_show_the_same_as_textures_from_the_lowest_row_up() {
    let file = bmp(16, &noise::<{ 2 * TEXELS }>());
    let image = tinybmp::Bmp::<Rgb565>::from_slice(&file).expect("a file by the book");
    let data = image.as_raw().image_data();
    let expected = turned(&shown(&image, of_rgb565));
    assert_eq!(texels::<LittleEndian>(data.as_chunks().0), expected, "16 bits");

    let file = bmp(24, &noise::<{ 3 * TEXELS }>());
    let image = tinybmp::Bmp::<Rgb888>::from_slice(&file).expect("a file by the book");
    let data = image.as_raw().image_data();
    assert_eq!(texels::<Bgr888>(data.as_chunks().0), turned(&shown(&image, of_rgb888)), "24 bits");
}

/// A TGA file of so many bits a pixel, from the upper row down.
fn tga(bits: u8, pixels: &[u8]) -> Vec<u8> {
    let kind = if bits == 8 { 3 } else { 2 };
    let mut file = vec![0, 0, kind, 0, 0, 0, 0, 0, 0, 0, 0, 0];
    file.extend(WIDTH.to_le_bytes());
    file.extend(HEIGHT.to_le_bytes());
    file.extend([bits, 0x20 | if bits == 32 { 8 } else { 0 }]);
    file.extend(pixels);
    file
}

#[test]
fn tga_files_show_the_same_as_textures() {
    let pixels = noise::<{ 3 * TEXELS }>();
    let file = tga(24, &pixels);
    let image = tinytga::Tga::<Rgb888>::from_slice(&file).expect("a file by the book");
    let data = image.as_raw().image_data();
    let expected = texels::<Bgr888>(data.as_chunks().0);
    assert_eq!(expected, drawn(&image), "24 bits");

    // The reader of `embedded-graphics` shows no file of 32 bits; it finds the data of one.
    let file = tga(32, &noise::<{ 4 * TEXELS }>());
    let format = image::ImageFormat::Tga;
    let read = image::load_from_memory_with_format(&file, format).expect("a file by the book");
    let expected: Vec<_> = read.to_rgb8().pixels().map(|pixel| pixel.0).collect();
    let raw = tinytga::RawTga::from_slice(&file).expect("a file by the book");
    assert_eq!(texels::<Bgra8888>(raw.image_data().as_chunks().0), expected, "32 bits");

    let file = tga(8, &noise::<TEXELS>());
    let image = tinytga::Tga::<Rgb888>::from_slice(&file).expect("a file by the book");
    assert_eq!(texels::<Luminance8>(image.as_raw().image_data()), drawn(&image), "8 bits");
}

/// What an image draws.
fn drawn(image: &impl ImageDrawable<Color = Rgb888>) -> Vec<[u8; 3]> {
    let mut pixels = [0; TEXELS];
    let size = microraster::Size::new(WIDTH, HEIGHT);
    let mut frame = microraster::Frame::<microraster::Rgba8888>::new(&mut pixels, size)
        .expect("the buffer fits");
    let Ok(()) = image.draw(&mut frame);
    let channels = |pixel: &u32| {
        let [red, green, blue, _] = pixel.to_ne_bytes();
        [red, green, blue]
    };
    pixels.iter().map(channels).collect()
}
