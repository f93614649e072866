use super::{Always, Equal, Greater, GreaterEqual, Less, LessEqual, NotEqual};

/// Which fragments pass the stencil test: the reference is compared with what is stored, as the
/// name says, after both have been masked.
///
/// The types are those of the depth tests, and [`Never`].
pub trait StencilCompare {
    /// Whether a fragment passes.
    fn compares(&self, reference: u8, stored: u8) -> bool;
}

/// Nothing passes: for what a stencil test leaves where it fails.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Never;

macro_rules! compares {
    ($($name:ident: $reference:ident, $stored:ident => $passes:expr;)*) => {
        $(
            impl StencilCompare for $name {
                #[inline(always)]
                fn compares(&self, $reference: u8, $stored: u8) -> bool {
                    $passes
                }
            }
        )*

        /// Any comparison, chosen when the program runs: for host tools.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum AnyCompare {
            $(
                #[doc = concat!("As [`", stringify!($name), "`](struct@", stringify!($name), ").")]
                $name,
            )*
        }

        impl StencilCompare for AnyCompare {
            fn compares(&self, reference: u8, stored: u8) -> bool {
                match self {
                    $(Self::$name => $name.compares(reference, stored),)*
                }
            }
        }
    };
}

compares! {
    Never: _reference, _stored => false;
    Less: reference, stored => reference < stored;
    LessEqual: reference, stored => reference <= stored;
    Equal: reference, stored => reference == stored;
    Greater: reference, stored => reference > stored;
    GreaterEqual: reference, stored => reference >= stored;
    NotEqual: reference, stored => reference != stored;
    Always: _reference, _stored => true;
}
