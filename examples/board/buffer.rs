//! Memory that is there from the start and is handed out once.

use core::cell::UnsafeCell;
use core::sync::atomic::{AtomicBool, Ordering};

/// A static whose content is lent to the first who asks, mutably and for good.
pub(crate) struct Buffer<T> {
    /// The content.
    content: UnsafeCell<T>,
    /// Whether somebody has it.
    taken: AtomicBool,
}

// SAFETY: `take` lends the content once. The firmware has one thread and no interrupt handler,
// so that a load and a store are as good as a swap, which Armv6-M lacks.
#[allow(unsafe_code, reason = "a static must be Sync; the flag keeps the loan unique")]
unsafe impl<T: Send> Sync for Buffer<T> {}

impl<T> Buffer<T> {
    /// Nobody has it yet.
    pub(crate) const fn new(content: T) -> Self {
        Self { content: UnsafeCell::new(content), taken: AtomicBool::new(false) }
    }

    /// The content, for the first who asks.
    #[allow(clippy::mut_from_ref, reason = "the flag sees to it that there is one loan only")]
    pub(crate) fn take(&'static self) -> Option<&'static mut T> {
        if self.taken.load(Ordering::Relaxed) {
            return None;
        }
        self.taken.store(true, Ordering::Relaxed);
        // SAFETY: the flag was raised just now and is never lowered: no other reference exists.
        #[allow(unsafe_code, reason = "the one loan of a static buffer")]
        Some(unsafe { &mut *self.content.get() })
    }
}
