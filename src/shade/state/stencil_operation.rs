use super::Replace;

/// What takes the place of a stored stencil value, as far as the write mask says.
pub trait StencilOperation {
    /// The value that is left where `stored` was.
    fn apply(&self, reference: u8, stored: u8) -> u8;

    /// Whether it leaves everything as it is.
    #[inline(always)]
    fn keeps(&self) -> bool {
        false
    }
}

macro_rules! operations {
    ($($(#[$doc:meta])* $name:ident: $reference:ident, $stored:ident => $value:expr;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct $name;

            impl StencilOperation for $name {
                #[inline(always)]
                fn apply(&self, $reference: u8, $stored: u8) -> u8 {
                    $value
                }
            }
        )*

        /// Any operation, chosen when the program runs: for host tools.
        #[non_exhaustive]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum AnyOperation {
            /// As [`Keep`](struct@Keep).
            Keep,
            /// As [`Replace`](struct@Replace).
            Replace,
            $(
                $(#[$doc])*
                $name,
            )*
        }

        impl StencilOperation for AnyOperation {
            fn apply(&self, reference: u8, stored: u8) -> u8 {
                match self {
                    Self::Keep => stored,
                    Self::Replace => reference,
                    $(Self::$name => $name.apply(reference, stored),)*
                }
            }

            fn keeps(&self) -> bool {
                *self == Self::Keep
            }
        }
    };
}

operations! {
    /// Zero.
    Zero: _reference, _stored => 0;
    /// One more, at most 255.
    IncrementClamp: _reference, stored => stored.saturating_add(1);
    /// One more; 0 after 255.
    IncrementWrap: _reference, stored => stored.wrapping_add(1);
    /// One less, at least 0.
    DecrementClamp: _reference, stored => stored.saturating_sub(1);
    /// One less; 255 after 0.
    DecrementWrap: _reference, stored => stored.wrapping_sub(1);
    /// All bits the other way.
    Invert: _reference, stored => !stored;
}

/// What is stored stays: the default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keep;

impl StencilOperation for Keep {
    #[inline(always)]
    fn apply(&self, _reference: u8, stored: u8) -> u8 {
        stored
    }

    #[inline(always)]
    fn keeps(&self) -> bool {
        true
    }
}

/// The reference takes the place of what is stored.
impl StencilOperation for Replace {
    #[inline(always)]
    fn apply(&self, reference: u8, _stored: u8) -> u8 {
        reference
    }
}
