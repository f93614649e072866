//! Products of 32-bit numbers to 64 bits.
//!
//! ARMv6-M multiplies to 32 bits only; there the compiler calls a routine for 64-bit factors,
//! which costs twice what four products of halves do. The bits are the same everywhere.

/// Whether long products are made of 16-bit halves. ARMv6-M is the one Arm profile without
/// compare-and-swap, by which it is told here.
pub(crate) const BY_HALVES: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

/// Whether halves of words are factors of one instruction, and upper words of signed products are
/// added to others by one.
pub(crate) const HALVES_MULTIPLY: bool = cfg!(target_arch = "arm") && !BY_HALVES;

/// The product of two numbers by their 16-bit halves: high and low word.
#[inline(always)]
const fn by_halves(a: u32, b: u32) -> (u32, u32) {
    let (al, ah, bl, bh) = (a & 0xFFFF, a >> 16, b & 0xFFFF, b >> 16);
    let low = al * bl;
    // Neither sum overflows: (2^16 - 1)^2 + 2^16 - 1 < 2^32.
    let middle = ah * bl + (low >> 16);
    let other = al * bh + (middle & 0xFFFF);
    (ah * bh + (middle >> 16) + (other >> 16), (other << 16) | (low & 0xFFFF))
}

/// The upper 32 bits of a product with a number below 2^31, by parts of 16 bits, and of 16 and 15.
///
/// Parts that are not halves keep the compiler from seeing the product of 64 bits in it, for which
/// it would call a routine that costs twice as much.
#[inline(always)]
const fn high_by_parts(a: u32, b: u32) -> u32 {
    let (al, ah, bl, bh) = (a & 0xFFFF, a >> 16, b & 0x7FFF, b >> 15);
    // a b = top 2^31 + (ah bl) 2^16 + (al bh) 2^15 + al bl; no sum overflows.
    let top = ah.wrapping_mul(bh);
    let low = al.wrapping_mul(bh).wrapping_add(al.wrapping_mul(bl) >> 15);
    let middle = ah.wrapping_mul(bl).wrapping_add(low >> 1);
    (top >> 1).wrapping_add(middle.wrapping_add((top & 1) << 15) >> 16)
}

/// The upper 32 bits of a product; `b` must be below 2^31.
#[inline(always)]
pub(crate) const fn mul_high_31(a: u32, b: u32) -> u32 {
    if BY_HALVES {
        high_by_parts(a, b)
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// The lower 16 of the upper 32 bits of a product, by halves; what is above them is not its own.
#[inline(always)]
const fn low_of_high_by_halves(a: u32, b: u32) -> u32 {
    let (al, ah, bl, bh) = (a & 0xFFFF, a >> 16, b & 0xFFFF, b >> 16);
    // What the sum loses is above those bits.
    let middle = ((al * bl) >> 16).wrapping_add(ah * bl).wrapping_add(al * bh);
    (ah * bh).wrapping_add(middle >> 16)
}

/// The lower 16 of the upper 32 bits of a product; what is above them may be anything.
#[inline(always)]
pub(crate) const fn low_of_high(a: u32, b: u32) -> u32 {
    if BY_HALVES {
        low_of_high_by_halves(a, b)
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// The same of two numbers below 2^31, by halves: no sum overflows.
#[inline(always)]
const fn high_of_31_bits_by_halves(a: u32, b: u32) -> u32 {
    let (al, ah, bl, bh) = (a & 0xFFFF, a >> 16, b & 0xFFFF, b >> 16);
    let middle = ah * bl + al * bh + ((al * bl) >> 16);
    ah * bh + (middle >> 16)
}

/// The upper 32 bits of a product of two numbers below 2^31.
#[inline(always)]
pub(crate) const fn mul_high_both_31(a: u32, b: u32) -> u32 {
    if BY_HALVES {
        high_of_31_bits_by_halves(a, b)
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// A multiple of 2^15 below 2^31 as [`mul_high_positive`] takes it.
#[inline(always)]
pub(crate) const fn half_factor(b: i32) -> i32 {
    if BY_HALVES {
        b >> 15
    } else {
        b
    }
}

/// The same of a number below 2^31 and 2^15 times one below 2^16, by halves of the first.
#[inline(always)]
const fn high_by_upper_half(a: u32, b: u32) -> u32 {
    ((a >> 16) * b + (((a & 0xFFFF) * b) >> 16)) >> 1
}

/// The upper 32 bits of the product of two numbers that are not negative, as signed; the second
/// comes from [`half_factor`].
///
/// Of signed factors whose signs it does not know the compiler makes one instruction, and one again
/// of the result's product with a signed number; of an unsigned and a signed one it makes three.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "below 2^30")]
pub(crate) const fn mul_high_positive(a: i32, b: i32) -> i32 {
    if BY_HALVES {
        high_by_upper_half(a as u32, b as u32) as i32
    } else {
        ((a as i64 * b as i64) >> 32) as i32
    }
}

/// The upper 32 bits of a product.
#[inline(always)]
pub(crate) const fn mul_high(a: u32, b: u32) -> u32 {
    if BY_HALVES {
        by_halves(a, b).0
    } else {
        ((a as u64 * b as u64) >> 32) as u32
    }
}

/// The upper 32 bits of the product of a signed and an unsigned number, rounded down.
///
/// `b` must be below 2^31.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "the same bits, read as signed")]
pub(crate) const fn mul_high_signed(a: i32, b: u32) -> i32 {
    if BY_HALVES {
        // As unsigned, a negative number is 2^32 too large.
        (high_by_parts(a as u32, b) as i32).wrapping_sub(a >> 31 & b as i32)
    } else {
        ((a as i64 * b as i32 as i64) >> 32) as i32
    }
}

/// The same by halves, for numbers of at most 2^30 in magnitude: no sum overflows.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "halves")]
const fn high_of_30_bits_by_halves(a: i32, b: u32) -> i32 {
    let (al, ah, bl, bh) = (a & 0xFFFF, a >> 16, (b & 0xFFFF) as i32, (b >> 16) as i32);
    let low = ((al as u32 * bl as u32) >> 16) as i32;
    ah * bh + ((ah * bl + (al * bh + low)) >> 16)
}

/// The upper 32 bits of the product of a signed and an unsigned number, both of at most 2^30 in
/// magnitude, rounded down.
#[inline(always)]
pub(crate) const fn mul_high_30(a: i32, b: u32) -> i32 {
    if BY_HALVES {
        high_of_30_bits_by_halves(a, b)
    } else {
        mul_high_signed(a, b)
    }
}

/// The product of a number below 2^30 and one of 16 bits, less its lower 16 bits: rounded down.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "below 2^31")]
pub(crate) const fn mul_short(a: u32, b: i16) -> i32 {
    if BY_HALVES {
        short_by_parts(a, b)
    } else if cfg!(target_arch = "arm") {
        // One instruction where there are products of halves.
        ((a as i32 as i64 * b as i64) >> 16) as i32
    } else {
        mul_high_signed((b as i32) << 16, a)
    }
}

/// The same by parts: no sum overflows.
#[inline(always)]
#[allow(clippy::cast_possible_wrap, reason = "16 bits")]
const fn short_by_parts(a: u32, b: i16) -> i32 {
    let (b, low, high) = (b as i32, (a & 0xFFFF) as i32, (a >> 16) as i32);
    b * high + ((b * low) >> 16)
}

/// A number less the upper 32 bits of a product, rounded down.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "wraps as a difference of words does")]
pub(crate) const fn less_high(from: i32, a: i32, b: i32) -> i32 {
    // One instruction on cores that multiply halves.
    (((from as i64) << 32).wrapping_sub(a as i64 * b as i64) >> 32) as i32
}

/// A weight as [`weighted_sum`] takes it.
///
/// Where products are long, one bit higher: their upper words are then the sum, with no shift.
#[inline(always)]
pub(crate) const fn weight(w: i32) -> i32 {
    if BY_HALVES {
        w
    } else {
        w.wrapping_shl(1)
    }
}

/// Bits of the lower part of a weight in two.
const LOW: u32 = 14;

/// A pair of plain weights in two parts each: the lower ones, the upper ones.
#[inline(always)]
pub(crate) const fn in_parts(p: i32, q: i32) -> [i32; 4] {
    const MASK: i32 = (1 << LOW) - 1;
    [p & MASK, q & MASK, p >> LOW, q >> LOW]
}

/// The same as [`weighted_sum`] for plain weights in parts.
#[inline(always)]
pub(crate) const fn weighted_sum_of_parts(a: i32, b: i32, parts: [i32; 4]) -> i32 {
    let [p_low, q_low, p_high, q_high] = parts;
    let low = a.wrapping_mul(p_low).wrapping_add(b.wrapping_mul(q_low));
    let high = a.wrapping_mul(p_high).wrapping_add(b.wrapping_mul(q_high));
    high.wrapping_add(low >> LOW) >> 2
}

/// (a p + b q) / 2^16, rounded down.
///
/// `a` and `b` must be below 2^16 in magnitude, p and q at most 2^27; `p` and `q` come from
/// [`weight`].
#[inline(always)]
pub(crate) const fn weighted_sum(a: i32, p: i32, b: i32, q: i32) -> i32 {
    if BY_HALVES {
        weighted_sum_of_parts(a, b, in_parts(p, q))
    } else {
        // 2^15 and the weight's 2 make 2^16: what is left is the upper word.
        let (a, b) = (a.wrapping_shl(15) as i64, b.wrapping_shl(15) as i64);
        (a.wrapping_mul(p as i64).wrapping_add(b.wrapping_mul(q as i64)) >> 32) as i32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weighted_sums_of_parts_are_those_of_64_bits() {
        let ends = [0, 1, -1, 77, -4096, 65_535, -65_535];
        let weights = [0, 1, -1, 16_383, -16_384, 16_385, 1 << 27, -(1 << 27), (1 << 27) - 1];
        for (a, b) in ends.iter().flat_map(|a| ends.map(|b| (*a, b))) {
            for (p, q) in weights.iter().flat_map(|p| weights.map(|q| (*p, q))) {
                let exact = (i64::from(a) * i64::from(p) + i64::from(b) * i64::from(q)) >> 16;
                let sum = weighted_sum_of_parts(a, b, in_parts(p, q));
                assert_eq!(i64::from(sum), exact, "{a} x {p} + {b} x {q}");
                let sum = weighted_sum(a, weight(p), b, weight(q));
                assert_eq!(i64::from(sum), exact, "{a} x {p} + {b} x {q}");
            }
        }
    }

    #[test]
    fn products_by_halves_are_those_of_64_bits() {
        let ends = [0, 1, 2, 0xFFFF, 0x1_0000, 0x1_0001, 0x7FFF_FFFF, 0x8000_0000, u32::MAX];
        let mut state = 1_u32;
        let mut next = || {
            state = state.wrapping_mul(0x915F_77F5).wrapping_add(0x9E37_79B9);
            state ^ (state >> 15)
        };
        let check = |a: u32, b: u32| {
            let exact = u64::from(a) * u64::from(b);
            let (high, low) = by_halves(a, b);
            assert_eq!(u64::from(high) << 32 | u64::from(low), exact, "{a:x} x {b:x}");
            let low = low_of_high_by_halves(a, b) & 0xFFFF;
            assert_eq!(low, high & 0xFFFF, "{a:x} x {b:x}");
            assert_eq!(low_of_high(a, b) & 0xFFFF, low, "{a:x} x {b:x}");
            let (signed, half) = (a.cast_signed(), b >> 1);
            let exact = i64::from(signed) * i64::from(half);
            let high = by_halves(a, half).0.cast_signed();
            let high = high.wrapping_sub(signed >> 31 & half.cast_signed());
            assert_eq!(i64::from(high), exact >> 32, "{signed} x {half:x}");
            assert_eq!(mul_high_signed(signed, half), high, "{signed} x {half:x}");
            let upper = (u64::from(a) * u64::from(half)) >> 32;
            assert_eq!(u64::from(high_by_parts(a, half)), upper, "{a:x} x {half:x}");
            assert_eq!(u64::from(mul_high_31(a, half)), upper, "{a:x} x {half:x}");
            let (a, b) = (a >> 1, half);
            let upper = (u64::from(a) * u64::from(b)) >> 32;
            assert_eq!(u64::from(high_of_31_bits_by_halves(a, b)), upper, "{a:x} x {b:x}");
            let short = ((a & 0xFFFF) as u16).cast_signed();
            let product = (i64::from(short) * i64::from(half >> 1)) >> 16;
            assert_eq!(i64::from(mul_short(half >> 1, short)), product, "{short} x {half:x} / 2");
            assert_eq!(i64::from(short_by_parts(half >> 1, short)), product, "{short} x {half:x}");
            let difference = (i128::from(signed) << 32) - i128::from(signed) * i128::from(short);
            let high = less_high(signed, signed, short.into());
            assert_eq!(
                i128::from(high),
                difference >> 32,
                "{signed} less its product with {short}"
            );
            let coarse = b >> 15 << 15;
            let upper = (u64::from(a) * u64::from(coarse)) >> 32;
            assert_eq!(u64::from(high_by_upper_half(a, coarse >> 15)), upper, "{a:x} x {coarse:x}");
            let (signed, b) = (signed >> 1, b.min(1 << 30));
            for signed in [signed, signed.saturating_add(1)] {
                let upper = (i64::from(signed) * i64::from(b)) >> 32;
                let high = high_of_30_bits_by_halves(signed, b);
                assert_eq!(i64::from(high), upper, "{signed} x {b:x}");
            }
        };
        for a in ends {
            for b in ends {
                check(a, b);
            }
        }
        for _ in 0..100_000 {
            check(next(), next());
        }
    }
}
