use crate::color::{Channel, ChannelLanes, Color, ColorLanes, Format, HALF, LANES};

/// The texels around [`LANES`] points side by side, two in a word, and where the points lie between
/// them: what is looked up for several pixels before any of them is blended.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Squares {
    /// The upper left texels below the upper right ones.
    upper: [u32; LANES],
    /// The lower left texels below the lower right ones.
    lower: [u32; LANES],
    /// The distances from the upper left, in units of 2^-5: to the right, and down above it.
    weights: [u32; LANES],
    /// The colours of a surface, by which texels may be multiplied.
    pub(crate) surface: ColorLanes,
}

impl Squares {
    /// Fills in what a function gives for each lane: two pairs of texels, and the distances.
    #[inline(always)]
    pub(super) fn fill(&mut self, mut square: impl FnMut() -> Option<[u32; 3]>) -> Option<()> {
        let Self { upper, lower, weights, .. } = self;
        for ((upper, lower), weights) in upper.iter_mut().zip(lower).zip(weights) {
            [*upper, *lower, *weights] = square()?;
            // Not unrolled.
            core::hint::black_box(());
        }
        Some(())
    }

    /// Texels of RGB565 mixed across and then down, multiplied with the colours of a surface: the same
    /// bits as one by one.
    #[inline(never)]
    #[allow(clippy::cast_possible_truncation, reason = "halves of a word")]
    pub(crate) fn blended<F: Format>(&self, multiplies: bool) -> [F::Raw; LANES] {
        let low = |words: &[u32; LANES]| words.map(|word| word as u16);
        let high = |words: &[u32; LANES]| words.map(|word| (word >> 16) as u16);
        let texels = [low(&self.upper), high(&self.upper), low(&self.lower), high(&self.lower)];
        let weights = [low(&self.weights), high(&self.weights)];
        let red = mixed::<11, 31>(&texels, &weights);
        let green = mixed::<5, 63>(&texels, &weights);
        let blue = mixed::<0, 31>(&texels, &weights);
        let Self { surface, .. } = self;
        if !multiplies {
            return F::pack_lanes(&ChannelLanes {
                red: red.map(|bits| bits << 11 | bits >> 2 << 8 | HALF),
                green: green.map(|bits| bits << 10 | bits >> 4 << 8 | HALF),
                blue: blue.map(|bits| bits << 11 | bits >> 2 << 8 | HALF),
                alpha: [Color::OPAQUE as u16; LANES],
            });
        }
        // Bits repeated, and the half that lies above.
        let of_five = |channel: Channel| channel.map(|bits| bits << 4 | bits >> 1 | 1);
        let of_six = |channel: Channel| channel.map(|bits| bits << 3 | bits >> 3 | 1);
        F::pack_lanes(&ChannelLanes {
            red: product(&of_five(red), &low(&surface.blue_red)),
            green: product(&of_six(green), &high(&surface.green)),
            blue: product(&of_five(blue), &high(&surface.blue_red)),
            alpha: low(&surface.green),
        })
    }
}

/// What a function makes of each lane's number.
#[inline(always)]
fn lanes(lane: impl FnMut(usize) -> u16) -> Channel {
    core::array::from_fn(lane)
}

/// Between two values of a channel, rounded; 63 at most, so that 16 bits hold the sum.
#[inline(always)]
fn between(from: &Channel, to: &Channel, weights: &Channel) -> Channel {
    lanes(|i| {
        let way = to[i].wrapping_sub(from[i]).wrapping_mul(weights[i]);
        (from[i] << 5).wrapping_add(way).wrapping_add(16) >> 5
    })
}

/// The channel that lies so many bits above the lowest, between the texels of squares.
#[inline(always)]
fn mixed<const SHIFT: u32, const MASK: u16>(
    texels: &[Channel; 4],
    [x, y]: &[Channel; 2],
) -> Channel {
    let [a, b, c, d] = texels.each_ref().map(|texels| texels.map(|texel| texel >> SHIFT & MASK));
    between(&between(&a, &b, x), &between(&c, &d, x), y)
}

/// A channel of 512ths times one of a surface, 8.8.
#[inline(always)]
#[allow(clippy::cast_possible_truncation, reason = "the upper half")]
fn product(channel: &Channel, surface: &Channel) -> Channel {
    lanes(|i| (u32::from(channel[i] << 7).wrapping_mul(surface[i].into()) >> 16) as u16)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Rgb565, Rgb565Be, Rgba8888};
    use crate::math::hard_numbers::Random;
    use crate::texture::{TexelFormat, Weights};

    /// Texels, distances and colours of a lane.
    type Lane = ([u16; 4], [u32; 2], Color);

    /// The same by what draws one pixel after the other.
    fn one_by_one<F: Format>((texels, [x, y], surface): Lane, multiplies: bool) -> F::Raw {
        let weights = Weights::new(x << 3, y << 3);
        let surface = multiplies.then_some(surface);
        let corners = || Some(texels);
        let constants = <Rgb565 as TexelFormat>::CONSTANTS;
        let color = Rgb565::blend_square(&[], None, 0, corners, weights, constants, surface);
        F::pack(color.unwrap_or_default())
    }

    #[test]
    fn pixels_are_those_blended_one_by_one() {
        let mut random = Random::new(19);
        for round in 0..40_000 {
            let lanes: [Lane; LANES] = core::array::from_fn(|_| {
                let texels = [(); 4].map(|()| match random.word() & 7 {
                    0 => 0,
                    1 => u16::MAX,
                    _ => (random.word() >> 16) as u16,
                });
                let word = random.word();
                let surface = Color { blue_red: random.word(), green: random.word() };
                (texels, [word >> 27, word >> 4 & 31], surface)
            });
            let mut squares = Squares::default();
            let mut given = lanes.iter();
            let filled = squares.fill(|| {
                let (texels, [x, y], _) = given.next()?;
                let [a, b, c, d] = texels.map(u32::from);
                Some([a | b << 16, c | d << 16, x | y << 16])
            });
            assert_eq!(filled, Some(()), "there are as many");
            squares.surface = ColorLanes::of(|lane| lanes[lane].2);
            let multiplies = round % 2 == 0;
            let expected = lanes.map(|lane| one_by_one::<Rgb565>(lane, multiplies));
            assert_eq!(squares.blended::<Rgb565>(multiplies), expected, "{lanes:x?}");
            let expected = lanes.map(|lane| one_by_one::<Rgb565Be>(lane, multiplies));
            assert_eq!(squares.blended::<Rgb565Be>(multiplies), expected, "{lanes:x?}");
            let expected = lanes.map(|lane| one_by_one::<Rgba8888>(lane, multiplies));
            assert_eq!(squares.blended::<Rgba8888>(multiplies), expected, "{lanes:x?}");
        }
    }
}
