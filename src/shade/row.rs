use super::{Blend, ColorOutput, Counter, DepthTest, Dither, SmoothColor, State, Stepped, Verdict};
use crate::color::{Color, Format};
use crate::frame::DepthAccess;
use crate::math::BY_HALVES;

/// The depth cells of a row under state `S`.
type Access<S> = <<S as State>::Depth as DepthTest>::Access;
/// How state `S` dithers.
type OutputDither<S> = <<S as State>::Output as ColorOutput>::Dither;
/// A colour that is ready to be blended under state `S`.
type Source<S> = <<<S as State>::Output as ColorOutput>::Blend as Blend>::Source;
/// A row of depth under state `S`.
pub(crate) type Cells<'a, S> = <Access<S> as DepthAccess>::Cells<'a>;

/// Pixels that the loop over rows of one depth takes at a turn.
const TURN: usize = 4;

/// Pixels from which on a row is long: what entering that loop costs is less than what it spares.
const LONG: usize = 12;

/// A run of pixels in one row: where depth, state, format and the varying's step meet.
pub struct Row<'a, S: State, F: Format, V: Stepped> {
    /// The first pixel's column and row, in picture coordinates.
    pub(crate) x: i32,
    pub(crate) y: i32,
    pub(crate) pixels: &'a mut [F::Raw],
    pub(crate) cells: Cells<'a, S>,
    /// Depth at the first pixel, 16.16, and its step.
    pub(crate) z: u32,
    pub(crate) z_step: u32,
    /// Whether to ask if the row is long and of one depth: not of points and lines, whose rows are
    /// short and would pay for the question.
    pub(crate) may_be_level: bool,
    pub(crate) varying: V,
    pub(crate) step: V::Step,
    pub(crate) depth: &'a S::Depth,
    pub(crate) output: &'a S::Output,
    pub(crate) counter: &'a mut S::Counter,
}

impl<S: State, F: Format, V: Stepped> core::fmt::Debug for Row<'_, S, F, V> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Row").field("pixels", &self.pixels.len()).finish_non_exhaustive()
    }
}

impl<'a, S: State, F: Format, V: Stepped> Row<'a, S, F, V> {
    /// The first pixel's column, in picture coordinates.
    #[inline(always)]
    pub fn x(&self) -> i32 {
        self.x
    }

    /// The pixels' row, in picture coordinates.
    #[inline(always)]
    pub fn y(&self) -> i32 {
        self.y
    }

    /// The varying at the first pixel.
    #[inline(always)]
    pub fn varying(&self) -> &V {
        &self.varying
    }

    /// What is added to the varying from one pixel to the next.
    #[inline(always)]
    pub fn step(&self) -> &V::Step {
        &self.step
    }

    /// The same pixels with another value and step: for what is cheaper to step in a form that only
    /// the shader knows.
    #[inline(always)]
    pub fn convert<W: Stepped>(
        self,
        change: impl FnOnce(V, V::Step) -> (W, W::Step),
    ) -> Row<'a, S, F, W> {
        let Self { x, y, pixels, cells, z, z_step, may_be_level, .. } = self;
        let Self { varying, step, depth, output, counter, .. } = self;
        let (varying, step) = change(varying, step);
        Row { x, y, pixels, cells, z, z_step, may_be_level, varying, step, depth, output, counter }
    }

    /// Calls `fragment` for each pixel that passes the depth test and stores what it gives;
    /// `None` discards: neither colour nor depth is written, nor a stencil value.
    ///
    /// # Cost
    /// 17 instructions a pixel on Cortex-M4 with depth and an interpolated colour; the closure is
    /// inlined. Iteration stays inside because an iterator that is pulled costs 1.5 to 2 times as
    /// much.
    #[inline(always)]
    pub fn each(self, mut fragment: impl FnMut(&V) -> Option<Color>) {
        if S::Output::PLAIN {
            self.each_packed(|varying| fragment(varying).map(F::pack));
        } else {
            self.place(fragment);
        }
    }

    /// The same for pixels that are packed already: for a shader that takes its colours from a
    /// small table, which it packs once a row by [`Format::pack`]. They are opaque.
    ///
    /// # Cost
    /// 5 instructions a pixel less than [`each`](Self::each), where colours are neither blended
    /// nor dithered nor masked; otherwise more, for they are unpacked.
    #[inline(always)]
    pub fn each_packed(self, mut fragment: impl FnMut(&V) -> Option<F::Raw>) {
        if !S::Output::PLAIN {
            return self.place(|varying| fragment(varying).map(F::unpack));
        }
        let Self { pixels, cells, mut z, z_step, mut varying, step, depth, counter, .. } = self;
        for (pixel, cell) in pixels.iter_mut().zip(<Access<S>>::iter(cells)) {
            let code = (z >> 16) as u16;
            let verdict = depth.verdict(code, &cell);
            if verdict != Verdict::Fails {
                if let Some(raw) = fragment(&varying) {
                    depth.leave(verdict, code, cell);
                    if verdict == Verdict::Passes {
                        *pixel = raw;
                        counter.pixels(1);
                    }
                }
            }
            z = z.wrapping_add(z_step);
            varying.step(&step);
            if <Access<S>>::TOUCHES {
                // Unrolled by the compiler, this loop spills: 25 instead of 19 instructions on M4.
                core::hint::black_box(());
            }
        }
    }

    /// Blends, dithers and masks colours.
    #[inline(always)]
    fn place(self, mut fragment: impl FnMut(&V) -> Option<Color>) {
        let output = self.output;
        self.walk(|varying| Some(output.blend().source::<F>(fragment(varying)?)));
    }

    /// The pixel loop where what is stored counts, or the place: `source` gives what is to be
    /// blended.
    #[inline(always)]
    fn walk(self, mut source: impl FnMut(&V) -> Option<Source<S>>) {
        let Self { x, y, pixels, cells, mut z, z_step, mut varying, .. } = self;
        let Self { step, depth, output, counter, .. } = self;
        let mut thresholds = output.dither().thresholds(x, y);
        for (pixel, cell) in pixels.iter_mut().zip(<Access<S>>::iter(cells)) {
            let code = (z >> 16) as u16;
            let verdict = depth.verdict(code, &cell);
            if verdict != Verdict::Fails {
                if let Some(source) = source(&varying) {
                    depth.leave(verdict, code, cell);
                    if verdict == Verdict::Passes {
                        *pixel = output.pixel::<F>(&source, pixel, &thresholds);
                        counter.pixels(1);
                    }
                }
            }
            z = z.wrapping_add(z_step);
            varying.step(&step);
            <OutputDither<S>>::step(&mut thresholds);
            if <Access<S>>::TOUCHES {
                // Unrolled by the compiler, this loop spills: 25 instead of 19 instructions on M4.
                core::hint::black_box(());
            }
        }
    }

    /// Stores one colour in each pixel that passes the depth test.
    ///
    /// # Cost
    /// Without depth, half an instruction a 16-bit pixel on Cortex-M4: whole words, eight a turn.
    /// With depth 11 instructions a pixel, and 7 in rows of one depth from 12 pixels on.
    #[inline(always)]
    pub fn fill(self, color: Color) {
        let output = self.output;
        if <Access<S>>::TOUCHES && S::Output::PLAIN {
            self.fill_visible(F::pack(color));
        } else if <Access<S>>::TOUCHES {
            let source = output.blend().source::<F>(color);
            self.walk(|_| Some(source));
        } else {
            self.counter.pixels(u32::try_from(self.pixels.len()).unwrap_or(u32::MAX));
            match self.pixels {
                // Where it is known that there is but one, nothing is called.
                [pixel] if S::Output::PLAIN => *pixel = F::pack(color),
                pixels => output.fill::<F>(pixels, color, self.x, self.y),
            }
        }
    }
}

impl<S: State, F: Format, V: Stepped> Row<'_, S, F, V> {
    /// Stores one value in each pixel that passes the depth test.
    #[inline(always)]
    fn fill_visible(self, raw: F::Raw) {
        let Self { pixels, cells, mut z, z_step, depth, counter, .. } = self;
        let is_level = self.may_be_level && pixels.len() >= LONG && z_step == 0;
        let cells = if !is_level && (BY_HALVES || pixels.len() == 1) {
            // With few registers, the loop over both is the longer one; of lines, it is none.
            cells
        } else {
            match <Access<S>>::codes(cells) {
                Ok(codes) if is_level => {
                    return fill_level::<S::Depth, F, _>(pixels, codes, z, raw, depth, counter);
                }
                Ok(codes) => {
                    return pixels.iter_mut().zip(codes).for_each(|(pixel, stored)| {
                        store_visible((z >> 16) as u16, raw, pixel, stored, depth, counter);
                        z = z.wrapping_add(z_step);
                        core::hint::black_box(());
                    });
                }
                Err(cells) => cells,
            }
        };
        let row = Self { pixels, cells, z, counter, ..self };
        row.each_packed(|_| Some(raw));
    }
}

/// Stores one value in a pixel that passes the depth test.
#[inline(always)]
fn store_visible<T>(
    code: u16,
    raw: T,
    pixel: &mut T,
    stored: &mut u16,
    depth: &impl DepthTest,
    counter: &mut impl Counter,
) {
    if depth.passes(code, *stored) {
        if depth.writes() {
            *stored = code;
        }
        *pixel = raw;
        counter.pixels(1);
    }
}

/// Stores one value in each pixel of a long row of one depth that passes the depth test, a few at
/// a turn: apart, so that other rows pay nothing for it.
#[inline(never)]
fn fill_level<D: DepthTest, F: Format, C: Counter>(
    pixels: &mut [F::Raw],
    codes: &mut [u16],
    z: u32,
    raw: F::Raw,
    depth: &D,
    counter: &mut C,
) {
    let code = (z >> 16) as u16;
    let mut store = |(pixel, stored)| store_visible(code, raw, pixel, stored, depth, counter);
    let (turns, rest) = pixels.as_chunks_mut::<TURN>();
    let (code_turns, code_rest) = codes.as_chunks_mut::<TURN>();
    for (pixels, codes) in turns.iter_mut().zip(code_turns) {
        pixels.iter_mut().zip(codes).for_each(&mut store);
        core::hint::black_box(());
    }
    for pixel in rest.iter_mut().zip(code_rest) {
        store(pixel);
        core::hint::black_box(());
    }
}

impl<S: State, F: Format> Row<'_, S, F, SmoothColor> {
    /// Stores the interpolated colour, as it is, in each pixel that passes the depth test: for
    /// shaders that say [`COLOR_AS_IS`](super::Shader::COLOR_AS_IS).
    ///
    /// # Cost
    /// That of [`each`](Self::each), but where colours are dithered and not blended: thresholds are
    /// part of the colour's steps then, of which there are as many as columns of the matrix.
    #[inline(always)]
    pub fn each_as_is(self) {
        if S::Output::PLAIN {
            self.each(|varying| Some(varying.color()));
        } else if self.output.dims() {
            self.raised();
        } else {
            self.place(|varying| Some(varying.color()));
        }
    }

    /// The pixel loop of colours that are [dimmed](Format::dim), and dithered.
    #[inline(always)]
    fn raised(self) {
        let Self { x, y, pixels, cells, mut z, z_step, varying, .. } = self;
        let Self { step, depth, output, counter, .. } = self;
        let mut thresholds = output.dither().thresholds(x, y);
        let raise = |thresholds: &<OutputDither<S> as Dither>::Thresholds| {
            <OutputDither<S>>::first(thresholds).map_or(Color::NOTHING, F::raise)
        };
        let mut here = raise(&thresholds);
        let mut varying = varying;
        varying.step(&(here.blue_red, here.green));
        // From each column's threshold to the next one's: no more of them than there are pixels.
        let mut steps = <OutputDither<S> as Dither>::Steps::default();
        for place in steps.as_mut().iter_mut().take(pixels.len()) {
            <OutputDither<S>>::step(&mut thresholds);
            let next = raise(&thresholds);
            *place = (
                step.0.wrapping_add(next.blue_red).wrapping_sub(here.blue_red),
                step.1.wrapping_add(next.green).wrapping_sub(here.green),
            );
            here = next;
        }
        let mut row = pixels.iter_mut().zip(<Access<S>>::iter(cells));
        loop {
            for step in steps.as_ref() {
                let Some((pixel, cell)) = row.next() else { return };
                let code = (z >> 16) as u16;
                let verdict = depth.verdict(code, &cell);
                if verdict != Verdict::Fails {
                    depth.leave(verdict, code, cell);
                    if verdict == Verdict::Passes {
                        *pixel = output.masked::<F>(F::pack(varying.color()), pixel);
                        counter.pixels(1);
                    }
                }
                z = z.wrapping_add(z_step);
                varying.step(step);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shade::{Counting, LessEqual, Output, ReadOnly, States, Stats};
    use crate::{raster::Scanline, Rgb565};

    /// Fills a row under a test, and does the same pixel by pixel.
    fn check<D: DepthTest<Access = crate::frame::ReadWrite>>(
        depth: D,
        codes: &[u16],
        z: u32,
        z_step: u32,
    ) {
        const COLOR: Color = Color::new(255, 0, 0);
        let (mut pixels, mut cells) = ([7u16; 64], [0u16; 64]);
        let (pixels, cells) = (&mut pixels[..codes.len()], &mut cells[..codes.len()]);
        cells.copy_from_slice(codes);
        let (mut expected, mut visible) = (([7u16; 64], [0u16; 64]), 0);
        let mut along = z;
        for (i, &stored) in codes.iter().enumerate() {
            let code = (along >> 16) as u16;
            let passes = depth.passes(code, stored);
            visible += u32::from(passes);
            expected.0[i] = if passes { 0xF800 } else { 7 };
            expected.1[i] = if passes && depth.writes() { code } else { stored };
            along = along.wrapping_add(z_step);
        }
        let (output, mut stats) = (Output::default(), Stats::default());
        Row::<States<D, Counting<'_>, Scanline, Output>, Rgb565, ()> {
            x: 0,
            y: 0,
            pixels,
            cells,
            z,
            z_step,
            may_be_level: true,
            varying: (),
            step: (),
            depth: &depth,
            output: &output,
            counter: &mut Counting(&mut stats),
        }
        .fill(COLOR);
        assert_eq!(pixels, &expected.0[..codes.len()], "colours from {z:x} by {z_step:x}");
        assert_eq!(cells, &expected.1[..codes.len()], "codes from {z:x} by {z_step:x}");
        assert_eq!(stats.pixels, visible, "pixels from {z:x} by {z_step:x}");
    }

    #[test]
    fn rows_of_all_lengths_and_slopes_are_filled_where_they_are_visible() {
        let mut bits = 1u32;
        let mut word = || {
            bits = bits.wrapping_mul(0x0019_660D).wrapping_add(0x3C6E_F35F);
            bits
        };
        for case in 0..2000 {
            let z = if case % 5 == 0 { u32::MAX } else { word() };
            let z_step = if case % 2 == 0 { 0 } else { word() };
            let mut codes = [0u16; 64];
            for code in &mut codes {
                let near = (z >> 16) as u16;
                *code = match word() >> 30 {
                    0 => near,
                    1 => near.wrapping_add(1),
                    2 => near.wrapping_sub(1),
                    _ => (word() >> 16) as u16,
                };
            }
            let codes = &codes[..case % 65];
            check(crate::Less, codes, z, z_step);
            check(ReadOnly::new(LessEqual), codes, z, z_step);
        }
    }
}
