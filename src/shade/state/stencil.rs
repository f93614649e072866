use super::{
    AnyCompare, AnyOperation, DepthTest, Keep, StencilCompare, StencilOperation, TestCell, Verdict,
};
use crate::frame::{DepthAccess, WithStencil};

/// A stencil test, and what it leaves in the stencil buffer of fragments that fail it, that fail
/// the depth test after it, and that pass both.
///
/// ```
/// use microraster::{Equal, IncrementWrap, Stencil};
///
/// // Passes where nothing has been drawn, and counts what is.
/// let once = Stencil::new(Equal, 0).on_pass(IncrementWrap);
/// # let _ = once;
/// ```
///
/// Fragments that the shader discards leave nothing, whichever test they fail.
///
/// Source: OpenGL 4.6, section 17.3.3; one test for both faces of a triangle: two passes that
/// [cull](crate::Pass::cull) have one for each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stencil<C, F = Keep, Z = Keep, P = Keep> {
    pub(crate) compare: C,
    pub(crate) reference: u8,
    pub(crate) read_mask: u8,
    pub(crate) write_mask: u8,
    pub(crate) on_fail: F,
    pub(crate) on_depth_fail: Z,
    pub(crate) on_pass: P,
}

/// A stencil test with all that it does chosen when the program runs: for host tools.
pub type AnyStencil = Stencil<AnyCompare, AnyOperation, AnyOperation, AnyOperation>;

impl<C: StencilCompare> Stencil<C> {
    /// A test of `reference` against what is stored, which leaves everything as it is.
    pub const fn new(compare: C, reference: u8) -> Self {
        Self {
            compare,
            reference,
            read_mask: u8::MAX,
            write_mask: u8::MAX,
            on_fail: Keep,
            on_depth_fail: Keep,
            on_pass: Keep,
        }
    }
}

impl<C, F, Z, P> Stencil<C, F, Z, P> {
    /// What fragments leave that fail the stencil test.
    pub fn on_fail<N: StencilOperation>(self, on_fail: N) -> Stencil<C, N, Z, P> {
        let Self { compare, reference, read_mask, write_mask, on_depth_fail, on_pass, .. } = self;
        Stencil { compare, reference, read_mask, write_mask, on_fail, on_depth_fail, on_pass }
    }

    /// What fragments leave that pass the stencil test and fail the depth test.
    pub fn on_depth_fail<N: StencilOperation>(self, on_depth_fail: N) -> Stencil<C, F, N, P> {
        let Self { compare, reference, read_mask, write_mask, on_fail, on_pass, .. } = self;
        Stencil { compare, reference, read_mask, write_mask, on_fail, on_depth_fail, on_pass }
    }

    /// What fragments leave that are drawn.
    pub fn on_pass<N: StencilOperation>(self, on_pass: N) -> Stencil<C, F, Z, N> {
        let Self { compare, reference, read_mask, write_mask, on_fail, on_depth_fail, .. } = self;
        Stencil { compare, reference, read_mask, write_mask, on_fail, on_depth_fail, on_pass }
    }

    /// The bits of both sides that are compared: all by default.
    #[must_use]
    pub const fn read_mask(mut self, bits: u8) -> Self {
        self.read_mask = bits;
        self
    }

    /// The bits that operations change: all by default.
    #[must_use]
    pub const fn write_mask(mut self, bits: u8) -> Self {
        self.write_mask = bits;
        self
    }
}

/// A depth test behind a stencil test: the state of a pass on a frame with a
/// [stencil buffer](crate::Frame::with_stencil).
///
/// It is the outermost of the wrappers; with [`Off`](crate::Off) inside, the frame needs no depth.
///
/// ```
/// use microraster::math::{AngleUnits, Mat4};
/// use microraster::models::TEAPOT;
/// use microraster::{Always, Camera, Flat, Frame, Less, Pass, Replace, Rgb, Rgb565, Size};
/// use microraster::{Stencil, Stenciled};
///
/// let (mut pixels, mut depth, mut stencil) = ([0; 64 * 32], [0; 64 * 32], [0; 64 * 32]);
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(64, 32))?
///     .with_depth(&mut depth)?
///     .with_stencil(&mut stencil)?;
/// let camera = Camera::perspective(45.0.degrees(), 0.5);
/// // A mark where the teapot is seen.
/// let mark = Stencil::new(Always, 1).on_pass(Replace);
/// Pass::new(&camera).depth(Stenciled::new(Less, mark)).draw(
///     &mut frame,
///     &Mat4::translation(microraster::math::Vec3::new(0.0, 0.0, -5.0)),
///     &TEAPOT,
///     &Flat::solid(Rgb::RED),
/// );
/// assert!(stencil.contains(&1));
/// # Ok::<(), microraster::FrameError>(())
/// ```
///
/// Without a stencil buffer this does not compile:
/// ```compile_fail,E0277
/// # use microraster::math::{AngleUnits, Mat4};
/// # use microraster::models::TEAPOT;
/// # use microraster::{Always, Camera, Flat, Frame, Less, Pass, Replace, Rgb, Rgb565, Size};
/// # use microraster::{Stencil, Stenciled};
/// # let (mut pixels, mut depth) = ([0; 64 * 32], [0; 64 * 32]);
/// let mut frame = Frame::<Rgb565>::new(&mut pixels, Size::new(64, 32))?.with_depth(&mut depth)?;
/// # let camera = Camera::perspective(45.0.degrees(), 0.5);
/// # let mark = Stencil::new(Always, 1).on_pass(Replace);
/// Pass::new(&camera).depth(Stenciled::new(Less, mark)).draw(
///     &mut frame,
///     &Mat4::identity(),
///     &TEAPOT,
///     &Flat::solid(Rgb::RED),
/// );
/// # Ok::<(), microraster::FrameError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stenciled<D, S> {
    depth: D,
    stencil: S,
}

impl<D, S> Stenciled<D, S> {
    /// The depth test, for what passes the stencil test.
    pub const fn new(depth: D, stencil: S) -> Self {
        Self { depth, stencil }
    }
}

/// Leaves what an operation makes of a value.
#[inline(always)]
fn apply(operation: &impl StencilOperation, reference: u8, write_mask: u8, value: &mut u8) {
    if !operation.keeps() {
        // With one mask, not two: registers are short in the pixel loop.
        *value ^= (operation.apply(reference, *value) ^ *value) & write_mask;
    }
}

impl<D, C, F, Z, P> DepthTest for Stenciled<D, Stencil<C, F, Z, P>>
where
    D: DepthTest,
    C: StencilCompare,
    F: StencilOperation,
    Z: StencilOperation,
    P: StencilOperation,
{
    type Access = WithStencil<D::Access>;
    const OFFSETS: bool = D::OFFSETS;

    #[inline(always)]
    fn passes(&self, new: u16, stored: u16) -> bool {
        self.depth.passes(new, stored)
    }

    #[inline(always)]
    fn writes(&self) -> bool {
        self.depth.writes()
    }

    #[inline(always)]
    fn verdict(&self, new: u16, (depth, value): &TestCell<'_, Self>) -> Verdict {
        let Stencil { compare, reference, read_mask, on_fail, on_depth_fail, .. } = &self.stencil;
        let failed = |verdict, keeps: bool| if keeps { Verdict::Fails } else { verdict };
        if !compare.compares(reference & read_mask, **value & read_mask) {
            failed(Verdict::FailsStencil, on_fail.keeps())
        } else if !self.depth.passes(new, D::Access::read(depth)) {
            failed(Verdict::FailsDepth, on_depth_fail.keeps())
        } else {
            Verdict::Passes
        }
    }

    #[inline(always)]
    fn leave(&self, verdict: Verdict, new: u16, (depth, value): TestCell<'_, Self>) {
        let Stencil { reference, write_mask, on_fail, on_depth_fail, on_pass, .. } = &self.stencil;
        match verdict {
            Verdict::Fails => {}
            Verdict::FailsStencil => apply(on_fail, *reference, *write_mask, value),
            Verdict::FailsDepth => apply(on_depth_fail, *reference, *write_mask, value),
            Verdict::Passes => {
                apply(on_pass, *reference, *write_mask, value);
                self.depth.leave(verdict, new, depth);
            }
        }
    }

    #[inline(always)]
    fn is_constant(&self) -> bool {
        self.depth.is_constant()
    }

    #[inline(always)]
    fn maps(&self) -> bool {
        self.depth.maps()
    }

    #[inline(always)]
    fn map(&self, code: u16) -> u16 {
        self.depth.map(code)
    }

    #[inline(always)]
    fn offset(&self, dx: i32, dy: i32) -> i64 {
        self.depth.offset(dx, dy)
    }
}
