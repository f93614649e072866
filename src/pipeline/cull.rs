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
    clockwise: bool,
    counter_clockwise: bool,
}

impl CulledWindings {
    /// What a pass leaves out.
    pub(super) fn new(cull: Cull, front: Winding) -> Self {
        let drops = |winding| match cull {
            Cull::None => false,
            Cull::Back => winding != front,
            Cull::Front => winding == front,
        };
        Self {
            clockwise: drops(Winding::Clockwise),
            counter_clockwise: drops(Winding::CounterClockwise),
        }
    }

    /// Whether those are left out whose corners run clockwise, and counter-clockwise.
    pub(super) const fn by_winding(self) -> [bool; 2] {
        [self.clockwise, self.counter_clockwise]
    }

    /// Whether a triangle with an area of this sign is left out; positive areas run clockwise on
    /// the screen.
    #[inline(always)]
    pub(super) const fn contain(self, area: i32) -> bool {
        if area < 0 {
            self.counter_clockwise
        } else {
            self.clockwise
        }
    }
}
