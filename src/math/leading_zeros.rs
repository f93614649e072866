use super::BY_HALVES;

/// A number of zeros in a byte. As the compiler knows the range, a shift by it needs no mask.
#[derive(Clone, Copy)]
#[repr(u8)]
enum Zeros {
    None,
    One,
    Two,
    Three,
    Four,
    Five,
    Six,
    Seven,
    All,
}

/// Leading zeros of a byte.
static ZEROS: [Zeros; 256] = {
    let mut zeros = [Zeros::All; 256];
    let mut byte = 1_u8;
    loop {
        zeros[byte as usize] = match byte.leading_zeros() {
            0 => Zeros::None,
            1 => Zeros::One,
            2 => Zeros::Two,
            3 => Zeros::Three,
            4 => Zeros::Four,
            5 => Zeros::Five,
            6 => Zeros::Six,
            _ => Zeros::Seven,
        };
        if byte == u8::MAX {
            break zeros;
        }
        byte += 1;
    }
};

/// The zeros above the highest bit of a byte.
#[inline(always)]
pub(crate) fn zeros_of_byte(byte: u32) -> u32 {
    ZEROS[(byte & 0xFF) as usize] as u32
}

/// The zeros above the highest bit that is set.
///
/// ARMv6-M has no instruction for it, and the compiler calls a routine that takes 27; there it is
/// about 8 by a table.
#[inline(always)]
pub(crate) fn leading_zeros(n: u32) -> u32 {
    if BY_HALVES {
        by_table(n)
    } else {
        n.leading_zeros()
    }
}

/// The same by a table.
#[inline(always)]
fn by_table(n: u32) -> u32 {
    let (byte, above) = match n {
        0x0100_0000.. => (n >> 24, 0),
        0x0001_0000.. => (n >> 16, 8),
        0x0000_0100.. => (n >> 8, 16),
        _ => (n, 24),
    };
    zeros_of_byte(byte).wrapping_add(above)
}

#[cfg(test)]
mod tests {
    use super::by_table;
    use crate::math::hard_numbers::{Random, WORDS};

    #[test]
    fn a_table_counts_what_the_instruction_counts() {
        let mut random = Random::new(33);
        let randoms = (0..100_000).map(|_| {
            let word = random.word();
            word >> (word & 31)
        });
        let powers = (0..32).flat_map(|bit| [1_u32 << bit, (1 << bit) - 1, (1 << bit) + 1]);
        for n in WORDS.into_iter().chain(powers).chain(0..70_000).chain(randoms) {
            assert_eq!(by_table(n), n.leading_zeros(), "{n:#x}");
        }
    }
}
