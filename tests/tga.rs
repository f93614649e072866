//! TGA pictures, read back by two readers that share no code with the writer: a few lines of our
//! own, and the crate `image`.
#![cfg(feature = "std")]

#[path = "support/tga_reader.rs"]
mod tga_reader;

use microraster::host::{AtomicFile, Tga, TgaDepth, TgaError, TgaOrigin};
use std::fs;
use std::io::Write;
use tga_reader::read;

/// Every pixel differs, in every channel, and no two neighbours are alike.
fn picture(width: usize, height: usize) -> Vec<[u8; 4]> {
    (0..width * height)
        .map(|i| [i * 7, i * 13 + 1, i * 29 + 2, i * 53 + 3].map(|c| c.to_le_bytes()[0]))
        .collect()
}

fn write(tga: Tga, pixels: &[[u8; 4]]) -> Vec<u8> {
    let mut file = Vec::new();
    tga.write(&mut file, pixels).expect("a Vec takes all bytes");
    file
}

#[test]
fn header_is_what_the_format_says() {
    let file = write(Tga::new(258, 3).unwrap(), &picture(258, 3));
    assert_eq!(
        file[..18],
        [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 1, 3, 0, 32, 0x28],
        "true colour, 258 x 3, 32 bits, 8 of alpha, top left"
    );
    let bottom = Tga::new(2, 2).unwrap().origin(TgaOrigin::BottomLeft);
    assert_eq!(write(bottom, &picture(2, 2))[17], 0x08, "bottom left");
    let small = Tga::new(2, 2).unwrap().depth(TgaDepth::A1r5g5b5);
    assert_eq!(write(small, &picture(2, 2))[16..18], [16, 0x21], "A1R5G5B5");
}

#[test]
fn both_origins_read_back_as_written() {
    for (width, height) in [(1, 1), (3, 2), (17, 31), (65535, 1), (1, 65535), (0, 5), (5, 0)] {
        let pixels = picture(width, height);
        for origin in [TgaOrigin::TopLeft, TgaOrigin::BottomLeft] {
            let file = write(Tga::new(width, height).unwrap().origin(origin), &pixels);
            assert_eq!(read(&file), (width, height, pixels.clone()), "{origin:?}");
        }
    }
}

#[test]
fn the_image_crate_reads_the_same_pixels() {
    let pixels = picture(19, 11);
    for origin in [TgaOrigin::TopLeft, TgaOrigin::BottomLeft] {
        let file = write(Tga::new(19, 11).unwrap().origin(origin), &pixels);
        let seen = image::load_from_memory_with_format(&file, image::ImageFormat::Tga)
            .expect("a TGA picture")
            .to_rgba8();
        assert_eq!(seen.dimensions(), (19, 11), "{origin:?}");
        let seen: Vec<[u8; 4]> = seen.pixels().map(|p| p.0).collect();
        assert_eq!(seen, pixels, "{origin:?}");
    }
}

#[test]
fn sixteen_bits_keep_five_of_each_channel() {
    let pixels = picture(16, 16);
    let file = write(Tga::new(16, 16).unwrap().depth(TgaDepth::A1r5g5b5), &pixels);
    let five = |c: u8| (c & 0xf8) | (c >> 5);
    let expected: Vec<[u8; 4]> = pixels
        .iter()
        .map(|&[r, g, b, a]| [five(r), five(g), five(b), if a >= 128 { 255 } else { 0 }])
        .collect();
    assert_eq!(read(&file), (16, 16, expected), "five bits a channel");
    // Green 4 and green 0 differ in RGB565 (sixth bit); here they are one.
    assert_eq!(
        write(Tga::new(1, 1).unwrap().depth(TgaDepth::A1r5g5b5), &[[0, 4, 0, 255]]),
        write(Tga::new(1, 1).unwrap().depth(TgaDepth::A1r5g5b5), &[[0, 0, 0, 255]]),
        "the sixth bit of green is lost"
    );
}

#[test]
fn wrong_sizes_are_errors_and_write_nothing() {
    assert!(
        matches!(Tga::new(65536, 1), Err(TgaError::TooLarge { width: 65536, height: 1 })),
        "too wide"
    );
    let mut file = Vec::new();
    let result = Tga::new(2, 2).unwrap().write(&mut file, &picture(3, 1));
    assert!(matches!(result, Err(TgaError::WrongLength { needed: 4, got: 3 })), "{result:?}");
    assert_eq!(result.unwrap_err().to_string(), "the picture needs 4 pixels and got 3");
    assert!(file.is_empty(), "nothing is written");
}

#[test]
fn a_file_appears_whole_or_not_at_all() {
    let folder = std::env::temp_dir().join(format!("microraster-tga-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let path = folder.join("picture.tga");
    let names = || {
        let mut names: Vec<_> =
            fs::read_dir(&folder).unwrap().map(|e| e.unwrap().file_name()).collect();
        names.sort();
        names
    };

    // Dropped without commit: nothing stays.
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(b"half").unwrap();
    drop(file);
    assert!(names().is_empty(), "an abandoned file leaves nothing");

    // Committed: the old bytes stay until then.
    fs::write(&path, b"old").unwrap();
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(b"new").unwrap();
    file.seal().unwrap();
    assert!(file.write_all(b"!").is_err(), "a sealed file takes nothing");
    assert_eq!(fs::read(&path).unwrap(), b"old", "not yet");
    file.commit().unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new", "now");
    assert_eq!(names(), ["picture.tga"], "no temporary file stays");

    // Never in place of a folder.
    assert!(AtomicFile::create(&folder).is_err(), "a folder is no file");
    fs::remove_dir_all(&folder).unwrap();
}
