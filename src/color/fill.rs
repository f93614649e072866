/// Sets all of `pixels` to what repeats in `word`, by whole words where they are aligned.
///
/// `raw` is one pixel, `word` the same pixel as often as it fits into 32 bits.
#[inline(never)]
pub(crate) fn fill_words<T: bytemuck::Pod>(pixels: &mut [T], raw: T, word: u32) {
    let (head, words, tail) = bytemuck::pod_align_to_mut::<T, u32>(pixels);
    for pixel in head {
        *pixel = raw;
    }
    let mut chunks = words.chunks_exact_mut(16);
    for chunk in &mut chunks {
        for one in chunk {
            *one = word;
        }
        // Sixteen stores are enough in a row: more would cost what leads up to them.
        core::hint::black_box(());
    }
    for one in chunks.into_remainder() {
        *one = word;
        // Keeps the short rest a loop: a call of memset costs more than its stores.
        core::hint::black_box(());
    }
    for pixel in tail {
        *pixel = raw;
    }
}

#[cfg(test)]
mod tests {
    use super::fill_words;

    #[test]
    fn every_length_and_alignment_is_filled_and_nothing_else() {
        for start in 0..4 {
            for length in 0..40 {
                let mut pixels = [7u16; 48];
                if let Some(part) = pixels.get_mut(start..start + length) {
                    fill_words(part, 0xABCD, 0xABCD_ABCD);
                }
                for (i, &pixel) in pixels.iter().enumerate() {
                    let inside = i >= start && i < start + length;
                    let expected = if inside { 0xABCD } else { 7 };
                    assert_eq!(pixel, expected, "pixel {i} of {start}+{length}");
                }
            }
        }
    }
}
