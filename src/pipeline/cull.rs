/// Which triangles are left out by the side that they show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Cull {
    /// None: both sides are drawn.
    #[default]
    None,
    /// Those that show their back.
    Back,
    /// Those that show their front.
    Front,
}

/// Which way the corners of a front face run, as seen in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Winding {
    /// Counter-clockwise, as in OBJ, glTF and OpenGL.
    #[default]
    CounterClockwise,
    /// Clockwise.
    Clockwise,
}

/// Which triangles are left out by the way that their corners run on the screen: [`Cull`] and
/// [`Winding`] together, asked once a draw.
#[derive(Clone, Copy, Debug)]
pub(super) struct CulledWindings {
    /// Has the sign of the areas that are left out, if any are.
    sign: i32,
    any: bool,
}

impl CulledWindings {
    /// What a pass leaves out.
    pub(super) fn new(cull: Cull, front: Winding) -> Self {
        let drops_clockwise = (cull == Cull::Back) == (front == Winding::CounterClockwise);
        Self { sign: if drops_clockwise { 0 } else { -1 }, any: cull != Cull::None }
    }

    /// Whether a triangle with an area of this sign is left out; positive areas run clockwise on
    /// the screen.
    #[inline(always)]
    pub(super) const fn contain(self, area: i32) -> bool {
        area ^ self.sign >= 0 && self.any
    }
}
