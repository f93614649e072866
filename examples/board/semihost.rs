//! Talks to the debugger or emulator that runs the firmware: prints, files, arguments, exit.

use core::ffi::CStr;
use core::fmt;

/// One semihosting call: operation number and address of its argument block.
#[inline(never)]
#[allow(unsafe_code, reason = "the trap is an instruction that no safe function offers")]
fn call(operation: usize, argument: usize) -> isize {
    let result: isize;
    #[cfg(target_arch = "arm")]
    // SAFETY: the trap only touches r0, r1 and the memory that the argument block names.
    unsafe {
        core::arch::asm!("bkpt #0xAB", inout("r0") operation => result, in("r1") argument);
    }
    #[cfg(target_arch = "riscv32")]
    // SAFETY: as above; the three words must be uncompressed and in one page.
    unsafe {
        core::arch::asm!(
            ".balign 16", ".option push", ".option norvc",
            "slli x0, x0, 0x1f", "ebreak", "srai x0, x0, 7",
            ".option pop",
            inout("a0") operation => result, in("a1") argument,
        );
    }
    #[cfg(target_arch = "wasm32")]
    // SAFETY: as above; the embedder's function keeps to the argument block.
    unsafe {
        result = embedder::semihost(operation, argument);
    }
    result
}

/// What runs WebAssembly has no trap to serve, but a function to call.
#[cfg(target_arch = "wasm32")]
mod embedder {
    #[allow(unsafe_code, reason = "a function of who runs this")]
    #[link(wasm_import_module = "host")]
    extern "C" {
        pub(super) fn semihost(operation: usize, argument: usize) -> isize;
    }
}

/// A call whose argument block is `block`.
fn call_block(operation: usize, block: &mut [usize]) -> isize {
    call(operation, block.as_mut_ptr() as usize)
}

// Operation numbers of Arm's semihosting specification.
const OPEN: usize = 0x01;
const CLOSE: usize = 0x02;
const WRITE: usize = 0x05;
const READ: usize = 0x06;
const COMMAND_LINE: usize = 0x15;
const EXIT_EXTENDED: usize = 0x20;

/// How `open` treats the file.
#[derive(Clone, Copy)]
pub(crate) enum Mode {
    /// Binary, from the start.
    Read = 1,
    /// Binary, emptied first.
    Write = 5,
}

/// A file on the host, closed on drop.
pub(crate) struct File(usize);

impl File {
    /// `None` where the host has no such file.
    pub(crate) fn open(name: &CStr, mode: Mode) -> Option<Self> {
        let length = name.to_bytes().len();
        let handle = call_block(OPEN, &mut [name.as_ptr() as usize, mode as usize, length]);
        usize::try_from(handle).ok().map(Self)
    }

    /// The console: the special name `:tt`.
    pub(crate) fn console() -> Option<Self> {
        Self::open(c":tt", Mode::Write)
    }

    /// Writes all of `bytes`; false when the host took less.
    fn write_all(&mut self, bytes: &[u8]) -> bool {
        bytes.is_empty()
            || call_block(WRITE, &mut [self.0, bytes.as_ptr() as usize, bytes.len()]) == 0
    }

    /// Fills `bytes` as far as the file goes and returns what was read.
    pub(crate) fn read<'a>(&mut self, bytes: &'a mut [u8]) -> Option<&'a [u8]> {
        let block = &mut [self.0, bytes.as_mut_ptr() as usize, bytes.len()];
        let missing = usize::try_from(call_block(READ, block)).ok()?;
        bytes.get(..bytes.len().checked_sub(missing)?)
    }
}

impl Drop for File {
    fn drop(&mut self) {
        call_block(CLOSE, &mut [self.0]);
    }
}

impl fmt::Write for File {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        if self.write_all(text.as_bytes()) {
            Ok(())
        } else {
            Err(fmt::Error)
        }
    }
}

/// The command line that the emulator was given, without the trailing zero; `None` when `buffer`
/// is too small for it.
pub(crate) fn command_line(buffer: &mut [u8]) -> Option<&str> {
    let mut block = [buffer.as_mut_ptr() as usize, buffer.len()];
    if call_block(COMMAND_LINE, &mut block) != 0 {
        return None;
    }
    core::str::from_utf8(buffer.get(..block[1])?).ok()
}

/// Ends the emulator with this exit status.
pub(crate) fn exit(status: u32) -> ! {
    const APPLICATION_EXIT: usize = 0x20026;
    call_block(EXIT_EXTENDED, &mut [APPLICATION_EXIT, status as usize]);
    loop {
        core::hint::spin_loop();
    }
}
