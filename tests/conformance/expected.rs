//! The expected picture of a scene, in binary.

/// What is expected of one pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pixel {
    /// The primitive that is seen, -1 for the background.
    pub(crate) primitive: i16,
    /// Primitives that cover the pixel, after culling.
    pub(crate) count: u8,
    /// Not to be compared.
    pub(crate) ambiguous: bool,
    /// 0 near, 1 far.
    pub(crate) depth: f32,
    pub(crate) color: [u8; 4],
}

/// The coverage of one primitive alone: pixels, and their FNV-1a hash.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Coverage {
    pub(crate) pixels: u32,
    pub(crate) hash: u32,
}

impl Coverage {
    /// Of pixels in order of rows.
    pub(crate) fn of(pixels: &[(u16, u16)]) -> Self {
        let mut hash = 0x811C_9DC5_u32;
        for (x, y) in pixels {
            for byte in x.to_le_bytes().into_iter().chain(y.to_le_bytes()) {
                hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        }
        Self { pixels: u32::try_from(pixels.len()).expect("a small picture"), hash }
    }
}

/// The whole picture.
#[derive(Clone, Debug)]
pub(crate) struct Expected {
    pub(crate) pixels: Vec<Pixel>,
    pub(crate) primitives: Vec<Coverage>,
}

/// Takes the first bytes off.
fn take<const N: usize>(bytes: &mut &[u8]) -> Option<[u8; N]> {
    let (first, rest) = bytes.split_first_chunk::<N>()?;
    *bytes = rest;
    Some(*first)
}

impl Expected {
    /// Reads the binary form; `None` if it is too short or something else.
    pub(crate) fn parse(mut bytes: &[u8]) -> Option<Self> {
        let bytes = &mut bytes;
        (take(bytes)? == *b"GXR1").then_some(())?;
        let [width, height, primitives, flags] =
            [take(bytes)?, take(bytes)?, take(bytes)?, take(bytes)?].map(u16::from_le_bytes);
        let size = usize::from(width) * usize::from(height);
        let each = || 0..size;
        let seen: Vec<i16> =
            each().map(|_| take(bytes).map(i16::from_le_bytes)).collect::<Option<_>>()?;
        let counts: Vec<[u8; 1]> = each().map(|_| take(bytes)).collect::<Option<_>>()?;
        let depths: Vec<f32> =
            each().map(|_| take(bytes).map(f32::from_le_bytes)).collect::<Option<_>>()?;
        let colors: Vec<[u8; 4]> = each().map(|_| take(bytes)).collect::<Option<_>>()?;
        if flags & 1 != 0 {
            *bytes = bytes.get(8 * size..)?;
        }
        let coverage = |_| {
            let [pixels, hash] = [take(bytes)?, take(bytes)?].map(u32::from_le_bytes);
            Some(Coverage { pixels, hash })
        };
        let primitives = (0..primitives).map(coverage).collect::<Option<_>>()?;
        let pixel = |i: usize| Pixel {
            primitive: seen[i],
            count: counts[i][0] & 0x7F,
            ambiguous: counts[i][0] & 0x80 != 0,
            depth: depths[i],
            color: colors[i],
        };
        Some(Self { pixels: each().map(pixel).collect(), primitives })
    }

    /// How much depth changes by a column and by a row together at a pixel, of what is seen there;
    /// beyond any bound where no neighbour shows the same.
    pub(crate) fn slope(&self, at: usize, width: usize) -> f64 {
        self.change(at, width, |pixel| pixel.depth.into())
    }

    /// The same of a colour's channel.
    pub(crate) fn color_slope(&self, at: usize, width: usize, channel: usize) -> f64 {
        self.change(at, width, |pixel| pixel.color[channel].into())
    }

    fn change(&self, at: usize, width: usize, value: impl Fn(&Pixel) -> f64) -> f64 {
        let here = &self.pixels[at];
        let to = |neighbor: Option<usize>| {
            let there = self.pixels.get(neighbor?)?;
            let same = there.primitive == here.primitive;
            same.then(|| (value(there) - value(here)).abs())
        };
        let by = |step: usize| to(at.checked_sub(step)).or_else(|| to(at.checked_add(step)));
        by(1).unwrap_or(f64::INFINITY) + by(width).unwrap_or(f64::INFINITY)
    }
}
