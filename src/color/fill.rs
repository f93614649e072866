/// Sets all of `pixels` to what repeats in `word`, by whole words where they are aligned.
///
/// `raw` is one pixel, `word` the same pixel as often as it fits into 32 bits.
#[inline(never)]
pub(crate) fn fill_words<T: bytemuck::Pod>(pixels: &mut [T], raw: T, word: u32) {
    let (head, words, tail) = bytemuck::pod_align_to_mut::<T, u32>(pixels);
    for pixel in head {
        *pixel = raw;
    }
    // What follows a loop's turn keeps the compiler from unrolling it further, and the last one
    // from being a call of memset, which costs more than a few stores.
    if let Some(at) = words.len().checked_sub(16) {
        // The last sixteen, as from a place that is not known: some are stored again below.
        let last = words.get_mut(core::hint::black_box(at)..).and_then(|w| w.first_chunk_mut());
        if let Some(last) = last {
            *last = [word; 16];
        }
        let (chunks, rest) = words.as_chunks_mut::<32>();
        for chunk in chunks {
            *chunk = [word; 32];
            core::hint::black_box(());
        }
        if let Some(chunk) = rest.first_chunk_mut() {
            *chunk = [word; 16];
        }
    } else {
        for one in words {
            *one = word;
            core::hint::black_box(());
        }
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
            for length in 0..100 {
                let mut pixels = [7u16; 104];
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
