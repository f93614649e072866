//! TGA pictures of any size, origin and depth from raw bytes, written and read back. The crate
//! reads none itself.
#![no_main]

#[path = "../../tests/support/tga_reader.rs"]
mod tga_reader;

use libfuzzer_sys::fuzz_target;
use microraster::host::{Tga, TgaDepth, TgaOrigin};

fuzz_target!(|data: &[u8]| {
    let Some(([width, height, form], rest)) = data.split_first_chunk::<3>() else { return };
    let (width, height) = (usize::from(*width), usize::from(*height));
    let origin = if form & 1 == 0 { TgaOrigin::TopLeft } else { TgaOrigin::BottomLeft };
    let is_short = form & 2 != 0;
    let depth = if is_short { TgaDepth::A1r5g5b5 } else { TgaDepth::Bgra32 };
    // As many pixels as the bytes make, which may be too few or too many.
    let mut pixels = rest.as_chunks::<4>().0.to_vec();
    let is_exact = form & 4 != 0;
    if is_exact {
        pixels.resize(width * height, [1, 2, 3, 4]);
    }
    let tga = Tga::new(width, height).expect("a size below 65536").origin(origin).depth(depth);
    let mut file = Vec::new();
    let result = tga.write(&mut file, &pixels);
    assert_eq!(result.is_ok(), pixels.len() == width * height, "{result:?}");
    if result.is_err() {
        assert!(file.is_empty(), "nothing is written");
        return;
    }
    if is_short {
        let five = |c: u8| (c & 0xF8) | (c >> 5);
        for [red, green, blue, alpha] in &mut pixels {
            (*red, *green, *blue) = (five(*red), five(*green), five(*blue));
            *alpha = if *alpha < 128 { 0 } else { 255 };
        }
    }
    assert_eq!(tga_reader::read(&file), (width, height, pixels), "read back");
});
