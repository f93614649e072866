use crate::frame::Rect;
use crate::pipeline::{Cull, Winding};
use crate::shade::{AnyBlend, AnyDepth, AnyDepthState, AnyMask, AnyStencil};

/// Which fragments are drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct State {
    /// Which triangles are left out.
    pub cull: Cull,
    /// Which way the corners of a front face run.
    pub front: Winding,
    /// The depth test, whether it writes, the offset of triangles and the range of codes.
    pub depth: AnyDepthState,
    /// The stencil test, if there is one.
    pub stencil: Option<AnyStencil>,
    /// How colours meet the stored ones.
    pub blend: AnyBlend,
    /// The channels that are stored.
    pub mask: AnyMask,
    /// The pixels that may be drawn, if not all.
    pub scissor: Option<Rect>,
}

impl State {
    /// Both sides of everything, without any test, as it is.
    pub const PLAIN: Self = Self {
        cull: Cull::None,
        front: Winding::CounterClockwise,
        depth: AnyDepthState::new(AnyDepth::Off),
        stencil: None,
        blend: AnyBlend::Replace,
        mask: AnyMask { red: true, green: true, blue: true },
        scissor: None,
    };
}

impl Default for State {
    fn default() -> Self {
        Self::PLAIN
    }
}

/// How finely depths are told apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DepthPrecision {
    /// As `f64` has it.
    #[default]
    Exact,
    /// A pixel's depth is rounded to a whole code before it is compared and stored; where depth is
    /// constant, so are the corners', and their mean is cut off to one.
    Codes,
}
