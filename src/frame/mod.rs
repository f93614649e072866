//! The caller's colour, depth and stencil buffers as one checked view.
//!
//! A [`Frame`] borrows its buffers, checks their lengths once and cannot fail from then on. It may
//! show a whole picture, a part of a larger buffer (stride), or a band of rows of a taller picture
//! (`first_row`); coordinates are the picture's in every case, so that bands and scissors change
//! no pixel. [`Bands`] draw a picture through one such band after the other, and [`Damage`] says what of
//! it a display does not show yet.

mod bands;
mod damage;
mod depth;
mod error;
mod rect;
mod size;
mod stencil;
mod view;
mod window;

pub use bands::{Band, Bands};
pub use damage::Damage;
pub use depth::{DepthAccess, DepthBuffer, NoDepth, ReadWrite, Supplies, Untouched};
pub use error::FrameError;
pub use rect::Rect;
pub use size::Size;
pub use stencil::{StencilBuffer, WithStencil};
pub use view::{Frame, MAX_SIDE};
pub(crate) use window::{Target, Window};
