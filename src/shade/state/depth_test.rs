use crate::frame::{DepthAccess, ReadWrite, Untouched};

/// A pixel's cells under a depth test.
pub type TestCell<'a, D> = <<D as DepthTest>::Access as DepthAccess>::Cell<'a>;

/// What tests make of a fragment.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It fails, and nothing comes of it.
    Fails,
    /// It fails the stencil test, which leaves something.
    FailsStencil,
    /// It fails the depth test, which leaves something.
    FailsDepth,
    /// It is drawn.
    Passes,
}

/// Which fragments are near enough to be drawn.
///
/// Names compare **distance**: [`Less`] passes what is nearer than what is stored. Codes run the
/// other way (larger is nearer), which no user needs to know.
pub trait DepthTest {
    /// Whether depth is touched at all.
    type Access: DepthAccess;
    /// Whether triangles may be [moved](Self::offset).
    const OFFSETS: bool = false;

    /// Whether a fragment with code `new` is drawn over one with code `stored`.
    fn passes(&self, new: u16, stored: u16) -> bool;

    /// Whether a fragment that is drawn leaves its depth.
    fn writes(&self) -> bool;

    /// What becomes of a fragment with code `new`, unless the shader discards it.
    #[doc(hidden)]
    #[inline(always)]
    fn verdict(&self, new: u16, cell: &TestCell<'_, Self>) -> Verdict {
        if self.passes(new, Self::Access::read(cell)) {
            Verdict::Passes
        } else {
            Verdict::Fails
        }
    }

    /// Leaves in the pixel's cell what comes of a verdict that is not [`Verdict::Fails`].
    #[doc(hidden)]
    #[inline(always)]
    fn leave(&self, _verdict: Verdict, new: u16, cell: TestCell<'_, Self>) {
        if self.writes() {
            Self::Access::write(cell, new);
        }
    }

    /// Whether a triangle or line has one code for all of its pixels: the mean of its corners'.
    #[inline(always)]
    fn is_constant(&self) -> bool {
        false
    }

    /// Whether corners' codes are [mapped](Self::map).
    #[inline(always)]
    fn maps(&self) -> bool {
        false
    }

    /// The code that takes the place of a corner's.
    #[inline(always)]
    fn map(&self, code: u16) -> u16 {
        code
    }

    /// The depth that a corner has, 16.16, raised by a half so that cutting off rounds.
    #[doc(hidden)]
    #[inline(always)]
    fn corner(&self, code: u16) -> u32 {
        u32::from(if self.maps() { self.map(code) } else { code }) << 16 | 0x8000
    }

    /// By how much a triangle is farther than it says, as 16.16 codes, where its depth changes by
    /// so much from one pixel to the next, across and down.
    #[inline(always)]
    fn offset(&self, _dx: i32, _dy: i32) -> i64 {
        0
    }
}

/// No depth test and no depth written: the frame needs no depth buffer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Off;

impl DepthTest for Off {
    type Access = Untouched;

    #[inline(always)]
    fn passes(&self, _new: u16, _stored: u16) -> bool {
        true
    }

    #[inline(always)]
    fn writes(&self) -> bool {
        false
    }
}

macro_rules! depth_tests {
    ($($(#[$doc:meta])* $name:ident: $new:ident, $stored:ident => $passes:expr;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct $name;

            impl DepthTest for $name {
                type Access = ReadWrite;

                #[inline(always)]
                fn passes(&self, $new: u16, $stored: u16) -> bool {
                    $passes
                }

                #[inline(always)]
                fn writes(&self) -> bool {
                    true
                }
            }
        )*

        /// Any depth test, chosen when the program runs: for host tools, which would otherwise
        /// instantiate every combination. Needs a frame with depth even when it is off.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum AnyDepth {
            /// As [`Off`](struct@Off).
            Off,
            $(
                $(#[$doc])*
                $name,
            )*
        }

        impl DepthTest for AnyDepth {
            type Access = ReadWrite;

            #[inline(always)]
            fn passes(&self, new: u16, stored: u16) -> bool {
                match self {
                    Self::Off => true,
                    $(Self::$name => $name.passes(new, stored),)*
                }
            }

            #[inline(always)]
            fn writes(&self) -> bool {
                !matches!(self, Self::Off)
            }
        }
    };
}

depth_tests! {
    /// Draws what is nearer than what is stored.
    Less: new, stored => new > stored;
    /// Draws what is nearer, and what is as near.
    LessEqual: new, stored => new >= stored;
    /// Draws what is as near as what is stored.
    Equal: new, stored => new == stored;
    /// Draws what is farther.
    Greater: new, stored => new < stored;
    /// Draws what is farther, and what is as near.
    GreaterEqual: new, stored => new <= stored;
    /// Draws what is nearer or farther.
    NotEqual: new, stored => new != stored;
    /// Draws all, and writes depth.
    Always: _new, _stored => true;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_compare_distance_and_larger_codes_are_nearer() {
        assert!(Less.passes(2, 1) && !Less.passes(1, 1) && !Less.passes(1, 2), "less");
        assert!(LessEqual.passes(1, 1) && !LessEqual.passes(1, 2), "less or equal");
        assert!(Greater.passes(1, 2) && !Greater.passes(2, 2), "greater");
        assert!(GreaterEqual.passes(2, 2) && !GreaterEqual.passes(3, 2), "greater or equal");
        assert!(Equal.passes(5, 5) && !Equal.passes(5, 4), "equal");
        assert!(NotEqual.passes(5, 4) && !NotEqual.passes(5, 5), "not equal");
        assert!(Always.passes(0, 65535) && Always.writes(), "always");
    }

    #[test]
    fn the_runtime_test_agrees_with_the_types() {
        for (new, stored) in [(0, 0), (0, 1), (1, 0), (65535, 65534), (65534, 65535), (7, 7)] {
            let pairs = [
                (AnyDepth::Off, Off.passes(new, stored)),
                (AnyDepth::Less, Less.passes(new, stored)),
                (AnyDepth::LessEqual, LessEqual.passes(new, stored)),
                (AnyDepth::Equal, Equal.passes(new, stored)),
                (AnyDepth::Greater, Greater.passes(new, stored)),
                (AnyDepth::GreaterEqual, GreaterEqual.passes(new, stored)),
                (AnyDepth::NotEqual, NotEqual.passes(new, stored)),
                (AnyDepth::Always, Always.passes(new, stored)),
            ];
            for (any, typed) in pairs {
                assert_eq!(any.passes(new, stored), typed, "{any:?} of {new}, {stored}");
            }
        }
    }
}
