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

impl Cull {
    /// Whether a triangle with this sign of its area is left out; positive areas run clockwise on
    /// the screen.
    #[inline(always)]
    pub(crate) fn drops(self, area: i64, front: Winding) -> bool {
        let shows_front = (area < 0) == (front == Winding::CounterClockwise);
        match self {
            Self::None => false,
            Self::Back => !shows_front,
            Self::Front => shows_front,
        }
    }
}
