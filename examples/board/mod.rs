//! What the firmware examples need of a board: console, counter, stack meter, buffers, panic.

pub(crate) mod buffer;
pub(crate) mod meter;
pub(crate) mod run;
pub(crate) mod semihost;
pub(crate) mod stack;

use core::fmt::Write;

/// Prints one line on the host's console.
macro_rules! say {
    ($($argument:tt)*) => {
        if let Some(mut console) = $crate::board::semihost::File::console() {
            // A console that is gone cannot be told about.
            let _ = core::fmt::Write::write_fmt(
                &mut console,
                format_args!("{}\n", format_args!($($argument)*)),
            );
        }
    };
}
pub(crate) use say;

/// The exit status of firmware that panicked, as of a host program.
const PANICKED: u32 = 101;

#[panic_handler]
fn panic(info: &core::panic::PanicInfo<'_>) -> ! {
    if let Some(mut console) = semihost::File::console() {
        let _ = writeln!(console, "{info}");
    }
    semihost::exit(PANICKED)
}
