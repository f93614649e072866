//! What a log may say, in the words of `defmt`. A program that logs brings the logger; without one
//! this links all the same.
#![cfg(feature = "defmt")]

use microraster::texture::TextureError;
use microraster::{Damage, FrameError, ListError, Rect, Size, Stats};

/// How many bytes a value takes that may be logged.
fn logged<T: defmt::Format>() -> usize {
    size_of::<T>()
}

#[test]
fn errors_sizes_and_statistics_may_be_logged() {
    let sizes = [
        logged::<FrameError>(),
        logged::<ListError>(),
        logged::<TextureError>(),
        logged::<Size>(),
        logged::<Rect>(),
        logged::<Stats>(),
        logged::<Damage>(),
    ];
    // Errors are small: they are returned from constructors.
    assert!(sizes.iter().all(|bytes| *bytes <= 40), "{sizes:?}");
}
