use super::{Blend, ColorOutput, Counter, DepthTest, Dither, SmoothColor, State, Stepped, Verdict};
use crate::color::{Color, Format};
use crate::frame::DepthAccess;
use crate::math::rare;

/// The depth cells of a row under state `S`.
pub(super) type Access<S> = <<S as State>::Depth as DepthTest>::Access;
/// How state `S` dithers.
type OutputDither<S> = <<S as State>::Output as ColorOutput>::Dither;
/// A colour that is ready to be blended under state `S`.
type Source<S> = <<<S as State>::Output as ColorOutput>::Blend as Blend>::Source;
/// A row of depth under state `S`.
pub(crate) type Cells<'a, S> = <Access<S> as DepthAccess>::Cells<'a>;

/// The pixel loop from a row's last pixel to its first; `behind`, which is one pixel further, and
/// `steps` are of the varying and of depth.
#[inline(always)]
fn from_last<F: Format, V: Stepped>(
    pixels: &mut [F::Raw],
    codes: &mut [u16],
    behind: (V, u32),
    steps: (V::Step, u32),
    depth: &impl DepthTest,
    counter: &mut impl Counter,
    mut fragment: impl FnMut(&V, &F::Raw) -> Option<F::Raw>,
) {
    let ((mut varying, mut z), (step, z_step)) = (behind, steps);
    for (pixel, stored) in pixels.iter_mut().zip(codes).rev() {
        z = z.wrapping_sub(z_step);
        varying.jump(&step, -1);
        let code = (z >> 16) as u16;
        if depth.passes(code, *stored) {
            if let Some(raw) = fragment(&varying, pixel) {
                if depth.writes() {
                    *stored = code;
                }
                *pixel = raw;
                counter.pixels(1);
                // Neither unrolled, which spills, nor made of conditional instructions.
                core::hint::black_box(());
            } else {
                rare();
            }
        } else {
            // Otherwise a visible pixel takes a jump more.
            rare();
        }
    }
}

/// The same of colours that are [dimmed](Format::dim), and dithered; `value` and `steps` are of the
/// colour and of depth at the first pixel, which is at (`x`, `y`).
#[inline(always)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
fn raised_from_last<S: State, F: Format>(
    (x, y): (i32, i32),
    pixels: &mut [F::Raw],
    codes: &mut [u16],
    value: (SmoothColor, u32),
    ((blue_red, green), z_step): ((u32, u32), u32),
    (depth, output, counter): (&S::Depth, &S::Output, &mut S::Counter),
) {
    // No row is longer. As the compiler knows it, one number is a pixel's place among colours and
    // codes, and the count.
    let length = pixels.len() & 0xFFFF;
    let Some(pixels) = pixels.get_mut(..length) else { return };
    let (mut varying, mut z) = value;
    z = z.wrapping_add(z_step.wrapping_mul(length as u32));
    varying.jump(&(blue_red, green), length as i32);
    // From each column's threshold to the one before: no more of them than there are pixels.
    let mut steps = <OutputDither<S> as Dither>::Steps::default();
    let count = steps.as_ref().len().min(length);
    let from = x.wrapping_add(length.wrapping_sub(count) as i32);
    let mut thresholds = output.dither().thresholds(from, y);
    let raise = |thresholds: &<OutputDither<S> as Dither>::Thresholds| {
        <OutputDither<S>>::first(thresholds).map_or(Color::NOTHING, F::raise)
    };
    let mut here = raise(&thresholds);
    for place in steps.as_mut().iter_mut().take(count).rev() {
        <OutputDither<S>>::step(&mut thresholds);
        let next = raise(&thresholds);
        *place = (
            blue_red.wrapping_add(next.blue_red).wrapping_sub(here.blue_red),
            green.wrapping_add(next.green).wrapping_sub(here.green),
        );
        here = next;
    }
    varying.step(&(here.blue_red, here.green));
    let mut row = pixels.iter_mut().zip(codes).rev();
    loop {
        for step in steps.as_ref() {
            let Some((pixel, stored)) = row.next() else { return };
            z = z.wrapping_sub(z_step);
            varying.jump(step, -1);
            let code = (z >> 16) as u16;
            if depth.passes(code, *stored) {
                if depth.writes() {
                    *stored = code;
                }
                *pixel = output.masked::<F>(F::pack(varying.color()), pixel);
                counter.pixels(1);
                core::hint::black_box(());
            } else {
                rare();
            }
        }
    }
}

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
    /// Whether to ask if the row is long and of one depth: not of points, lines and short triangles,
    /// most of whose rows are short and would pay for the question.
    pub(crate) may_be_level: bool,
    pub(crate) varying: V,
    pub(crate) step: V::Step,
    /// The varying and depth behind the last pixel, where they cost no more than those at the first: if
    /// the loop begins with them, its count is the pixel's number.
    pub(crate) behind: Option<(V, u32)>,
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

    /// Says where it is, before it is drawn.
    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
    pub(crate) fn announce(&mut self) {
        let end = self.x.wrapping_add(self.pixels.len() as i32);
        self.counter.row(self.y, self.x, end);
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
        let (varying, step) = change(self.varying, self.step);
        self.of(varying, step, None)
    }

    /// The same where values, of which two may be needed, and step are changed apart.
    #[inline(always)]
    pub(super) fn convert_apart<W: Stepped>(
        self,
        value: impl Fn(V) -> W,
        step: impl FnOnce(V::Step) -> W::Step,
    ) -> Row<'a, S, F, W> {
        let (varying, step) = (value(self.varying), step(self.step));
        let behind = self.behind.map(|(behind, z)| (value(behind), z));
        self.of(varying, step, behind)
    }

    /// The same pixels with another value.
    #[inline(always)]
    fn of<W: Stepped>(
        self,
        varying: W,
        step: W::Step,
        behind: Option<(W, u32)>,
    ) -> Row<'a, S, F, W> {
        let Self { x, y, pixels, cells, z, z_step, may_be_level, depth, output, counter, .. } =
            self;
        Row {
            x,
            y,
            pixels,
            cells,
            z,
            z_step,
            may_be_level,
            varying,
            step,
            behind,
            depth,
            output,
            counter,
        }
    }

    /// Calls `fragment` for each pixel that passes the depth test and stores what it gives;
    /// `None` discards: neither colour nor depth is written, nor a stencil value. Pixels come in any
    /// order.
    ///
    /// # Cost
    /// 15 instructions a pixel on Cortex-M4 with depth and an interpolated colour; the closure is
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
        let Self { pixels, mut cells, mut z, z_step, mut varying, step, behind, .. } = self;
        let Self { depth, counter, .. } = self;
        if let (true, Some(behind)) = (<Access<S>>::TOUCHES && V::JUMPS, behind) {
            cells = match <Access<S>>::codes(cells) {
                Ok(codes) => {
                    let steps = (step, z_step);
                    let fragment = |varying: &V, _: &F::Raw| fragment(varying);
                    return from_last::<F, V>(
                        pixels, codes, behind, steps, depth, counter, fragment,
                    );
                }
                Err(cells) => cells,
            };
        }
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
    #[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "of a picture")]
    fn walk(self, mut source: impl FnMut(&V) -> Option<Source<S>>) {
        let Self { x, y, pixels, mut cells, mut z, z_step, mut varying, .. } = self;
        let Self { step, depth, output, counter, .. } = self;
        let mut thresholds = output.dither().thresholds(x, y);
        let jumps = V::JUMPS && cfg!(not(target_arch = "riscv32"));
        if <Access<S>>::TOUCHES && !<OutputDither<S>>::DITHERS && jumps {
            cells = match <Access<S>>::codes(cells) {
                Ok(codes) => {
                    let length = pixels.len() & 0xFFFF;
                    let Some(pixels) = pixels.get_mut(..length) else { return };
                    z = z.wrapping_add(z_step.wrapping_mul(length as u32));
                    varying.jump(&step, length as i32);
                    let (behind, steps) = ((varying, z), (step, z_step));
                    let fragment = |varying: &V, pixel: &F::Raw| {
                        Some(output.pixel::<F>(&source(varying)?, pixel, &thresholds))
                    };
                    return from_last::<F, V>(
                        pixels, codes, behind, steps, depth, counter, fragment,
                    );
                }
                Err(cells) => cells,
            };
        }
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
    /// Without depth, that of [`Format::fill`]: a quarter of an instruction a 16-bit pixel on Cortex-M4
    /// in rows of 160.
    /// With depth 9 instructions a pixel, and 7 in rows of one depth from 12 pixels on where the
    /// triangle is higher than 14 pixels.
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
                // Where there may be but one, nothing is called for it.
                [pixel] if S::Output::PLAIN && !self.may_be_level => *pixel = F::pack(color),
                pixels => output.fill::<F>(pixels, color, self.x, self.y),
            }
        }
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
    fn raised(mut self) {
        if <Access<S>>::TOUCHES && cfg!(not(target_arch = "riscv32")) {
            self.cells = match <Access<S>>::codes(self.cells) {
                Ok(codes) => {
                    let (place, value) = ((self.x, self.y), (self.varying, self.z));
                    let (steps, output) = ((self.step, self.z_step), self.output);
                    let (depth, counter) = (self.depth, self.counter);
                    return raised_from_last::<S, F>(
                        place,
                        self.pixels,
                        codes,
                        value,
                        steps,
                        (depth, output, counter),
                    );
                }
                Err(cells) => cells,
            };
        }
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
#[path = "row_tests.rs"]
mod tests;
