//! Counts instructions. Under `qemu -icount shift=7` every instruction takes 128 ns of virtual
//! time; a 25 MHz counter then moves 3.2 ticks an instruction, so that each one is seen.

/// Picoseconds of virtual time for one instruction: 1000 shifted left as `-icount` says.
const INSTRUCTION_PS: u64 = 1000 << 7;

#[cfg(target_arch = "arm")]
mod clock {
    use core::ptr::addr_of;

    #[allow(unsafe_code, reason = "addresses that memory.x gives, not data")]
    extern "C" {
        static __counter: u32;
        static __counter_ps: u32;
    }

    /// Picoseconds a tick.
    #[allow(unsafe_code, reason = "only the address is taken, nothing is read")]
    pub(super) fn period_ps() -> u64 {
        addr_of!(__counter_ps) as usize as u64
    }

    /// Ticks so far; wraps. The profiler recognises the measured part by this function's name.
    #[inline(never)]
    #[allow(unsafe_code, reason = "a device register is read")]
    pub(super) fn now() -> u32 {
        // SAFETY: memory.x names a readable 32-bit register.
        unsafe { addr_of!(__counter).read_volatile() }
    }
}

#[cfg(target_arch = "riscv32")]
mod clock {
    /// QEMU gives virtual nanoseconds as cycles when it counts instructions.
    pub(super) fn period_ps() -> u64 {
        1000
    }

    /// Ticks so far; wraps. The profiler recognises the measured part by this function's name.
    #[inline(never)]
    #[allow(unsafe_code, reason = "a counter register has no other access")]
    pub(super) fn now() -> u32 {
        let low: u32;
        // SAFETY: reads a counter register; no memory is touched.
        unsafe { core::arch::asm!("rdcycle {}", out(reg) low, options(nostack)) };
        low
    }
}

#[cfg(target_arch = "wasm32")]
mod clock {
    /// Nothing counts instructions here.
    pub(super) fn period_ps() -> u64 {
        0
    }

    /// Always the same.
    pub(super) fn now() -> u32 {
        0
    }
}

/// Instructions of so many ticks.
fn of_ticks(ticks: u32) -> u64 {
    (u64::from(ticks) * clock::period_ps() + INSTRUCTION_PS / 2) / INSTRUCTION_PS
}

/// A point in time.
#[derive(Clone, Copy)]
pub(crate) struct Instant(u32);

#[allow(dead_code, reason = "for who looks at the time more than twice")]
impl Instant {
    /// Now.
    pub(crate) fn now() -> Self {
        Self(clock::now())
    }

    /// Instructions since then, of up to 1.34e9.
    pub(crate) fn elapsed(self) -> u64 {
        of_ticks(clock::now().wrapping_sub(self.0))
    }
}

/// Instructions that `work` took, with the few that reading the counter costs: measure `|| ()`
/// once and subtract it.
#[inline(never)]
pub(crate) fn instructions<T>(work: impl FnOnce() -> T) -> (u64, T) {
    let before = clock::now();
    let value = work();
    let after = clock::now();
    (of_ticks(after.wrapping_sub(before)), value)
}
