use crate::math::BY_HALVES;

/// Whether one instruction stores several registers, each of them once.
const BY_GROUPS: bool = cfg!(target_arch = "arm");

/// Sets all of `pixels` to what is both halves of `word`: whole words where they are aligned.
///
/// `again` is `word` too, but the compiler is not to know: see below.
///
/// # Cost
/// Some 30 instructions on Cortex-M4 and one for eight words, some 40 on Cortex-M0+ and two for four
/// words, of rows of up to 320 pixels. Of longer ones half an instruction a word on Cortex-M4, one
/// on Cortex-M0+ and elsewhere.
#[inline(never)]
#[allow(clippy::cast_possible_truncation, reason = "both halves are the same")]
pub(crate) fn fill_halves(pixels: &mut [u16], word: u32, again: u32) {
    let mut pixels = pixels;
    if pixels.as_ptr().addr() & 2 != 0 {
        let Some((first, rest)) = pixels.split_first_mut() else { return };
        *first = word as u16;
        pixels = rest;
    }
    let length = pixels.len();
    if length & 1 != 0 {
        if let Some(last) = pixels.last_mut() {
            *last = word as u16;
        }
    }
    let Some(pairs) = pixels.get_mut(..length & !1) else { return };
    let Ok(words) = bytemuck::try_cast_slice_mut::<u16, u32>(pairs) else { return };
    if !BY_GROUPS {
        return fill_by_chunks(words, word);
    }
    if words.len() < if BY_HALVES { 4 } else { 8 } {
        return fill_one_by_one(words, word);
    }
    let is_filled = if BY_HALVES {
        fill_by_fours(words, fours(word, again))
    } else {
        fill_by_eights(words, eights(word, again))
    };
    if !is_filled {
        fill_words(words, word);
    }
}

/// Sets all of `words` to `word`.
#[inline(never)]
pub(crate) fn fill_words(words: &mut [u32], word: u32) {
    fill_by_chunks(words, word);
}

/// Few words.
#[inline(always)]
fn fill_one_by_one(words: &mut [u32], word: u32) {
    for one in words {
        *one = word;
        core::hint::black_box(());
    }
}

/// Words by stores of one register each.
#[inline(always)]
fn fill_by_chunks(words: &mut [u32], word: u32) {
    // What follows a loop's turn keeps the compiler from unrolling it further, and the last one
    // from being a call of memset, which costs more than a few stores.
    let Some(at) = words.len().checked_sub(16) else {
        return fill_one_by_one(words, word);
    };
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
}

// A store of several registers (`stm`) is made of stores to one place after the other, of registers
// that the compiler happens to have taken in ascending order. So values must be ones that it does not know
// to be equal; the order in which they are made and that in which they are stored were found by
// trying.

/// Four values that are all `word`, if `again` is.
#[inline(always)]
const fn fours(word: u32, again: u32) -> [u32; 4] {
    let zero = word.wrapping_sub(again);
    [word, again, again.wrapping_sub(zero), word.wrapping_add(zero)]
}

/// Eight values that are all `word`, if `again` is.
#[inline(always)]
const fn eights(word: u32, again: u32) -> [u32; 8] {
    let zero = word ^ again;
    let either = word | again;
    let again_more = again.wrapping_add(zero);
    let less = word.wrapping_sub(zero);
    let both = word & again;
    let again_less = again.wrapping_sub(zero);
    let more = word.wrapping_add(zero);
    [more, word, again, again_less, either, again_more, less, both]
}

/// As many groups as there are, if that is a number known beforehand.
#[inline(always)]
fn exactly<const N: usize, const K: usize>(groups: &mut [[u32; N]]) -> Option<&mut [[u32; N]; K]> {
    if groups.len() == K {
        groups.first_chunk_mut()
    } else {
        None
    }
}

/// Stores values in all groups, of which there are so many as one of the numbers: one store after the
/// other, entered where as many are left as there are groups, so that nothing is counted. Ends the
/// function with `false` if there are more.
///
/// Each store is where a jump may lead, thus apart from the others: the compiler then steps the
/// pointer by the store itself.
macro_rules! store_all {
    ($groups:ident, $values:ident, [$most:literal] $($enter:stmt;)*) => {{
        $($enter)*
        let Some(all) = exactly::<_, $most>($groups) else { return false };
        all
    }};
    ($groups:ident, $values:ident, [$here:literal $next:literal $($more:literal)*]
        $($enter:stmt;)*) => {
        'here: {
            let [group, rest @ ..]: &mut [_; $next] = store_all!(
                $groups, $values, [$next $($more)*] $($enter;)*
                if let Some(all) = exactly::<_, $here>($groups) { break 'here all };);
            *group = $values;
            core::hint::black_box(());
            rest
        }
    };
}

/// Eight words or more; `false` if they are too many.
#[inline(always)]
fn fill_by_eights(words: &mut [u32], values: [u32; 8]) -> bool {
    // Some are stored again below.
    if let Some(last) = words.last_chunk_mut() {
        *last = values;
    }
    core::hint::black_box(());
    let groups = words.as_chunks_mut().0;
    let _none: &mut [_; 0] = store_all!(
        groups, values, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20]);
    true
}

/// Four words or more; `false` if they are too many.
#[inline(always)]
fn fill_by_fours(words: &mut [u32], values: [u32; 4]) -> bool {
    let groups = words.as_chunks_mut().0;
    let _none: &mut [_; 0] = store_all!(
        groups, values, [0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20
            21 22 23 24 25 26 27 28 29 30 31 32 33 34 35 36 37 38 39 40]);
    // Some for the second time. Here the pointer to them takes no register of the stores.
    if let Some(last) = words.last_chunk_mut() {
        *last = values;
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_length_and_alignment_is_filled_and_nothing_else() {
        for start in 0..4 {
            for length in 0..100 {
                let mut pixels = [7u16; 104];
                if let Some(part) = pixels.get_mut(start..start + length) {
                    fill_halves(part, 0xABCD_ABCD, 0xABCD_ABCD);
                }
                for (i, &pixel) in pixels.iter().enumerate() {
                    let inside = i >= start && i < start + length;
                    let expected = if inside { 0xABCD } else { 7 };
                    assert_eq!(pixel, expected, "pixel {i} of {start}+{length}");
                }
            }
        }
    }

    /// All words of a row of each length, and whether it is not too long.
    fn check<const N: usize>(
        most: usize,
        values: fn(u32, u32) -> [u32; N],
        fill: fn(&mut [u32], [u32; N]) -> bool,
    ) {
        for word in [0, u32::MAX, 0xABCD_ABCD, 0x8000_8000, 0x0001_0001] {
            assert_eq!(values(word, word.rotate_right(16)), [word; N], "values of {word:x}");
            for length in N..=most + 2 * N {
                let mut words = [7; 200];
                let is_filled = fill(&mut words[1..=length], values(word, word));
                assert_eq!(is_filled, length < most + N, "{length} words");
                if is_filled {
                    assert!(words[1..=length].iter().all(|&one| one == word), "{length} words");
                }
                assert_eq!((words[0], words[length + 1]), (7, 7), "beside {length} words");
            }
        }
    }

    #[test]
    fn groups_of_all_numbers_are_filled() {
        check(160, eights, fill_by_eights);
        check(160, fours, fill_by_fours);
    }
}
