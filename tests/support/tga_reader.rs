//! A reader of TGA pictures that shares no code with the writer.

/// Rows from the top of red, green, blue, alpha; by the letter of the specification.
pub(crate) fn read(file: &[u8]) -> (usize, usize, Vec<[u8; 4]>) {
    assert_eq!(file[..3], [0, 0, 2], "no id, no palette, true colour");
    assert_eq!(file[3..12], [0; 9], "no palette, origin 0, 0");
    let word = |at: usize| usize::from(u16::from_le_bytes([file[at], file[at + 1]]));
    let (width, height) = (word(12), word(14));
    let bytes = usize::from(file[16]) / 8;
    let rows = &file[18..];
    assert_eq!(rows.len(), width * height * bytes, "nothing but pixels");
    let mut pixels: Vec<[u8; 4]> = rows
        .chunks_exact(bytes)
        .map(|p| match *p {
            [b, g, r, a] => [r, g, b, a],
            [low, high] => {
                let word = u16::from_le_bytes([low, high]);
                let eight = |shift: u16| {
                    let five = ((word >> shift) & 31) as u8;
                    (five << 3) | (five >> 2)
                };
                [eight(10), eight(5), eight(0), if word >> 15 == 1 { 255 } else { 0 }]
            }
            _ => panic!("pixels of {bytes} bytes"),
        })
        .collect();
    if file[17] & 0x20 == 0 {
        pixels = pixels.chunks(width.max(1)).rev().flatten().copied().collect();
    }
    (width, height, pixels)
}
