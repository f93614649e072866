use core::ops::Deref;

use super::PerspectiveCorner;
use crate::shade::{Interpolated, Stepped, Varying};

/// How often perspective is corrected: [`Affine`](super::Affine) (never),
/// [`Every`](super::Every) `N` pixels, [`Adaptive`](super::Adaptive), or
/// [`Exact`](super::Exact) (at each pixel).
pub trait PerspectiveMode: Copy {
    /// A varying in this mode.
    type Of<V: Interpolated>: PerspectiveVarying<Inner = V>;
}

/// A varying in a [`PerspectiveMode`], which leads to the value at a pixel by `*`.
pub trait PerspectiveVarying:
    Varying<Corner = PerspectiveCorner<<Self::Inner as Varying>::Corner>> + Deref<Target = Self::Inner>
{
    /// What is interpolated.
    type Inner: Interpolated;

    /// Whether what is interpolated goes from pixel to pixel of a run in equal steps.
    const LINEAR: bool;

    /// The step of what is interpolated, at the first pixel of a run.
    fn inner_step(step: &<Self as Stepped>::Step) -> &<Self::Inner as Stepped>::Step;
}

/// A varying `V` in perspective, corrected as `M` says.
///
/// ```
/// use microraster::{Every, Exact, Perspective, Scalars, SmoothColor, Uv};
///
/// type Textured = Perspective<Uv>;
/// type Lit = Perspective<(Uv, SmoothColor), Every<8>>;
/// type Precise = Perspective<Scalars<4>, Exact>;
/// # let _ = (core::any::type_name::<(Textured, Lit, Precise)>(),);
/// ```
///
/// # Measured
/// <!-- tradeoff: plane-10/colour=adaptive -->
/// `adaptive` in the scene `plane-10`: 47.3 (M4F), 87.8 (M0+), 52.8 (RV32) instructions a pixel; PSNR 41.1 dB.
pub type Perspective<V, M = super::Adaptive> = <M as PerspectiveMode>::Of<V>;
